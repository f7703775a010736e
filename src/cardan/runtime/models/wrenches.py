"""Wrenches on frames, turned into what the compiled functions read."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ArgumentError, ModelError, named, near
from ...schema.entries import ForceRow
from ..calls.argument_values import numbers

if TYPE_CHECKING:
    from ..calls.evaluation import Evaluation, State, Values

# entries of a wrench, by the names that follow the joint's
PARTS = {"moment": slice(0, 3), "force": slice(3, 6)}


def read_wrenches(model: Evaluation, wrenches: Mapping[str, ArrayLike]) -> dict[str, Array]:
    """Wrenches as arrays (..., 6), their frames known."""
    result = {}
    for frame, value in named("wrenches", wrenches, "'hand': [0, 0, 0, 0, 0, 1]").items():
        if frame not in model.frames:
            raise ModelError(
                f"wrenches: frame '{frame}' does not exist.{near(frame, model.frames)}"
            )
        array = numbers(f"wrenches: '{frame}'", value)
        if array.ndim == 0 or array.shape[-1] != 6:
            raise ArgumentError(
                f"wrenches: '{frame}' has shape {array.shape}, "
                "expected (..., 6): moment, then force"
            )
        result[frame] = array
    return result


def _at(
    model: Evaluation,
    function: str,
    frame: str,
    q: State,
    r: State | None = None,
    t: ArrayLike = 0.0,
    parameters: Values | None = None,
) -> Array:
    """Value of a function of a frame."""
    return model._evaluate((function, frame), (t, q, r), parameters, None)


def generalized(model: Evaluation, wrenches: Mapping[str, ArrayLike], q: Any, **rest: Any) -> Array:
    """The generalized force (..., nu) of wrenches at frame origins in ground axes: sum of Jᵀ w."""
    total: Array = np.zeros(len(model.speeds))
    for frame, wrench in read_wrenches(model, wrenches).items():
        jacobian = _at(model, "frame_jacobian", frame, q, **rest)
        total = total + np.einsum("...ij,...i->...j", jacobian, wrench)
    return total


def refuse_ground(model: Evaluation, wrenches: Mapping[str, ArrayLike], joint: str) -> None:
    """The reaction of a fixed joint may hold a wrench on the ground that the block has no row for.

    Raises:
        ModelError: a wrench on a frame fixed to the ground; names it.
    """
    still = [frame for frame in read_wrenches(model, wrenches) if model.part_of[frame] is None]
    if still and joint in model.manifest.fixed:
        raise ModelError(
            f"reaction('{joint}'): the wrench on '{still[0]}' acts on a body fixed to the ground "
            "and would not be counted. Put it into the scene as a Force and a Torque"
        )


def by_part(model: Evaluation, wrenches: Mapping[str, ArrayLike], q: Any, **rest: Any) -> Array:
    """The block ``wrench``: (..., parts, 6), each at the origin of the part's own frame."""
    parts, part_of = model.bodies, model.part_of
    rows: dict[str, Array] = {}
    for frame, wrench in read_wrenches(model, wrenches).items():
        part = part_of[frame]
        if part is None:
            continue
        if part != frame:
            # the same force at the origin of the part has the moment of its arm
            places = (_at(model, "pose", name, q, **rest)[..., :3, 3] for name in (frame, part))
            arm = np.subtract(*places)
            moment = wrench[..., :3] + np.cross(arm, wrench[..., 3:])
            force = np.broadcast_to(wrench[..., 3:], moment.shape)
            wrench = np.concatenate([moment, force], axis=-1)
        rows[part] = rows[part] + wrench if part in rows else wrench
    lead = np.broadcast_shapes(*(row.shape[:-1] for row in rows.values()))
    result = np.zeros((*lead, len(parts), 6))
    for part, row in rows.items():
        result[..., parts.index(part), :] = row
    return result


def outboard(
    model: Evaluation,
    wrenches: Mapping[str, ArrayLike],
    joint: str,
    q: State,
    r: State | None,
    t: ArrayLike,
    parameters: Values | None,
) -> Array:
    """Sum (..., 6) of wrenches on bodies outboard of a joint of a rigid tree, at its child frame.

    In absolute coordinates; reactions of other joints follow from multipliers alone.

    Raises:
        ModelError: the joint has no speeds that tell which bodies these are.
    """
    total: Array = np.zeros(6)
    elements = model.manifest.elements
    if joint not in elements.tree_joints:
        return total
    joints = model.manifest.joints
    first, count = next((row.slot("u") for row in joints if row.name == joint), (0, 0))
    if not count or any(row.solved for row in joints):
        raise ModelError(
            f"reaction('{joint}'): which bodies are outboard of it is not known beside beams, so "
            "wrenches= would not be counted. Put them into the scene as a Force and a Torque"
        )
    pose = _at(model, "pose", elements.reaction_frames[joint], q, r, t, parameters)
    for frame, wrench in read_wrenches(model, wrenches).items():
        jacobian = _at(model, "frame_jacobian", frame, q, r, t, parameters)
        moves = np.any(jacobian[..., first : first + count] != 0, axis=(-1, -2))
        arm = _at(model, "pose", frame, q, r, t, parameters)[..., :3, 3] - pose[..., :3, 3]
        force = np.broadcast_to(
            wrench[..., 3:], np.broadcast_shapes(arm.shape, wrench[..., 3:].shape)
        )
        pair = np.stack([wrench[..., :3] + np.cross(arm, force), force], axis=-2)
        there = np.einsum("...ji,...kj->...ki", pose[..., :3, :3], pair)
        total = total + np.where(moves[..., None], there.reshape(*there.shape[:-2], 6), 0.0)
    return total


def force_part(name: str, rows: Sequence[ForceRow]) -> int | slice | None:
    """Entry or entries of ``element_forces`` that ``<element>.force`` or ``.moment`` names.

    Args:
        rows: Of the manifest.
    """
    names = [row.name for row in rows]
    if name in names:
        return names.index(name)
    places = [k for k, one in enumerate(names) if one.rpartition(".")[0] == name]
    return slice(places[0], places[-1] + 1) if places else None


def force_names(rows: Sequence[ForceRow]) -> list[str]:
    """Names of forces and moments as a whole, ``<element>.force`` and so on."""
    parts = (row.name.removeprefix(f"{row.element}.").partition(".")[0] for row in rows)
    return list(
        dict.fromkeys(f"{row.element}.{part}" for row, part in zip(rows, parts, strict=True))
    )


def reaction_part(name: str, joints: Collection[str]) -> tuple[str, slice | int] | None:
    """The joint whose reaction a name means, and the entry or entries of it.

    ``<joint>.force`` and ``.moment``, each perhaps with ``.x``, ``.y`` or ``.z`` behind.
    """
    vector, _, axis = name.rpartition(".")
    if axis in ("x", "y", "z") and (named_vector := reaction_part(vector, joints)):
        joint, entries = named_vector
        assert isinstance(entries, slice)
        return joint, entries.start + "xyz".index(axis)
    joint, _, part = name.rpartition(".")
    return (joint, PARTS[part]) if part in PARTS and joint in joints else None
