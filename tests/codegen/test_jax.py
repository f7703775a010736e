"""Exports that JAX calls: first derivatives in both modes, one call for many states, refusals."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import cardan as cd
from codegen.bindings import loaded, pushed, unit, wrist
from codegen.running import STRICT, compilers

jax = pytest.importorskip("jax", reason="JAX is not installed")
jnp = jax.numpy
test_util = pytest.importorskip("jax.test_util")

FUNCTIONS = ["forward_dynamics", "inverse_dynamics", "rhs", "mass_matrix", ("pose", "hand")]
# differences by steps of 1e-6 of numbers of about 100: 1e-8, a thousand times that
CLOSE: dict[str, Any] = {"order": 1, "eps": 1e-6, "atol": 1e-5, "rtol": 1e-5}


@pytest.fixture(scope="module", autouse=True)
def double_precision() -> Any:
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


@pytest.fixture(scope="module")
def model() -> Any:
    return cd.compile(wrist())


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    where = tmp_path_factory.mktemp("jax") / "wrist"
    return cd.derive(wrist()).export(where, FUNCTIONS, language="jax")


@pytest.fixture(scope="module")
def module(folder: Path) -> ModuleType:
    return loaded(folder, "wrist_jax")


@pytest.fixture
def state() -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(5)
    return tuple(rng.standard_normal(size) for size in (5, 4, 4))


def test_values_are_those_of_the_model(model: Any, module: ModuleType, state: Any) -> None:
    q, u, tau = state
    at = unit(q, model.manifest.quaternions)
    found = jax.jit(lambda q, u, tau: module.forward_dynamics(q, u, tau=tau))(q, u, tau)
    np.testing.assert_allclose(found, model.forward_dynamics(at, u, tau=tau), rtol=1e-12)
    found = module.inverse_dynamics(q, u, tau, parameters={"m": 3.0})
    expected = model.inverse_dynamics(at, u, tau, parameters={"m": 3.0})
    np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-13)
    pose = module.pose__hand(q)
    np.testing.assert_allclose(pose, model.pose("hand", at), rtol=1e-13, atol=1e-15)


def test_derivatives_agree_with_differences_in_both_modes(module: ModuleType, state: Any) -> None:
    q, u, tau = map(jnp.asarray, state)
    p = jnp.array(module._DEFAULTS["p"])
    test_util.check_grads(
        lambda q, u, tau, p: module.forward_dynamics(q, u, tau=tau, parameters=p),
        (q, u, tau, p),
        **CLOSE,
    )
    x = jnp.concatenate([q, u])
    test_util.check_grads(lambda x, p: module.rhs(0.0, x, parameters=p), (x, p), **CLOSE)
    test_util.check_grads(module.inverse_dynamics, (q, u, tau), **CLOSE)
    test_util.check_grads(module.mass_matrix, (q,), **CLOSE)
    by_name = lambda q, m: module.pose__hand(q, parameters={"m": m})  # noqa: E731
    test_util.check_grads(by_name, (q, jnp.array(2.0)), **CLOSE)


def test_derivatives_are_those_of_the_model(model: Any, module: ModuleType, state: Any) -> None:
    q, u, tau = state
    at = unit(q, model.manifest.quaternions)
    exact = model.derivative("forward_dynamics", wrt="coordinates")(at, u, tau=tau)
    exact[:, :4] /= np.linalg.norm(q[:4])
    dynamics = lambda q: module.forward_dynamics(q, u, tau=tau)  # noqa: E731
    for mode in (jax.jacfwd, jax.jacrev):
        np.testing.assert_allclose(mode(dynamics)(q), exact, rtol=1e-11, atol=1e-12)


def test_states_inputs_and_time_have_derivatives(tmp_path: Path) -> None:
    scene = pushed()
    model = cd.compile(scene)
    cd.derive(scene).export(tmp_path / "c", ["rhs"], language="jax")
    module = loaded(tmp_path / "c", "pushed_jax")
    t, x, r = 0.3, np.array([0.4, -0.2, 0.5]), np.array([1.1])
    np.testing.assert_allclose(module.rhs(t, x), model.rhs(t, x), rtol=1e-13)
    by_t, by_x, by_r = jax.jacfwd(lambda t, x, r: module.rhs(t, x, r=r), argnums=(0, 1, 2))(t, x, r)
    exact = model.rhs_jacobian(t, x, r=r)
    for one, other in zip((by_x, by_t, by_r), exact, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-13)


def test_many_states_are_one_call(module: ModuleType, state: Any) -> None:
    """Axes of jax.vmap stand in front, whatever they belong to; leading axes broadcast."""
    _, u, _ = state
    rng = np.random.default_rng(7)
    q, p = rng.standard_normal((3, 2, 5)), jnp.array(module._DEFAULTS["p"])
    several = jnp.stack([p, 1.1 * p])
    dynamics = lambda q, p: module.forward_dynamics(q, u, parameters=p)  # noqa: E731
    one_by_one = [[[dynamics(x, p) for x in row] for row in q] for p in several]
    both = jax.vmap(jax.vmap(jax.vmap(dynamics, (0, None)), (0, None)), (None, 0))
    np.testing.assert_array_equal(both(q, several), one_by_one)
    np.testing.assert_array_equal(jax.vmap(dynamics, (None, 0))(q, several), one_by_one)
    np.testing.assert_array_equal(dynamics(q, p), one_by_one[0])
    text = str(jax.make_jaxpr(both)(q, several))
    assert text.count("ffi_call[") == 1
    gradient = jax.vmap(jax.grad(lambda q: dynamics(q, p).sum()))(q[0])
    alone = [jax.grad(lambda q: dynamics(q, p).sum())(x) for x in q[0]]
    np.testing.assert_allclose(gradient, alone, rtol=1e-13)


def test_gradient_of_a_rollout(model: Any, module: ModuleType, state: Any) -> None:
    """Fifty steps, the quaternion too, against differences of eighth order."""
    q, u, tau = map(jnp.asarray, state)
    nq = model.nq
    start = jnp.concatenate([jnp.array(unit(q, model.manifest.quaternions)), u])

    def loss(tau: Any, k: Any) -> Any:
        def step(x: Any, _: Any) -> Any:
            udot = module.forward_dynamics(x[:nq], x[nq:], tau=tau, parameters={"k": k})
            x = x.at[nq:].add(0.01 * udot)
            return x.at[:nq].add(0.01 * module.rhs(0.0, x)[:nq]), None

        end, _ = jax.lax.scan(step, start, None, length=50)
        return jnp.sum(end[:nq] * jnp.arange(1.0, nq + 1)) + end[nq:] @ end[nq:]

    by_tau, by_k = jax.jit(jax.grad(loss, argnums=(0, 1)))(tau, 3.0)
    h, weights = 1e-2, (4 / 5, -1 / 5, 4 / 105, -1 / 280)

    def difference(f: Any) -> Any:
        pairs = enumerate(weights, 1)
        return sum(c * (f(n * h) - f(-n * h)) for n, c in pairs) / h

    run = jax.jit(loss)
    expected = [difference(lambda s, w=w: run(tau + s * w, 3.0)) for w in jnp.eye(4)]
    np.testing.assert_allclose(by_tau, expected, rtol=1e-9)
    np.testing.assert_allclose(by_k, difference(lambda s: run(tau, 3.0 + s)), rtol=1e-8)


def test_second_derivatives_are_refused(module: ModuleType, state: Any) -> None:
    q, u, _ = state
    with pytest.raises(ValueError, match="first derivatives and no second ones"):
        jax.hessian(lambda q: module.forward_dynamics(q, u).sum())(q)


def test_left_out_parameters_are_refused(tmp_path: Path) -> None:
    named = ["forward_dynamics", ("derivative", "forward_dynamics: q u")]
    cd.derive(wrist()).export(tmp_path / "c", named, language="jax")
    module = loaded(tmp_path / "c", "wrist_jax")
    q, u = jnp.array([1.0, 0, 0, 0, 0.2]), jnp.ones(4)
    assert jnp.isfinite(jax.grad(lambda q: module.forward_dynamics(q, u).sum())(q)).all()
    with pytest.raises(ValueError, match="without its derivative by parameters"):
        jax.grad(lambda m: module.forward_dynamics(q, u, parameters={"m": m}).sum())(2.0)


def test_wrong_arguments_are_named(module: ModuleType, state: Any) -> None:
    q, u, _ = state
    with pytest.raises(ValueError, match=r"q must have shape \(\.\.\., 5\), not \(4,\)"):
        module.forward_dynamics(q[:4], u)
    with pytest.raises(KeyError, match="p has no 'mm'"):
        module.forward_dynamics(q, u, parameters={"mm": 1.0})


def test_single_precision_is_refused(folder: Path) -> None:
    code = "import wrist_jax; wrist_jax.mass_matrix([1., 0, 0, 0, 0])"
    answer = subprocess.run(
        [sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, check=False
    )
    assert "jax_enable_x64" in answer.stderr.splitlines()[-1]


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_the_c_compiles_without_a_warning(compiler: str, folder: Path) -> None:
    for flags in ((), ("-DCARDAN_JAX", "-isystem", jax.ffi.include_dir())):
        command = [*compilers()[compiler], *STRICT, "-O2", *flags, f"-I{folder}", "-c"]
        answer = subprocess.run(
            [*command, str(folder / "jax.c"), "-o", str(folder / "jax.o")],
            capture_output=True,
            text=True,
            check=False,
        )
        assert answer.returncode == 0, answer.stderr


@pytest.mark.slow
def test_panda(tmp_path: Path) -> None:
    """check_grads of first order, on the arm with its 113 parameters."""
    pytest.importorskip("example_robot_data")
    from mechanisms.robots import panda

    cd.derive(panda()).export(tmp_path / "c", ["forward_dynamics"], language="jax")
    module = loaded(tmp_path / "c", "panda_jax")
    rng = np.random.default_rng(1)
    q, u, tau = (jnp.array(rng.standard_normal(7)) for _ in range(3))
    mass = next(name for name in module.PARAMETERS if name.endswith("mass"))
    test_util.check_grads(
        lambda q, u, tau, m: module.forward_dynamics(q, u, tau=tau, parameters={mass: m}),
        (q, u, tau, jnp.array(3.0)),
        order=1,
        eps=1e-6,
        atol=1e-3,
        rtol=1e-5,
    )
