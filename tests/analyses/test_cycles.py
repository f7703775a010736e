"""Motions that repeat against published gaits, closed forms and computations in 22 digits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ModelError, SolveError, SolveWarning
from cycle_scenes import (
    APEX,
    MULTIPLIERS,
    OMEGA,
    POINT,
    STATES,
    bounce,
    duffing,
    heel_strike,
    oscillator,
    step,
    table,
    walker,
)


@pytest.fixture(scope="module")
def garcia() -> cd.CompiledModel:
    return walker()


@pytest.mark.parametrize(
    ("slope", "state", "period", "multiplier"),
    [
        (
            0.009,
            (0.20031090054424724, -0.19983247300495247),
            3.8824637528513737,
            -0.19009984106588088 + 0.55759877668201j,
        ),
        (0.009, (0.1939373698101821, -0.20386692744200718), 3.0961058680781686, 4.00386435892967),
        (
            0.004,
            (0.1533895648762366, -0.1560801466756817),
            3.8526134617509786,
            0.22888996288846666 + 0.591155194683454j,
        ),
    ],
)
def test_simplest_walker(
    garcia: cd.CompiledModel,
    slope: float,
    state: tuple[float, float],
    period: float,
    multiplier: complex,
) -> None:
    """Garcia et al. (1998) print 0.200310900544287, -0.199832473004977; 22 digits of Taylor series.

    The foot passes the ground at mid-stride too, the other way.
    """
    angle, rate = state
    gait = step(garcia, 1.01 * angle, 1.02 * rate, parameters={"slope": slope})
    assert gait["stance"] == pytest.approx(angle, abs=STATES)
    assert gait["stance.u"] == pytest.approx(rate, abs=STATES)
    assert gait.period == pytest.approx(period, abs=1e-10)
    assert gait.multipliers[0] == pytest.approx(multiplier, abs=MULTIPLIERS)
    # an angle and its rate: the swing leg is at rest beside them
    assert len(gait.multipliers) == 3
    assert abs(gait.multipliers[2]) < 1e-7
    assert gait.stable == (abs(multiplier) < 1)
    assert gait.iterations <= 8


def test_mid_stride_is_left_out_by_a_condition(garcia: cd.CompiledModel) -> None:
    start = heel_strike({"stance": -0.2003, "stance.u": -0.1998 / np.cos(0.4006)})
    gait = garcia.cycle(start, section="strike", where={"stance": (-1, -0.1)}, symmetry=heel_strike)
    again = garcia.cycle(
        start, section="strike", where=lambda x: x["swing"] < -0.2, symmetry=heel_strike
    )
    counted = garcia.cycle(start, section="strike", crossing=2, symmetry=heel_strike)
    for one in (gait, again, counted):
        assert one["stance"] == pytest.approx(0.20031090054424724, abs=STATES)


def compass(slope: float) -> cd.CompiledModel:
    """A. Goswami, B. Thuilot, B. Espiau (1998): legs with a mass of 5 each, a hip of 10."""
    scene = cd.Scene("compass", gravity=(0, 0, -9.81))
    stance = scene.body("stance_leg", mass=5.0, com=(0, 0, 0.5), inertia=(0, 0, 0))
    hip = scene.body("hip_mass", mass=10.0, inertia=(0, 0, 0))
    swing = scene.body("swing_leg", mass=5.0, com=(0, 0, -0.5), inertia=(0, 0, 0))
    scene.joint("stance", cd.Revolute((0, -1, 0)), scene.ground, stance)
    scene.joint("top", cd.Fixed(), stance.at(0, 0, 1), hip)
    scene.joint("hip", cd.Revolute((0, -1, 0)), stance.at(0, 0, 1), swing)
    ground = 2 * scene.q("stance") + scene.q("hip") + 2 * slope
    scene.force("strike", cd.Event(ground, direction="both", terminal=True))
    return cd.compile(scene)


def compass_strike(before: Mapping[str, float]) -> dict[str, float]:
    """Goswami et al. (1998), equation (3): both angular momenta, about the contact and the hip."""
    m, hip, a, b, length = 5.0, 10.0, 0.5, 0.5, 1.0
    c = np.cos(before["hip"])
    rates = np.array([before["stance.u"] + before["hip.u"], before["stance.u"]])
    Q0 = [[-m * a * b, -m * a * b + (hip * length**2 + 2 * m * a * length) * c], [0, -m * a * b]]
    whole = m * length * (length - b * c) + m * a**2 + hip * length**2
    Q1 = [[m * b * (b - length * c), whole], [m * b**2, -m * b * length * c]]
    swing, stance = np.linalg.solve(Q1, Q0 @ rates)
    angle = before["stance"] + before["hip"]
    return {"stance": angle, "hip": -before["hip"], "stance.u": stance, "hip.u": swing - stance}


def test_compass_gait() -> None:
    """Slope of 3 degrees; 22 digits of Taylor series. The legs must be apart at the strike."""
    model = compass(np.radians(3))
    start = {"stance": 0.22, "hip": -0.54, "stance.u": -1.1, "hip.u": 0.7}
    gait = model.cycle(
        start, section="strike", where={"hip": (0.1, 2)}, symmetry=compass_strike, check=True
    )
    swing_rate = gait["stance.u"] + gait["hip.u"]
    state = [gait["stance"], swing_rate, gait["stance.u"]]
    expected = [0.21866880293899058, -0.37737394890719933, -1.0923835898836036]
    np.testing.assert_allclose(state, expected, atol=STATES)
    assert gait.period == pytest.approx(0.7343463911587157, abs=STATES)
    assert gait.multipliers[0] == pytest.approx(
        -0.19972612682999336 + 0.5444760620947514j, abs=MULTIPLIERS
    )
    assert gait.multipliers[2] == pytest.approx(0.13157262407718276, abs=MULTIPLIERS)
    assert gait.stable
    # a lap ends before the strike
    assert gait.motion.t[-1] == pytest.approx(gait.period)
    assert gait.motion["hip"][-1] == pytest.approx(-gait["hip"], abs=1e-9)


@pytest.mark.parametrize(
    ("mu", "period", "amplitude", "multiplier"),
    [
        (1.0, 6.663286859323133, 2.008619860874844, 0.000859695063603616),
        (0.5, 6.380675801773599, 2.002487930447113, 0.039176920259272885),
    ],
)
def test_limit_cycle(mu: float, period: float, amplitude: float, multiplier: float) -> None:
    """B. van der Pol (1926); 25 digits of Taylor series and the integral of the trace."""
    model = oscillator(lambda scene, x, v: scene.parameter("mu", mu) * (1 - x**2) * v - x)
    cycle = model.cycle({"x": 2.0}, check=True)
    assert cycle.period == pytest.approx(period, abs=1e-12)
    assert cycle["x"] == pytest.approx(amplitude, abs=1e-12)
    # that along the motion is left out
    assert cycle.multipliers == pytest.approx([multiplier], abs=1e-9)
    assert cycle.stable
    # far from it laps lead there
    far = model.cycle({"x": 0.5}, settle=4, check=True)
    assert far.period == pytest.approx(period, abs=1e-11)


def test_forced_motion() -> None:
    """Harmonic balance with 81 points; the product of multipliers is exp(-delta T)."""
    model, omega = duffing()
    for period in (2 * np.pi / 1.4, 2 * sp.pi / omega, lambda p: 2 * np.pi / p["omega"]):
        cycle = model.cycle({"x": 1.2, "x.u": 0.8}, period=period, check=True)
        np.testing.assert_allclose(cycle.x, [1.2300225936705684, 0.8277945356190878], atol=1e-12)
        pair = 0.14952248542462676 + 0.7848805393297366j
        assert cycle.multipliers == pytest.approx([pair, pair.conjugate()], abs=1e-9)
        product = np.prod(cycle.multipliers)
        assert product == pytest.approx(np.exp(-0.1 * 2 * np.pi / 1.4), abs=1e-10)
    # what moves back after half a period, mirrored
    half = model.cycle(
        {"x": 1.2, "x.u": 0.8}, period=np.pi / 1.4, symmetry={"x": ("x", -1)}, check=True
    )
    np.testing.assert_allclose(half.x, cycle.x, atol=1e-12)
    np.testing.assert_allclose(abs(half.multipliers) ** 2, abs(cycle.multipliers), atol=1e-9)


@pytest.mark.parametrize(
    ("a", "trace"),
    [(0.3, -1.3057659566890862), (2.5, 0.34657857116230845), (0.4706543549338391, -2)],
)
def test_multipliers_of_rest(a: float, trace: float) -> None:
    """E. Mathieu (1868), x'' + (a - cos 2t) x = 0: the trace over pi, by characteristic values."""
    model = oscillator(lambda scene, x, v: -(a - sp.cos(2 * cd.t)) * x)
    rest = model.cycle({"x": 0.0}, period=np.pi, check=True)
    assert rest.multipliers.sum() == pytest.approx(trace, abs=1e-9)
    assert rest.stable == (abs(trace) < 2) or abs(trace) == 2


def test_ball_on_a_table() -> None:
    """Impacts at phase acos(v/A), v = pi g (1 - e) / w^2 (1 + e); multipliers of the exact map."""
    amplitude = 0.001272178511781217
    cycle = bounce(table(amplitude), amplitude)
    (impact,) = (event for event in cycle.motion.events if event.kind == "impact")
    assert impact.t * OMEGA == pytest.approx(0.4296996661514246, abs=1e-10)
    assert impact.x_after[1] + amplitude * OMEGA * np.cos(impact.t * OMEGA) == pytest.approx(APEX)
    pair = 0.0851280198327865 + 0.4926999292057478j
    assert cycle.multipliers == pytest.approx([pair, pair.conjugate()], abs=1e-9)
    assert np.prod(cycle.multipliers) == pytest.approx(0.25, abs=1e-9)


def impact_pair(amplitude: float, omega: float, play: float, e: float) -> cd.CompiledModel:
    """A mass in a slot that moves as A sin(w t)."""
    scene = cd.Scene("impact_pair", gravity=(0, 0, 0))
    slot, mass = scene.body("slot"), scene.body("mass", **POINT)
    motion = amplitude * sp.sin(omega * cd.t)
    scene.joint("slot", cd.Prismatic("x"), scene.ground, slot, prescribed=motion)
    scene.joint("play", cd.Prismatic("x"), slot, mass)
    scene.force("walls", cd.Stop("play", lower=-play, upper=play, restitution=e))
    return cd.compile(scene)


@pytest.mark.parametrize(
    ("values", "phase", "speed", "moduli"),
    [
        ((0.002, 50.0, 0.008, 0.6), 2.4085167644167482, 0.2972478653637431, (0.36, 0.36)),
        (
            (0.002, 50.0, 0.008, 0.6),
            4.190330923339157,
            0.19946604226712913,
            (7.951218525500034, 0.016299388497541756),
        ),
        ((0.003, 80.0, 0.008, 0.4), 2.615225064025346, 0.4841971002141097, (0.16, 0.16)),
        (
            (0.003, 80.0, 0.008, 0.4),
            4.200668681628255,
            0.2742196268398023,
            (9.596054788336389, 0.002667763033532111),
        ),
    ],
)
def test_play_with_two_impacts(
    values: tuple[float, float, float, float],
    phase: float,
    speed: float,
    moduli: tuple[float, float],
) -> None:
    """S. F. Masri, T. K. Caughey (1966): v = -A w cos p (1 + e) / (1 - e), v pi/w = 2A sin p + 2c.

    Multipliers are those of the map from impact to impact.
    """
    A, omega, play, _ = values
    model, later = impact_pair(*values), np.pi / 2
    # a quarter of a period behind the right wall
    start = {
        "play": play + A * np.sin(phase) - speed * later / omega - A * np.sin(phase + later),
        "play.u": -speed - A * omega * np.cos(phase + later),
    }
    start["play.u"] *= 1 + 1e-4
    t, mirror = (phase + later) / omega, {"play": ("play", -1)}
    cycle = model.cycle(start, period=2 * np.pi / omega, t=t, check=True)
    half = model.cycle(start, period=np.pi / omega, t=t, symmetry=mirror, check=True)
    walls = [event for event in cycle.motion.events if event.kind == "impact"]
    assert [event.name for event in walls] == ["walls.lower", "walls.upper"]
    assert walls[1].t * omega - 2 * np.pi == pytest.approx(phase, abs=1e-9)
    assert walls[0].t * omega - np.pi == pytest.approx(phase, abs=1e-9)
    np.testing.assert_allclose(abs(cycle.multipliers), moduli, rtol=1e-7)
    np.testing.assert_allclose(abs(half.multipliers) ** 2, moduli, rtol=1e-7)
    np.testing.assert_allclose(half.x, cycle.x, atol=1e-11)
    assert cycle.stable == (moduli[0] < 1)


def linkage(coordinates: str) -> cd.CompiledModel:
    """A four-bar linkage under a torque."""
    scene = cd.Scene("linkage", gravity=(0, 0, -9.81))
    bodies = {name: scene.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1)) for name in "abc"}
    a, b, c = bodies.values()
    scene.joint("crank", cd.Revolute("y"), scene.ground, a)
    scene.joint("elbow", cd.Revolute("y"), a.at(1, 0, 0), b)
    scene.joint("rocker", cd.Revolute("y"), scene.ground.at(2.5, 0, 0), c)
    scene.joint("pin", cd.Revolute("y"), b.at(2.2, 0, 0), c.at(0, 0, 2))
    scene.force("push", cd.JointForce("crank", 3 * sp.cos(2 * cd.t)))
    scene.force("spring", cd.JointSpring("crank", stiffness=60.0))
    scene.force("damper", cd.JointDamper("crank", damping=4.0))
    return cd.compile(scene, coordinates=coordinates)


def inertia_of_crank(model: cd.CompiledModel, x: Any) -> float:
    """Inertia of the linkage against its crank."""
    q, _ = model.split(x)
    G = model.constraint_jacobian(q)
    motion = np.linalg.svd(G)[2][-1]
    motion /= motion[model.speeds.index("crank.u")]
    return float(motion @ model.mass_matrix(q) @ motion)


@pytest.mark.parametrize(
    "coordinates", ["relative", pytest.param("absolute", marks=pytest.mark.slow)]
)
def test_closed_loops(coordinates: str) -> None:
    model = linkage(coordinates)
    cycle = model.cycle({"crank": 0.1}, period=np.pi, settle=6, check=True)
    # one degree of freedom: what constraints take away is left out
    assert len(cycle.multipliers) == 2
    assert cycle.stable
    after = model.simulate(
        (0, np.pi), x0=cycle.x, rtol=1e-12, atol=1e-14, method="DOP853", check=True
    ).x[-1]
    np.testing.assert_allclose(after, cycle.x, atol=1e-9)
    # with p = M(crank) crank' volumes shrink at the rate c / M
    states = cycle.motion.at(np.linspace(0, np.pi, 65)[:-1])
    decay = [4.0 / inertia_of_crank(model, x) for x in states]
    product = np.prod(cycle.multipliers)
    assert product == pytest.approx(np.exp(-np.pi * np.mean(decay)), rel=1e-7)


def belt(speed: float) -> cd.CompiledModel:
    """A mass on a belt, with a spring of 1: sliding friction 1, sticking 3/2."""
    scene = cd.Scene("belt", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("mass", **POINT))
    surface = scene.parameter("speed", speed)
    scene.force("friction", cd.Friction("x", coulomb=1.0, static=1.5, against=surface))
    scene.force("spring", cd.JointSpring("x", stiffness=1.0))
    return cd.compile(scene)


def test_stick_and_slip() -> None:
    """With A = 1/2 between both: 2 A / v of sticking, 2 (pi - atan(A / v)) of sliding.

    Where it sticks all disturbances end.
    """
    cycle = belt(0.5).cycle({"x": 1.0, "x.u": -0.65}, check=True)
    assert cycle.period == pytest.approx(2 + 1.5 * np.pi, abs=1e-11)
    assert cycle["x.u"] == pytest.approx(-np.sqrt(0.5), abs=1e-11)
    assert [event.name for event in cycle.motion.events] == ["friction.stop", "friction.slip"]
    assert cycle.motion.events[1].t - cycle.motion.events[0].t == pytest.approx(2.0, abs=1e-11)
    assert cycle.multipliers == pytest.approx([0.0], abs=1e-9)
    assert cycle.modes == [-1.0]
    path = cycle.model.continuation(speed=(0.5, 1.0), of="cycles", start=cycle)
    v = path["speed"]
    expected = 1 / v + 2 * np.pi - 2 * np.arctan(0.5 / v)
    np.testing.assert_allclose(path["period"], expected, atol=1e-10)


def swung(rotation: str) -> Any:
    """A body on a ball joint that a force swings around, tied to the ground."""
    scene = cd.Scene("swung", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, com=(0, 0, -1), inertia=(0.1, 0.1, 0.05))
    scene.joint("ball", cd.Spherical(rotation=rotation), scene.ground, body)
    push = (sp.cos(2 * cd.t), 0.5 * sp.sin(2 * cd.t), 0)
    scene.force("push", cd.Force(body.at(0, 0, -1), push))
    scene.force("drag", cd.JointDamper("ball", damping=0.5))
    tie = cd.SpringDamper(
        scene.ground.at(1, 0, -1), body.at(0.5, 0, -1), stiffness=3.0, rest_length=0.2
    )
    scene.force("tie", tie)
    return cd.compile(scene).cycle({}, period=np.pi, settle=10, check=True)


def test_rotations_are_moved_by_increments() -> None:
    quaternion, angles = swung("quaternion"), swung("xyz")
    np.testing.assert_allclose(quaternion.u, angles.u, atol=1e-11)
    assert len(quaternion.multipliers) == 6
    np.testing.assert_allclose(quaternion.multipliers, angles.multipliers, atol=1e-9)
    assert quaternion.stable


def test_messages() -> None:
    model = oscillator(lambda scene, x, v: (1 - x**2) * v - x)
    with pytest.raises(ModelError, match=r"there is no 'y'"):
        model.cycle({"y": 1.0})
    with pytest.raises(ModelError, match=r"there is no event 'strike'"):
        model.cycle({"x": 1.0}, section="strike")
    with pytest.raises(ModelError, match=r"leave one out"):
        model.cycle({"x": 1.0}, section="strike", period=1.0)
    with pytest.raises(ModelError, match=r"symmetry: there is no 'y'"):
        model.cycle({"x": 1.0}, symmetry={"x": "y"})
    with pytest.raises(SolveError, match=r"does not come back to 'section' within 20 s"):
        model.cycle({"x": 1.0}, section=("x", 5.0), longest=20.0)
    with pytest.raises(SolveError, match=r"at rest"):
        model.cycle({"x": 0.0})
    forced, _ = duffing()
    with pytest.raises(ModelError, match=r"give period="):
        forced.cycle({"x": 1.0})
    with pytest.raises(ModelError, match=r"period=1.234: what forces 'duffing'"):
        forced.cycle({"x": 1.0}, period=1.234)
    drifting = oscillator(lambda scene, x, v: 1 + sp.cos(cd.t))
    with pytest.warns(SolveWarning, match=r"laps miss their starts by"):
        lost = drifting.cycle({"x": 1.0}, period=2 * np.pi)
    assert not lost.converged
    by_section = model.cycle({"x": 2.0, "x.u": -0.1}, section=(("x.u", 0.0), "down"))
    assert by_section["x"] == pytest.approx(2.008619860874844, abs=1e-11)
    assert by_section.multipliers == pytest.approx([0.000859695063603616], abs=1e-8)
    assert "multipliers 0.00085969" in repr(by_section)
