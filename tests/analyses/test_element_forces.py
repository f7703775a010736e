"""Forces of elements by name: closed forms, the work in the ledger, and equilibrium of what they
hold, in both kinds of coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose

import cardan as cd

BOTH = pytest.mark.parametrize("coordinates", ["relative", "absolute"])
G = 9.81


def run(scene: cd.Scene, coordinates: str, time: float = 0.5, **values: Any) -> cd.Trajectory:
    # smooth laws: what remains is the error of the integration
    options = {"rtol": 1e-9, "atol": 1e-11} if coordinates == "relative" else {"rtol": 1e-7}
    model = cd.compile(cd.derive(scene, coordinates=coordinates))
    return model.simulate(time, **values, **options)


def pendulum(name: str = "pendulum") -> tuple[cd.Scene, cd.Body]:
    scene = cd.Scene(name, gravity=(0, 0, -G))
    rod = scene.body("rod", mass=2.0, com=(0, 0, -0.5), inertia=(0.2, 0.2, 0.01))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, rod)
    return scene, rod


@BOTH
def test_a_spring_pulls_along_its_line(coordinates: str) -> None:
    scene, rod = pendulum()
    tip, wall = rod.at(0, 0, -1, name="tip"), scene.ground.at(1.5, 0, -0.4, name="wall")
    k, c, free = 30.0, 4.0, 0.8
    scene.force("spring", cd.SpringDamper(tip, wall, stiffness=k, damping=c, rest_length=free))
    motion = run(scene, coordinates, q={"hinge": 0.4})
    span = motion.pose("wall")[:, :3, 3] - motion.pose("tip")[:, :3, 3]
    length = np.linalg.norm(span, axis=1)
    model = motion.model
    velocity = model.velocity("tip", motion.q, motion.u)[:, 3:]
    rate = -np.einsum("ij,ij->i", velocity, span) / length
    assert_allclose(motion["spring.force"], k * (length - free) + c * rate, rtol=1e-9, atol=1e-9)
    assert motion["spring.force"].shape == motion.t.shape


@BOTH
def test_joint_elements_by_their_laws(coordinates: str) -> None:
    scene, _ = pendulum()
    q, u = scene.q("hinge"), scene.u("hinge")
    scene.force("spring", cd.JointSpring("hinge", stiffness=7.0, rest=0.2, damping=0.5))
    scene.force("damper", cd.JointDamper("hinge", 0.3))
    scene.force("motor", cd.JointForce("hinge", 2 * cd.t - 0.1 * q * u))
    scene.force("drag", cd.Friction("hinge", coulomb=0.4, smooth=0.05))
    scene.force("drive", cd.Drive("hinge", 0.01, ratio=5.0, torque=0.2, friction=0.001))
    motion = run(scene, coordinates, q={"hinge": 0.4})
    q, u = motion["hinge"], motion["hinge.u"]
    expected = {
        "spring": -7.0 * (q - 0.2) - 0.5 * u,
        "damper": -0.3 * u,
        "motor": 2 * motion.t - 0.1 * q * u,
        "drag": -0.4 * np.tanh(u / 0.05),
        "drive": 5.0 * (0.2 - 0.001 * 5.0 * u),
    }
    for name, force in expected.items():
        assert_allclose(motion[f"{name}.force"], force, rtol=1e-8, atol=1e-9, err_msg=name)
    row = next(r for r in motion.manifest.element_forces if r.name == "motor.force")
    assert (row.element, row.unit) == ("motor", "N*m")


@BOTH
def test_the_work_of_forces_is_that_of_the_ledger(coordinates: str) -> None:
    """Power integrated from forces and velocities, by another rule than the ledger's."""
    scene = cd.Scene("ball", gravity=(0, 0, -G))
    ball = scene.body("ball", mass=1.5, com=(0.1, 0, 0), inertia=(0.02, 0.03, 0.04))
    scene.joint("free", cd.Free(), scene.ground, ball)
    port = ball.at(0.2, -0.1, 0.3, name="port")
    v = port.velocity()
    scene.force("drag", cd.Force(port, [-0.6 * x for x in v]))
    scene.force("spin", cd.Torque(ball, (0.1, 0.2, -0.05), in_=port))
    law = {"stiffness": 20.0, "damping": 3.0}
    kind = cd.Maxwell if coordinates == "relative" else cd.SpringDamper
    scene.force("strut", kind(port, scene.ground, **law))
    motion = run(scene, coordinates, 0.4, q={"free": [1, 0, 0, 0, 0.5, 0.2, 1.0]},
                 u={"free": [1.0, -2.0, 0.5, 0.3, 0.0, 1.0]})  # fmt: skip
    assert motion["drag.force"].shape == (len(motion.t), 3)
    times = np.linspace(0, 0.4, 2001)
    fine = motion.resample(times)
    for name, frame in (("drag", "port"), ("spin", "ball")):
        twist = motion.model.velocity(frame, fine.q, fine.u)
        power = np.einsum("ij,ij->i", fine[f"{name}.moment"], twist[:, :3])
        power += np.einsum("ij,ij->i", fine[f"{name}.force"], twist[:, 3:])
        work = np.trapezoid(power, times)
        assert_allclose(work, motion.work[name][-1], rtol=2e-5, atol=1e-6, err_msg=name)
    # the strut pulls the port towards the ground
    pose, twist = fine.pose("port"), motion.model.velocity("port", fine.q, fine.u)
    along = -pose[:, :3, 3] / np.linalg.norm(pose[:, :3, 3], axis=1)[:, None]
    power = fine["strut.force"] * np.einsum("ij,ij->i", along, twist[:, 3:])
    stored = 0.0
    if coordinates == "absolute":
        # the energy of the spring is not work of the ledger
        span = np.linalg.norm(pose[:, :3, 3], axis=1)
        stored = 20.0 / 2 * (span[-1] ** 2 - span[0] ** 2)
    work = motion.work["strut"][-1] - stored
    assert_allclose(np.trapezoid(power, times), work, rtol=1e-4, atol=1e-6)
    # components have names too
    assert np.array_equal(motion["drag.force.y"], motion["drag.force"][:, 1])


