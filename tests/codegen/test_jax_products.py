"""Exports for JAX whose reverse mode is a product with weights, beside those by Jacobians."""

from __future__ import annotations

import subprocess
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import DerivationError
from codegen.bindings import loaded, pushed, wrist
from codegen.running import STRICT, compilers

jax = pytest.importorskip("jax", reason="JAX is not installed")
jnp = jax.numpy
test_util = pytest.importorskip("jax.test_util")

FUNCTIONS = ["forward_dynamics", "rhs", "mass_matrix", ("pose", "hand")]
PRODUCTS = [
    ("vjp", "forward_dynamics: q"),
    ("vjp", "rhs: q"),
    ("vjp", "mass_matrix: q"),
    ("vjp", "pose(hand): q"),
]
# as in test_jax.py
CLOSE: dict[str, Any] = {"order": 1, "eps": 1e-6, "atol": 1e-5, "rtol": 1e-5}


@pytest.fixture(scope="module", autouse=True)
def double_precision() -> Any:
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    where = tmp_path_factory.mktemp("products") / "wrist"
    return cd.derive(wrist()).export(where, [*FUNCTIONS, *PRODUCTS], language="jax")


@pytest.fixture(scope="module")
def module(folder: Path) -> ModuleType:
    return loaded(folder, "wrist_jax")


@pytest.fixture(scope="module")
def by_jacobians(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    where = tmp_path_factory.mktemp("jacobians") / "wrist"
    return loaded(cd.derive(wrist()).export(where, FUNCTIONS, language="jax"), "wrist_jax")


@pytest.fixture
def state() -> tuple[Any, ...]:
    rng = np.random.default_rng(5)
    return tuple(jnp.asarray(rng.standard_normal(size)) for size in (5, 4, 4))


def test_derivatives_agree_with_differences_in_both_modes(module: ModuleType, state: Any) -> None:
    q, u, tau = state
    p = jnp.array(module._DEFAULTS["p"])

    def dynamics(q: Any, u: Any, tau: Any, p: Any) -> Any:
        return module.forward_dynamics(q, u, tau=tau, parameters=p)

    test_util.check_grads(dynamics, (q, u, tau, p), **CLOSE)
    x = jnp.concatenate([q, u])
    test_util.check_grads(lambda x, p: module.rhs(0.0, x, parameters=p), (x, p), **CLOSE)
    test_util.check_grads(module.mass_matrix, (q,), **CLOSE)
    by_name = lambda q, m: module.pose__hand(q, parameters={"m": m})  # noqa: E731
    test_util.check_grads(by_name, (q, jnp.array(2.0)), **CLOSE)
    # many states at once, some of what they have being one for all
    several = jnp.stack([q, 1.1 * q, q[::-1]])
    mapped = jax.vmap(dynamics, (0, None, None, None))
    test_util.check_grads(mapped, (several, u, tau, p), **CLOSE)
    test_util.check_grads(dynamics, (several, u, tau, p), **CLOSE)


def test_gradients_are_those_by_jacobians(
    module: ModuleType, by_jacobians: ModuleType, state: Any
) -> None:
    q, u, tau = state
    p = jnp.array(module._DEFAULTS["p"])
    weights = jnp.arange(1.0, 5.0)

    def gradient(module: ModuleType) -> Any:
        def weighted(q: Any, u: Any, tau: Any, p: Any) -> Any:
            return weights @ module.forward_dynamics(q, u, tau=tau, parameters=p)

        return jax.jit(jax.grad(weighted, argnums=(0, 1, 2, 3)))

    for one, other in zip(
        gradient(module)(q, u, tau, p), gradient(by_jacobians)(q, u, tau, p), strict=True
    ):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-12)
    # no Jacobian is formed
    text = gradient(module).lower(q, u, tau, p).compile().as_text()
    assert "vjp__forward_dynamics" in text
    assert "derivative__forward_dynamics" not in text
    found = [
        jax.jacrev(one.pose__hand)(q) - jax.jacfwd(one.pose__hand)(q)
        for one in (module, by_jacobians)
    ]
    np.testing.assert_allclose(found, 0.0, atol=1e-14)


def test_gradient_of_a_motion(module: ModuleType, by_jacobians: ModuleType, state: Any) -> None:
    q, u, _ = state
    start = jnp.concatenate([q.at[:4].divide(jnp.linalg.norm(q[:4])), u])
    starts = jnp.stack([start, start.at[5:].multiply(0.5)])

    def loss(module: ModuleType) -> Any:
        def end(x: Any, k: Any) -> Any:
            def step(x: Any, _: Any) -> Any:
                return x + 0.01 * module.rhs(0.0, x, parameters={"k": k}), None

            x, _ = jax.lax.scan(step, x, None, length=20)
            return x @ x

        return end

    for transform in (
        lambda f: jax.jit(jax.vmap(jax.grad(f, argnums=(0, 1)), (0, None))),
        lambda f: jax.vmap(jax.jacfwd(f, argnums=(0, 1)), (0, None)),
        lambda f: jax.grad(lambda x, k: jax.vmap(f, (0, None))(x, k).sum(), argnums=(0, 1)),
        lambda f: jax.grad(
            lambda x, k: jax.vmap(jax.checkpoint(f), (0, None))(x, k).sum(), argnums=(0, 1)
        ),
    ):
        ours, theirs = (transform(loss(one))(starts, 3.0) for one in (module, by_jacobians))
        for one, other in zip(ours, theirs, strict=True):
            np.testing.assert_allclose(one, other, rtol=1e-11, atol=1e-12)


def test_states_inputs_and_time(tmp_path: Path) -> None:
    cd.derive(pushed()).export(tmp_path / "c", ["rhs", ("vjp", "rhs: q")], language="jax")
    module = loaded(tmp_path / "c", "pushed_jax")
    values = tuple(map(jnp.asarray, (0.3, [0.4, -0.2, 0.5], [1.1])))
    test_util.check_grads(lambda t, x, r: module.rhs(t, x, r=r), values, **CLOSE)


def test_refusals(module: ModuleType, state: Any, tmp_path: Path) -> None:
    q, u, _ = state
    dynamics = lambda q: module.forward_dynamics(q, u).sum()  # noqa: E731
    with pytest.raises(ValueError, match="exact first derivatives and no second ones"):
        jax.hessian(dynamics)(q)
    with pytest.raises(DerivationError, match="'jax' takes no 'hessian' of a function"):
        cd.derive(wrist()).export(tmp_path / "c", [("hessian", "rhs: q")], language="jax")


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_the_c_compiles_without_a_warning(compiler: str, folder: Path) -> None:
    flags = ("-DCARDAN_JAX", "-isystem", jax.ffi.include_dir())
    command = [*compilers()[compiler], *STRICT, "-O2", *flags, f"-I{folder}", "-c"]
    for file in ("jax.c", *(path.name for path in folder.glob("vjp__*.c"))):
        answer = subprocess.run(
            [*command, str(folder / file), "-o", str(folder / "strict.o")],
            capture_output=True,
            text=True,
            check=False,
        )
        assert answer.returncode == 0, answer.stderr
