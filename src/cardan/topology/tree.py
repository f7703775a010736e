"""The spanning tree of a model: which joint is inboard of which body, and which joints are cut.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 8.2; Prim's algorithm for
the tree of fewest freedoms.
"""

from __future__ import annotations

from collections.abc import Collection, Container, Mapping
from dataclasses import dataclass
from heapq import heappop, heappush

from ..errors import TopologyError
from ..scene.body import Body
from ..scene.connections import Joint
from ..scene.scene import SceneRecord


@dataclass(frozen=True)
class Branch:
    """A joint of the tree with the bodies it joins; ``inner`` is nearer to the ground."""

    joint: Joint
    inner: Body
    outer: Body

    @property
    def reversed(self) -> bool:
        """The joint's child is nearer to the ground than its parent."""
        return self.joint.parent.body is self.outer


@dataclass(frozen=True)
class Closing:
    """A joint that closes a circuit.

    Attributes:
        joint: The joint.
        ring: All joints of the circuit, itself included.
        reason: Why this one was cut.
        carried: Its coordinates are wanted: it keeps them.
    """

    joint: Joint
    ring: tuple[Joint, ...]
    reason: str
    carried: bool = False


def spanning_tree(model: SceneRecord) -> tuple[list[Branch], list[Closing]]:
    """The tree from the ground, and the joints that close its circuits.

    Joints are taken in the order of declaration. Where there are circuits, those of most freedoms
    are cut: that leaves the fewest speeds, and with them the fewest constraints. In a scene with
    beams speeds do not count, and places follow in the order of the joints: the last ones are cut.

    Returns:
        The branches, every inner body before its outer one, and the cut joints.
    """
    joints, kept = list(model.joints.values()), keep(model)
    asked = {joint.name for joint in joints if joint.cut}
    branches, closing = _grow(model, [joint for joint in joints if not joint.cut])
    if closing and not model.beams:
        branches, closing = _grow(model, _fewest_freedoms(model, asked, kept))
        closing += [j for j in joints if j not in closing and _closes(branches, j)]
    closing += [j for j in joints if j.cut and j not in closing and _reached(model, branches, j)]
    order = {joint.name: k for k, joint in enumerate(joints)}
    closing.sort(key=lambda joint: order[joint.name])
    return branches, [_closing(branches, joint, kept) for joint in closing]


def keep(model: SceneRecord) -> dict[str, str]:
    """Joints whose coordinates are wanted, and so are cut last: name -> why."""
    found: dict[str, str] = {}
    for joint in model.joints.values():
        if joint.motion is not None:
            found[joint.name] = "it is prescribed"
        elif joint.couple is not None:
            found[joint.name] = f"it follows '{joint.couple.leader}'"
            found.setdefault(joint.couple.leader, f"joint '{joint.name}' follows it")
        elif joint.kind.closes_by_coordinates:
            found[joint.name] = "a joint of this kind closes circuits by its coordinates"
    for force in model.forces.values():
        for name in force.element.joints().values():
            found.setdefault(name, f"force '{force.name}' acts on its coordinate")
    for text, atom in model.atoms.items():
        if atom.quantity in ("q", "u"):
            found.setdefault(str(atom.place), f"'{text}' stands in an expression")
    return found


def _grow(model: SceneRecord, joints: Collection[Joint]) -> tuple[list[Branch], list[Joint]]:
    """A tree of the joints in their order, and those of them that close circuits."""
    joints = list(joints)
    at: dict[Body, list[int]] = {body: [] for body in model.bodies.values()}
    at[model.ground] = []
    for k, joint in enumerate(joints):
        at[joint.parent.body].append(k)
        at[joint.child.body].append(k)
    reached = {model.ground}
    open_joints: list[int] = []
    for k in at[model.ground]:
        heappush(open_joints, k)
    branches: list[Branch] = []
    used: set[int] = set()
    closing: list[Joint] = []
    while open_joints:
        k = heappop(open_joints)
        if k in used:
            continue
        used.add(k)
        joint = joints[k]
        a, b = joint.parent.body, joint.child.body
        inner, outer = (a, b) if a in reached else (b, a)
        if outer in reached:
            closing.append(joint)
            continue
        branches.append(Branch(joint, inner, outer))
        reached.add(outer)
        for j in at[outer]:
            heappush(open_joints, j)
    return branches, closing


