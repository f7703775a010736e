"""Histories of a run by name, and their units."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveError, SolveWarning, near
from ...schema.entries import Entry
from ...schema.manifest import Manifest
from ..models.node_names import nodes_last
from ..models.wrenches import PARTS, force_names, force_part, reaction_part
from . import dependent_joints

if TYPE_CHECKING:
    from .trajectory import TrajectoryRecord

# tables that a model computes along a run, and a file holds: what one history of each is called
COMPUTED = {"outputs": "output", "element_forces": "force"}
# names of energies -> their attribute of ``Trajectory.energy``
ENERGIES = {"energy": "total", "kinetic energy": "kinetic", "potential energy": "potential"}


def history(motion: TrajectoryRecord, name: str) -> Array:
    """History of a name, as :meth:`.TrajectoryRecord.__getitem__`.

    Raises:
        ModelError: no such name, or one that needs the model.
    """
    place = motion._places.get(name)
    if place is not None:
        values, columns = place
        return values[:, columns]
    manifest = motion.manifest
    follow = dependent_joints.names(manifest)
    if name in follow:
        return dependent_joints.history(motion, name)
    outputs = [row.name for row in manifest.outputs]
    if name in outputs:
        return computed(motion, "outputs", f"output '{name}'")[:, outputs.index(name)]
    multipliers = [row.name for row in manifest.multipliers]
    if name in multipliers:
        # of the accelerations, not those that an integrator found
        return computed(motion, "multipliers", f"multiplier '{name}'")[:, multipliers.index(name)]
    if part := reaction_part(name, joint_names(manifest)):
        return motion.reaction(part[0])[:, part[1]]
    rows = manifest.element_forces
    if (entries := force_part(name, rows)) is not None:
        return computed(motion, "element_forces", f"'{name}'")[:, entries]
    if name in ENERGIES:
        energy: Array = getattr(motion.energy, ENERGIES[name])
        return energy
    reactions = [f"{joint}.{part}" for joint in joint_names(manifest) for part in PARTS]
    # what the scene names comes first
    histories = [*outputs, *motion._places, *follow, *force_names(rows), *ENERGIES]
    histories = nodes_last(manifest, [*histories, *multipliers, *reactions])
    joint, _, suffix = name.rpartition(".")
    if suffix == "driving_force" and joint in joint_names(manifest):
        raise ModelError(
            f"motion['{name}']: '{joint}' moves freely or follows another joint; only a joint with "
            "prescribed= has a driving force, and that of its followers acts on it"
        )
    raise ModelError(f"motion['{name}']: there is no such history.{near(name, histories)}")


def state_places(manifest: Manifest) -> dict[str, tuple[str, int | slice]]:
    """Name -> the block it lies in, by letter, and its column or columns there."""
    places: dict[str, tuple[str, int | slice]] = {}
    for letter, suffix in (("q", ""), ("u", ".u")):
        for joint in manifest.joints:
            start, size = joint.slot(letter)
            if size:
                columns = start if size == 1 else slice(start, start + size)
                places[joint.name + suffix] = (letter, columns)
    for letter in "qurzs":
        for k, row in enumerate(manifest.block(letter)):
            places.setdefault(row.name, (letter, k))
    return places


def computed(motion: TrajectoryRecord, table: str, what: str) -> Array:
    """A table (nt, n) that the model computes along the run, or that a file holds.

    NaN, with a warning, at times at which the equations have no solution: a run that ended there
    loses nothing of what came before.

    Raises:
        ModelError: there is neither.
    """
    if motion.model is None and table in motion.stored:
        return motion.stored[table]
    function = getattr(motion._model(what), table)
    arguments = {"q": motion.q, "u": motion.u, "t": motion.t, "r": motion._r, **motion._arguments}
    try:
        values: Array = function(**arguments)
    except SolveError as problem:
        reason = str(problem)
    else:
        return values
    values = np.full((len(motion.t), len(getattr(motion.manifest, table))), np.nan)
    for k in range(len(motion.t)):
        with suppress(SolveError):
            values[k] = function(**{n: None if x is None else x[k] for n, x in arguments.items()})
    missing = np.flatnonzero(np.isnan(values).any(axis=-1))
    if not len(missing):
        return values
    warnings.warn(
        f"{what} has no value at {len(missing)} of {len(motion.t)} times, the first "
        f"t = {motion.t[missing[0]]:.6g} s: {reason}",
        SolveWarning,
        stacklevel=4,
    )
    return values


def joint_names(manifest: Manifest) -> list[str]:
    """Names of the joints that have reactions, as far as files of runs know them."""
    joints = [row.name for row in manifest.joints] + [row.name for row in manifest.cuts]
    elements = manifest.finite_elements
    more = () if elements is None else (*elements.reactions, *elements.tree_joints)
    return [*joints, *more, *manifest.fixed]


def units_of(motion: TrajectoryRecord) -> dict[str, str]:
    """Units of histories by name."""
    m = motion.manifest
    blocks: tuple[Sequence[Entry], ...] = (m.coordinates, m.speeds, m.inputs, m.outputs, m.z)
    units = {row.name: row.unit for rows in blocks for row in rows}
    units |= {row.name: row.unit for row in m.multipliers}
    for row in m.element_forces:
        # all entries of a force have the unit of the force
        units |= {row.name: row.unit, row.name.rpartition(".")[0]: row.unit}
    units |= dict.fromkeys(ENERGIES, "J")
    for joint in joint_names(m):
        units |= {f"{joint}.force": "N", f"{joint}.moment": "N*m"}
    return units
