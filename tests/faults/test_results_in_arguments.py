"""Results written to arrays that are read: ``out`` may be an argument, or a part of one."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import cardan as cd
from mechanisms.chain import chain
from table import each

SIZES = {"unrolled": 4, "loops over bodies": 60}
Call = Callable[..., np.ndarray]


@pytest.fixture(scope="module")
def models() -> dict[str, cd.CompiledModel]:
    return {name: cd.compile(chain(n), loops=n > 10 or None) for name, n in SIZES.items()}


def calls(model: cd.CompiledModel) -> dict[str, tuple[Call, list[np.ndarray]]]:
    """Functions of arrays and ``out``, and the arrays."""
    n = model.nu
    q, u, tau, udot = np.random.default_rng(4).uniform(-1, 1, (4, n))
    return {
        "rhs": (lambda x, out: model.rhs(0.0, x, out=out), [np.concatenate([q, u])]),
        "forward": (
            lambda q, u, tau, out: model.forward_dynamics(q, u, tau=tau, out=out),
            [q, u, tau],
        ),
        "inverse": (lambda *x, out: model.inverse_dynamics(*x, out=out), [q, u, udot]),
    }


@each("size", SIZES)
def test_results_in_place(size: str, models: dict[str, cd.CompiledModel]) -> None:
    """rhs(t, x, out=x) of long chains was wrong: loops wrote rates over speeds not read yet."""
    for name, (call, arrays) in calls(models[size]).items():
        exact = call(*arrays, out=None)
        assert np.isfinite(exact).all()
        for batch in (0, 1, 3, 70):
            shape = (batch,) if batch else ()
            expected = np.broadcast_to(exact, (*shape, *exact.shape))
            for k in range(len(arrays)):
                # the same array, and one that begins an entry later or earlier
                for shift in (0, 1, -1):
                    states = [np.broadcast_to(x, (*shape, *x.shape)).copy() for x in arrays]
                    memory = np.zeros(states[k].size + 2)
                    place = memory[1 : 1 + states[k].size]
                    place[:] = states[k].reshape(-1)
                    states[k] = place.reshape(states[k].shape)
                    out = memory[1 + shift :][: expected.size].reshape(expected.shape)
                    result = call(*states, out=out)
                    assert result is out
                    assert result.tobytes() == expected.tobytes(), (name, batch, k, shift)


def test_arguments_survive_a_result_that_is_not_finite(models: dict[str, cd.CompiledModel]) -> None:
    """The error named the argument, which held what the function had written over it."""
    model = models["unrolled"]
    q, u = np.full(4, 0.3), np.full(4, 1e200)
    with pytest.raises(cd.SolveError, match="no finite result"):
        model.forward_dynamics(q, u, out=u)
    assert np.array_equal(u, np.full(4, 1e200))


def test_arrays_for_results_are_checked(models: dict[str, cd.CompiledModel]) -> None:
    """Results under wrenches were cut off to whole numbers in silence, or an AttributeError."""
    model = models["unrolled"]
    q, u = np.full((2, 4), 0.3)
    locked = np.zeros(4)
    locked.flags.writeable = False
    body = next(iter(model.manifest.bodies)).name
    usual: Call = lambda out: model.forward_dynamics(q, u, out=out)  # noqa: E731
    pushed: Call = lambda out: model.forward_dynamics(  # noqa: E731
        q, u, wrenches={body: np.ones(6)}, out=out
    )
    for call in (usual, pushed):
        assert np.array_equal(call(np.empty(4)), call(None))
        for out in ([0.0] * 4, np.empty(4, int), np.empty(4, np.float32), np.empty(3), locked):
            with pytest.raises(cd.ArgumentError, match=r"out (is read-only|has shape)"):
                call(out)


def test_masked_entries_are_refused(models: dict[str, cd.CompiledModel]) -> None:
    """What the mask hides was read as if it were a state."""
    model, u = models["unrolled"], np.zeros(4)
    q = np.ma.masked_array(np.full(4, 0.3), [0, 1, 0, 0])
    with pytest.raises(cd.ArgumentError, match="q has masked entries"):
        model.forward_dynamics(q, u)
    assert model.forward_dynamics(np.ma.masked_array(q.data), u).shape == (4,)
