"""The beam of the Hellinger-Reissner principle: stress in equilibrium, helicoidal strain."""

from __future__ import annotations

from typing import ClassVar

from ...ir.function import Function
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.short_rotations import Slopes
from ..formulas import Lines, Shapes
from .element import balance, energy, matrix
from .element_ends import Ends
from .equilibrium_load import CarriedLoad
from .formulas import HELLINGER_REISSNER, HELLINGER_REISSNER_LOADED, STRAIN_SHAPES
from .relative import Relative
from .section import DEAD_LOADS, FORCES, SECTION, SHAPE, weight
from .strain import StrainElement, increment, stresses, transported_strain, unknown
from .stress_field import VaryingStress


@dataclass(frozen=True)
class HellingerReissner(StrainElement):
    """Geometrically exact beam with a stress field in equilibrium and helicoidal strain.

    Stress resultants vary linearly along the element as equilibrium has them, n' = -K x n and
    m' = -K x m - E x n; their six unknowns are those of the middle and are condensed exactly:
    ``energy = y·s - s·F s / 2, F s = y, F = c + Aᵀ c A / 12, A = d(stress end to end) / ds``. The
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
    geometric: ClassVar[tuple[str, ...]] = SHAPE
    symbol_shapes: ClassVar[Shapes] = {**STRAIN_SHAPES, "f_0": (3, 1), "n": (3, 1)}
    loaded: bool = False

    @property
    def common(self) -> tuple[str, ...]:
        return (*SECTION, *FORCES) if self.loaded else SECTION

    @property
    def carries(self) -> tuple[str, ...]:
        return DEAD_LOADS if self.loaded else ()

    @property
    def variant(self) -> str:
        return "loaded" if self.loaded else ""

    @property
    def formula_lines(self) -> Lines:
        return HELLINGER_REISSNER_LOADED if self.loaded else HELLINGER_REISSNER

    def measures(self, at: Relative) -> tuple[Slopes, Slopes]:
        return Slopes(-0.5), at.inverse

    def field(self, ends: Ends, at: Relative, e: Matrix) -> VaryingStress:
        if not self.loaded:
            return VaryingStress.of(ends, at.turn, e)
        # the force in axes of the section, those of both ends as one
        fixed, follower = weight(ends)
        in_end_axes = at.start.rotation.T @ fixed + at.end.rotation.T @ fixed
        return VaryingStress.of(ends, at.turn, e, in_end_axes * 0.5 + follower)

    def functions(self, ends: Ends) -> dict[str, Function]:
        return self._loaded(ends) if self.loaded else super().functions(ends)

    def _loaded(self, ends: Ends) -> dict[str, Function]:
        """The same with loads that the stress is in equilibrium with."""
        at = Relative.of(ends.pose(0), ends.pose(1))
        measures = self.measures(at)
        field = self.field(ends, at, transported_strain(at, *measures))
        load = CarriedLoad.of(ends, at, measures, field)
        stress, z = field.solved(field.strain), unknown(ends)
        law, gap = field.law(stress), field.strain - field.relaxed(z)
        end_forces, loads = load.end_forces(stress), load.end_forces(z, field.solved(gap))
        stiffness = ends.derivative(load.tangent(stress), end_forces)
        mixed = ends.derivative(load.tangent(z), load.end_forces(z))
        new = z + field.solved(gap + load.change(ends.increments(), z))
        settled_blocks, unsettled = ends.blocks("q", "p"), ends.blocks("q", "z", "p", "du")
        plain = {
            "balance": balance(ends, ends.assembled(end_forces)),
            "balance_tangent": matrix(ends, "K", stiffness),
            "energy": energy(None, law.energy - load.work),
            "stress": stresses(law),
        }
        parted = {
            "mixed": (balance(ends, ends.assembled(loads)), matrix(ends, "K", mixed)),
            "mixed_step": (increment(new),),
        }
        functions = {
            name: self.function(ends, name, settled_blocks, output)
            for name, output in plain.items()
        }
        for name, outputs in parted.items():
            functions[name] = self.function(ends, name, unsettled, *outputs)
        return functions