def test_contact_carries_the_weight() -> None:
    scene = cd.Scene("ball", gravity=(0, 0, -G))
    ball = scene.body("ball", mass=2.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("way", cd.Prismatic("z"), scene.ground, ball)
    law = cd.Contact(ball, scene.ground, radius=0.1, stiffness=1e5, damping=0.5, exponent=1.0)
    scene.force("floor", law)
    model = cd.compile(scene)
    rest = model.equilibrium(q={"way": 0.0999})
    assert_allclose(rest["floor.force"], [0, 0, 2.0 * G], atol=1e-6)
    assert_allclose(rest["floor.moment"], 0, atol=1e-9)
    motion = model.simulate(0.2, q={"way": 0.2})
    # it hits the floor after 0.14 s: no force in the air
    flying = motion["way"] > 0.1
    assert_allclose(motion["floor.force"][flying], 0, atol=1e-12)
    # between, momentum is what forces make of it
    assert motion["floor.force"][:, 2].max() > 2.0 * G


def test_stops_latches_and_sticking_friction_hold() -> None:
    moment = 2.0 * G * 0.5
    scene, _ = pendulum("stopped")
    scene.force("stop", cd.Stop("hinge", lower=0.3))
    rest = cd.compile(scene).equilibrium(q={"hinge": 0.4})
    # gravity turns it down; the stop pushes up
    assert rest["stop.force"] == pytest.approx(moment * np.sin(0.3), rel=1e-9)
    motion = cd.compile(scene).simulate(2.0, q={"hinge": 0.31})
    assert motion["stop"][-1] == -1
    assert motion["stop.force"][-1] == pytest.approx(moment * np.sin(0.3), rel=1e-6)
    assert motion["stop.force"][0] == 0

    scene, _ = pendulum("sticking")
    scene.force("bearing", cd.Friction("hinge", coulomb=0.5, static=20.0))
    motion = cd.compile(scene).simulate(0.2, q={"hinge": 0.6})
    assert_allclose(motion["bearing.force"][-1], moment * np.sin(0.6), rtol=1e-9)

    scene, _ = pendulum("latched")
    scene.force("latch", cd.Lock("hinge", when=scene.q("hinge") - 10, locked=True))
    motion = cd.compile(scene).simulate(0.2, q={"hinge": 0.6})
    assert_allclose(motion["latch.force"], moment * np.sin(0.6), rtol=1e-9)


def test_friction_by_reactions() -> None:
    """A slide on level ground: the normal force is the weight."""
    scene = cd.Scene("sledge", gravity=(0, 0, -G))
    sledge = scene.body("sledge", mass=3.0, inertia=(1, 1, 1))
    scene.joint("way", cd.Prismatic("x"), scene.ground, sledge)
    scene.force("snow", cd.Friction("way", mu=0.2))
    motion = cd.compile(scene).simulate(0.5, u={"way": 2.0})
    sliding = motion["way.u"] > 1e-6
    assert sliding.sum() > 1
    assert_allclose(motion["snow.force"][sliding], -0.2 * 3.0 * G, rtol=1e-9)


def test_gravitation_has_one_force_per_body() -> None:
    scene = cd.Scene("moons", gravity=(0, 0, 0))
    bodies = [scene.body(n, mass=m, inertia=(1, 1, 1)) for n, m in (("a", 2.0), ("b", 3.0))]
    for body in bodies:
        scene.joint(f"{body.name}_joint", cd.Free(), scene.ground, body)
    scene.force("pull", cd.CentralGravity(scene.ground, mu=10.0))
    model = cd.compile(scene)
    names = [row.name for row in model.manifest.element_forces]
    assert names[:3] == ["pull.a.force.x", "pull.a.force.y", "pull.a.force.z"]
    q = {"a_joint": [1, 0, 0, 0, 2, 0, 0], "b_joint": [1, 0, 0, 0, 0, 4, 0]}
    motion = model.simulate(0.01, q=q)
    assert_allclose(motion["pull.a.force"][0], [-10 * 2 / 4, 0, 0], atol=1e-12)
    assert_allclose(motion["pull.b.force"][0], [0, -10 * 3 / 16, 0], atol=1e-12)


@BOTH
def test_load_paths_and_unknown_names(coordinates: str) -> None:
    scene = cd.Scene("scales", gravity=(0, 0, 0))
    load = scene.parameter("load", 1.0)
    pan = scene.body("pan", mass=1.0, inertia=(1, 1, 1))
    scene.joint("way", cd.Prismatic("z"), scene.ground, pan)
    scene.force("weight", cd.Force(pan, (0, 0, -load)))
    hook = scene.ground.at(0, 0, 2, name="hook")
    scene.force("spring", cd.SpringDamper(pan, hook, stiffness=50.0, rest_length=1.5))
    model = cd.compile(cd.derive(scene, coordinates=coordinates))
    path = model.statics(load=np.linspace(1.0, 5.0, 3))
    assert_allclose(path["spring.force"], path["load"], rtol=1e-8)
    assert_allclose(path["weight.force"][:, 2], -path["load"])
    rest = model.equilibrium()
    assert rest["spring.force"] == pytest.approx(1.0, rel=1e-8)
    motion = model.simulate(0.01)
    for result in (rest, path, motion):
        with pytest.raises(cd.ModelError, match=r"'sprin.force'.*Did you mean 'spring.force'"):
            result["sprin.force"]


def test_states_of_that_name_come_first() -> None:
    scene, _ = pendulum()
    scene.force("motor", cd.Actuator("hinge", command=1.0, lag=0.1, limit=0.5))
    scene.force("mark", cd.Event(scene.q("hinge")))
    model = cd.compile(scene)
    assert not model.manifest.element_forces
    with pytest.raises(cd.CardanError, match="has none"):
        model.element_forces(np.zeros(1), np.zeros(1))


def test_laws_that_read_nodes_drive_a_joint() -> None:
    """The torque on the wheel of a free hub, and one that follows the tip of a beam."""
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=5, inertia=(0.1, 0.2, 0.15))
    scene.joint("drift", cd.Free(), scene.ground, hub)
    dural = cd.material(E=7e10, nu=0.3, rho=2700)
    beam = scene.beam("panel", hub, (1, 0, 0), cd.section.circle(0.01), dural, elements=1)
    scene.force("wheel", cd.Rotor(hub, axis="z", inertia=0.01, torque=0.3 * sp.sin(5 * cd.t)))
    gimbal = scene.body("gimbal", mass=1.0, inertia=(0.01, 0.01, 0.01))
    scene.joint("tilt", cd.Revolute("x"), hub, gimbal)
    follow = 0.1 - 2.0 * beam.end.velocity()[2] - 0.1 * scene.u("tilt")
    scene.force("follow", cd.JointForce("tilt", follow))
    model = cd.compile(scene)
    motion = model.simulate(0.5)
    assert_allclose(motion["wheel.force"], 0.3 * np.sin(5 * motion.t), rtol=0, atol=1e-12)
    q, u = motion.q, motion.u
    tip = model.velocity("panel.end", q, u)[:, 5]
    expected = 0.1 - 2.0 * tip - 0.1 * motion["tilt.u"]
    assert_allclose(motion["follow.force"], expected, rtol=0, atol=1e-12)
    assert "element_forces" in str(model.verify())
