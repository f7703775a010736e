"""The quick way into derivatives and their products: the same results and errors as the general
one, arrays of their own in every call, also among threads and after parameters have changed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError, ModelError, SolveError
from laws.cases import compiled, states
from mechanisms import ZOO
from table import each

FUNCTIONS = ("forward_dynamics", "mass_matrix", "energy")
WRTS: tuple[Any, ...] = (("q", "u"), ("u", "q"), ("q", "q"), ("q",), "q", ["u", "q"])


@pytest.fixture(scope="module")
def model() -> Any:
    return compiled("springs")


def state() -> tuple[np.ndarray, np.ndarray]:
    q, u = states("springs")
    return q[0].copy(), u[0].copy()


def arrays(result: Any) -> list[np.ndarray]:
    return [*result] if isinstance(result, tuple) else [result]


def products(model: Any) -> Iterator[tuple[str, Callable[..., Any], list[np.ndarray], Any]]:
    """Name, what is called, states and what is handed over after them."""
    q, u = state()
    rng = np.random.default_rng(2)
    of_result = {"forward_dynamics": (model.nu,), "mass_matrix": (model.nu,) * 2, "energy": (3,)}
    for name in FUNCTIONS:
        at = [q] if name == "mass_matrix" else [q, u]
        for wrt in WRTS if name != "mass_matrix" else ("q", ("q",)):
            weights = rng.uniform(-1, 1, of_result[name])
            one = isinstance(wrt, str)
            direction: Any = rng.uniform(-1, 1, model.nu)
            direction = direction if one else [rng.uniform(-1, 1, model.nu) for _ in wrt]
            yield f"d {name} {wrt}", model.derivative(name, wrt=wrt), at, None
            yield f"vjp {name} {wrt}", model.vjp(name, wrt=wrt), at, ("weights", weights)
            if one or len(set(wrt)) == len(wrt):
                yield f"jvp {name} {wrt}", model.jvp(name, wrt=wrt), at, ("direction", direction)
                hessian = model.hessian(name, wrt=wrt)
                yield f"hessian {name} {wrt}", hessian, at, ("weights", weights)


def slow(function: Any, names: tuple[str, ...], at: list[Any], more: Any) -> list[np.ndarray]:
    """Results of the general way, which takes parameters."""
    keywords = dict(zip(names, at, strict=False)) | ({} if more is None else dict([more]))
    return arrays(function(**keywords, parameters={}))


def test_quick_and_general_calls_have_equal_bits(model: Any) -> None:
    for name, function, at, more in products(model):
        general = slow(function, ("q", "u"), at, more)
        handed = [] if more is None else [more[1]]
        by_name = {} if more is None else dict([more])
        for found in (function(*at, *handed), function(*at, **by_name), function(*at, *handed)):
            quick = arrays(found)
            assert [x.shape for x in quick] == [x.shape for x in general], name
            assert [x.tobytes() for x in quick] == [x.tobytes() for x in general], name
        lists = [x.tolist() for x in at]
        assert np.array_equal(arrays(function(*lists, *handed))[0], general[0]), name


def test_few_and_many_states_have_the_bits_of_each(model: Any) -> None:
    q, u = states("springs")
    rng = np.random.default_rng(3)
    q, u = (
        np.array([x[0] + rng.uniform(-0.1, 0.1, x[0].shape) for _ in range(50)]) for x in (q, u)
    )
    weights = rng.uniform(-1, 1, (50, model.nu))
    derivative = model.derivative("forward_dynamics", wrt=("u", "q"))
    product = model.vjp("forward_dynamics", wrt=("u", "q"))
    for count in (1, 10, 31, 32, 39, 40, 41, 50):
        many = derivative(q[:count], u[:count])
        gradients = product(q[:count], u[:count], weights[:count])
        for k in (0, count - 1):
            assert [x[k].tobytes() for x in many] == [x.tobytes() for x in derivative(q[k], u[k])]
            one = product(q[k], u[k], weights[k])
            assert [x[k].tobytes() for x in gradients] == [x.tobytes() for x in one]


def test_results_are_nobody_elses(model: Any) -> None:
    for name, function, at, more in products(model):
        handed = [] if more is None else [more[1]]
        first = arrays(function(*at, *handed))
        kept = [x.copy() for x in first]
        second = arrays(function(*at, *handed))
        given = [*at, *(x for x in handed for x in (x if isinstance(x, list) else [x]))]
        for k, x in enumerate(first):
            others = [*second, *given, *first[:k], *first[k + 1 :]]
            assert not any(np.may_share_memory(x, y) for y in others), name
        for x in second:
            x[...] = np.nan
        function(*[x + 0.1 for x in at], *handed)
        assert all(np.array_equal(x, y) for x, y in zip(first, kept, strict=True)), name


def test_requests_may_come_as_any_list_of_names(model: Any) -> None:
    for ask in (model.derivative, model.jvp, model.vjp, model.hessian):
        expected = ask("forward_dynamics", wrt=("u", "q")).wrt
        for wrt in (["u", "q"], np.array(["u", "q"]), iter(["u", "q"]), {"u": 1, "q": 2}.keys()):
            assert ask("forward_dynamics", wrt=wrt).wrt == expected
        for names in ({"u", "q"}, frozenset(["u", "q"])):
            with pytest.raises(ArgumentError, match="a set has none"):
                ask("forward_dynamics", wrt=names)


@each("name, options", [("springs", {}), ("springs", {"coordinates": "absolute"})])
def test_results_may_go_where_arguments_are(name: str, options: dict[str, Any]) -> None:
    """The array of results begins with an argument, or some numbers behind its first."""
    model: Any = cd.compile(ZOO[name].build(), **options)
    for shape in ((), (3,), (40,)):
        q, u = model.split(model.random_state(1, shape))
        for function in ("qdot", "forward_dynamics", "momentum", "mass_matrix"):
            call = getattr(model, function)
            at = [q] if function == "mass_matrix" else [q, u]
            expected = call(*[x.copy() for x in at])
            for k, argument in enumerate(at):
                for shift in (0, 1, argument.size // 2):
                    shared = np.zeros(shift + max(argument.size, expected.size))
                    values = [x.copy() for x in at]
                    values[k] = shared[: argument.size].reshape(argument.shape)
                    values[k][...] = argument
                    out = shared[shift : shift + expected.size].reshape(expected.shape)
                    assert call(*values, out=out) is out
                    assert np.array_equal(out, expected), (function, shape, k, shift)


def test_threads_get_their_own_results(model: Any) -> None:
    q, u = state()
    rng = np.random.default_rng(5)
    places = q + rng.uniform(-0.1, 0.1, (400, len(q)))
    function = model.derivative("forward_dynamics", wrt=("q", "u"))
    product = model.jvp("forward_dynamics", wrt=("q", "u"))
    expected = [[x.copy() for x in function(place, u)] for place in places]
    changes = [product(place, u, (u, u)) for place in places]

    def one(start: int) -> bool:
        same = True
        for k in range(start, 400, 8):
            found = model.derivative("forward_dynamics", wrt=("q", "u"))(places[k], u)
            same &= all(np.array_equal(a, b) for a, b in zip(found, expected[k], strict=True))
            same &= np.array_equal(product(places[k], u, (u, u)), changes[k])
        return same

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(one, range(8)))


def test_a_model_with_other_parameters_has_its_own_derivatives(model: Any) -> None:
    q, u = state()
    name = next(n for n in model.parameters if n.endswith("mass"))
    values = {name: 2.5 * model.parameters[name]}
    before = model.derivative("forward_dynamics", wrt=("q", "u"))(q, u)
    other = model.with_parameters(values)
    changed = other.derivative("forward_dynamics", wrt=("q", "u"))(q, u)
    general = model.derivative("forward_dynamics", wrt=("q", "u"))(q, u, parameters=values)
    assert [x.tobytes() for x in changed] == [x.tobytes() for x in general]
    assert not np.array_equal(changed[0], before[0])
    again = model.derivative("forward_dynamics", wrt=("q", "u"))(q, u)
    assert [x.tobytes() for x in again] == [x.tobytes() for x in before]


def test_what_is_asked_for_is_told_from_equal_names(model: Any) -> None:
    # everything that the function reads, and the same names given
    assert model.derivative("mass_matrix").wrt == ("q", "r", "p")
    with pytest.raises(ArgumentError, match="mass_matrix does not read u"):
        model.derivative("mass_matrix", wrt=("q", "u", "r", "p"))
    assert model.derivative("mass_matrix") is model.derivative("mass_matrix")
    wrt = ["q", "u"]
    first = model.derivative("forward_dynamics", wrt)
    wrt[1] = "tau"
    assert first.wrt == ("q", "u")
    assert model.derivative("forward_dynamics", wrt).wrt == ("q", "tau")
    # one name alone and a row of one
    assert model.derivative("forward_dynamics", "q") is not model.derivative(
        "forward_dynamics", ("q",)
    )
    with pytest.raises(ArgumentError, match="no such argument"):
        model.derivative("mass_matrix", to=("q",))


MISTAKES = (
    (lambda f, q, u: f(q), ArgumentError, "needs u="),
    (lambda f, q, u: f(q, u, u), ArgumentError, r"takes q, u in this order and the rest by name"),
    (lambda f, q, u: f(q, u, u=u), ArgumentError, "u is given twice"),
    (lambda f, q, u: f(q, u, tua=u), ArgumentError, "tua is none of its arguments"),
    (lambda f, q, u: f(q[:-1], u), ArgumentError, "q has shape"),
    (lambda f, q, u: f(q.astype(complex), u), ArgumentError, "real numbers"),
    (lambda f, q, u: f(np.full_like(q, np.nan), u), SolveError, "is nan"),
    (lambda f, q, u: f(q, u, tau=np.full_like(u, np.inf)), SolveError, "is inf"),
    (lambda f, q, u: f({"nobody": 1.0}, u), ModelError, "does not exist"),
    (lambda f, q, u: f(q, u, out=np.zeros(3)), ArgumentError, "out holds"),
)


@each("call, error, message", MISTAKES)
def test_mistakes_are_named(call: Any, error: type[Exception], message: str) -> None:
    q, u = state()
    function = compiled("springs").derivative("forward_dynamics", wrt=("q", "u"))
    with pytest.raises(error, match=message):
        call(function, q, u)


PRODUCTS = (
    (lambda m, q, u: m.vjp("forward_dynamics", "q")(q, u), "needs weights="),
    (lambda m, q, u: m.vjp("forward_dynamics", "q")(q, u, u[:-1]), "weights has shape"),
    (lambda m, q, u: m.vjp("mass_matrix", "q")(q, np.ones(len(u) ** 2)), "weights has shape"),
    (lambda m, q, u: m.jvp("forward_dynamics", ("q", "u"))(q, u, (u,)), "one array for each"),
    (lambda m, q, u: m.jvp("forward_dynamics", ("q", "u"))(q, u, (u, u[:-1])), "has shape"),
    (lambda m, q, u: m.jvp("forward_dynamics", ("q", "u"))(q, u, (u, 1.0)), "has shape"),
    (lambda m, q, u: m.hessian("forward_dynamics", "q")(q, u, wrenches={}), "wrenches have none"),
)


@each("call, message", PRODUCTS)
def test_mistakes_in_products_are_named(call: Any, message: str) -> None:
    with pytest.raises(ArgumentError, match=message):
        call(compiled("springs"), *state())
