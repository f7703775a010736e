"""Gradients through events in absolute coordinates: closed forms, differences, joints."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import SolveError
from laws.event_scenes import SCENES
from laws.test_happening import inclined
from laws.test_reaction_friction import slider_crank
from table import each

G = 9.81
TIGHT: dict[str, Any] = {"rtol": 1e-11, "atol": 1e-13}
# backward and forward differentiate the same steps
EXACT = 1e-12
# of differences to eighth order
WEIGHTS = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
absolute = partial(cd.compile, coordinates="absolute")


def difference(f: Callable[[float], float], step: float) -> float:
    """Slope of f at 0 to eighth order."""
    pairs = enumerate(WEIGHTS, 1)
    return sum(w * (f(k * step) - f(-k * step)) for k, w in pairs) / step


def ball() -> cd.Scene:
    scene = cd.Scene("ball", gravity=(0, 0, -G))
    restitution = scene.parameter("e", 0.8)
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    scene.force("floor", cd.Stop("z", lower=0.0, restitution=restitution))
    return scene


def height(h: complex, e: complex, t: float) -> complex:
    """Height of the ball after a time, in closed form: numbers may have imaginary parts."""
    start = np.sqrt(2 * h / G)
    speed, at = G * start, start
    while (at + 2 * e * speed / G).real < t:
        speed, at = e * speed, at + 2 * e * speed / G
    return complex(e * speed * (t - at) - G * (t - at) ** 2 / 2)


@each(
    "method, how, e, t",
    [
        ("DOP853", TIGHT, 0.8, 2.0),
        ("Radau", TIGHT, 0.8, 2.0),
        # between its rows steps of Radau lead; free fall is exact
        (cd.GeneralizedAlpha(0.8), {"step": 1e-2}, 0.8, 2.0),
        # twenty impacts
        ("DOP853", {"rtol": 1e-13, "atol": 1e-14}, 0.95, 12.0),
    ],
)
def test_a_bouncing_ball(method: Any, how: dict[str, Any], e: float, t: float) -> None:
    model, unit = absolute(ball()), 1e-30
    found = model.gradient(
        t, cd.cost(final="z"), wrt=("q0.z", "e"), q={"z": 1.0}, parameters={"e": e}, method=method,
        **how,
    )  # fmt: skip
    assert len(found.motion.events) >= (20 if t > 2 else 2)
    assert found.value == pytest.approx(height(1.0, e, t).real, abs=1e-10)
    by_height = height(1.0 + 1j * unit, e, t).imag / unit
    assert found.slope["q0.z"] == pytest.approx(by_height, rel=1e-10)
    assert found.slope["e"] == pytest.approx(height(1.0, e + 1j * unit, t).imag / unit, rel=1e-10)
    if t == 2:
        # without the time of the impact it would be 1
        assert by_height == pytest.approx(0.42661, abs=1e-5)


# runs of scenes with events: speeds of their starts, and how long they are
RUNS: dict[str, tuple[dict[str, float], float]] = {
    "rubbing": ({"x": 0.3}, 1.5),
    "ball": ({}, 1.5),
    "rough_arm": ({"J1": 0.4, "J2": -0.5}, 1.5),
    # what it locks loses its derivatives but for rounding, which is no size to grow from
    "latch": ({}, 1.5),
    "four_bar": ({"A": 0.3}, 1.0),
    "slider_crank": ({"A": -0.4}, 1.5),
    "sampled": ({}, 0.4),
}


def both(
    scene: Callable[[], cd.Scene], t: float, cost: Any, names: tuple[str, ...], **how: Any
) -> list[Any]:
    """Gradients in joint and in absolute coordinates."""
    return [
        cd.compile(scene(), coordinates=one).gradient(t, cost, wrt=("p", *names), **how)
        for one in ("relative", "absolute")
    ]


def assert_alike(found: list[Any], tol: float) -> None:
    """Slopes by names and by all parameters are the same, as parts of the largest."""
    assert [e.name for e in found[0].motion.events] == [e.name for e in found[1].motion.events]
    assert found[1].value == pytest.approx(found[0].value, rel=tol)
    a, b = (np.concatenate([np.ravel(x) for _, x in sorted(one.slope.items())]) for one in found)
    assert np.abs(b - a).max() <= tol * np.abs(a).max()


@each("name", RUNS)
def test_scenes_in_both_coordinates(name: str) -> None:
    """Impacts, sticking, a stop of a loop and samples move as in joint coordinates.

    A controller has corners within its steps, and steps are others.
    """
    u, t = RUNS[name]
    q = SCENES[name]()[1]
    joint = list(q)[-1]
    cost = cd.cost(
        final=None if name == "latch" else f"{joint}^2 + 0.3*{joint}", running=f"{joint}^2"
    )
    names = tuple(f"q0.{one}" for one in q)
    how = {"q": q, "u": u, "method": "DOP853", "rtol": 1e-11, "atol": 1e-12}
    found = both(lambda: SCENES[name]()[0], t, cost, names, **how)
    assert found[1].motion.events or name == "sampled"
    assert_alike(found, 1e-5 if name == "sampled" else 1e-8)


def pendulum() -> cd.Scene:
    """A rubber bar on a hinge that hits a stop, again and again, until it rests."""
    scene = cd.Scene("rubber pendulum", gravity=(0, 0, -G))
    E, e, stop = (scene.parameter(n, x) for n, x in {"E": 5e6, "e": 0.6, "stop": 0.5}.items())
    hub = scene.body("hub", mass=0.5, inertia=(0.01, 0.01, 0.01))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    rubber = cd.material(E=E, nu=0.45, rho=1100, damping=1e-3)
    section = cd.section.rectangle(0.02, 0.03)
    bar = scene.beam("bar", hub, (1, 0, 0), section, rubber, elements=2)
    scene.force("buffer", cd.Stop("hinge", upper=stop, restitution=e))
    scene.output("tip", bar.end.position()[2])
    return scene


@each("method", ["DOP853", "Radau", "GeneralizedAlpha"])
def test_a_beam_that_hits_a_stop(method: str) -> None:
    """Against differences of tight runs; backward and forward agree to rounding."""
    model, t, start = cd.compile(pendulum()), 0.6, {"hinge": -0.2}
    assert model.manifest.absolute
    how: dict[str, Any] = {"method": method, **TIGHT}
    if method == "GeneralizedAlpha":
        how = {"method": cd.GeneralizedAlpha(0.8), "step": 2e-3}
    names = ("E", "e", "stop", "u0.hinge")
    cost = cd.cost(final="tip + hinge.u/10")
    found = model.gradient(t, cost, wrt=names, u=start, **how)
    # it comes to lie there
    assert len(found.motion.events) > 10
    motion = model.simulate(t, u=start, sensitivity=names, **how)
    q, u, _ = model.parts_of(motion.x[-1])
    by_q = model.derivative("outputs", wrt="coordinates")(q, u)[0]
    for name in names:
        change = motion.sensitivity[name][-1]
        forward = by_q @ change[: model.nq] + change[model.nq + model.speeds.index("hinge.u")] / 10
        assert found.slope[name] == pytest.approx(forward, rel=EXACT), name
    if method == "GeneralizedAlpha":
        return
    for name in names:
        size = 0.2 if name == "u0.hinge" else model.parameters[name]

        def value(h: float, name: str = name, size: float = size) -> float:
            if name == "u0.hinge":
                given: dict[str, Any] = {"u": {"hinge": -0.2 + h * size}}
            else:
                changed = {name: model.parameters[name] + h * size}
                given = {"u": start, "parameters": changed}
            run = model.simulate(t, method="DOP853", rtol=1e-12, atol=1e-14, **given)
            end = model.outputs(*model.split(run.x[-1]))[0]
            return float(end + run["hinge.u"][-1] / 10)

        expected = difference(value, 2e-3) / size
        # what the tolerance of the run leaves of it
        assert found.slope[name] == pytest.approx(expected, rel=1e-8), name


def rough() -> cd.Scene:
    return inclined("rough", True)


def wedge() -> cd.Scene:
    """A heavy rod on a light cart, which jams."""
    scene = cd.Scene("wedge", gravity=(0, 0, -G))
    cart = scene.body("cart", mass=0.1)
    rod = scene.body("rod", mass=10.0, com=(0, 0, 1.0), inertia=(0.1, 0.1, 0.01))
    scene.joint("x", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("h", cd.Revolute("y"), cart, rod)
    scene.force("rail", cd.Friction("x", mu=0.9))
    return scene


@each(
    "build, q, u, joint, t, tol",
    [
        # sticks and slips
        (rough, {"x": 0.2, "h": 0.5}, {"x": 0.4, "h": -2}, "h", 1.5, 1e-9),
        # the force across a line changes its side within a step: corners of |F|
        (lambda: slider_crank(0.05), {"drive": 0.4}, {"drive": 1.0}, "slide", 0.5, 1e-4),
        (wedge, {"h": 1.2}, {"x": 50.0, "h": -4.0}, "h", 5.0, 1e-5),
    ],
)
def test_friction_by_reactions(
    build: Callable[[], cd.Scene], q: Any, u: Any, joint: str, t: float, tol: float
) -> None:
    """Sliding, sticking, smoothed, and until it jams: as in joint coordinates."""
    names = (*(f"q0.{one}" for one in q), *(f"u0.{one}" for one in u))
    cost = cd.cost(final=f"{joint}^2 + 0.3*{joint}", running=f"{joint}^2")
    how = {"q": q, "u": u, "method": "DOP853", "rtol": 1e-11, "atol": 1e-12}
    assert_alike(both(build, t, cost, names, **how), tol)


def test_sticking_and_slipping_beside_differences() -> None:
    """Backward and forward through every mode of friction by reactions, by stiff steps too."""
    model = absolute(rough())
    start = {"q": {"x": 0.2, "h": 0.5}, "u": {"x": 0.4, "h": -2.0}}
    names, how = ("cart.mass", "rail.mu"), {"method": "Radau", "rtol": 1e-10, "atol": 1e-12}
    found = model.gradient(1.0, cd.cost(final="h"), wrt=names, **start, **how)
    assert {event.name for event in found.motion.events} >= {"pin.stop", "rail.stop"}
    motion = model.simulate(1.0, sensitivity=names, **start, **how)
    for name in names:
        forward = motion.sensitivity[name][-1][model.coordinates.index("h")]
        assert found.slope[name] == pytest.approx(forward, rel=1e-11)

        def value(h: float, name: str = name) -> float:
            changed = {name: model.parameters[name] * (1 + h)}
            run = model.simulate(1.0, parameters=changed, method="DOP853", **TIGHT, **start)
            return float(run["h"][-1])

        expected = difference(value, 1e-3) / model.parameters[name]
        assert found.slope[name] == pytest.approx(expected, rel=1e-7)


def test_touches_and_events_at_one_time_are_refused() -> None:
    scene = cd.Scene("ceiling", gravity=(0, 0, -10.0))
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    scene.force("ceiling", cd.Stop("z", upper=5.0 * (1 - 1e-14), restitution=0.5))
    model = absolute(scene)
    with pytest.raises(SolveError, match=r"'ceiling\.upper'.*by a touch"):
        model.gradient(2.0, cd.cost(final="z"), wrt="u0.z", u={"z": 10.0}, **TIGHT)
    scene = cd.Scene("feet", gravity=(0, 0, -G))
    for name in ("left", "right"):
        scene.joint(name, cd.Prismatic("z"), scene.ground, scene.body(f"{name} foot", mass=1.0))
        scene.force(f"floor of {name}", cd.Stop(name, lower=0.0, restitution=0.5))
    feet, q = absolute(scene), {"left": 0.5, "right": 0.5}
    with pytest.raises(SolveError, match=r"floor of left.*floor of right.*at the same time"):
        feet.gradient(1.0, cd.cost(final="left"), wrt="q0.left", q=q)
    with pytest.raises(SolveError, match=r"floor of left.*floor of right.*at the same time"):
        feet.simulate(1.0, q=q, sensitivity="q0.left")


def test_a_bar_that_comes_to_rest_at_a_stop() -> None:
    """What is left of its speeds are numbers of 1e-300, which round as they like.

    Runs with sensitivities take the method of gradients.
    """
    model = cd.compile(pendulum())
    for speed in (-1.0, -0.9):
        found = model.gradient(1.0, cd.cost(final="tip"), wrt="E", u={"hinge": speed}, rtol=1e-8)
        run = model.simulate(1.0, u={"hinge": speed}, sensitivity="E", rtol=1e-8)
        assert run.solver_info.method == found.motion.solver_info.method == "Radau"
        q, u, _ = model.parts_of(run.x[-1])
        by_q = model.derivative("outputs", wrt="coordinates")(q, u)[0]
        forward = by_q @ run.sensitivity["E"][-1][: model.nq]
        assert found.slope["E"] == pytest.approx(forward, rel=1e-9)
