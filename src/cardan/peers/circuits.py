"""Loops for programs that close them by points or whole bodies held together.

A ball joint that closes a loop holds two points together, a weld two bodies. Any other one is
put back into the tree: the body behind it is split, one part stays where it is, the other hangs on
the joint, and both are held together. The masses of the parts add up to that of the body, so the
motion is the same.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import field

import numpy as np

from ..api.comparison import (
    CompiledModel,
    CutRow,
    KindNumbers,
    Moving,
    Scene,
    cross,
    frames,
    joint_data,
    joint_motions,
    joint_rows,
    pose_of,
    scene_of,
    times,
)
from ..arrays import Array
from ..records import dataclass
from .peer import States

# what can hang on a joint of a split body: coordinates and speeds
SPLIT = {"revolute": 1, "prismatic": 1, "universal": 2}


# numbers of a scene that come body by body
BY_BODY = (
    *("mass", "first_moment", "inertia", "rotation", "position", "axis", "axis2", "pitch"),
    *("ratio", "offset", "rotor", "sizes"),
)


@dataclass(frozen=True)
class Connection:
    """Two frames that are held together.

    Attributes:
        aligned: Their axes too, not only their origins.
        bodies: The two bodies, -1 for the ground.
        rotations, positions: The frames in axes of their bodies, (2, 3, 3) and (2, 3).
    """

    aligned: bool
    bodies: tuple[int, int]
    rotations: Array
    positions: Array


@dataclass(frozen=True)
class Circuits:
    """A closed system as a tree with frames held together.

    Attributes:
        scene: The tree, parts of split bodies last.
        connections: What closes the loops.
        bodies, nq, nu: Of the system without parts.
        seats: For every part the frame it must meet: body, rotation, position.
    """

    scene: Scene
    connections: tuple[Connection, ...]
    bodies: int
    nq: int
    nu: int
    seats: tuple[tuple[int, Array, Array], ...] = field(repr=False)

    def states(self, states: States) -> States:
        """The states with coordinates and speeds of the parts; no force acts along their joints."""
        motions = _bodies(self.scene, self.bodies, states.q, states.u)
        n, q, u = self.scene.numbers, [states.q], [states.u]
        for part, (body, rotation, position) in enumerate(self.seats, self.bodies):
            kind, parent = self.scene.kinds[part], motions[self.scene.parents[part] + 1]
            outer = parent.on_body(n["rotation"][part], n["position"][part])
            relative = _relative_motion(outer, motions[body + 1].on_body(rotation, position))
            axes = np.stack([n["axis"][part], n["axis2"][part]])
            q.append(_coordinates(kind, axes, relative))
            u.append(_speeds(kind, axes, relative))
        third = [states.third, *map(np.zeros_like, u[1:])]
        return States(*(np.concatenate(blocks, axis=1) for blocks in (q, u, third)))


def _bodies(scene: Scene, count: int, q: Array, u: Array) -> list[Moving]:
    """The ground and the first bodies."""
    rows = [joint_rows(scene, i, q, (u,), None) for i in range(count)]
    qs, us = [row[0] for row in rows], [row[1] for row in rows]
    return frames(scene, joint_motions(scene.joints[:count], qs, us), us)


def _relative_motion(frame: Moving, other: Moving) -> Moving:
    """Another frame in axes of one; velocities relative to it."""
    back = np.swapaxes(frame.rotation, -1, -2)
    arm = other.position - frame.position
    moving = other.moving - frame.moving - cross(frame.omega, arm)
    return Moving(
        back @ other.rotation,
        times(back, arm),
        times(back, other.omega - frame.omega),
        times(back, moving),
    )


def _coordinates(kind: str, axes: Array, relative: Moving) -> Array:
    """Coordinates (n, k) of a joint at a relative pose that it allows."""
    e, f = axes / np.maximum(np.linalg.norm(axes, axis=1, keepdims=True), 1e-300)
    if kind == "prismatic":
        return np.asarray(relative.position @ e)[:, None]
    if kind == "revolute":
        # any direction across the axis, and how far it is turned
        x = np.cross(e, np.eye(3)[np.argmin(np.abs(e))])
        rotated = relative.rotation @ x
        return np.asarray(np.arctan2(rotated @ np.cross(e, x), rotated @ x))[:, None]
    # R e2 is turned about the first axis alone, R^T e1 about the second one
    g = np.cross(e, f)
    first = relative.rotation @ f
    second = np.swapaxes(relative.rotation, 1, 2) @ e
    one = np.arctan2(first @ g, first @ f)
    return np.stack([one, np.arctan2(second @ g, second @ e)], axis=1)


def _speeds(kind: str, axes: Array, relative: Moving) -> Array:
    """Speeds (n, k) of a joint that moves as it allows."""
    e, f = axes / np.maximum(np.linalg.norm(axes, axis=1, keepdims=True), 1e-300)
    if kind == "prismatic":
        return np.asarray(relative.moving @ e)[:, None]
    if kind == "revolute":
        return np.asarray(relative.omega @ e)[:, None]
    # the second axis as the first angle has turned it; perpendicular to the first one
    rotated = relative.rotation @ f
    return np.stack([relative.omega @ e, np.sum(relative.omega * rotated, axis=1)], axis=1)


def circuits(model: CompiledModel) -> Circuits | str:
    """The loops of a model, or why they cannot be handed over."""
    scene, cuts = scene_of(model), model.manifest.cuts
    rows: Mapping[str, int] = {}
    for row in model.manifest.multipliers:
        if row.joint not in {cut.name for cut in cuts} or row.level != "position":
            return f"'{row.name}' is not a closing condition of a joint"
        rotational_rows = row.name.rpartition(".")[2].startswith("r")
        rows = {**rows, row.joint: rows.get(row.joint, 0) + rotational_rows}
    bodies = {body.name: k for k, body in enumerate(model.manifest.bodies)}
    frames = {f.name: (k, bodies.get(f.body, -1)) for k, f in enumerate(model.manifest.frames)}
    connections: list[Connection] = []
    parts: list[Part] = []
    for number, cut in enumerate(cuts):
        axes = np.stack([scene.numbers[name][number] for name in ("cut_axis", "cut_axis2")])
        ends = [frames[cut.parent_frame], frames[cut.child_frame]]
        closure = _closed(cut, rows.get(cut.name, 0), scene, axes, ends)
        if isinstance(closure, str):
            return closure
        (connections if isinstance(closure, Connection) else parts).append(closure)  # type: ignore[arg-type]
    return _with_parts(scene, connections, parts, model.nq, model.nu)


@dataclass(frozen=True)
class Part:
    """A part of a body on a joint of its own."""

    kind: str
    axes: Array
    ends: tuple[tuple[int, Array, Array], ...]


def _closed(
    cut: CutRow, rotational_rows: int, scene: Scene, axes: Array, ends: Sequence[tuple[int, int]]
) -> Connection | Part | str:
    """Closure of a cut joint: two connected frames, or an additional joint in the tree."""
    n, kind = scene.numbers, cut.kind
    attachments = tuple((body, n["frame_rotation"][k], n["frame_position"][k]) for k, body in ends)
    # a hinge of which only points have to be held, as in planar loops, is a ball to others
    if kind in ("spherical", "fixed") or (kind == "revolute" and not rotational_rows):
        return Connection(
            kind == "fixed",
            (attachments[0][0], attachments[1][0]),
            np.stack([end[1] for end in attachments]),
            np.stack([end[2] for end in attachments]),
        )
    if kind not in SPLIT:
        return f"joint '{cut.name}' that closes a loop is {kind}"
    if attachments[1][0] < 0:
        if kind == "universal":
            return f"joint '{cut.name}' ends at the ground"
        attachments, axes = attachments[::-1], -axes
    return Part(kind, axes, attachments)


def _with_parts(
    scene: Scene, connections: list[Connection], parts: list[Part], nq: int, nu: int
) -> Circuits:
    """The tree with split bodies."""
    n = {name: np.array(block) for name, block in scene.numbers.items()}
    count = len(scene.parents)
    share = np.ones(count)
    for part in parts:
        share[part.ends[1][0]] += 1
    for name in ("mass", "first_moment", "inertia"):
        n[name] = (n[name].T / share).T
    parents, kinds = [*scene.parents], [*scene.kinds]
    places, speeds, joints = [*scene.q], [*scene.u], [*scene.joints]
    q, u = nq, nu
    new: dict[str, list[Array]] = {name: [] for name in n}
    for part in parts:
        (outer, rotation, position), (body, seat, at) = part.ends
        size = SPLIT[part.kind]
        connections.append(
            Connection(
                True, (len(parents), body), np.stack([np.eye(3), seat]), np.stack([np.zeros(3), at])
            )
        )
        parents.append(outer)
        kinds.append(part.kind)
        numbers = KindNumbers(None, *part.axes)
        joints.append(joint_data(pose_of(part.kind, numbers), part.kind, None))
        places.append((q, size))
        speeds.append((u, size))
        q, u = q + size, u + size
        rows = dict(zip(("axis", "axis2"), part.axes, strict=True))
        rows |= {"rotation": rotation, "position": position}
        rows |= _mass(n["mass"][body], n["first_moment"][body], n["inertia"][body], seat, at)
        for name in BY_BODY:
            if name in n:
                new[name].append(rows.get(name, np.zeros(n[name].shape[1:])))
    for name, blocks in new.items():
        if blocks:
            n[name] = np.concatenate([n[name], np.stack(blocks)])
    more = len(parts)
    tree = dataclasses.replace(
        scene,
        parents=tuple(parents),
        kinds=tuple(kinds),
        rotations=(*scene.rotations, *[None] * more),
        q=tuple(places),
        u=tuple(speeds),
        leaders=(*scene.leaders, *[-1] * more),
        prescribed=(*scene.prescribed, *[False] * more),
        numbers=n,
        nu=u,
        joints=tuple(joints),
    )
    return Circuits(tree, tuple(connections), count, nq, nu, tuple(part.ends[1] for part in parts))


def _mass(mass: Array, first: Array, inertia: Array, seat: Array, at: Array) -> dict[str, Array]:
    """Mass, first moment and inertia about the origin of a frame, in its axes."""
    s = first - mass * at

    def square(a: Array, b: Array) -> Array:
        return np.asarray(a @ b * np.eye(3) - np.outer(a, b))

    moved = inertia - square(first, at) - square(at, first) + mass * square(at, at)
    return {"mass": mass, "first_moment": seat.T @ s, "inertia": seat.T @ moved @ seat}
