"""Exports that CasADi calls: values, exact sparse Jacobians, parameters, refusals."""

from __future__ import annotations

import subprocess
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import DerivationError
from codegen.bindings import loaded, pushed, unit, wrist
from codegen.running import STRICT, compilers

casadi = pytest.importorskip("casadi", reason="CasADi is not installed")

FUNCTIONS = ["forward_dynamics", "rhs", "mass_matrix", "energy", ("pose", "hand")]


@pytest.fixture(scope="module")
def model() -> Any:
    return cd.compile(wrist())


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    where = tmp_path_factory.mktemp("casadi") / "wrist"
    return cd.derive(wrist()).export(where, FUNCTIONS, language="casadi")


@pytest.fixture(scope="module")
def module(folder: Path) -> ModuleType:
    return loaded(folder, "wrist_casadi")


@pytest.fixture
def state() -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(3)
    return tuple(rng.standard_normal(size) for size in (5, 4, 4))


def _jacobian(function: Any, *values: Any) -> list[np.ndarray]:
    """Derivatives along every argument."""
    names = [casadi.MX.sym(f"a{k}", *function.size_in(k)) for k in range(function.n_in())]
    blocks = [casadi.jacobian(function(*names), name) for name in names]
    found = casadi.Function("jacobian", names, blocks)(*values)
    return [np.array(x) for x in (found if isinstance(found, tuple) else (found,))]


def test_values_are_those_of_the_model(model: Any, module: ModuleType, state: Any) -> None:
    q, u, tau = state
    at = unit(q, model.manifest.quaternions)
    dynamics = module.function("forward_dynamics")
    assert dynamics.name_in() == ["q", "u", "tau"]
    assert dynamics.name_out() == ["udot"]
    found = np.array(dynamics(q, u, tau)).ravel()
    np.testing.assert_allclose(found, model.forward_dynamics(at, u, tau=tau), rtol=1e-12)
    # what is not handed over acts nowhere; a missing state is not a number
    free = np.array(dynamics(q=q, u=u)["udot"]).ravel()
    np.testing.assert_allclose(free, model.forward_dynamics(at, u), rtol=1e-12)
    assert np.isnan(np.array(dynamics(q=q)["udot"])).all()
    pose = np.array(module.function("pose", "hand")(q))
    np.testing.assert_allclose(pose, model.pose("hand", at), rtol=1e-13, atol=1e-15)
    mass = module.function("mass_matrix")(q)
    np.testing.assert_allclose(np.array(mass), model.mass_matrix(at), rtol=1e-13, atol=1e-15)


def test_jacobians_are_exact_and_sparse(model: Any, module: ModuleType, state: Any) -> None:
    q, u, tau = state
    at = unit(q, model.manifest.quaternions)
    long = np.linalg.norm(q[:4])
    by_q, by_u, by_tau = _jacobian(module.function("forward_dynamics"), q, u, tau)
    wrt = ("coordinates", "u", "tau")
    exact = model.derivative("forward_dynamics", wrt=wrt)(at, u, tau=tau)
    exact[0][:, :4] /= long
    for one, other in zip((by_q, by_u, by_tau), exact, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-11, atol=1e-12)
    pose = module.function("pose", "hand")
    by_q = _jacobian(pose, q)[0].reshape(4, 4, 5, order="F")
    exact = model.derivative(("pose", "hand"), wrt="coordinates")(at)
    exact[..., :4] /= long
    np.testing.assert_allclose(by_q, exact, rtol=1e-11, atol=1e-13)
    # the last row of a pose is constant, and so is half of rhs
    assert pose.jacobian().sparsity_out(0).nnz() < 16 * 5
    rhs = module.function("rhs")
    assert rhs.jacobian().sparsity_out(0).nnz() < 81


