"""Scenes in a plane: x, y and angle of every node give what poses in space give."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import DerivationError
from cardan.runtime.models.finite_elements.elements import State
from spread import some

NORMALS = ("x", "y", "z")
STEEL = {"E": 2.1e8, "nu": 0.3, "rho": 7850.0, "damping": 1e-3}


def turned(normal: str, x: float, y: float) -> tuple[float, ...]:
    """A point of the plane."""
    a = NORMALS.index(normal)
    found = [0.0] * 3
    found[(a + 1) % 3], found[(a + 2) % 3] = x, y
    return tuple(found)


def swing(normal: str, element: str = "hellinger_reissner") -> cd.Scene:
    """An arm with a blade and a hook on it, a spring, and weight."""
    scene = cd.Scene("swing", gravity=turned(normal, -2.0, -9.81))
    arm = scene.body("arm", mass=2, inertia=(0.1, 0.1, 0.1), com=turned(normal, 0.5, 0.0))
    scene.joint("pivot", cd.Revolute(normal), scene.ground, arm)
    blade = scene.beam(
        "blade",
        arm.at(*turned(normal, 1.0, 0.0)),
        turned(normal, 2.0, 0.5),
        section=cd.section.rectangle(width=0.02, height=0.03),
        material=cd.material(**STEEL),
        elements=4,
        element=element,
    )
    hook = scene.body("hook", mass=1, inertia=(0.01, 0.01, 0.01))
    # axes of the section, and of the hook: e2 is along the normal where that is not z
    own = "z" if normal == "z" else "y"
    scene.joint("pin", cd.Revolute(own), blade.end, hook)
    scene.force("wind", cd.LineLoad(blade, force=turned(normal, 3.0, 1.0)))
    along = [hook.at(*turned(own, 0.2, 0.1)), scene.ground.at(*turned(normal, 3.0, 1.0))]
    scene.force("spring", cd.SpringDamper(*along, stiffness=20, rest_length=0.5))
    scene.output("sag", blade.at(0.5).position()[(NORMALS.index(normal) + 2) % 3], unit="m")
    return scene


def both(scene: cd.Scene, normal: str) -> tuple[cd.CompiledModel, cd.CompiledModel]:
    """In the plane and in space."""
    made = [cd.derive(scene, coordinates="absolute", plane=p) for p in (normal, None)]
    plane, space = (cd.compile(equations) for equations in made)
    return plane, space


@pytest.mark.parametrize("normal", some(NORMALS, 3, 1))
def test_motion_of_a_plane_is_that_in_space(normal: str) -> None:
    plane, space = both(swing(normal), normal)
    assert plane.nu < 0.6 * space.nu
    runs = [m.simulate(0.05, step=1e-3, method="GeneralizedAlpha", rtol=1e-11)
            for m in (plane, space)]  # fmt: skip
    for frame in ("hook", "blade.end", "arm"):
        np.testing.assert_allclose(runs[0].pose(frame), runs[1].pose(frame), atol=1e-9)
    np.testing.assert_allclose(runs[0].line("blade"), runs[1].line("blade"), atol=1e-9)
    here, there = ((run.q[-1], run.u[-1]) for run in runs)
    for frame in ("hook", "blade.end"):
        found = plane.velocity(frame, *here), space.velocity(frame, *there)
        np.testing.assert_allclose(*found, atol=1e-7)
        J = plane.frame_jacobian(frame, here[0])
        np.testing.assert_allclose(J @ here[1], found[0], atol=1e-12)
    np.testing.assert_allclose(plane.outputs(*here), space.outputs(*there), atol=1e-9)
    energy = plane.energy(*here).total, space.energy(*there).total
    assert abs(energy[0] - energy[1]) < 1e-8 * abs(energy[1])


@pytest.mark.parametrize("element", some(["hellinger_reissner", "helicoidal", "classical"], 3))
def test_rest_and_modes_of_a_plane_are_those_in_space(element: str) -> None:
    plane, space = both(swing("y", element), "y")
    rest = [model.equilibrium() for model in (plane, space)]
    for frame in ("hook", "blade.end"):
        found = [m.pose(frame, r.q) for m, r in zip((plane, space), rest, strict=True)]
        np.testing.assert_allclose(found[0], found[1], atol=1e-8)
    own, others = (m.modes(x=r).frequencies for m, r in zip((plane, space), rest, strict=True))
    for frequency in own[:6]:
        assert np.abs(others - frequency).min() < 1e-6 * (1 + frequency)


def test_accelerations_and_tangents_in_the_plane() -> None:
    plane, _ = both(swing("y"), "y")
    mesh: Any = plane._source.results(plane).mesh  # type: ignore[attr-defined]
    x = plane.initial()
    q = x[: plane.nq] + 0.01 * np.random.default_rng(0).standard_normal(plane.nq)
    K = mesh.tangent(State(q))["K"].toarray()
    for k in range(plane.nu):
        step = 1e-6 * np.eye(plane.nu)[k]
        sides = [mesh.balance(State(mesh.move(q, sign * step)))[0] for sign in (1.0, -1.0)]
        slope = (sides[0] - sides[1]) / 2e-6
        np.testing.assert_allclose(K[:, k], slope, atol=1e-6 * np.abs(K).max())


def test_the_plane_is_found() -> None:
    found = cd.derive(swing("x"), coordinates="absolute", plane="auto")
    assert "hook.angle" in found.coordinates
    scene = swing("x")
    scene.force("push", cd.LineLoad("blade", force=(1.0, 0.0, 0.0)))
    found = cd.derive(scene, coordinates="absolute", plane="auto")
    assert "hook.px" in found.coordinates


def test_what_leaves_the_plane_is_named() -> None:
    scene = swing("y")
    scene.force("push", cd.LineLoad("blade", force=(0.0, 1.0, 0.0)))
    with pytest.raises(
        DerivationError, match=r"'blade\.\d+' does not stay in the plane across 'y'"
    ):
        cd.derive(scene, coordinates="absolute", plane="y")
    with pytest.raises(DerivationError, match="does not stay in the plane"):
        cd.derive(swing("y"), coordinates="absolute", plane="x")
    with pytest.raises(DerivationError, match=r"plane 'xy' does not exist"):
        cd.derive(swing("y"), coordinates="absolute", plane="xy")  # type: ignore[call-overload]
    with pytest.raises(DerivationError, match="coordinates='absolute'"):
        cd.derive(swing("y"), coordinates="relative", plane="y")  # type: ignore[call-overload]


def test_a_parameter_that_leads_out_of_the_plane_is_seen() -> None:
    scene = cd.Scene("tilted", gravity=(0, 0, -9.81))
    side = scene.parameter("side", 0.0, unit="N")
    body = scene.body("body", mass=1, inertia=(1, 1, 1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, body)
    scene.force("push", cd.Force(body, (0, side, 0)))
    with pytest.raises(DerivationError, match="'push' does not stay"):
        cd.derive(scene, coordinates="absolute", plane="y")


def planar_arm(kind: str) -> cd.Scene:
    """Two rigid links and a beam on them, and what acts there."""
    scene = cd.Scene("arm")
    hub = scene.body("hub", mass=2, com=(0.1, 0, 0), inertia=(0.1, 0.2, 0.1))
    link = scene.body("link", mass=1, com=(0.2, 0, 0), inertia=(0.01, 0.02, 0.01))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    scene.joint("elbow", cd.Revolute("y"), hub.at(0.4, 0, 0), link)
    section = cd.section.general(EA=1e5, GA=1e5, GJ=20, EI=20, rhoA=0.4, rhoI=1e-3)
    boom = scene.beam("boom", link.at(0.3, 0, 0), (1.5, 0, 0.1), section, elements=3)
    angle, speed = scene.q("hinge"), scene.u("hinge")
    if kind == "frame":
        scene.beam("tip", boom.end, (2.0, 0, 0.3), section, elements=2)
    elif kind == "stop":
        scene.force("stop", cd.Stop("elbow", lower=-0.02, upper=0.05, restitution=0.3))
    elif kind == "controller":
        pull = -20 * scene.state("servo.error") - 2 * speed
        scene.force("servo", cd.Controller("hinge", ("error",), (angle,), pull))
    elif kind == "sampled":
        scene.force("servo", cd.Controller("hinge", force=-20 * angle - 2 * speed, sample=0.01))
    elif kind == "latch":
        scene.force("latch", cd.Lock("elbow", when=scene.q("elbow") + 0.02))
    else:
        ball = scene.body("ball", mass=0.2, inertia=(1e-3, 1e-3, 1e-3))
        scene.joint("pin", cd.Revolute("y"), boom.end, ball)
        floor = scene.ground.at(0, 0, -0.2)
        if kind == "contact":
            contact = cd.Contact(ball, floor, 0.05, 1e4, exponent=1.0, damping=0.2)
            scene.force("floor", contact)
        else:
            tables = {"x": cd.table([-2, -0.5, 0, 0.5, 2], [-9, -1, 0, 2, 12])}
            branches = [((2, 2, 2, 40, 40, 40), 0.05)]
            ends = ball, scene.ground.at(1.5, 0, 0)
            stiffness, damping = (5, 5, 5, 90, 90, 90), (0.1,) * 6
            mount = cd.Bushing(*ends, stiffness, damping, tables=tables, branches=branches)
            scene.force("mount", mount)
    return scene


KINDS = ("frame", "stop", "controller", "sampled", "latch", "contact", "bushing")


@pytest.mark.parametrize("kind", some(KINDS, 7, 3))
def test_rigid_trees_events_and_controllers_in_the_plane(kind: str) -> None:
    """Accelerations to rounding, and short runs through the events."""
    scene = planar_arm(kind)
    u = {"hinge": 0.4, "elbow": -1.5}
    for coordinates in ("auto", "absolute"):
        equations = cd.derive(scene, coordinates=coordinates, plane="auto")
        assert "boom.end.angle" in equations.coordinates
        models = cd.compile(equations), cd.compile(scene, coordinates=coordinates)
        assert models[0].nu < 0.6 * models[1].nu
        found = []
        for model in models:
            q, speeds = model.split(model.initial(u=u))
            udot = model.forward_dynamics(q, speeds)
            rows = [model.acceleration(n, q, speeds, udot) for n in ("link", "boom.end")]
            motion = model.simulate(0.06, u=u, step=1e-3, method="GeneralizedAlpha", rtol=1e-12)
            found.append((np.array(rows), motion.pose("boom.end"), len(motion.events)))
        (rows, poses, events), (of_space, poses_of_space, events_of_space) = found
        scale = np.abs(of_space).max()
        np.testing.assert_allclose(rows, of_space, atol=1e-10 * scale)
        np.testing.assert_allclose(poses, poses_of_space, atol=1e-6)
        assert events == events_of_space


def test_rigid_scenes_take_the_plane_that_there_is() -> None:
    scene = cd.Scene("pendulum")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    assert cd.derive(scene, plane="auto").coordinates == cd.derive(scene).coordinates
