"""Dead loads along an element whose stress is in equilibrium with them.

The energy of the element gains a dependence on the force f per length as both ends see it,
a_i = R_iᵀ f: through the stress, which is in equilibrium with their mean, and through the work on
the helix between the ends, f · (p_1 + p_2) L/2 - (a_2 - a_1) · e L/12.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from ...ir.matrix import Matrix
from ...spatial.short_rotations import Slopes
from .element_ends import NAMES, Ends
from .relative import Relative, carried_by, carried_slope, forces, moved, tangent
from .section import weight
from .strain import Law, respond
from .stress_field import Varying

# of the two ends in the work on the helix
SIGNS = (-1.0, 1.0)


@dataclass(frozen=True)
class CarriedLoad:
    """A loaded element at a relative pose.

    Attributes:
        at: The relative pose.
        measures: What U of the strain e = U d is made of.
        field: Stress and strain.
        fixed: f (3, 1) [N/m].
        seen: a_1 and a_2 (3, 1).
    """

    at: Relative
    measures: tuple[Slopes, Slopes]
    field: Varying
    fixed: Matrix
    seen: tuple[Matrix, Matrix]

    @staticmethod
    def of(
        ends: Ends, at: Relative, measures: tuple[Slopes, Slopes], field: Varying
    ) -> CarriedLoad:
        """With the loads of the data."""
        fixed, _ = weight(ends)
        start, end = at.start.rotation.T @ fixed, at.end.rotation.T @ fixed
        seen = (start.note("start_load"), end.note("end_load"))
        return CarriedLoad(at, measures, field, fixed, seen)

    @property
    def work(self) -> Matrix:
        """What the load has done (1, 1) [J]."""
        length, (first, last) = self.field.section.length, self.seen
        middle = (self.at.start.position + self.at.end.position) * 0.5
        return (self.fixed.T @ middle - (last - first).T @ self.field.e * (1 / 12)) * length

    def held(self, stress: Matrix, missing: Matrix | None = None) -> list[Matrix]:
        """Moments and forces on the ends at a stress.

        Args:
            stress: Of the middle (6, 1).
            missing: Stress of the strain that is not yet there (6, 1).
        """
        law, by_load = self._law(stress), self.field.by_load(stress)
        if missing is not None:
            added = self.field.slope(stress).T @ missing
            moment, force = added.block(slice(3)), added.block(slice(3, 6))
            law = replace(law, moment=law.moment + moment, force=law.force + force)
            by_load = by_load + self.field.by_force.T @ missing
        response = respond(self.at, *self.measures, law)
        loads = forces(self.at, response.moment, response.force)
        half = self.fixed * (self.field.section.length * 0.5)
        for k, seen in enumerate(self.seen):
            loads[2 * k] = loads[2 * k] + self._by_seen(k, by_load).cross(seen)
            loads[2 * k + 1] = loads[2 * k + 1] - half
        return loads

    def tangent(self, stress: Matrix) -> list[list[Matrix]]:
        """Derivatives of :meth:`held` along the increments of the ends, stress eliminated."""
        blocks = tangent(self.at, respond(self.at, *self.measures, self._law(stress)))
        mixed, both = self.field.load_slopes(stress)
        unit = Matrix.vstack(Matrix.zeros(stress.graph, 3, 3), Matrix.identity(stress.graph, 3))
        by_mean, by_length = self._told(mixed), self._told(unit)
        twelfth = self.field.section.length * (1 / 12)
        by_load = self.field.by_load(stress)
        for i, seen in enumerate(self.seen):
            skew = seen.skew
            for r in range(4):
                change = by_mean[r] * 0.5 + by_length[r] * (twelfth * SIGNS[i])
                across = change.note(f"load_{r}_by_{NAMES[i]}_load") @ skew
                blocks[r][2 * i] = blocks[r][2 * i] + across
                blocks[2 * i][r] = blocks[2 * i][r] + across.T
            for j, other in enumerate(self.seen):
                pair = skew.T @ (both * 0.25) @ other.skew
                blocks[2 * i][2 * j] = blocks[2 * i][2 * j] + pair
            own = self._by_seen(i, by_load).skew @ skew
            blocks[2 * i][2 * i] = blocks[2 * i][2 * i] + own
        return blocks

    def change(self, increments: list[Matrix], stress: Matrix) -> Matrix:
        """Change of the strain that the stress must meet, from increments of the ends (6, 1)."""
        turned = [a.cross(x) for a, x in zip(self.seen, increments[::2], strict=True)]
        by_force = self.field.by_force @ (turned[0] + turned[1]) * 0.5
        return self.field.slope(stress) @ moved(self.at, increments, *self.measures) + by_force

    def _law(self, stress: Matrix) -> Law:
        """What the strain does, the work on the helix included."""
        law, (first, last) = self.field.law(stress), self.seen
        along = (last - first) * (self.field.section.length * (1 / 12))
        return replace(law, force=law.force + along)

    def _by_seen(self, k: int, by_load: Matrix) -> Matrix:
        """Derivative of the energy by a_k (3, 1)."""
        own = by_load * 0.5 + self.field.e * (self.field.section.length * (SIGNS[k] / 12))
        return own.note(f"by_{NAMES[k]}_load")

    def _told(self, columns: Matrix) -> list[Matrix]:
        """Columns along theta and e (6, 3) as moments and forces on the ends, (3, 3) each."""
        at, upper = self.at, slice(3)
        m, n = columns.block(upper), columns.block(slice(3, 6))
        carried = carried_by(at.turn, *self.measures)
        turned = m + carried_slope(at.turn, *self.measures, at.position).T @ n
        moment = (at.slope.T @ turned.note("load_by_theta")).note("load_by_rho")
        force = (carried.T @ n).note("load_by_d")
        parts = [forces(at, moment.column(j), force.column(j)) for j in range(3)]
        return [Matrix.hstack(*(part[r] for part in parts)) for r in range(4)]
