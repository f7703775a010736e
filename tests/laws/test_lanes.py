"""States side by side have the bits of single states: every mechanism, every width."""

from __future__ import annotations

import warnings
from itertools import cycle

import numpy as np
import pytest

import cardan as cd
from cardan.errors import SolveWarning
from laws.cases import derived, states
from mechanisms import ZOO
from spread import some

pytestmark = pytest.mark.optimized

# where compilers make branches of the selects of rotation vectors in single states, and fuse other
# sums of products there: one rounding may differ
FUSED = {"mounts"}
# blocks of all widths and a rest
COUNT = 45


# one width for one mechanism, the other for the next
PAIRS = [(name, lanes) for name, first in zip(ZOO, cycle((4, 4, 8, 8)), strict=False)
         for lanes in (first, 12 - first)]  # fmt: skip


@pytest.mark.parametrize(("name", "lanes"), some(PAIRS, 9))
def test_lanes_have_the_bits_of_single_states(
    name: str, lanes: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CARDAN_LANES", str(lanes))
    model = cd.compile(derived(name))
    q, u = (np.resize(x, (COUNT, x.shape[1])) for x in states(name))
    rng = np.random.default_rng(3)
    tau, udot = rng.uniform(-1, 1, (2, *u.shape))
    t = rng.uniform(0, 1, COUNT)
    model.prepare("forward_dynamics", "inverse_dynamics", batch=True)
    assert model.lanes("forward_dynamics") == model.lanes("inverse_dynamics") == lanes
    with warnings.catch_warnings():
        # a listed state may be singular
        warnings.simplefilter("ignore", SolveWarning)
        forward = model.forward_dynamics(q, u, tau=tau, t=t)
        inverse = model.inverse_dynamics(q, u, udot, t=t)
    for k in range(COUNT):
        if np.isfinite(forward[k]).all():
            one = model.forward_dynamics(q[k], u[k], tau=tau[k], t=t[k])
            assert alike(one, forward[k], name)
        one = model.inverse_dynamics(q[k], u[k], udot[k], t=t[k])
        assert alike(one, inverse[k], name)


def alike(one: np.ndarray, other: np.ndarray, name: str) -> bool:
    """Equal bits, or but for a rounding where that is known."""
    if name in FUSED:
        return np.allclose(one, other, rtol=1e-13, atol=1e-13 * np.abs(other).max())
    return one.tobytes() == other.tobytes()
