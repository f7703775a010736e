"""The nodes of a beam: stations along its line, and section axes that twist as little as may be."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ...arrays import Array
from ...elements.centerlines import Curve
from ...errors import ModelError
from .segment_tables import Line

# shortest element against the beam; most that neighboring sections may be turned
SHORTEST, TURN = 1e-9, np.pi / 2
# a line this near to the vertical (sine of the angle) has no direction "up"
UPRIGHT = 1e-3
UP, SIDE = np.array([0.0, 0.0, 1.0]), np.array([0.0, 1.0, 0.0])


def meshed(curve: Curve, elements: int, stops: Sequence[float], up: Array | None) -> list[Line]:
    """The pieces of a beam between its named nodes.

    Args:
        curve: Its line.
        elements: Number of them, of about equal length.
        stops: Where named nodes are, in 0 ... 1 of the length; 0 and 1 included, rising.
        up: Direction whose part across the line is e3; None carries the first section along
            without twist.

    Raises:
        ModelError: zero length, an element that is folded, or ``up`` along the line.
    """
    ends = np.cumsum([0, *shares(elements, stops)])
    fractions = np.interp(np.arange(ends[-1] + 1), ends, stops)
    if curve.length == 0 or np.diff(fractions).min() < SHORTEST:
        raise ModelError(_no_length(curve, fractions))
    stations = fractions * curve.length
    positions, tangents = curve.at(stations)
    turns = np.arccos(np.clip(np.sum(tangents[1:] * tangents[:-1], axis=1), -1.0, 1.0))
    if turns.max() > TURN:
        k = int(np.argmax(turns))
        raise ModelError(
            f"it is folded: between {stations[k]:.4g} m and {stations[k + 1]:.4g} m its line turns "
            f"by {np.degrees(turns[k]):.0f} degrees within one element. Take more elements, or "
            "two beams where there is a corner"
        )
    rotations = _transported_axes(tangents) if up is None else _raised(tangents, up, stations)
    return [
        Line(stations[a : b + 1], positions[a : b + 1], rotations[a : b + 1])
        for a, b in pairwise(ends)
    ]


def shares(elements: int, stops: Sequence[float]) -> list[int]:
    """Elements of every piece: in proportion to their lengths, at least one each."""
    target = elements * np.diff(stops)
    counts = np.maximum(np.floor(target + 1e-9), 1).astype(int)
    # those that are left go where most of one is missing
    for k in np.argsort(counts - target, kind="stable")[: max(0, elements - int(counts.sum()))]:
        counts[k] += 1
    return [int(count) for count in counts]


def _no_length(curve: Curve, fractions: Array) -> str:
    if curve.length == 0:
        return "its ends are the same point, so that it has no length; give it another end"
    k = int(np.argmin(np.diff(fractions)))
    return (
        f"an element of length 0: two nodes are at {fractions[k]:.9g} of its length; take the same "
        "frame for both"
    )


def _across(tangents: Array, up: Array) -> Array:
    """Part of a direction across the line, not normalized (n, 3)."""
    return np.asarray(up - np.sum(up * tangents, axis=-1, keepdims=True) * tangents)


def _sections(tangents: Array, e3: Array) -> Array:
    """Section axes (n, 3, 3) as columns."""
    e3 = e3 / np.linalg.norm(e3, axis=-1, keepdims=True)
    return np.stack([tangents, np.cross(e3, tangents), e3], axis=-1)


def _raised(tangents: Array, up: Array, stations: Array) -> Array:
    """Section axes with e3 as near to ``up`` as the line allows.

    Raises:
        ModelError: the line runs along ``up`` somewhere.
    """
    e3 = _across(tangents, up / np.linalg.norm(up))
    sizes = np.linalg.norm(e3, axis=1)
    if sizes.min() < UPRIGHT:
        up_text = ", ".join(f"{x:g}" for x in up)
        raise ModelError(
            f"up=({up_text}) is parallel to the beam at {stations[int(np.argmin(sizes))]:.4g} m: "
            "it "
            "says nothing about how the section is turned. Give a direction across the beam"
        )
    return _sections(tangents, e3)


def _transported_axes(tangents: Array) -> Array:
    """Section axes carried along without twist: e3 starts upward, of an upright line e2 along y.

    Any axes across the line serve; the angles by which neighbors must be turned so that none is
    twisted against the one before add up along the line.
    """
    first = _across(tangents[0], UP)
    upright = float(np.linalg.norm(first)) < UPRIGHT
    if upright:
        first = np.cross(tangents[0], _across(tangents[0], SIDE))
    if (tangents == tangents[0]).all():
        return np.repeat(_sections(tangents[:1], first[None]), len(tangents), axis=0)
    least = np.eye(3)[np.argmin(np.abs(tangents), axis=1)]
    some = _sections(tangents, _across(tangents, least))
    transported = _transported(some[:-1, :, 2], tangents[:-1], tangents[1:])
    steps = _angle(transported, some[1:])
    start = _angle(first[None] / np.linalg.norm(first), some[:1])
    angles = np.concatenate([start, start + np.cumsum(steps)])[:, None]
    return _sections(tangents, np.cos(angles) * some[:, :, 2] - np.sin(angles) * some[:, :, 1])


def _transported(vectors: Array, before: Array, after: Array) -> Array:
    """Vectors (n, 3) turned by the least rotation that takes one direction to another."""
    axis = np.cross(before, after)
    cos = np.sum(before * after, axis=1)[:, None]
    along = np.sum(axis * vectors, axis=1)[:, None]
    return np.asarray(cos * vectors + np.cross(axis, vectors) + axis * along / (1 + cos))


def _angle(vectors: Array, sections: Array) -> Array:
    """Angle about e1 from e3 of sections to vectors across them (n,)."""
    e2, e3 = (np.sum(vectors * sections[:, :, k], axis=1) for k in (1, 2))
    return np.asarray(np.arctan2(-e2, e3))
