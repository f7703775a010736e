"""System -> Absolute: places, kinds found by structure, and the tables of their members."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np

from ...arrays import Integers
from ...elements.flexible import FLEXIBLE
from ...errors import DerivationError
from ...ir.function import Function, Output
from ...ir.graph import ZERO
from ...processes import collector_paused
from ...schema.finite_elements import GROUND, ON_TREE
from ...spatial.plane import NORMALS
from ...topology.prescribed_motion import driving_outputs
from ...topology.system import Cut, Joint, System, joint_lengths
from ..functions.blocks import parameters
from ..functions.element_forces import named_forces
from .blocks import Holds, holds
from .element_kinds import kind_of
from .nodal_scene import NODE, Key, Scene
from .parts import Part, parts, structure
from .planar_kinds import flattened
from .planarity import check, planes
from .record import BlockKind, FiniteElementRecord, Frames, Group, Kind, Places, unique
from .segments import beamed
from .states import states
from .superelements import refuse_plane, superelements


@collector_paused()
def lowered(
    system: System, plane: str | None = None, nodes: Collection[int] | None = None
) -> FiniteElementRecord:
    """A system in absolute coordinates.

    Args:
        system: The system graph.
        plane: Normal of the plane it stays in ("x", "y" or "z"), "auto" to look for one, None for
            space.
        nodes: As of :class:`.nodal_scene.Scene`.

    Raises:
        DerivationError: it is made of written equations, or leaves the plane.
    """
    _refuse(system)
    scene = Scene(system, nodes)
    if plane != "auto":
        return _lowered(scene, None if plane is None else NORMALS.index(plane))
    for normal in reversed(range(3)):
        try:
            return _lowered(scene, normal)
        except DerivationError:
            continue
    return _lowered(scene, None)


def _lowered(scene: Scene, normal: int | None) -> FiniteElementRecord:
    """A scene in space, or in the plane across an axis of the ground."""
    system = scene.system
    if normal is not None:
        refuse_plane(scene)
    bodies, lines = (None, ()) if normal is None else planes(scene, normal)
    block_table = holds(scene, bodies, lines)
    at = {key: k for k, key in enumerate(scene.places)}
    taken, space = set(FLEXIBLE), dict[str, Kind]()
    sorted_parts = _sorted(parts(scene), block_table, taken, space)
    # elements that do nothing are left out, not those that push out of a plane
    sorted_parts = [
        (kind, members_of_kind)
        for kind, members_of_kind in sorted_parts
        if space.get(kind.name, kind).functions
    ]
    results = _names(sorted_parts, "outputs", lambda part: part.results)
    powers = _names(sorted_parts, "power", lambda part: part.powers)
    beams = beamed(scene, at, block_table, powers, taken)
    reduced = tuple(superelements(scene, at, block_table, powers, taken))
    names = [*(scene.name(key) for key in scene.places), *beams.names]
    kinds, every = _numbered(
        [block_table.node] * (bodies is None), [*block_table.here.values(), *beams.kinds]
    )
    groups, position = list[Group](), 0
    tree_number = {i: k for k, i in enumerate(sorted(scene.in_trees))}
    other = sum(kind.mp * len(members) for kind, members in sorted_parts)
    for kind, members in sorted_parts:
        rows = _rows(kind, len(members), position, other)
        groups.append(_group(kind, members, at, rows, system, (results, powers), tree_number))
        position += kind.mp * len(members)
        other += (kind.m - kind.mp) * len(members)
    numbered = [
        (part, (g, e))
        for g, (_, members) in enumerate(sorted_parts)
        for e, part in enumerate(members)
    ]
    forces = {name: at for part, at in numbered for name in part.forces}
    units = dict(driving_outputs(system).values())
    units |= {entry.name: entry.unit for entry in system.outputs}
    if normal is not None:
        check(scene, (*groups, *beams.groups), space | beams.space, normal)
    return FiniteElementRecord(
        system=system,
        places=Places(names, kinds, every),
        groups=(*groups, *beams.groups, *reduced),
        frames=_frames(scene, at, numbered),
        tree_joints=tuple(system.joints[i].name for i in sorted(scene.in_trees)),
        joints={part.name: at for part, at in numbered if part.joint},
        forces={one.name: forces[one.name] for one in named_forces(system) if one.name in forces},
        state_visits=states(scene, bodies, beams.tree_ends),
        results=tuple((name, units[name]) for name in results),
        powers=tuple(powers),
        reference=beams.reference,
        lines=beams.lines,
    )


def _numbered(
    first: Sequence[BlockKind], places: Sequence[BlockKind]
) -> tuple[tuple[BlockKind, ...], Integers]:
    """The kinds of places there are, and the kind of every place."""
    kinds = {kind.name: kind for kind in (*first, *places)}
    numbers = {name: k for k, name in enumerate(kinds)}
    every = np.array([numbers[kind.name] for kind in places], dtype=np.intp)
    return tuple(kinds.values()), every


def _refuse(system: System) -> None:
    """Refuse options that belong to joint coordinates alone.

    Raises:
        DerivationError: it is made of written equations.
    """
    if system.written:
        raise DerivationError(
            f"'{system.name}' is made of written equations, which have coordinates of their own: "
            'leave out coordinates="absolute"'
        )


def _sorted(
    parts_of_scene: Iterable[Part], block_table: Holds, taken: set[str], space: dict[str, Kind]
) -> list[tuple[Kind, list[Part]]]:
    """Pieces by kind, in the order in which kinds come up; kinds of planes as they are in space."""
    members: dict[tuple[str, ...], list[Part]] = {}
    # members that share a small system share its text
    texts: dict[int, str] = {}
    for part in parts_of_scene:
        text = texts.get(id(part.system))
        if text is None:
            text = texts[id(part.system)] = structure(part)
        places = [block.name for block in _blocks(part, block_table.here)]
        members.setdefault((text, *places), []).append(part)
    kinds = []
    for members_alike in members.values():
        name = unique(members_alike[0].kind, taken)
        here, there = (
            _blocks(members_alike[0], by_key) for by_key in (block_table.here, block_table.space)
        )
        kind = kind_of(name, members_alike[0], there)
        if any(block.plane is not None for block in here):
            space[name], kind = kind, flattened(name, kind, here)
        kinds.append((kind, members_alike))
    return kinds


def _blocks(part: Part, at: Mapping[Key, BlockKind]) -> tuple[BlockKind, ...]:
    return tuple(at[key] for key in part.cutting.places)


def _names(
    sorted_parts: Sequence[tuple[Kind, list[Part]]], function: str, names: object
) -> dict[str, int]:
    """Numbers of the outputs or powers by name."""
    listed = (
        name
        for kind, members in sorted_parts
        if function in kind.functions
        for part in members
        for name in names(part)  # type: ignore[operator]
    )
    return {name: k for k, name in enumerate(dict.fromkeys(listed))}


def _group(
    kind: Kind,
    members: list[Part],
    at: Mapping[Key, int],
    rows: Integers,
    system: System,
    named: tuple[Mapping[str, int], Mapping[str, int]],
    tree_number: Mapping[int, int],
) -> Group:
    """The table of the members of a kind."""
    results, powers = named
    has = kind.functions.keys()
    return Group(
        kind=kind,
        members=tuple(part.name for part in members),
        places=_table([[at[key] for key in one.cutting.places] for one in members]),
        rows=rows,
        common=_common(kind, members, system),
        z=_table([one.cutting.z for one in members]) if members[0].cutting.z else None,
        s=_table([one.cutting.s for one in members]) if members[0].cutting.s else None,
        events=_table([part.events for part in members]) if members[0].events else None,
        outputs=_table([[results[n] for n in p.results] for p in members])
        if "outputs" in has
        else None,
        powers=_table([[powers[n] for n in p.powers] for p in members]) if "power" in has else None,
        reactions=_table([[tree_number[i] for i in p.cutting.moved] for p in members])
        if "reactions" in has
        else None,
    )


def _rows(kind: Kind, count: int, position: int, other: int) -> Integers:
    """First rows of members that follow each other, of positions and of the others."""
    each = np.arange(count, dtype=np.intp)
    return np.stack([position + kind.mp * each, other + (kind.m - kind.mp) * each], axis=1)


def _table(rows: Sequence[Sequence[int]]) -> Integers:
    return np.array(rows, dtype=np.intp).reshape(len(rows), -1)


def _common(kind: Kind, members: list[Part], system: System) -> Function | None:
    """The data of all members as a function of the parameters of the scene."""
    rows = [tuple(part.cutting.data) for part in members]
    count = len(kind.data)
    if not count:
        return None
    alike = len(set(rows)) == 1
    nodes = rows[0] if alike else tuple(node for row in rows for node in row)
    shape = (count,) if alike else (len(rows), count)
    return _of_parameters(f"{kind.name}__data", system, (Output("data", shape, nodes),))


def _of_parameters(name: str, system: System, results: tuple[Output, ...]) -> Function:
    return Function(name, system.graph, (parameters(system),), results, ("ground",))


def _frames(
    scene: Scene, at: Mapping[Key, int], numbered: Sequence[tuple[Part, tuple[int, int]]]
) -> Frames:
    """Poses of the frames of the scene on their nodes or bodies of trees."""
    system = scene.system
    frames = [system.frames[scene.frame(k)] for k in range(len(system.frames))]
    place = [GROUND if f.body < 0 else at.get((NODE, f.body), ON_TREE) for f in frames]
    rotation = tuple(node for f in frames for node in f.rotation)
    position = tuple(node for f in frames for node in f.position)
    results = [
        Output("rotation", (len(frames), 9), rotation),
        Output("position", (len(frames), 3), position),
    ]
    # those of joints count where the size of the scene is asked for
    joints: tuple[Joint | Cut, ...] = (*system.joints, *system.closing)
    lengths = tuple(node for joint in joints for node in joint_lengths(joint) if node != ZERO)
    if lengths:
        results.append(Output("lengths", (len(lengths),), lengths))
    poses = _of_parameters("frames__data", system, tuple(results))
    bodies = {
        i: (*member, k)
        for part, member in numbered
        if part.tree
        for k, i in enumerate(part.cutting.moved)
    }
    on_trees = {k: bodies[f.body] for k, f in enumerate(frames) if f.body in bodies}
    return Frames(np.array(place, dtype=np.intp), poses, on_trees)
