"""Units of what a linear model connects, by the names it has there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from ...schema.entries import Entry
from ...schema.manifest import Manifest

ALONG = "along "  # before the name of a speed: an increment along it
FORCES = {"rad/s": "N*m", "m/s": "N"}  # along a speed, by its unit


def of_states(manifest: Manifest, names: Iterable[str]) -> tuple[str, ...]:
    """Units of increments, speeds and internal states."""
    units = _units(manifest.coordinates, manifest.speeds, manifest.z)
    speeds = _units(manifest.speeds)
    along = {f"{ALONG}{name}": unit.removesuffix("/s") for name, unit in speeds.items()}
    return _of(names, units | along)


def of_inputs(manifest: Manifest, names: Iterable[str]) -> tuple[str, ...]:
    """Units of inputs, and of forces along speeds."""
    speeds = _units(manifest.speeds)
    forces = {name: FORCES.get(unit, "") for name, unit in speeds.items()}
    forces |= {name.removesuffix(".u"): unit for name, unit in forces.items()}
    return _of(names, forces | _units(manifest.inputs))


def of_outputs(manifest: Manifest, names: Iterable[str]) -> tuple[str, ...]:
    """Units of outputs, coordinates, speeds and internal states."""
    blocks = manifest.z, manifest.speeds, manifest.coordinates, manifest.outputs
    return _of(names, _units(*blocks))


def _units(*blocks: Sequence[Entry]) -> dict[str, str]:
    return {row.name: row.unit or "" for rows in blocks for row in rows}


def _of(names: Iterable[str], units: Mapping[str, str]) -> tuple[str, ...]:
    return tuple(units.get(name, "") for name in names)
