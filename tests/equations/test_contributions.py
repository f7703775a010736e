"""Where terms come from: what bodies and forces contribute adds up to M, h, f by every method."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.equations.formalisms import FORMALISMS
from cardan.errors import DerivationError
from cardan.ir.interpreter import evaluate
from equations.classical import CLASSICAL
from laws.cases import EPS, call, derived, states, values
from mechanisms import ZOO
from spread import some

PARTS = {"mass_matrix": "M", "bias": "h", "applied_forces": "f"}


@pytest.mark.parametrize("name", CLASSICAL)
def test_symbols_add_up(name: str) -> None:
    equations = cd.derive(CLASSICAL[name].scene())
    for function in PARTS:
        whole = equations.written(function)
        parts = [one.matrix for one in equations.contributions(function)]
        left = sum(parts, sp.zeros(*whole.shape)) - whole
        assert all(sp.simplify(entry) == 0 for entry in left)


@pytest.mark.parametrize("name", some(ZOO, 5))
def test_numbers_add_up(name: str) -> None:
    system = derived(name).system
    q, u = states(name)
    given = {"q": q, "u": u, "z": np.zeros(system.nz), "s": np.zeros(system.ns)}
    for function, letter in PARTS.items():
        shares = derived(name).contributions(function)
        numbers = values(derived(name), **given)
        found = [evaluate(one.function, numbers, "numpy")[letter] for one in shares]
        size = 1.0 + sum((np.abs(part).max() for part in found), 0.0)
        for method in ZOO[name].methods:
            if not system.closed or method != "articulated":
                whole = call(derived(name, method), function, **given)[letter]
                assert np.abs(sum(found, np.zeros(1)) - whole).max() < 1e4 * EPS * size


def test_every_method_is_in_the_zoo() -> None:
    assert {method for one in ZOO.values() for method in one.methods} <= set(FORMALISMS)


def carried() -> cd.Scene:
    scene = cd.Scene("carried", gravity=(0, 0, -9.81))
    arm = scene.body("arm", mass=2.0, com=(0, 0, -0.5), inertia=(0.2, 0.2, 0.01))
    tool = scene.body("tool", mass=0.5)
    scene.joint("pivot", cd.Revolute("y"), scene.ground, arm)
    scene.joint("grip", cd.Fixed(), arm.at(0, 0, -1.0), tool)
    scene.force("brake", cd.JointForce("pivot", -0.3 * scene.u("pivot")))
    scene.force("push", cd.JointForce("pivot", scene.input("push")))
    return scene


def test_fixed_bodies_and_forces_are_told_apart() -> None:
    equations = cd.derive(carried())
    mass = {one.owner: one.matrix[0] for one in equations.contributions("mass_matrix")}
    m, c, yy, tool, arm = sp.symbols("arm.mass arm.com.z arm.inertia.yy tool.mass grip.position.z")
    assert sp.expand(mass["arm"] - yy - m * c**2) == 0
    assert sp.expand(mass["tool"] - tool * arm**2) == 0
    weights = equations.contributions("bias")
    assert [(one.owner, one.cause) for one in weights] == [("arm", "weight"), ("tool", "weight")]
    forces = {one.owner: one.matrix[0] for one in equations.contributions("applied_forces")}
    assert forces["push"] == sp.Symbol("push")
    assert set(forces) == {"brake", "push"}


def test_other_names_are_refused() -> None:
    with pytest.raises(DerivationError, match="mass_matrix, bias, applied"):
        cd.derive(carried()).contributions("mass")
