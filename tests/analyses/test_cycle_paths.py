"""Paths of cycles against closed forms: folds, doublings, torus points, branches, beginnings."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from analyses.interpreted import without_compiler
from cardan.errors import ModelError, SolveWarning
from cycle_scenes import (
    MULTIPLIERS,
    NEUTRAL_A,
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
    path = garcia.continuation(slope=(0.005, 0.0185), of="cycles", start=point)
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
    assert row.multipliers[0] == pytest.approx(once.multipliers[0], abs=1e-8)


@pytest.mark.slow
def test_cascade(garcia: cd.CompiledModel) -> None:
    """M. J. Feigenbaum (1978): distances of doublings fall by a factor that tends to 4.669."""
    gait = step(garcia, 0.2003, -0.1998)
    options = {"of": "cycles", "start": gait, "branches": 2, "step": 0.1}
    path = garcia.continuation(slope=(0.009, 0.0183), **options)
    name = "period doubling 1"
    assert [*path.branches] == ["main", name, f"{name}.{name}"]
    slopes = [branch.points[0].values["slope"] for branch in path.branches.values()]
    assert slopes[0] == pytest.approx(0.015088437941119985, abs=1e-10)
    first, second = np.diff(slopes)
    assert first / second == pytest.approx(4.669, rel=0.15)


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
    assert path["multiplier"][-1] == pytest.approx(0.000859695063603616, abs=1e-10)
    assert all(path.main.stable)
    # from a cycle the path is the same one
    end = path[-1]
    back = model.continuation(mu=(1.0, 0.2), of="cycles", start=end)
    assert back["x.max"][0] == pytest.approx(2.008619860874844, abs=1e-6)
    assert back["x.max"][-1] == pytest.approx(2 * np.sqrt(0.2), rel=1e-2)


def test_small_limit_cycles_begin_too() -> None:
    """The same with an amplitude of 2e-4 sqrt(mu)."""
    model = oscillator(lambda scene, x, v: (scene.parameter("mu", -0.5) - 1e8 * x**2) * v - x)
    point = model.continuation(mu=(-0.5, 0.5)).point("Hopf point 1")
    path = model.continuation(mu=(-0.5, 1.0), of="cycles", start=point)
    assert path["period"][-1] == pytest.approx(6.663286859323133, abs=1e-9)
    assert abs(path["x"][-1]) == pytest.approx(2.008619860874844e-4, rel=1e-7)


def test_paths_that_begin_within_their_range_end_at_its_start() -> None:
    """They left it, and went on for as many points as they may have."""
    model = oscillator(lambda scene, x, v: (scene.parameter("mu", -0.5) - x**2) * v - x)
    point = model.continuation(mu=(-0.5, 0.5)).point("Hopf point 1")
    path = model.continuation(mu=(0.5, -0.5), of="cycles", start=point)
    assert path.success
    assert path.message.endswith("reached the start")
    assert path["mu"][-1] == pytest.approx(0.5, abs=1e-10)


def test_relaxation_oscillations() -> None:
    """Van der Pol at mu = 10: the return by another program, and the integral of the trace."""
    from scipy.integrate import solve_ivp

    model = oscillator(lambda scene, x, v: scene.parameter("mu", 1.0) * (1 - x**2) * v - x)
    cycle = model.cycle({"x": 2.0}, check=True)
    path = model.continuation(mu=(1.0, 10.0), of="cycles", start=cycle)
    assert kinds(path) == ["event"]
    assert (np.diff(path["period"]) > 0).all()

    def rates(t: float, y: Any) -> list[float]:
        return [y[1], 10 * (1 - y[0] ** 2) * y[1] - y[0], 10 * (1 - y[0] ** 2)]

    def top(t: float, y: Any) -> float:
        return float(y[1])

    top.direction = -1.0  # type: ignore[attr-defined]
    tolerances = {"method": "LSODA", "rtol": 1e-12, "atol": 1e-13}
    run = solve_ivp(rates, (0, 60), [2.01, 0.0, 0.0], events=top, **tolerances)
    before, after = run.t_events[0][-2:]
    assert path["period"][-1] == pytest.approx(after - before, abs=1e-8)
    trace = run.y_events[0][-1][2] - run.y_events[0][-2][2]
    assert np.exp(trace) < 1e-30
    assert path["multiplier"][-1] < 1e-10


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
    assert len(path.plot("omega", "x.max").axes) == 1
    for point in path.points[:2]:
        assert abs(point.solution.multipliers - 1).min() < 1e-6
    for k in range(0, len(path), 6):
        row = path[k]
        times = np.linspace(0, row.period, 61, endpoint=False)
        x = row.motion.at(times)[:, 0]
        balanced = harmonic_balance(rates[k], x)
        np.testing.assert_allclose(x, balanced, atol=1e-5)
        assert path["x.max"][k] == pytest.approx(x.max(), rel=1e-2)


def test_response_to_an_input() -> None:
    """x'' + d x' + k x = F cos(w t): an amplitude F / |k - w^2 + i d w|."""
    scene = cd.Scene("driven", gravity=(0, 0, 0))
    F, w = scene.input("F", 0.1), scene.parameter("w", 1.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    force = F * sp.cos(w * cd.t) - 0.2 * scene.u("x") - 4 * scene.q("x")
    scene.force("force", cd.JointForce("x", force))
    model = cd.compile(scene)
    cycle = model.cycle({"x": 0.1}, period=2 * sp.pi / w, inputs={"F": 1.0}, check=True)
    louder = model.continuation(F=(0.5, 2.0), of="cycles", start=cycle)
    np.testing.assert_allclose(louder["x.max"], louder["F"] / np.hypot(3, 0.2), rtol=1e-7)
    faster = model.continuation(
        w=(0.5, 1.5), of="cycles", start=cycle, inputs={"F": 2.0}, until={"period": 5.0}
    )
    w = faster["w"]
    np.testing.assert_allclose(faster["x.max"], 2 / np.hypot(4 - w**2, 0.2 * w), rtol=1e-7)
    assert w[-1] == pytest.approx(2 * np.pi / 5, abs=1e-10)


def test_a_period_by_an_input() -> None:
    """x'' + x' / 5 + 4 x = cos(w t), w an input."""
    scene = cd.Scene("swept", gravity=(0, 0, 0))
    w = scene.input("w", 0.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    force = sp.cos(w * cd.t) - 0.2 * scene.u("x") - 4 * scene.q("x")
    scene.force("force", cd.JointForce("x", force))
    model = cd.compile(scene)
    cycle = model.cycle({"x": 0.1}, period=2 * sp.pi / w, inputs={"w": 1.5}, check=True)
    path = model.continuation(w=(1.5, 2.5), of="cycles", start=cycle)
    expected = 1 / np.hypot(4 - path["w"] ** 2, 0.2 * path["w"])
    np.testing.assert_allclose(path["x.max"], expected, rtol=1e-7)


def test_without_a_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    model, omega = duffing()
    start, tolerances = {"x": 1.2, "x.u": 0.8}, {"rtol": 1e-9, "atol": 1e-11}
    period = 2 * sp.pi / omega
    compiled = model.cycle(start, period=period, check=True, **tolerances)
    slow = without_compiler(model, monkeypatch)
    cycle = slow.cycle(start, period=period, check=True, **tolerances)
    np.testing.assert_allclose(cycle.x, compiled.x, atol=1e-9)
    options = {"of": "cycles", "points": 2, "step": 0.05}
    with pytest.warns(SolveWarning, match=r"after 2 points"):
        path = slow.continuation(omega=(1.4, 1.5), start=cycle, **options)
    with pytest.warns(SolveWarning, match=r"after 2 points"):
        expected = model.continuation(omega=(1.4, 1.5), start=compiled, **options)
    np.testing.assert_allclose(path["x"], expected["x"], atol=1e-6)
    np.testing.assert_allclose(path["omega"], expected["omega"], atol=1e-6)


def test_paths_say_what_they_need(garcia: cd.CompiledModel) -> None:
    with pytest.raises(ModelError, match=r"start= takes the cycle"):
        garcia.continuation(slope=(0.01, 0.02), of="cycles")
    with pytest.raises(ModelError, match=r"q=, u= and locked= are of equilibria"):
        garcia.continuation(slope=(0.01, 0.02), of="cycles", q={"stance": 0.2})
    with pytest.raises(ModelError, match=r"Did you mean 'cycles'"):
        garcia.continuation(slope=(0.01, 0.02), of="cycle")
    gait = step(garcia, 0.2003, -0.1998)
    with pytest.raises(ModelError, match=r"start= is of another model than 'duffing'"):
        duffing()[0].continuation(omega=(1, 2), of="cycles", start=gait)
    with pytest.raises(ModelError, match=r"there is no parameter or input 'slop'"):
        garcia.continuation(slop=(0.01, 0.02), of="cycles", start=gait)
    with pytest.raises(ModelError, match=r"there is no 'stances' to watch"):
        garcia.continuation(slope=(0.01, 0.02), of="cycles", start=gait, until={"stances": 1})
