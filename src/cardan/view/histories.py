"""Curves below a picture, by unit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from ..arrays import Array
from ..runtime.trajectory.trajectory import TrajectoryRecord

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


def curves_by_unit(
    motion: TrajectoryRecord, names: Sequence[str] | None, of: HasHistories | None = None
) -> list[Histories]:
    """Curves of a motion, a group for every unit.

    Args:
        motion: Source of the histories and their units.
        names: Of the curves; by default energies, coordinates and outputs.
        of: Source of the histories, if not the motion; then energies are left out.

    Raises:
        ModelError: there is no such history.
    """
    groups: dict[tuple[str, str], list[tuple[str, Array]]] = {}
    units = _units(motion)
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
        kind = {"rad": "angles", "m": "lengths", "N": "forces", "N m": "torques"}.get(unit, unit)
        groups.setdefault((kind or "values", unit), []).extend(curves)
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


def _units(motion: TrajectoryRecord) -> dict[str, str]:
    """Units of histories by name."""
    m = motion.manifest
    entries = (*m.coordinates, *m.speeds, *m.inputs, *m.outputs, *m.z)
    units = {entry.name: entry.unit for entry in entries}
    for row in m.element_forces:
        # forces and moments on frames are also named as a whole
        vector = row.name.rpartition(".")[0]
        names = (row.name,) if vector == row.element else (row.name, vector)
        units |= dict.fromkeys(names, row.unit)
    joints = [*(row.name for row in m.joints), *(row.name for row in m.cuts), *m.fixed]
    units |= {f"{name}.force": "N" for name in joints}
    units |= {f"{name}.moment": "N*m" for name in joints}
    return {name: unit.replace("*", " ") for name, unit in units.items()}
