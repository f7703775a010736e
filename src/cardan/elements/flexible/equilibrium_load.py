"""Dead loads along an element whose stress is in equilibrium with them.

The energy of the element gains a dependence on the force f per length as both ends see it,
a_i = R_iᵀ f: through the stress, which is in equilibrium with their mean, and through the work on
the helix between the ends, f · (p_1 + p_2) L/2 - (a_2 - a_1) · e L/12.
"""

from __future__ import annotations

from dataclasses import replace

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.short_rotations import Slopes
from .element_ends import NAMES, Ends
from .relative import Relative, forces, moved, tangent, transport, transport_slope
from .section import weight
from .strain import Law, respond
from .stress_field import VaryingStress

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
        in_end_axes: a_1 and a_2 (3, 1).
    """

    at: Relative
    measures: tuple[Slopes, Slopes]
    field: VaryingStress
    fixed: Matrix
    in_end_axes: tuple[Matrix, Matrix]

    @staticmethod
    def of(
        ends: Ends, at: Relative, measures: tuple[Slopes, Slopes], field: VaryingStress
    ) -> CarriedLoad:
        """With the loads of the data."""
        fixed, _ = weight(ends)
        start, end = at.start.rotation.T @ fixed, at.end.rotation.T @ fixed
        in_axes = (start.note("start_load"), end.note("end_load"))
        return CarriedLoad(at, measures, field, fixed, in_axes)

    @property
    def work(self) -> Matrix:
        """Work of the load (1, 1) [J]."""
        length, (first, last) = self.field.section.length, self.in_end_axes
        middle = (self.at.start.position + self.at.end.position) * 0.5
        return (self.fixed.T @ middle - (last - first).T @ self.field.e * (1 / 12)) * length

    def end_forces(self, stress: Matrix, missing: Matrix | None = None) -> list[Matrix]:
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
        for k, load in enumerate(self.in_end_axes):
            loads[2 * k] = loads[2 * k] + self._by_load(k, by_load).cross(load)
            loads[2 * k + 1] = loads[2 * k + 1] - half
        return loads

    def tangent(self, stress: Matrix) -> list[list[Matrix]]:
        """Derivatives of :meth:`end_forces` along the increments of the ends, stress eliminated."""
        blocks = tangent(self.at, respond(self.at, *self.measures, self._law(stress)))
        mixed, both = self.field.load_slopes(stress)
        unit = Matrix.vstack(Matrix.zeros(stress.graph, 3, 3), Matrix.identity(stress.graph, 3))
        by_mean, by_length = self._end_loads(mixed), self._end_loads(unit)
        twelfth = self.field.section.length * (1 / 12)
        by_load = self.field.by_load(stress)
        for i, load in enumerate(self.in_end_axes):
            skew = load.skew
            for r in range(4):
                change = by_mean[r] * 0.5 + by_length[r] * (twelfth * SIGNS[i])
                across = change.note(f"load_{r}_by_{NAMES[i]}_load") @ skew
                blocks[r][2 * i] = blocks[r][2 * i] + across
                blocks[2 * i][r] = blocks[2 * i][r] + across.T
            for j, other in enumerate(self.in_end_axes):
                pair = skew.T @ (both * 0.25) @ other.skew
                blocks[2 * i][2 * j] = blocks[2 * i][2 * j] + pair
            geometric_block = self._by_load(i, by_load).skew @ skew
            blocks[2 * i][2 * i] = blocks[2 * i][2 * i] + geometric_block
        return blocks

    def change(self, increments: list[Matrix], stress: Matrix) -> Matrix:
        """Change of the strain that the stress must meet, from increments of the ends (6, 1)."""
        rotated_loads = [a.cross(x) for a, x in zip(self.in_end_axes, increments[::2], strict=True)]
        by_force = self.field.by_force @ (rotated_loads[0] + rotated_loads[1]) * 0.5
        return self.field.slope(stress) @ moved(self.at, increments, *self.measures) + by_force

    def _law(self, stress: Matrix) -> Law:
        """Strain law, including the work of loads on the helix."""
        law, (first, last) = self.field.law(stress), self.in_end_axes
        along = (last - first) * (self.field.section.length * (1 / 12))
        return replace(law, force=law.force + along)

    def _by_load(self, k: int, by_load: Matrix) -> Matrix:
        """Derivative of the energy by a_k (3, 1)."""
        slope = by_load * 0.5 + self.field.e * (self.field.section.length * (SIGNS[k] / 12))
        return slope.note(f"by_{NAMES[k]}_load")

    def _end_loads(self, columns: Matrix) -> list[Matrix]:
        """Columns along theta and e (6, 3) as moments and forces on the ends, (3, 3) each."""
        at, upper = self.at, slice(3)
        m, n = columns.block(upper), columns.block(slice(3, 6))
        carrier = transport(at.turn, *self.measures)
        by_theta = m + transport_slope(at.turn, *self.measures, at.position).T @ n
        moment = (at.slope.T @ by_theta.note("load_by_theta")).note("load_by_rho")
        force = (carrier.T @ n).note("load_by_d")
        parts = [forces(at, moment.column(j), force.column(j)) for j in range(3)]
        return [Matrix.hstack(*(part[r] for part in parts)) for r in range(4)]
