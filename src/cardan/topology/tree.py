"""The spanning tree of a model: which joint is inboard of which body, and which joints are cut.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 8.2; Prim's algorithm for
the tree of fewest freedoms.
"""

from __future__ import annotations

from collections.abc import Collection, Container, Mapping, Sequence
from heapq import heappop, heappush

from ..errors import TopologyError
from ..records import dataclass
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
    """A joint that closes a loop.

    Attributes:
        joint: The joint.
        ring: All joints of the loop, itself included.
        reason: Why this one was cut.
        keeps_coordinates: Its coordinates are wanted: it keeps them.
    """

    joint: Joint
    ring: tuple[Joint, ...]
    reason: str
    keeps_coordinates: bool = False


def spanning_tree(model: SceneRecord) -> tuple[list[Branch], list[Closing]]:
    """The tree from the ground, and the joints that close its loops.

    Joints are taken in the order of declaration. Where there are loops, those of most freedoms
    are cut: that leaves the fewest speeds, and with them the fewest constraints. In a scene with
    beams speeds do not count, and places follow in the order of the joints: the last ones are cut.

    Returns:
        The branches, every inner body before its outer one, and the cut joints.
    """
    joints, required = list(model.joints.values()), required_coordinates(model)
    requested = {joint.name for joint in joints if joint.cut}
    branches, closing = _grow(model, [joint for joint in joints if not joint.cut])
    if closing and not model.beams:
        branches, closing = _grow(model, _fewest_freedoms(model, requested, required))
        closing += [j for j in joints if j not in closing and _closes(branches, j)]
    closing += [
        j for j in joints if j.cut and j not in closing and _is_connected(model, branches, j)
    ]
    order = {joint.name: k for k, joint in enumerate(joints)}
    closing.sort(key=lambda joint: order[joint.name])
    return branches, [_closing(branches, joint, required) for joint in closing]


def required_coordinates(model: SceneRecord) -> dict[str, str]:
    """Joints whose coordinates are wanted, and so are cut last: name -> why."""
    reasons: dict[str, str] = {}
    for joint in model.joints.values():
        if joint.prescribed is not None:
            reasons[joint.name] = "it is prescribed"
        elif joint.couple is not None:
            reasons[joint.name] = f"it follows '{joint.couple.leader}'"
            reasons.setdefault(joint.couple.leader, f"joint '{joint.name}' follows it")
        elif joint.kind.closes_by_coordinates:
            reasons[joint.name] = "a joint of this kind closes loops by its coordinates"
    for force in model.forces.values():
        for name in force.element.joints().values():
            reasons.setdefault(name, f"force '{force.name}' acts on its coordinate")
    for text, atom in model.atoms.items():
        if atom.quantity in ("q", "u"):
            reasons.setdefault(str(atom.place), f"'{text}' stands in an expression")
    return reasons


def _grow(model: SceneRecord, joints: Collection[Joint]) -> tuple[list[Branch], list[Joint]]:
    """A tree of the joints in their order, and those of them that close loops."""
    joints = list(joints)
    at: dict[Body, list[int]] = {body: [] for body in model.bodies.values()}
    at[model.ground] = []
    for k, joint in enumerate(joints):
        at[joint.parent.body].append(k)
        at[joint.child.body].append(k)
    in_tree = {model.ground}
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
        inner, outer = (a, b) if a in in_tree else (b, a)
        if outer in in_tree:
            closing.append(joint)
            continue
        branches.append(Branch(joint, inner, outer))
        in_tree.add(outer)
        for j in at[outer]:
            heappush(open_joints, j)
    return branches, closing


def freedoms(joint: Joint, required: Container[str]) -> int:
    """Speeds that a joint adds to the tree; -1 where cutting it would save none."""
    return -1 if joint.name in required else len(joint.kind.speeds)


def _fewest_freedoms(
    model: SceneRecord, requested: Collection[str], required: Container[str]
) -> list[Joint]:
    """The joints of the tree of fewest speeds; among those, of the shallowest, declared first."""
    joints = list(model.joints.values())
    at: dict[Body, list[int]] = {}
    for k, joint in enumerate(joints):
        if joint.name not in requested:
            for body in (joint.parent.body, joint.child.body):
                at.setdefault(body, []).append(k)
    depth = {model.ground: 0}
    open_joints: list[tuple[int, int, int]] = []

    def offer(body: Body) -> None:
        for k in at.get(body, []):
            heappush(open_joints, (freedoms(joints[k], required), depth[body], k))

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