def freedoms(joint: Joint, kept: Container[str]) -> int:
    """Speeds that a joint adds to the tree; -1 where cutting it would save none."""
    return -1 if joint.name in kept else len(joint.kind.speeds)


def _fewest_freedoms(
    model: SceneRecord, asked: Collection[str], kept: Container[str]
) -> list[Joint]:
    """The joints of the tree of fewest speeds; among those, of the shallowest, declared first."""
    joints = list(model.joints.values())
    at: dict[Body, list[int]] = {}
    for k, joint in enumerate(joints):
        if joint.name not in asked:
            for body in (joint.parent.body, joint.child.body):
                at.setdefault(body, []).append(k)
    depth = {model.ground: 0}
    open_joints: list[tuple[int, int, int]] = []

    def offer(body: Body) -> None:
        for k in at.get(body, []):
            heappush(open_joints, (freedoms(joints[k], kept), depth[body], k))

    offer(model.ground)
    taken: set[int] = set()
    while open_joints:
        _, deep, k = heappop(open_joints)
        ends = (joints[k].parent.body, joints[k].child.body)
        outer = next((body for body in ends if body not in depth), None)
        if outer is None:
            continue
        taken.add(k)
        depth[outer] = deep + 1
        offer(outer)
    return [joints[k] for k in sorted(taken)]


def _reached(model: SceneRecord, branches: list[Branch], joint: Joint) -> bool:
    """Whether both bodies of a joint hang on the ground without it.

    Raises:
        TopologyError: the tree needs a joint that is to be cut.
    """
    known = {model.ground, *(branch.outer for branch in branches)}
    ends = (joint.parent.body, joint.child.body)
    if all(body in known for body in ends):
        return True
    loose = next(body.name for body in ends if body not in known)
    raise TopologyError(
        f"joint '{joint.name}' ({joint.kind.kind}): cut=True, but it closes no circuit that is not "
        f"cut already: without it nothing joins body '{loose}' to the ground. Leave out cut=True "
        "here, or at another joint of its circuit"
    )


def _closes(branches: list[Branch], joint: Joint) -> bool:
    return not joint.cut and all(branch.joint is not joint for branch in branches)


def _closing(branches: list[Branch], joint: Joint, kept: Mapping[str, str]) -> Closing:
    """What a joint closes, and why it was cut."""
    ring = tuple(loop(branches, joint))
    carried = joint.name in kept and bool(joint.kind.coordinates)
    if joint.cut:
        return Closing(joint, ring, "cut=True asks for it", carried)
    if joint.name in kept:
        return Closing(joint, ring, "the coordinates of all joints here are wanted", carried)
    if joint.parent.body.model.beams:
        return Closing(joint, ring, "it is the last of its circuit")
    count = freedoms(joint, kept)
    others = [j for j in ring if j is not joint and freedoms(j, kept) >= count]
    freest = f"{count} freedoms less" if count != 1 else "1 freedom less"
    freest += " in the tree is the most that a joint of the circuit gives"
    if others:
        freest += f"; '{others[0].name}' would give as much, but a deeper tree"
    return Closing(joint, ring, freest)


def rooted_tree(model: SceneRecord) -> tuple[list[Branch], list[Closing]]:
    """The spanning tree of a model in which all bodies hang on the ground.

    Raises:
        TopologyError: a body that nothing joins to the ground.
    """
    branches, closing = spanning_tree(model)
    reached = {branch.outer for branch in branches}
    loose = [body.name for body in model.bodies.values() if body not in reached]
    if loose:
        names = ", ".join(f"'{name}'" for name in loose[:12]) + (", ..." if len(loose) > 12 else "")
        raise TopologyError(
            f"nothing joins {'bodies' if len(loose) > 1 else 'body'} {names} to the ground. Add "
            "the missing joint; Free() lets a body float"
        )
    return branches, closing


def loop(branches: list[Branch], closing: Joint) -> list[Joint]:
    """The joints of the circuit that a joint closes, itself included."""
    inboard = {branch.outer: branch for branch in branches}

    def path(body: Body) -> list[Branch]:
        found = []
        while body in inboard:
            found.append(inboard[body])
            body = inboard[body].inner
        return found

    one, other = path(closing.parent.body), path(closing.child.body)
    shared = set(map(id, one)) & set(map(id, other))
    there = [b.joint for b in reversed(one) if id(b) not in shared]
    back = [b.joint for b in other if id(b) not in shared]
    return [*there, closing, *back]
