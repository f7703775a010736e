"""Forces and moments in the sections of the beams of a component."""

from __future__ import annotations

from dataclasses import field

import numpy as np

from ..arrays import Array, Integers
from ..errors import ModelError, counted, near
from ..records import dataclass

COMPONENTS = ("N", "Qy", "Qz", "Mx", "My", "Mz")


@dataclass(frozen=True, eq=False)
class BeamSections:
    """Where section forces are known: six rows of stress for each place.

    Attributes:
        beams: Beam of each section, at the start and at the end of each element.
        stations: Arc length from the start of the beam (sections,) [m].
    """

    beams: tuple[str, ...] = ()
    stations: Array = field(default_factory=lambda: np.zeros(0))

    @property
    def names(self) -> tuple[str, ...]:
        """The beams, each once."""
        return tuple(dict.fromkeys(self.beams))

    @property
    def numbers(self) -> Integers:
        """Which of ``names`` each section is of (sections,)."""
        number = {name: k for k, name in enumerate(self.names)}
        return np.array([number[name] for name in self.beams], dtype=np.intp)

    def of(self, beam: str) -> Integers:
        """Sections of a beam.

        Raises:
            ModelError: there is none of this name.
        """
        if beam not in self.beams:
            names = self.names
            listed = near(beam, names).replace(" Known:", " Beams:") if names else ""
            raise ModelError(
                f"there is no beam '{beam}' in the component.{listed or ' It is not of beams'}"
            )
        return np.flatnonzero([one == beam for one in self.beams])


@dataclass(frozen=True, repr=False, eq=False)
class SectionForces:
    """Internal forces of a beam of a component, at the start and end of each of its n elements.

    Axes are those of the section, e1 along the beam; they turn with the frame of the component.
    Forces are those of what lies ahead on what lies behind: tension is positive. Loads between
    nodes count at these.

    Attributes:
        name: Of the beam.
        s: Arc length from the start of the beam (2 n,) [m].
        force: (..., 2 n, 3) [N]: N, Qy and Qz: axial, shear along e2 and e3.
        moment: (..., 2 n, 3) [N m]: Mx, My and Mz: torsion, bending about e2 and e3.
    """

    name: str
    s: Array
    force: Array
    moment: Array

    def __repr__(self) -> str:
        sizes = [f"{np.abs(x).max(initial=0.0):.6g}" for x in (self.force, self.moment)]
        return (
            f"SectionForces('{self.name}', {counted(len(self.s) // 2, 'element')}: force up to "
            f"{sizes[0]} N, moment up to {sizes[1]} N m)"
        )


def forces_of(beam: str, sections: BeamSections, rows: Array) -> SectionForces:
    """The section forces of a beam out of rows (..., sections, 6) of all of them.

    Raises:
        ModelError: there is no such beam.
    """
    chosen = sections.of(beam)
    values = rows[..., chosen, :]
    return SectionForces(beam, sections.stations[chosen], values[..., :3], values[..., 3:])
