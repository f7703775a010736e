"""Motions that repeat against published gaits, closed forms and computations in 22 digits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ModelError, SolveError, SolveWarning

POINT = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}
STATES, MULTIPLIERS = 1e-11, 1e-8


def oscillator(force: Any) -> cd.CompiledModel:
    """x'' = force(x, x'), with parameters by name."""
    scene = cd.Scene("oscillator", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    scene.force("force", cd.JointForce("x", force(scene, scene.q("x"), scene.u("x"))))
    return cd.compile(scene)


def walker() -> cd.CompiledModel:
    """M. Garcia, A. Chatterjee, A. Ruina, M. Coleman (1998): the stance and the swing leg."""
    scene = cd.Scene("walker", gravity=(0, 0, 0))
    slope = scene.parameter("slope", 0.009)
    for name in ("stance", "swing"):
        body = scene.body(f"body_{name}", **POINT)
        scene.joint(name, cd.Prismatic("x"), scene.ground, body)
    stance, swing, rate = scene.q("stance"), scene.q("swing"), scene.u("stance")
    scene.force("first", cd.JointForce("stance", sp.sin(stance - slope)))
    pull = rate**2 * sp.sin(swing) - sp.cos(stance - slope) * sp.sin(swing)
    scene.force("second", cd.JointForce("swing", sp.sin(stance - slope) + pull))
    scene.force("strike", cd.Event(swing - 2 * stance, direction="both"))
    return cd.compile(scene)


def heel_strike(before: Mapping[str, float]) -> dict[str, float]:
    """Angular momentum about the new contact is kept, and the legs change their names."""
    angle, rate = before["stance"], np.cos(2 * before["stance"]) * before["stance.u"]
    swing_rate = (1 - np.cos(2 * angle)) * rate
    return {"stance": -angle, "stance.u": rate, "swing": -2 * angle, "swing.u": swing_rate}


def step(model: cd.CompiledModel, angle: float, rate: float, **options: Any) -> Any:
    """The gait next to an angle and a rate behind a heel strike."""
    start = heel_strike({"stance": -angle, "stance.u": rate / np.cos(2 * angle)})
    return model.cycle(start, section="strike.up", symmetry=heel_strike, check=True, **options)


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


def duffing() -> tuple[cd.CompiledModel, Any]:
    """G. Duffing (1918)."""
    scene = cd.Scene("duffing", gravity=(0, 0, 0))
    omega = scene.parameter("omega", 1.4)
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    x, v = scene.q("x"), scene.u("x")
    scene.force("force", cd.JointForce("x", 0.5 * sp.cos(omega * cd.t) - 0.1 * v - x - x**3))
    return cd.compile(scene), omega


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


def table(amplitude: float) -> cd.CompiledModel:
    """A ball that bounces on a table with A sin(w t), w of 15 Hz, restitution 1/2."""
    scene = cd.Scene("ball_on_table", gravity=(0, 0, -9.81))
    A, plate, ball = (
        scene.parameter("A", amplitude),
        scene.body("plate"),
        scene.body("ball", **POINT),
    )
    motion = A * sp.sin(2 * sp.pi * 15 * cd.t)
    scene.joint("table", cd.Prismatic("z"), scene.ground, plate, prescribed=motion)
    scene.joint("gap", cd.Prismatic("z"), plate, ball)
    scene.force("bounce", cd.Stop("gap", lower=0.0, restitution=0.5))
    return cd.compile(scene)


OMEGA, APEX = 2 * np.pi * 15, 9.81 / 30
NEUTRAL_A = np.pi * 9.81 / OMEGA**2 / 3  # (1 - e) / (1 + e) = 1/3


def bounce(model: cd.CompiledModel, amplitude: float, **options: Any) -> Any:
    """The motion of one bounce per period, from the top of a flight."""
    phase = np.arccos(NEUTRAL_A / amplitude)
    start = {
        "gap": APEX**2 / 2 / 9.81 + amplitude * np.sin(phase),
        "gap.u": amplitude * OMEGA * np.cos(phase),
    }
    t = phase / OMEGA - 1 / 30
    return model.cycle(start, period=1 / 15, t=t, check=True, **options)


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


# paths


def kinds(path: Any) -> list[str]:
    return [point.kind for point in path.points]


@pytest.fixture(scope="module")
def long_gaits(garcia: cd.CompiledModel) -> Any:
    gait = step(garcia, 0.2003, -0.1998)
    return garcia.continuation(slope=(0.009, 0.018), of="cycles", start=gait)


def test_walker_doubles_its_period(long_gaits: Any) -> None:
    """The multiplier is -1 to 2e-12 in 22 digits at the slope 0.015088437941119985."""
    assert kinds(long_gaits) == ["period doubling", "event"]
    point = long_gaits.point("period doubling 1")
    assert point.values["slope"] == pytest.approx(0.015088437941119985, abs=1e-10)
    assert point["stance"] == pytest.approx(0.2371658635915819, abs=1e-9)
    expected = [-1, -0.29762136168495523]
    assert point.solution.multipliers[:2] == pytest.approx(expected, abs=MULTIPLIERS)
    stable = np.array(long_gaits.main.stable)
    assert (stable == (long_gaits["slope"] < point.values["slope"])).all()
    # a cycle of the path is one by itself
    row = long_gaits[2]
    other = step(row.model, row["stance"], row["stance.u"])
    np.testing.assert_allclose(other.x, row.x, atol=STATES)
    assert other.period == pytest.approx(row.period, abs=1e-10)
    assert "period doubling 1: slope = 0.015088" in repr(long_gaits)


def test_steps_of_two_kinds_begin_where_the_period_doubles(
    garcia: cd.CompiledModel, long_gaits: Any
) -> None:
    """Garcia et al. (1998): stable up to the next doubling, near 0.0177."""
    point = long_gaits.point("period doubling 1")
    path = garcia.continuation(slope=(0.009, 0.0185), of="cycles", start=point)
    assert path["slope"][0] > point.values["slope"]
    (doubling, _) = path.points
    assert doubling.kind == "period doubling"
    assert 0.0175 < doubling.values["slope"] < 0.0178
    before = path["slope"] < doubling.values["slope"]
    assert (np.array(path.main.stable) == before).all()
    # one lap leads to the other step, two laps back
    row = path[3]
    once = row.model.cycle(row.state, section="strike.up", symmetry=heel_strike, laps=2, check=True)
    np.testing.assert_allclose(once.x, row.x, atol=1e-10)
    assert abs(once.problem.lap(once.at).x - once.x).max() < 1e-11
    assert row.multipliers[0] == pytest.approx(once.multipliers[0], abs=1e-6)


def test_bounces_double_their_period() -> None:
    """(A w)^2 = v^2 + (2 g (1 + e^2) / (1 + e)^2 w)^2; the motion exists from A w = v."""
    amplitude = 0.0013
    cycle = bounce(table(amplitude), amplitude)
    path = cycle.model.continuation(A=(amplitude, 0.002), of="cycles", start=cycle)
    second = 2 * 9.81 * 1.25 / 1.5**2 / OMEGA**2
    point = path.point("period doubling 1")
    assert point.values["A"] == pytest.approx(np.hypot(NEUTRAL_A, second), abs=1e-12)
    assert point.values["A"] == pytest.approx(0.0016862254715924452, abs=1e-12)
    back = cycle.model.continuation(
        A=(amplitude, 0.001), of="cycles", start=cycle, bounds={"A": (0.001, 0.0014)}
    )
    fold = back.point("fold 1")
    assert fold.values["A"] == pytest.approx(0.0011565259198011062, abs=1e-12)
    assert kinds(back) == ["fold", "event"]
    assert not back.main.stable[-1]


def coupled(force: Any) -> cd.CompiledModel:
    """A forced oscillator x, and y beside it."""
    scene = cd.Scene("coupled", gravity=(0, 0, 0))
    mu = scene.parameter("mu", -0.2)
    for name in "xy":
        body = scene.body(f"body_{name}", **POINT)
        scene.joint(name, cd.Prismatic("x"), scene.ground, body)
    x, y, u, v = scene.q("x"), scene.q("y"), scene.u("x"), scene.u("y")
    forced = sp.cos(cd.t) - 0.4 * u - 2 * x - x**3
    scene.force("first", cd.JointForce("x", forced))
    scene.force("second", cd.JointForce("y", force(mu, y, v)))
    return cd.compile(scene)


def test_torus_point() -> None:
    """y'' = (mu - y^2) y' - 2 y: multipliers exp((mu/2 +- i w) T), |.| = 1 at mu = 0."""
    model = coupled(lambda mu, y, v: (mu - y**2) * v - 2 * y)
    cycle = model.cycle({"x": 0.5}, period=2 * np.pi, check=True)
    path = model.continuation(mu=(-0.2, 0.3), of="cycles", start=cycle)
    assert kinds(path) == ["torus point", "event"]
    (point, _) = path.points
    assert point.values["mu"] == pytest.approx(0.0, abs=1e-10)
    turn = np.angle(np.exp(2j * np.pi * np.sqrt(2)))
    assert point.frequency == pytest.approx(abs(turn), abs=1e-9)
    assert "torus begins: disturbances turn by 2.60258 rad" in str(point)


def test_branches_of_cycles() -> None:
    """y'' = mu y - y^3 - y'/2: y = +- sqrt(mu) from mu = 0."""
    model = coupled(lambda mu, y, v: mu * y - y**3 - 0.5 * v)
    cycle = model.cycle({"x": 0.5}, period=2 * np.pi, check=True)
    path = model.continuation(mu=(-0.2, 0.3), of="cycles", start=cycle, branches=1)
    point = path.point("branch point 1")
    assert point.values["mu"] == pytest.approx(0.0, abs=1e-10)
    assert point.symmetric == (("1a", "1b"),)
    for name in ("1a", "1b"):
        branch = path.branches[name]
        np.testing.assert_allclose(branch["y"] ** 2, branch["mu"], atol=1e-10)
        assert all(branch.stable)


def test_limit_cycles_begin_at_a_hopf_point() -> None:
    """x'' = (mu - x^2) x' - x: an amplitude 2 sqrt(mu) and period 2 pi (1 + mu^2 / 16) to first
    order; at mu = 1 van der Pol's equation.
    """
    model = oscillator(lambda scene, x, v: (scene.parameter("mu", -0.5) - x**2) * v - x)
    rest = model.continuation(mu=(-0.5, 0.5))
    point = rest.point("Hopf point 1")
    assert point.values["mu"] == pytest.approx(0.0, abs=1e-10)
    path = model.continuation(mu=(-0.5, 1.0), of="cycles", start=point)
    small = path["mu"] < 0.1
    mu = path["mu"][small]
    np.testing.assert_allclose(abs(path["x"])[small], 2 * np.sqrt(mu), rtol=1e-3)
    np.testing.assert_allclose(path["period"][small], 2 * np.pi * (1 + mu**2 / 16), rtol=1e-5)
    assert path["period"][-1] == pytest.approx(6.663286859323133, abs=1e-9)
    assert abs(path["x"][-1]) == pytest.approx(2.008619860874844, abs=1e-9)
    assert path["multiplier"][-1] == pytest.approx(0.000859695063603616, abs=1e-8)
    assert all(path.main.stable)
    # from a cycle the path is the same one
    end = path[-1]
    back = model.continuation(mu=(1.0, 0.2), of="cycles", start=end)
    assert back["x.max"][0] == pytest.approx(2.008619860874844, abs=1e-6)
    assert back["x.max"][-1] == pytest.approx(2 * np.sqrt(0.2), rel=1e-2)


def harmonic_balance(omega: float, x: Any) -> Any:
    """A cycle of the forced oscillator by Fourier collocation at 61 points."""
    from scipy.optimize import fsolve

    n = 61
    angles = 2 * np.pi * np.arange(n) / n
    odd = angles[:, None] - angles[None, :] + np.eye(n)
    alternating = (-1.0) ** np.subtract.outer(np.arange(n), np.arange(n))
    D = omega * alternating / (2 * np.sin(odd / 2)) * (1 - np.eye(n))
    force = 0.5 * np.cos(angles)
    return fsolve(lambda x: D @ D @ x + 0.1 * D @ x + x + x**3 - force, x, xtol=1e-13)


def test_forced_response() -> None:
    """Duffing's resonance turns back twice; every cycle balances its harmonics."""
    model, omega = duffing()
    period = 2 * sp.pi / omega
    cycle = model.cycle({"x": 0.6}, period=period, parameters={"omega": 0.7}, settle=20, check=True)
    path = model.continuation(omega=(0.7, 3.0), of="cycles", start=cycle)
    assert kinds(path) == ["fold", "fold", "event"]
    folds = [point.values["omega"] for point in path.points[:2]]
    rates, rows = np.array(path["omega"]), np.arange(len(path))
    first, second = (point.special.after for point in path.points[:2])
    unstable = (rows > first) & (rows <= second)
    assert (np.array(path.main.stable) == ~unstable).all()
    assert folds[1] < 1.5 < folds[0]
    for point in path.points[:2]:
        assert abs(point.solution.multipliers - 1).min() < 1e-6
    for k in range(0, len(path), 6):
        row = path[k]
        times = np.linspace(0, row.period, 61, endpoint=False)
        x = row.motion.at(times)[:, 0]
        balanced = harmonic_balance(rates[k], x)
        np.testing.assert_allclose(x, balanced, atol=1e-5)
        assert path["x.max"][k] == pytest.approx(x.max(), rel=1e-2)


def test_paths_say_what_they_need(garcia: cd.CompiledModel) -> None:
    with pytest.raises(ModelError, match=r"start= takes the cycle"):
        garcia.continuation(slope=(0.01, 0.02), of="cycles")
    with pytest.raises(ModelError, match=r"q= and locked= are of equilibria"):
        garcia.continuation(slope=(0.01, 0.02), of="cycles", q={"stance": 0.2})
    with pytest.raises(ModelError, match=r"Did you mean 'cycles'"):
        garcia.continuation(slope=(0.01, 0.02), of="cycle")
    gait = step(garcia, 0.2003, -0.1998)
    with pytest.raises(ModelError, match=r"there is no parameter or input 'slop'"):
        garcia.continuation(slop=(0.01, 0.02), of="cycles", start=gait)
    with pytest.raises(ModelError, match=r"there is no 'stances' to watch"):
        garcia.continuation(slope=(0.01, 0.02), of="cycles", start=gait, until={"stances": 1})