def test_parameters_are_an_argument_or_numbers(model: Any, module: ModuleType, state: Any) -> None:
    q, u, tau = state
    at = unit(q, model.manifest.quaternions)
    names, p = list(module.PARAMETERS), np.array(module.P)
    open_ = module.function("forward_dynamics", parameters=True)
    by_p = _jacobian(open_, q, u, tau, p)[3]
    exact = model.derivative("forward_dynamics", wrt="p")(at, u, tau=tau)
    np.testing.assert_allclose(by_p, exact, rtol=1e-10, atol=1e-11)
    heavy = module.function("forward_dynamics", parameters={"m": 4.0})
    p[names.index("m")] = 4.0
    np.testing.assert_array_equal(np.array(heavy(q, u, tau)), np.array(open_(q, u, tau, p)))
    with pytest.raises(KeyError, match="no parameter 'mm'"):
        module.function("energy", parameters={"mm": 1.0})
    with pytest.raises(KeyError, match="without 'bias'"):
        module.function("bias")


def test_states_inputs_and_time_are_arguments(tmp_path: Path) -> None:
    scene = pushed()
    model = cd.compile(scene)
    cd.derive(scene).export(tmp_path / "c", ["rhs"], language="casadi")
    rhs = loaded(tmp_path / "c", "pushed_casadi").function("rhs")
    assert rhs.name_in() == ["t", "x", "r"]
    t, x, r = 0.3, np.array([0.4, -0.2, 0.5]), np.array([1.1])
    np.testing.assert_allclose(np.array(rhs(t, x, r)).ravel(), model.rhs(t, x, r=r), rtol=1e-13)
    by_t, by_x, by_r = _jacobian(rhs, t, x, r)
    exact = model.rhs_jacobian(t, x, r=r)
    np.testing.assert_allclose(by_x, exact[0], rtol=1e-13)
    np.testing.assert_allclose(by_t.ravel(), exact[1], rtol=1e-13)
    np.testing.assert_allclose(by_r, exact[2], rtol=1e-13)


def test_a_derivative_without_parameters_leaves_these_out(tmp_path: Path) -> None:
    named = ["forward_dynamics", ("derivative", "forward_dynamics: q u tau")]
    folder = cd.derive(wrist()).export(tmp_path / "c", named, language="casadi")
    assert not list(folder.glob("derivative__*_p.c"))
    module = loaded(folder, "wrist_casadi")
    q = np.array([1.0, 0, 0, 0, 0.2])
    assert np.isfinite(_jacobian(module.function("forward_dynamics"), q, q[:4], q[:4])[0]).all()
    with pytest.raises(ValueError, match="without its derivative by parameters"):
        module.function("forward_dynamics", parameters=True)


def test_second_derivatives_do_not_exist(module: ModuleType) -> None:
    energy = module.function("energy")
    q, u = casadi.MX.sym("q", 5), casadi.MX.sym("u", 4)
    with pytest.raises(RuntimeError):
        casadi.hessian(energy(q, u)[2], q)


@pytest.mark.parametrize(
    ("function", "message"),
    [
        ("integrate", "'integrate' has no derivative"),
        ("difference", "'difference' has no derivative"),
        ("rhs_jacobian", "'rhs_jacobian' has no derivative"),
        (("derivative", "forward_dynamics: q m"), "by whole blocks, not by 'm' alone"),
    ],
)
@pytest.mark.parametrize("language", ["casadi", "jax"])
def test_what_has_no_derivative_is_refused_by_name(
    function: Any, message: str, language: str, tmp_path: Path
) -> None:
    with pytest.raises(DerivationError, match=message):
        cd.derive(wrist()).export(tmp_path / "c", [function], language=language)
    assert not (tmp_path / "c").exists()


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_the_c_compiles_without_a_warning(compiler: str, folder: Path) -> None:
    files = [str(path) for path in folder.glob("*.c")]
    command = [*compilers()[compiler], *STRICT, "-O2", f"-I{folder}", "-fPIC", "-shared"]
    answer = subprocess.run(
        [*command, *files, "-o", str(folder / "strict.so"), "-lm"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 0, answer.stderr


def test_a_model_without_coordinates(tmp_path: Path) -> None:
    scene = cd.Scene("still")
    scene.joint("weld", cd.Fixed(), scene.ground, scene.body("block", mass=1.0))
    folder = cd.derive(scene).export(tmp_path / "still", ["rhs"], language="casadi")
    rates = loaded(folder, "still_casadi").function("rhs")
    assert [one.shape for one in rates.call([])] == [(0, 1)]
