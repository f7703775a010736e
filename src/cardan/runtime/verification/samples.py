"""Check functions of written equations against what SymPy said when they were taken over.

The manifest has its numbers at some states; neither SymPy nor an expression of the model is needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...schema.tree import SampleRow

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel

CHANGED = "not checked: values are built in that SymPy's numbers do not belong to"
YIELDING = "not checked: constraints treated by '{}' give way"
NO_NUMBERS = "not checked: SymPy tells no numbers of it"


def samples_of(model: LoadedModel) -> Sequence[SampleRow]:
    """The states of which SymPy's numbers are known; none of models of bodies."""
    return model.manifest.scene.samples


def error(model: LoadedModel, name: str) -> tuple[float, str]:
    """Largest difference of a function over the largest term of its equation, or why not known."""
    rows = samples_of(model)
    built = model.manifest.structural
    if any(built.get(key, value) != value for s in rows for key, value in s.p.items()):
        return np.nan, CHANGED
    treatment = model.manifest.scene.treatment
    if name in ("forward_dynamics", "rhs") and treatment and not treatment.exact:
        return np.nan, YIELDING.format(treatment.name)
    if name not in CHECKS:
        return np.nan, NO_NUMBERS
    return max(CHECKS[name](model, sample) for sample in rows), ""


def _inputs(model: LoadedModel, sample: SampleRow, *blocks: str) -> dict[str, Any]:
    """Arguments of a function at a sample."""
    names = set(model.parameters)
    values = {key: value for key, value in sample.p.items() if key in names}
    arrays = {block: np.array(getattr(sample, block), dtype=np.float64) for block in blocks}
    r = model._vector("r", dict(sample.r))
    return {**arrays, "t": sample.t, "r": r, "parameters": values or None}


def _relative(difference: Array, *terms: Array) -> float:
    """Largest entry of a difference over that of the terms in it."""
    largest = max((float(np.abs(x).max(initial=0.0)) for x in terms), default=0.0)
    # a larger number would hide one that is none
    gap = np.where(np.isnan(difference), np.inf, np.abs(difference))
    return float(gap.max(initial=0.0)) / max(largest, 1e-300)


def _mass_matrix(model: LoadedModel, sample: SampleRow) -> float:
    M = np.array(sample.M)
    return _relative(model.mass_matrix(**_inputs(model, sample, "q")) - M, M)


def _qdot(model: LoadedModel, sample: SampleRow) -> float:
    rates = np.array(sample.qdot)
    return _relative(model.qdot(**_inputs(model, sample, "q", "u")) - rates, rates)


def _bias(model: LoadedModel, sample: SampleRow) -> float:
    """All forces are applied ones."""
    return _relative(model.bias(**_inputs(model, sample, "q", "u")), np.ones(1))


def _inverse(model: LoadedModel, sample: SampleRow) -> float:
    M, f = np.array(sample.M), np.array(sample.f)
    udot = np.linspace(-1.0, 1.0, len(f))
    tau = model.inverse_dynamics(**_inputs(model, sample, "q", "u"), udot=udot)
    return _relative(tau - (M @ udot - f), M * udot, f)


def _forward(model: LoadedModel, sample: SampleRow) -> float:
    return _balance(sample, model.forward_dynamics(**_inputs(model, sample, "q", "u")))


def _rhs(model: LoadedModel, sample: SampleRow) -> float:
    inputs = _inputs(model, sample, "q", "u")
    start = model._layout.start("z")
    x = np.concatenate([inputs.pop("q"), inputs.pop("u"), start])
    qdot, udot = model.split(model.rhs(inputs.pop("t"), x, inputs.pop("r"), **inputs))
    rates = np.array(sample.qdot)
    return max(_balance(sample, udot), _relative(qdot - rates, rates))


def _balance(sample: SampleRow, udot: Array) -> float:
    """Residual of SymPy's rows at the accelerations, over the largest product or number in it."""
    rows, right = np.array(sample.rows), np.array(sample.right)
    return _relative(rows @ udot - right, rows * udot, right)


CHECKS = {
    "mass_matrix": _mass_matrix,
    "qdot": _qdot,
    "bias": _bias,
    "inverse_dynamics": _inverse,
    "forward_dynamics": _forward,
    "rhs": _rhs,
}
