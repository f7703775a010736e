"""Functions of beams in JAX and PyTorch, beside differences and the model itself."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd


@pytest.fixture(scope="module")
def rubber() -> cd.CompiledModel:
    """A beam of rubber on a hinge with a motor."""
    scene = cd.Scene("rubber", gravity=(0, 0, -9.81))
    E, rho = scene.parameter("E", 5e3, unit="Pa"), scene.parameter("rho", 1100)
    material = cd.material(E=E, nu=0.45, rho=rho, damping=2e-3)
    hub = scene.body("hub", mass=0.5, inertia=(0.01, 0.01, 0.01))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    scene.force("motor", cd.JointForce("hinge", scene.input("tau")))
    square = cd.section.rectangle(0.1, 0.1)
    bar = scene.beam("bar", hub, (0.4, 0, 0), square, material, elements=1)
    scene.output("tip", bar.end.position()[2])
    return cd.compile(scene)


@pytest.fixture(scope="module")
def state(rubber: cd.CompiledModel) -> np.ndarray:
    rng = np.random.default_rng(0)
    return rubber.initial(q={"hinge": 0.2}) + 0.02 * rng.standard_normal(rubber.nx)


@pytest.fixture
def jax() -> Any:
    jax = pytest.importorskip("jax", reason="JAX is not installed")
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield jax
    jax.config.update("jax_enable_x64", before)


ARGUMENTS = {"rhs": "tx", "forward_dynamics": "qu", "inverse_dynamics": "quu", "outputs": "qu"}
MORE = {"energy": "qu", "momentum": "qu", "qdot": "qu"}


def arguments(model: cd.CompiledModel, letters: str, x: np.ndarray) -> tuple[Any, ...]:
    values = {"t": 0.1, "x": x, "q": x[: model.nq], "u": x[model.nq :]}
    return tuple(values[letter] for letter in letters)


@pytest.mark.parametrize(
    "name", [*ARGUMENTS, *(pytest.param(n, marks=pytest.mark.slow) for n in MORE)]
)
def test_jax_agrees_with_differences(
    rubber: cd.CompiledModel, state: np.ndarray, jax: Any, name: str
) -> None:
    from jax.test_util import check_grads

    function = rubber.to_jax(name)
    values = arguments(rubber, (ARGUMENTS | MORE)[name], state)
    # a quaternion counts by its direction, which the model leaves to its callers
    place = slice(1, 5)
    exact = state.copy()
    exact[place] /= np.linalg.norm(exact[place])
    direct = getattr(rubber, name)(*arguments(rubber, (ARGUMENTS | MORE)[name], exact))
    direct = [*direct] if name == "energy" else direct
    np.testing.assert_allclose(function(*values), np.ravel(direct), rtol=1e-10, atol=1e-12)

    def scaled(*parts: Any) -> Any:
        *values, e, m = parts
        return function(*values, parameters={"E": 1e3 * e, "rho": 200 * m})

    # differences of 1e-6 leave 1e-10 of the rates, which are hundreds, over that
    close: dict[str, Any] = {"order": 1, "eps": 1e-6, "atol": 1e-4, "rtol": 1e-5}
    check_grads(scaled, (*values, 5.0, 5.5), **close)


def test_jax_takes_many_states_and_parameters(
    rubber: cd.CompiledModel, state: np.ndarray, jax: Any
) -> None:
    jnp, rhs = jax.numpy, rubber.to_jax("rhs")
    many = jnp.stack([state, 1.01 * state, 0.99 * state])
    moduli = jnp.array([4e3, 5e3, 4e3])

    def loss(x: Any, e: Any, tau: Any) -> Any:
        return (rhs(0.0, x, r={"tau": tau}, parameters={"E": e}) ** 2).sum()

    slopes = jax.grad(loss, argnums=(0, 1, 2))
    together = jax.jit(jax.vmap(slopes, (0, 0, None)))(many, moduli, 0.3)
    for k in range(3):
        for part, alone in zip(together, slopes(many[k], moduli[k], 0.3), strict=True):
            np.testing.assert_allclose(part[k], alone, rtol=1e-12, atol=1e-12)
    # those of the model, which come by another way
    place = slice(1, 5)
    x = state.copy()
    x[place] /= np.linalg.norm(x[place])
    found = jax.jacrev(lambda e: rhs(0.0, x, parameters={"E": e}))(4e3)
    by_model = rubber.derivative("rhs", wrt="E")(0.0, x, parameters={"E": 4e3})
    np.testing.assert_allclose(found, by_model, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("name", [("pose", "hub"), "mass_matrix"])
def test_frames_and_matrices(
    rubber: cd.CompiledModel, state: np.ndarray, jax: Any, name: str | tuple[str, str]
) -> None:
    """Reverse mode is the product of the model, of coordinates as they are stored."""
    q = state[: rubber.nq].copy()
    q[1:5] /= np.linalg.norm(q[1:5])
    function = rubber.to_jax(name)
    direct = rubber.pose("hub", q) if isinstance(name, tuple) else rubber.mass_matrix(q)
    np.testing.assert_allclose(function(q), direct, rtol=1e-10, atol=1e-12)
    weights = np.random.default_rng(1).uniform(-1, 1, direct.shape)
    (product,) = jax.vjp(function, q)[1](weights)
    expected = rubber.vjp(name, wrt="coordinates")(q, weights)
    np.testing.assert_allclose(product, expected, atol=1e-12 * np.abs(expected).max())


def test_torch(rubber: cd.CompiledModel, state: np.ndarray) -> None:
    torch = pytest.importorskip("torch", reason="PyTorch is not installed")
    rhs = rubber.to_torch("rhs")
    x = torch.tensor(np.stack([state, 0.99 * state]), dtype=torch.float64, requires_grad=True)
    e = torch.tensor([5.0, 4.0], dtype=torch.float64, requires_grad=True)

    def rates(x: Any, e: Any) -> Any:
        p = torch.tensor([*rubber.parameters.values()], dtype=torch.float64).repeat(2, 1)
        place = [*rubber.parameters].index("E")
        p = torch.cat([p[:, :place], 1e3 * e[:, None], p[:, place + 1 :]], dim=1)
        return 1e-3 * rhs(0.0, x, parameters=p)

    assert torch.autograd.gradcheck(rates, (x, e), check_forward_ad=True, atol=1e-5, rtol=1e-4)
