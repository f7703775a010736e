"""Equations of second order, M y'' + (D + G) y' + (K + N) y = B r, and their four parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...arrays import Array
from ...errors import DerivationError
from ...ir.matrix import Matrix
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


def second_order(at: Reference, x: Reduced, wanted: Sequence[int]) -> Parts:
    """The equations of some increments, where no others enter them.

    Args:
        wanted: Speeds along which the increments are.

    Raises:
        DerivationError: other increments or speeds enter them, or they are not independent.
    """
    names = at.increments
    for k in wanted:
        if k not in at.y or k not in at.w:
            raise DerivationError(
                f"linearize: '{names[k]}' depends on the others, or they on each other: "
                f"{len(at.w)} speeds are independent, such as {', '.join(names[w] for w in at.w)}"
            )
    own_y, own_w = [at.y.index(k) for k in wanted], [at.w.index(k) for k in wanted]
    other_y = [n for n in range(len(at.y)) if n not in own_y]
    other_w = [n for n in range(len(at.w)) if n not in own_w]
    for p in at.trials():
        rows = [at.number(picked(m, own_w, range(m.columns)), p) for m in (x.M, x.C, x.K)]
        sizes = [float(np.abs(row).max(initial=0.0)) for row in rows]
        own = (other_w, at.w), (other_w, at.w), (other_y, at.y)
        for row, size, (others, columns) in zip(rows, sizes, own, strict=True):
            least = max(ROUNDING * size, EPS * max(sizes))
            _refuse_others(at, row[:, others], least, [columns[n] for n in others], wanted)
    M, C, K = picked(x.M, own_w, own_w), picked(x.C, own_w, own_w), picked(x.K, own_w, own_y)
    turned = picked(x.Ty, own_y, own_y)
    moved = picked(x.Tw, own_y, own_w) - Matrix.identity(at.graph, len(wanted))
    if any(np.abs(at.number(moved, p)).max(initial=0.0) > ROUNDING for p in at.trials()):
        raise DerivationError("linearize: the independent speeds are no rates of the increments")
    if not turned.is_zero:
        # w = y' - T y
        if x.Tydot is None:
            raise DerivationError(
                "linearize: increments of turning bodies in closed circuits have no equations of "
                "second order here. Take A and B"
            )
        K = K - C @ turned - M @ picked(x.Tydot, wanted, wanted)
        C = C - M @ turned
    return Parts(M, C, K, -picked(x.by_z, own_w, range(x.by_z.columns)))


def _refuse_others(
    at: Reference, coupling: Array, least: float, others: Sequence[int], wanted: Sequence[int]
) -> None:
    """Nothing but what is wanted may stand in its equations beyond rounding."""
    for n, value in enumerate(np.abs(coupling).max(axis=0, initial=0.0)):
        if value > least:
            told = ", ".join(at.increments[k] for k in wanted)
            raise DerivationError(
                f"linearize: '{at.increments[others[n]]}' enters the equations of {told}: take it "
                "along, or A and B"
            )


def parts_of(x: Matrix) -> tuple[Matrix, Matrix]:
    """Symmetric and skew part."""
    return (x + x.T) / 2, (x - x.T) / 2
