"""Linear models of loops and rolling bodies against finite differences of reduced equations.

Nothing of the reduction (:mod:`laws.reduced`) knows a linear model.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.ir.matrix import Matrix
from laws.cases import slots
from laws.reduced import Reduced, slope
from mechanisms.closed import CLOSED
from mechanisms.rolling import ROLLING
from spread import some

Array = np.ndarray
# independent coordinates, whose rates are the independent speeds
CHOSEN = {
    "four_bar": 1, "slider_crank": 1, "andrews": 1, "bricard": 1, "delta": 3,
    "stewart": tuple(f"slide{k}" for k in range(6)),
}  # fmt: skip


def judge(equations: Any, found: Any, q: Array, u: Array) -> None:
    n = len(found.coordinates)
    own = Reduced(equations, found.states[:n], found.states[n:], q)
    expected = slope(own.rates, np.concatenate([q[own.y], u[own.w]]))
    size = np.abs(expected).max()
    np.testing.assert_allclose(found.at()["A"], expected, rtol=0, atol=1e-7 * size)


@pytest.mark.parametrize("name", some(CHOSEN, 3))
def test_six_mechanisms_in_motion(name: str) -> None:
    equations = cd.derive(CLOSED[name].build())
    joints = {joint.name for joint in equations.system.joints if joint.q >= 0}
    q, _ = slots(equations.system, CLOSED[name].state(0.1, 1.0, joints))
    place = dict(zip(equations.coordinates, q.tolist(), strict=True))
    chosen = CHOSEN[name]
    if isinstance(chosen, int):
        chosen = equations.linearize(q=place).coordinates
    speeds = {name: 0.4 + 0.3 * k for k, name in enumerate(chosen)}
    found = equations.linearize(q=place, u=speeds, udot="free", independent=chosen)
    assert found.needed == {}
    assert set(found.coordinates) == set(chosen)
    judge(equations, found, q, values_of(found, "u"))


def values_of(found: Any, letter: str) -> Array:
    """Numbers of a block of the reference motion."""
    at = found._reference
    nodes = [at.values[leaf] for leaf in at.block(letter)]
    return at.number(Matrix(at.graph, len(nodes), 1, nodes))[:, 0]


@pytest.mark.parametrize("name", some(ROLLING, 2))
def test_rolling_bodies_in_motion(name: str) -> None:
    equations = cd.derive(ROLLING[name]())
    place = {"rolls.lean": 0.2, "rolls.yaw": 0.4, "rolls.spin": 0.7}
    speeds = {"rolls.yaw": 0.3, "rolls.lean": -0.2, "rolls.spin": 1.1}
    found = equations.linearize(q=place, u=speeds, udot="free")
    assert len(found.coordinates) > len(found.speeds)
    judge(equations, found, values_of(found, "q"), values_of(found, "u"))


def test_lengths_at_which_a_reference_of_numbers_stays_open_are_refused() -> None:
    scene = cd.Scene("rectangle", gravity=(0, 0, -9.81))
    length = scene.parameter("l", 1.0)
    left = scene.body("left", mass=1, com=(0, 0, -length / 2))
    beam = scene.body("beam", mass=1, com=(0.5, 0, 0))
    right = scene.body("right", mass=1, com=(0, 0, -0.5))
    scene.joint("A", cd.Revolute("y"), scene.ground, left)
    scene.joint("B", cd.Revolute("y"), left.at(0, 0, -length), beam)
    scene.joint("D", cd.Revolute("y"), scene.ground.at(1, 0, 0), right)
    scene.joint("C", cd.Revolute("y"), beam.at(1, 0, 0), right.at(0, 0, -1), cut=True)
    found = cd.derive(scene).linearize()
    # masses leave it closed
    assert found.at({"left.mass": 2.0})["A"].shape == (2, 2)
    with pytest.raises(cd.DerivationError, match="loops do not close"):
        found.at(l=1.1)
