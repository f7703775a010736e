"""Projection on the null space of the constraint Jacobian."""

from __future__ import annotations

from typing import ClassVar

from ....ir.matrix import Matrix
from ....ir.solve import solve
from ....records import dataclass
from .treatment import Bound, Treatment, by_motions


@dataclass(frozen=True)
class NullSpace(Treatment):
    """The balance is taken on the orthogonal complement of the rows of G.

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001); W. Kamman, R. Huston, J. Appl.
        Mech. 51 (1984).
    """

    name: ClassVar[str] = "null_space"
    exact: ClassVar[bool] = True

    def accelerations(self, bound: Bound) -> tuple[Matrix, Matrix]:
        G = bound.jacobian
        n = G.columns
        across = G.T @ solve("semidefinite", (G @ G.T).mirrored, Matrix.hstack(bound.gamma, G))
        across_motions = across.block(slice(0, n), slice(1, 1 + n))
        return by_motions(bound, across.column(0), across_motions.mirrored)
