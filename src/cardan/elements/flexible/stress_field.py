"""A stress field in equilibrium along an element, condensed to the stress of its middle."""

from __future__ import annotations

from ...ir.graph import SystemNames
from ...ir.matrix import Matrix
from ...ir.solve import factored, substitute
from ...records import dataclass
from .element_ends import STRESSES, Ends
from .relative import mirrored
from .section import Section, diagonal
from .strain import STRAINS, Field, Law


@dataclass(frozen=True)
class VaryingStress(Field):
    """Everything that follows from the strain alone.

    The energy is y · s - s · c s / 2 - t · c t / 24 with y the strain of the element, s the stress
    of the middle and -t its change from end to end: t = A s + l, A s = (theta x m + e x n,
    theta x n), l = (0, L f) with f a force per length. So F = c + Aᵀ c A / 12.

    Attributes:
        section: Data.
        e: Length and shear of the element (3, 1).
        load: l (6, 1) in axes of the section, None without load.
        compliance: c (6, 6); a twelfth of it.
        change: A (6, 6).
        flexibility: F (6, 6); its factors.
    """

    section: Section
    e: Matrix
    load: Matrix | None
    compliance: Matrix
    twelfth: Matrix
    change: Matrix
    flexibility: Matrix
    factors: tuple[list[list[int]], list[int]]

    @staticmethod
    def of(ends: Ends, theta: Matrix, e: Matrix, load: Matrix | None = None) -> VaryingStress:
        """The field of a strain.

        Args:
            ends: Where the data are.
            theta, e: Strain of the element (3, 1).
            load: Force per length in axes of the section (3, 1) [N/m].
        """
        g, section = ends.graph, Section.of(ends)
        entries = [section.length / x for x in section.stiffness]
        # a twelfth of the compliance counts where the stress varies
        c, twelfth = diagonal(g, entries), diagonal(g, [x / 12.0 for x in entries])
        change = _blocks(theta.skew, e.skew, Matrix.zeros(g, 3, 3), theta.skew)
        flexibility = (c.note("c") + change.T.congruence(twelfth.note("twelfth"))).note("F")
        strain, total_load = (Matrix.vstack(theta, e) - section.free).hint("", "y", STRAINS), None
        if load is not None:
            total_load = Matrix.vstack(Matrix.zeros(g, 3), load * section.length)
            strain = strain - change.T @ (twelfth @ total_load)
        factors = factored(flexibility, SystemNames("F", STRESSES, ()))
        return VaryingStress(
            strain, section, e, total_load, c, twelfth, change, flexibility, factors
        )

    def _varied(self, stress: Matrix) -> Matrix:
        """t (6, 1)."""
        varied = (self.change @ stress).hint("", "t", STRESSES)
        return varied if self.load is None else varied + self.load

    def relaxed(self, stress: Matrix) -> Matrix:
        return self.flexibility @ stress

    def solved(self, right: Matrix) -> Matrix:
        g = right.graph
        nodes = substitute(*self.factors, g, list(right.nodes))
        return Matrix(g, 6, 1, nodes).hint("", "s", STRESSES)

    def slope(self, stress: Matrix) -> Matrix:
        g = stress.graph
        tau = (self.twelfth @ self._varied(stress)).hint("", "tau", STRAINS)
        t1, t2 = tau.block(slice(3)).skew, tau.block(slice(3, 6)).skew
        direct = _blocks(t1, Matrix.zeros(g, 3, 3), t2, t1)
        varied = (self.twelfth @ _transport_slope(stress)).note("tau_by_strain")
        return (Matrix.identity(g, 6) - direct - self.change.T @ varied).note("B")

    def law(self, stress: Matrix) -> Law:
        g, transport_slope = stress.graph, _transport_slope(stress)
        m, n = stress.block(slice(3)), stress.block(slice(3, 6))
        varied = self._varied(stress)
        tau = (self.twelfth @ varied).hint("", "tau", STRAINS)
        t1, t2 = tau.block(slice(3)), tau.block(slice(3, 6))
        bend = mirrored(
            transport_slope.T @ (self.twelfth @ transport_slope).note("tau_by_strain")
        ).note("t_bend")
        tangent = _condensed(*self.factors, self.slope(stress), bend)
        middle, half = self._at_ends(stress), varied * 0.5
        ends = (middle + half, middle - half)
        elastic = diagonal(g, [1.0 / x for x in self.section.stiffness])
        return Law(
            (m - m.cross(t1) - n.cross(t2)).note("m"),
            (n - n.cross(t1)).note("n"),
            tangent,
            (stress.T @ (self.compliance @ stress) + tau.T @ self._stored(varied)) * 0.5,
            ends,
            (elastic @ ends[0], elastic @ ends[1]),
        )

    def by_load(self, stress: Matrix) -> Matrix:
        """Derivative of the energy by the force per length, in axes of the section (3, 1)."""
        tau = self.twelfth @ self._varied(stress)
        return tau.block(slice(3, 6)) * (-1.0 * self.section.length)

    @property
    def by_force(self) -> Matrix:
        """Derivative of the strain, less F s, by the force per length (6, 3)."""
        g = self.strain.graph
        theta, yielding = self.change.block(slice(3), slice(3)), self._yielding
        return Matrix.vstack(Matrix.zeros(g, 3, 3), theta @ yielding).note("strain_by_load")

    @property
    def _yielding(self) -> Matrix:
        """A twelfth of the compliance by force, times L (3, 3)."""
        return self.twelfth.block(slice(3, 6), slice(3, 6)) * self.section.length

    def load_slopes(self, stress: Matrix) -> tuple[Matrix, Matrix]:
        """Second derivatives of the energy by strain and force (6, 3), by force (3, 3)."""
        n, change = stress.block(slice(3, 6)), self.by_force
        solved = Matrix.hstack(*(self.solved(change.column(j)) for j in range(3))).note("s_by_load")
        direct = Matrix.vstack(-(n.skew @ self._yielding), Matrix.zeros(stress.graph, 3, 3))
        both = change.T @ solved - self._yielding * self.section.length
        return direct + self.slope(stress).T @ solved, mirrored(both)

    def _stored(self, varied: Matrix) -> Matrix:
        """Strain whose product with t gives the stored energy: A s - l."""
        return varied if self.load is None else varied - self.load * 2.0

    def _at_ends(self, stress: Matrix) -> Matrix:
        """The mean of the stress at both ends: a load bends the line between."""
        if self.load is None:
            return stress
        sagging = self.e.cross(self.load.block(slice(3, 6))) * (1 / 12)
        return stress + Matrix.vstack(sagging, Matrix.zeros(stress.graph, 3))


def _transport_slope(stress: Matrix) -> Matrix:
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
    left = Matrix(g, n, n, [x for column in columns for x in column]).note("LB")
    scaled = [g.mul(d, x) for column in columns for d, x in zip(inverse, column, strict=True)]
    matrix = mirrored(left @ Matrix(g, n, n, scaled).note("DLB").T - bend).note("by_strain_strain")
    upper, below = slice(3), slice(3, 6)
    return matrix.block(upper, upper), matrix.block(upper, below), matrix.block(below, below)


def _blocks(a: Matrix, b: Matrix, c: Matrix, d: Matrix) -> Matrix:
    """A (6, 6) matrix of four (3, 3)."""
    return Matrix.vstack(Matrix.hstack(a, b), Matrix.hstack(c, d))
