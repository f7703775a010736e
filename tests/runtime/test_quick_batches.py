"""Batches that the extension hands to a lane build at once: the bits and the errors of the general
way, however arrays lie in memory, and that way wherever something is not plain.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError, SolveError, SolveWarning
from laws.cases import compiled, derived, states
from table import each

abi = pytest.importorskip("cardan.runtime.calls._abi")
Array = np.ndarray
COUNTS = (1, 2, 15, 16, 17, 31, 64, 301)
NAME = "forward_dynamics"


class Watched:
    """The general way into a function, which counts how often it is taken."""

    def __init__(self, caller: Any) -> None:
        self.caller = caller
        self.taken = 0

    def __getattr__(self, name: str) -> Any:
        return getattr(self.caller, name)

    def __call__(self, *values: Any) -> Array:
        self.taken += 1
        found: Array = self.caller(*values)
        return found


@pytest.fixture(scope="module")
def model() -> Any:
    found = compiled("springs")
    found.prepare(NAME, batch=True)
    if found._function(NAME).caller.batch.lanes == 1:
        pytest.skip("no lanes here")
    return found


def arguments(model: Any, count: int) -> list[Array]:
    """q, u and tau of random states, in the order of the function with t left out."""
    rng = np.random.default_rng(count)
    q, u = (x[0] + rng.uniform(-0.1, 0.1, (count, len(x[0]))) for x in states("springs"))
    return [q, u, rng.uniform(-1, 1, (count, model.nu))]


def ways(model: Any) -> tuple[Any, Watched, dict[str, int]]:
    """The quick way into forward dynamics, the general one, and places of arguments."""
    watched = Watched(model._function(NAME).caller)
    places = {str(argument): k for k, argument in enumerate(watched.arguments)}
    return abi.Fast(watched), watched, places


def values(places: dict[str, int], q: Any, u: Any, tau: Any) -> list[Any]:
    """As the function takes them."""
    found: list[Any] = [None] * len(places)
    for name, value in (("q", q), ("u", u), ("tau", tau)):
        found[places[name]] = value
    return found


def columns(x: Array) -> Array:
    return np.asfortranarray(x)


def rows(x: Array) -> Array:
    return x


LAYOUTS: dict[str, tuple[Callable[[Array], Array], ...]] = {
    "rows": (rows, rows, rows),
    "columns": (columns, columns, columns),
    "rows and columns": (columns, rows, columns),
    "one for all states": (rows, lambda x: x[0], rows),
}


@each("layout", list(LAYOUTS))
def test_bits_are_those_of_the_general_way(model: Any, layout: str) -> None:
    fast, general, places = ways(model)
    for count in COUNTS:
        given = [lay(x) for lay, x in zip(LAYOUTS[layout], arguments(model, count), strict=True)]
        exact = general.caller(None, *values(places, *given))
        general.taken = 0
        found = fast(None, *values(places, *given))
        assert found.tobytes("A") == exact.tobytes("A")
        assert found.shape == exact.shape == (count, model.nu)
        assert found.flags.f_contiguous == exact.flags.f_contiguous
        if count >= 16 or layout == "rows":
            assert general.taken == 0, count
    # each state gives the bits of the batch
    q, u, tau = given
    one = [x if x.ndim == 1 else x[-1] for x in (q, u, tau)]
    assert fast(None, *values(places, *one)).tobytes() == np.ascontiguousarray(found[-1]).tobytes()


def test_results_go_where_they_are_wanted(model: Any) -> None:
    fast, general, places = ways(model)
    for count in (2, 40):
        given = arguments(model, count)
        exact = general.caller(None, *values(places, *given))
        out = np.full((count, model.nu), np.nan)
        assert fast(out, *values(places, *given)) is out
        assert general.taken == 0
        np.testing.assert_array_equal(out, exact)
        # into a column of a larger array, and over what is read
        wide = np.zeros((count, model.nu, 2))
        fast(wide[:, :, 1], *values(places, *given))
        np.testing.assert_array_equal(wide[:, :, 1], exact)
        assert not wide[:, :, 0].any()
        assert fast(given[2], *values(places, *given)) is given[2]
        np.testing.assert_array_equal(given[2], exact)
        shifted = np.empty(count * model.nu + 1)
        shifted[1:] = arguments(model, count)[2].reshape(-1)
        tau = shifted[1:].reshape(count, model.nu)
        fast(shifted[:-1].reshape(count, model.nu), *values(places, *given[:2], tau))
        np.testing.assert_array_equal(shifted[:-1].reshape(count, model.nu), exact)
        with pytest.raises(ArgumentError, match="out has shape"):
            fast(np.empty((count + 1, model.nu)), *values(places, *given))
        locked = np.empty((count, model.nu))
        locked.flags.writeable = False
        with pytest.raises((ArgumentError, ValueError)):
            fast(locked, *values(places, *given))
        general.taken = 0


@each("bad", [np.nan, np.inf, -np.inf])
def test_numbers_that_are_not_finite_are_named(model: Any, bad: float) -> None:
    fast, _, places = ways(model)
    for count in (2, 40):
        for lay in (rows, columns):
            for k in range(3):
                given = arguments(model, count)
                given[k][count - 1, -1] = bad
                with pytest.raises(SolveError, match=f"at state {count - 1}"):
                    fast(None, *values(places, *(lay(x) for x in given)))


def test_what_is_not_plain_takes_the_general_way(model: Any) -> None:
    fast, general, places = ways(model)
    q, u, tau = arguments(model, 40)
    exact = general.caller(None, *values(places, q, u, tau))
    other: list[tuple[Any, Any, Any]] = [
        (q.astype(">f8"), u, tau), (q[::-1][::-1], u, tau), (np.repeat(q, 2, 0)[::2], u, tau),
        (q.tolist(), u, tau), (q[None], u, tau),
    ]  # fmt: skip
    for given in other:
        found = fast(None, *values(places, *given))
        np.testing.assert_array_equal(np.reshape(found, (-1, model.nu))[:40], exact)
    for given in ((q[:39], u, tau), (q[:, :-1], u, tau), (np.empty((0, q.shape[1])), u, tau)):
        with pytest.raises(ArgumentError):
            fast(None, *values(places, *given))
    assert fast(None, *values(places, *(x[:0] for x in (q, u, tau)))).shape == (0, model.nu)
    # integers are numbers, and so are arrays of a subclass
    whole = np.zeros((40, model.nu), int)
    found = fast(None, *values(places, q, u, whole))
    np.testing.assert_array_equal(found, fast(None, *values(places, q, u, whole * 1.0)))


@each("layout", list(LAYOUTS))
def test_floats_have_the_bits_of_the_general_way(layout: str) -> None:
    model = cd.compile(derived("springs"), dtype="float32")
    model.prepare(NAME, batch=True)
    fast, general, places = ways(model)
    for count in COUNTS:
        given = [
            lay(x.astype(np.float32))
            for lay, x in zip(LAYOUTS[layout], arguments(model, count), strict=True)
        ]
        exact = general.caller(None, *values(places, *given))
        general.taken = 0
        found = fast(None, *values(places, *given))
        assert found.dtype == exact.dtype
        assert found.tobytes("A") == exact.tobytes("A")
        # what all states share is a double, which the general way makes a float
        assert general.taken == (count < 16 or layout == "one for all states")


def test_states_without_a_result_are_told_apart() -> None:
    # a body without mass that slides has no accelerations
    scene = cd.Scene("light")
    m = scene.parameter("m", 0.0, "kg")
    body = scene.body("body", mass=m, inertia=(0, 0, 0))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, body)
    model = cd.compile(scene)
    model.prepare(NAME, batch=True)
    zero = np.zeros((40, 1))
    with pytest.warns(SolveWarning, match="40 of 40 states failed"):
        assert not np.isfinite(model.forward_dynamics(zero, zero, tau=zero + 1.0)).any()


def test_batches_that_threads_share_take_the_general_way(model: Any) -> None:
    fast, general, places = ways(model)
    most = general.caller.batch.direct.most
    given = arguments(model, most + 1)
    exact = general.caller(None, *values(places, *given))
    general.caller.batch.direct = replace(general.caller.batch.direct, most=most)
    np.testing.assert_array_equal(fast(None, *values(places, *given)), exact)
    assert general.taken == 1
