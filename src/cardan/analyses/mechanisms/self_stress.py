"""Forces in closed loops that balance without any load: what they leave undetermined.

Every loop may carry a wrench of its own round its joints. What joints pass along their freedoms
must vanish, or be what a constraint of the user bears: the wrenches that are left are
self-stresses, and a component of a reaction is determined where no self-stress has it. All six
conditions of a loop are asked, those too that its motion fulfills by itself. In absolute
coordinates every joint has conditions of its own, and self-stresses are combinations of all of
them that vanish.

Source: T. H. Davies, Mechanical networks, Mech. Mach. Theory 18 (1983); J. Angeles, Rational
Kinematics, Springer (1988).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field, replace

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...records import dataclass
from ...runtime.verification.closed_states import closers_at, unbound
from ...runtime.verification.flat_scene import motion_of, scene_of, unknown
from ...runtime.verification.loop_constraints import Circuits, End, circuits_of, jacobian
from ...runtime.verification.newton_euler import moving
from ...runtime.verification.user_constraints import written
from ...schema.mechanism import CutRow
from .mechanism import Mechanism

Components = dict[str, tuple[bool, ...]]
Wrenches = dict[str, Array]
Poses = tuple[Array, Array]  # R (n + 1, 3, 3) and p (n + 1, 3) of the ground and all bodies
Seat = tuple[Array, Array]  # R (3, 3) and p (3,) of a frame, the latter without unit


@dataclass(frozen=True)
class SelfStresses:
    """Reactions of the joints of loops that balance without any load.

    Attributes:
        wrenches: Joint -> (k, 6) in the order and axes of ``model.reaction``, but for a factor
            moments over the size of the mechanism.
        places: Joint -> where it acts (3,), in ground axes [m].
    """

    wrenches: Wrenches = field(default_factory=dict)
    places: Mapping[str, Array] = field(default_factory=dict)

    @property
    def length(self) -> float:
        """Largest distance between two of the joints [m], 1 where they all act at one point."""
        places = np.array(list(self.places.values())).reshape(-1, 3)
        distances = places[:, None] - places[None]
        return float(np.linalg.norm(distances, axis=-1).max(initial=0.0)) or 1.0


COMPONENTS = ("Mx", "My", "Mz", "Fx", "Fy", "Fz")
RANK = 1e-8  # singular values below this part of the largest count as zero
UNIQUE = 1e-7  # parts of a self-stress below this are none
CLOSED = 1e-6  # of the size of the mechanism: joints that close loops have no pose farther off


def determined(m: Mechanism, q: Array) -> Components | None:
    """Mask of the determined components of every joint reaction.

    Args:
        m, q: A model at a position (nq,) at which its loops are closed.

    Returns:
        Joint -> (Mx, My, Mz, Fx, Fy, Fz) as ``model.reaction`` orders them, of all joints of the
        loops; None where joints are not known by their poses.
    """
    stresses = self_stresses(m, q)
    return None if stresses is None else {n: _free(x) for n, x in stresses.wrenches.items()}


def self_stresses(m: Mechanism, q: Array) -> SelfStresses | None:
    """The self-stresses of a model at a position (nq,) at which its loops are closed; None where
    joints are not known by their poses.
    """
    if m.model.manifest.absolute:
        return _of_rows(m, q)
    return _of_loops(m, q) if m.cuts else SelfStresses()


def of_least_norm(m: Mechanism, q: Array, reactions: Mapping[str, Array]) -> Mapping[str, Array]:
    """Reactions (6,) of all joints less the self-stresses in them.

    What is left has the smallest sum of squares of forces, and of moments over the largest distance
    between two of the joints.

    Args:
        m, q: A model at a position (nq,).
        reactions: Reactions of at least all joints that self-stresses load.
    """
    stresses = self_stresses(m, q) or SelfStresses()
    names = [n for n, x in stresses.wrenches.items() if np.abs(x).max(initial=0.0) > 0]
    if not names or not reactions.keys() >= set(names):
        return reactions
    units = np.array([stresses.length] * 3 + [1.0] * 3)
    sizes = np.array([m.size] * 3 + [1.0] * 3) / units
    loads = np.concatenate([stresses.wrenches[name] * sizes for name in names], axis=1)
    total = np.concatenate([reactions[name] / units for name in names])
    shares, *_ = np.linalg.lstsq(loads.T, total, rcond=RANK)
    left = np.split(total - shares @ loads, len(names))
    return {**reactions, **{n: x * units for n, x in zip(names, left, strict=True)}}


def holds(m: Mechanism, q: Array) -> NDArray[np.bool_]:
    """Mask of the constraints less those that elements hold in other modes only (m,)."""
    always = np.array([not row.switched for row in m.closing.rows], bool)
    return np.asarray(always | m.jacobian(q).any(axis=1))


def null_space(rows: Array) -> Array:
    """Combinations (k, m) of rows (m, n) that vanish, orthonormal."""
    if not rows.size:
        return np.eye(len(rows))
    U, s, _ = np.linalg.svd(rows, full_matrices=True)
    rank = int((s > RANK * s.max(initial=0.0)).sum())
    return np.asarray(U[:, rank:].T)


def _free(wrenches: Array) -> tuple[bool, ...]:
    """Mask of the components that none of the wrenches (k, 6) without units has."""
    return tuple((np.abs(wrenches).max(axis=0, initial=0.0) < UNIQUE).tolist())


# joint coordinates


def _of_loops(m: Mechanism, q: Array) -> SelfStresses | None:
    """By the wrenches of all loops."""
    model, user_constraints = m.model, written(m.model)
    if unknown(model) or unbound(model):
        return None
    scene = scene_of(model)
    tree = max((first + size for first, size in scene.q), default=0)
    circuits = circuits_of(model.manifest, scene, max(tree, model.nq))
    r = model._layout.start("r") if m.r is None else m.r
    motion = motion_of(model, m.t, r)
    motion = None if motion is None else np.reshape(motion, (1, *np.shape(motion)[-2:]))
    # the reference implementation must see the loops closed, or its wrenches mean nothing
    closers, missed = closers_at(model, circuits, q, m.t, r, motion)
    if not missed <= CLOSED * m.size:
        return None
    G = jacobian(circuits, closers, motion)[0][0]
    loops = 6 * len(circuits.closers)
    # moments over the size of the mechanism: rows of one scale
    units = np.ones(len(G))
    units[:loops].reshape(-1, 6)[:, 3:] = m.size
    G = G / units[:, None]
    if user_constraints:
        bound = np.zeros((len(user_constraints), circuits.nu))
        bound[:, : model.nu] = (
            m.evaluate("constraint_jacobian", q)[user_constraints] / m.rows[user_constraints, None]
        )
        G = np.concatenate([G, bound])
    G[:, : model.nu] *= m.columns
    # states of self-stress span the left null space of the loop Jacobian
    lengths = np.linalg.norm(G, axis=0)
    stresses = null_space(G / np.where(lengths > 0, lengths, 1.0))[:, :loops]
    poses = _poses(circuits, closers, motion, m.size)
    return _joint_wrenches(m, circuits, poses, stresses.reshape(-1, len(circuits.closers), 6))


def _poses(circuits: Circuits, q: Array, motion: Array | None, size: float) -> Poses:
    """R (n + 1, 3, 3) and p (n + 1, 3) without unit of the ground and all bodies."""
    still = np.zeros((1, circuits.scene.nu))
    motion_of_bodies = moving(circuits.scene, q, still, still, motion)
    rotations = [np.broadcast_to(R, (1, 3, 3))[0] for R in motion_of_bodies.rotations]
    return np.array(rotations), np.array(
        [np.broadcast_to(p, (1, 3))[0] / size for p in motion_of_bodies.place]
    )


def _joint_wrenches(
    m: Mechanism, circuits: Circuits, poses: Poses, stresses: Array
) -> SelfStresses:
    """Wrenches of every joint of the loops, fixed ones too, under self-stresses (k, loops, 6)."""
    names = [joint.name for joint in m.model.manifest.joints]
    through: dict[str, Array] = {}
    seats: dict[str, Seat] = {}
    for n, (closer, cut) in enumerate(zip(circuits.closers, m.cuts, strict=True)):
        parent, child = (_in_ground(poses, end, m.size) for end in (closer.parent, closer.child))
        moment, force = stresses[:, n, :3] @ child[0].T, stresses[:, n, 3:] @ parent[0].T
        wrench = np.concatenate([moment + np.cross(child[1], force), force], axis=-1)
        for body, sign in _path(circuits.scene.parents, closer.parent.body, closer.child.body):
            end = _end(m, circuits, m.model.manifest.joints[body].child_frame)
            # the child as declared may be the inner body: its reaction is the opposite one
            sign = sign if end.body == body else -sign
            through[names[body]] = through.get(names[body], 0.0) + sign * wrench
            seats[names[body]] = _in_ground(poses, end, m.size)
        for weld in cut.fixed:
            through[weld.joint] = through.get(weld.joint, 0.0) + weld.side * wrench
            seats[weld.joint] = _in_ground(poses, _end(m, circuits, weld.frame), m.size)
        if closer.name not in names:
            through[closer.name] = wrench
            seats[closer.name] = child
    every = dict.fromkeys(name for cut in m.cuts for name in passed(cut))
    wrenches = {name: _at_frame(through[name], *seats[name]) for name in every}
    return SelfStresses(wrenches, {name: seats[name][1] * m.size for name in every})


def passed(cut: CutRow) -> list[str]:
    """Joints of a loop: those of the tree, fixed ones, the one that closes it."""
    welds = [weld.joint for weld in cut.fixed]
    return list(dict.fromkeys([*cut.loop, *welds, cut.name]))


def _end(m: Mechanism, circuits: Circuits, frame: str) -> End:
    """A frame on its body."""
    rows, bodies = m.model.manifest.frames, [b.name for b in m.model.manifest.bodies]
    k = [row.name for row in rows].index(frame)
    body, numbers = rows[k].body, circuits.scene.numbers
    number = bodies.index(body) if body in bodies else -1
    return End(number, numbers["frame_rotation"][k], numbers["frame_position"][k])


def _in_ground(poses: Poses, end: End, size: float) -> Seat:
    """A frame of a body in ground axes."""
    R, p = (values[end.body + 1] for values in poses)
    return R @ end.rotation, p + R @ end.position / size


def _path(parents: tuple[int, ...], parent: int, child: int) -> Iterator[tuple[int, float]]:
    """Bodies whose joints a loop passes, and the sign with which its wrench does."""
    one, other = parent, child
    while one != other:
        # bodies are numbered regularly: the higher number cannot be inboard of the other
        if one > other:
            yield one, 1.0
            one = parents[one]
        else:
            yield other, -1.0
            other = parents[other]


def _at_frame(wrench: Array, rotation: Array, position: Array) -> Array:
    """Wrenches (k, 6) about the origin in ground axes, at a frame and in its axes."""
    moment, force = wrench[:, :3], wrench[:, 3:]
    return np.concatenate([(moment - np.cross(position, force)) @ rotation, force @ rotation], -1)


# absolute coordinates


def _of_rows(m: Mechanism, q: Array) -> SelfStresses:
    """By the conditions of all joints: reactions follow from multipliers."""
    from ...runtime.models.finite_elements.assembled import Assembled
    from ...runtime.models.finite_elements.elements import State
    from ...runtime.models.finite_elements.summands import of_reaction

    model = m.model
    source, elements = model._source, model.manifest.elements
    assert isinstance(source, Assembled)
    evaluator, layout = source.results(model), model._layout
    sums = {
        name: of_reaction(evaluator.tables, model.manifest, name)
        for name in (*elements.reactions, *elements.tree_joints)
    }
    r = layout.start("r") if m.r is None else m.r
    at = State(q, t=m.t, r=r, z=layout.start("z"), s=layout.start("s"))

    def reactions(lam: Array) -> dict[str, Array]:
        here = replace(at, lam=lam)
        return {name: each.total(evaluator.mesh, here) for name, each in sums.items()}

    none = reactions(np.zeros(len(m.rows)))
    active = holds(m, q)
    combinations = null_space(m.jacobian(q)[active])
    stresses = np.zeros((len(combinations), len(active)))
    stresses[:, active] = combinations
    units = np.array([1.0] * 3 + [m.size] * 3)
    brought: Mapping[str, list[Array]] = {name: [] for name in none}
    for stress in stresses:
        for name, wrench in reactions(stress / m.rows).items():
            brought[name].append((wrench - none[name]) * units)
    frames = model.manifest.elements.reaction_frames
    return SelfStresses(
        {name: np.reshape(wrenches, (-1, 6)) for name, wrenches in brought.items()},
        {
            name: evaluator.pose(frames[name], {"q": q, "t": np.array([m.t])})[:3, 3]
            for name in none
        },
    )
