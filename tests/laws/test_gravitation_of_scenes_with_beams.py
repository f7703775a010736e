"""Gravity fields in scenes with beams: a rigid rod in closed form, other coordinates, files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd
from equations.finite_elements.reference import Reference
from equations.finite_elements.test_tangents import tangents_agree
from laws.gravity_scenes import MU, boom


def state(model: Any) -> tuple[Any, Any]:
    """A state with little strain that nothing singles out."""
    x, random = model.initial(), np.random.default_rng(3)
    du, u = random.uniform(-1, 1, (2, model.nu))
    return model.integrate(x[: model.nq], 1e-3 * du), u


def law(scene: cd.Scene) -> Any:
    """A strength that changes with time, an input, a speed and the place of a frame."""
    place = scene.bodies["hub"].at(0.2, 0.1, 0).position()[0]
    speed = scene.u("hub" if scene.joints["hub"].kind.kind == "revolute" else "hub.x")
    return MU * (1 + cd.t) + scene.input("more", default=2.0) + speed / 5 + place**2


@pytest.mark.parametrize(
    ("center", "hub"),
    [
        pytest.param("ground", "free", marks=pytest.mark.slow),
        pytest.param("node", "hinged", marks=pytest.mark.slow),
        ("tree", "hinged"),
    ],
)
def test_strength_may_change_with_all_that_moves(center: str, hub: str) -> None:
    """Accelerations are those of the number that the law gives; power is accounted for."""
    model = cd.compile(boom(law, center, hub))
    q, u = state(model)
    strength = model.outputs(q, u, t=0.7, r=[4.0])[0]
    fixed = cd.compile(boom(lambda scene: float(strength), center, hub))
    expected = fixed.forward_dynamics(q, u)
    udot = model.forward_dynamics(q, u, t=0.7, r=[4.0])
    np.testing.assert_allclose(udot, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())
    other = model.forward_dynamics(q, u, t=0.7, r=[9.0])
    assert np.abs(other - udot).max() > 0.1
    tangents_agree(Reference(cd.derive(boom(law, center, hub)), None, None))
    model.verify()


def test_work_of_a_field_that_grows_is_accounted_for() -> None:
    model = cd.compile(boom(law))
    motion = model.simulate(0.3, rtol=1e-8, atol=1e-11)
    size = np.abs(motion.work_done[-1]).sum()
    assert size > 0.1
    assert np.abs(motion.energy_residual).max() < 1e-6 * size


@pytest.mark.slow
def test_energy_is_kept_to_rounding_where_the_method_does_so() -> None:
    """Outputs, which have no balance, stand among the elements."""
    model = cd.compile(boom(lambda scene: MU, inertia="lumped"), coordinates="absolute")
    motion = model.simulate(0.5, method="EnergyMomentum", step=1e-3)
    energy = motion.energy.total
    # the energies that it is the difference of are two orders larger
    assert np.abs(energy - energy[0]).max() < 1e-11 * np.abs(motion.energy.potential).max()
    assert motion.energy.kinetic[-1] > 0.1
    expected = model.simulate(0.5, rtol=1e-8, atol=1e-11)
    np.testing.assert_allclose(motion.q[-1], expected.q[-1], atol=1e-5)


@pytest.mark.slow
def test_strength_by_a_state_of_another_element() -> None:
    """An actuator that follows its command; accelerations are those of the same number."""

    def slow(scene: cd.Scene) -> Any:
        scene.force("lag", cd.Actuator("hub", command=30.0, lag=0.2))
        return MU + scene.state("lag.force")

    model = cd.compile(boom(slow, hub="hinged"))
    (q, u), z = state(model), [7.0]
    fixed = boom(lambda scene: MU + 7.0, hub="hinged")
    fixed.force("torque", cd.JointForce("hub", 7.0))
    expected = cd.compile(fixed).forward_dynamics(q, u)
    np.testing.assert_allclose(model.forward_dynamics(q, u, z=z), expected, rtol=1e-9, atol=1e-9)


@pytest.mark.slow
def test_linear_model_has_the_input_of_the_field() -> None:
    model = cd.compile(boom(lambda scene: scene.input("mu", default=MU)))
    q, u = state(model)
    linear = model.linearize(q=q, u=0 * u)
    rates = [model.forward_dynamics(q, 0 * u, r=[mu]) for mu in (MU - 1, MU + 1)]
    # accelerations are linear in the strength
    expected = (rates[1] - rates[0]) / 2
    np.testing.assert_allclose(
        linear.B[-model.nu :, 0], expected, atol=1e-8 * np.abs(expected).max()
    )


@pytest.mark.parametrize(
    "joint", [pytest.param(cd.Free(), marks=pytest.mark.slow), cd.Revolute("z")]
)
def test_beam_on_the_body_of_the_center(joint: Any) -> None:
    """All forces are internal: momentum stays, and the linear model has their derivative."""
    scene = cd.Scene("own", gravity=(0, 0, 0))
    planet = scene.body("planet", mass=5.0, inertia=(1, 1.2, 1.3))
    scene.joint("planet", joint, scene.ground, planet)
    section = cd.section.general(EA=1e3, GA=1e3, GJ=1e2, EI=1e2, rhoA=1.3, rhoI=(0.02, 0.03))
    scene.beam("beam", planet.at(0.5, 0, 0), (3, 0.5, 0), section, elements=2)
    center = planet.at(0.1, 0.3, 0.2)
    scene.force("pull", cd.CentralGravity(center, MU, bodies="beam"))
    scene.force("flat", cd.J2(center, MU, 0.1, 1.0, pole=(0.1, 0.2, 0.9), bodies="beam"))
    model = cd.compile(scene)
    model.verify()
    q, u = state(model)
    step = 1e-5
    ahead, behind = (model.integrate(q, s * step * u) for s in (1, -1))
    udot = model.forward_dynamics(q, u)
    ends = [model.momentum(x, u + s * step * udot) for s, x in ((1, ahead), (-1, behind))]
    kept = slice(2, 3) if joint.kind == "revolute" else slice(0, 6)
    rate = ((ends[0] - ends[1]) / (2 * step))[kept]
    size = np.abs(model.mass_matrix(q) @ udot).max()
    assert np.abs(rate).max() < 1e-6 * size
    linear = model.linearize(q=q, u=0 * u)
    du = np.random.default_rng(5).uniform(-1, 1, model.nu)
    ends = [model.forward_dynamics(model.integrate(q, s * step * du), 0 * u) for s in (1, -1)]
    slope = (ends[0] - ends[1]) / (2 * step)
    block = linear.A[-model.nu :, : model.nu]
    np.testing.assert_allclose(block @ du, slope, atol=1e-5 * np.abs(slope).max())


@pytest.mark.parametrize("center", ["ground", pytest.param("tree", marks=pytest.mark.slow)])
def test_coordinates_do_not_change_accelerations(center: str) -> None:
    """Ends on rigid trees by elimination, against nodes held by rows of constraints."""
    scene = boom(lambda scene: MU, center, "hinged")
    models = [cd.compile(cd.derive(scene, coordinates=kind)) for kind in ("auto", "absolute")]
    assert models[0].nu < models[1].nu
    values = []
    for model in models:
        x = model.initial(q={"hub": 0.3}, u={"hub": 0.4})
        q, u = x[: model.nq], x[model.nq : model.nq + model.nu]
        udot = model.forward_dynamics(q, u)
        values.append([model.acceleration(f, q, u, udot) for f in ("hub", "beam.end")])
    np.testing.assert_allclose(*values, atol=1e-9 * np.abs(values).max())


@pytest.mark.slow
def test_planar_nodes_are_those_in_space() -> None:
    def planar() -> cd.Scene:
        scene = cd.Scene("planar", gravity=(0, 0, 0))
        hub = scene.body("hub", mass=2.0, inertia=(0.1, 0.1, 0.1))
        scene.joint("hub", cd.Planar("z"), scene.ground, hub, q0=(3, 0, 0))
        planet = scene.body("planet", mass=5.0, inertia=(1, 1, 1))
        scene.joint("planet", cd.Planar("z"), scene.ground, planet, u0=(0.1, 0.2, 0.3))
        section = cd.section.general(EA=1e4, GA=1e4, GJ=1e3, EI=1e3, rhoA=1.3, rhoI=0.02)
        scene.beam("beam", hub, (5, 0.5, 0), section, elements=3)
        center = planet.at(0.2, 0.1, 0)
        scene.force("pull", cd.CentralGravity(center, MU * (1 + cd.t)))
        scene.force("extent", cd.GravityGradient(center, MU))
        return scene

    models = [cd.compile(cd.derive(planar(), plane=plane)) for plane in ("z", None)]
    assert models[0].nu < models[1].nu
    models[0].verify()
    ends = [model.simulate(0.5, rtol=1e-9, atol=1e-12) for model in models]
    poses = [motion.pose("beam.end")[-1] for motion in ends]
    np.testing.assert_allclose(*poses, atol=1e-7)


def test_scene_files_name_beams(tmp_path: Path) -> None:
    scene = boom(lambda scene: MU, bodies=("hub", "beam"))
    scene.save(tmp_path / "boom.yaml")
    models = [cd.compile(one) for one in (scene, cd.load(tmp_path / "boom.yaml"))]
    q, u = state(models[0])
    np.testing.assert_array_equal(*(model.forward_dynamics(q, u) for model in models))
    text = (tmp_path / "boom.yaml").read_text().replace("[hub, beam]", "[hub, bean]")
    (tmp_path / "boom.yaml").write_text(text)
    with pytest.raises(cd.ModelError, match=r"body or beam 'bean' does not exist.*'beam'"):
        cd.load(tmp_path / "boom.yaml")


def test_force_on_a_body_beside_a_beam_is_called_after_the_body() -> None:
    model = cd.compile(boom(lambda scene: MU))
    motion = model.simulate(0.1)
    r = motion.pose("hub")[0, :3, 3] - [0.1, 0.2, 0.3]
    expected = -MU * 2.0 * r / np.linalg.norm(r) ** 3
    np.testing.assert_allclose(motion["pull.hub.force"][0], expected, atol=1e-12)


def test_stiff_beam_moves_like_a_rigid_rod() -> None:
    """Planar motion of a rod near the center, with the logarithmic potential of a line of mass."""
    length, density, mu = 1.0, 1.0, 9.0
    middle, angle = np.array([3.0, 0.0]), 0.4

    def slopes(t: float, x: Any) -> Any:
        e, n = (np.array(v) for v in ((np.cos(x[2]), np.sin(x[2])), (-np.sin(x[2]), np.cos(x[2]))))
        ends = [x[:2] + s * length / 2 * e for s in (-1, 1)]
        sizes = [np.linalg.norm(end) for end in ends]
        pull = 2 * mu * density * length / (sum(sizes) ** 2 - length**2)
        units = [end / size for end, size in zip(ends, sizes, strict=True)]
        force = -pull * (units[0] + units[1])
        torque = -pull * length / 2 * n @ (units[1] - units[0])
        mass = density * length
        return [*x[3:], *force / mass, torque / (mass * length**2 / 12)]

    spin, speed = 0.3, np.array([0.0, 1.7])
    rod = solve_ivp(slopes, (0, 3), [*middle, angle, *speed, spin], rtol=1e-10, atol=1e-12)

    e = np.array([np.cos(angle), np.sin(angle)])
    ends = [middle + s * length / 2 * e for s in (-1, 1)]
    scene = cd.Scene("rod", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1e-8, inertia=(1e-10,) * 3)
    rate = speed - spin * length / 2 * np.array([-e[1], e[0]])
    at = scene.ground.at(*ends[0], 0)
    scene.joint("free", cd.Free(), at, hub, u0=(0, 0, spin, *rate, 0))
    section = cd.section.general(EA=3e4, GA=3e4, GJ=1e4, EI=1e4, rhoA=density, rhoI=1e-8)
    scene.beam("beam", hub, (*ends[1], 0), section, elements=4)
    scene.force("field", cd.CentralGravity(scene.ground, mu))
    motion = cd.compile(scene).simulate(3.0, rtol=1e-7, atol=1e-10)
    start, end = motion.pose("hub")[-1, :2, 3], motion.pose("beam.end")[-1, :2, 3]
    turn = np.arctan2(*(end - start)[::-1])
    final = rod.y[:, -1]
    # the stretch of the beam is left out, and (element / distance)^4 of the field
    np.testing.assert_allclose((start + end) / 2, final[:2], atol=1e-4)
    assert abs((turn - final[2] + np.pi) % (2 * np.pi) - np.pi) < 2e-4
    # a point mass would be elsewhere, and a rod without torque turned otherwise
    assert abs(final[2] - angle - 3 * spin) > 0.02
