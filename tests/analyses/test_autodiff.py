"""Functions of a model in JAX and PyTorch, beside the model itself and differences."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError, ModelError
from codegen.bindings import pushed, unit, wrist

jax = pytest.importorskip("jax", reason="JAX is not installed")
jnp = jax.numpy
test_util = pytest.importorskip("jax.test_util")

# as in codegen/test_jax.py
CLOSE: dict[str, Any] = {"order": 1, "eps": 1e-6, "atol": 1e-5, "rtol": 1e-5}


@pytest.fixture(autouse=True)
def double_precision() -> Any:
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


@pytest.fixture(scope="module")
def model() -> Any:
    return cd.compile(wrist())


@pytest.fixture
def state() -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(5)
    return tuple(rng.standard_normal(size) for size in (5, 4, 4))


def test_jax_values_are_those_of_the_model(model: Any, state: Any) -> None:
    q, u, tau = state
    at = unit(q, model.manifest.quaternions)
    dynamics, rhs = model.to_jax("forward_dynamics"), model.to_jax("rhs")
    expected = model.forward_dynamics(at, u, tau=tau)
    np.testing.assert_allclose(dynamics(q, u, tau=tau), expected, rtol=1e-13)
    heavy = jax.jit(lambda q, m: dynamics(q, u, parameters={"m": m}))(q, 3.0)
    np.testing.assert_allclose(heavy, model.forward_dynamics(at, u, parameters={"m": 3.0}))
    # a quaternion counts by its direction, and its negative is the same rotation
    several = q * np.array([[1, 1, 1, 1, 1], [2, 2, 2, 2, 1], [-1, -1, -1, -1, 1]])
    np.testing.assert_allclose(dynamics(several, u), [model.forward_dynamics(at, u)] * 3)
    pose = model.to_jax(("pose", "hand"))(q)
    np.testing.assert_allclose(pose, model.pose("hand", at), rtol=1e-13, atol=1e-15)
    x = np.concatenate([at, u])
    np.testing.assert_allclose(rhs(0.0, x), model.rhs(0.0, x), rtol=1e-13, atol=1e-15)


def test_jax_derivatives_agree_with_differences_in_both_modes(model: Any, state: Any) -> None:
    q, u, tau = map(jnp.asarray, state)
    p = jnp.array([*model.parameters.values()])
    dynamics = model.to_jax("forward_dynamics")
    run = lambda q, u, tau, p: dynamics(q, u, tau=tau, parameters=p)  # noqa: E731
    test_util.check_grads(run, (q, u, tau, p), **CLOSE)
    several = jnp.stack([q, 1.1 * q, q[::-1]])
    test_util.check_grads(jax.vmap(run, (0, None, None, None)), (several, u, tau, p), **CLOSE)
    test_util.check_grads(run, (several, u, tau, jnp.stack([p, 1.1 * p, 1.2 * p])), **CLOSE)
    pose = model.to_jax(("pose", "hand"))
    by_name = lambda q, m: pose(q, parameters={"m": m})  # noqa: E731
    test_util.check_grads(by_name, (q, jnp.array(2.0)), **CLOSE)
    inverse = model.to_jax("inverse_dynamics")
    test_util.check_grads(inverse, (q, u, tau), **CLOSE)
    energy = model.to_jax("energy")
    test_util.check_grads(energy, (q, u), **CLOSE)


def test_jax_derivatives_are_those_of_the_model(model: Any, state: Any) -> None:
    q, u, tau = state
    at = unit(q, model.manifest.quaternions)
    exact = model.derivative("forward_dynamics", wrt="coordinates")(at, u, tau=tau)
    exact[:, :4] /= np.linalg.norm(q[:4])
    dynamics = model.to_jax("forward_dynamics")
    for mode in (jax.jacfwd, jax.jacrev):
        found = jax.jit(mode(lambda q: dynamics(q, u, tau=tau)))(q)
        np.testing.assert_allclose(found, exact, rtol=1e-11, atol=1e-12)


def test_jax_states_inputs_and_time() -> None:
    model = cd.compile(pushed())
    rhs, t, x, r = model.to_jax("rhs"), 0.3, np.array([0.4, -0.2, 0.5]), np.array([1.1])
    found = jax.jacrev(lambda t, x, r: rhs(t, x, r=r), argnums=(0, 1, 2))(t, x, r)
    by_x, by_t, by_r = model.rhs_jacobian(t, x, r=r)
    for one, other in zip(found, (by_t, by_x, by_r), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-13)
    by_name = jax.grad(lambda push: rhs(t, x, r={"push": push})[2])(1.1)
    np.testing.assert_allclose(by_name, by_r[2, 0], rtol=1e-13)


def test_jax_gradient_of_a_motion(model: Any, state: Any) -> None:
    """Twenty steps of many motions, against differences of eighth order."""
    q, u, _ = map(jnp.asarray, state)
    rhs = model.to_jax("rhs")

    def loss(x: Any, k: Any) -> Any:
        def step(x: Any, _: Any) -> Any:
            return x + 0.01 * rhs(0.0, x, parameters={"k": k}), None

        x, _ = jax.lax.scan(step, x, None, length=20)
        return x @ x

    start = jnp.concatenate([q / jnp.linalg.norm(q[:4]), u])
    both = jnp.stack([start, start.at[5:].multiply(0.5)])
    by_k = jax.jit(jax.vmap(jax.grad(loss, argnums=1), (0, None)))(both, 3.0)
    many, h = jax.jit(jax.vmap(loss, (0, None))), 1e-2
    weights = enumerate((4 / 5, -1 / 5, 4 / 105, -1 / 280), 1)
    pairs = [c * (many(both, 3 + n * h) - many(both, 3 - n * h)) for n, c in weights]
    np.testing.assert_allclose(by_k, sum(pairs) / h, rtol=1e-9)


def test_refusals(model: Any, state: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    q, u, _ = state
    dynamics = model.to_jax("forward_dynamics")
    with pytest.raises(ModelError, match="exact first derivatives and no second ones"):
        jax.hessian(lambda q: dynamics(q, u).sum())(q)
    with pytest.raises(ModelError, match=r"'integrate' does not exist, or has no derivative"):
        model.to_jax("integrate")
    with pytest.raises(ModelError, match="frame 'hamd' does not exist"):
        model.to_jax(("pose", "hamd"))
    with pytest.raises(ArgumentError, match="forward_dynamics needs u"):
        dynamics(q)
    with pytest.raises(ArgumentError, match=r"q, u by place and t, z, s, r, tau, parameters by na"):
        dynamics(q, u, tav=u)
    with pytest.raises(ArgumentError, match=r"u has shape \(5,\), expected \(..., 4\)"):
        dynamics(q, q)
    with pytest.raises(ArgumentError, match="parameters has no 'mm'"):
        dynamics(q, u, parameters={"mm": 1.0})
    jax.config.update("jax_enable_x64", False)
    with pytest.raises(ModelError, match="jax_enable_x64"):
        dynamics(q, u)
    for name, package in (("jax", "jax"), ("torch", "torch")):
        monkeypatch.setitem(sys.modules, name, None)
        with pytest.raises(ModuleNotFoundError, match=f"pip install {package}"):
            getattr(model, f"to_{name}")("rhs")


def test_what_has_no_solution_is_not_a_number() -> None:
    scene = cd.Scene("light")
    scene.joint(
        "slide", cd.Prismatic("x"), scene.ground, scene.body("dust", mass=scene.parameter("m", 1.0))
    )
    dynamics = cd.compile(scene).to_jax("forward_dynamics")
    q, u, tau = np.zeros((3, 1, 1))
    assert np.isfinite(dynamics(q[0], u[0], tau=tau[0] + 1.0)).all()
    found = dynamics(q[0], u[0], tau=tau[0] + 1.0, parameters={"m": 0.0})
    assert not np.isfinite(found).any()


def test_torch(model: Any, state: Any) -> None:
    torch = pytest.importorskip("torch", reason="PyTorch is not installed")

    def tensor(value: Any) -> Any:
        return torch.tensor(np.array(value), dtype=torch.float64, requires_grad=True)

    q, u, tau = map(tensor, state)
    p, several = tensor([*model.parameters.values()]), tensor(np.stack([state[0], state[0][::-1]]))
    at = unit(state[0], model.manifest.quaternions)
    dynamics, pose = model.to_torch("forward_dynamics"), model.to_torch(("pose", "hand"))
    rhs = model.to_torch("rhs")
    expected = model.forward_dynamics(at, state[1], tau=state[2])
    found = dynamics(q, u, tau=tau)
    np.testing.assert_allclose(found.detach().numpy(), expected, rtol=1e-13)

    def check(function: Any, *values: Any) -> None:
        assert torch.autograd.gradcheck(function, values, check_forward_ad=True)

    check(lambda q, u, tau, p: dynamics(q, u, tau=tau, parameters=p), q, u, tau, p)
    check(lambda q, u, p: dynamics(q, u, parameters=p), several, u, p)
    check(lambda q, m: pose(q, parameters={"m": m}), q, tensor(2.0))
    check(lambda x: rhs(0.0, x), torch.cat([q, u]))
    exact = model.derivative("forward_dynamics", wrt="coordinates")(at, state[1], tau=state[2])
    exact[:, :4] /= np.linalg.norm(state[0][:4])
    for mode in (torch.func.jacrev, torch.func.jacfwd):
        one = mode(lambda q: dynamics(q, u, tau=tau))
        np.testing.assert_allclose(one(q).detach().numpy(), exact, rtol=1e-11, atol=1e-12)
        many = torch.func.vmap(one)(several).detach().numpy()
        np.testing.assert_allclose(many[0], exact, rtol=1e-11, atol=1e-12)
    mapped = torch.func.vmap(dynamics, in_dims=(0, None))(several, u)
    np.testing.assert_array_equal(mapped.detach().numpy(), dynamics(several, u).detach().numpy())
    (gradient,) = torch.autograd.grad(dynamics(q, u).sum(), q, create_graph=True)
    with pytest.raises(ModelError, match="no second ones"):
        torch.autograd.grad(gradient.sum(), q)
    with pytest.raises(ArgumentError, match=r"u has shape \(5,\), expected \(..., 4\)"):
        dynamics(q, q)
    # numbers of single precision come out in double precision, and their gradients as they were
    short = torch.zeros(4, requires_grad=True)
    result = dynamics(q.detach(), short)
    assert result.dtype == torch.float64
    result.sum().backward()
    assert short.grad.dtype == torch.float32
