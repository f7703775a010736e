"""Fields of gravity along beams, against integrals along their line and closed forms of orbits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad_vec

import cardan as cd
from cardan.elements.flexible import GravityField
from cardan.ir.interpreter import evaluate
from equations.finite_elements.reference import Reference
from equations.finite_elements.test_tangents import tangents_agree
from laws.gravity_scenes import MU, boom


def flat_boom(center: str = "ground", hub: str = "free", inertia: str = "linked") -> cd.Scene:
    """A hub with a beam, pulled by all fields about a point of the ground or of a body."""
    scene = boom(lambda scene: MU, center, hub, inertia=inertia)
    place = scene.bodies.get("planet", scene.ground).at(0.1, 0.2, 0.3)
    scene.force("flat", cd.J2(place, MU, 0.1, 1.0, pole=(0.1, 0.2, 0.9), gradient=True))
    return scene


@pytest.mark.parametrize(
    ("center", "hub", "inertia"),
    [("ground", "free", "lumped"), ("node", "free", "linked"), ("tree", "hinged", "linked")],
)
def test_tangents_are_derivatives(center: str, hub: str, inertia: str) -> None:
    equations = cd.derive(flat_boom(center, hub, inertia))
    assert any("gravity_field" in kind.name for kind in equations.kinds)
    tangents_agree(Reference(equations, None, None))


def _data(element: GravityField, **given: float) -> list[float]:
    unit = {f"center_R{i}{i}": 1.0 for i in (1, 2, 3)}
    stiff = dict.fromkeys(("EI2", "EI3", "GA2", "GA3"), 1.0)
    numbers = {"rhoA": 1.3, "mu": MU, "length": 1.0, **stiff, **unit, **given}
    kinds = ("node", "node", "offset") if given.get("moving") else ("node", "node")
    return [numbers.get(name, 0.0) for name in element.data(kinds)]


@pytest.mark.parametrize("distance", [30.0, 7e6])
def test_pull_of_a_straight_beam_is_an_integral_along_it(distance: float) -> None:
    """Total force and moment about the middle; two points leave out (length / distance)^4."""
    element, direction = GravityField(), np.array([0.6, 0.0, 0.8])
    turn = [np.sqrt(0.8), 0.0, -np.sqrt(0.2), 0.0]
    middle = np.array([distance, 0.0, 0.0])
    ends = [middle - direction / 2, middle + direction / 2]
    mu = MU * distance**2
    values = {"q": [*turn, *ends[0], *turn, *ends[1]], "p": _data(element, mu=mu)}
    b = -np.ravel(evaluate(element.derived()["balance"], values)["balance"]).astype(float)
    R = np.array([[0.6, 0, -0.8], [0, 1, 0], [0.8, 0, 0.6]])
    force = b[3:6] + b[9:12]
    moment = R @ (b[:3] + b[6:9]) + np.cross(direction / 2, b[9:12] - b[3:6])

    def density(s: float) -> Any:
        # the pull less that of the middle, whose moment is 0: no digits are lost far away
        x, arm = s * direction, 2 * s * direction[0] / distance + (s / distance) ** 2
        grown = np.expm1(-1.5 * np.log1p(arm))
        f = -1.3 * MU * ((x + middle) / distance * grown + x / distance)
        return np.concatenate([f, np.cross(x, f)])

    expected, _ = quad_vec(density, -0.5, 0.5, epsabs=1e-16, epsrel=1e-12)
    expected[:3] -= 1.3 * MU * middle / distance
    order = distance**-4 + 1e-15
    np.testing.assert_allclose(force, expected[:3], atol=2 * order * 1.3 * MU)
    # rounding of the pull itself against its differences along the beam
    limit = 2 * distance**-3 * 1.3 * MU if distance < 100 else 1e-14 * MU
    np.testing.assert_allclose(moment, expected[3:], atol=limit)
    assert abs(expected[4]) > 10 * limit


@pytest.mark.parametrize("torque_alone", [False, True])
def test_center_that_moves_is_pulled_back(torque_alone: bool) -> None:
    """Shifts and turns of everything do no work."""
    fields = (cd.GravityGradient("a", MU, force=not torque_alone), cd.CentralGravity("a", MU))
    rng = np.random.default_rng(4)
    kinds = ("node", "node", "offset")
    for field in fields:
        element = GravityField(field)
        q = rng.normal(size=(3, 7))
        q[:, :4] /= np.linalg.norm(q[:, :4], axis=1)[:, None]
        given = {"rhoI2": 0.3, "rhoI3": 0.2, "center_px": 0.3, "center_pz": -0.2, "moving": 1.0}
        values = {"q": q.ravel(), "p": _data(element, **given)}
        function = element.derived(kinds)["balance"]
        b = np.ravel(evaluate(function, values)["balance"]).astype(float).reshape(3, 6)
        total = b[:, 3:].sum(axis=0)
        moment = sum(
            _rotation(one[:4]) @ load[:3] + np.cross(one[4:], load[3:])
            for one, load in zip(q, b, strict=True)
        )
        size = np.abs(b).max()
        assert size > 0
        assert np.abs(total).max() <= 1e-13 * size
        assert np.abs(moment).max() <= 1e-13 * size


def _rotation(q: Any) -> Any:
    w, x, y, z = q
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * w * skew + 2 * skew @ skew


def test_beams_are_named_like_bodies() -> None:
    scene = flat_boom()
    scene.force("named", cd.CentralGravity(scene.ground, 1.0, bodies=("hub", "beam")))
    scene.force("one", cd.CentralGravity(scene.ground, 1.0, bodies=scene.beams["beam"]))
    with pytest.raises(cd.ModelError, match="beam 'beam' is named twice"):
        cd.CentralGravity(scene.ground, 1.0, bodies=[scene.beams["beam"]] * 2)
    members = cd.derive(scene)
    assert any("gravity_field" in kind.name for kind in members.kinds)
    other = cd.Scene("other")
    other.include(scene, "part_")
    cd.derive(other)


def test_libration_of_a_boom_on_an_orbit() -> None:
    """A slender stiff beam swings with sqrt(3) n about the vertical; energy is kept."""
    angle, half = 0.05, 0.01
    middle, arm = np.array([1.0, 0, 0]), half * np.array([np.cos(angle), np.sin(angle), 0])
    scene = cd.Scene("libration", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1e-6, inertia=(1e-12,) * 3)
    speed = np.cross([0, 0, 1.0], middle - arm)
    scene.joint("free", cd.Free(), scene.ground.at(*(middle - arm)), hub, u0=(0, 0, 1, *speed))
    section = cd.section.general(EA=10, GA=10, GJ=1e-4, EI=1e-4, rhoA=1.0, rhoI=1e-9)
    scene.beam("beam", hub, tuple(middle + arm), section, elements=2)
    scene.force("field", cd.CentralGravity(scene.ground, 1.0))
    model = cd.compile(scene)
    model.verify()
    motion = model.simulate(2 * np.pi / np.sqrt(3), rtol=1e-6, atol=1e-9)
    root, tip = (
        np.stack([motion[f"{name}.p{x}"] for x in "xyz"], axis=-1) for name in ("free", "beam.end")
    )
    root += middle - arm
    along, center = tip - root, (tip + root) / 2
    pitch = np.arctan2(along[:, 1], along[:, 0]) - np.arctan2(center[:, 1], center[:, 0])
    pitch = (pitch + np.pi) % (2 * np.pi) - np.pi
    # the stretch of the beam and second order in size / r are left out
    assert np.abs(pitch - angle * np.cos(np.sqrt(3) * motion.t)).max() < 0.02 * angle
    assert np.abs(motion.energy_residual).max() < 1e-6 * motion.energy.kinetic[0]
