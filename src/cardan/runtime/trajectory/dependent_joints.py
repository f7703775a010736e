"""Histories of joints without slots in the state: coupled and prescribed ones."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...schema.manifest import Manifest

if TYPE_CHECKING:
    from .trajectory import TrajectoryRecord


def names(manifest: Manifest) -> list[str]:
    """Histories that follow from others: ``<joint>`` and ``<joint>.u``."""
    rows = [j.name for j in manifest.joints if j.coupled or j.prescribed]
    return [name + suffix for name in rows for suffix in ("", ".u")] + _solved(manifest)


def _solved(manifest: Manifest) -> list[str]:
    """Coordinates and speeds of joints that loops in closed form determine."""
    rows = [j.solved for j in manifest.joints if j.solved]
    return [name for block in ("q", "u") for row in rows for name in row.names(block)]


def history(motion: TrajectoryRecord, name: str) -> Array:
    """Coordinate or speed (nt,) of a coupled or prescribed joint.

    Raises:
        ModelError: a prescribed motion of a run read from a file without its model.
    """
    if name in _solved(motion.manifest):
        return _from_circuit(motion, name)
    joint, rate = name.removesuffix(".u"), name.endswith(".u")
    rows = motion.manifest.joints
    number = [row.name for row in rows].index(joint)
    if rows[number].prescribed:
        return _prescribed(motion, number, rate)
    ratio = float(np.ravel(motion.scene["ratio"])[number])
    offset = 0.0 if rate else float(np.ravel(motion.scene["offset"])[number])
    coupling = rows[number].coupled
    assert coupling is not None
    return ratio * motion[coupling.leader + (".u" if rate else "")] + offset


def _from_circuit(motion: TrajectoryRecord, name: str) -> Array:
    """A coordinate or speed of a joint of a loop in closed form, angles without jumps."""
    if motion.model is None:
        raise ModelError(
            f"motion['{name}']: it follows from others by a function of the model. Compile that "
            "and give it: load_motion(path, model=...)"
        )
    values = motion.model.dependents(motion.q, motion.u, t=motion.t, r=motion.r)
    column: Array = values[:, _solved(motion.manifest).index(name)].copy()
    (angles, _) = motion.model.manifest.functions["dependents"].outputs
    if (name, "rad") in zip(angles.entries, angles.units, strict=True):
        column = np.unwrap(column)
    return column


def _prescribed(motion: TrajectoryRecord, number: int, rate: bool) -> Array:
    """Prescribed motion of a joint at the times of the run."""
    model = motion.model
    if model is None:
        joint = motion.manifest.joints[number].name
        raise ModelError(
            f"motion['{joint}']: the joint is prescribed, which a file does not hold. Compile the "
            "model and give it: load_motion(path, model=...)"
        )
    values_of = model._evaluate_saved(
        "scene_motion",
        t=motion.t[:, np.newaxis],
        r=motion.r,
        p=np.broadcast_to(model.parameters.vector, (len(motion.t), len(model.parameters.vector))),
    )["motion"]
    values: Array = np.broadcast_to(values_of, (len(motion.t), *np.shape(values_of)[-2:]))
    return values[:, number, 1 if rate else 0].copy()
