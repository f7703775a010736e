"""Second derivatives of functions over elements: slopes of gradients, rays, and other routes."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError
from cardan.runtime.calls.lanes import width
from cardan.runtime.models.finite_elements import product_forms
from cardan.runtime.models.finite_elements.products import PROJECTIONS
from cardan.runtime.verification.differences import BOUND, missing, slope
from laws.absolute_scenes import SCENES
from laws.test_absolute_derivatives import (
    Key,
    arguments,
    keys_of,
    model_of,
    result_of,
    state_of,
    value,
    ways,
)
from table import each

# of second differences at 0 ... 4 steps, to eighth order
# Source: Fornberg, Math. Comp. 51 (1988), table 1.
WEIGHTS = np.array([-205 / 72, 8 / 5, -1 / 5, 8 / 315, -1 / 560])
# each step is so much of the one before, from the longest on
LONGEST, SHORTER, STEPS = 0.1, 0.6, 14
# what the best of them may be off, of the largest term: rounding of the values over the square of
# the step, and what two steps share by chance
MARGIN, SHARP = 50.0, 1e-6
# of sums of terms of one size, which other routes add in another order
ROUNDING = 1e-10


def second(f: Any, size: float) -> tuple[float, float]:
    """Second derivative of f at 0, and how far it may be off: two steps, and rounding.

    Args:
        f: Of one number.
        size: Of the values beside which they are rounded.
    """
    steps, here = LONGEST * SHORTER ** np.arange(STEPS), f(0.0)
    values, errors = list[float](), list[float]()
    for h in steps:
        away = [f(k * h) + f(-k * h) for k in range(1, 5)]
        values.append(float(WEIGHTS @ [here, *away]) / h**2)
        errors.append(4e-16 * max(size, *map(abs, away)) / h**2)
    off = np.abs(np.diff(values)) + np.array(errors[1:])
    best = int(np.argmin(off))
    return values[best + 1], float(off[best])


@functools.cache
def softened(name: str, step: float, way: tuple[float, ...]) -> cd.CompiledModel:
    """The model with other parameters."""
    model = model_of(name)
    values = model.parameters.vector + step * np.array(way)
    return model.with_parameters(dict(zip(model.parameters, values, strict=True)))


def along_ray(name: str, function: Key, way: dict[str, Any], weights: Any, step: float) -> float:
    """Weighted sum of a function where all that it reads has gone a step, coordinates by speeds."""
    model, state = model_of(name), dict(state_of(name))
    other = softened(name, step, tuple(way["p"].tolist())) if step and "p" in way else model
    for block in way.keys() - {"p", "q"}:
        state[block] = state[block] + step * way[block]
    if "q" in way:
        state["q"] = model.integrate(state["q"], step * way["q"])
    return float(weights @ value(name, function, state, other))


def gradient_slopes(
    name: str, function: Key, wrt: tuple[str, ...], weights: Any, block: str, way: Any
) -> tuple[Any, Any]:
    """Slopes of all derivatives along a way of a block, one behind the other; how far off."""
    model, state = model_of(name), state_of(name)
    product, letter = model.vjp(function, wrt=wrt), "q" if block == "coordinates" else block
    rate = model.qdot(state["q"], way) if block == "q" else way

    def here(places: dict[str, Any]) -> Any:
        return np.array(
            [
                np.concatenate(
                    [
                        np.ravel(x)
                        for x in product(
                            **arguments(function, {**state, letter: place}), weights=weights
                        )
                    ]
                )
                for place in places[letter]
            ]
        )

    change, off = slope(here, {letter: state[letter][None]}, {letter: rate[None]}, np.ones(1))
    return change[0], off


@pytest.mark.parametrize("name", SCENES)
def test_second_derivatives(name: str) -> None:
    """Columns are slopes of gradients, and along a ray of everything the form is its curvature.

    Projections have derivatives where gaps are closed: slopes of these beside such places mean
    nothing. Rays need only values.
    """
    model, state, compared = model_of(name), state_of(name), set()
    for function in keys_of(model):
        array, shape = result_of(function, state, model)
        if not array.size:
            continue
        way, at, result = ways(name, function), arguments(function, state), np.ravel(array)
        weights = np.random.default_rng(1).uniform(-1, 1, result.size)
        shaped = np.reshape(weights, shape)
        H = model.hessian(function, wrt=tuple(way))(**at, weights=shaped)
        assert np.array_equal(H, H.T)
        ends = np.cumsum([x.size for x in way.values()]).tolist()
        parts = {k: slice(end - x.size, end) for end, (k, x) in zip(ends, way.items(), strict=True)}
        ray = {k: x for k, x in way.items() if k != "coordinates"}
        flat = np.concatenate([x * (k in ray) for k, x in way.items()])
        terms = np.abs(flat[:, None] * H * flat).max(initial=0)
        curved = functools.partial(along_ray, name, function, ray, weights)
        expected, off = second(curved, np.abs(weights * result).max())
        if off <= SHARP * terms:
            error = abs(expected - flat @ H @ flat)
            assert error <= BOUND * terms + MARGIN * off, (function, error, terms, off)
            compared.add(function)
        for block in way.keys() - {"p"} if function not in PROJECTIONS else ():
            change, off = gradient_slopes(name, function, tuple(way), shaped, block, way[block])
            columns = H[:, parts[block]] * way[block]
            for other, part in parts.items():
                # a derivative along speeds is not one along coordinates that moved before
                if (block, other) != ("coordinates", "q"):
                    error = disagreement(block, other, change[part], columns[part], off, way)
                    assert np.isnan(error) or error <= BOUND, (function, block, other, error)
    assert compared >= {"rhs", "energy", "forward_dynamics"}


def disagreement(
    block: str, other: str, change: Any, columns: Any, off: Any, way: dict[str, Any]
) -> float:
    """Of a slope of derivatives by another block and the columns (rows, n) along a way.

    Directions of columns change with coordinates: along one way both orders are one.
    """
    total = columns.sum(axis=1)
    if block == other and block in ("q", "coordinates"):
        change, total = np.atleast_1d(way[other] @ change), np.atleast_1d(way[other] @ total)
    return missing(change[None], off, total[None], np.abs(columns).max(initial=0))


def arm(coordinates: str) -> cd.CompiledModel:
    """Two rods on hinges across each other, with a motor, a spring and what a point does."""
    scene = cd.Scene("arm", gravity=(0.5, 0, -9.81))
    m, k = scene.parameter("m", 1.2), scene.parameter("k", 3.0)
    torque = scene.input("torque", unit="N*m")
    rod = cd.inertia.rod(m, 0.6, axis="z")
    upper = scene.body("upper", mass=m, com=(0, 0.05, -0.3), inertia=rod)
    lower = scene.body("lower", mass=2 * m**2, com=(0, 0, -0.2), inertia=(0.03, 0.02, 0.01))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("x"), upper.at(0, 0, -0.6), lower)
    scene.force("motor", cd.JointForce("elbow", torque * (1 + cd.t)))
    scene.force("spring", cd.JointSpring("shoulder", stiffness=k))
    tip = lower.at(0.1, 0, -0.4)
    scene.output("reach", tip.position()[0])
    scene.output("speed", tip.velocity()[2])
    scene.output("rate", tip.acceleration()[1])
    return cd.compile(scene, coordinates=coordinates)


@each("function", ["energy", "outputs"])
def test_joints_and_nodes_have_one_curvature(function: str) -> None:
    """Joint coordinates have other second derivatives, of other equations, along one path."""
    joints, nodes, step, rng = arm("relative"), arm("absolute"), 0.02, np.random.default_rng(7)
    names, q, u, a, b = ("shoulder", "elbow"), *rng.uniform(0.3, 0.8, (4, 2))
    r, c, p = np.array([0.7]), np.array([0.5]), np.array([0.4, -1.0])
    weights = rng.uniform(0.5, 1, 3)

    def of_nodes(angles: Any, speeds: Any) -> Any:
        named = [dict(zip(names, x.tolist(), strict=True)) for x in (angles, speeds)]
        return nodes.split(nodes.initial(q=named[0], u=named[1]))

    def derivatives(model: cd.CompiledModel, q: Any, u: Any) -> tuple[Any, Any]:
        more, blocks = ({"r": r}, ("q", "u", "r", "m", "k"))
        if function == "energy":
            more, blocks = {}, ("q", "u", "m", "k")
        at = {"weights": weights, **more}
        slopes = model.vjp(function, wrt=blocks)(q=q, u=u, **at)
        gradient = np.concatenate([np.atleast_1d(x) for x in slopes])
        return gradient, model.hessian(function, wrt=blocks)(q=q, u=u, **at)

    tail = np.concatenate([c * (function == "outputs"), p])[0 if function == "outputs" else 1 :]
    _, H = derivatives(joints, q, u)
    ray = np.concatenate([a, b, tail])
    # nodes go along curves: speeds along them, and how these change, to eighth order
    at, gone = of_nodes(q, u), step * np.arange(-4, 5)
    along = np.array([of_nodes(q + s * a, a)[1] for s in gone])
    speeds = np.array([of_nodes(q + s * a, u + s * b)[1] for s in gone])
    first = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])
    bend = np.concatenate([WEIGHTS[:0:-1], WEIGHTS])
    path = np.concatenate([along[4], first @ speeds / step, tail])
    curve = np.concatenate([first @ along / step, bend @ speeds / step**2, 0 * tail])
    gradient, curvature = derivatives(nodes, *at)
    terms = np.abs(path[:, None] * curvature * path).max()
    difference = path @ curvature @ path + gradient @ curve - ray @ H @ ray
    # rounding of second differences over the square of the step
    assert abs(difference) <= 4e-16 / step**2 * 10 * terms
    assert abs(ray @ H @ ray) >= 1e-2 * terms


def test_a_stretched_bar() -> None:
    """Of a bar that is stretched by the part e the energy is E w h l e^2 / 2."""
    scene = cd.Scene("bar", gravity=(0, 0, 0))
    values = {"E": 5e6, "width": 0.03, "height": 0.04}
    E, width, height = (scene.parameter(name, x) for name, x in values.items())
    material = cd.material(E=E, nu=0.45, rho=1100)
    section = cd.section.rectangle(width, height)
    scene.beam("bar", scene.ground, (0.8, 0, 0), section, material, elements=2)
    model = cd.compile(scene)
    q, u = model.split(model.initial())
    stretch, e = np.zeros(model.nu), 0.02
    # nodes move as far as they are out
    stretch[3::6] = q[4::7]
    q = model.integrate(q, e * stretch)
    wrt = ("q", "E", "width", "height")
    H = model.hessian("energy", wrt=wrt)(q, u, [0, 1.0, 0])
    way = np.zeros((model.nu + 3, 4))
    way[: model.nu, 0] = stretch
    way[model.nu :, 1:] = np.eye(3)
    energy = 0.5 * 0.8 * e**2 * np.prod([*values.values()])
    parts = np.array([e, *values.values()])
    # of a product of powers: e^2 E w h
    powers = np.array([2, 1, 1, 1])
    expected = energy * (np.outer(powers, powers) - np.diag(powers)) / np.outer(parts, parts)
    size = energy / np.outer(parts, parts)
    assert np.abs((way.T @ H @ way - expected) / size).max() <= 1e-9


def test_accelerations_by_stiffness_and_density() -> None:
    """At rest accelerations are as E / rho: data of elements are products of parameters."""
    name = "cantilever"
    model, q = model_of(name), state_of(name)["q"]
    still, weights = np.zeros(model.nu), np.ones(model.nu)
    total = model.forward_dynamics(q, still).sum()
    H = model.hessian("forward_dynamics", wrt=("E", "rho"))(q, still, weights)
    expected = total * np.array([[0, -1 / (5e6 * 1100)], [-1 / (5e6 * 1100), 2 / 1100**2]])
    assert np.abs(H - expected).max() <= ROUNDING * np.abs(expected).max()
    assert abs(H[0, 0]) <= ROUNDING * abs(total) / 5e6**2


def test_a_formula() -> None:
    """Second derivatives of a formula, and those of the outputs that it reads."""
    name, formula = "rubber, nodes", "z^2*m + hinge*torque*hinge.u + acceleration*torque^2"
    model, state = model_of(name), state_of(name)
    at = {letter: state[letter] for letter in ("q", "u", "r")} | {"t": 0.2}
    wrt = ("coordinates", "u", "torque", "m")
    H = model.hessian(("expression", formula), wrt=wrt)(**at, weights=1.5)
    (z, acceleration), tau, m = model.outputs(**at), at["r"][0], 0.1
    D = np.concatenate(
        [np.reshape(x, (2, -1)) for x in model.derivative("outputs", wrt=wrt)(**at)], axis=1
    )
    expected = model.hessian("outputs", wrt=wrt)(**at, weights=[2 * z * m, tau**2])
    at_q, at_u = model.coordinates.index("hinge"), model.nq + model.speeds.index("hinge.u")
    e = np.eye(len(H))
    by_tau, by_m = e[-2], e[-1]
    pairs = [
        (2 * m, D[0], D[0] / 2),
        (2 * z, D[0], by_m),
        (2 * tau, D[1], by_tau),
        (at["u"][0], e[at_q], by_tau),
        (at["q"][0], e[at_u], by_tau),
        (tau, e[at_q], e[at_u]),
        (acceleration, by_tau, by_tau),
    ]
    for factor, one, other in pairs:
        expected += factor * (np.outer(one, other) + np.outer(other, one))
    assert np.abs(H - 1.5 * expected).max() <= ROUNDING * np.abs(H).max()


@each("name", ["crane", "cantilever", "superelement, damped chord"])
def test_along_speeds_and_along_coordinates(name: str) -> None:
    """A quaternion counts by its direction: along rates at unit speeds nothing bends.

    That of a sphere, -1/4 of the quaternion itself, is along what does not count.
    """
    model, state = model_of(name), state_of(name)
    N = np.array([model.qdot(state["q"], e) for e in np.eye(model.nu)]).T
    at = {"q": state["q"], "u": state["u"], "weights": [0.4, 1.0, -0.3]}
    H = model.hessian("energy", wrt="q")(**at)
    by_coordinates = model.hessian("energy", wrt="coordinates")(**at)
    assert np.abs(N.T @ by_coordinates @ N - H).max() <= ROUNDING * np.abs(H).max()


def test_names_batches_and_parameters() -> None:
    """Columns are in the order in which they were asked for; leading axes broadcast."""
    name = "cantilever"
    model, state = model_of(name), state_of(name)
    q = np.stack([state["q"], model.integrate(state["q"], 0.01 * np.ones(model.nu))])
    weights = np.ones(model.nu)
    H = model.hessian("forward_dynamics", wrt=("rho", "u", "E"))(q, state["u"], weights)
    n = model.nu + 2
    assert H.shape == (2, n, n)
    turned = model.hessian("forward_dynamics", wrt=("u", "E", "rho"))(q[1], state["u"], weights)
    order = [n - 1, *range(n - 1)]
    assert np.array_equal(H[1], turned[order][:, order])
    soft = model.hessian("energy", wrt=("q", "E"))
    other = model.with_parameters(E=1e6).hessian("energy", wrt=("q", "E"))
    at = (q[1], state["u"], [1, 1, 0])
    assert np.array_equal(soft(*at, parameters={"E": 1e6}), other(*at))


@pytest.mark.parametrize("name", ["superelement, chord", "cantilever"])
def test_elements_side_by_side(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Elements that are computed several at once have the derivatives of single ones."""
    model, state = model_of(name), state_of(name)
    at, wrt = {"q": state["q"], "u": state["u"]}, ("q", "u")
    one = model.hessian("forward_dynamics", wrt=wrt)(**at, weights=np.ones(model.nu))
    monkeypatch.setattr(product_forms, "LANE_THRESHOLD", 1)
    build, options = SCENES[name]
    again = cd.compile(build(), **options)
    many = again.hessian("forward_dynamics", wrt=wrt)(**at, weights=np.ones(model.nu))
    if width() > 1:
        symbols = [symbol for symbol in again._objects.lanes if symbol.endswith("_curvature")]
        assert symbols
    assert np.abs(many - one).max() <= ROUNDING * np.abs(one).max()


def test_every_build_is_checked() -> None:
    """Curvatures of kinds of elements are compared with slopes of their gradients."""
    name = "cantilever"
    model, state = model_of(name), state_of(name)
    model.hessian("energy", wrt="q")(state["q"], state["u"], np.ones(3))
    checks = {one.function: one.error for one in model.verify().checks}
    curved = {label: error for label, error in checks.items() if label.endswith("energy_curvature")}
    assert len(curved) >= 2
    assert max(curved.values()) <= BOUND


def test_wrenches_are_refused() -> None:
    model = model_of("rubber, nodes")
    q, u = model.split(model.initial())
    with pytest.raises(ArgumentError, match="wrenches have none"):
        model.hessian("forward_dynamics")(q, u, np.ones(model.nu), wrenches={"tip": np.ones(6)})
