"""Fields of gravity: orbits in closed form, what they keep, the order of what they leave out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

MU = 3.986004418e14
EARTH, FLATTENING = 6378137.0, 1.08262668e-3
TIGHT = {"rtol": 1e-12, "atol": 1e-12}


def orbiting() -> cd.Scene:
    """A body that moves freely about the origin, mu = 1."""
    scene = cd.Scene("orbiting", gravity=(0, 0, 0))
    body = scene.body("body", mass=2.0, inertia=(0.006, 0.01, 0.008))
    scene.joint("free", cd.Free(), scene.ground, body)
    scene.force("field", cd.CentralGravity(scene.ground, 1.0))
    return scene


def test_period_and_apsides_of_kepler() -> None:
    """Half a period leads from a (1 - e) to a (1 + e), a whole one back."""
    a, e = 1.3, 0.6
    period = 2 * np.pi * a**1.5
    speed = np.sqrt((1 + e) / (1 - e) / a)
    motion = cd.compile(orbiting()).simulate(
        [0, period / 2, period],
        q={"free": (1, 0, 0, 0, a * (1 - e), 0, 0)},
        u={"free": (0, 0, 0, 0, 0.6 * speed, 0.8 * speed)},
        **TIGHT,
    )
    np.testing.assert_allclose(motion.q[1, 4:], [-a * (1 + e), 0, 0], atol=2e-10)
    np.testing.assert_allclose(motion.q[2, 4:], [a * (1 - e), 0, 0], atol=2e-10)


def test_two_bodies_attract_each_other() -> None:
    """Their distance is a Kepler orbit of mu = G (m1 + m2); the forces sum to zero."""
    scene, masses = cd.Scene("pair", gravity=(0, 0, 0)), (3.0, 1.0)
    bodies = [scene.body(f"b{k}", mass=m, inertia=(0.1,) * 3) for k, m in enumerate(masses)]
    for k, body in enumerate(bodies):
        scene.joint(f"free{k}", cd.Free(), scene.ground, body)
    scene.force("pull", cd.CentralGravity(bodies[0], 0.5 * masses[0], bodies[1]))
    model, total = cd.compile(scene), 0.5 * sum(masses)
    a, e = 1.0, 0.3
    period = 2 * np.pi * np.sqrt(a**3 / total)
    speed = np.sqrt(total / a * (1 + e) / (1 - e))
    drift = (0.2, -0.1, 0.05)
    motion = model.simulate(
        [0, period / 2, period],
        q={"free1": (1, 0, 0, 0, a * (1 - e), 0, 0)},
        u={"free0": (0, 0, 0, *drift), "free1": (0, 0, 0, 0.2, speed - 0.1, 0.05)},
        **TIGHT,
    )
    apart = motion.q[:, 11:14] - motion.q[:, 4:7]
    np.testing.assert_allclose(apart[1], [-a * (1 + e), 0, 0], atol=2e-10)
    np.testing.assert_allclose(apart[2], [a * (1 - e), 0, 0], atol=2e-10)
    momentum = model.momentum(motion.q, motion.u)
    np.testing.assert_allclose(momentum, momentum[[0, 0, 0]], atol=1e-12)
    pulled = model.forward_dynamics(motion.q, motion.u)
    np.testing.assert_allclose(3.0 * pulled[:, 3:6] + pulled[:, 9:12], 0, atol=1e-14)


def test_long_runs_keep_energy_and_angular_momentum() -> None:
    """A hundred turns of a body with extent, which exchanges momentum with its orbit."""
    scene = orbiting()
    scene.force("extent", cd.GravityGradient(scene.ground, 1.0))
    model = cd.compile(scene)
    motion = model.simulate(
        200 * np.pi,
        q={"free": (1, 0, 0, 0, 1, 0, 0)},
        u={"free": (0.1, 0.2, 0.9, 0, 1.1, 0.2)},
        **TIGHT,
    )
    assert motion.success
    assert np.abs(motion.energy_residual).max() < 2e-9 * motion.energy.kinetic.max()
    momentum = model.momentum(motion.q, motion.u)[:, :3]
    assert np.abs(momentum - momentum[0]).max() < 2e-9 * np.abs(momentum[0]).max()
    # it does exchange: spin alone is not kept
    spin = np.linalg.norm(motion.u[:, :3] * (0.006, 0.01, 0.008), axis=1)
    assert np.ptp(spin) > 1e-4


def test_dumbbell_against_two_points() -> None:
    """What second order leaves out of torque and force falls with the square of size / r."""
    missed = []
    for half in (0.1, 0.05, 0.025):
        scene = cd.Scene("dumbbell", gravity=(0, 0, 0))
        rod = scene.body("rod", mass=2.0, inertia=(0.0, 2 * half**2, 2 * half**2))
        ends = [scene.body(f"end{k}", mass=1.0) for k in range(2)]
        balls = scene.body("balls")
        for k, end in enumerate(ends):
            scene.joint(f"fix{k}", cd.Fixed(), balls.at(half * (2 * k - 1), 0, 0), end)
        for name, body in (("rod", rod), ("balls", balls)):
            scene.joint(name, cd.Free(), scene.ground, body)
        scene.force("on_rod", cd.CentralGravity(scene.ground, 1.0, rod))
        scene.force("extent", cd.GravityGradient(scene.ground, 1.0, rod))
        scene.force("on_balls", cd.CentralGravity(scene.ground, 1.0, ends))
        model = cd.compile(scene, functions=["inverse_dynamics"])
        pose = [1, 0, 0, 0, 0.6, 0.8, -0.4]
        wrench = model.inverse_dynamics([*pose, *pose], np.zeros(12), np.zeros(12))
        first, other = wrench[:6], wrench[6:]
        on_point = 2.0 * np.array(pose[4:]) / np.linalg.norm(pose[4:]) ** 3
        kept = [np.abs(other[:3]).max(), np.abs(other[3:] - on_point).max()]
        lost = [np.abs(first[s] - other[s]).max() for s in (slice(0, 3), slice(3, 6))]
        missed.append(np.array(lost) / kept)
    ratios = np.array(missed[:-1]) / missed[1:]
    np.testing.assert_allclose(ratios, 4, rtol=0.05)


def test_gradient_of_a_flattened_planet_against_points() -> None:
    """Six points in the field of J2 against one body with their inertia."""
    reach, place = np.array([0.02, 0.012, 0.03]), np.array([0.7, -0.5, 0.6])
    planet = {"mu": 2.0, "j2": 0.3, "radius": 0.5, "pole": (0.2, 0.4, 1.0)}
    squares = 2 * reach**2
    scene = cd.Scene("cluster", gravity=(0, 0, 0))
    solid = scene.body("solid", mass=6.0, inertia=tuple(squares.sum() - squares))
    points = scene.body("points")
    six = [scene.body(f"p{k}", mass=1.0) for k in range(6)]
    for k, point in enumerate(six):
        at = np.zeros(3)
        at[k // 2] = reach[k // 2] * (1 - 2 * (k % 2))
        scene.joint(f"fix{k}", cd.Fixed(), points.at(*at), point)
    for name, body in (("solid", solid), ("points", points)):
        scene.joint(name, cd.Free(), scene.ground, body)
    scene.force("on_solid", cd.J2(scene.ground, **planet, bodies=solid, gradient=True))
    scene.force("on_points", cd.J2(scene.ground, **planet, bodies=six))
    model = cd.compile(scene, functions=["inverse_dynamics"])
    pose = [*(np.array([0.9, 0.1, 0.3, -0.2]) / np.sqrt(0.95)), *place]
    wrench = model.inverse_dynamics([*pose, *pose], np.zeros(12), np.zeros(12))
    first, other = wrench[:6], wrench[6:]
    # fourth moments: (reach / r)^2 of the torque, (reach / r)^4 of the force
    np.testing.assert_allclose(first[:3], other[:3], atol=0.02 * np.abs(other[:3]).max())
    np.testing.assert_allclose(first[3:], other[3:], atol=2e-5 * np.abs(other[3:]).max())


def node_rate(j2: float) -> float:
    """Mean rate of the ascending node over the closed form of first order, less 1."""
    radius, lean, turns = 7.2e6, 1.1, 8
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    scene.joint("free", cd.Free(), scene.ground, scene.body("sat", mass=5.0, inertia=(1, 1, 1)))
    scene.force("earth", cd.CentralGravity(scene.ground, MU))
    scene.force("bulge", cd.J2(scene.ground, MU, j2, EARTH))
    speed, n = np.sqrt(MU / radius), np.sqrt(MU / radius**3)
    crossing = scene.bodies["sat"].position()[2]
    scene.force("node", cd.Event(-crossing))
    motion = cd.compile(scene).simulate(
        (turns + 0.5) * 2 * np.pi / n,
        q={"free": (1, 0, 0, 0, radius, 0, -1e-6 * radius)},
        u={"free": (0, 0, 0, 0, speed * np.cos(lean), speed * np.sin(lean))},
        rtol=1e-12,
        atol=1e-9,
    )
    times = np.array([event.t for event in motion.events])
    x, y = motion.at(times)[:, 4:6].T
    node = np.unwrap(np.arctan2(y, x))
    rate = (node[-1] - node[0]) / (times[-1] - times[0])
    return float(rate / (-1.5 * n * j2 * (EARTH / radius) ** 2 * np.cos(lean)) - 1)


def test_node_of_a_flattened_planet() -> None:
    """Omega' = -3/2 n J2 (R / p)^2 cos i, with an error in proportion to J2."""
    coarse, fine = node_rate(FLATTENING), node_rate(FLATTENING / 4)
    # mean and starting radius differ by J2 too
    assert abs(coarse) < 5e-3
    assert coarse / fine == pytest.approx(4, rel=0.1)


