"""Rotations among named values: a unit quaternion is named whole or not at all.

Its four components depend on each other: one of them alone would have to change the others and,
rescaled, itself.
"""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from ...arguments import UNIT
from ...arrays import Array
from ...errors import ModelError, SolveError
from ...schema.manifest import Manifest
from ...schema.mechanism import JointRow
from ...schema.rows import having

EVERYWHERE = "every rotation"  # beginning of the domain of parameters without singularity
ZERO = 1e-6  # a length below stands for no rotation


def refuse_components(manifest: Manifest, where: str, covered: Collection[int]) -> None:
    """Refuse quaternions of which some components are named and others are not.

    Args:
        manifest: Of the model.
        where: What the user wrote, to begin the message with.
        covered: Entries of q that are named.

    Raises:
        ModelError: single components of a rotation.
    """
    for start in manifest.quaternions if covered else ():
        named = [k for k in range(start, start + 4) if k in covered]
        if 0 < len(named) < 4:
            name = str(manifest.coordinates[named[0]].name)
            raise ModelError(f"{where}: {_one_component(manifest, int(start), name)}")


def component(manifest: Manifest, name: str) -> str:
    """Why a name such as ``base.x`` or ``base.qx`` cannot be given alone; "" if it is another."""
    head, _, last = str(name).rpartition(".")
    full_name = f"{head}.q{last.removeprefix('q')}"
    missing = "" if full_name == name else f"there is no coordinate '{name}': "
    for start in manifest.quaternions:
        names = [str(row.name) for row in manifest.coordinates[start : start + 4]]
        if full_name in names:
            return missing + _one_component(manifest, int(start), full_name)
    return ""


def _one_component(manifest: Manifest, start: int, name: str) -> str:
    """The message about one component of the quaternion that starts at an entry."""
    rows = manifest.coordinates
    head, _, last = name.rpartition(".q")
    names = [str(row.name) for row in rows[start : start + 4]]
    owners = (j for j in manifest.joints if j.slot("q")[0] <= start < sum(j.slot("q")))
    owner = next(owners, None)
    rotation_name, entries = head, names
    if owner is not None:
        first, count = owner.slot("q")
        rotation_name = str(owner.name)
        entries = [str(row.name) for row in rows[first : first + count]]
    place = f"{head}.p{last}"
    hint = f" The position along {last} is '{place}'." if place in entries else ""
    return (
        f"'{name}' is one component of the unit quaternion of '{head}', which "
        f"one component does not determine.{hint} Give the rotation whole: '{rotation_name}': "
        f"[{', '.join(entry.rpartition('.')[2] for entry in entries)}]"
    )


def check_units(manifest: Manifest, q: Array, where: str = "", first: int = 0) -> None:
    """Refuse quaternions whose length is not 1.

    Args:
        manifest: Of the model.
        q: Coordinates (nq,) or (runs, nq) as they were given.
        where: Words to begin the message with.
        first: Number of the first run, where there are several.

    Raises:
        SolveError: a length that is off by more than rounded digits explain.
    """
    starts = np.array(manifest.quaternions, dtype=np.intp)
    if not len(starts):
        return
    entries = starts[:, None] + np.arange(4)
    lengths = np.linalg.norm(np.atleast_2d(q)[:, entries], axis=-1)
    wrong = np.argwhere(~(np.abs(lengths - 1) <= UNIT))
    if not len(wrong):
        return
    row, k = wrong[0].tolist()
    name, length = manifest.coordinates[int(starts[k])].name, float(lengths[row, k])
    if len(lengths) > 1:
        where += f"run {first + row}: "
    if length < ZERO:
        raise SolveError(
            f"{where}the quaternion at '{name}' has length {length:g} and stands for no rotation. "
            "No rotation is (1, 0, 0, 0)"
        )
    raise SolveError(
        f"{where}the quaternion at '{name}' has length {length:.9g}: a rotation has length 1. "
        "Divide its four components by that; nothing that is named is rescaled"
    )


def is_bounded(joint: JointRow) -> bool:
    """True when the rotation parameters of a joint are singular somewhere."""
    domain = joint.domain or ""
    return bool(joint.rotation and domain and not domain.startswith(EVERYWHERE))


def bounded(manifest: Manifest) -> tuple[int, ...]:
    """Entries of q that belong to rotation parameters with a singularity."""
    owners = {joint.name for joint in having(manifest.joints, "domain") if is_bounded(joint)}
    if not owners:
        return ()
    rows = enumerate(manifest.coordinates)
    # a joint may have lengths beside
    return tuple(k for k, row in rows if row.joint in owners and row.unit != "m")
