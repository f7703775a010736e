"""Every part against what is known of it in closed form, or by another way."""

from __future__ import annotations

import itertools
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import fsolve
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.parts import PARTS

Array = NDArray[np.float64]
TIGHT = 1e-9


def run(
    scene: cd.Scene,
    t: float = 0.5,
    u: dict[str, float] | None = None,
    inputs: dict[str, float] | None = None,
) -> tuple[cd.CompiledModel, cd.Trajectory]:
    model = cd.compile(scene)
    start = scene.settings.get("u") if u is None else u
    motion = model.simulate(np.linspace(0, t, 101), u=start, inputs=inputs, rtol=1e-10)
    assert motion.success
    return model, motion


def values(model: cd.CompiledModel) -> dict[str, float]:
    return dict(model.parameters)


def test_four_bar_obeys_freudenstein() -> None:
    """K1 cos(rocker) - K2 cos(crank) + K3 = cos(crank - rocker), and the point by trigonometry."""
    model, motion = run(cd.parts.four_bar(), 2.0)
    p = values(model)
    a, b, c, d = (p[f"{name}_length"] for name in ("crank", "coupler", "rocker", "ground"))
    crank, rocker = motion["crank"], motion["rocker"]
    assert np.ptp(crank) > 2 * np.pi
    freudenstein = d / a * np.cos(rocker) - d / c * np.cos(crank)
    freudenstein += (a * a - b * b + c * c + d * d) / (2 * a * c) - np.cos(crank - rocker)
    assert np.abs(freudenstein).max() < TIGHT
    angle = crank + motion["coupler"]
    x = a * np.cos(crank) + p["point_along"] * np.cos(angle) - p["point_across"] * np.sin(angle)
    z = a * np.sin(crank) + p["point_along"] * np.sin(angle) + p["point_across"] * np.cos(angle)
    np.testing.assert_allclose(motion["point.x"], x, rtol=0, atol=TIGHT)
    np.testing.assert_allclose(motion["point.z"], z, rtol=0, atol=TIGHT)
    # law of cosines over the diagonal from crank pin to rocker pivot
    diagonal = a * a + d * d - 2 * a * d * np.cos(crank)
    cosine = (b * b + c * c - diagonal) / (2 * b * c)
    np.testing.assert_allclose(np.cos(motion["transmission_angle"]), cosine, rtol=0, atol=TIGHT)


@pytest.mark.parametrize("offset", [0.0, 0.02])
def test_slider_crank_in_closed_form(offset: float) -> None:
    """Place and speed of the piston, and the balance of power with torque and gas force."""
    scene = cd.parts.slider_crank(offset=offset)
    model, motion = run(scene, 1.0, inputs={"torque": 0.7, "force": -20.0})
    p = values(model)
    r, l, angle = p["crank_length"], p["rod_length"], motion["crank"]
    height = r * np.sin(angle) - offset
    x = r * np.cos(angle) + np.sqrt(l**2 - height**2)
    np.testing.assert_allclose(motion["piston.x"], x, rtol=0, atol=TIGHT)
    ratio = -r * np.sin(angle) - height * r * np.cos(angle) / np.sqrt(l**2 - height**2)
    speed = ratio * motion["crank.u"]
    np.testing.assert_allclose(motion["piston.u"], speed, rtol=0, atol=1e-7)
    np.testing.assert_allclose(np.sin(motion["rod_angle"]), -height / l, rtol=0, atol=TIGHT)
    work = 0.7 * (angle - angle[0]) - 20.0 * (x - x[0])
    np.testing.assert_allclose(np.ptp(motion.energy.total - work), 0, atol=1e-6)


