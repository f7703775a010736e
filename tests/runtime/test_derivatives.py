"""Derivatives of a compiled model: shapes, names, wrenches, files."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError, CardanError, DerivationError, ModelError
from laws.cases import compiled, states
from mechanisms import ZOO

NAME = "springs"
STEP = 1e-6
# central differences: STEP^2 of third derivatives, eps / STEP of rounding
ROUGH = 1e-7


@pytest.fixture(scope="module")
def model() -> Any:
    return compiled(NAME)


@pytest.fixture(scope="module")
def state() -> tuple[np.ndarray, np.ndarray]:
    q, u = states(NAME)
    return q[0], u[0]


def test_one_array_per_block(model: Any, state: Any) -> None:
    q, u = state
    derivative = model.derivative("forward_dynamics")
    assert derivative.wrt == ("q", "u", "r", "p")
    by_q, by_u, by_r, by_p = derivative(q, u)
    nu = model.nu
    shapes = [x.shape for x in (by_q, by_u, by_r, by_p)]
    assert shapes == [(nu, nu), (nu, nu), (nu, model.nr), (nu, len(model.parameters))]
    assert sum(derivative.operations.values()) > 0


def test_leading_axes_broadcast(model: Any) -> None:
    q, u = states(NAME)
    derivative = model.derivative("forward_dynamics", wrt=("u", "q"))
    by_u, by_q = derivative(q[:, None], u[None, :3], t=0.2)
    assert by_q.shape == (len(q), 3, model.nu, model.nu)
    for k in range(3):
        one = derivative(q[k], u[1], t=0.2)
        np.testing.assert_array_equal(one[0], by_u[k, 1])
        np.testing.assert_array_equal(one[1], by_q[k, 1])


def test_arguments_by_place_and_by_name_give_the_same(model: Any, state: Any) -> None:
    (q, u), v = state, np.linspace(0.5, 1.5, model.nu)
    for ask, more in ((model.derivative, ()), (model.vjp, (v,))):
        for wrt in (("u", "q"), ("q", "q"), ("q",), "u"):
            function = ask("forward_dynamics", wrt=wrt)
            assert function is ask("forward_dynamics", wrt=wrt)
            named = {"weights": v} if more else {}
            results = function(q, u, *more), function(q=q, u=u, **named)
            lists = [np.ravel(x).tolist() for x in (q, u, *more)]
            results += (function(*lists), function(q, u, *more, t=0.0))
            for other in results[1:]:
                np.testing.assert_array_equal(np.array(other), np.array(results[0]))
    heavy = model.with_parameters({name: 2.0 for name in model.parameters if "mass" in name})
    changed = heavy.derivative("forward_dynamics", wrt="q")(q, u)
    assert not np.array_equal(changed, model.derivative("forward_dynamics", wrt="q")(q, u))


def test_results_go_where_they_are_wanted(model: Any, state: Any) -> None:
    nu = model.nu
    out = np.zeros((nu, nu)), np.zeros((nu, nu))
    derivative = model.derivative("inverse_dynamics", wrt=("u", "udot"))
    found = derivative(*state, np.ones(nu), out=out)
    assert found[0] is out[0]
    np.testing.assert_allclose(out[1], model.mass_matrix(state[0]), rtol=1e-13)
    with pytest.raises(ArgumentError, match="1 arrays, expected 2"):
        derivative(*state, np.ones(nu), out=out[:1])
    alone = model.derivative("inverse_dynamics", wrt="udot")(*state, np.ones(nu))
    np.testing.assert_allclose(alone, out[1], rtol=1e-15)


def test_single_names_have_no_axis(model: Any, state: Any) -> None:
    name = next(n for n in model.parameters if n.endswith("mass"))
    derivative = model.derivative("bias", wrt=(name, "t", "p"))
    by_mass, by_t, by_p = derivative(*state)
    assert by_mass.shape == by_t.shape == (model.nu,)
    np.testing.assert_allclose(by_mass, by_p[:, list(model.parameters).index(name)], rtol=1e-14)


def test_other_parameter_values(model: Any, state: Any) -> None:
    name = next(n for n in model.parameters if n.endswith("mass"))
    value = 1.7 * model.parameters[name]
    derivative = model.derivative("forward_dynamics", wrt="u")
    theirs = model.with_parameters({name: value}).derivative("forward_dynamics", wrt="u")
    np.testing.assert_array_equal(derivative(*state, parameters={name: value}), theirs(*state))


@pytest.mark.parametrize("function", ["forward_dynamics", "inverse_dynamics"])
@pytest.mark.parametrize("name", ["springs", "satellite", "crane"])
def test_wrenches_are_felt_through_their_frames(name: str, function: str) -> None:
    model = compiled(name)
    q, u = (x[0] for x in states(name))
    rng = np.random.default_rng(3)
    wrenches = {frame: rng.uniform(-1, 1, 6) for frame in model.frames[-2:]}
    more = (rng.uniform(-1, 1, model.nu),) if function == "inverse_dynamics" else ()
    names = ("q", "u", "p", "t")
    found = model.derivative(function, wrt=names)(q, u, *more, wrenches=wrenches, t=0.3)

    def call(q: Any, u: Any, **rest: Any) -> np.ndarray:
        value: np.ndarray = getattr(model, function)(q, u, *more, wrenches=wrenches, **rest)
        return value

    for k, step in enumerate(np.eye(model.nu) * STEP):
        ahead, behind = (call(model.integrate(q, s * step), u, t=0.3) for s in (1, -1))
        slope = (ahead - behind) / (2 * STEP)
        np.testing.assert_allclose(found[0][:, k], slope, rtol=ROUGH, atol=ROUGH * 100)
        ahead, behind = (call(q, u + s * step, t=0.3) for s in (1, -1))
        slope = (ahead - behind) / (2 * STEP)
        np.testing.assert_allclose(found[1][:, k], slope, rtol=ROUGH, atol=ROUGH * 100)
    for k, parameter in enumerate(model.parameters):
        value, h = model.parameters[parameter], STEP * max(1.0, abs(model.parameters[parameter]))
        sides = [call(q, u, t=0.3, parameters={parameter: value + s * h}) for s in (1, -1)]
        slope = (sides[0] - sides[1]) / (2 * h)
        np.testing.assert_allclose(found[2][:, k], slope, rtol=ROUGH, atol=ROUGH * 100)
    sides = [call(q, u, t=0.3 + s * STEP) for s in (1, -1)]
    slope = (sides[0] - sides[1]) / (2 * STEP)
    np.testing.assert_allclose(found[3], slope, rtol=ROUGH, atol=ROUGH * 100)


def test_rhs_takes_what_solvers_give(model: Any, state: Any) -> None:
    x = np.concatenate(state)
    by_q, by_t = model.derivative("rhs", wrt=("q", "t"))(0.1, x)
    assert by_q.shape == (model.nx, model.nu)
    udot = model.derivative("forward_dynamics", wrt="q")(*state, t=0.1)
    np.testing.assert_allclose(by_q[model.nq :], udot, rtol=1e-12)
    assert by_t.shape == (model.nx,)


def test_what_is_wrong_is_said(model: Any, state: Any) -> None:
    with pytest.raises(ModelError, match="Did you mean 'forward_dynamics'"):
        model.derivative("forward_dynamic")
    with pytest.raises(ModelError, match="derivative of 'integrate'"):
        model.derivative("integrate", wrt="q")
    with pytest.raises(ArgumentError, match="does not read udot"):
        model.derivative("bias", wrt="udot")
    with pytest.raises(ModelError, match="not a block"):
        model.derivative("bias", wrt="mas")
    with pytest.raises(ModelError, match="frame 'nowhere' does not exist"):
        model.derivative(("pose", "nowhere"), wrt="q")
    with pytest.raises(ModelError, match="needs a frame"):
        model.derivative("pose", wrt="q")
    with pytest.raises(ModelError, match="takes none"):
        model.derivative(("bias", "elbow"), wrt="q")
    bias = model.derivative("bias", wrt="q")
    with pytest.raises(ArgumentError, match="q, u in this order"):
        bias(*state, state[0])
    with pytest.raises(ArgumentError, match="tau is none of its arguments"):
        bias(*state, tau=state[1])
    with pytest.raises(ArgumentError, match="u is given twice"):
        bias(*state, u=state[1])
    with pytest.raises(ArgumentError, match="needs u="):
        bias(state[0])
    with pytest.raises(ArgumentError, match="wrenches go with"):
        bias(*state, wrenches={model.frames[-1]: np.zeros(6)})


def test_only_what_was_asked_for() -> None:
    model = cd.compile(ZOO["pendulum"].build(), functions=("bias",))
    with pytest.raises(DerivationError, match="'derivative' was not asked for"):
        model.derivative("bias", wrt="q")([0.1], [0.2])


def test_a_pickled_model_knows_what_was_used(model: Any, state: Any) -> None:
    used = model.derivative("forward_dynamics", wrt=("u", "q"))
    expected = used(*state)
    other = pickle.loads(pickle.dumps(model))
    # in any order of the blocks
    found = other.derivative("forward_dynamics", wrt=("q", "u"))(*state)
    np.testing.assert_allclose(found[1], expected[0], rtol=1e-13)
    with pytest.raises(ModelError, match="without"):
        other.derivative("energy", wrt="p")(*state)


def test_in_an_export(tmp_path: Path, model: Any) -> None:
    equations = cd.derive(ZOO["double_pendulum"].build())
    asked = [("derivative", "forward_dynamics: q u"), ("derivative", "energy: p"), "bias"]
    folder = equations.export(tmp_path / "out", functions=asked)
    assert (folder / "derivative__forward_dynamics_q_u.c").exists()
    text = (folder / "double_pendulum.pyx").read_text(encoding="utf-8")
    assert "def derivative__forward_dynamics_q_u(q, u, *, t=0.0, " in text
    entry = model.manifest["functions"]
    assert all(e["of"] for name, e in entry.items() if name.startswith("derivative__"))


@pytest.mark.parametrize("name", ["springs", "satellite", "crane"])
def test_frame_jacobians_in_both_axes(name: str) -> None:
    model = compiled(name)
    q, u = states(name)
    rest = model.frames[-1]
    for frame in {model.frames[0], rest}:
        for axes in ("ground", "frame"):
            jacobian = model.frame_jacobian(frame, q, in_=axes, t=0.3)
            assert jacobian.shape == (len(q), 6, model.nu)
            # what prescribed joints add does not change with u
            still = model.velocity(frame, q, 0 * u, in_=axes, t=0.3)
            moving = model.velocity(frame, q, u, in_=axes, t=0.3)
            found = np.einsum("...ij,...j->...i", jacobian, u)
            np.testing.assert_allclose(found, moving - still, rtol=1e-12, atol=1e-12)
    with pytest.raises(ArgumentError, match="in_ must be"):
        model.frame_jacobian(rest, q, in_="body")


@pytest.mark.parametrize("wrt", [None, 3, ()])
def test_wrt_must_name_something(wrt: object) -> None:
    scene = cd.Scene("slider")
    scene.joint("slide", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    model = cd.compile(scene)
    with pytest.raises(CardanError, match=r"wrt(=.*: give text| is a block such as 'q')"):
        model.derivative("forward_dynamics", wrt=wrt)
    with pytest.raises(ModelError, match="a name, or a pair"):
        model.derivative(5, wrt="q")


@pytest.mark.parametrize("name", ["springs", "satellite", "spherical_ZYX", "universal"])
def test_columns_along_coordinates_give_those_along_speeds(name: str) -> None:
    """dq = N e_k: the chain rule, over quaternions too, along which nothing changes."""
    model = compiled(name)
    q, u = (x[0] for x in states(name))
    by_coordinate, by_speed = model.derivative("energy", wrt=("coordinates", "q"))(q, u)
    assert by_coordinate.shape == (3, model.nq)
    still = model.qdot(q, np.zeros(model.nu))
    rates = np.stack([model.qdot(q, way) - still for way in np.eye(model.nu)], axis=-1)
    size = np.abs(by_speed).max()
    np.testing.assert_allclose(by_coordinate @ rates, by_speed, rtol=0, atol=1e-13 * size)
    for first in model.manifest.quaternions:
        part = slice(first, first + 4)
        along = by_coordinate[:, part] @ q[part]
        np.testing.assert_allclose(along, 0, atol=1e-13 * size)
