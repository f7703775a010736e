"""Placement in the reference configuration: ``pose=`` of bodies and ``at=`` of joints."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..errors import ModelError
from ..scene.body import Body
from ..scene.connections import Joint
from ..scene.frame import Place
from ..scene.scene import SceneRecord
from .beams.beams import Beams
from .conversion import IDENTITY, Converter
from .placement import HERE, Placement, rotated

# of numbers that a user types, against the length of the beam
TOLERANCE = 1e-6


class Reference:
    """Poses of the bodies in ground axes at the default coordinates.

    A body with ``pose=`` has that; the others get theirs from their inboard joint. Nothing is
    computed in a model that uses neither ``pose=`` nor ``at=`` nor beams.
    """

    def __init__(self, convert: Converter, model: SceneRecord, beams: Beams) -> None:
        self.convert = convert
        self.beams = beams
        self.active = (
            bool(model.beams)
            or any(b.pose is not None for b in model.bodies.values())
            or any(j.at is not None for j in model.joints.values())
        )
        self.ground = model.ground
        self.poses: dict[Body, Placement] = {model.ground: HERE}

    def sides(
        self,
        joint: Joint,
        parent: Placement,
        child: Placement,
        default_pose_of: Callable[[], Placement] = lambda: HERE,
    ) -> tuple[Placement, Placement]:
        """The joint frame on the parent and on the child, each in its user body.

        Args:
            joint: The joint.
            parent, child: Its frames as written, in their user bodies.
            default_pose_of: Makes the pose of the child frame in the parent frame at the default
                coordinates.
        """
        if not self.active:
            return parent, child
        g, default_pose = self.convert.graph, default_pose_of()
        if self._at_node(joint):
            return self._noded(joint, parent, child, default_pose)
        if joint.parent.body not in self.poses:
            return self._backwards(joint, parent, child, default_pose)
        base = self.poses[joint.parent.body]
        body = joint.child.body
        declared = self._declared_pose(body)
        if joint.at is not None:
            place, there = self._at(joint, default_pose)
            self.poses[body] = declared or there
            return base.inverse(g).then(g, place), self.poses[body].inverse(g).then(g, there)
        if declared is not None and isinstance(joint.parent, Body):
            # the frame on the parent follows from where the child is
            self.poses[body] = declared
            side = declared.then(g, child).then(g, default_pose.inverse(g))
            return base.inverse(g).then(g, side), child
        computed = base.then(g, parent).then(g, default_pose).then(g, child.inverse(g))
        if declared is not None:
            self._agree(joint, body, computed, declared)
        self.poses[body] = declared or computed
        return parent, child

    def closing(
        self,
        joint: Joint,
        parent: Placement,
        child: Placement,
        default_pose_of: Callable[[], Placement] = lambda: HERE,
    ) -> tuple[Placement, Placement]:
        """The frames of a joint between bodies that have their places already."""
        if not self.active:
            return parent, child
        g, default_pose = self.convert.graph, default_pose_of()
        if self._at_node(joint):
            return self._noded(joint, parent, child, default_pose)
        base, outer = self.poses[joint.parent.body], self.poses[joint.child.body]
        if joint.at is not None:
            place, there = self._at(joint, default_pose)
            return base.inverse(g).then(g, place), outer.inverse(g).then(g, there)
        if joint.child.body.pose is not None and isinstance(joint.parent, Body):
            side = outer.then(g, child).then(g, default_pose.inverse(g))
            return base.inverse(g).then(g, side), child
        return parent, child

    # joints at nodes of beams

    def floating(self, joint: Joint) -> tuple[Placement, Placement]:
        """The frames of an implicit joint: both are origins."""
        body = joint.child.body
        pose = self.beams.pose(body) or self._declared_pose(body)
        assert pose is not None, "a body moves freely only where it has a place"
        self.poses[body] = pose
        return HERE, HERE

    def _at_node(self, joint: Joint) -> bool:
        return any(place.body in self.beams.nodes.beams for place in (joint.parent, joint.child))

    def _noded(
        self, joint: Joint, parent: Placement, child: Placement, default_pose: Placement
    ) -> tuple[Placement, Placement]:
        """A joint at a node sits there; its axes are those of the parent, the others follow.

        Where the other side is a body, its frame follows too; where it is a frame or a node, both
        must be at the same place.
        """
        g = self.convert.graph
        inner, outer = joint.parent.body, joint.child.body
        for body in (inner, outer):
            pose = (
                None if body in self.poses else self.beams.pose(body) or self._declared_pose(body)
            )
            if pose is not None:
                self.poses[body] = pose
        if joint.at is not None:
            place, there = self._at(joint, default_pose)
            self.poses.setdefault(inner, place)
            self.poses.setdefault(outer, there)
            return self._onto(inner, place), self._onto(outer, there)
        if inner not in self.poses or outer not in self.poses:
            # one of them is carried by the node: the frames coincide
            if inner in self.poses:
                moved = parent.then(g, default_pose).then(g, child.inverse(g))
                self.poses[outer] = self.poses[inner].then(g, moved)
            else:
                moved = child.then(g, default_pose.inverse(g)).then(g, parent.inverse(g))
                self.poses[inner] = self.poses[outer].then(g, moved)
            return parent, child
        return self._from_node_poses(joint, parent, child, default_pose)

    def _from_node_poses(
        self, joint: Joint, parent: Placement, child: Placement, default_pose: Placement
    ) -> tuple[Placement, Placement]:
        """The frames of a joint at a node, both sides of which have their places."""
        g = self.convert.graph
        inner, outer = joint.parent.body, joint.child.body
        near, far = self.poses[inner].then(g, parent), self.poses[outer].then(g, child)
        released = joint.name in self.beams.nodes.releases
        axes = far.rotation if released else near.rotation
        place = Placement(axes, near.position)
        if self._follows(joint.parent):
            arm = rotated(g, axes, default_pose.position)
            place = Placement(axes, tuple(map(g.sub, far.position, arm)))
            near_side = self._onto(inner, place)
        else:
            # what is let go turns about axes of its own beam, not of the node it leaves
            axes_there = self._onto(inner, place).rotation if released else parent.rotation
            near_side = Placement(axes_there, parent.position)
        there = place.then(g, default_pose)
        far_side = self._onto(outer, there)
        if not self._follows(joint.child):
            self._meet(joint, there, far)
            far_side = child if released else Placement(far_side.rotation, child.position)
        return near_side, far_side

    def _follows(self, place: Place) -> bool:
        """True when the frame of a joint on a body follows from the node on its other side."""
        return isinstance(place, Body) and place not in self.beams.nodes.beams

    def _onto(self, body: Body, place: Placement) -> Placement:
        """A place in ground axes as seen from a body; in numbers, unless nothing has to be."""
        g = self.convert.graph
        relative = self.poses[body].inverse(g).then(g, place)
        return self.beams.constant(*self.beams.numbers(relative))

    def _meet(self, joint: Joint, actual: Placement, required: Placement) -> None:
        """Both sides of a joint at a node are at the same place.

        Raises:
            ModelError: they are apart.
        """
        a, b = (np.array(self.convert.defaults(p.position)) for p in (actual, required))
        beams = (self.beams.nodes.beams.get(p.body) for p in (joint.parent, joint.child))
        length = max(self.beams.laid(beam).length for beam in beams if beam is not None)
        gap = float(np.linalg.norm(a - b))
        if gap > TOLERANCE * length:
            raise ModelError(
                f"joint '{joint.name}' ({joint.kind.kind}): '{joint.parent.name}' and "
                f"'{joint.child.name}' are {gap:.3g} m apart where the beams lie in the reference "
                "configuration. Let them meet, or name a body instead of a frame: then the frame "
                "of the joint follows from the node"
            )

    def _at(self, joint: Joint, default_pose: Placement) -> tuple[Placement, Placement]:
        """Both frames of a joint with ``at=``, in ground axes."""
        g = self.convert.graph
        place = Placement(IDENTITY, self.convert.vector(joint.at or (), f"{joint.name}.at", "m"))
        place = self._base(joint.base).then(g, place)
        return place, place.then(g, default_pose)

    def _backwards(
        self, joint: Joint, parent: Placement, child: Placement, default_pose: Placement
    ) -> tuple[Placement, Placement]:
        """A joint whose child is nearer to the ground."""
        g, body = self.convert.graph, joint.parent.body
        carrier, declared = self.poses[joint.child.body], self._declared_pose(joint.parent.body)
        if joint.at is not None:
            place, there = self._at(joint, default_pose)
            self.poses[body] = declared or place
            return self.poses[body].inverse(g).then(g, place), carrier.inverse(g).then(g, there)
        side = carrier.then(g, child).then(g, default_pose.inverse(g))
        computed = side.then(g, parent.inverse(g))
        child_declared = joint.child.body is self.ground or joint.child.body.pose is not None
        if declared is not None and child_declared and joint.parent is body:
            # the frame on the parent follows from where the child is
            self.poses[body] = declared
            return declared.inverse(g).then(g, side), child
        if declared is not None:
            self._agree(joint, body, computed, declared)
        self.poses[body] = declared or computed
        return parent, child

    def _declared_pose(self, body: Body) -> Placement | None:
        if body.pose is None:
            return None
        position, rotation = body.pose
        declared = Placement(
            self.convert.rotation(rotation, f"{body.name}.pose.rotation"),
            self.convert.vector(position, f"{body.name}.pose.position", "m"),
        )
        return self._base(body.base).then(self.convert.graph, declared)

    def _base(self, body: Body | None) -> Placement:
        """Pose of the ground of an included model."""
        return HERE if body is None else self.poses[body]

    def _agree(self, joint: Joint, body: Body, computed: Placement, declared: Placement) -> None:
        """Frames on both sides and a pose say the same, at the default parameters.

        Raises:
            ModelError: they do not.
        """
        pairs = zip(
            (*computed.rotation, *computed.position),
            (*declared.rotation, *declared.position),
            strict=True,
        )
        worst = max(abs(a - b) for a, b in (self.convert.defaults(pair) for pair in pairs))
        if worst > 1e-9:
            raise ModelError(
                f"joint '{joint.name}': its frames put body '{body.name}' "
                f"{worst:.3g} away from its pose=. Leave out one of them, or give the parent as "
                "a body: then its frame follows from the pose"
            )
