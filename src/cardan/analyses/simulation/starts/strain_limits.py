"""Starts in which beams are strained beyond what materials bear."""

from __future__ import annotations

import numpy as np

from ....arrays import Array
from ....errors import SolveError, SolveWarning, warn
from ....runtime.models.finite_elements import table_loading
from ....runtime.models.finite_elements.joint_driven_nodes import Carrier
from ....runtime.models.loaded_model import LoadedModel

# strain: no linear elastic material is meant to bear more
LARGE = 0.1
SMALL_ANGLE = 1e-4
# angle from one end of an element to the other: at half a turn its rotation vector jumps
FOLDED = np.radians(150.0)
MAX_STATES = 64  # of a run that are looked at


def warn_of_strain(model: LoadedModel, x: Array) -> bool:
    """Warn of the beam that a start strains most, if that is too much; true where it is.

    Args:
        model: In absolute coordinates.
        x: State (nx,).

    Warns:
        SolveWarning: a stretch or shear beyond 0.1, the mean over an element, or bending that
            reaches it at the surface of a section whose outline is known.
    """
    tables = table_loading.tables_of(model)
    if not tables.beams:
        return False
    nothing_moves = np.ones(model.nq + model.nu, dtype=bool)
    reference, q = Carrier(model, nothing_moves).reference, model.split(x)[0]
    strains = [_strain(model, k, reference, q) for k in range(len(model.manifest.beams))]
    worst = int(np.argmax(strains))
    if strains[worst] > LARGE:
        name = model.manifest.beams[worst].name
        warn(
            f"model '{model.name}': the start strains beam '{name}' by {strains[worst]:.2g}, more "
            f"than any elastic material bears ({LARGE:g}): its ends are not where an unstrained "
            "beam would have them. Name other coordinates, or the joints at its ends too",
            SolveWarning,
        )
    return bool(strains[worst] > LARGE)


def folded(model: LoadedModel, states: Array) -> str:
    """A sentence about the beam that is bent most in a run, "" if none is bent too far.

    The strain of an element is that of the shorter way from one end to the other: a beam that is
    bent further changes its energy at once.

    Args:
        model: Any.
        states: Of the run (n, nx).
    """
    if not model.manifest.beams or not len(states):
        return ""
    rows = np.unique(np.linspace(0, len(states) - 1, MAX_STATES).astype(int))
    worst, name = 0.0, ""
    for q in (model.split(states[row])[0] for row in rows):
        for k, beam in enumerate(model.manifest.beams):
            try:
                bent = np.linalg.norm(_relative(*_poses(model, k, q))[0], axis=1).max(initial=0.0)
            except (SolveError, ValueError):
                # a state of numbers that are no pose, as a file may have them
                continue
            worst, name = max((worst, name), (float(bent), beam.name))
    if worst < FOLDED:
        return ""
    return (
        f"An element of beam '{name}' is bent by {np.degrees(worst):.0f} degrees from end to end, "
        "and its strain is defined below 180: take more elements, or a stiffer beam"
    )


def _strain(model: LoadedModel, number: int, reference: Array, q: Array) -> float:
    """The largest strain of the elements of a segment, each of constant strain."""
    poses = [_poses(model, number, at) for at in (reference, q)]
    length = np.maximum(np.linalg.norm(np.diff(poses[0][1], axis=0), axis=1), 1e-300)
    before, now = (_relative(*pair) for pair in poses)
    stretch = np.linalg.norm(now[1] - before[1], axis=1) / length
    bend = np.linalg.norm(now[0] - before[0], axis=1) / length
    # about which axis it bends is not asked: the thinner side strains least
    half = min(model.manifest.beams[number].outline[:2])
    return float(np.maximum(stretch, bend * half).max(initial=0.0))


def _poses(model: LoadedModel, number: int, q: Array) -> tuple[Array, Array]:
    """Rotations (n, 3, 3) and positions (n, 3) of the nodes of a segment, ends on their bodies."""
    from scipy.spatial.transform import Rotation

    tables, row = table_loading.tables_of(model), model.manifest.beams[number]
    inner = tables.poses(q, tables.beams[number][1:-1])
    ends = [model.pose(end, q) for end in (row.start, row.end)]
    turns = np.zeros((len(inner), 3, 3))
    if len(inner):
        turns[:] = Rotation.from_quat(np.roll(inner[:, :4], -1, axis=1)).as_matrix()
    rotations = np.concatenate([ends[0][None, :3, :3], turns, ends[1][None, :3, :3]])
    positions = np.concatenate([ends[0][None, :3, 3], inner[:, 4:], ends[1][None, :3, 3]])
    return rotations, positions


def _relative(rotations: Array, positions: Array) -> tuple[Array, Array]:
    """Rotation vectors (n, 3) and ways (n, 3) of a motion of constant twist from node to node."""
    from scipy.spatial.transform import Rotation

    back = np.swapaxes(rotations[:-1], 1, 2)
    theta = Rotation.from_matrix(back @ rotations[1:]).as_rotvec()
    d = np.einsum("nij,nj->ni", back, np.diff(positions, axis=0))
    angle = np.linalg.norm(theta, axis=1)
    safe = np.where(angle > SMALL_ANGLE, angle, 1.0)
    # inverse of the map from a twist to the way it leads
    second = np.where(
        angle > SMALL_ANGLE, (1 - safe * np.sin(safe) / (2 * (1 - np.cos(safe)))) / safe**2, 1 / 12
    )
    once = np.cross(theta, d)
    return theta, d - once / 2 + second[:, None] * np.cross(theta, once)
