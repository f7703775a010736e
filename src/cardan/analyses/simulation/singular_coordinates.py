"""Rotations whose coordinates are singular somewhere."""

from __future__ import annotations

from ...schema.manifest import Manifest
from ...schema.mechanism import JointRow
from ...schema.rows import having

EVERYWHERE = "every rotation"  # how the domain of those begins that are singular nowhere


def is_bounded(joint: JointRow) -> bool:
    """Whether the rotation of a joint, a row of the manifest, has a place where it is singular."""
    domain = joint.domain or ""
    return bool(joint.rotation and domain and not domain.startswith(EVERYWHERE))


def bounded(manifest: Manifest) -> tuple[int, ...]:
    """Places in q of the coordinates of such rotations."""
    owners = {joint.name for joint in having(manifest.joints, "domain") if is_bounded(joint)}
    if not owners:
        return ()
    rows = enumerate(manifest.coordinates)
    # a joint may have lengths beside
    return tuple(k for k, row in rows if row.joint in owners and row.unit != "m")
