"""Elimination of dependent speeds."""

from __future__ import annotations

from typing import ClassVar

from ....ir.matrix import Matrix
from ....ir.solve import solve
from ....records import dataclass
from .treatment import Bound, Treatment, by_motions


@dataclass(frozen=True)
class Elimination(Treatment):
    """Dependent speeds follow from independent ones; the balance is taken along the latter.

    Which speeds depend is found by complete pivoting of G at every call: no choice can go wrong,
    and the accelerations do not depend on it. With nonholonomic constraints these are Kane's
    equations with dependent speeds.

    Source: R. A. Wehage, E. J. Haug, J. Mech. Design 104 (1982); T. R. Kane, D. A. Levinson,
        Dynamics (1985), section 4.4.
    """

    name: ClassVar[str] = "elimination"
    exact: ClassVar[bool] = True

    def accelerations(self, bound: Bound) -> tuple[Matrix, Matrix]:
        G = bound.jacobian
        graph, m, n = G.graph, G.rows, G.columns
        # the system is square with rows of zeros, or with unknowns that nothing asks for
        size = max(m, n)
        both = Matrix.hstack(bound.gamma, G)
        if m < size:
            both = Matrix.vstack(both, Matrix.zeros(graph, size - m, 1 + n))
        square = both.block(slice(0, size), slice(1, 1 + n))
        if n < size:
            square = Matrix.hstack(square, Matrix.zeros(graph, size, size - n))
        basic = solve("basic", square, both).block(slice(0, n))
        return by_motions(bound, basic.column(0), basic.block(slice(0, n), slice(1, 1 + n)))
