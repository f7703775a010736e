"""Sums over trees by doubling distances against sums body by body."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.arrays import Array
from cardan.runtime.verification.joint_motion import cross
from cardan.runtime.verification.tree_sums import BodyTree, Indices

STATES = 2
SHAPES = {
    "chain": tuple(range(-1, 36)),
    "star": (-1, *[0] * 20),
    "forest": (-1, 0, -1, 2, 2, 1, -1),
    "random": tuple(int(k) for k in np.random.default_rng(3).integers(-1, range(60))),
    "one": (-1,),
    "none": (),
}
# sums of a few dozen numbers of size 1 in another order
CLOSE = 1e-13


@pytest.fixture(params=SHAPES)
def parents(request: pytest.FixtureRequest) -> tuple[int, ...]:
    return SHAPES[request.param]


def drawn(*shape: int) -> Array:
    return np.random.default_rng(1).uniform(-1, 1, (STATES, *shape))


def test_sums_over_ancestors(parents: tuple[int, ...]) -> None:
    parts = drawn(len(parents) + 1, 3)
    parts[:, 0] = 0.0
    sums = parts.copy()
    for i, parent in enumerate(parents):
        sums[:, i + 1] += sums[:, parent + 1]
    assert BodyTree(parents).sums(parts) == pytest.approx(sums, abs=CLOSE)


def test_products_of_rotations(parents: tuple[int, ...]) -> None:
    parts, _ = np.linalg.qr(drawn(len(parents) + 1, 3, 3))
    parts[:, 0] = np.eye(3)
    products = parts.copy()
    for i, parent in enumerate(parents):
        products[:, i + 1] = products[:, parent + 1] @ products[:, i + 1]
    assert BodyTree(parents).rotations(parts) == pytest.approx(products, abs=CLOSE)


def test_wrenches_of_what_hangs_on_a_body(parents: tuple[int, ...]) -> None:
    places, wrenches = drawn(len(parents) + 1, 3), drawn(len(parents) + 1, 6)

    def shift(wrench: Array, bodies: Indices, above: Indices) -> Array:
        arms = places[:, bodies] - places[:, above]
        moment = wrench[..., :3] + cross(arms, wrench[..., 3:])
        return np.concatenate([moment, wrench[..., 3:]], axis=-1)

    sums = wrenches.copy()
    for i in range(len(parents) - 1, -1, -1):
        if parents[i] >= 0:
            here, above = np.array([i + 1]), np.array([parents[i] + 1])
            sums[:, above] += shift(sums[:, here], here, above)
    result = BodyTree(parents).subtree_sums(wrenches, shift)
    assert result[:, 1:] == pytest.approx(sums[:, 1:], abs=CLOSE)
    # of the ground nothing is said: it has what it had
    assert (result[:, 0] == wrenches[:, 0]).all()
