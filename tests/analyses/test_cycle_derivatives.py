"""Derivatives of laps by sweeps over their steps, against differences of runs and closed forms."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from analyses.interpreted import without_compiler
from cardan.analyses.cycles.lap_derivative import lap_derivative
from cardan.analyses.cycles.shooting import Shooting
from cardan.arrays import Array
from cycle_scenes import POINT, bounce, duffing, oscillator, step, table, walker

DIFFERENCES = 1e-9  # that runs at 1e-13 leave in differences of laps, and what events add


def gait() -> Any:
    """A section at which legs change by a function; the slope is not in its event."""
    return step(walker(), 0.2003, -0.1998), "slope"


def free() -> Any:
    model = oscillator(lambda scene, x, v: scene.parameter("mu", 1.0) * (1 - x**2) * v - x)
    return model.cycle({"x": 2.0}, check=True), "mu"


def free_of_two_laps() -> Any:
    model = oscillator(lambda scene, x, v: scene.parameter("mu", 1.0) * (1 - x**2) * v - x)
    return model.cycle({"x": 2.0}, laps=2, check=True), "mu"


def watched() -> Any:
    """A section that is an entry of the state, and changes nothing."""
    model = oscillator(lambda scene, x, v: scene.parameter("mu", 1.0) * (1 - x**2) * v - x)
    section = (("x.u", 0.0), "down")
    return model.cycle({"x": 2.0, "x.u": -0.1}, section=section, check=True), "mu"


def mirrored() -> Any:
    """Half a period that the swept frequency decides."""
    model, omega = duffing()
    return (
        model.cycle(
            {"x": 1.2, "x.u": 0.8}, period=sp.pi / omega, symmetry={"x": ("x", -1)}, check=True
        ),
        "omega",
    )


def impacts() -> Any:
    amplitude = 0.001272178511781217
    return bounce(table(amplitude), amplitude), "A"


def stopped(section: str | None, coordinates: str = "relative") -> Any:
    """An impact in the lap, or at its end."""
    scene = cd.Scene("stopped", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    x, v, mu = scene.q("x"), scene.u("x"), scene.parameter("mu", 1.0)
    scene.force("force", cd.JointForce("x", mu * (1 - x**2) * v - x))
    scene.force("stop", cd.Stop("x", lower=-1.0, restitution=0.8))
    start = {"x": 1.5} if section is None else {"x": -1.0, "x.u": 1.5}
    model = cd.compile(scene, coordinates=coordinates)
    return model.cycle(start, section=section, check=True), "mu"


def sticking() -> Any:
    scene = cd.Scene("belt", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("mass", **POINT))
    speed = scene.parameter("speed", 0.5)
    scene.force("friction", cd.Friction("x", coulomb=1.0, static=1.5, against=speed))
    scene.force("spring", cd.JointSpring("x", stiffness=1.0))
    return cd.compile(scene).cycle({"x": 1.0, "x.u": -0.65}, check=True), "speed"


def swung(rotation: str) -> Any:
    """A body on a ball joint that a force swings around, tied to the ground."""
    scene = cd.Scene("swung", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, com=(0, 0, -1), inertia=(0.1, 0.1, 0.05))
    scene.joint("ball", cd.Spherical(rotation=rotation), scene.ground, body)
    size = scene.parameter("size", 1.0)
    push = (size * sp.cos(2 * cd.t), 0.5 * sp.sin(2 * cd.t), 0)
    scene.force("push", cd.Force(body.at(0, 0, -1), push))
    scene.force("drag", cd.JointDamper("ball", damping=0.5))
    tie = cd.SpringDamper(
        scene.ground.at(1, 0, -1), body.at(0.5, 0, -1), stiffness=3.0, rest_length=0.2
    )
    scene.force("tie", tie)
    return cd.compile(scene).cycle({}, period=np.pi, settle=10, check=True), "size"


def linkage(coordinates: str) -> Any:
    """A four-bar linkage, the length of whose coupler is swept: starts move along with it."""
    scene = cd.Scene("linkage", gravity=(0, 0, -9.81))
    bodies = {name: scene.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1)) for name in "abc"}
    a, b, c = bodies.values()
    length = scene.parameter("length", 2.2)
    scene.joint("crank", cd.Revolute("y"), scene.ground, a)
    scene.joint("elbow", cd.Revolute("y"), a.at(1, 0, 0), b)
    scene.joint("rocker", cd.Revolute("y"), scene.ground.at(2.5, 0, 0), c)
    scene.joint("pin", cd.Revolute("y"), b.at(length, 0, 0), c.at(0, 0, 2))
    scene.force("push", cd.JointForce("crank", 3 * sp.cos(2 * cd.t)))
    scene.force("spring", cd.JointSpring("crank", stiffness=60.0))
    scene.force("damper", cd.JointDamper("crank", damping=0.5))
    model = cd.compile(scene, coordinates=coordinates)
    return model.cycle({"crank": 0.1}, period=np.pi, settle=12, check=True), "length"


def rubber(section: Any = None, **options: Any) -> Any:
    """A beam of rubber on a hinge that is pushed at times, or by itself, and its modulus."""
    scene = cd.Scene("rubber", gravity=(0, 0, -9.81))
    material = cd.material(E=scene.parameter("E", 5e6), nu=0.45, rho=1100, damping=2e-3)
    hub = scene.body("hub", mass=0.5, inertia=(0.01, 0.01, 0.01))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    scene.beam("bar", hub, (0.4, 0, 0), cd.section.rectangle(0.03, 0.03), material, elements=1)
    v, x = scene.u("hinge"), scene.q("hinge")
    push = 0.5 * sp.sin(12 * cd.t) - 6 * x - 0.1 * v
    push = push if section is None else 20 * (0.02 - x**2) * v - 20 * x
    scene.force("push", cd.JointForce("hinge", push))
    model = cd.compile(scene)
    if section is None:
        return model.cycle({}, period=np.pi / 6, settle=3, check=True, **options), "E"
    start = {"hinge": 0.0, "hinge.u": 1.5}
    return model.cycle(start, section=section, settle=8, check=True), "E"


def pumped() -> Any:
    """A closed loop that keeps swinging, and begins where its crank passes a place.

    Starts of differences that are closed lie beside the section: so soon they are not back at it
    by ``longest``, of which that is a part.
    """
    scene = cd.Scene("pumped", gravity=(0, 0, 0))
    bodies = {name: scene.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1)) for name in "abc"}
    a, b, c = bodies.values()
    scene.joint("crank", cd.Revolute("y"), scene.ground, a)
    scene.joint("elbow", cd.Revolute("y"), a.at(1, 0, 0), b)
    scene.joint("rocker", cd.Revolute("y"), scene.ground.at(2.5, 0, 0), c)
    scene.joint("pin", cd.Revolute("y"), b.at(2.2, 0, 0), c.at(0, 0, 2))
    mu, v, x = scene.parameter("mu", 2.0), scene.u("crank"), scene.q("crank")
    scene.force("push", cd.JointForce("crank", mu * (0.05 - x**2) * v * 20 - 40 * x))
    model = cd.compile(scene)
    return (
        model.cycle(
            {"crank": 0.0, "crank.u": 1.5},
            section=(("crank", 0.0), "up"),
            settle=10,
            longest=1e4,
            check=True,
        ),
        "mu",
    )


CASES: dict[str, Callable[[], Any]] = {
    "gait": gait,
    "free": free,
    "two laps": free_of_two_laps,
    "watched": watched,
    "mirrored": mirrored,
    "impacts": impacts,
    "impact in a lap": lambda: stopped(None),
    "impact at its end": lambda: stopped("stop.lower"),
    "sticking": sticking,
    "quaternion": lambda: swung("quaternion"),
    "angles": lambda: swung("xyz"),
    "loop": lambda: linkage("relative"),
    "loop and section": pumped,
    "loop in absolute coordinates": lambda: linkage("absolute"),
    "rubber": rubber,
    "rubber and section": lambda: rubber((("hinge", 0.0), "up")),
}
SLOW = (
    *("two laps", "watched", "impacts", "impact in a lap", "angles"),
    *("loop in absolute coordinates", "rubber", "rubber and section"),
)
# a start on section and constraints is one where both are met; nodes of a loop move alone
HERE = ("loop and section", "rubber and section", "loop in absolute coordinates")


def rows(names: Any) -> list[Any]:
    return [pytest.param(n, marks=pytest.mark.slow) if n in SLOW else n for n in names]


@pytest.mark.parametrize("name", rows(CASES))
@pytest.mark.parametrize("aside", [0.0, 1e-2])
def test_derivatives_are_those_of_differences(name: str, aside: float) -> None:
    """At a cycle and beside it: by the start, a free period, a parameter."""
    cycle, parameter = CASES[name]()
    aside = 0.0 if name in HERE else aside
    assert cycle.derivatives == "exact"
    problem, n = cycle.problem, len(cycle.problem.units)
    value = cycle.model.parameters[parameter]
    shooting = Shooting.of(problem, cycle.at)
    size = n + problem.free_period
    moved = shooting.moved(cycle.at, aside * np.sin(2.0 * np.arange(size) + 1))
    at = problem.closed(replace(moved, x=problem.on_section(moved)))

    def values(ds: float) -> dict[str, float]:
        return {parameter: value * (1 + ds)}

    def residual(dz: Array) -> Array:
        there = shooting.moved(at, dz[:size])
        return shooting.residual(replace(there, values=values(float(dz[size]))))

    at = replace(at, values=values(0.0))
    exact = shooting.derivative(at, residual, size + 1, values=values)
    assert problem.reasons == []
    # closed loops lose digits in projections of steps that differences see, and so do nodes
    coarse = problem.constrained or problem.model.manifest.absolute
    bound = DIFFERENCES * (10 if coarse else 1) * (1 + np.abs(exact).max())
    columns = shooting._by_differences(at, residual, size + 1, rough=False)
    np.testing.assert_allclose(exact, columns, atol=bound)


def test_parts_at_rest_are_resolved() -> None:
    """y'' = -30^2 y - y'/5 at rest beside a limit cycle: exp((-1/10 +- i w) T), w^2 = 900 - 1/100.

    Steps of a motion are no measure for changes of what does not move in it.
    """
    scene = cd.Scene("beside", gravity=(0, 0, 0))
    for name in "xy":
        body = scene.body(f"body_{name}", **POINT)
        scene.joint(name, cd.Prismatic("x"), scene.ground, body)
    x, y, u, v = scene.q("x"), scene.q("y"), scene.u("x"), scene.u("y")
    scene.force("first", cd.JointForce("x", (1 - x**2) * u - x))
    scene.force("second", cd.JointForce("y", -900 * y - v / 5))
    cycle = cd.compile(scene).cycle({"x": 2.0}, check=True)
    assert cycle.derivatives == "exact"
    pair = np.exp((-0.1 + 1j * np.sqrt(900 - 0.01)) * cycle.period)
    expected = sorted([pair, pair.conjugate()], key=lambda value: -value.imag)
    assert cycle.multipliers[:2] == pytest.approx(expected, abs=1e-9)
    assert cycle.multipliers[2] == pytest.approx(0.000859695063603616, abs=1e-10)


@pytest.mark.parametrize("mode", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_multipliers_of_what_keeps_its_energy_multiply_to_1(mode: int) -> None:
    """H. Poincare (1892): nonlinear modes of a double pendulum, and the last as a free cycle."""
    scene = cd.Scene("swing", gravity=(0, 0, -9.81))
    bar: Any = {"mass": 1.0, "inertia": (0, 0, 0), "com": (0, 0, -1)}
    upper, lower = scene.body("upper", **bar), scene.body("lower", **bar)
    scene.joint("upper", cd.Revolute("y"), scene.ground, upper)
    scene.joint("lower", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    swing = cd.compile(scene)
    path: Any = swing.continuation(energy=(0, 10.0), of="cycles", start=swing.modes()[mode])
    last = path[-1]
    cycles = [path[k] for k in range(len(path))]
    cycles.append(swing.cycle(last.state, guess=last.period, check=True))
    for cycle in cycles:
        assert cycle.derivatives == "exact"
        assert abs(np.prod(cycle.multipliers) - 1) < 1e-9


@pytest.mark.filterwarnings("ignore:model 'pendulum'. its builds are not checked")
def test_speeds_that_the_user_chose() -> None:
    """The speeds of a cycle are those of the model; multipliers do not depend on them."""

    def pendulum(chosen: bool) -> Any:
        scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
        body = scene.body("body", mass=1.0, com=(0, 0, -1), inertia=(0, 0, 0))
        scene.joint("angle", cd.Revolute("y"), scene.ground, body)
        push = sp.cos(2 * cd.t) - scene.u("angle") / 5
        scene.force("push", cd.JointForce("angle", push))
        speeds = {"w": 3 * scene.u("angle")} if chosen else None
        model = cd.compile(scene, speeds=speeds) if chosen else cd.compile(scene)
        return model.cycle({"angle": 0.1}, period=np.pi, settle=30, check=True)

    plain, other = pendulum(False), pendulum(True)
    assert other.derivatives == plain.derivatives == "exact"
    np.testing.assert_allclose(other.multipliers, plain.multipliers, atol=1e-10)


def test_multipliers_that_are_far_below_rounding() -> None:
    """Van der Pol at mu = 3: exp of the integral of the trace."""
    from scipy.integrate import solve_ivp

    model = oscillator(lambda scene, x, v: scene.parameter("mu", 3.0) * (1 - x**2) * v - x)
    cycle = model.cycle({"x": 2.0}, check=True)

    def trace(t: float, y: Array) -> list[float]:
        return [y[1], 3 * (1 - y[0] ** 2) * y[1] - y[0], 3 * (1 - y[0] ** 2)]

    run = solve_ivp(
        trace, (0, cycle.period), [*cycle.x, 0.0], method="DOP853", rtol=1e-13, atol=1e-14
    )
    assert cycle.multipliers == pytest.approx([np.exp(run.y[2, -1])], abs=1e-12)


def test_stiff_beams_by_radau() -> None:
    """The derivative is that of the exact motion: multipliers do not depend on the method."""
    first, _ = rubber(rtol=1e-10, atol=1e-13)
    other, _ = rubber(method="Radau", rtol=1e-10, atol=1e-13)
    assert first.derivatives == other.derivatives == "exact"
    np.testing.assert_allclose(other.multipliers, first.multipliers, atol=1e-8)


# where there are none


def test_other_laps_take_differences_of_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    model, _ = duffing()
    options: dict[str, Any] = {"period": 2 * np.pi / 1.4, "check": True}
    start = {"x": 1.2, "x.u": 0.8}
    exact = model.cycle(start, **options)
    radau = model.cycle(start, method="Radau", rtol=1e-10, atol=1e-12, **options)
    assert radau.derivatives == "exact"
    np.testing.assert_allclose(radau.multipliers, exact.multipliers, atol=1e-8)
    implicit = model.cycle(start, method="Rosenbrock", rtol=1e-10, atol=1e-12, **options)
    assert implicit.derivatives.startswith("differences of runs: there is no sweep through steps")
    assert "derivatives of laps: differences" in repr(implicit)
    np.testing.assert_allclose(implicit.multipliers, exact.multipliers, atol=1e-6)
    explicit = model.cycle(start, method="RK45", rtol=1e-11, atol=1e-13, **options)
    assert explicit.derivatives == "exact"
    np.testing.assert_allclose(explicit.multipliers, exact.multipliers, atol=1e-8)
    slow = without_compiler(model, monkeypatch)
    cycle = slow.cycle(start, rtol=1e-9, atol=1e-11, **options)
    assert cycle.derivatives == "differences of runs: there is no C compiler"


@pytest.mark.parametrize("section", [None, "stop.lower"])
def test_impacts_of_nodes(section: str | None) -> None:
    joints, nodes = (stopped(section, coordinates)[0] for coordinates in ("relative", "absolute"))
    assert nodes.derivatives == joints.derivatives == "exact"
    np.testing.assert_allclose(nodes.multipliers, joints.multipliers, atol=1e-9)


def test_functions_as_inputs_take_differences_of_runs() -> None:
    scene = cd.Scene("driven", gravity=(0, 0, 0))
    force = scene.input("F", 0.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    pull = force - 0.2 * scene.u("x") - 4 * scene.q("x")
    scene.force("force", cd.JointForce("x", pull))
    model = cd.compile(scene)
    driven = model.cycle(
        {"x": 0.1}, period=2 * np.pi, inputs={"F": lambda t, x: np.cos(t)}, check=True
    )
    assert driven.derivatives.endswith("input 'F' is a function, whose derivative is not known")
    expected = np.exp((-0.1 + 1j * np.sqrt(4 - 0.01)) * 2 * np.pi)
    assert abs(driven.multipliers[0]) == pytest.approx(abs(expected), abs=1e-9)


def test_two_events_at_one_time_take_differences_of_runs() -> None:
    """Two balls that bounce at the same time: which comes first is not decided."""
    scene = cd.Scene("two", gravity=(0, 0, -9.81))
    plate = scene.body("plate")
    amplitude = 0.001272178511781217
    motion = amplitude * sp.sin(2 * sp.pi * 15 * cd.t)
    scene.joint("table", cd.Prismatic("z"), scene.ground, plate, prescribed=motion)
    for name in ("left", "right"):
        scene.joint(name, cd.Prismatic("z"), plate, scene.body(f"ball_{name}", **POINT))
        scene.force(f"bounce_{name}", cd.Stop(name, lower=0.0, restitution=0.5))
    model = cd.compile(scene)
    one = bounce(table(amplitude), amplitude)
    start = {name + end: one["gap" + end] for name in ("left", "right") for end in ("", ".u")}
    cycle = model.cycle(start, period=1 / 15, t=one.problem.t, check=True)
    assert "happen at the same time" in cycle.derivatives
    moduli = np.abs(np.repeat(one.multipliers, 2))
    np.testing.assert_allclose(np.abs(cycle.multipliers), moduli, atol=1e-8)


def test_a_lap_and_its_derivative_agree() -> None:
    """The lap that a derivative is of is that of the problem."""
    cycle = step(walker(), 0.2003, -0.1998)
    lap = lap_derivative(cycle.problem, cycle.at)
    np.testing.assert_allclose(lap.end.x, cycle.problem.lap(cycle.at).x, rtol=0, atol=1e-15)
    assert lap.end.period == pytest.approx(cycle.period, rel=1e-15)


# pictures


def test_pictures_of_a_cycle(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    model, _ = duffing()
    cycle: Any = model.cycle({"x": 1.2, "x.u": 0.8}, period=2 * np.pi / 1.4, check=True)
    histories = cycle.plot(tmp_path / "histories.png")
    assert [axis.get_xlabel() for axis in histories.axes][-1] == "t [s]"
    orbit = cycle.plot(tmp_path / "orbit.svg", "x.u", against="x")
    (line,) = orbit.axes[0].lines
    ends = np.array([[*line.get_xdata()], [*line.get_ydata()]])[:, [0, -1]]
    # it is closed
    np.testing.assert_allclose(ends[:, 0], ends[:, 1], atol=1e-9)
    assert orbit.axes[0].get_xlabel() == "x [m]"
    assert len(cycle.plot(against="x").axes) == 1
    with pytest.raises(cd.ModelError, match=r"'speed'"):
        cycle.plot(against="speed")
    page = cycle.animate(tmp_path / "page.html", page="plain")
    assert page.path.read_text().startswith("<!")
    assert (tmp_path / "histories.png").exists()
    # what paths give has them too
    path: Any = model.continuation(omega=(1.4, 1.42), of="cycles", start=cycle)
    assert path[-1].plot().axes
    assert path[-1].motion.plot().axes
