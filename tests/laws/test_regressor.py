"""Forces and energies are linear in the inertial parameters, with the regressors as matrices."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import DerivationError
from cardan.ir.interpreter import evaluate
from laws.cases import EPS, call, derived, states
from mechanisms import ZOO
from spread import some

# members with forces that are linear in none of their numbers: motors, given forces
DRIVEN = {"mounts", "damped", "driven", "gyrostat"}
# members in which time or inputs move something
MOVED = {"crane", "gyrostat", "dual_spin"}
# members with forces on masses where their centers are: not linear in first moments
PULLED = {"orbiter", "binary", "librating"}
LINEAR = [name for name in ZOO if name not in PULLED]


def parameters(equations: Any) -> np.ndarray:
    return np.array([p.value for p in equations.system.parameters])


def phi(equations: Any, p: np.ndarray) -> np.ndarray:
    found = evaluate(equations.function("inertial_parameters"), {"p": p}, arithmetic="numpy")
    return np.asarray(found["phi"])


def moved(name: str) -> tuple[Any, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    equations = derived(name)
    q, u = states(name)
    udot = np.random.default_rng(3).uniform(-1, 1, u.shape)
    return equations, q, u, udot, call(equations, "regressor", q=q, u=u, udot=udot)["Y"]


@pytest.mark.parametrize("name", some(LINEAR, 3))
def test_forces_are_linear(name: str) -> None:
    equations, q, u, udot, y = moved(name)
    p = parameters(equations)
    size = np.abs(y) @ np.abs(phi(equations, p)) + 1e-3
    tau = call(equations, "inverse_dynamics", q=q, u=u, udot=udot)["tau"]
    bound = 100 * EPS * len(equations.system.bodies)
    if name not in DRIVEN:
        assert np.all(np.abs(y @ phi(equations, p) - tau) <= bound * size)
    # other masses and coefficients, in shapes that stay: the forces change by Y times the change
    rng, other = np.random.default_rng(4), p.copy()
    for k in range(len(p)):
        changed = p * (1 + 0.3 * (np.arange(len(p)) == k))
        stays = call(equations, "regressor", q=q, u=u, udot=udot, p=changed)["Y"]
        if np.array_equal(stays, y) and np.any(phi(equations, changed) != phi(equations, p)):
            other[k] *= 1 + rng.uniform(-0.4, 0.4)
    change = phi(equations, other) - phi(equations, p)
    assert np.abs(change).max() > 0.01
    after = call(equations, "inverse_dynamics", q=q, u=u, udot=udot, p=other)["tau"]
    size = size + np.abs(tau)
    assert np.all(np.abs(after - tau - y @ change) <= bound * size)


@pytest.mark.parametrize("name", some([name for name in LINEAR if name not in MOVED], 3, 1))
def test_energies_are_linear(name: str) -> None:
    equations, q, u, *_ = moved(name)
    e = call(equations, "energy_regressor", q=q, u=u)["E"]
    numbers = phi(equations, parameters(equations))
    found, size = e @ numbers, np.abs(e) @ np.abs(numbers) + 1e-6
    energy = call(equations, "energy", q=q, u=u)
    bound = 100 * EPS * len(equations.system.bodies)
    assert np.all(np.abs(found[:, 0] - energy["kinetic"]) <= bound * size[:, 0])
    if name not in DRIVEN:
        assert np.all(np.abs(found[:, 1] - energy["potential"]) <= bound * size[:, 1])
        power = call(equations, "power", q=q, u=u)["power"].sum(axis=-1)
        assert np.all(np.abs(found[:, 2] - power) <= bound * size[:, 2])


def test_energy_of_what_moves_by_itself_is_refused() -> None:
    with pytest.raises(DerivationError, match="moved by time or inputs"):
        derived("crane").function("energy_regressor")


@pytest.mark.parametrize("name", sorted(PULLED))
def test_forces_on_centers_of_mass_are_refused(name: str) -> None:
    for function in ("regressor", "energy_regressor"):
        with pytest.raises(DerivationError, match="acts on masses where their centers are"):
            derived(name).function(function)


def test_phi_is_told_about_the_frame_of_the_body() -> None:
    """In the axes and about the origin of the user's frame, wherever its joint is."""
    scene = cd.Scene("offset", gravity=(0, 0, -9.81))
    c, moments = np.array([0.1, -0.2, 0.3]), {"xx": 0.03, "yy": 0.05, "zz": 0.04, "xy": 0.01}
    link = scene.body("link", mass=2.0, com=tuple(c), inertia=moments)
    turned = link.at(0.4, 0.1, -0.2, rotation=("XYZ", 0.3, -0.5, 0.2))
    scene.joint("hinge", cd.Revolute((1, 2, 2)), scene.ground, turned)
    equations = cd.derive(scene)
    found = phi(equations, parameters(equations))
    tensor = 2.0 * (c @ c * np.eye(3) - np.outer(c, c)) + np.diag([0.03, 0.05, 0.04])
    tensor[0, 1] += 0.01
    wanted = [2.0, *(2.0 * c), *np.diag(tensor), tensor[0, 1], tensor[0, 2], tensor[1, 2]]
    assert np.allclose(found, wanted, rtol=1e-14, atol=1e-16)
    names = equations.function("inertial_parameters").outputs[0].entries
    assert names[:2] == ("link.mass", "link.moment_x")
    assert names[-1] == "link.yz"


def test_regressor_reads_as_in_a_textbook() -> None:
    equations = derived("cart_pole")
    g, c, s = sp.Symbol("gravity.z"), sp.cos(sp.Symbol("hinge")), sp.sin(sp.Symbol("hinge"))
    x, w, turn = sp.symbols("track.udot hinge.u hinge.udot")
    wanted = {
        "cart.mass": (x, 0),
        "pole.mass": (x, 0),
        "pole.moment_x": (-turn * s - w**2 * c, g * c - x * s),
        "pole.moment_z": (turn * c - w**2 * s, g * s + x * c),
        "pole.yy": (0, turn),
    }
    columns = dict(zip(equations.inertial_parameters, equations.regressor.T.tolist(), strict=True))
    for name, column in columns.items():
        for mine, book in zip(column, wanted.get(name, (0, 0)), strict=True):
            assert sp.expand(mine - book) == 0
            assert sp.sympify(mine).count_ops() <= sp.sympify(book).count_ops() + 1
    m, z, moment = sp.symbols("pole.mass pole.com.z pole.inertia.yy")
    assert sp.expand(equations.inertial_parameters["pole.yy"] - moment - m * z**2) == 0
