"""Check that a scene stays in a plane, from its elements in space.

Everything starts in the plane, and nothing pushes out of it whatever the motion in it is: the
balance of every element is asked at random motions in the plane, and at other parameters too, so
that a parameter that may lead out of the plane is seen.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ...errors import DerivationError
from ...ir.interpreter import evaluate
from ...ir.visits import RepeatedRecursion
from ...spatial.plane import NORMALS, Plane, upright
from ..functions.blocks import defaults
from .nodal_scene import JOINT, Scene
from .planar_kinds import Flat
from .record import BlockKind, Group, Kind, Numbers
from .segment_elements import poses_of
from .states import READ, states

# of directions, and of positions and loads against their size
ROUNDING = 1e-9
TRIALS = 3
# how far parameters are moved, in shares of their size and besides
CHANGE = 0.05


def planes(scene: Scene, normal: int) -> tuple[dict[int, Plane], tuple[Plane, ...]]:
    """Planes of the nodes: those of bodies, and those inside every segment.

    Raises:
        DerivationError: one is not in the plane.
    """
    coordinates = _reference(scene)
    bodies, at = dict[int, Plane](), 0
    for kind, i in scene.places:
        if kind == JOINT:
            at += len(scene.system.joints[i].element.coordinates)
            continue
        pose, at = np.asarray(coordinates[at : at + 7], dtype=np.float64), at + 7
        bodies[i] = _plane_of(scene.system.bodies[i].name, normal, pose[None])
    segments = scene.system.segments
    return bodies, tuple(_plane_of(s.name, normal, poses_of(s)) for s in segments)


def _reference(scene: Scene) -> Sequence[float]:
    """Coordinates of all places as runs start."""
    values = defaults(scene.system)
    joints = [joint for joint in scene.system.joints if joint.q >= 0]
    starts = [j.q0 or tuple(c.default for c in j.element.coordinates) for j in joints]
    values["q"] = np.array([x for start in starts for x in start])
    values["u"] = np.zeros(scene.system.nu)
    values["r"] = values["r"][: len(scene.system.inputs)]
    numbers = {name: values[name].tolist() for name in READ}
    return RepeatedRecursion(states(scene))(numbers)["q"]


def _plane_of(name: str, normal: int, poses: Numbers) -> Plane:
    """The plane of nodes at such poses (n, 7)."""
    from scipy.spatial.transform import Rotation

    rotations = Rotation.from_quat(poses[:, [1, 2, 3, 0]]).as_matrix()
    plane = upright(normal, rotations[0], ROUNDING)
    size = 1 + np.abs(poses[:, 4:]).max()
    if plane is None:
        raise _leaves(name, normal, "none of its axes is along the normal")
    if np.abs(poses[:, 4 + normal]).max() > ROUNDING * size:
        raise _leaves(name, normal, "it is beside the plane through the origin of the ground")
    if np.abs(rotations[:, normal] - plane.rotation[normal]).max() > ROUNDING:
        raise _leaves(name, normal, "its line turns out of the plane")
    return plane


def _leaves(name: str, normal: int, why: str) -> DerivationError:
    return DerivationError(
        f"'{name}' does not stay in the plane across '{NORMALS[normal]}': {why}. Leave out "
        "plane=, or take another"
    )


def check(scene: Scene, groups: Sequence[Group], space: Mapping[str, Kind], normal: int) -> None:
    """That no element pushes out of the plane.

    Args:
        scene: The scene.
        groups: Its elements in the plane.
        space: By the names of their kinds the same in space.
        normal: Of the plane.

    Raises:
        DerivationError: one does.
    """
    random = np.random.default_rng(0)
    values = defaults(scene.system)["p"]
    for trial in range(TRIALS):
        moved = CHANGE * random.uniform(-1, 1, (2, len(values))) if trial else np.zeros(2)[:, None]
        p = values * (1 + moved[0]) + moved[1]
        for group in (g for g in groups if g.kind.name in space):
            if "balance" in space[group.kind.name].functions:
                for member in _leaving(group, space[group.kind.name], p, random):
                    raise _leaves(member, normal, "it pushes out of it, or holds it beside it")


def _leaving(group: Group, kind: Kind, p: Numbers, random: np.random.Generator) -> Iterator[str]:
    """Members that push out of the plane at a random motion in it."""
    from scipy.linalg import block_diag

    n, blocks, function = len(group), group.kind.blocks, kind.functions["balance"]
    inputs = _motion(kind, blocks, n, random)
    rows = list(Flat(kind, blocks).rows)
    inputs["lam"] = np.zeros((n, kind.m))
    inputs["lam"][:, rows] = random.standard_normal((n, len(rows)))
    inputs["p"], inputs["t"] = _data(group, p), random.uniform(0, 1, 1)
    for block in function.inputs:
        if block.name not in inputs:
            shape = (len(block),) if block.name == "r" else (n, len(block))
            inputs[block.name] = random.uniform(0, 1, shape)
    _settle_states(kind, inputs)
    with np.errstate(all="ignore"):
        values = evaluate(function, inputs, "numpy")
    results = {o.name: np.broadcast_to(values[o.name], (n, o.size)) for o in function.outputs}
    across = block_diag(
        *(np.zeros((b.nu, 0)) if b.plane is None else b.plane.across for b in blocks)
    )
    pushed = [results["balance"] @ across] if across.size else []
    out_of_plane = [row for row in range(kind.m) if row not in rows]
    for name, count in (("g", kind.mp), ("rates", kind.m)):
        position_rows = [row for row in out_of_plane if row < count]
        pushed += [results[name][:, position_rows]] if position_rows and name in results else []
    size = 1 + np.abs(results["balance"]).max(axis=1, initial=0)
    for part in pushed:
        for e in np.flatnonzero(~(np.abs(part).max(axis=1, initial=0) <= ROUNDING * size)):
            yield group.members[int(e)]


def _settle_states(kind: Kind, inputs: dict[str, Numbers]) -> None:
    """Set internal states to 0 that no motion in the plane moves from there."""
    if "zdot" not in kind.functions or "z" not in inputs:
        return
    random, function = inputs["z"], kind.functions["zdot"]
    missing = {b.name: np.zeros(len(b)) for b in function.inputs if b.name not in inputs}
    moves, before = np.zeros(random.shape[1], dtype=bool), -1
    while moves.sum() > before:
        before = int(moves.sum())
        inputs["z"] = np.where(moves, random, 0.0)
        with np.errstate(all="ignore"):
            rates = evaluate(function, missing | inputs, "numpy")[function.outputs[0].name]
        # of an element that keeps only the first of the states that it reads
        rates = np.broadcast_to(rates, (len(random), function.outputs[0].size))
        large = ~(np.abs(rates) <= ROUNDING * (1 + np.abs(rates).max(initial=0.0)))
        moves[: large.shape[1]] |= large.any(axis=0)
        moves[large.shape[1] :] = True


def _motion(
    kind: Kind, blocks: Sequence[BlockKind], n: int, random: np.random.Generator
) -> dict[str, Numbers]:
    """A random motion in the plane of the places of every member."""
    parts: dict[str, list[Numbers]] = {name: [] for name in ("q", "u", "udot")}
    for space, planar in zip(kind.blocks, blocks, strict=True):
        for name, columns in parts.items():
            x = random.standard_normal((n, planar.nq if name == "q" else planar.nu))
            if planar.plane is not None:
                x = planar.plane.pose(x) if name == "q" else x @ planar.plane.to_space.T
            elif name == "q" and space.quaternion is not None:
                at = slice(space.quaternion, space.quaternion + 4)
                x[:, at] /= np.linalg.norm(x[:, at], axis=1, keepdims=True)
            columns.append(x)
    return {name: np.hstack(draws) for name, draws in parts.items()}


def _data(group: Group, p: Numbers) -> Numbers:
    """Data of the members at parameters (n, k)."""
    parts, n = [], len(group)
    if group.common is not None:
        # one row for all of them, or one each
        k = group.common.outputs[0].shape[-1]
        data = np.asarray(evaluate(group.common, {"p": p})["data"], dtype=np.float64)
        parts.append(np.broadcast_to(data.reshape(-1, k), (n, k)))
    if group.attributes is not None:
        parts.append(group.attributes)
    return np.hstack(parts) if parts else np.zeros((n, 0))
