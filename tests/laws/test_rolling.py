"""Wheels and disks: the point of contact does not slip, and the plane acts on nothing else."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.verification.flat_scene import scene_of
from cardan.runtime.verification.newton_euler import inverse_dynamics
from laws.cases import EPS
from mechanisms.rolling import ROLLING

STEP = 1e-5


class Case:
    """A scene at a state in which it rolls: the wheel is its first body, on the ground."""

    def __init__(self, name: str) -> None:
        self.equations = cd.derive(ROLLING[name]())
        self.model = cd.compile(self.equations)
        joint = self.equations.system.joints[0]
        self.kind: Any = joint.element
        frames = self.equations.system.frames
        self.wheel, self.plane = frames[joint.child_frame].name, frames[joint.parent_frame].name
        rng = np.random.default_rng(3)
        self.q = rng.uniform(0.2, 0.6, self.model.nq)
        u = rng.uniform(-1, 1, self.model.nu)
        self.u = self.model.close_velocity(self.q, u)[: self.model.nu]
        self.udot = self.model.forward_dynamics(self.q, self.u)

    def moved(self, h: float) -> tuple[np.ndarray, np.ndarray]:
        """The state a short time later; coordinates are as accurate as their second derivative."""
        q = self.q + h * self.u + h * h / 2 * self.udot
        return q, self.u + h * self.udot

    def contact(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Center, lowest point, normal and heading of the wheel, from its pose alone."""
        pose, ground = self.model.pose(self.wheel, q), self.model.pose(self.plane, q)
        n = np.array(self.kind.normal) / np.linalg.norm(self.kind.normal)
        # the axle is the second direction across the normal: y for "z", z for "x"
        axle = np.array([0.0, 0, 1]) if self.kind.normal == (1, 0, 0) else _second(n)
        axle, n = pose[:3, :3] @ axle, ground[:3, :3] @ n
        heading = np.cross(axle, n)
        heading /= np.linalg.norm(heading)
        up, crown = np.cross(heading, axle), float(getattr(self.kind, "crown", 0.0))
        point = pose[:3, 3] - (self.kind.radius - crown) * up - crown * n
        assert abs(n @ (point - ground[:3, 3])) < 10 * EPS
        return pose[:3, 3], point, n, heading

    def slip(self, q: np.ndarray, u: np.ndarray) -> list[float]:
        """Velocity of the material point of contact, along what must not slip."""
        center, point, n, heading = self.contact(q)
        twist = self.model.velocity(self.wheel, q, u)
        velocity = twist[3:] + np.cross(twist[:3], point - center)
        assert abs(n @ velocity) < 100 * EPS
        along = {"longitudinal": heading, "lateral": np.cross(n, heading)}
        return [float(along[c.name] @ velocity) for c in self.kind.slips]


def _second(n: np.ndarray) -> np.ndarray:
    """Where y goes by the shortest rotation of z to n."""
    x, y, z = n
    return np.array([-x * y / (1 + z), 1 - y * y / (1 + z), -y])


@pytest.fixture(scope="module", params=ROLLING)
def case(request: pytest.FixtureRequest) -> Case:
    return Case(request.param)


def test_the_contact_does_not_slip_and_stays_so(case: Case) -> None:
    assert np.abs(case.slip(case.q, case.u)).max() < 100 * EPS
    rates = [np.array(case.slip(*case.moved(h))) for h in (STEP, -STEP)]
    # a central difference, and rounding divided by its step
    assert np.abs(rates[0] - rates[1]).max() / (2 * STEP) < 1e2 * STEP**2 + 1e2 * EPS / STEP


def test_energy_stays(case: Case) -> None:
    energy = [case.model.energy(*case.moved(h)).total for h in (STEP, -STEP)]
    assert abs(energy[0] - energy[1]) / (2 * STEP) < 1e3 * STEP**2 + 1e3 * EPS / STEP


def test_constraint_forces_balance_the_independent_equations(case: Case) -> None:
    """M udot + h of Newton and Euler in NumPy is Gᵀ lam, in newtons."""
    q, u, model = case.q, case.u, case.model
    left = inverse_dynamics(scene_of(model), q, u, case.udot)
    lam = model.multipliers(q, u)
    G = model.constraint_jacobian(q)
    assert G.shape == (len(case.kind.slips), model.nu)
    assert np.abs(left - G.T @ lam).max() < 1e4 * EPS * np.abs(left).max()
    assert [row["unit"] for row in model.manifest["multipliers"]] == ["N"] * len(lam)


def test_the_plane_acts_at_the_point_of_contact(case: Case) -> None:
    """Its force has no moment there, and no component along what may slip."""
    q, u = case.q, case.u
    center, point, n, heading = case.contact(q)
    wrench = case.model.reaction("rolls", q, u)
    turn = case.model.pose(case.wheel, q)[:3, :3]
    moment, force = turn @ wrench[:3], turn @ wrench[3:]
    size = np.abs(wrench).max()
    assert np.abs(moment - np.cross(point - center, force)).max() < 1e4 * EPS * size
    along = {"longitudinal": heading @ force, "lateral": np.cross(n, heading) @ force}
    lam = dict(zip([c.name for c in case.kind.slips], case.model.multipliers(q, u), strict=True))
    for name, value in along.items():
        assert abs(value - lam.get(name, 0.0)) < 1e4 * EPS * size


def test_random_states_are_regular(case: Case) -> None:
    """No wheel lies flat."""
    q, _ = case.model.split(case.model.random_state(1, (500,)))
    lean = q[:, case.model.coordinates.index("rolls.lean")]
    assert 1.3 < np.abs(lean).max() < 0.9 * np.pi / 2
    assert np.abs(q[:, case.model.coordinates.index("rolls.yaw")]).max() > 3
