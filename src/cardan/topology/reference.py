"""Placement in the reference configuration: ``pose=`` of bodies and ``at=`` of joints."""

from __future__ import annotations

from collections.abc import Callable

from ..errors import ModelError
from ..model.body import Body
from ..model.connections import Joint
from ..model.model import Model
from .convert import IDENTITY, Converter
from .placement import HERE, Placement


class Reference:
    """Poses of the bodies in ground axes at the default coordinates.

    A body with ``pose=`` has that; the others get theirs from their inboard joint. Nothing is
    computed in a model that uses neither ``pose=`` nor ``at=``.
    """

    def __init__(self, convert: Converter, model: Model) -> None:
        self.convert = convert
        self.active = any(b.pose is not None for b in model.bodies.values()) or any(
            j.at is not None for j in model.joints.values()
        )
        self.ground = model.ground
        self.poses: dict[Body, Placement] = {model.ground: HERE}

    def sides(
        self,
        joint: Joint,
        parent: Placement,
        child: Placement,
        rest: Callable[[], Placement] = lambda: HERE,
    ) -> tuple[Placement, Placement]:
        """The joint frame on the parent and on the child, each in its user body.

        Args:
            joint: The joint.
            parent, child: Its frames as written, in their user bodies.
            rest: Makes the pose of the child frame in the parent frame at the default coordinates.
        """
        if not self.active:
            return parent, child
        g, apart = self.convert.graph, rest()
        if joint.parent.body not in self.poses:
            return self._backwards(joint, parent, child, apart)
        base = self.poses[joint.parent.body]
        body = joint.child.body
        given = self._given(body)
        if joint.at is not None:
            place, there = self._at(joint, apart)
            self.poses[body] = given or there
            return base.inverse(g).then(g, place), self.poses[body].inverse(g).then(g, there)
        if given is not None and isinstance(joint.parent, Body):
            # the frame on the parent follows from where the child is
            self.poses[body] = given
            side = given.then(g, child).then(g, apart.inverse(g))
            return base.inverse(g).then(g, side), child
        found = base.then(g, parent).then(g, apart).then(g, child.inverse(g))
        if given is not None:
            self._agree(joint, body, found, given)
        self.poses[body] = given or found
        return parent, child

    def closing(
        self,
        joint: Joint,
        parent: Placement,
        child: Placement,
        rest: Callable[[], Placement] = lambda: HERE,
    ) -> tuple[Placement, Placement]:
        """The frames of a joint between bodies that have their places already."""
        if not self.active:
            return parent, child
        g, apart = self.convert.graph, rest()
        base, outer = self.poses[joint.parent.body], self.poses[joint.child.body]
        if joint.at is not None:
            place, there = self._at(joint, apart)
            return base.inverse(g).then(g, place), outer.inverse(g).then(g, there)
        if joint.child.body.pose is not None and isinstance(joint.parent, Body):
            side = outer.then(g, child).then(g, apart.inverse(g))
            return base.inverse(g).then(g, side), child
        return parent, child

    def _at(self, joint: Joint, apart: Placement) -> tuple[Placement, Placement]:
        """Both frames of a joint with ``at=``, in ground axes."""
        g = self.convert.graph
        place = Placement(IDENTITY, self.convert.vector(joint.at or (), f"{joint.name}.at", "m"))
        place = self._base(joint.base).then(g, place)
        return place, place.then(g, apart)

    def _backwards(
        self, joint: Joint, parent: Placement, child: Placement, apart: Placement
    ) -> tuple[Placement, Placement]:
        """A joint whose child is nearer to the ground."""
        g, body = self.convert.graph, joint.parent.body
        carrier, given = self.poses[joint.child.body], self._given(joint.parent.body)
        if joint.at is not None:
            place, there = self._at(joint, apart)
            self.poses[body] = given or place
            return self.poses[body].inverse(g).then(g, place), carrier.inverse(g).then(g, there)
        side = carrier.then(g, child).then(g, apart.inverse(g))
        found = side.then(g, parent.inverse(g))
        known = joint.child.body is self.ground or joint.child.body.pose is not None
        if given is not None and known and joint.parent is body:
            # the frame on the parent follows from where the child is
            self.poses[body] = given
            return given.inverse(g).then(g, side), child
        if given is not None:
            self._agree(joint, body, found, given)
        self.poses[body] = given or found
        return parent, child

    def _given(self, body: Body) -> Placement | None:
        if body.pose is None:
            return None
        position, rotation = body.pose
        given = Placement(
            self.convert.rotation(rotation, f"{body.name}.pose.rotation"),
            self.convert.vector(position, f"{body.name}.pose.position", "m"),
        )
        return self._base(body.base).then(self.convert.graph, given)

    def _base(self, body: Body | None) -> Placement:
        """Pose of the ground of an included model."""
        return HERE if body is None else self.poses[body]

    def _agree(self, joint: Joint, body: Body, found: Placement, given: Placement) -> None:
        """Frames on both sides and a pose say the same, at the default parameters.

        Raises:
            ModelError: they do not.
        """
        pairs = zip(
            (*found.rotation, *found.position), (*given.rotation, *given.position), strict=True
        )
        worst = max(abs(a - b) for a, b in (self.convert.defaults(pair) for pair in pairs))
        if worst > 1e-9:
            raise ModelError(
                f"joint '{joint.name}': its frames put body '{body.name}' "
                f"{worst:.3g} away from its pose=. Leave out one of them, or give the parent as "
                "a body: then its frame follows from the pose"
            )
