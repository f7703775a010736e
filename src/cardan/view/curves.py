"""Curves of a motion by unit, as a page shows them below its picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from ..arrays import Array
from ..records import dataclass
from ..runtime.trajectory.histories import units_of
from ..runtime.trajectory.trajectory import TrajectoryRecord

# histories by their unit
KINDS = {
    "rad": "angles", "m": "lengths", "N": "forces", "N*m": "torques", "rad/s": "angular speeds",
    "m/s": "speeds", "J": "energies", "W": "powers",
}  # fmt: skip
MOST_CURVES = 8


@dataclass(frozen=True)
class Histories:
    """Curves of one unit."""

    name: str
    unit: str
    curves: Sequence[tuple[str, Array]]


class HasHistories(Protocol):
    """A result with histories by name."""

    def __getitem__(self, name: str, /) -> object:
        """A history (nt, ...)."""


def histories(
    motion: TrajectoryRecord, names: Sequence[str] | None, of: HasHistories | None = None
) -> list[Histories]:
    """Curves by unit.

    Args:
        motion: Source of the histories and their units.
        names: Of the curves; by default energies, coordinates and outputs.
        of: Source of the histories, if not the motion; then energies are left out.

    Raises:
        ModelError: there is no such history.
    """
    groups: dict[tuple[str, str], list[tuple[str, Array]]] = {}
    units = units_of(motion)
    for name in _usual(motion, of is None) if names is None else names:
        if name == "energy" and of is None:
            energy = motion.energy
            rows = [(part, getattr(energy, part)) for part in ("kinetic", "potential", "total")]
            groups.setdefault(("energy", "J"), []).extend(rows)
            continue
        values = np.asarray((motion if of is None else of)[name], dtype=np.float64)
        unit = units.get(name, "")
        if values.ndim == 1:
            curves = [(name, values)]
        else:
            flat = values.reshape(len(values), -1)
            letters = "xyz" if flat.shape[1] == 3 else [str(k) for k in range(flat.shape[1])]
            curves = [(f"{name}.{letters[k]}", flat[:, k]) for k in range(flat.shape[1])]
        groups.setdefault((KINDS.get(unit, "values"), unit), []).extend(curves)
    return [Histories(name, unit, curves) for (name, unit), curves in groups.items()]


def _usual(motion: TrajectoryRecord, moving: bool) -> list[str]:
    """Energies, coordinates of joints with one, and outputs, as far as they can be had."""
    manifest = motion.manifest
    names = []
    computed = motion.model is not None and "energy" in manifest.available
    if moving and ("kinetic" in motion.stored or computed):
        names.append("energy")
    units: dict[str, int] = {}
    for row in manifest.coordinates:
        units[row.unit] = units.get(row.unit, 0) + 1
        if units[row.unit] <= MOST_CURVES and row.joint == row.name and row.unit:
            # one that follows others has no history of its own everywhere
            names.append(row.name)
    if motion.model is not None:
        names += [row.name for row in manifest.outputs][:MOST_CURVES]
    return names
