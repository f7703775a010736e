"""Formulas that readers see of flexible elements are what their functions compute."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cardan.elements.flexible import BEAMS, FLEXIBLE, INERTIAS, FlexibleElement, GravityField
from cardan.elements.forces.gravity.gravity_gradient import GravityGradient
from cardan.equations.reading.typesetting import typeset, unbroken
from cardan.ir.interpreter import evaluate
from elements.formula_values import computed, data_of, skew

ELEMENTS: dict[str, FlexibleElement] = {
    **BEAMS, **INERTIAS,
    **{k: FLEXIBLE[k]() for k in FLEXIBLE if k not in ("hellinger_reissner", "linked_inertia",
       "lumped_inertia", "helicoidal", "classical")},
    "field at the ends": GravityField(lumped=True),
    "gradient": GravityField(GravityGradient("ground", 1.0)),
    "gradient at the ends": GravityField(GravityGradient("ground", 1.0), lumped=True),
}  # fmt: skip
# solves of six equations with stiffness of one magnitude
ROUNDING = 1e-10


@pytest.mark.parametrize("name", ELEMENTS)
def test_balance_and_energy(name: str) -> None:
    """Formulas by NumPy and functions by the interpreter, at random poses and motions."""
    element = ELEMENTS[name]
    rng = np.random.default_rng(sum(name.encode()))
    functions = element.derived()
    for _ in range(5):
        inputs = _state(rng, element.data())
        given = data_of(element, inputs)
        if name != "lumped":
            values = computed(element.formula_lines, given)
        else:
            ends = [computed(element.formula_lines, given | _end(given, k)) for k in (1, 2)]
            values = {x: sum(end[x] for end in ends) for x in "TV"}
            values["b"] = np.vstack([end[x] for end in ends for x in ("b_m", "b_f")])
        b = np.ravel(evaluate(functions["balance"], inputs, "numpy")["balance"])
        assert np.abs(np.ravel(values["b"]) - b).max() <= ROUNDING * np.abs(b).max()
        if "energy" in functions:
            energy = np.ravel(evaluate(functions["energy"], inputs, "numpy")["energy"])
            shown = [float(np.squeeze(values.get(x, 0.0))) for x in "TV"]
            assert np.allclose(shown, energy, rtol=ROUNDING, atol=0)


def _state(rng: np.random.Generator, data: tuple[str, ...]) -> dict[str, Any]:
    q = rng.normal(size=(2, 7))
    q[1, :4] = q[0, :4] + 0.4 * rng.normal(size=4)
    q[:, :4] /= np.linalg.norm(q[:, :4], axis=1)[:, None]
    p = rng.uniform(0.5, 1.5, len(data))
    return {"q": q.ravel(), "u": rng.normal(size=12), "udot": rng.normal(size=12), "p": p}


def _end(given: dict[str, Any], k: int) -> dict[str, Any]:
    """Motion of end k."""
    return {x: given[f"{x}_{k}"] for x in ("p", "v", "vdot", "omega", "omegadot")}


def test_typeset() -> None:
    text, mathml, latex = unbroken(typeset("V = dot(y, A.T @ y) / 2 - (a + b_1) * c ** 2"))
    assert text == "V = (y · Aᵀ y) / 2 - (a + b_1) c^2"
    assert mathml.count("<mfrac>") == 1
    assert "<mi>T</mi>" in mathml
    assert latex == r"V = \frac{y \cdot {A}^T \, y}{2} - (a + b_{1}) \, {c}^{2}"


@pytest.mark.parametrize("name", ["hellinger_reissner", "linked"])
def test_forces_are_carried_to_the_node(name: str) -> None:
    """An end off its node, and one at the ground, as the page says."""
    element, rng = ELEMENTS[name], np.random.default_rng(7)
    inputs = _state(rng, element.data(("offset", "node")))
    R, s = np.linalg.qr(rng.normal(size=(3, 3)))[0], 0.3 * rng.normal(size=(3, 1))
    R *= np.linalg.det(R)
    placed = dict(zip(element.data(("offset", "node")), inputs["p"], strict=True))
    placed |= {f"start_R{i + 1}{j + 1}": R[i, j] for i in range(3) for j in range(3)}
    placed |= {f"start_p{x}": s[i, 0] for i, x in enumerate("xyz")}
    inputs["p"] = np.array(list(placed.values()))
    plain = inputs | {"p": inputs["p"][: len(element.data())]}
    given = data_of(element, plain)
    node, omega, omegadot = given["R_1"], given["omega_1"], given["omegadot_1"]
    spun = skew(omega)
    given |= {
        "R_1": node @ R,
        "p_1": given["p_1"] + node @ s,
        "omega_1": R.T @ omega,
        "omegadot_1": R.T @ omegadot,
        "v_1": given["v_1"] + node @ spun @ s,
        "vdot_1": given["vdot_1"] + node @ (skew(omegadot) + spun @ spun) @ s,
    }
    b = computed(element.formula_lines, given)["b"]
    b[:3] = R @ b[:3] + skew(s) @ node.T @ b[3:6]
    balance = element.derived(("offset", "node"))["balance"]
    expected = np.ravel(evaluate(balance, inputs, "numpy")["balance"])
    assert np.abs(np.ravel(b) - expected).max() < ROUNDING * np.abs(expected).max()
