"""Directional derivatives of FMUs are exact: those of the model, in the coordinates as stored."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cardan.schema.functions import FUNCTIONS
from codegen.fmu.importing import Instance, description, model_of, unit
from codegen.fmu.scenes import CASES
from codegen.running import compilers

pytestmark = pytest.mark.skipif(not compilers(), reason="needs a C compiler")

QUICK = ("tumbling", "gauges")
SMOOTH = [name for name, case in CASES.items() if not case.elements]
NAMES = [pytest.param(n, marks=[] if n in QUICK else [pytest.mark.slow]) for n in SMOOTH]
# of sums of rounded products, against the largest entry
EXACT = 1e-12


def at_a_state(name: str) -> tuple[Instance, np.ndarray]:
    """An instance for model exchange at a state in the middle of the motion, and that state."""
    case, model = CASES[name], model_of(name)
    motion = model.simulate(
        np.linspace(0, 0.3 * case.end, 3),
        q=dict(case.q),
        u=dict(case.u),
        inputs=dict(case.inputs),
        rtol=1e-9,
    )
    one = Instance(unit(name), "me")
    one.set(dict(case.inputs))
    one.begin()
    one.update()
    one.fmu.enterContinuousTimeMode()
    x = motion.x[-1, : model.nx]
    one.set_states(x)
    return one, x


def blocks_of(name: str, x: np.ndarray, one: Instance) -> dict[str, Any]:
    """Arguments of the functions of a model at that state."""
    model, case = model_of(name), CASES[name]
    q, u, z = model.parts_of(x)
    modes = [row.name for row in model.manifest.s]
    r = [dict(case.inputs).get(row.name, row.default) for row in model.manifest.inputs]
    # names that coordinates have too are those of the modes behind their kind
    names = [m if m not in model.coordinates else f"mode.{m}" for m in modes]
    given = {"t": 0.0, "q": q, "u": u, "z": z, "s": np.array(one.get(*names)), "r": np.array(r)}
    return {k: v for k, v in given.items() if k == "t" or len(v)}


def called(name: str, function: str, given: dict[str, Any], wrt: tuple[str, ...]) -> Any:
    """A derivative of the model, as a matrix (rows, columns)."""
    model = model_of(name)
    row = FUNCTIONS[function]
    read = {k: v for k, v in given.items() if k in row.arguments}
    result = model.derivative(function, wrt=wrt)(**read)
    return np.hstack([np.reshape(p, (-1, np.shape(p)[-1])) for p in result])


@pytest.mark.parametrize("name", NAMES)
def test_rates_by_states_and_inputs(name: str) -> None:
    model = model_of(name)
    one, x = at_a_state(name)
    with one:
        given = blocks_of(name, x, one)
        jacobian = model.rhs_jacobian(0.0, x, **{k: given[k] for k in "rs" if k in given})
        by_x, by_r = jacobian[0], (jacobian[2] if len(jacobian) > 2 else np.zeros((model.nx, 0)))
        states, rates = one.state_names(), [f"der({n})" for n in one.state_names()]
        inputs = [row.name for row in model.manifest.inputs]
        # tangent to quaternions, along which the model is at home
        free = np.eye(model.nx)
        for first in model.manifest.quaternions:
            q = x[first : first + 4]
            free[first : first + 4, first : first + 4] -= np.outer(q, q) / (q @ q)
        scale = max(1.0, float(np.abs(by_x).max()))
        for column in free.T:
            values = one.derivative(rates, states, column)
            assert values == pytest.approx(by_x @ column, abs=EXACT * scale)
        for k, entry in enumerate(inputs):
            values = one.derivative(rates, [entry], [1.0])
            assert values == pytest.approx(by_r[:, k], abs=EXACT * scale)


@pytest.mark.parametrize("name", ["gauges", pytest.param("cart", marks=pytest.mark.slow)])
def test_outputs_and_energies(name: str) -> None:
    model = model_of(name)
    one, x = at_a_state(name)
    with one:
        given = blocks_of(name, x, one)
        states = one.state_names()
        energies = [f"energy.{n}" for n in ("kinetic", "potential", "total")]
        outputs = [row.name for row in model.manifest.outputs]
        pairs = {"energy": energies, **({"outputs": outputs} if outputs else {})}
        for function, names in pairs.items():
            expected = called(name, function, given, ("q", "u"))
            values = np.array([one.derivative(names, [n], [1.0]) for n in states]).T
            assert values == pytest.approx(expected, abs=EXACT * max(1, np.abs(expected).max()))


@pytest.mark.parametrize("name", NAMES)
def test_differences_and_adjoints(name: str) -> None:
    """Every derivative is that of what the FMU itself gives, and the adjoint one its transpose."""
    one, x = at_a_state(name)
    with one:
        outputs = [n for n in one.outputs() if n not in one.state_names()]
        states = one.state_names()
        unknowns = [*(f"der({n})" for n in states), *outputs]
        knowns = [*states, *(row.name for row in model_of(name).manifest.inputs)]
        rng = np.random.default_rng(1)
        # off the unit sphere too
        x = x * (1 + 1e-3 * rng.standard_normal(len(x)))
        one.set_states(x)
        J = np.array([one.derivative(unknowns, [n], [1.0]) for n in knowns]).T
        scale = max(1.0, float(np.abs(J).max()))
        for k in range(len(states)):
            h = 1e-6 * max(1.0, abs(x[k]))
            sides = []
            for sign in (1, -1):
                moved = x.copy()
                moved[k] += sign * h
                one.set_states(moved)
                sides.append(np.array(one.get(*unknowns)))
            one.set_states(x)
            assert J[:, k] == pytest.approx((sides[0] - sides[1]) / (2 * h), abs=1e-6 * scale)
        seed = rng.standard_normal(len(unknowns))
        a, b = ([one.references[n] for n in names] for names in (unknowns, knowns))
        adjoint = np.array(one.fmu.getAdjointDerivative(a, b, list(seed), len(b)))
        assert adjoint == pytest.approx(seed @ J, abs=1e-12 * scale * len(seed))


@pytest.mark.slow
def test_by_parameters() -> None:
    model, name = model_of("pendulum"), "pendulum"
    one, x = at_a_state(name)
    with one:
        given = blocks_of(name, x, one)
        parameters = [row.name for row in model.manifest.parameters]
        rates = [f"der({n})" for n in one.state_names()]
        expected = called(name, "forward_dynamics", given, ("p",))
        values = np.array([one.derivative(rates, [p], [1.0]) for p in parameters]).T
        scale = max(1.0, float(np.abs(expected).max()))
        assert values[model.nq :] == pytest.approx(expected, abs=EXACT * scale)
        assert not values[: model.nq].any()


@pytest.mark.slow
def test_elements_have_none_and_say_so() -> None:
    about = description(unit("rubber")).coSimulation
    assert not about.providesDirectionalDerivative
    with Instance(unit("rubber")) as one:
        one.begin()
        with pytest.raises(Exception, match="failed with status 3"):
            one.derivative(["energy.total"], ["pin"], [1.0])
        assert "was exported without them" in one.messages[-1]
