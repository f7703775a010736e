"""Residuals of the equations of motion vanish where accelerations and multipliers are right."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from laws.circuits import compiled, start
from mechanisms.closed import CLOSED
from table import each

BICYCLE = Path(__file__).parents[2] / "src" / "cardan" / "scenes" / "bicycle.yaml"


@each("index", [3, 2, 1])
@each("name", CLOSED)
def test_vanishes_on_motions(name: str, index: int) -> None:
    model = compiled(name)
    q, u = start(model, name, 0.3)
    tau = np.linspace(-0.01, 0.02, model.nu)
    udot = model.forward_dynamics(q, u, tau=tau)
    lam = model.multipliers(q, u, tau=tau)
    found = model.residual(0.0, q, u, udot, lam, qdot=model.qdot(q, u), index=index, tau=tau)
    assert found.shape == (model.nq + model.nu + model.nlam,)
    size = max(1.0, float(np.abs(udot).max()))
    assert np.abs(found).max() < 1e-9 * size


def test_every_block_tells_its_own_error() -> None:
    model = compiled("four_bar")
    q, u = start(model, "four_bar", 0.3)
    rates, udot, lam = model.qdot(q, u), model.forward_dynamics(q, u), model.multipliers(q, u)
    off = np.array([1e-3, -2e-3, 3e-3])
    G, M = model.constraint_jacobian(q), model.mass_matrix(q)

    def blocks(index: int, **changed: np.ndarray) -> list[np.ndarray]:
        values = {"q": q, "u": u, "udot": udot, "lam": lam, "qdot": rates} | changed
        found = model.residual(0.0, index=index, **values)
        return np.split(found, [model.nq, model.nq + model.nu])

    np.testing.assert_allclose(blocks(3, qdot=rates + off)[0], off, rtol=0, atol=1e-15)
    np.testing.assert_allclose(blocks(3, udot=udot + off)[1], M @ off, rtol=0, atol=1e-13)
    np.testing.assert_allclose(blocks(3, lam=lam + off[:2])[1], -G.T @ off[:2], rtol=0, atol=1e-13)
    np.testing.assert_allclose(blocks(2, u=u + off)[2], G @ off, rtol=0, atol=1e-13)
    np.testing.assert_allclose(blocks(1, udot=udot + off)[2], G @ off, rtol=0, atol=1e-12)
    np.testing.assert_allclose(blocks(3, q=q + off)[2], model.constraints(q + off), atol=1e-16)


def test_rolling_has_no_positions_and_trees_no_constraints() -> None:
    model = cd.compile(cd.load(BICYCLE))
    x = model.random_state(1)
    q, u = model.split(x)
    found = model.residual(0.0, q, u, np.zeros(model.nu), np.zeros(model.nlam), index=3)
    expected = [*model.constraints(q), *model.constraint_rates(q, u)[1:]]
    np.testing.assert_array_equal(found[model.nq + model.nu :], expected)
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=1.0, com=(0, 0, -1.0))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, bob)
    tree = cd.compile(scene)
    states = tree.random_state(2, shape=(3,))
    q, u = tree.split(states)
    found = tree.residual(0.0, q, u, tree.forward_dynamics(q, u))
    assert found.shape == (3, 2)
    assert np.abs(found).max() < 1e-13


def test_another_index() -> None:
    model = compiled("four_bar")
    with pytest.raises(cd.ArgumentError, match=r"index=4: 3 \(positions\), 2 \(velocities\) or 1"):
        model.residual(0.0, [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0], index=4)
