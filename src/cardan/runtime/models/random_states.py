"""Random states of a model, inside limits and away from singular coordinates."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from ...arrays import Array
from ...schema.entries import CoordinateRow
from ...schema.manifest import Manifest
from ..verification.rotations import PARAMETERS

SPEED = 1.0
TURN = math.pi
MOVE = 1.0
OTHER = 0.3
# part of the way to where a joint is no longer regular
INSIDE = 0.9


def random_state(
    manifest: Manifest, rng: np.random.Generator, shape: tuple[int, ...] = ()
) -> Array:
    """States x = [q, u, z] (*shape, nx).

    Angles fill their limits or +-pi, displacements their limits or +-1 m, rotations every
    direction up to an angle at which the parametrization is still regular; speeds +-1. Other
    coordinates stay where their joint is regular, internal states where they start.
    """
    rows = manifest.coordinates
    q = np.zeros((*shape, len(rows)))
    rotations = _rotations(manifest)
    covered = {k for start, name in rotations for k in range(start, start + PARAMETERS[name].size)}
    limits = {joint.name: joint.limits for joint in manifest.joints}
    for k, row in enumerate(rows):
        if k not in covered:
            lower, upper = _range(row, limits.get(row.name) or {})
            q[..., k] = rng.uniform(lower, upper, shape)
    for start, name in rotations:
        kind = PARAMETERS[name]
        direction = rng.normal(size=(*shape, 3))
        direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
        vector = direction * rng.uniform(0.1, kind.reach, (*shape, 1))
        q[..., start : start + kind.size] = kind.of_vector(vector)
    u = rng.uniform(-SPEED, SPEED, (*shape, len(manifest.speeds)))
    z = [row.default for row in manifest.z]
    return np.concatenate([q, u, np.broadcast_to(z, (*shape, len(z)))], axis=-1)


def _rotations(manifest: Manifest) -> list[tuple[int, str]]:
    """(first coordinate, parametrization) of every rotation in q."""
    names = manifest.scene.rotations
    pairs = zip(manifest.joints, names, strict=False)
    by_joint = {joint.q[0]: name for joint, name in pairs if name in PARAMETERS and joint.q}
    # nodes turn by quaternions too
    nodes = dict.fromkeys(manifest.quaternions, "quaternion")
    return list({**by_joint, **{k: name for k, name in nodes.items() if k not in by_joint}}.items())


def _range(row: CoordinateRow, limits: Mapping[str, float]) -> tuple[float, float]:
    """Range from which a coordinate is drawn."""
    reach = {"rad": TURN, "m": MOVE}.get(row.unit, OTHER)
    if row.reach is not None:
        reach = min(reach, INSIDE * row.reach)
    middle = row.default or 0.0
    lower, upper = limits.get("lower"), limits.get("upper")
    if row.unit == "rad":
        middle = 0.0
    low = middle - reach if lower is None else max(lower, -1e3)
    high = middle + reach if upper is None else min(upper, 1e3)
    return (low, high) if low <= high else (high, high)
