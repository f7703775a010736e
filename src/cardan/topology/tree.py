"""The spanning tree of a model: which joint is inboard of which body, in regular order."""

from __future__ import annotations

from dataclasses import dataclass
from heapq import heappop, heappush

from ..errors import TopologyError
from ..model.body import Body
from ..model.checks import circuits
from ..model.connections import Joint
from ..model.model import Model


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


def spanning_tree(model: Model) -> tuple[list[Branch], list[Joint]]:
    """Grow the tree from the ground, taking joints in the order of declaration.

    Returns:
        The branches, every inner body before its outer one, and the joints that close circuits.
    """
    joints = list(model.joints.values())
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


def open_tree(model: Model) -> list[Branch]:
    """The spanning tree of a model without circuits in which all bodies hang on the ground.

    Raises:
        TopologyError: a circuit, a body that nothing joins to the ground, or a joint whose child
            is nearer to the ground than its parent.
    """
    branches, closing = spanning_tree(model)
    if closing:
        names = ", ".join(f"'{j.name}'" for j in loop(branches, closing[0]))
        raise circuits(
            f"joint '{closing[0].name}' closes a circuit: body '{closing[0].child.body.name}' is "
            f"reached twice; joints on the loop: {names}"
        )
    reached = {branch.outer for branch in branches}
    loose = [body.name for body in model.bodies.values() if body not in reached]
    if loose:
        names = ", ".join(f"'{name}'" for name in loose[:12]) + (", ..." if len(loose) > 12 else "")
        raise TopologyError(
            f"nothing joins {'bodies' if len(loose) > 1 else 'body'} {names} to the ground. Add "
            "the missing joint; Free() lets a body float"
        )
    for branch in branches:
        joint = branch.joint
        if branch.reversed and joint.kind.kind != "fixed":
            raise TopologyError(
                f"joint '{joint.name}' ({joint.kind.kind}): its child '{branch.inner.name}' is "
                f"nearer to the ground than its parent '{branch.outer.name}'; exchange the two"
            )
    return branches


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
