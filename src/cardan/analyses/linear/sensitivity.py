"""Derivatives of eigenvalues by parameters: wᴴ dA/dp v / wᴴ v, the motion moving along.

The linear model is that of the equilibrium, steady motion or trim at the changed parameter: dA/dp
is the whole derivative. It comes from central differences at three steps, extrapolated to step 0
(the model has first derivatives of its functions, A is made of them); what the last extrapolation
changes is told as the error.

Source: J. H. Wilkinson, The Algebraic Eigenvalue Problem (1965), chapter 2 (first-order
perturbation); A. P. Seyranian, A. A. Mailybaev, Multiparameter Stability Theory with Mechanical
Applications (2003), chapter 2.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, final

import numpy as np

from ...arguments import checked
from ...arrays import Array, Complex
from ...errors import ModelError, listed, near
from ...records import dataclass
from ..statics.equilibrium import EquilibriumRecord, equilibrium
from .family import Family, Member
from .steady_motion import SteadyMotionRecord

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

STEP = 0.02  # of a parameter, the longest; of 1 where it is 0
LEVELS = 3
MAX_PRINTED = 10


@final
@dataclass(frozen=True, repr=False, eq=False)
class Sensitivity:
    """Derivatives of eigenvalues by parameters.

    Attributes:
        name: Of the model.
        parameters: Name -> value (np).
        eigenvalues: (n,) [1/s], as the linear model has them.
        values: d eigenvalue / d parameter (n, np); NaN where eigenvalues are defective: they move
            with a root of the parameter.
        errors: Of them, as extrapolation tells it (n, np).
    """

    name: str
    parameters: Mapping[str, float]
    eigenvalues: Complex
    values: Complex
    errors: Array

    def __getitem__(self, name: str) -> Complex:
        if name not in self.parameters:
            raise ModelError(f"sensitivity['{name}']: not asked for.{near(name, self.parameters)}")
        return np.asarray(self.values[:, list(self.parameters).index(name)])

    def __repr__(self) -> str:
        lines = [f"'{self.name}': change of eigenvalues [1/s] for the whole of each parameter"]
        names = list(self.parameters)
        lines.append(f"  {'eigenvalue':<24}" + "".join(f"{name:>24}" for name in names))
        upper = np.flatnonzero(self.eigenvalues.imag >= 0)
        for k in upper[:MAX_PRINTED]:
            row = f"  {_number(self.eigenvalues[k]):<24}"
            scaled = self.values[k] * np.array([*self.parameters.values()])
            row += "".join(f"{_number(x):>24}" for x in scaled)
            lines.append(row)
        lines += [f"  ... {len(upper) - MAX_PRINTED} more"] if len(upper) > MAX_PRINTED else []
        if np.isnan(self.values).any():
            lines.append("  '-': the eigenvalue is defective and has no derivative")
        return "\n".join(lines)


@checked
def sensitivity(
    model: LoadedModel,
    parameters: Iterable[str] | str,
    about: EquilibriumRecord | SteadyMotionRecord | None = None,
) -> Sensitivity:
    """Derivatives of eigenvalues by parameters, the motion moving along with them.

    Args:
        model: The compiled model.
        parameters: Their names.
        about: An equilibrium, a steady motion or a trim, found anew for every value; that next to
            the initial position if left out.

    Raises:
        ModelError: unknown names, or something that is no such motion.
        SolveError: there is no such motion beside it.
    """
    names = listed("parameters", parameters, "mass")
    unknown = next((name for name in names if name not in model.parameters), None)
    if unknown is not None or not names:
        raise ModelError(
            f"sensitivity: there is no parameter '{unknown or ''}'."
            f"{near(unknown or '', model.parameters)}"
        )
    state = equilibrium(model, check=True) if about is None else about
    members = _neighbors(state, names)
    base = members.member(0.0, {}, None)
    derivatives = [_derivative(members, base, name) for name in names]
    values = np.array([base.spectrum.derivative(dA) for dA, _ in derivatives]).T
    rough = np.array([base.spectrum.derivative(dA - off) for dA, off in derivatives]).T
    nominal = {name: float(state.model.parameters[name]) for name in names}
    shape = len(base.values), len(names)
    values, rough = values.reshape(shape), rough.reshape(shape)
    return Sensitivity(model.name, nominal, base.values, values, np.abs(values - rough))


def _neighbors(state: object, names: list[str]) -> Family:
    """The motions beside one, as parameters change."""
    kinds = dict.fromkeys(names, "parameters")
    if isinstance(state, SteadyMotionRecord):
        return Family(state.model, {}, kinds, state.trim_arguments)
    if isinstance(state, EquilibriumRecord):
        load = state.load
        arguments = {"q": state.q, "locked": dict(load.locked), "inputs": dict(state.inputs),
                 "t": state.t}  # fmt: skip
        return Family(state.model, {}, kinds, arguments | ({} if load.u is None else {"u": load.u}))
    raise ModelError(
        f"sensitivity: about={state!r}: give model.equilibrium(...) or model.trim(...), which can "
        "be found anew for other parameters"
    )


def _derivative(members: Family, base: Member, name: str) -> tuple[Array, Array]:
    """dA/dp (n, n), and what the last extrapolation changed of it."""
    value = float(members.model.parameters[name])
    rows = list[Array]()
    for level in range(LEVELS):
        h = STEP * (abs(value) or 1.0) / 2**level
        sides = [
            members.member(0.0, {name: value + sign * h}, base, base.linear.choice).linear.A
            for sign in (1, -1)
        ]
        rows.append((sides[0] - sides[1]) / (2 * h))
    # the error of a central difference has even powers of the step
    table = [rows]
    for k in range(1, LEVELS):
        last = table[-1]
        table.append([b + (b - a) / (4**k - 1) for a, b in pairwise(last)])
    return table[-1][0], table[-1][0] - table[-2][-1]


def _number(value: complex) -> str:
    if np.isnan(value):
        return "-"
    real = 0.0 if abs(value.real) < 1e-9 * abs(value) else value.real
    imag = 0.0 if abs(value.imag) < 1e-9 * abs(value) else value.imag
    return f"{real:.5g}" + (f" {'-' if imag < 0 else '+'} {abs(imag):.5g} i" if imag else "")
