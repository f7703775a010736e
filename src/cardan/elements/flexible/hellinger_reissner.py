"""The beam of the Hellinger-Reissner principle: stress in equilibrium, helicoidal strain."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...ir.derivative import directional
from ...ir.function import Function
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...spatial.short_rotations import Slopes
from .element import balance, energy, matrix
from .ends import Ends
from .relative import Relative, forces, mirrored
from .section import FORCES, SECTION, SHAPE, weight
from .strain import StrainElement, carried_strain, increment, respond, stresses, unknown
from .stress_field import Varying


@dataclass(frozen=True)
class HellingerReissner(StrainElement):
    """Geometrically exact beam with a stress field in equilibrium and helicoidal strain.

    Stress resultants vary linearly along the element as equilibrium has them, n' = -K x n and
    m' = -K x m - E x n; their six unknowns are those of the middle and are condensed exactly. The
    complementary energy is that of this field: nodal displacements are of fourth order in statics
    and nothing locks, however slender.

    Args:
        loaded: The element carries dead loads along it and its weight too: the stress is in
            equilibrium with them, n' = -K x n - f, and they work on the helix between the ends.
            Displacements are of fourth order then, however the loads stretch and shear the beam,
            and the stress at the ends is that of the load. Dead loads and inertia beside it have
            none of these forces; follower loads act by an element of their own.

    Source: Sonneville, Cardona and Brüls, CMAME 268 (2014) for the strain; Pian and Sumihara, IJNME
    20 (1984) for stress fields; their union on SE(3) is our own.
    """

    kind: ClassVar[str] = "hellinger_reissner"
    source: ClassVar[str] = (
        "V. Sonneville, A. Cardona, O. Brüls, Geometrically exact beam finite element formulated "
        "on the special Euclidean group SE(3), CMAME 268, 2014"
    )
    own: ClassVar[tuple[str, ...]] = SHAPE
    loaded: bool = False

    @property
    def common(self) -> tuple[str, ...]:
        return (*SECTION, *FORCES) if self.loaded else SECTION

    @property
    def variant(self) -> str:
        return "loaded" if self.loaded else ""

    def measures(self, at: Relative) -> tuple[Slopes, Slopes]:
        return Slopes(-0.5), at.inverse

    def field(self, ends: Ends, at: Relative, e: Matrix) -> Varying:
        if not self.loaded:
            return Varying.of(ends, at.turn, e)
        # the force in axes of the section, those of both ends as one
        fixed, turning = weight(ends)
        seen = at.start.rotation.T @ fixed + at.end.rotation.T @ fixed
        return Varying.of(ends, at.turn, e, seen * 0.5 + turning)

    def functions(self, ends: Ends) -> dict[str, Function]:
        return self._loaded(ends) if self.loaded else super().functions(ends)

    def _loaded(self, ends: Ends) -> dict[str, Function]:
        """The same with a field that depends on where the load comes from."""
        at = Relative.of(ends.pose(0), ends.pose(1))
        field = self.field(ends, at, carried_strain(at, *self.measures(at)))
        z, read = unknown(ends), ends.blocks("q", "p")
        exact = field.solved(field.strain)
        law = field.law(exact)
        held, tangent, _ = self._eliminated(ends, at, field, exact)
        found, stiffness, change = self._eliminated(ends, at, field, z)
        gap = field.strain - field.relaxed(z)
        du = Matrix.vstack(*(place.entries("du") for place in ends.places))
        new = z + field.solved(gap + change @ du)
        mixed = (balance(ends, found + change.T @ field.solved(gap)), matrix(ends, "K", stiffness))
        return {
            "balance": self.function(ends, "balance", read, balance(ends, held)),
            "balance_tangent": self.function(
                ends, "balance_tangent", read, matrix(ends, "K", tangent)
            ),
            "energy": self.function(
                ends, "energy", read, energy(None, law.energy - _work(ends, at, field))
            ),
            "stress": self.function(ends, "stress", read, stresses(law)),
            "mixed": self.function(ends, "mixed", ends.blocks("q", "z", "p"), *mixed),
            "mixed_step": self.function(
                ends, "mixed_step", ends.blocks("q", "z", "p", "du"), increment(new)
            ),
        }

    def _eliminated(
        self, ends: Ends, at: Relative, field: Varying, stress: Matrix
    ) -> tuple[Matrix, Matrix, Matrix]:
        """Loads on the nodes at a stress, their derivative without it, and that of the strain."""
        g, law = ends.graph, field.law(stress)
        response = respond(at, *self.measures(at), law)
        loads = forces(at, response.moment, response.force)
        # the share of both ends in the force that the field is in equilibrium with
        fixed, _ = weight(ends)
        for k, pose in ((0, at.start), (2, at.end)):
            loads[k] = loads[k] + field.by_load(stress).cross(pose.rotation.T @ fixed) * 0.5
        along, work = ends.directions("q"), _work(ends, at, field)
        done = [column[0] for column in directional(g, work.nodes, along)]
        told = ends.told(loads) - Matrix(g, len(done), 1, done)
        kept = dict.fromkeys(stress.nodes, ZERO)
        roots = (*told.nodes, *(field.strain - field.relaxed(stress)).nodes)
        columns = directional(g, roots, [seeds | kept for seeds in along])
        n = told.rows
        both = Matrix(g, n, n + 6, [x for column in columns for x in column]).T
        change = both.block(slice(n, None))
        solved = [field.solved(change.column(j)) for j in range(n)]
        condensed = mirrored(change.T @ Matrix.hstack(*solved))
        return told, both.block(slice(n)) + condensed, change


def _work(ends: Ends, at: Relative, field: Varying) -> Matrix:
    """What dead loads and weight have done (1, 1): force times the mean place on the helix."""
    fixed, _ = weight(ends)
    length = field.section.length
    middle = (at.start.position + at.end.position) * 0.5
    sagging = (at.end.rotation @ field.e - at.start.rotation @ field.e) * (1 / 12)
    return fixed.T @ (middle - sagging) * length
