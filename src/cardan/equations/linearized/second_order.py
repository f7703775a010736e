"""Equations of second order, M y'' + (D + G) y' + (K + N) y = B r, and their four parts."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...arrays import Array
from ...errors import DerivationError
from ...ir.matrix import Matrix
from ...records import dataclass
from .reduced import Reduced
from .reference import Reference, picked

ROUNDING = 1e-11  # of the largest entry of the same matrix
EPS = 1e-15  # of the largest entry of all of them


@dataclass(frozen=True)
class Parts:
    """Matrices of the equations of second order as expressions.

    Attributes:
        M, damping, K: (n, n).
        inner: What multiplies internal states, on the right side (n, nz).
    """

    M: Matrix
    damping: Matrix
    K: Matrix
    inner: Matrix


def second_order(at: Reference, x: Reduced, chosen: Sequence[int]) -> Parts:
    """The equations of some increments, where no others enter them.

    Args:
        chosen: Speeds along which the increments are.

    Raises:
        DerivationError: other increments or speeds enter them, or they are not independent.
    """
    names = at.increments
    for k in chosen:
        if k not in at.y or k not in at.w:
            raise DerivationError(
                f"linearize: '{names[k]}' depends on the others, or they on each other: "
                f"{len(at.w)} speeds are independent, such as {', '.join(names[w] for w in at.w)}"
            )
    rows_y, rows_w = [at.y.index(k) for k in chosen], [at.w.index(k) for k in chosen]
    other_y = [n for n in range(len(at.y)) if n not in rows_y]
    other_w = [n for n in range(len(at.w)) if n not in rows_w]
    for p in at.trials():
        rows = [at.number(picked(m, rows_w, range(m.columns)), p) for m in (x.M, x.C, x.K)]
        sizes = [float(np.abs(row).max(initial=0.0)) for row in rows]
        couplings = (other_w, at.w), (other_w, at.w), (other_y, at.y)
        for row, size, (other_columns, columns) in zip(rows, sizes, couplings, strict=True):
            least = max(ROUNDING * size, EPS * max(sizes))
            _check_decoupled(
                at, row[:, other_columns], least, [columns[n] for n in other_columns], chosen
            )
    M, C, K = picked(x.M, rows_w, rows_w), picked(x.C, rows_w, rows_w), picked(x.K, rows_w, rows_y)
    rotation_terms = picked(x.Ty, rows_y, rows_y)
    moved = picked(x.Tw, rows_y, rows_w) - Matrix.identity(at.graph, len(chosen))
    if any(np.abs(at.number(moved, p)).max(initial=0.0) > ROUNDING for p in at.trials()):
        raise DerivationError("linearize: the independent speeds are not rates of the increments")
    if not rotation_terms.is_zero:
        # w = y' - T y
        if x.Tydot is None:
            raise DerivationError(
                "linearize: increments of turning bodies in closed loops have no equations of "
                "second order here. Take A and B"
            )
        K = K - C @ rotation_terms - M @ picked(x.Tydot, chosen, chosen)
        C = C - M @ rotation_terms
    return Parts(M, C, K, -picked(x.by_z, rows_w, range(x.by_z.columns)))


def _check_decoupled(
    at: Reference,
    coupling: Array,
    least: float,
    other_increments: Sequence[int],
    chosen: Sequence[int],
) -> None:
    """Nothing but what is wanted may stand in its equations beyond rounding."""
    for n, value in enumerate(np.abs(coupling).max(axis=0, initial=0.0)):
        if value > least:
            names = ", ".join(at.increments[k] for k in chosen)
            raise DerivationError(
                f"linearize: '{at.increments[other_increments[n]]}' enters the equations of "
                f"{names}: take it "
                "along, or A and B"
            )


def parts_of(x: Matrix) -> tuple[Matrix, Matrix]:
    """Symmetric and skew part."""
    return (x + x.T) / 2, (x - x.T) / 2
