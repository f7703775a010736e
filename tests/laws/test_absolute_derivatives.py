"""Derivatives of functions over elements: products, columns and differences agree."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.models.finite_elements.products import DIRECT, EVENTS
from cardan.runtime.verification.differences import BOUND, missing, slope
from cardan.schema.functions import FUNCTIONS
from laws.absolute_scenes import SCENES, cantilever
from table import each

# a function, or one with its frame or joint
Key = str | tuple[str, str]
ROUNDING = 1e-10
SMALL = 1e-4
T = 0.2


@functools.cache
def model_of(name: str) -> cd.CompiledModel:
    build, options = SCENES[name]
    return cd.compile(build(), **options)


@functools.cache
def state_of(name: str) -> dict[str, Any]:
    """A state near the start, on the constraints, with all that functions read."""
    model, rng = model_of(name), np.random.default_rng(3)
    q, _, z = model.parts_of(model.initial())
    q = model.integrate(q, 0.05 * rng.uniform(-1, 1, model.nu))
    u, nq, nu = 0.3 * rng.uniform(-1, 1, model.nu), model.nq, model.nu
    r = model._layout.start("r") + 0.1 * rng.uniform(-1, 1, model.nr)
    for _ in range(30):
        q = model.close_position(q, t=T, r=r)[:nq]
    return {
        **{"t": np.array([T]), "q": q, "z": z + 0.1, "r": r, "s": model._layout.start("s")},
        "u": model.close_velocity(q, u, t=T, r=r)[:nu],
        "udot": rng.uniform(-1, 1, nu),
        "tau": 0.1 * rng.uniform(-1, 1, nu),
    }


def keys_of(model: cd.CompiledModel) -> list[Key]:
    """All functions with derivatives that a model has: of frames on places of every kind, and of a
    joint between nodes and one inside of a tree."""
    listed: list[Key] = []
    frames = {(row.node is None, row.tree): row.name for row in model.manifest.frames}
    elements = model.manifest.elements
    joints = (*[*elements.reactions][-1:], *elements.tree_joints[-1:])
    of = {"frame": tuple(frames.values()), "joint": joints}
    for name in DIRECT:
        row = FUNCTIONS[name]
        # those of events: test_absolute_event_derivatives.py
        available = all(having(model, need) for need in row.needs)
        if name in EVENTS or row.of == "formula" or not available:
            continue
        listed += [(name, each) for each in of[row.of]] if row.of else [name]
    return listed


def having(model: cd.CompiledModel, need: str) -> bool:
    """True where a model has what a function needs."""
    available = {
        "constraints": model.manifest.multipliers,
        "element forces": model.manifest.element_forces,
    }
    return bool(available.get(need, True))


def row_of(key: Key) -> Any:
    return FUNCTIONS[key if isinstance(key, str) else key[0]]


def arguments(key: Key, blocks: dict[str, Any]) -> dict[str, Any]:
    """What a function reads, at one state or, where a block has rows, at many."""
    state = {**blocks, "t": blocks["t"][..., 0]}
    lead = np.broadcast_shapes(*(np.shape(x)[:-1] for x in blocks.values()))
    parts = [np.broadcast_to(x, (*lead, x.shape[-1])) for x in (state[n] for n in "quz")]
    state["x"] = np.concatenate(parts, axis=-1)
    return {block: state[block] for block in row_of(key).arguments if block != "wrench"}


def result_of(key: Key, blocks: dict[str, Any], model: cd.CompiledModel) -> Any:
    """Results at one state or many, and the shape of one."""
    of = [key[1]] if isinstance(key, tuple) else []
    result = getattr(model, row_of(key).name)(*of, **arguments(key, blocks))
    array = np.stack(result, axis=-1) if isinstance(result, tuple) else np.asarray(result)
    return array, array.shape[-len(row_of(key).shape.split()) :]


def value(name: str, key: Key, blocks: dict[str, Any], model: Any = None) -> Any:
    """Results one behind the other (..., k)."""
    array, shape = result_of(key, blocks, model or model_of(name))
    lead = np.broadcast_shapes(*(np.shape(x)[:-1] for x in blocks.values()))
    # what reads nothing that has rows is the same for all
    return np.broadcast_to(array, (*lead, *shape)).reshape(*lead, -1)


@functools.cache
def parameter_way(name: str) -> Any:
    values = model_of(name).parameters.vector
    way = np.random.default_rng(6).uniform(0.3, 1, len(values))
    return way * np.where(values == 0, 1e-2, 1e-2 * values)


@functools.cache
def moved(name: str, h: float) -> Any:
    """The model with other parameters, along their way."""
    parameters = model_of(name).parameters
    values = parameters.vector + h * parameter_way(name)
    return model_of(name).with_parameters(dict(zip(parameters, values, strict=True)))


def along(name: str, function: Key, block: str, way: Any) -> tuple[Any, Any]:
    """Slope of a function along a way of a block, and how far it may be off."""
    model, state = model_of(name), state_of(name)
    if block == "p":

        def at(places: dict[str, Any]) -> Any:
            steps = places["h"][:, 0]
            return np.array([value(name, function, state, moved(name, h)) for h in steps])

        return slope(at, {"h": np.zeros((1, 1))}, {"h": np.ones((1, 1))}, np.ones(1))
    letter = "q" if block == "coordinates" else block
    rate = model.qdot(state["q"], way) if block == "q" else way

    def here(places: dict[str, Any]) -> Any:
        return value(name, function, {**state, letter: places[letter]})

    return slope(here, {letter: state[letter][None]}, {letter: rate[None]}, np.ones(1))


def ways(name: str, function: Key) -> dict[str, Any]:
    """Random ways of all that a function depends on."""
    model, rng, state = model_of(name), np.random.default_rng(5), state_of(name)
    reads = {*"quz"} if "x" in row_of(function).arguments else set()
    reads |= {*row_of(function).arguments, "p"} - {"x", "s"}
    found = {}
    for block in ("t", "q", "coordinates", "u", "z", "r", "p", "udot", "tau"):
        if (block if block != "coordinates" else "q") not in reads:
            continue
        size = {"q": model.nu, "coordinates": model.nq}.get(block)
        if block == "p":
            found[block] = parameter_way(name)
            continue
        way = rng.uniform(0.3, 1, len(state[block]) if size is None else size)
        if block == "coordinates":
            for first in model.manifest.quaternions:
                part = slice_of(first)
                way[part] -= state["q"][part] * (state["q"][part] @ way[part])
        found[block] = way
    return {block: way for block, way in found.items() if way.size}


def slice_of(first: int) -> slice:
    return slice(first, first + 4)


@each("name", SCENES)
def test_derivatives(name: str) -> None:
    """Columns are slopes; products with weights and along directions are those of columns."""
    model, state, compared = model_of(name), state_of(name), set()
    having_results = set()
    for function in keys_of(model):
        array, shape = result_of(function, state, model)
        result = np.ravel(array)
        if not result.size:
            continue
        having_results.add(row_of(function).name)
        directions, at = ways(name, function), arguments(function, state)
        wrt = tuple(directions)
        columns = model.derivative(function, wrt=wrt)(**at)
        weights = np.random.default_rng(1).uniform(-1, 1, result.size)
        products = model.vjp(function, wrt=wrt)(**at, weights=np.reshape(weights, shape))
        for block, D, product in zip(wrt, columns, products, strict=True):
            way = directions[block]
            D = np.reshape(D, (result.size, way.size))
            expected, off = along(name, function, block, way)
            # less than SMALL of a result is a part of the rounding of its differences
            sizes = np.abs(D * way).max(initial=0), SMALL * np.abs(result).max()
            error = missing(expected, off, (D @ way)[None], *sizes)
            assert np.isnan(error) or error <= BOUND, (function, block)
            # differences that rounding blurs say nothing
            compared |= set() if np.isnan(error) else {(row_of(function).name, block)}
            size = np.abs(weights[:, None] * D).max(initial=1e-30) + sizes[1]
            assert np.abs(weights @ D - product).max() <= ROUNDING * size, (function, block)
            direction = way if block != "t" else float(way[0])
            change = np.ravel(model.jvp(function, wrt=block)(**at, direction=direction))
            size = sum(sizes) + 1e-30
            assert np.abs(change - D @ way).max() <= ROUNDING * size, (function, block)
    moved.cache_clear()
    assert compared >= {("forward_dynamics", "q"), ("rhs", "u"), ("energy", "q")}
    assert {function for function, _ in compared} == having_results


def test_single_names() -> None:
    """A parameter or an input by name is a column of its block."""
    name = "rubber, nodes"
    model, state = model_of(name), arguments("rhs", state_of(name))
    by_p, by_r = model.derivative("rhs", wrt=("p", "r"))(**state)
    by_E, by_torque = model.derivative("rhs", wrt=("E", "torque"))(**state)
    assert by_E.shape == by_torque.shape == (model.nx,)
    assert np.array_equal(by_E, by_p[:, list(model.parameters).index("E")])
    assert np.array_equal(by_torque, by_r[:, 0])
    # many columns are found row by row, few of them column by column
    by_rows = model.derivative("rhs", wrt=("q", "coordinates", "u", "p"))(**state)[-1]
    assert np.abs(by_rows - by_p).max() <= 1e-10 * np.abs(by_p).max()
    some = model.vjp("rhs", wrt=("E", "q", "u"))(**state, weights=np.ones(model.nx))
    assert [np.shape(x) for x in some] == [(), (model.nu,), (model.nu,)]
    assert some[0] == pytest.approx(by_E.sum(), rel=1e-10)


def test_batches() -> None:
    """Leading axes broadcast; other parameters are those of another model."""
    name = "cantilever"
    model, state = model_of(name), state_of(name)
    q = np.stack([state["q"], model.integrate(state["q"], 0.01 * np.ones(model.nu))])
    product, weights = model.vjp("forward_dynamics", wrt=("u", "E")), np.ones(model.nu)
    by_u, by_E = product(q, state["u"], weights)
    assert by_u.shape == (2, model.nu)
    assert by_E.shape == (2,)
    one = product(q[1], state["u"], weights)
    assert np.array_equal(by_E[1], one[1])
    soft = product(q[1], state["u"], weights, parameters={"E": 1e6})
    other = model.with_parameters(E=1e6).vjp("forward_dynamics", wrt=("u", "E"))
    assert np.array_equal(soft[0], other(q[1], state["u"], weights)[0])


def test_forces_in_proportion() -> None:
    """At rest accelerations are as E, and as 1 / rho."""
    name = "cantilever"
    model, q = model_of(name), state_of(name)["q"]
    still = np.zeros(model.nu)
    udot = model.forward_dynamics(q, still)
    by_E, by_rho = model.derivative("forward_dynamics", wrt=("E", "rho"))(q, still)
    size = np.abs(udot).max()
    assert np.abs(5e6 * by_E - udot).max() <= 1e-12 * size
    assert np.abs(1100 * by_rho + udot).max() <= 1e-12 * size


def test_a_formula() -> None:
    """Costs are formulas in coordinates, speeds, inputs, parameters and outputs."""
    name, formula = (
        "rubber, nodes",
        "(z - 0.3)^2 + hinge*torque + 1e-3*hinge.u^2*m + acceleration*t",
    )
    model, state = model_of(name), state_of(name)
    at = {letter: state[letter] for letter in ("q", "u", "r")} | {"t": T}
    z, acceleration = model.outputs(**at)
    expected = (z - 0.3) ** 2 + at["q"][0] * at["r"][0] + 1e-3 * at["u"][0] ** 2 * 0.1
    key = ("expression", formula)
    function = model._function(*key).caller
    values = (T, at["q"], at["u"], at["r"], state["z"], state["s"])
    assert function(None, *values) == pytest.approx(expected + acceleration * T, rel=1e-12)
    by_t, by_u, by_m = model.vjp(key, wrt=("t", "u", "m"))(**at, weights=1.0)
    D_t, D_u, D_m = model.derivative("outputs", wrt=("t", "u", "m"))(**at)
    assert by_t == pytest.approx(2 * (z - 0.3) * D_t[0] + acceleration + T * D_t[1], rel=1e-10)
    assert by_m == pytest.approx(1e-3 * at["u"][0] ** 2 + T * D_m[1], rel=1e-10)
    whole = 2 * (z - 0.3) * D_u[0] + T * D_u[1]
    whole[model.speeds.index("hinge.u")] += 2e-3 * at["u"][0] * 0.1
    assert by_u == pytest.approx(whole, rel=1e-10, abs=1e-10 * np.abs(whole).max())


def test_only_on_request(tmp_path: Any) -> None:
    """Gradients of elements are written when somebody asks for them."""
    model = cd.compile(cantilever(), directory=tmp_path)
    model.forward_dynamics(*model.split(model.initial()))
    assert not list(tmp_path.glob("*gradient*"))
    model.vjp("forward_dynamics", wrt="E")(*model.split(model.initial()), np.ones(model.nu))
    kinds = {path.name.split("__")[0] for path in tmp_path.glob("*__balance.c")}
    written = {path.name for path in tmp_path.glob("*gradient*.c")}
    assert written == {f"{kind}__dynamics_gradient.c" for kind in kinds}


@each("name", ["rubber, joints in trees", "rubber, nodes"])
def test_wrenches(name: str) -> None:
    """A wrench on a frame acts along its Jacobian, which moves with the frame."""
    model, state = model_of(name), state_of(name)
    pushed = {"low.at1": np.array([0.3, -0.2, 0.4, 2.0, 1.0, -3.0])}
    more = {"u": state["u"], "r": state["r"], "t": T, "wrenches": pushed}
    way = np.random.default_rng(2).uniform(-1, 1, model.nu)
    by_q = model.derivative("forward_dynamics", wrt="q")(q=state["q"], **more)

    def here(places: dict[str, Any]) -> Any:
        return np.array([model.forward_dynamics(q=q, **more) for q in places["q"]])

    rates = {"q": model.qdot(state["q"], way)[None]}
    expected, off = slope(here, {"q": state["q"][None]}, rates, np.ones(1))
    assert missing(expected, off, (by_q @ way)[None], np.abs(by_q * way).max()) <= BOUND


def test_a_change_of_a_superelement_is_checked_without_its_gradient(tmp_path: Any) -> None:
    """Its routine has no derivatives by how it is turned on what carries it, nor has the check."""
    build, options = SCENES["superelement, root"]
    model = cd.compile(build(), directory=tmp_path, **options)
    q, u = model.split(model.initial())
    assert model.jvp("forward_dynamics", wrt="u")(q, u, np.ones(model.nu)).shape == (model.nu,)
    assert not list(tmp_path.glob("*gradient*"))
    checks = {one.function: one.error for one in model.verify().checks}
    changes = [error for label, error in checks.items() if label.endswith("dynamics_change")]
    assert changes
    assert max(changes) <= BOUND
