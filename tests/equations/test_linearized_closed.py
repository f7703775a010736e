"""Linear models of loops and rolling bodies against finite differences of reduced equations.

The equations are reduced here in numbers: positions by Newton's method, speeds and accelerations
from linear systems in maximal form, M udot + h = f + Gᵀ lam, G udot = gamma with gamma from
differences of G u along the motion. Nothing of it knows a linear model.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.ir.interpreter import evaluate
from cardan.ir.matrix import Matrix
from laws.cases import slots, values
from mechanisms.closed import CLOSED
from mechanisms.rolling import ROLLING
from spread import some

STEP = 1e-3
# of the central difference of fourth order
WEIGHTS = {-2: 1 / 12, -1: -2 / 3, 1: 2 / 3, 2: -1 / 12}
Array = np.ndarray
# independent coordinates, whose rates are the independent speeds
CHOSEN = {
    "four_bar": 1, "slider_crank": 1, "andrews": 1, "bricard": 1, "delta": 3,
    "stewart": tuple(f"slide{k}" for k in range(6)),
}  # fmt: skip


class Reduced:
    """Independent coordinates and speeds y, and their rates.

    Args:
        equations: Of the system.
        y, w: Names of independent coordinates and speeds.
        q: A closed position.
    """

    def __init__(self, equations: Any, y: Any, w: Any, q: Array) -> None:
        self.equations, self.last = equations, q
        self.y = [equations.coordinates.index(name) for name in y]
        self.w = [equations.speeds.index(name) for name in w]
        self.count = sum(row.level == "position" for row in equations.constraint_rows)

    def call(self, name: str, **given: Any) -> Array:
        function = self.equations.function(name)
        blocks = values(self.equations, t=[0.0], z=[], s=[], **given)
        (found,) = evaluate(function, blocks, "numpy").values()
        return np.asarray(found, dtype=float)

    @cached_property
    def _nothing(self) -> Array:
        return np.zeros(len(self.equations.speeds))

    def moves(self, q: Array) -> Array:
        """N (nq, nu)."""
        unit = np.eye(len(self._nothing))
        return np.stack([np.broadcast_to(self.call("qdot", q=q, u=u), q.shape) for u in unit], 1)

    def jacobian(self, q: Array) -> Array:
        return self.call("constraint_jacobian", q=q)

    def position(self, goal: Array) -> Array:
        q = self.last.copy()
        for _ in range(8):
            off = q[self.y] - goal
            kept = self.moves(q)[self.y]
            if self.count:
                off = np.concatenate([self.call("constraints", q=q), off])
                kept = np.concatenate([self.jacobian(q)[: self.count], kept])
            q = self.call("integrate", q=q, du=-np.linalg.lstsq(kept, off, rcond=1e-10)[0])
        return q

    def speeds(self, q: Array, w: Array) -> Array:
        G = self.jacobian(q)
        kept = np.concatenate([G, np.eye(G.shape[1])[self.w]])
        right = np.concatenate([np.zeros(len(G)), w])
        return np.linalg.lstsq(kept, right, rcond=1e-10)[0]

    def accelerations(self, q: Array, u: Array) -> Array:
        shapes = {"mass_matrix": (len(u),) * 2, "bias": u.shape, "applied_forces": u.shape}
        M, h, f = (np.broadcast_to(self.call(n, q=q, u=u), s) for n, s in shapes.items())
        G = self.jacobian(q)
        sides = {
            k: self.jacobian(self.call("integrate", q=q, du=k * STEP * u)) @ u for k in WEIGHTS
        }
        gamma = -sum(weight * sides[k] for k, weight in WEIGHTS.items()) / STEP
        system = np.block([[M, G.T], [G, np.zeros((len(G),) * 2)]])
        right = np.concatenate([f - h, gamma])
        return np.linalg.lstsq(system, right, rcond=1e-10)[0][: len(u)]

    def rates(self, x: Array) -> Array:
        n = len(self.y)
        q = self.position(x[:n])
        u = self.speeds(q, x[n:])
        return np.concatenate([(self.moves(q) @ u)[self.y], self.accelerations(q, u)[self.w]])

    def slope(self, x: Array) -> Array:
        """Central differences of fourth order."""
        columns = []
        for unit in np.eye(len(x)):
            sides = (w * self.rates(x + k * STEP * unit) for k, w in WEIGHTS.items())
            columns.append(sum(sides) / STEP)
        return np.stack(columns, axis=1)


def judge(equations: Any, found: Any, q: Array, u: Array) -> None:
    n = len(found.coordinates)
    own = Reduced(equations, found.states[:n], found.states[n:], q)
    expected = own.slope(np.concatenate([q[own.y], u[own.w]]))
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
