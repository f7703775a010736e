"""Costs of motions for JAX: gradients through jax.ffi, under jit and vmap, and what is refused."""

from __future__ import annotations

import shutil
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import cardan as cd
from codegen.bindings import loaded
from codegen.test_export_gradient import COST, X0, arm

jax = pytest.importorskip("jax", reason="JAX is not installed")
jnp = jax.numpy
test_util = pytest.importorskip("jax.test_util")

if not any(map(shutil.which, ("cc", "gcc", "clang"))):
    pytest.skip("there is no C compiler", allow_module_level=True)

START = np.array(X0) / np.append(np.full(4, np.linalg.norm(X0[:4])), np.ones(5))


@pytest.fixture(scope="module", autouse=True)
def double_precision() -> Any:
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


@pytest.fixture(scope="module")
def module(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    where = tmp_path_factory.mktemp("jax") / "arm"
    options: dict[str, Any] = {"integrators": ["dop853", "rk4"], "gradient": COST}
    cd.derive(arm()).export(where, ["energy"], language="jax", **options)
    return loaded(where, "arm_jax")


def test_values_and_gradients_are_those_of_the_model(module: ModuleType) -> None:
    model = cd.compile(arm())
    how = {"rtol": 1e-10, "atol": 1e-12}
    wrt = ("u0", "p", "tau")
    expected = model.gradient(1.0, COST, x0=START, method="DOP853", wrt=wrt, **how)
    p = jnp.array(list(model.parameters.values()))
    f = lambda x, r, p: module.cost(x, end=1.0, r=r, parameters=p, **how)  # noqa: E731
    value, slopes = jax.jit(jax.value_and_grad(f, argnums=(0, 1, 2)))(START, jnp.array([0.3]), p)
    assert value == pytest.approx(expected.value, rel=1e-13)
    scale = max(float(np.abs(expected.slope[name]).max()) for name in wrt)
    ours = (slopes[0][model.nq :], slopes[2], slopes[1][0])
    for name, one in zip(wrt, ours, strict=True):
        np.testing.assert_allclose(one, expected.slope[name], atol=1e-13 * scale, rtol=0)


def test_gradients_agree_with_differences(module: ModuleType) -> None:
    how: dict[str, Any] = {"end": 0.35, "method": "rk4", "step": 1e-3}
    p = jnp.array(module._DEFAULTS["p"])
    f = lambda x, r, p: module.cost(x, r=r, parameters=p, **how)  # noqa: E731
    close = {"order": 1, "modes": ["rev"], "eps": 1e-5, "atol": 1e-6, "rtol": 1e-6}
    test_util.check_grads(f, (jnp.array(START), jnp.array([0.3]), p), **close)
    test_util.check_grads(jax.jit(f), (jnp.array(START), jnp.array([0.3]), p), **close)
    by_name = lambda m: module.cost(START, parameters={"m": m}, **how)  # noqa: E731
    test_util.check_grads(by_name, (jnp.array(1.2),), **close)


def test_many_motions_are_one_call(module: ModuleType) -> None:
    how: dict[str, Any] = {"end": 0.3, "method": "rk4", "step": 2e-3}
    rng = np.random.default_rng(3)
    x = jnp.array(START + np.append(np.zeros((3, 4)), 0.2 * rng.standard_normal((3, 5)), axis=1))
    r = jnp.array(rng.standard_normal((3, 1)))
    f = lambda x, r, m: module.cost(x, r=r, parameters={"m": m}, **how)  # noqa: E731
    slopes = jax.grad(f, argnums=(0, 1, 2))
    one_by_one = [slopes(a, b, 1.3) for a, b in zip(x, r, strict=True)]
    mapped = jax.jit(jax.vmap(slopes, (0, 0, None)))(x, r, 1.3)
    for k in range(3):
        np.testing.assert_array_equal(mapped[k], np.stack([row[k] for row in one_by_one]))
    # what they share sums up
    total = jax.grad(lambda m: jax.vmap(f, (0, 0, None))(x, r, m).sum())(1.3)
    assert total == pytest.approx(sum(float(row[2]) for row in one_by_one), rel=1e-13)
    text = str(jax.make_jaxpr(jax.vmap(slopes, (0, 0, None)))(x, r, 1.3))
    assert text.count("ffi_call[") == 1
    # more steps than there was room for at first
    long = module.cost(START, end=2.5, method="rk4", step=1e-3)
    model = cd.compile(arm())
    expected = model.gradient(2.5, COST, x0=START, method="RK4", step=1e-3, wrt="x0")
    assert long == pytest.approx(expected.value, rel=1e-11)


def test_what_is_refused(module: ModuleType, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="no method 'radau'"):
        module.cost(START, end=1.0, method="radau")
    # none of a time is not zero
    late = lambda end, x: module.cost(x, end=end, method="rk4", step=1e-2)  # noqa: E731
    with pytest.raises(TypeError, match=r"no derivatives by times.*stop_gradient"):
        jax.grad(late)(0.1, START)
    held = jax.grad(lambda x: late(jax.lax.stop_gradient(0.1 * x[0]), x))(jnp.array(START))
    fixed = jax.grad(late, argnums=1)(0.1 * START[0], START)
    np.testing.assert_array_equal(held, fixed)
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    scene.force("floor", cd.Stop("z", lower=0.0, restitution=0.8))
    options: dict[str, Any] = {"integrators": ["dop853"], "gradient": cd.cost(final="z")}
    cd.derive(scene).export(tmp_path / "c", ["energy"], language="jax", **options)
    drop = loaded(tmp_path / "c", "ball_jax")
    slope = jax.grad(lambda x: drop.cost(x, end=0.4))(jnp.array([1.0, 0.0]))
    np.testing.assert_allclose(slope, [1.0, 0.4], rtol=1e-12)
    with pytest.raises(Exception, match=r"floor.*an event changed the motion"):
        jax.grad(lambda x: drop.cost(x, end=2.0))(jnp.array([1.0, 0.0])).block_until_ready()
