"""Calls: shapes, broadcasting, out=, names, errors, threads; ctypes and the extension alike."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from cardan.api.compiled_model import CompiledModel
from cardan.errors import ArgumentError, CardanError, ModelError, SolveError, SolveWarning
from cardan.runtime.calls import batch
from runtime import pendulum
from runtime.conftest import WAYS, use

M, L, G = 2.0, 0.5, 9.81
pytestmark = pytest.mark.usefixtures("way")


def udot(q, tau=0.0):
    return tau / (M * L * L) - G / L * np.sin(q)


def test_one_state(model):
    found = model.forward_dynamics(np.array([0.3]), np.array([0.0]), tau=np.array([2.0]))
    assert found.shape == (1,)
    assert abs(found[0] - udot(0.3, 2.0)) < 1e-15 * 20


@pytest.mark.parametrize("given", [[0.3], (0.3,), np.array([0.3], np.float32), np.float64([0.3])])
def test_anything_like_an_array(model, given):
    expected = udot(np.float64(np.asarray(given)[0]))
    assert np.allclose(model.forward_dynamics(given, [0]), expected, rtol=1e-15, atol=0)


def test_integers_and_views(model):
    q = np.array([[1, 7], [2, 7]])[:, :1]
    assert np.allclose(model.forward_dynamics(q, [0]), udot(q), rtol=1e-14, atol=0)
    wide = np.linspace(0, 1, 6).reshape(3, 2)[:, ::2]
    assert np.allclose(model.forward_dynamics(wide, [0.0]), udot(wide), rtol=1e-14, atol=0)


@pytest.mark.parametrize(
    ("q", "tau", "lead"),
    [
        ((5, 1), (1,), (5,)),
        ((1,), (4, 1), (4,)),
        ((3, 1, 1), (1, 4, 1), (3, 4)),
        ((0, 1), (1,), (0,)),
    ],
)
def test_leading_axes_broadcast(model, q, tau, lead):
    rng = np.random.default_rng(3)
    qs, taus = rng.uniform(-1, 1, q), rng.uniform(-1, 1, tau)
    found = model.forward_dynamics(qs, [0.0], tau=taus)
    assert found.shape == (*lead, 1)
    assert np.allclose(found, udot(qs, taus), rtol=1e-13, atol=0)


def test_result_has_the_batch_of_arguments_the_c_does_not_read(model):
    assert model.mass_matrix(np.zeros((6, 1))).shape == (6, 1, 1)


def test_every_call_returns_a_fresh_array(model):
    q, u = np.array([0.3]), np.array([0.0])
    first = model.forward_dynamics(q, u)
    second = model.forward_dynamics(q, u)
    assert first is not second
    second[0] = 9
    assert first[0] != 9


@pytest.mark.parametrize("lead", [(), (3,)])
def test_out_is_filled_and_returned(model, lead):
    out = np.full((*lead, 1), np.nan)
    q = np.full((*lead, 1), 0.3)
    assert model.forward_dynamics(q, [0.0], out=out) is out
    assert np.allclose(out, udot(0.3), rtol=1e-14, atol=0)


def test_out_may_be_strided_but_must_fit(model):
    wide = np.zeros((3, 2))
    model.forward_dynamics(np.full((3, 1), 0.3), [0.0], out=wide[:, 1:])
    assert np.allclose(wide[:, 1], udot(0.3), rtol=1e-14, atol=0)
    assert not wide[:, 0].any()
    with pytest.raises(ValueError, match=r"out has shape \(2,\) of float64, expected \(1,\)"):
        model.forward_dynamics([0.3], [0.0], out=np.zeros(2))
    with pytest.raises(ValueError, match=r"out has shape .* compile\(dtype='float32'\)"):
        model.forward_dynamics([0.3], [0.0], out=np.zeros(1, np.float32))


def test_rhs_splits_the_state(model):
    assert np.array_equal(model.rhs(0.0, np.array([0.3, 2.0])), [2.0, udot(0.3)])
    assert model.rhs(np.zeros(4), np.zeros(2)).shape == (4, 2)


def test_several_results_have_names(model):
    energy = model.energy(np.full((2, 1), 0.3), [2.0])
    assert np.allclose(energy.kinetic, 0.5 * M * L * L * 4, rtol=1e-15)
    assert np.allclose(energy.total, energy.kinetic - M * G * L * np.cos(0.3), rtol=1e-15)
    assert energy.total.shape == (2,)


def test_frames_and_wrenches(model):
    assert np.allclose(model.pose("bob", [0.3])[:3, 2], [np.sin(0.3), 0, np.cos(0.3)])
    pushed = model.forward_dynamics([0.3], [0.0], wrenches={"tip": [0, 0, 0, 3.0, 0, 0]})
    assert np.allclose(pushed, udot(0.3, -3.0 * L * np.cos(0.3)), rtol=1e-14)
    held = model.inverse_dynamics([0.3], [0.0], pushed, wrenches={"tip": [0, 0, 0, 3.0, 0, 0]})
    assert abs(held[0]) < 1e-13
    rate = model.rhs(0.0, [0.3, 0.0], wrenches={"tip": [0, 0, 0, 3.0, 0, 0]})
    assert np.allclose(rate, [0.0, pushed[0]], rtol=1e-14)


def test_vectors_by_name(model):
    found = model.forward_dynamics({"swing": 0.3}, {}, tau={"swing": 2.0})
    assert np.allclose(found, udot(0.3, 2.0), rtol=1e-14)
    many = model.forward_dynamics({"swing": np.linspace(0, 1, 5)}, {"swing.u": 1.0})
    assert np.allclose(many[:, 0], udot(np.linspace(0, 1, 5)), rtol=1e-14)


def test_parameter_values_of_a_call(model):
    found = model.forward_dynamics([0.3], [0.0], parameters={"l": np.array([0.5, 1.0, 2.0])})
    assert np.allclose(found[:, 0], -G / np.array([0.5, 1.0, 2.0]) * np.sin(0.3), rtol=1e-14)
    one = model.forward_dynamics([0.3], [0.0], parameters={"l": 1.0})
    assert one.shape == (1,)


def test_parameter_values_that_come_again_give_the_bits_of_the_first_call(model):
    values = {"l": 1.3}
    calls = [model.forward_dynamics([0.3], [0.0], parameters=values) for _ in range(4)]
    assert np.allclose(calls[0], -G / 1.3 * np.sin(0.3), rtol=1e-14)
    assert len({call.tobytes() for call in calls}) == 1
    # other functions, other values in the same dict, and the values of the model
    assert abs(model.energy([0.3], [0.0], parameters=values)[2]) > 0
    values["l"] = 0.7
    for _ in range(3):
        found = model.forward_dynamics([0.3], [0.0], parameters=values)
        assert np.allclose(found, -G / 0.7 * np.sin(0.3), rtol=1e-14)
    assert np.allclose(model.forward_dynamics([0.3], [0.0]), udot(0.3), rtol=1e-14)


@pytest.mark.parametrize("bad", [{"length": 1.0}, {"l": float("nan")}, {"l": float("inf")}])
def test_bad_parameter_values_are_refused_every_time(model, bad):
    for _ in range(4):
        with pytest.raises(ModelError, match=r"parameter 'l"):
            model.forward_dynamics([0.3], [0.0], parameters=bad)


BAD = {
    ValueError: [
        (
            lambda m: m.forward_dynamics([0.1, 0.2], [0.0]),
            r"forward_dynamics: q has shape \(2,\), expected \(\.\.\., 1\): coordinates swing",
        ),
        (
            lambda m: m.forward_dynamics([0.1], np.zeros((3, 2))),
            r"u has shape \(3, 2\), expected \(\.\.\., 1\): speeds swing\.u",
        ),
        (lambda m: m.rhs(0.0, [0.1]), r"x has shape \(1,\), expected \(\.\.\., 2\)"),
        (
            lambda m: m.forward_dynamics(np.zeros((3, 1)), np.zeros((4, 1))),
            r"leading axes do not broadcast together: q \(3,\), u \(4,\)",
        ),
        (
            lambda m: m.forward_dynamics([0.1], [0.0], wrenches={"tip": [0] * 3}),
            r"wrenches: 'tip' has shape \(3,\)",
        ),
    ],
    TypeError: [
        (lambda m: m.forward_dynamics(["a"], [0.0]), "q must be real numbers"),
        (lambda m: m.forward_dynamics([0.3 + 1j], [0.0]), "q must be real numbers"),
        (lambda m: m.forward_dynamics(None, [0.0]), "forward_dynamics needs q="),
    ],
    SolveError: [
        (lambda m: m.forward_dynamics([np.nan], [0.0]), "q of swing is nan"),
        (lambda m: m.forward_dynamics(np.array([np.nan]), np.array([0.0])), "swing is nan"),
        (lambda m: m.forward_dynamics([[0.1], [np.inf]], [0.0]), "swing is inf at state 1"),
        (lambda m: m.rhs(np.nan, [0.1, 0.2]), "rhs: t is nan"),
    ],
    ModelError: [
        (lambda m: m.forward_dynamics({"swign": 0.1}, {}), "Did you mean 'swing'"),
        (lambda m: m.pose("bop", [0.1]), r"frame 'bop' does not exist.*Did you mean 'bob'"),
        (lambda m: m.reaction("swin", [0.1], [0.0]), r"joint 'swin'.*mean 'swing'"),
        (lambda m: m.com([0.1]), r"without 'com'.*functions=\(\.\.\., 'com'\)"),
        (lambda m: m.forward_dynamics([0.1], [0.0], wrenches={"tap": [0] * 6}), "'tip'"),
        (lambda m: m.forward_dynamics([0.1], [0.0], parameters={"mm": 1}), "Known: m, l"),
        (lambda m: m.with_parameters({"swing.axis.y": -1}), r"structural.*Declare"),
        (lambda m: m.with_parameters(m=np.nan), "'m' must be finite"),
    ],
}


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [(call, error, message) for error, rows in BAD.items() for call, message in rows],
)
def test_bad_input_is_named(model, call, error, message):
    with pytest.raises(error, match=message):
        call(model)


def test_one_state_without_result_raises_a_batch_warns(model):
    assert model.outputs([0.5], [0.0])[0] == 2.0
    with pytest.raises(SolveError, match=r"outputs has no finite result for hinge"):
        model.outputs([0.0], [0.0])
    with pytest.raises(SolveError, match=r"status 7"):
        model.outputs(np.array([4.0]), np.array([0.0]))
    with pytest.warns(SolveWarning, match=r"hinge.*at state 1; 2 of 4 states"):
        found = model.outputs([[0.5], [0.0], [1.0], [0.0]], [0.0])
    assert np.array_equal(found[:, 0], [2.0, np.inf, 1.0, np.inf])
    with pytest.warns(SolveWarning, match=r"status 7.*state 1; 2 of 3 states"):
        found = model.outputs([[0.5], [4.0], [5.0]], [0.0])
    assert np.array_equal(found[:, 0], [2.0, np.nan, np.nan], equal_nan=True)


def test_a_few_states_have_the_bits_of_each(model):
    rng = np.random.default_rng(4)
    q, u = rng.uniform(-1, 1, (2, 7, 1))
    times = np.linspace(0, 1, 7)
    expected = np.array([model.forward_dynamics(*pair) for pair in zip(q, u, strict=True)])
    assert model.forward_dynamics(q, u).tobytes() == expected.tobytes()
    # one of them for all states, as an array or as a list, and a time for each
    for one in (u[0], u[0].tolist()):
        rows = model.forward_dynamics(q, one, t=times)
        assert rows.tobytes() == np.array([model.forward_dynamics(x, u[0]) for x in q]).tobytes()
    assert model.rhs(times, np.hstack([q, u])).shape == (7, 2)
    # whatever is no plain batch
    assert model.forward_dynamics(q[:1], u).tobytes() == model.forward_dynamics(q[0], u).tobytes()
    assert np.array_equal(model.forward_dynamics(q[::2], u[::2]), expected[::2])
    assert model.forward_dynamics(np.asfortranarray(q), u.astype(">f8")).shape == (7, 1)


@pytest.mark.parametrize("number", [2, np.int64(2), True, np.float64(2.0), 2.0])
def test_numbers_of_any_kind(model, number):
    for value in ([number], (number,), {"swing": number}):
        assert model.forward_dynamics(value, [0], t=number) == udot(float(number))
    with pytest.raises(SolveError, match="swing is inf"):
        model.forward_dynamics([np.inf], [0])
    with pytest.raises(ArgumentError, match="real numbers"):
        model.forward_dynamics([10**400], [0])


def test_long_batches_run_in_pieces(model, monkeypatch):
    q = np.linspace(-1, 1, 50)[:, None]
    expected = model.forward_dynamics(q, [0.0], tau=q)
    monkeypatch.setattr(batch, "FIRST", 7)
    monkeypatch.setattr(batch, "CHUNK_SECONDS", 0.0)
    assert np.array_equal(model.forward_dynamics(q, [0.0], tau=q), expected)
    with pytest.warns(SolveWarning, match=r"status 7.*state 30; 1 of 40"):
        model.outputs(np.where(np.arange(40) == 30, 4.0, 1.0)[:, None], [0.0])


def test_threads_get_their_own_results(model):
    q = np.linspace(-2, 2, 400)[:, None]
    expected = model.energy(q, np.ones(1)).total

    def one(k: int) -> bool:
        rows = [model.energy(q[i], np.ones(1)).total for i in range(k, 400, 8)]
        return np.array_equal(rows, expected[k::8])

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(one, range(8)))


def test_threads_may_ask_first_for_different_functions(directory):
    model = CompiledModel(directory)
    names = ["rhs", "forward_dynamics", "inverse_dynamics", "mass_matrix", "qdot", "energy"]
    with ThreadPoolExecutor(6) as pool:
        loaded = list(pool.map(model._function, names * 3))
    assert {f.symbol for f in loaded} == set(names)
    assert all(f.address for f in loaded)


def test_functions_compiled_side_by_side(directory):
    model = CompiledModel(directory)
    model.prepare("rhs", ("pose", "bob"))
    assert set(model._functions) == {("rhs", None), ("pose", "bob")}
    model.prepare()
    assert len(model._functions) == len(pendulum.FUNCTIONS)


@pytest.mark.skipif(len(WAYS) < 2, reason="the extension is not built")
def test_ctypes_and_extension_give_equal_bits(directory, monkeypatch):
    rng = np.random.default_rng(5)
    q, u, tau = rng.uniform(-2, 2, (3, 50, 1))
    results = []
    for name in WAYS:
        use(name, monkeypatch)
        model = CompiledModel(directory)
        rows = [model.forward_dynamics(a, b, tau=c) for a, b, c in zip(q, u, tau, strict=True)]
        results.append([*rows, model.forward_dynamics(q, u, tau=tau), model.pose("bob", q)])
    for a, b in zip(*results, strict=True):
        assert a.tobytes() == b.tobytes()


MISTAKES = [
    (lambda m: m.rhs(0.0, [1.0]), r"rhs: x has shape \(1,\), expected \(\.\.\., 2\)"),
    (lambda m: m.rhs(0.0, None), r"rhs needs x="),
    (lambda m: m.rhs(0.0, ["a", "b"]), r"rhs: x must be real numbers"),
    (lambda m: m.rhs(0.0, [[1.0], [1.0, 2.0]]), r"rhs: x: its rows have different lengths"),
    (lambda m: m.rhs(0.0, [1j, 0]), r"x must be real numbers, not complex"),
    (
        lambda m: m.rhs(np.zeros(3), np.zeros((2, 2))),
        r"rhs: leading axes do not broadcast together: t \(3,\), x \(2,\)",
    ),
    (lambda m: m.rhs(0.0, [1.0, 2.0], out=np.zeros(3)), r"rhs: out has shape \(3,\)"),
    (lambda m: m.split(3.0), r"x has shape \(\), expected \(\.\.\., 2\)"),
    (lambda m: m.split("x"), r"x must be real numbers"),
    (lambda m: m.with_parameters(m="heavy"), r"parameter 'm' must be real numbers"),
    (
        lambda m: m.energy([0.1], [0.1], parameters={"m": [1, 2], "l": [1, 2, 3]}),
        r"parameters: leading axes do not broadcast",
    ),
    (
        lambda m: m.mass_matrix(np.broadcast_to(0.0, (2**59, 1))),
        r"mass_matrix: so many states do not fit into memory",
    ),
    (lambda m: m.simulate("soon"), r"t='soon': give a number"),
    (lambda m: m.simulate(1.0, x0=[1.0]), r"x0 has shape \(1,\), expected \(2,\)"),
    (lambda m: m.simulate(1.0, x0="rest"), r"x0='rest': give .*real numbers"),
]


@pytest.mark.parametrize(("call", "text"), MISTAKES)
def test_mistakes_are_our_errors_and_those_of_numpy_users(model, call, text):
    """One of ours, and still what code written for NumPy catches."""
    with pytest.raises(ArgumentError, match=text) as told:
        call(model)
    assert isinstance(told.value, CardanError)
    assert isinstance(told.value, ValueError)
    assert isinstance(told.value, TypeError)