# whom it pulls


def test_all_bodies_but_that_of_the_centre_are_pulled(tmp_path: Path) -> None:
    scene = cd.Scene("three", gravity=(0, 0, 0))
    bodies = [scene.body(f"b{k}", mass=1.0 + k) for k in range(3)]
    scene.body("massless")
    for k, body in enumerate([*bodies, scene.bodies["massless"]]):
        scene.joint(f"x{k}", cd.Prismatic("x"), scene.ground.at(k, 0, 0), body)
    scene.joint("fix", cd.Fixed(), bodies[2], scene.body("part", mass=0.5))
    scene.force("some", cd.CentralGravity(bodies[0].at(0.5, 0, 0), 3.0, [bodies[1], "part"]))
    scene.force("all", cd.CentralGravity("b0", 1.0))
    # at x = 1 and 2 m, seen from x = 0.5 and 0 m
    wanted = [3.0 * (2 / 0.25 + 0.5 / 2.25) + 2 + 3.5 / 4, -24 - 2, -1.5 / 2.25 - 3.5 / 4, 0]
    scene.save(tmp_path / "scene.yaml")
    whole = cd.Scene("whole", gravity=(0, 0, 0))
    whole.include(scene, "part")
    late = whole.body("late", mass=9.0)
    whole.joint("late", cd.Prismatic("y"), whole.ground, late)
    for read, more in ((scene, []), (cd.load(tmp_path / "scene.yaml"), []), (whole, [0])):
        equations = cd.derive(read)
        defaults = {p.name: p.value for p in equations.system.parameters}
        defaults |= dict.fromkeys(equations.coordinates, 0.0)
        forces = np.array(equations.forces.subs(defaults), float).ravel()
        np.testing.assert_allclose(forces, wanted + more, rtol=1e-14)


@pytest.mark.parametrize(
    ("bodies", "message"),
    [
        (["b", "ground"], "the ground does not move; leave it out of bodies"),
        ("a", "'a' carries its center; no body pulls itself"),
        ("tip", "'tip' is a frame; give its body, 'b'"),
        ("c", "body 'c' does not exist.*Bodies|'c'"),
        (None, "no body but that of its frame has mass"),
    ],
)
def test_what_cannot_be_pulled(bodies: Any, message: str) -> None:
    scene = cd.Scene("refused")
    for name in "ab":
        mass = 0.0 if bodies is None else 1.0
        scene.joint(name, cd.Prismatic("x"), scene.ground, scene.body(name, mass=mass))
    scene.bodies["b"].at(1, name="tip")
    scene.force("g", cd.CentralGravity("a", 1.0, bodies))
    with pytest.raises(cd.ModelError, match=rf"force 'g' \(central_gravity\).*({message})"):
        cd.derive(scene)
