"""The beam of the Hellinger-Reissner principle: stress in equilibrium, helicoidal strain."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from ...ir.solve import ltl, substitute
from ...spatial.short_rotations import Slopes
from .ends import Ends
from .relative import Relative, mirrored
from .section import SECTION, SHAPE, Section, diagonal
from .strain import Field, Law, StrainElement


@dataclass(frozen=True)
class HellingerReissner(StrainElement):
    """Geometrically exact beam with a stress field in equilibrium and helicoidal strain.

    Stress resultants vary linearly along the element as equilibrium has them, n' = -K x n and
    m' = -K x m - E x n; their six unknowns are those of the middle and are condensed exactly. The
    complementary energy is that of this field: nodal displacements are of fourth order in statics
    and nothing locks, however slender.

    Source: Sonneville, Cardona and Brüls, CMAME 268 (2014) for the strain; Pian and Sumihara, IJNME
    20 (1984) for stress fields; their union on SE(3) is our own.
    """

    kind: ClassVar[str] = "hellinger_reissner"
    source: ClassVar[str] = (
        "V. Sonneville, A. Cardona, O. Brüls, Geometrically exact beam finite element formulated "
        "on the special Euclidean group SE(3), CMAME 268, 2014"
    )
    common: ClassVar[tuple[str, ...]] = SECTION
    own: ClassVar[tuple[str, ...]] = SHAPE

    def measures(self, at: Relative) -> tuple[Slopes, Slopes]:
        return Slopes(-0.5), at.inverse

    def field(self, ends: Ends, theta: Matrix, e: Matrix) -> Field:
        return _Varying.of(ends, theta, e)


@dataclass(frozen=True)
class _Varying(Field):
    """Everything that follows from the strain alone.

    The energy is y · s - s · F s / 2 with y the strain of the element, s the stress of the middle
    and F = c + Aᵀ c A / 12, where A s = (theta x m + e x n, theta x n) is the change of stress.
    """

    section: Section
    compliance: Matrix
    twelfth: Matrix
    change: Matrix
    flexibility: Matrix
    factors: tuple[list[list[int]], list[int]]

    @staticmethod
    def of(ends: Ends, theta: Matrix, e: Matrix) -> _Varying:
        g, section = ends.graph, Section.of(ends)
        entries = [section.length / x for x in section.stiffness]
        # a twelfth of the compliance counts where the stress varies
        c, twelfth = diagonal(g, entries), diagonal(g, [x / 12.0 for x in entries])
        change = _blocks(theta.skew, e.skew, Matrix.zeros(g, 3, 3), theta.skew)
        flexibility = c + change.T.congruence(twelfth)
        strain = Matrix.vstack(theta, e) - section.free
        return _Varying(strain, section, c, twelfth, change, flexibility, ltl(flexibility))

    def relaxed(self, stress: Matrix) -> Matrix:
        return self.flexibility @ stress

    def solved(self, right: Matrix) -> Matrix:
        g = right.graph
        return Matrix(g, 6, 1, substitute(*self.factors, g, list(right.nodes)))

    def slope(self, stress: Matrix) -> Matrix:
        g = stress.graph
        tau = self.twelfth @ (self.change @ stress)
        t1, t2 = tau.block(slice(3)).skew, tau.block(slice(3, 6)).skew
        direct = _blocks(t1, Matrix.zeros(g, 3, 3), t2, t1)
        return Matrix.identity(g, 6) - direct - self.change.T @ (self.twelfth @ _turned(stress))

    def law(self, stress: Matrix) -> Law:
        g, turned = stress.graph, _turned(stress)
        m, n = stress.block(slice(3)), stress.block(slice(3, 6))
        varied = self.change @ stress
        tau = self.twelfth @ varied
        t1, t2 = tau.block(slice(3)), tau.block(slice(3, 6))
        bend = mirrored(turned.T @ (self.twelfth @ turned))
        tangent = _condensed(*self.factors, self.slope(stress), bend)
        half = varied * 0.5
        ends = (stress + half, stress - half)
        rest = self.section.free * (1.0 / self.section.length)
        elastic = diagonal(g, [1.0 / x for x in self.section.stiffness])
        return Law(
            m - m.cross(t1) - n.cross(t2),
            n - n.cross(t1),
            tangent,
            (stress.T @ (self.compliance @ stress) + tau.T @ varied) * 0.5,
            ends,
            (rest + elastic @ ends[0], rest + elastic @ ends[1]),
        )


def _turned(stress: Matrix) -> Matrix:
    """Derivative of A s by the strain (6, 6)."""
    m, n = stress.block(slice(3)).skew, stress.block(slice(3, 6)).skew
    return _blocks(-m, -n, -n, Matrix.zeros(stress.graph, 3, 3))


def _condensed(
    lower: list[list[int]], inverse: list[int], slope: Matrix, bend: Matrix
) -> tuple[Matrix, Matrix, Matrix]:
    """Blocks of Bᵀ F⁻¹ B - bend, symmetric (6, 6), from the factors F = Lᵀ D L."""
    g, n = slope.graph, slope.rows
    columns: list[list[int]] = []
    for j in range(n):
        x = list(slope.nodes[j::n])
        for k in range(n - 1, -1, -1):
            for i in range(k):
                x[i] = g.sub(x[i], g.mul(lower[k][i], x[k]))
        columns.append(x)
    left = Matrix(g, n, n, [x for column in columns for x in column])
    scaled = [g.mul(d, x) for column in columns for d, x in zip(inverse, column, strict=True)]
    whole = mirrored(left @ Matrix(g, n, n, scaled).T - bend)
    upper, below = slice(3), slice(3, 6)
    return whole.block(upper, upper), whole.block(upper, below), whole.block(below, below)


def _blocks(a: Matrix, b: Matrix, c: Matrix, d: Matrix) -> Matrix:
    """A (6, 6) matrix of four (3, 3)."""
    return Matrix.vstack(Matrix.hstack(a, b), Matrix.hstack(c, d))
