"""Motions that repeat against published gaits, closed forms and computations in 22 digits."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest
import sympy as sp

import cardan as cd
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
    assert abs(gait.multipliers[2]) < 1e-12
    assert gait.stable == (abs(multiplier) < 1)
    assert gait.iterations <= 6


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
    # from 3 percent off
    aside = {name: 1.03 * gait[name] for name in start}
    far = model.cycle(aside, section="strike", where={"hip": (0.1, 2)}, symmetry=compass_strike)
    assert far.iterations <= 6
    np.testing.assert_allclose(far.x, gait.x, atol=STATES)
    # a lap ends before the strike
    assert gait.motion.t[-1] == pytest.approx(gait.period)
    assert gait.motion["hip"][-1] == pytest.approx(-gait["hip"], abs=1e-9)


def test_rimless_wheel() -> None:
    """T. McGeer (1990): u^2 = 4 (g/l) sin a sin slope c^2 / (1 - c^2), c = cos 2a."""
    half, slope, pull = np.pi / 8, 0.1, 9.81
    scene = cd.Scene("wheel", gravity=(0, 0, -pull))
    spoke = scene.body("spoke", mass=1.0, com=(0, 0, 1), inertia=(0, 0, 0))
    scene.joint("angle", cd.Revolute("y"), scene.ground, spoke)
    scene.force("strike", cd.Event(scene.q("angle") - slope - half, direction="up"))
    c = np.cos(2 * half)
    next_spoke = {"angle": ("angle", 1, -2 * half), "angle.u": ("angle.u", c)}
    wheel = cd.compile(scene).cycle(
        {"angle": slope - half, "angle.u": 1.5}, section="strike", symmetry=next_spoke, check=True
    )
    speed = np.sqrt(4 * pull * np.sin(half) * np.sin(slope) * c**2 / (1 - c**2))
    assert wheel["angle.u"] == pytest.approx(speed, abs=STATES)
    assert wheel["angle"] == pytest.approx(slope - half, abs=STATES)
    assert wheel.multipliers == pytest.approx([c**2], abs=MULTIPLIERS)


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
    assert cycle.multipliers == pytest.approx([multiplier], abs=1e-12)
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
        assert cycle.multipliers == pytest.approx([pair, pair.conjugate()], abs=1e-11)
        product = np.prod(cycle.multipliers)
        assert product == pytest.approx(np.exp(-0.1 * 2 * np.pi / 1.4), abs=1e-12)
    # what moves back after half a period, mirrored
    half = model.cycle(
        {"x": 1.2, "x.u": 0.8}, period=np.pi / 1.4, symmetry={"x": ("x", -1)}, check=True
    )
    np.testing.assert_allclose(half.x, cycle.x, atol=1e-12)
    np.testing.assert_allclose(abs(half.multipliers) ** 2, abs(cycle.multipliers), atol=1e-11)


@pytest.mark.parametrize(
    ("a", "trace"),
    [(0.3, -1.3057659566890862), (2.5, 0.34657857116230845), (0.4706543549338391, -2)],
)
def test_multipliers_of_rest(a: float, trace: float) -> None:
    """E. Mathieu (1868), x'' + (a - cos 2t) x = 0: the trace over pi, by characteristic values."""
    model = oscillator(lambda scene, x, v: -(a - sp.cos(2 * cd.t)) * x)
    rest = model.cycle({"x": 0.0}, period=np.pi, check=True)
    assert rest.multipliers.sum() == pytest.approx(trace, abs=2e-10)
    assert rest.stable == (abs(trace) < 2) or abs(trace) == 2


def test_ball_on_a_table() -> None:
    """Impacts at phase acos(v/A), v = pi g (1 - e) / w^2 (1 + e); multipliers of the exact map."""
    amplitude = 0.001272178511781217
    cycle = bounce(table(amplitude), amplitude)
    (impact,) = (event for event in cycle.motion.events if event.kind == "impact")
    assert impact.t * OMEGA == pytest.approx(0.4296996661514246, abs=1e-10)
    assert impact.x_after[1] + amplitude * OMEGA * np.cos(impact.t * OMEGA) == pytest.approx(APEX)
    pair = 0.0851280198327865 + 0.4926999292057478j
    assert cycle.multipliers == pytest.approx([pair, pair.conjugate()], abs=1e-11)
    assert np.prod(cycle.multipliers) == pytest.approx(0.25, abs=1e-12)


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
    np.testing.assert_allclose(abs(cycle.multipliers), moduli, rtol=2e-8)
    np.testing.assert_allclose(abs(half.multipliers) ** 2, moduli, rtol=2e-8)
    np.testing.assert_allclose(half.x, cycle.x, atol=1e-11)
    assert cycle.stable == (moduli[0] < 1)
