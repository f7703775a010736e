"""Second derivatives in CasADi: of a Lagrangian, beside CasADi's own and beside differences."""

from __future__ import annotations

import subprocess
from itertools import pairwise
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

FUNCTIONS = [
    "forward_dynamics",
    ("hessian", "forward_dynamics: q u"),
    ("hessian", "energy: q p"),
    ("hessian", "mass_matrix: q"),
    ("hessian", "pose(hand): q"),
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    where = tmp_path_factory.mktemp("hessians") / "wrist"
    return cd.derive(wrist()).export(where, FUNCTIONS, language="casadi")


@pytest.fixture(scope="module")
def module(folder: Path) -> ModuleType:
    return loaded(folder, "wrist_casadi")


@pytest.fixture
def state() -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(3)
    return tuple(rng.standard_normal(size) for size in (5, 4, 4))


def _second(function: Any, weights: np.ndarray, *values: np.ndarray) -> list[Any]:
    """Hessian, gradient and Jacobian of a weighted sum of results by all arguments together."""
    ends = np.cumsum([0, *map(len, values)])
    z = casadi.MX.sym("z", int(ends[-1]))
    names = [z[a:b] for a, b in pairwise(ends)]
    result = function(*names)
    lam = casadi.MX.sym("lam", *result.shape)
    hessian, gradient = casadi.hessian(casadi.sum1(casadi.sum2(lam * result)), z)
    jacobian = casadi.jacobian(casadi.vec(result), z)
    found = casadi.Function("second", [z, lam], [hessian, gradient, jacobian])
    return [found, *found(np.concatenate(values), weights)]


def _check(function: Any, *values: np.ndarray) -> Any:
    """Compare with differences of the gradient, and this with the Jacobian."""
    weights = np.random.default_rng(4).standard_normal(function.size_out(0))
    found, hessian, gradient, jacobian = _second(function, weights, *values)
    by_jacobian = np.array(jacobian).T @ weights.ravel(order="F")
    np.testing.assert_allclose(np.array(gradient).ravel(), by_jacobian, rtol=1e-12, atol=1e-13)
    # fourth order: steps of 1e-3 leave 1e-12 of their own, and rounding 1e-13
    z, step, columns = np.concatenate(values), 1e-3, []
    for k in range(len(z)):
        e = step * np.eye(len(z))[k]
        slopes = [np.array(found(z + n * e, weights)[1]).ravel() for n in (1, -1, 2, -2)]
        near, far = slopes[0] - slopes[1], slopes[2] - slopes[3]
        columns.append((8 * near - far) / (12 * step))
    scale = max(1.0, np.abs(columns).max())
    np.testing.assert_allclose(np.array(hessian), np.array(columns).T, atol=1e-8 * scale)
    return hessian


def test_hessians_are_those_of_differences(module: ModuleType, state: Any) -> None:
    q, u, tau = state
    assert module.HESSIANS["energy"]
    assert not module.HESSIANS["forward_dynamics"]
    hessian = _check(module.function("forward_dynamics"), q, u, tau)
    # by the forces the accelerations are linear
    assert not np.array(hessian)[9:, 9:].any()
    _check(module.function("pose", "hand"), q)
    # only the elbow changes the mass matrix
    assert _check(module.function("mass_matrix"), q).nnz() == 1
    _check(module.function("energy"), q, u)


def test_hessians_are_those_of_the_model(module: ModuleType, state: Any) -> None:
    q, u, tau = state
    model = cd.compile(wrist())
    at = unit(q, model.manifest.quaternions)
    weights = np.array([[0.3], [-1.0], [0.7], [2.0]])
    _, hessian, *_ = _second(module.function("forward_dynamics"), weights, at, u, tau)
    wrt = ("coordinates", "u", "tau")
    exact = model.hessian("forward_dynamics", wrt=wrt)(at, u, weights.ravel(), tau=tau)
    np.testing.assert_allclose(np.array(hessian), exact, rtol=1e-11, atol=1e-12)


def test_parameters_are_constant_or_arguments(module: ModuleType, state: Any) -> None:
    q, u, tau = state
    p = np.array(module.P)
    _check(module.function("energy", parameters=True), q, u, p)
    heavy = module.function("forward_dynamics", parameters={"m": 4.0})
    _check(heavy, q, u, tau)
    # what was not exported is not a number, and only that
    open_ = module.function("forward_dynamics", parameters=True)
    _, hessian, gradient, _ = _second(open_, np.ones((4, 1)), q, u, tau, p)
    states = len(q) + len(u) + len(tau)
    assert np.isfinite(np.array(gradient)).all()
    assert np.isfinite(np.array(hessian)[:states, :states]).all()
    assert np.isnan(np.array(hessian)[states:, :]).any()


def test_states_inputs_and_time(tmp_path: Path) -> None:
    named = ["rhs", ("hessian", "rhs: q")]
    folder = cd.derive(pushed()).export(tmp_path / "c", named, language="casadi")
    rhs = loaded(folder, "pushed_casadi").function("rhs")
    _check(rhs, np.array([0.3]), np.array([0.4, -0.2, 0.5]), np.array([1.1]))


@pytest.mark.filterwarnings("ignore:the start of 'four_bar'")
@pytest.mark.parametrize("name", ["four_bar", "bouncing_ball"])
def test_closed_loops_and_modes(name: str, tmp_path: Path) -> None:
    scene = cd.load(cd.examples.path(name))
    model = cd.compile(scene)
    named = [("hessian", "rhs: q")]
    folder = cd.derive(scene).export(tmp_path / "c", named, language="casadi")
    rhs = loaded(folder, f"{name}_casadi").function("rhs")
    x = np.array(model.initial())
    if name == "bouncing_ball":
        # in flight, spinning; in this mode it touches nothing
        x[7:] = 0.3, 0.2, -0.5, 0.1, 0.2, 0.3
    values = {"x": x, "s": np.ones(model.ns)}
    _check(rhs, *(values[letter] for letter in rhs.name_in()))


def _cart_pole() -> cd.Scene:
    scene = cd.Scene("cart_pole", gravity=(0, 0, -9.81))
    push = scene.input("push", unit="N")
    cart = scene.body("cart", mass=1.0, inertia=(0.1, 0.1, 0.1))
    inertia = cd.inertia.rod(0.3, 1.0, axis="z")
    pole = scene.body("pole", mass=0.3, com=(0, 0, -0.5), inertia=inertia)
    scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("hinge", cd.Revolute("y"), cart, pole)
    scene.force("motor", cd.JointForce("rail", push))
    return scene


def _by_hand() -> Any:
    """The same cart and pole, from Lagrange's equations."""
    x, r = casadi.SX.sym("x", 4), casadi.SX.sym("r")
    m, length, g = 0.3, 0.5, 9.81
    s, c, rate = casadi.sin(x[1]), casadi.cos(x[1]), x[3]
    mass = casadi.vertcat(
        casadi.horzcat(1.0 + m, -m * length * c),
        casadi.horzcat(-m * length * c, m / 12 + m * length**2),
    )
    right = casadi.vertcat(r - m * length * s * rate**2, -m * g * length * s)
    return casadi.Function("rhs", [x, r], [casadi.vertcat(x[2:], casadi.solve(mass, right))])


def _swing(rhs: Any, count: int, options: dict[str, Any]) -> Any:
    """A swing-up by the midpoint rule, of which CasADi finds the derivatives itself."""
    x, r = casadi.MX.sym("x", 4, count + 1), casadi.MX.sym("r", 1, count)
    rates = rhs.map(count)((x[:, 1:] + x[:, :-1]) / 2, r)
    defects = x[:, 1:] - x[:, :-1] - 2.0 / count * rates
    ends = [x[:, 0], x[:, -1] - casadi.DM([0, np.pi, 0, 0])]
    problem = {
        "x": casadi.vertcat(casadi.vec(x), casadi.vec(r)),
        "f": casadi.sumsqr(r),
        "g": casadi.vertcat(casadi.vec(defects), *ends),
    }
    return casadi.nlpsol("swing", "ipopt", problem, {"print_time": False, "ipopt": options})


def test_the_lagrangian_is_that_of_expressions(tmp_path: Path) -> None:
    named = [("hessian", "rhs: q u")]
    folder = cd.derive(_cart_pole()).export(tmp_path / "c", named, language="casadi")
    rhs = loaded(folder, "cart_pole_casadi").function("rhs")
    options = {"print_level": 0, "sb": "yes"}
    solvers = [_swing(one, 30, options) for one in (rhs, _by_hand())]
    n, m = solvers[0].size1_in("x0"), solvers[0].size1_out("g")
    rng = np.random.default_rng(5)
    at = (rng.standard_normal(n), [], 0.7, rng.standard_normal(m))
    ours, theirs = (one.get_function("nlp_hess_l")(*at) for one in solvers)
    np.testing.assert_allclose(np.array(ours), np.array(theirs), rtol=1e-10, atol=1e-11)
    # no entry more than the expressions have
    assert ours.nnz() <= theirs.nnz()
    guess = np.concatenate([np.linspace(np.zeros(4), [0, np.pi, 0, 0], 31).ravel(), np.zeros(30)])
    found = [one(x0=guess, lbg=0, ubg=0) for one in solvers]
    counts = [one.stats()["iter_count"] for one in solvers]
    assert all(one.stats()["success"] for one in solvers)
    np.testing.assert_allclose(np.array(found[0]["x"]), np.array(found[1]["x"]), atol=1e-6)
    approximate = _swing(rhs, 30, {**options, "hessian_approximation": "limited-memory"})
    approximate(x0=guess, lbg=0, ubg=0)
    assert counts[0] < approximate.stats()["iter_count"]


def test_a_gradient_alone(tmp_path: Path) -> None:
    named = ["energy", ("vjp", "energy: q")]
    folder = cd.derive(wrist()).export(tmp_path / "c", named, language="casadi")
    module = loaded(folder, "wrist_casadi")
    assert module.HESSIANS == {}
    q, u = casadi.MX.sym("q", 5), casadi.MX.sym("u", 4)
    energy = module.function("energy")(q, u)[2]
    gradient = casadi.Function("gradient", [q, u], [casadi.gradient(energy, u)])
    momenta = cd.compile(wrist()).mass_matrix([1, 0, 0, 0, 0.3]) @ [0.1, 0.2, 0.3, 0.4]
    found = np.array(gradient([1, 0, 0, 0, 0.3], [0.1, 0.2, 0.3, 0.4])).ravel()
    np.testing.assert_allclose(found, momenta, rtol=1e-13)


def test_changes_along_a_direction_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DerivationError, match=r"takes no 'jvp' .* derivative, vjp, hessian"):
        cd.derive(wrist()).export(tmp_path / "c", [("jvp", "rhs: q")], language="casadi")


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
