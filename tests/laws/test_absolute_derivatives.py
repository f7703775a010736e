"""Derivatives of functions over elements: products, columns and differences agree."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import DerivationError, ModelError
from cardan.runtime.models.finite_elements.products import DIRECT
from cardan.runtime.verification.differences import BOUND, missing, slope
from cardan.schema.functions import FUNCTIONS
from laws.absolute_scenes import SCENES, cantilever
from table import each

# those of events: test_absolute_event_derivatives.py
FUNCTIONS_OF = tuple(n for n in DIRECT if n not in ("expression", "events", "transition"))
ROUNDING = 1e-10
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


def arguments(name: str, function: str, blocks: dict[str, Any]) -> dict[str, Any]:
    state = {**blocks, "t": float(blocks["t"][0])}
    state["x"] = np.concatenate([state[letter] for letter in "quz"])
    return {block: state[block] for block in FUNCTIONS[function].arguments}


def value(name: str, function: str, blocks: dict[str, Any], model: Any = None) -> Any:
    """Results one behind the other."""
    call = getattr(model or model_of(name), function)
    return np.ravel(np.array(call(**arguments(name, function, blocks)), dtype=float))


def along(name: str, function: str, block: str, way: Any) -> tuple[Any, Any]:
    """Slope of a function along a way of a block, and how far it may be off."""
    model, state = model_of(name), state_of(name)
    if block == "p":
        values = model.parameters.vector

        def at(places: dict[str, Any]) -> Any:
            changed = [
                model.with_parameters(dict(zip(model.parameters, values + h * way, strict=True)))
                for h in places["h"][:, 0]
            ]
            return np.array([value(name, function, state, one) for one in changed])

        return slope(at, {"h": np.zeros((1, 1))}, {"h": np.ones((1, 1))}, np.ones(1))
    letter = "q" if block == "coordinates" else block
    rate = model.qdot(state["q"], way) if block == "q" else way

    def here(places: dict[str, Any]) -> Any:
        return np.array([value(name, function, {**state, letter: x}) for x in places[letter]])

    return slope(here, {letter: state[letter][None]}, {letter: rate[None]}, np.ones(1))


def ways(name: str, function: str) -> dict[str, Any]:
    """Random ways of all that a function depends on."""
    model, rng, state = model_of(name), np.random.default_rng(5), state_of(name)
    reads = {*"quz"} if "x" in FUNCTIONS[function].arguments else set()
    reads |= {*FUNCTIONS[function].arguments, "p"} - {"x", "s"}
    found = {}
    for block in ("t", "q", "coordinates", "u", "z", "r", "p", "udot", "tau"):
        if (block if block != "coordinates" else "q") not in reads:
            continue
        size = {"q": model.nu, "coordinates": model.nq, "p": len(model.parameters)}.get(block)
        way = rng.uniform(0.3, 1, len(state[block]) if size is None else size)
        if block == "p":
            way *= np.where(model.parameters.vector == 0, 1e-2, 1e-2 * model.parameters.vector)
        if block == "coordinates":
            for first in model.manifest.quaternions:
                part = slice_of(first)
                way[part] -= state["q"][part] * (state["q"][part] @ way[part])
        if way.size:
            found[block] = way
    return found


def slice_of(first: int) -> slice:
    return slice(first, first + 4)


@each("name", SCENES)
def test_derivatives(name: str) -> None:
    """Columns are slopes; products with weights and along directions are those of columns."""
    model, state, compared = model_of(name), state_of(name), set()
    for function in FUNCTIONS_OF:
        result = value(name, function, state) if available(model, function) else np.zeros(0)
        if not result.size:
            continue
        directions, at = ways(name, function), arguments(name, function, state)
        wrt = tuple(directions)
        columns = model.derivative(function, wrt=wrt)(**at)
        weights = np.random.default_rng(1).uniform(-1, 1, result.size)
        products = model.vjp(function, wrt=wrt)(**at, weights=weights)
        for block, D, product in zip(wrt, columns, products, strict=True):
            way = directions[block]
            D = np.reshape(D, (result.size, way.size))
            expected, off = along(name, function, block, way)
            error = missing(expected, off, (D @ way)[None], np.abs(D * way).max(initial=0))
            assert np.isnan(error) or error <= BOUND, (function, block)
            # differences that rounding blurs say nothing
            compared |= set() if np.isnan(error) else {(function, block)}
            size = np.abs(weights[:, None] * D).max(initial=1e-30)
            assert np.abs(weights @ D - product).max() <= ROUNDING * size, (function, block)
            direction = way if block != "t" else float(way[0])
            change = np.ravel(model.jvp(function, wrt=block)(**at, direction=direction))
            size = np.abs(D * way).max(initial=1e-30) + 1e-5 * np.abs(result).max()
            assert np.abs(change - D @ way).max() <= ROUNDING * size, (function, block)
    assert compared >= {("forward_dynamics", "q"), ("rhs", "u"), ("energy", "q")}


def available(model: cd.CompiledModel, function: str) -> bool:
    """Some functions need constraints; superelements have some."""
    if model.manifest.superelements and function in ("momentum", "power"):
        return False
    return bool(model.manifest.multipliers) or "constraints" not in FUNCTIONS[function].needs


def test_single_names() -> None:
    """A parameter or an input by name is a column of its block."""
    name = "rubber, nodes"
    model, state = model_of(name), arguments(name, "rhs", state_of(name))
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


def test_superelements_have_derivatives_of_forces_and_energies() -> None:
    model = model_of("superelement, damped chord")
    with pytest.raises(DerivationError, match="none of momentum"):
        model.vjp("momentum", wrt="q")(*model.split(model.initial()), np.ones(6))


@each(
    "ask, words",
    [(lambda m, q, u: m.derivative(("pose", "tip"), wrt="q")(q), "output of the scene")],
)
def test_refused(ask: Any, words: str) -> None:
    model = model_of("rubber, nodes")
    with pytest.raises(ModelError, match=words):
        ask(model, *model.split(model.initial()))
