"""Dependent increments and speeds eliminated: what is left is free of constraints.

With e = J y and v = W w + Y y the equations of motion, projected on W, are

    M w' + C w + K y + by_z z = by_r r,     y' = Ty y + Tw w,

where accelerations are v' = W w' + Vy y + Vw w.

Source: R. E. Roberson, R. Schwertassek, Dynamics of Multibody Systems (1988), chapter 13.
"""

from __future__ import annotations

from ...ir.matrix import Matrix
from ...records import dataclass
from .all_coordinates import FullMatrices
from .reference import Reference, picked


@dataclass(frozen=True)
class Reduced:
    """Equations in independent increments y and speeds w.

    Attributes:
        M, C, K: (nw, nw), (nw, nw), (nw, ny).
        by_z, by_r: (nw, nz), (nw, nr).
        Ty, Tw: (ny, ny), (ny, nw).
        Tydot: Rate of Ty along the reference; None where dependent increments are in it.
        J: All increments (nu, ny). Y, W: All speeds (nu, ny), (nu, nw).
        Vy, Vw: Accelerations (nu, ny), (nu, nw) besides W w'.
    """

    M: Matrix
    C: Matrix
    K: Matrix
    by_z: Matrix
    by_r: Matrix
    Ty: Matrix
    Tw: Matrix
    Tydot: Matrix | None
    J: Matrix
    Y: Matrix
    W: Matrix
    Vy: Matrix
    Vw: Matrix


def reduced(at: Reference, x: FullMatrices) -> Reduced:
    """The equations of the independent increments and speeds."""
    W = at.W
    J = at.expanded(x.G, at.rows_y, at.dependent_y, at.y)
    Y = _follow(at, x.R @ J)
    Vw = _follow(at, x.Qv @ W)
    Vy = _follow(at, x.Qe @ J + x.Qv @ Y)
    left = W.T
    inertia = left @ x.M
    rotation_terms = x.E @ J + Y
    rows = range(rotation_terms.columns)
    tree = not at.system.closed
    return Reduced(
        M=inertia @ W,
        C=inertia @ Vw + left @ (x.C @ W),
        K=inertia @ Vy + left @ (x.K @ J + x.C @ Y),
        by_z=left @ x.by_z,
        by_r=left @ x.by_r,
        Ty=picked(rotation_terms, at.y, rows),
        Tw=picked(W, at.y, range(W.columns)),
        Tydot=x.Edot if tree else None,
        J=J,
        Y=Y,
        W=W,
        Vy=Vy,
        Vw=Vw,
    )


def _follow(at: Reference, missing: Matrix) -> Matrix:
    """X (nu, n) with G X = -missing and nothing along the independent speeds."""
    change = at.by_dependent(
        at.G, at.rows_w, at.dependent_w, -picked(missing, at.rows_w, range(missing.columns))
    )
    still = Matrix.zeros(at.graph, len(at.w), missing.columns)
    return at.joined(at.w, at.dependent_w, still, change)
