"""Flexible elements: poses and speeds at their ends, and quadrature along their shapes.

Elements with unknowns of their own are judged by the plain ones.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from itertools import takewhile

import numpy as np

from ..differences import missing, relative, worst_of
from ..joint_motion import Array, cross, times
from ..rotations import quaternion
from .balances import NO_LAW, balance, momenta
from .members import NODE, Members, in_space
from .shapes import ENERGIES, MOMENTA, STRESSES, quaternion_of

# kinds of ends, which stand last in the name of a kind
ENDS = ("node", "offset", "ground")


def ends_of(members: Members) -> tuple[Array, Array, dict[str, Array]] | None:
    """Poses (n, 14) and speeds (n, 12) of both ends of a flexible element, and its data by name.

    Ends that are fixed to nodes, or to the ground, have their place among the data. None of
    elements that are not flexible, of those in a plane, and of those with a third end.
    """
    name = members.table.kind.name
    if not any(name.startswith(kind) for kind in (*ENERGIES, *STRESSES)):
        return None
    if any(not block.node or block.nq != NODE for block in members.blocks):
        return None
    if len([*takewhile(ENDS.__contains__, reversed(name.split("_")))]) > 2:
        return None
    form = next(iter(members.codes.values())).symbol
    inputs = members.model._objects.saved()[form]["inputs"]
    names: list[str] = next((b["entries"] for b in inputs if b["name"] == "p"), [])
    data = {entry: members.inputs["p"][:, k] for k, entry in enumerate(names)}
    q, u, k = list[Array](), list[Array](), 0
    for end in ("start", "end"):
        attached = f"{end}_px" in data
        grounded = attached and _grounded(members, end, data)
        pose, speed = np.tile([1.0] + [0.0] * 6, (members.count, 1)), np.zeros((members.count, 6))
        if not grounded:
            pose = members.inputs["q"][:, 7 * k : 7 * k + 7]
            speed = members.inputs["u"][:, 6 * k : 6 * k + 6]
            k += 1
        if attached:
            pose, speed = _end_motion(pose, speed, end, data)
        q, u = [*q, pose], [*u, speed]
    return np.concatenate(q, axis=-1), np.concatenate(u, axis=-1), data


def _grounded(members: Members, end: str, data: Mapping[str, Array]) -> bool:
    """True when an end is fixed to the ground: the other one is the only node then."""
    other = "end" if end == "start" else "start"
    parts = members.table.kind.name.split("_")
    if len(members.blocks) == 2:
        return False
    return f"{other}_px" not in data or parts[-2 if end == "start" else -1] == "ground"


def _end_motion(
    pose: Array, speed: Array, end: str, data: Mapping[str, Array]
) -> tuple[Array, Array]:
    """Pose and speeds of a frame that is fixed to another."""
    n = len(pose)
    cells = [data[f"{end}_R{i}{j}"] for i in "123" for j in "123"]
    R = np.stack(cells, axis=-1).reshape(n, 3, 3)
    p = np.stack([data[f"{end}_p{x}"] for x in "xyz"], axis=-1)
    rotation = quaternion(pose[:, :4])
    place = pose[:, 4:] + times(rotation, p)
    back = np.swapaxes(R, -1, -2)
    moved = speed[:, 3:] + times(rotation, cross(speed[:, :3], p))
    end_pose = np.concatenate([quaternion_of(rotation @ R), place], axis=-1)
    return end_pose, np.concatenate([times(back, speed[:, :3]), moved], axis=-1)


def _energy(members: Members) -> float | str:
    """By quadrature of strain measures and of point masses, and by what it does."""
    law, here = balance(members), _quadrature(members)
    if here is None:
        return law

    def both(at: Members) -> tuple[Array, Array]:
        return at.call("energy"), here if at is members else np.asarray(_quadrature(at))

    error = members.disagreement(both)
    return error if isinstance(law, str) else worst_of(error, law)


def _quadrature(members: Members) -> Array | None:
    """Kinetic and potential energy (n, 2) along the shape; None where it is not known."""
    ends = ends_of(members)
    names = [name for name in ENERGIES if members.table.kind.name.startswith(name)]
    return ENERGIES[max(names, key=len)](*ends) if ends and names else None


def _momentum(members: Members) -> float | str:
    """dT/dv, and its moment with dT/domega; of points along the shape where an end is held."""
    ends = ends_of(members)
    names = [name for name in MOMENTA if members.table.kind.name.startswith(name)]
    value = members.call("momentum")
    if ends and names:
        expected = MOMENTA[max(names, key=len)](*ends)
        return relative(value - expected, expected)
    nodes = [in_space(block) for block in members.blocks]
    # what carries a rigid tree or a superelement moves all of it; other elements have more ends
    on_node = sum(nodes) == 1 and members.table.kind.name.startswith(("tree", "superelement"))
    if not ((nodes and all(nodes)) or on_node):
        return "its places are not nodes in space"
    if "ground" in members.table.kind.name:
        return NO_LAW
    p = momenta(lambda b: members.call("energy", b), members.inputs)
    expected = np.zeros((members.count, 6))
    for a, b, here in zip(*members.starts, nodes, strict=False):
        if not here:
            continue
        q = members.inputs["q"][:, a : a + NODE]
        linear_part = times(quaternion(q[:, :4]), p[:, b : b + 3])
        linear = p[:, b + 3 : b + 6]
        expected += np.concatenate([linear_part + cross(q[:, 4:], linear), linear], axis=-1)
    return relative(value - expected, expected, p)


def _mixed(members: Members) -> float | str:
    """With the stress that there is: the balance and its tangent."""
    nu = members.table.kind.nu

    def both(at: Members, name: str, part: slice) -> tuple[Array, Array]:
        z = at.call("mixed_step", {"du": np.zeros_like(at.inputs["du"])})
        return at.call("mixed", {"z": z})[:, part], at.call(name)

    return worst_of(
        members.disagreement(partial(both, name="balance", part=slice(0, nu))),
        members.disagreement(partial(both, name="balance_tangent", part=slice(nu, None))),
    )


def _mixed_step(members: Members) -> float | str:
    """The stress that there is comes from any; small increments lead to that behind them."""
    du = members.inputs["du"]
    none = {"du": np.zeros_like(du)}
    z = members.call("mixed_step", none)

    def both(at: Members) -> tuple[Array, Array]:
        once = at.call("mixed_step", none)
        return at.call("mixed_step", {**none, "z": once}), once

    worst = members.disagreement(both, members.inputs["z"])

    def settled(blocks: Mapping[str, Array]) -> Array:
        return members.call("mixed_step", {**blocks, "du": np.zeros_like(blocks["du"])})

    def stepped(at: Members) -> Array:
        settled = at.call("mixed_step", {"du": np.zeros_like(du)})
        return at.call("mixed_step", {"z": settled}) - settled

    slope, off = members.slope(settled, {"q": members.along(du)})
    step, blur = stepped(members), members.blur(lambda at: (stepped(at),))
    return worst_of(worst, missing(slope, off + blur, step, z * 1e-3))


def _stress(members: Members) -> float | str:
    """By quadrature of strain measures."""
    here = _stresses(members)
    if here is None:
        return NO_LAW

    def both(at: Members, k: int) -> tuple[Array, Array]:
        expected = here if at is members else np.asarray(_stresses(at))
        return at.call("stress").reshape(at.count, 4, 6)[:, k], expected[:, k]

    return worst_of(*(members.disagreement(partial(both, k=k)) for k in range(4)))


def _stresses(members: Members) -> Array | None:
    """Stress and strain (n, 4, 6) at both ends along the shape; None where it is not known."""
    ends = ends_of(members)
    names = [name for name in STRESSES if members.table.kind.name.startswith(name)]
    return STRESSES[max(names, key=len)](ends[0], ends[2]) if ends and names else None


LAWS: dict[str, Callable[[Members], float | str]] = {
    "energy": _energy,
    "momentum": _momentum,
    "mixed": _mixed,
    "mixed_step": _mixed_step,
    "stress": _stress,
}