def _is_connected(model: SceneRecord, branches: list[Branch], joint: Joint) -> bool:
    """True when both bodies of a joint hang on the ground without it.

    Raises:
        TopologyError: the tree needs a joint that is to be cut.
    """
    connected = {model.ground, *(branch.outer for branch in branches)}
    ends = (joint.parent.body, joint.child.body)
    if all(body in connected for body in ends):
        return True
    unconnected = next(body.name for body in ends if body not in connected)
    raise TopologyError(
        f"joint '{joint.name}' ({joint.kind.kind}): cut=True, but it closes no loop that is not "
        f"cut already: without it nothing joins body '{unconnected}' to the ground. Leave out "
        "cut=True "
        "here, or at another joint of its loop"
    )


def _closes(branches: list[Branch], joint: Joint) -> bool:
    return not joint.cut and all(branch.joint is not joint for branch in branches)


def _closing(branches: list[Branch], joint: Joint, required: Mapping[str, str]) -> Closing:
    """Loop that a joint closes, and the reason why it was cut."""
    ring = tuple(loop(branches, joint))
    keeps_coordinates = joint.name in required and bool(joint.kind.coordinates)
    if joint.cut:
        return Closing(joint, ring, "cut=True asks for it", keeps_coordinates)
    if joint.name in required:
        return Closing(
            joint, ring, "the coordinates of all joints here are wanted", keeps_coordinates
        )
    if joint.parent.body.model.beams:
        return Closing(joint, ring, "it is the last of its loop")
    count = freedoms(joint, required)
    alternatives = [j for j in ring if j is not joint and freedoms(j, required) >= count]
    freest = f"{count} freedoms less" if count != 1 else "1 freedom less"
    freest += " in the tree is the most that a joint of the loop gives"
    if alternatives:
        freest += f"; '{alternatives[0].name}' would give as much, but a deeper tree"
    return Closing(joint, ring, freest)


def rooted_tree(model: SceneRecord) -> tuple[list[Branch], list[Closing]]:
    """The spanning tree of a model in which all bodies hang on the ground.

    Raises:
        TopologyError: a body that nothing joins to the ground.
    """
    branches, closing = spanning_tree(model)
    connected = {branch.outer for branch in branches}
    unconnected = [body.name for body in model.bodies.values() if body not in connected]
    if unconnected:
        owners = {
            place: one.name
            for one in model.superelements.values()
            for place in (*one.places, one.modes_body)
        }
        flexible = [*dict.fromkeys(owners[name] for name in unconnected if name in owners)]
        rigid = [name for name in unconnected if name not in owners]
        kinds = (("body", "bodies", rigid), ("superelement", "superelements", flexible))
        floating = " and ".join(
            f"{many if len(names) > 1 else one} {_listed(names)}"
            for one, many, names in kinds
            if names
        )
        raise TopologyError(
            f"nothing joins {floating} to the ground. Add the missing joint"
            f"{', or fix an interface to something (interfaces=)' if flexible else ''}; "
            f"Free() lets a body float"
        )
    return branches, closing


def _listed(names: Sequence[str]) -> str:
    return ", ".join(f"'{name}'" for name in names[:12]) + (", ..." if len(names) > 12 else "")


def loop(branches: list[Branch], closing: Joint) -> list[Joint]:
    """The joints of the loop that a joint closes, itself included."""
    inboard = {branch.outer: branch for branch in branches}

    def path(body: Body) -> list[Branch]:
        branches_inward = []
        while body in inboard:
            branches_inward.append(inboard[body])
            body = inboard[body].inner
        return branches_inward

    one, other = path(closing.parent.body), path(closing.child.body)
    shared = set(map(id, one)) & set(map(id, other))
    there = [b.joint for b in reversed(one) if id(b) not in shared]
    back = [b.joint for b in other if id(b) not in shared]
    return [*there, closing, *back]
