"""Forces that elements transmit, judged by what they do to nodes and joints."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..differences import missing, relative
from ..joint_motion import Array, cross, times
from ..rotations import quaternion
from .balances import friction_parts, rates_of
from .members import Members, in_space

MOTION = 24  # numbers of the motion of a body of a tree


def _reaction(members: Members) -> float | str:
    """The multipliers put it on a node."""
    n, kind = members.count, members.table.kind
    still = members.call("balance", {"lam": np.zeros((n, kind.m))})
    constraint_forces = members.call("balance")[:, : kind.nu] - still[:, : kind.nu]
    return _on_node(members, constraint_forces, members.call("reaction"))


def _element_forces(members: Members) -> float | str:
    """The element puts it on a node: a wrench, a force along a line, or what drives a joint."""
    if members.table.kind.frictions:
        return _of_joint(members)
    if "M" in members.table.kind.parts:
        return "what it does to nodes is its inertia too"
    value = members.call("element_forces", {"lam": 0 * members.inputs["lam"]})
    # without what modes hold
    force = members.call("balance", {"lam": 0 * members.inputs["lam"]})[:, : members.table.kind.nu]
    if value.shape[-1] == 6:
        # force first there, moment first in reactions
        return _on_node(members, force, value[:, [3, 4, 5, 0, 1, 2]])
    if value.shape[-1] > 1:
        return "it drives several speeds at once"
    kind, blocks = members.table.kind, list(zip(members.blocks, members.starts[1], strict=False))
    parts = [
        force[:, part]
        for block, b in blocks
        for part in ((slice(b, b + 3), slice(b + 3, b + 6)) if in_space(block) else ())
    ]
    if "reactions" not in kind.functions:
        # on a joint itself, not on bodies that it carries; nodes that a law reads feel nothing; of
        # several joints the first one has the force
        joints = [force[:, b : b + 1] for block, b in blocks if block.nu == 1]
        parts = [*reversed(joints), *parts]
    # along a line or a slider the node feels the force itself, on an axle the moment alone
    norms = [np.linalg.norm(part, axis=-1, keepdims=True) for part in reversed(parts)]
    pushed = [norm for norm in norms if norm.any()]
    if not norms:
        return "it acts on no nodes in space"
    norm = pushed[0] if pushed else norms[0]
    return relative(np.abs(value) - norm, value)


def _of_joint(members: Members) -> float | str:
    """What multipliers add to the force along a joint acts along its coordinates."""
    kind, n = members.table.kind, members.count
    if kind.frictions > 1:
        return "several elements share the joint"
    still = {"lam": np.zeros((n, kind.m))}
    change = members.call("element_forces") - members.call("element_forces", still)
    acting = members.call("balance", still) - members.call("balance")
    permanent = members.constraint_rows()[:, : kind.m - kind.switched]
    fixed = times(np.swapaxes(permanent, 1, 2), members.inputs["lam"][:, : permanent.shape[1]])
    force = acting[:, : kind.nu] - fixed
    _, along, _ = friction_parts(members)
    # a row that a mode holds, or else sliding, says along which speeds
    row = members.constraint_rows()[:, kind.m - kind.switched :].sum(axis=1)
    row = np.where((row != 0).any(axis=-1, keepdims=True), row, along[:, 0])
    gap = np.linalg.norm(force, axis=-1) - np.linalg.norm(row, axis=-1) * np.abs(change[:, 0])
    return relative(gap[:, None], force, change)


def _reaction_friction(members: Members) -> float | str:
    """A reaction without its part along one fixed line, or the whole of it, tells the force."""
    n, m = members.count, members.table.kind.m
    _, _, normal = friction_parts(members)
    columns = []
    for row in range(m):
        unit = np.broadcast_to(np.eye(m)[row], (n, m))
        columns.append(members.call("reaction", {"lam": unit})[:, 3:])
    force = np.stack(columns, axis=-1)
    left = np.swapaxes(force, 1, 2) @ force - np.swapaxes(normal[:, 0], 1, 2) @ normal[:, 0]
    values, size = np.linalg.eigvalsh(left), (force**2).sum(axis=(1, 2))
    worst = relative(
        np.concatenate([values[:, :-1], np.minimum(values[:, -1:], 0)], -1), size[:, None]
    )
    same = normal - normal[:, :1]
    return max(worst, relative(same.reshape(n, -1), size[:, None]))


def _on_node(members: Members, generalized: Array, wrench: Array) -> float | str:
    """Force of a wrench, and moment along it, are those of generalized forces on a node."""
    nodes = [
        (a, b)
        for block, a, b in zip(members.blocks, *members.starts, strict=False)
        if in_space(block)
    ]
    if not nodes:
        return "it acts on no nodes in space"
    a, b = nodes[-1]
    moment = times(quaternion(members.inputs["q"][:, a : a + 4]), generalized[:, b : b + 3])
    force = generalized[:, b + 3 : b + 6]
    size = np.abs(wrench).max(axis=-1, keepdims=True)
    norms = [np.linalg.norm(x, axis=-1) for x in (force, wrench[:, 3:])]
    along = [(x * y).sum(axis=-1) for x, y in ((moment, force), (wrench[:, :3], wrench[:, 3:]))]
    first = relative((norms[0] - norms[1])[:, None], size)
    # the moment about any point has the same part along the force, whichever end it acts on
    gap = np.abs(np.abs(along[0]) - np.abs(along[1]))
    return max(first, relative(gap[:, None], size * size))


def _bodies(members: Members) -> float | str:
    """Velocities are the rates of poses, accelerations those of velocities."""

    def parts(values: Array) -> tuple[Array, Array, Array, Array]:
        rows = values.reshape(members.count, -1, MOTION)
        return rows[..., :9], rows[..., 9:12], rows[..., 12:18], rows[..., 18:]

    value = members.call("bodies")
    slope, off = members.slope(lambda b: members.call("bodies", b), rates_of(members))
    (R, _, velocity, acceleration), rates = parts(value), parts(slope)
    axes = np.moveaxis(R.reshape(*R.shape[:-1], 3, 3), -1, 0)
    axis_rates = np.stack([cross(velocity[..., :3], axis) for axis in axes], axis=-1)
    pairs = (
        (rates[0], axis_rates.reshape(R.shape)),
        (rates[1], velocity[..., 3:]),
        (rates[2], acceleration),
    )
    flat = [(a.reshape(members.count, -1), b.reshape(members.count, -1)) for a, b in pairs]
    return max(missing(expected, off, result) for expected, result in flat)


LAWS: dict[str, Callable[[Members], float | str]] = {
    "reaction": _reaction,
    "element_forces": _element_forces,
    "reaction_friction": _reaction_friction,
    "bodies": _bodies,
}
