"""Small motions of all increments and speeds, before dependent ones are eliminated.

Increments e move the coordinates along the speeds, v and a are changes of the speeds and of their
derivatives, lam the multipliers of the reference. To first order

    M a + C v + K e + by_z z = by_r r + Gᵀ dlam,     e' = E e + v,
    G v + R e = 0,   G a + Qv v + Qe e = 0,   z' = Ze e + Zv v + Zz z + Zr r.

K contains what a change of G does to the multipliers of the reference.

Source: R. E. Roberson, R. Schwertassek, Dynamics of Multibody Systems (1988), chapter 13.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields

from ...ir.matrix import Matrix
from ...records import dataclass


@dataclass(frozen=True)
class FullMatrices:
    """The matrices of all increments.

    Attributes:
        M, C, K: (nu, nu).
        by_z, by_r: (nu, nz), (nu, nr).
        G, R, Qv, Qe: (m, nu); rows of position level first.
        E, Edot: (nu, nu), and its rate along the reference.
        Ze, Zv, Zz, Zr: (nz, ...).
        ye, yv, yz, yr, ya: Change of declared outputs with e, v, z, r and a.
        N: Change of the coordinates with e (nq, nu).
        edot: Rates of increments along the reference (nu, 1): where it goes. zdot: (nz, 1).
    """

    M: Matrix
    C: Matrix
    K: Matrix
    by_z: Matrix
    by_r: Matrix
    G: Matrix
    R: Matrix
    Qv: Matrix
    Qe: Matrix
    E: Matrix
    Edot: Matrix
    Ze: Matrix
    Zv: Matrix
    Zz: Matrix
    Zr: Matrix
    ye: Matrix
    yv: Matrix
    yz: Matrix
    yr: Matrix
    ya: Matrix
    N: Matrix
    edot: Matrix
    zdot: Matrix

    def map(self, f: Callable[[Matrix], Matrix]) -> FullMatrices:
        """The same with every matrix replaced."""
        return FullMatrices(**{entry.name: f(getattr(self, entry.name)) for entry in fields(self)})


# what the two ways to a linear model have to say: all that costs work
DYNAMIC = ("M", "C", "K", "G", "R", "Qv", "Qe")
