"""Second derivatives of events over elements: slopes of gradients, rays, joints, a closed form."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.calls.lanes import width
from cardan.runtime.models.finite_elements import product_forms
from cardan.runtime.verification.differences import BOUND, missing, slope
from laws.test_absolute import carried
from laws.test_absolute_event_derivatives import (
    FLOOR,
    SCENES,
    arguments,
    model_of,
    possible,
    states,
    value,
    ways,
)
from laws.test_absolute_hessians import MARGIN, SHARP, WEIGHTS, second
from table import each

Array = np.ndarray
# the others differ little from these, and take as long
WITH_EVENTS = [name for name in SCENES if name != "controlled"]
QUICK = ("latch", "feet", "four_bar", "inclined", "smooth frictions in a loop", "gauged")
# of sums of terms of one size, which other routes add in another order
ROUNDING = 1e-10
# first differences of eighth order at -4 ... 4 steps
# Source: Fornberg, Math. Comp. 51 (1988), table 1.
FIRST = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])


def cases(name: str) -> Iterator[tuple[str, dict[str, Any]]]:
    """Values of events, and what every event and all impacts together change, at some states."""
    model = model_of(name)
    impacts = np.array([row.kind == "impact" for row in model.manifest.events], dtype=float)
    for state in states(name):
        yield "events", state
        alone = possible(model, state)
        together = [impacts] if impacts.sum() > 1 and (alone @ impacts).sum() > 1 else []
        for fired in [*alone, *together]:
            yield "transition", {**state, "e": fired}


def gradient_slopes(
    model: Any, function: str, state: dict[str, Any], wrt: Any, weights: Array, block: str, way: Any
) -> tuple[Array, Array]:
    """Slopes of all derivatives along a way of a block, one behind the other; how far off."""
    product = model.vjp(function, wrt=wrt)
    rate = model.qdot(state["q"], way) if block == "q" else way

    def here(places: dict[str, Any]) -> Array:
        at = [arguments(function, {**state, block: row}) for row in places[block]]
        parts = [product(**one, weights=weights) for one in at]
        return np.array([np.concatenate([np.ravel(x) for x in one]) for one in parts])

    change, off = slope(here, {block: state[block][None]}, {block: rate[None]}, np.ones(1))
    return change[0], off


@functools.cache
def moved(name: str, step: float, way: tuple[float, ...]) -> cd.CompiledModel:
    """The model with other parameters."""
    model = model_of(name)
    values = model.parameters.vector + step * np.array(way)
    return model.with_parameters(dict(zip(model.parameters, values, strict=True)))


def on_ray(
    name: str, function: str, state: dict[str, Any], way: Any, weights: Array, step: float
) -> float:
    """Weighted sum of a function where all that it reads has gone a step, coordinates by speeds."""
    model, at = model_of(name), dict(state)
    other = moved(name, step, tuple(way["p"].tolist())) if step else model
    for block in way.keys() - {"p", "q"}:
        at[block] = at[block] + step * way[block]
    at["q"] = model.integrate(at["q"], step * way["q"])
    return float(weights @ value(other, function, at))


@pytest.mark.parametrize(
    "name", [n if n in QUICK else pytest.param(n, marks=pytest.mark.slow) for n in WITH_EVENTS]
)
def test_second_derivatives(name: str) -> None:
    """Columns are slopes of gradients, and along a ray of everything the form is its curvature."""
    model, slopes, rays = model_of(name), set[tuple[str, str]](), set[str]()
    for function, state in cases(name):
        way, at = ways(model, function, state), arguments(function, state)
        result = value(model, function, state)
        weights = np.random.default_rng(1).uniform(-1, 1, result.size)
        H = model.hessian(function, wrt=tuple(way))(**at, weights=weights)
        ends = np.cumsum([x.size for x in way.values()])
        parts = dict(zip(way, np.split(np.arange(len(H)), ends[:-1]), strict=True))
        flat = np.concatenate([*way.values()])
        terms, floor = flat[:, None] * H * flat, FLOOR * (1 + np.abs(result).max())
        for block in way.keys() - {"p"}:
            change, off = gradient_slopes(
                model, function, state, tuple(way), weights, block, way[block]
            )
            for other, rows in parts.items():
                # along one way both orders of speeds are one
                columns = (flat[:, None] * H)[np.ix_(rows, parts[block])] * way[block]
                total, difference = columns.sum(axis=1), change[rows] * way[other]
                if block == other == "q":
                    total, difference = total.sum()[None], difference.sum()[None]
                size, far = np.abs(columns).max(), off * np.abs(way[other]).max()
                error = missing(difference[None], far, total[None], size, floor)
                assert np.isnan(error) or error <= BOUND, (function, block, other, error)
                slopes |= set() if np.isnan(error) else {(function, block)}
        curved = functools.partial(on_ray, name, function, state, way, weights)
        expected, off = second(curved, np.abs(weights * result).max(initial=0))
        most = max(floor, np.abs(terms).max())
        if off <= SHARP * most:
            assert abs(expected - flat @ H @ flat) <= BOUND * most + MARGIN * off, function
            rays.add(function)
    # differences of stiff forces may tell nothing
    assert slopes >= {("events", "u"), ("transition", "u")}
    assert rays


@each("name", ["gauged", "latch", "four_bar", "superelement on a stop"])
def test_order_of_columns(name: str) -> None:
    """Columns come as they are asked for; coordinates do not bend along rates at unit speeds."""
    model, (function, state) = model_of(name), [*cases(name)][1]
    at, n = arguments(function, state), value(model_of(name), function, state).size
    weights = np.random.default_rng(2).uniform(-1, 1, n)
    H = model.hessian(function, wrt=("q", "u", "p"))(**at, weights=weights)
    assert np.array_equal(H, H.T)
    turned = model.hessian(function, wrt=("p", "q", "u"))(**at, weights=weights)
    order = np.roll(np.arange(len(H)), len(model.parameters))
    assert np.abs(H[np.ix_(order, order)] - turned).max() <= ROUNDING * np.abs(H).max()
    N = np.array([model.qdot(state["q"], e) for e in np.eye(model.nu)]).T
    by_coordinates = model.hessian(function, wrt="coordinates")(**at, weights=weights)
    along = H[: model.nu, : model.nu]
    assert np.abs(N.T @ by_coordinates @ N - along).max() <= ROUNDING * np.abs(H).max()


class Path:
    """A scene in both coordinates, and a path of joints with which all nodes go."""

    STEP = 0.02

    def __init__(self, name: str) -> None:
        scene, start = SCENES[name]()
        self.nodes, self.joints, rng = model_of(name), cd.compile(scene), np.random.default_rng(4)
        q, u = self.joints.split(self.joints.initial(q=start))[:2]
        n = self.joints.nu
        self.q, self.a = q + 0.1 * rng.uniform(-1, 1, n), rng.uniform(0.3, 1, n)
        self.u, self.b = u + rng.uniform(0.3, 1, n), rng.uniform(0.3, 1, n)
        gone = self.STEP * np.arange(-4, 5)
        go = functools.partial(carried, self.nodes, self.joints)
        self.q_nodes, self.u_nodes = go(self.q, self.u)
        along = np.array([go(self.q + x * self.a, self.a)[1] for x in gone])
        moving = np.array([go(self.q + x * self.a, self.u + x * self.b)[1] for x in gone])
        bend = np.concatenate([WEIGHTS[:0:-1], WEIGHTS])
        self.way = np.concatenate([along[4], FIRST @ moving / self.STEP])
        self.turn = np.concatenate([FIRST @ along / self.STEP, bend @ moving / self.STEP**2])
        self.shared = [speed for speed in self.joints.speeds if speed in self.nodes.speeds]

    def weights(self, function: str, rng: Any) -> tuple[Array, Array]:
        """Weights by joints and by nodes, of results that both have."""
        if function == "events":
            both = rng.uniform(0.5, 1, len(self.nodes.event_names))
            return both, both
        states = rng.uniform(0.5, 1, len(self.nodes.manifest.z) + len(self.nodes.manifest.s))
        by_speed = dict(zip(self.shared, rng.uniform(0.5, 1, len(self.shared)), strict=True))
        of_joints, of_nodes = (
            np.concatenate([[by_speed.get(speed, 0.0) for speed in model.speeds], states])
            for model in (self.joints, self.nodes)
        )
        return of_joints, of_nodes


@each("name", ["gauged", "latch", "inclined", "braked"])
def test_joints_and_nodes_have_one_curvature(name: str) -> None:
    """Joint coordinates have other second derivatives, of other equations, along one path.

    On it x = phi(s): the second derivative of f is x' H x' + gradient x'' in either coordinates.
    """
    path, rng, most = Path(name), np.random.default_rng(6), 0.0
    joints, nodes = path.joints, path.nodes
    s = np.array([1.0 if row.labels else 0.5 for row in joints.manifest.s])
    # stops and locks hold nothing
    s[[k for k, row in enumerate(joints.manifest.s) if "free" in str(row.labels)]] = 0.0
    more = {"t": 0.2, "s": s, "r": 0.3 + joints._layout.start("r")}
    here = {"q": path.q_nodes, "u": path.u_nodes, **more, "z": nodes._layout.start("z")}
    impacts = possible(nodes, here)
    for function, fired in [("events", None), *(("transition", e) for e in impacts)]:
        of_joints, of_nodes = path.weights(function, rng)
        sides = []
        for model, q, u, weights in (
            (joints, path.q, path.u, of_joints),
            (nodes, path.q_nodes, path.u_nodes, of_nodes),
        ):
            at = arguments(function, {**here, "q": q, "u": u, "e": fired})
            at |= {"weights": weights}
            gradient = np.concatenate(model.vjp(function, wrt=("q", "u"))(**at))
            sides.append((gradient, model.hessian(function, wrt=("q", "u"))(**at)))
        (_, H), (gradient, curvature) = sides
        ray = np.concatenate([path.a, path.b])
        terms = np.abs(path.way[:, None] * curvature * path.way).max()
        # speeds are rounded, of which there are second differences
        terms = max(terms, np.abs(gradient).max() * np.abs(path.u_nodes).max())
        error = path.way @ curvature @ path.way + gradient @ path.turn - ray @ H @ ray
        # rounding of second differences over the square of the step
        assert abs(error) <= 4e-16 / path.STEP**2 * 10 * terms, (function, fired, error, terms)
        most = max(most, abs(ray @ H @ ray))
    assert most >= 1e-3


def test_two_masses_that_part() -> None:
    """Of a restitution e the heavy mass M takes m / (m + M) (1 + e) of the speed between them."""
    scene = cd.Scene("masses", gravity=(0, 0, 0))
    values = {"M": 2.0, "m": 0.7, "e": 0.4}
    M, m, e = (scene.parameter(name, x) for name, x in values.items())
    heavy = scene.body("heavy", mass=M, inertia=(0.1, 0.1, 0.1))
    light = scene.body("light", mass=m, inertia=(0.1, 0.1, 0.1))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, heavy)
    scene.joint("gap", cd.Prismatic("x"), heavy, light)
    scene.force("stop", cd.Stop("gap", lower=0.0, restitution=e))
    model = cd.compile(scene, coordinates="absolute")
    q, u = model.split(model.initial(u={"rail": 0.3, "gap": -1.5}))
    names = ("u", "M", "m", "e")
    # nothing but the speed of the heavy body counts
    weights = np.zeros(model.nu + len(model.manifest.s))
    weights[model.speeds.index("heavy.u.px")] = 1.0
    H = model.hessian("transition", wrt=names)(q, u, np.array([1.0, 0.0]), weights=weights)
    moving = {"rail": 0.0, "gap": 1.0}
    way = np.zeros((len(H), 4))
    way[: model.nu, 0] = model.split(model.initial(u=moving))[1]
    way[model.nu :, 1:] = np.eye(3)
    (M, m, e), v = values.values(), -1.5
    total = M + m
    share, by_M, by_m = m / total, -m / total**2, M / total**2
    expected = np.zeros((4, 4))
    expected[0, 1:] = [(1 + e) * by_M, (1 + e) * by_m, share]
    expected[1, 2:] = [v * (1 + e) * (m - M) / total**3, v * by_M]
    expected[2, 3] = v * by_m
    expected += expected.T
    expected[1, 1] = v * (1 + e) * 2 * m / total**3
    expected[2, 2] = -v * (1 + e) * 2 * M / total**3
    assert np.abs(way.T @ H @ way - expected).max() <= ROUNDING


@pytest.mark.parametrize("name", ["feet", "rough_arm"])
def test_elements_side_by_side(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Elements that are computed several at once have the derivatives of single ones."""
    results = []
    for threshold in (product_forms.LANE_THRESHOLD, 1):
        monkeypatch.setattr(product_forms, "LANE_THRESHOLD", threshold)
        model = cd.compile(SCENES[name]()[0], coordinates="absolute")
        for function, state in cases(name):
            at, n = arguments(function, state), value(model, function, state).size
            H = model.hessian(function, wrt=("q", "u", "p"))(**at, weights=np.ones(n))
            results.append(H)
    if width() > 1:
        lanes = {symbol.rpartition("__")[2] for symbol in model._objects.lanes}
        assert lanes >= {"signs_curvature", "jumps_curvature", "states_curvature"} or name != "feet"
    for one, many in zip(results[: len(results) // 2], results[len(results) // 2 :], strict=True):
        assert np.abs(many - one).max() <= ROUNDING * max(np.abs(one).max(), 1e-3)


def test_every_build_is_checked() -> None:
    """Curvatures of what elements say of events are compared with slopes of their gradients."""
    name = "inclined"
    model = model_of(name)
    for function, state in cases(name):
        n = value(model, function, state).size
        model.hessian(function, wrt="q")(**arguments(function, state), weights=np.ones(n))
    checks = {one.function: one.error for one in model.verify().checks}
    for form in ("signs", "jumps", "states", "friction"):
        errors = [e for label, e in checks.items() if label.endswith(f"{form}_curvature")]
        assert errors, form
        assert max(errors) <= BOUND, form