def test_cam_follows_the_lift_curve() -> None:
    """Cycloidal lift, velocity and acceleration, and the force between cam and follower."""
    model, motion = run(cd.parts.cam_and_follower(), 1.0)
    p = values(model)
    h, turn = p["lift"], np.mod(motion["cam"], 2 * np.pi)
    rate = motion["cam.u"]
    acceleration = model.forward_dynamics(motion.q, motion.u)
    cam = model.speeds.index("cam.u")
    s, v, a = np.zeros((3, len(turn)))
    for start, width, sign in ((0.0, p["rise"], 1), (p["rise"] + p["dwell"], p["fall"], -1)):
        there = (turn >= start) & (turn < start + width)
        y = 2 * np.pi * (turn[there] - start) / width
        lift = h * (y - np.sin(y)) / (2 * np.pi)
        s[there] = lift if sign > 0 else h - lift
        slope = sign * h / width * (1 - np.cos(y))
        v[there] = slope * rate[there]
        curve = sign * h / width**2 * 2 * np.pi * np.sin(y)
        a[there] = curve * rate[there] ** 2 + slope * acceleration[there, cam]
    s[(turn >= p["rise"]) & (turn < p["rise"] + p["dwell"])] = h
    assert len(np.unique(np.round(s, 6))) > 20
    np.testing.assert_allclose(motion["lift"], s, rtol=0, atol=TIGHT)
    np.testing.assert_allclose(motion["lift_rate"], v, rtol=0, atol=1e-7)
    follower = model.speeds.index("follower.u")
    np.testing.assert_allclose(acceleration[:, follower], a, rtol=0, atol=1e-6)
    pressed = p["preload"] + p["stiffness"] * s + p["damping"] * v
    force = p["follower_mass"] * (a + 9.81) + pressed
    np.testing.assert_allclose(model.multipliers(motion.q, motion.u)[:, 0], force, atol=1e-5)
    # the spring presses them together over the whole turn
    assert force.min() > 0


def test_differential_divides_speed_and_torque() -> None:
    scene = cd.parts.differential()
    push = {"pinion_torque": 12.0, "left_torque": -30.0, "right_torque": -9.0}
    model, motion = run(scene, inputs=push)
    p = values(model)
    mean = (motion["left_speed"] + motion["right_speed"]) / 2
    np.testing.assert_allclose(motion["carrier_speed"], mean, rtol=1e-12)
    pinion = p["final_drive"] * motion["carrier_speed"]
    np.testing.assert_allclose(motion["pinion_speed"], pinion, rtol=1e-12)
    assert np.ptp(motion["left_speed"] - motion["right_speed"]) > 1
    # equal torques on both shafts, half of that of the carrier each, hold still
    hold = {"pinion_torque": 12.0, "left_torque": -21.0, "right_torque": -21.0}
    r = [hold[name] for name in model.inputs]
    q, u = motion.q[0], motion.u[0]
    np.testing.assert_allclose(model.forward_dynamics(q, u, r=r), 0, atol=1e-10)
    # two degrees of freedom by hand
    side = p["side_mass"] * p["side_radius"] ** 2 / 2
    ratio = p["spider_teeth"] / p["side_teeth"]
    radius = p["side_radius"] * ratio
    spin = p["spider_mass"] * radius**2 / 2
    across = p["spider_mass"] * (3 * radius**2 + 0.02**2) / 12
    crown = p["carrier_mass"] * p["crown_radius"] ** 2 / 2
    drive = p["pinion_mass"] * (p["crown_radius"] / 3) ** 2 / 2
    orbit = 2 * (across + p["spider_mass"] * p["side_radius"] ** 2)
    of_carrier = crown + orbit + 2 * side + p["final_drive"] ** 2 * drive
    of_spider = 2 * spin + 2 * ratio**2 * side
    expected = {
        "carrier.u": (p["final_drive"] * 12.0 - 30.0 - 9.0) / of_carrier,
        "spider.u": ratio * (-9.0 + 30.0) / of_spider,
    }
    r = [push[name] for name in model.inputs]
    found = dict(zip(model.speeds, model.forward_dynamics(q, u, r=r), strict=True))
    assert found == pytest.approx(expected, rel=1e-10)


