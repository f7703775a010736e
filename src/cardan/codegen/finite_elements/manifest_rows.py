"""Rows of the manifest for the places of a mesh: coordinates, speeds, joints."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from typing import Any, TypeVar

import numpy as np

from ...equations.finite_elements.record import BlockKind, FiniteElementRecord
from ...schema.entries import CoordinateRow, SpeedRow
from ...schema.finite_elements import Plane
from ...schema.mechanism import JointRow
from ...schema.rows import INTEGER, TEXT, VALUE, Rows, Run
from ...topology.system import Joint
from ..manifest import limits_of

# nodes inside of beams up to which each has rows of its own, for readers
LISTED = 1000
Pattern = dict[str, Any]
R = TypeVar("R", CoordinateRow, SpeedRow)


def rows(
    absolute: FiniteElementRecord,
) -> tuple[Sequence[CoordinateRow], Sequence[SpeedRow], Sequence[JointRow]]:
    """Rows of the coordinates, of the speeds and of the joints, which are all places.

    Nodes inside of beams come last, as one run of rows for every segment; where they are few they
    are written out.
    """
    runs = list(_runs(absolute))
    named = len(absolute.places) - len(absolute.inner)
    q_entries, u_entries = _entries(absolute, named)
    q = Rows(q_entries, [run for run, _, _ in runs])
    u = Rows(u_entries, [run for _, run, _ in runs])
    joints = Rows(_joints(absolute, named), [run for _, _, run in runs])
    if len(absolute.inner) > LISTED:
        return q, u, joints
    return list(q), list(u), list(joints)


def plane_of(kind: BlockKind) -> Plane | None:
    """Planes of the nodes in space."""
    if kind.plane is None:
        return None
    return Plane(spread=kind.plane.to_space.tolist(), home=kind.plane.home.tolist())


def _runs(
    absolute: FiniteElementRecord,
) -> Iterator[tuple[Run[CoordinateRow], Run[SpeedRow], Run[JointRow]]]:
    """Rows of the nodes inside every segment."""
    places, counts, before = absolute.places, dict[str, int](), 0
    for segment, line in zip(absolute.system.segments, absolute.lines, strict=True):
        count = segment.line.elements - 1
        # nodes are numbered along the whole beam
        first = counts.get(segment.name, 0) + 1
        counts[segment.name] = first + count - 1
        if not count:
            continue
        values = absolute.inner[before : before + count]
        before, place = before + count, int(line[1])
        kind = places.kinds[places.kind[place]]
        stem = (f"{segment.name}.node", first)
        q, u = ((int(starts[place]), n) for starts, n in _starts(absolute, kind))
        pattern = _joint(kind, {TEXT: [*stem, ""]}, q, u)
        pattern |= {name: {INTEGER: [start, n, n]} for name, (start, n) in (("q", q), ("u", u))}
        if kind.quaternion is not None:
            pattern["quaternion"] = {INTEGER: [q[0] + kind.quaternion, kind.nq]}
        none = np.zeros((count, 0))
        yield (
            Run(CoordinateRow, count, tuple(_coordinates(kind, stem)), values),
            Run(SpeedRow, count, tuple(_speeds(kind, stem)), none),
            Run(JointRow, count, (pattern,), none),
        )


def _starts(absolute: FiniteElementRecord, kind: BlockKind) -> Iterator[tuple[Any, int]]:
    yield absolute.places.q, kind.nq
    yield absolute.places.u, kind.nu


def _coordinates(kind: BlockKind, stem: tuple[str, int]) -> Iterator[Pattern]:
    """Pattern of the coordinates of nodes inside of beams."""
    for k, (part, unit) in enumerate(zip(kind.coordinates, kind.q_units, strict=True)):
        name = {TEXT: [*stem, f".{part}" if part else ""]}
        yield {"name": name, "unit": unit, "default": {VALUE: k}, "joint": {TEXT: [*stem, ""]}}


def _speeds(kind: BlockKind, stem: tuple[str, int]) -> Iterator[Pattern]:
    """Pattern of their speeds."""
    for part, unit in zip(kind.speeds, kind.u_units, strict=True):
        name = {TEXT: [*stem, f".u.{part}" if part else ".u"]}
        yield {"name": name, "unit": unit, "joint": {TEXT: [*stem, ""]}}


def _entries(
    absolute: FiniteElementRecord, named: int
) -> tuple[list[CoordinateRow], list[SpeedRow]]:
    """Rows of the coordinates and of the speeds of the first places."""
    places, system = absolute.places, absolute.system
    starts: dict[str, Sequence[float]] = {
        joint.name: joint.q0 for joint in system.joints if joint.q0 is not None
    }
    q: list[CoordinateRow] = []
    u: list[SpeedRow] = []
    alike: dict[Hashable, tuple[list[CoordinateRow], list[SpeedRow]]] = {}
    for owner, k in zip(places.names[:named], places.kind[:named].tolist(), strict=True):
        kind = places.kinds[k]
        start_values = starts.get(owner) or kind.defaults
        # where a node of a plane starts follows from the pose that was asked for
        defaults = (
            start_values
            if len(start_values) == kind.nq or kind.plane is None
            else kind.plane.first(start_values)
        )
        key = (k, *defaults)
        if key not in alike:
            alike[key] = _rows_of(kind, defaults)
        q += _named(alike[key][0], owner, ".")
        u += _named(alike[key][1], owner, "")
    return q, u


def _named(rows: Sequence[R], owner: str, dot: str) -> list[R]:
    """The rows of a place like those of another: their names differ alone."""
    names = [f"{owner}{dot}{row.name}" if row.name else owner for row in rows]
    return [
        type(row).trusted({**vars(row), "name": name, "joint": owner})
        for row, name in zip(rows, names, strict=True)
    ]


def _rows_of(
    kind: BlockKind, defaults: Sequence[float]
) -> tuple[list[CoordinateRow], list[SpeedRow]]:
    """Rows of the coordinates and speeds of a place, named by what stands behind its name."""
    coordinates = zip(kind.coordinates, kind.q_units, defaults, strict=True)
    speeds = zip(kind.speeds, kind.u_units, strict=True)
    return (
        [CoordinateRow(name=n, unit=x, default=start, joint=n) for n, x, start in coordinates],
        [SpeedRow(name=f".u.{n}" if n else ".u", unit=x, joint=n) for n, x in speeds],
    )


def _start(kind: BlockKind, joint: Joint | None, name: str) -> list[float] | None:
    """Start values of a place in its own coordinates, from the model."""
    values = None if joint is None else getattr(joint, name)
    if values is None:
        return None
    if kind.plane is None:
        return list(values)
    return list(kind.plane.first(values) if name == "q0" else kind.plane.to_space.T @ values)


def _joints(absolute: FiniteElementRecord, named: int) -> list[JointRow]:
    """Rows of the first places, which histories and initial values know by name."""
    places = absolute.places
    joints_by_name = {joint.name: joint for joint in absolute.system.joints}
    rows: list[JointRow] = []
    for k, name in enumerate(places.names[:named]):
        kind, joint = places.kinds[places.kind[k]], joints_by_name.get(name)
        row = _joint(kind, name, (int(places.q[k]), kind.nq), (int(places.u[k]), kind.nu))
        row |= {"q0": _start(kind, joint, "q0"), "u0": _start(kind, joint, "u0")}
        if joint is not None:
            row |= {"domain": joint.element.domain, "limits": limits_of(joint)}
            if kind.plane is None:
                row["kind"] = joint.element.kind
        rows.append(JointRow(**row))
    return rows


def _joint(kind: BlockKind, name: object, q: tuple[int, int], u: tuple[int, int]) -> Pattern:
    """The row of a place that moves by itself, or the pattern of such rows."""
    quaternion = kind.quaternion
    return {
        "name": name,
        "kind": "planar" if kind.plane is not None else "free",
        "parent": "ground",
        "child": name,
        "parent_frame": "ground",
        "child_frame": "ground",
        "limits": {},
        "q": q,
        "u": u,
        **({} if quaternion is None else {"quaternion": q[0] + quaternion}),
        **({} if quaternion is None else {"rotation": "quaternion"}),
    }
