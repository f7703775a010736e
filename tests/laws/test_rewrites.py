"""Every rewrite of the system graph keeps the values of the whole zoo, and saves operations."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.equations.record import EquationRecord
from cardan.errors import DerivationError
from cardan.ir.interpreter import evaluate
from cardan.schema.functions import FUNCTIONS
from cardan.topology.rewrites import REWRITES
from laws.cases import EPS, derived, states, values
from mechanisms import ZOO
from spread import some

TOLD = tuple(name for name, row in FUNCTIONS.items() if row.rewritable and not row.rare)
METHODS = ("composite", "articulated", "newton_euler")
COUNTED = ("forward_dynamics", "inverse_dynamics", "mass_matrix")
# operations a rewrite may cost where it does not fit: an origin moved off a zero of the inertia
LEEWAY = 3


def told(name: str, method: str, rewrites: tuple[str, ...] | None) -> EquationRecord:
    return EquationRecord(derived(name).system, method, (), "", rewrites)


def methods(name: str) -> list[str]:
    return [m for m in METHODS if m in ZOO[name].methods]


@pytest.mark.parametrize("name", some(ZOO, 6))
def test_values_with_each_rewrite_alone_and_with_all(name: str) -> None:
    (q, u), rng = states(name), np.random.default_rng(3)
    udot, tau = rng.uniform(-3, 3, u.shape), rng.uniform(-1, 1, u.shape)
    blocks = values(derived(name), q=q, u=u, udot=udot, tau=tau)
    mass = evaluate(told(name, "newton_euler", ()).function("mass_matrix"), blocks, "numpy")["M"]
    condition = np.linalg.cond(mass).max() if mass.size else 1.0
    for method in methods(name):
        plain = told(name, method, ())
        for rewrites in [*((key,) for key in REWRITES), None]:
            made = told(name, method, rewrites)
            for of in TOLD:
                try:
                    exact = evaluate(plain.function(of), blocks, "numpy")
                except DerivationError:
                    continue
                found = evaluate(made.function(of), blocks, "numpy")
                for output, value in exact.items():
                    # sums of turned and regrouped numbers round; solving with M amplifies it
                    scale = max(1.0, np.abs(value).max(initial=0))
                    solved = condition if of in ("rhs", "forward_dynamics") else 1.0
                    error = np.abs(found[output] - value).max(initial=0) / scale
                    assert error <= 1000 * EPS * solved, (method, rewrites, of)


@pytest.mark.parametrize("name", some(ZOO, 6, 2))
def test_no_rewrite_adds_operations(name: str) -> None:
    for method in methods(name):
        for of in COUNTED:
            full = told(name, method, None)
            try:
                total = full.operations_of(of).total
            except DerivationError:
                continue
            described = told(name, method, ()).operations_of(of).total
            assert total <= described + LEEWAY, (method, of)
            for key in full.rewritten(of):
                rest = tuple(n for n in full.rewritten(of) if n != key)
                without = told(name, method, rest).operations_of(of).total
                assert total <= without + LEEWAY, (method, of, key)


@pytest.mark.parametrize("key", REWRITES)
@pytest.mark.parametrize("name", some(ZOO, 6, 4))
def test_a_second_time_changes_nothing(name: str, key: str) -> None:
    once = REWRITES[key](derived(name).system)
    assert REWRITES[key](once) is once


@pytest.mark.parametrize("angle", [1e-3, 1e-7, 1e-10, 2e-12, 1e-13, 0.0])
def test_lines_that_are_nearly_parallel(angle: float) -> None:
    scene = cd.Scene("near", gravity=(0, 0, -9.81))
    inner, turn = scene.ground, scene.parameter("turn", angle)
    for i in range(4):
        link = scene.body(f"link{i}", mass=1.0, com=(0.1, 0.2, 0.3), inertia=(0.1, 0.2, 0.25))
        place = inner.at(0.3, 0.1, 0.2, rotation=("XYZ", turn, 0, 0)) if i else inner
        scene.joint(f"joint{i}", cd.Revolute((1, 2, 3)), place, link)
        inner = link
    plain = cd.derive(scene, rewrites=())
    blocks = {"t": [0.0], "p": [p.value for p in plain.system.parameters], "r": []}
    blocks |= {"q": [0.3, -0.4, 0.5, 0.7], "u": [1.0, -2.0, 0.5, 1.0], "tau": [0.0] * 4}
    exact = evaluate(plain.function("forward_dynamics"), blocks, "mp")["udot"]
    found = evaluate(cd.derive(scene).function("forward_dynamics"), blocks)["udot"]
    worst = max(abs(float(a - b)) for a, b in zip(found, exact, strict=True))
    assert worst <= 1e-12 * max(abs(float(x)) for x in exact)
