"""Energies of elements as SymPy expressions have the values of their functions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.elements.flexible import BEAMS, FLEXIBLE, INERTIAS, GravityField
from cardan.elements.forces.gravity.gravity_gradient import GravityGradient
from cardan.equations.reading.energy_expressions import EnergyExpressions, energy_of
from cardan.errors import DerivationError
from cardan.ir.interpreter import evaluate
from elements.formula_values import data_of

ELEMENTS = {**BEAMS, "linked": INERTIAS["linked"],
            "dead_load": FLEXIBLE["dead_load"](), "gravity_field": FLEXIBLE["gravity_field"](),
            "gradient": GravityField(GravityGradient("ground", 1.0))}  # fmt: skip
# solves of six equations
ROUNDING = 1e-10


@pytest.mark.parametrize("name", ELEMENTS)
def test_values(name: str) -> None:
    element = ELEMENTS[name]
    energy = energy_of([(element.formula_lines, element.symbol_shapes)])
    function, rng = element.derived()["energy"], np.random.default_rng(sum(name.encode()))
    for _ in range(3):
        q = rng.normal(size=(2, 7))
        q[1, :4] = q[0, :4] + 0.4 * rng.normal(size=4)
        q[:, :4] /= np.linalg.norm(q[:, :4], axis=1)[:, None]
        p = rng.uniform(0.5, 1.5, len(element.data()))
        inputs = {"q": q.ravel(), "u": rng.normal(size=12), "udot": np.zeros(12), "p": p}
        shown = _values(energy, data_of(element, inputs))
        expected = np.ravel(evaluate(function, inputs, "numpy")["energy"])
        assert np.allclose(shown, expected, rtol=ROUNDING, atol=0)


def _values(energy: EnergyExpressions, given: dict[str, Any]) -> list[float]:
    """Both energies, definition after definition; rows of a system together."""
    values = _entries(given)
    systems: list[sympy.Eq] = []
    for equation in energy.definitions:
        if equation.lhs.is_Symbol:
            _solve(systems, values)
            values[equation.lhs] = _value(equation.rhs, values)
        else:
            systems.append(equation)
    _solve(systems, values)
    return [_value(x, values) for x in (energy.kinetic, energy.potential)]


def _value(expression: sympy.Expr, values: dict[sympy.Symbol, float]) -> float:
    names = sorted(expression.free_symbols, key=str)
    function = sympy.lambdify(names, expression, "numpy")
    return float(function(*(values[x] for x in names)))


def _solve(systems: list[sympy.Eq], values: dict[sympy.Symbol, float]) -> None:
    if systems:
        unknown = sorted(
            {x for row in systems for x in row.lhs.free_symbols} - set(values), key=str
        )
        matrix = [[_value(row.lhs.coeff(x), values) for x in unknown] for row in systems]
        right = [_value(row.rhs, values) for row in systems]
        values |= dict(zip(unknown, np.linalg.solve(matrix, right), strict=True))
        systems.clear()


def _entries(given: dict[str, Any]) -> dict[sympy.Symbol, float]:
    """Entries of vectors and matrices by the names that they have."""
    values: dict[sympy.Symbol, float] = {}
    for name, value in given.items():
        array = np.asarray(value if value is not None else np.nan, dtype=float)
        if array.ndim == 0:
            values[sympy.Symbol(name)] = float(array)
            continue
        size = max(array.shape)
        for index, x in np.ndenumerate(array):
            places = index[:1] if array.shape[1] == 1 else index
            if name == "J":
                places = index[:1] if index[0] == index[1] else index
            text = "".join("xyz"[k] if size == 3 else str(k + 1) for k in places)
            joined = f"{name}{text}" if name[-1].isdigit() and size == 3 else f"{name}_{text}"
            values[sympy.Symbol(joined)] = float(x)
    return values


def _equations(**more: Any) -> Any:
    scene = cd.Scene("rod")
    steel = cd.material(E=210e9, nu=0.3, rho=7850)
    scene.beam("rod", scene.ground, (1, 0, 0), cd.section.tube(0.02, 0.002), steel, elements=3)
    if more:
        scene.beam("arm", scene.ground, (0, 1, 0), cd.section.tube(0.02, 0.002), steel,
                   elements=3, **more)  # fmt: skip
    return cd.derive(scene, coordinates="absolute")


def test_a_beam_is_strain_and_mass() -> None:
    equations = _equations(element="hellinger_reissner")
    beam = equations.kinds["beam"]
    assert {kind.element for kind in beam.kinds} >= {"linked_inertia"}
    strain = equations.kinds["hellinger_reissner"].energy
    mass = equations.kinds["linked_inertia"].energy
    assert strain.kinetic == 0
    assert beam.energy.kinetic == mass.kinetic
    assert sympy.expand(beam.energy.potential - strain.potential - mass.potential) == 0
    s_1, GJ, L = sympy.symbols("s_1 GJ L")
    assert sympy.expand(strain.potential).coeff(s_1, 2) == L / (2 * GJ)


def test_kinds_by_name_and_number() -> None:
    equations = _equations()
    assert equations.kinds[0] is equations.kinds[equations.kinds[0].name].kinds[0]
    assert list(equations.kinds[:1]) == [equations.kinds[0]]
    with pytest.raises(DerivationError, match=r"'beams' does not exist.*Did you mean 'beam'"):
        equations.kinds["beams"]


def test_elements_of_several_kinds_have_no_common_energy() -> None:
    equations = _equations(element="classical")
    with pytest.raises(DerivationError, match="ask for one: classical, hellinger_reissner"):
        _ = equations.kinds["beam"].energy
    assert equations.kinds["classical"].energy.potential != 0