@pytest.mark.parametrize("fixed", ["ring", "sun", "carrier", "none"])
def test_planetary_gear_obeys_willis(fixed: str) -> None:
    """Speeds by Willis' equation, and torques that hold each other at rest."""
    scene = cd.parts.planetary_gear(fixed=fixed, planets=4)
    push = {"sun_torque": 1.0, "ring_torque": 0.4, "carrier_torque": 0.3}
    model, motion = run(scene, inputs=push)
    p = values(model)
    sun_teeth, ring_teeth = p["sun_teeth"], p["sun_teeth"] + 2 * p["planet_teeth"]
    speed = {name: motion[f"{name}_speed"] for name in ("sun", "ring", "carrier")}
    willis = (speed["sun"] - speed["carrier"]) * sun_teeth
    willis += (speed["ring"] - speed["carrier"]) * ring_teeth
    assert np.abs(willis).max() < 1e-9 * ring_teeth * 100
    if fixed != "none":
        assert np.abs(speed[fixed]).max() < 1e-12
    assert np.ptp(speed["sun" if fixed != "sun" else "ring"]) > 1
    # torques in the ratio of the teeth, and against the carrier, are in balance
    balance = {"sun_torque": sun_teeth, "ring_torque": ring_teeth}
    balance["carrier_torque"] = -(sun_teeth + ring_teeth)
    r = [0.1 * balance[name] for name in model.inputs]
    still = model.forward_dynamics(np.zeros(model.nq), np.zeros(model.nu), r=r)
    np.testing.assert_allclose(still, 0, atol=1e-10)
    # momentum and energy: what the torques do is what the gear has
    power = sum(push[f"{name}_torque"] * speed[name] for name in speed)
    angles = np.concatenate([[0], np.cumsum((power[1:] + power[:-1]) / 2 * np.diff(motion.t))])
    gained = motion.energy.kinetic - motion.energy.kinetic[0]
    np.testing.assert_allclose(gained, angles, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("side", ["left", "right"])
def test_double_wishbone_by_another_solver(side: str) -> None:
    """Camber, toe and track over bump and steering, from the lengths of the parts alone."""
    scene = cd.parts.double_wishbone(side=side)
    model = cd.compile(scene)
    sign = 1.0 if side == "left" else -1.0
    p = values(model)

    def point(name: str) -> Array:
        x, y, z = (p[f"{name}.{axis}"] for axis in "xyz")
        return np.array([x, sign * y, z])

    hub, low, high = (point(name) for name in ("wheel_center", "lower_ball", "upper_ball"))

    def moved(joint: float, name: str) -> Array:
        """A ball joint of an arm that turned about its hinge."""
        axis = sign * (point(f"{name}_front") - point(f"{name}_rear"))
        turn = Rotation.from_rotvec(joint * axis / np.linalg.norm(axis))
        start = point(f"{name}_front")
        return start + turn.apply(point(f"{name}_ball") - start)

    def open_loop(z: Array, lower: float, rack: float) -> Array:
        """Upper angle and rotation of the upright: distances that parts keep."""
        turn = Rotation.from_rotvec(z[1:])
        ball = moved(lower, "lower")
        top = ball + turn.apply(high - low) - moved(z[0], "upper")
        rod = ball + turn.apply(point("tie_outer") - low) - point("tie_inner") - [0, rack, 0]
        length = np.linalg.norm(point("tie_outer") - point("tie_inner"))
        return np.array([*top, rod @ rod - length**2])

    seen = []
    for lower, rack in itertools.product((-0.12, 0.0, 0.15), (0.0, 0.02)):
        r = [rack if name == "rack" else 0.0 for name in model.inputs]
        q = model.assemble({"lower": lower}, r=r).q
        z = fsolve(open_loop, np.zeros(4), args=(lower, rack), xtol=1e-13)
        turn = Rotation.from_rotvec(z[1:])
        center = moved(lower, "lower") + turn.apply(hub - low)
        x, y, up = sign * turn.as_matrix()[:, 1]
        expected = {
            "bump": center[2] - hub[2],
            "half_track": sign * center[1],
            "camber": -np.arcsin(up),
            "toe": np.arctan2(x, sign * y),
        }
        found = model.outputs(q, np.zeros(model.nu), r=r)
        names = [row.name for row in model.manifest.outputs]
        for name, value in expected.items():
            assert found[names.index(name)] == pytest.approx(value, abs=1e-8), (name, lower, rack)
        if not rack:
            seen.append((expected["bump"], expected["camber"], expected["toe"]))
    # the curve of camber: the top leans in where the wheel goes up, and out where it goes down
    (below, out, _), (_, none, _), (above, into, _) = seen
    assert below < -0.02 < 0.02 < above
    assert into < none < out
    assert none == pytest.approx(0, abs=1e-12)


def test_both_sides_mirror_each_other() -> None:
    left, right = (run(cd.parts.double_wishbone(side=side))[1] for side in ("left", "right"))
    for name in ("bump", "half_track", "camber", "toe", "spring_length"):
        np.testing.assert_allclose(left[name], right[name], rtol=0, atol=1e-8)


def test_leg_in_closed_form() -> None:
    model, motion = run(cd.parts.quadruped_leg(hip_offset=-0.07, shank_length=0.25), 1.0)
    p = values(model)
    hip, knee, roll = motion["hip"], motion["knee"], motion["abduction"]
    a, b = p["thigh_length"], p["shank_length"]
    x = -a * np.sin(hip) - b * np.sin(hip + knee)
    down = -a * np.cos(hip) - b * np.cos(hip + knee)
    expected = {
        "foot.x": x,
        "foot.y": p["hip_offset"] * np.cos(roll) - down * np.sin(roll),
        "foot.z": p["hip_offset"] * np.sin(roll) + down * np.cos(roll),
    }
    for name, value in expected.items():
        np.testing.assert_allclose(motion[name], value, rtol=0, atol=TIGHT)
    # torques that hold the weight: gradients of the heights of the masses
    still = motion.q[0]
    held = model.inverse_dynamics(still, np.zeros(3), np.zeros(3))
    step = 1e-6
    slopes = []
    for k in range(3):
        sides = [
            model.energy(still + s * step * np.eye(3)[k], np.zeros(3)).potential for s in (1, -1)
        ]
        slopes.append((sides[0] - sides[1]) / (2 * step))
    np.testing.assert_allclose(held, slopes, rtol=1e-6, atol=1e-6)


def test_stewart_platform_by_inverse_kinematics() -> None:
    """Lengths of the legs for poses of the platform: |p + R b - a|."""
    scene = cd.parts.stewart_platform()
    model = cd.compile(scene)
    p, names = values(model), [row.name for row in model.manifest.outputs]
    base, top = [], []
    for k in range(6):
        side = 1 if k % 2 else -1
        low = 2 * np.pi / 3 * (k // 2) + side * p["base_half_angle"]
        high = 2 * np.pi / 3 * (k // 2) + side * (np.pi / 3 - p["platform_half_angle"])
        base.append(p["base_radius"] * np.array([np.cos(low), np.sin(low), 0]))
        top.append(p["platform_radius"] * np.array([np.cos(high), np.sin(high), 0]))
    start = model.simulate(1e-9)
    q = start.q[0]
    rng = np.random.default_rng(2)
    for _ in range(4):
        pose = np.eye(4)
        pose[:3, :3] = Rotation.from_rotvec(rng.uniform(-0.2, 0.2, 3)).as_matrix()
        pose[:3, 3] = np.array([0, 0, 0.78]) + rng.uniform(-0.06, 0.06, 3)
        found = model.assemble({"platform": pose}, start=q)
        outputs = model.outputs(found.q, np.zeros(model.nu))
        for k in range(6):
            leg = pose[:3, 3] + pose[:3, :3] @ top[k] - base[k]
            assert outputs[names.index(f"leg{k + 1}")] == pytest.approx(
                np.linalg.norm(leg), abs=1e-9
            )


def test_stewart_platform_follows_its_commands() -> None:
    """Legs that are commanded to be longer lift the platform, up to the weight on the drives."""
    scene = cd.parts.stewart_platform()
    model = cd.compile(scene)
    lengths = {f"length{k}": scene.inputs[f"length{k}"].value + 0.02 for k in range(1, 7)}
    motion = model.simulate(1.0, inputs=lengths)
    legs = np.array([motion[f"leg{k}"][-1] for k in range(1, 7)])
    short = np.array(list(lengths.values())) - legs
    p, nominal = values(model), scene.inputs["length1"].value
    # virtual work of a small rise: a leg gets longer by the sine of its angle, its middle point of
    # the tube rises by lever, that of the rod by what is left
    steep = motion["platform.z"][-1] / legs[0]
    lever = p["leg_length"] / 2 * (1 - steep**2) / legs[0]
    weight = p["platform_mass"] / 6 + p["tube_mass"] * lever + p["rod_mass"] * (1 - lever)
    np.testing.assert_allclose(p["stiffness"] * short * steep, 9.81 * weight, rtol=1e-6)
    assert np.ptp(legs) < 1e-6
    assert legs[0] == pytest.approx(nominal + 0.02, abs=5e-4)


def top_momenta(model: cd.CompiledModel, motion: cd.Trajectory) -> tuple[Array, Array]:
    """Of the spin about its own axis, and about the vertical."""
    p = values(model)
    m, r = p["rotor_mass"], p["rotor_radius"]
    axial = m * r**2 / 2
    across = m * (3 * r**2 + p["rotor_thickness"] ** 2) / 12 + m * p["arm"] ** 2
    tilt, turn = motion["inner"], motion["outer.u"]
    spin = axial * (motion["rotor.u"] + turn * np.cos(tilt))
    return spin, across * turn * np.sin(tilt) ** 2 + spin * np.cos(tilt)


def test_gyroscope_precesses_steadily() -> None:
    """The start is that of regular precession: the tilt stays, with the weight of gimbals too."""
    _, motion = run(cd.parts.gyroscope(), 2.0)
    assert np.ptp(motion["inner"]) < 1e-9
    assert np.ptp(motion["outer.u"]) < 1e-9 * motion["outer.u"][0]
    assert np.ptp(motion["outer"]) > 1
    # close to m g arm / (C spin), the textbook's first approximation
    p = values(_)
    fast = 9.81 * p["arm"] / (p["rotor_radius"] ** 2 / 2 * 200.0)
    assert motion["outer.u"][0] == pytest.approx(fast, rel=0.05)


def test_gyroscope_without_gimbals_is_the_top_of_lagrange() -> None:
    """Both momenta are kept while it nods; its turning points are roots of a cubic."""
    scene = cd.parts.gyroscope(inner_mass=0.0, outer_mass=0.0, spin=150.0)
    model, motion = run(scene, 1.0, u={"outer": 0.0, "rotor": 150.0})
    assert np.ptp(motion["inner"]) > 1e-3
    spin, vertical = top_momenta(model, motion)
    assert np.ptp(spin) < 1e-9 * spin[0]
    assert np.ptp(vertical) < 1e-8 * abs(vertical[0])
    p = values(model)
    m, r = p["rotor_mass"], p["rotor_radius"]
    across = m * (3 * r**2 + p["rotor_thickness"] ** 2) / 12 + m * p["arm"] ** 2
    weight = m * 9.81 * p["arm"]
    # released from rest of the axis: the other turning point (Goldstein 5-7)
    start = np.cos(motion["inner"][0])
    a, b = spin[0] / across, 2 * weight / across
    roots = np.roots([1.0, -(a**2) / b, a**2 * start / b - 1 + 0.0])
    lower = min((x.real for x in roots if abs(x.imag) < 1e-12), key=lambda x: abs(x - start))
    dense = model.simulate(1.0, u={"outer": 0.0, "rotor": 150.0}, rtol=1e-10)
    fine = dense.resample(np.linspace(0, 0.2, 20001))
    assert np.cos(fine["inner"]).min() == pytest.approx(lower, abs=1e-7)


@pytest.mark.parametrize("wheels", [3, 4])
def test_reaction_wheels_keep_angular_momentum(wheels: int) -> None:
    """On a free body: what the wheels take the body gives."""
    space = cd.Scene("space", gravity=(0, 0, 0))
    bus = space.body("bus", mass=80.0, inertia=(9.0, 11.0, 7.0))
    space.joint("bus", cd.Free(), space.ground, bus)
    wheel_set = cd.parts.reaction_wheel_set(wheels=wheels)
    space.include(wheel_set, "wheels", at=bus.at(0, 0, 0.2, rotation=("XYZ", 0.3, -0.2, 0.1)))
    model = cd.compile(space)
    torques = {f"wheels.torque{k + 1}": 0.1 * (k + 1) * (-1) ** k for k in range(wheels)}
    start = {f"wheels.wheel{k + 1}": 100.0 for k in range(wheels)}
    motion = model.simulate(np.linspace(0, 20, 41), u=start, inputs=torques, rtol=1e-10)
    momentum = model.momentum(motion.q, motion.u)
    scale = np.abs(momentum[:, :3]).max()
    assert np.abs(momentum - momentum[0]).max() < 1e-9 * max(scale, 1.0)
    assert np.ptp(motion["bus.u"], axis=0)[:3].max() > 1e-3


def test_three_canted_wheels_have_orthogonal_axes_and_their_momentum() -> None:
    scene = cd.parts.reaction_wheel_set(wheels=3, cant=np.arctan(np.sqrt(0.5)))
    model = cd.compile(scene)
    axes = np.array([model.pose(f"wheel{k}", np.zeros(3))[:3, 2] for k in (1, 2, 3)])
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)
    speeds = np.array([120.0, -40.0, 75.0])
    stored = model.outputs(np.zeros(3), speeds)
    names = [row.name for row in model.manifest.outputs]
    p = values(model)
    axial = p["wheel_mass"] * p["wheel_radius"] ** 2 / 2
    found = [stored[names.index(f"momentum.{axis}")] for axis in "xyz"]
    np.testing.assert_allclose(found, axial * speeds @ axes, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(
        found, model.momentum(np.zeros(3), speeds)[:3], rtol=1e-12, atol=1e-12
    )


def test_every_part_has_a_closed_form_here() -> None:
    text = Path(__file__).read_text("utf-8")
    assert all(f"cd.parts.{name}(" in text for name in PARTS)
