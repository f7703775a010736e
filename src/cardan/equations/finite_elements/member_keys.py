"""Keys that bodies and joints of a scene share when what is derived for one serves all of them.

Of members with equal keys one is looked at; the others differ in what they read alone. A member
that takes part in more than its neighborhood has no key.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import NamedTuple

from ...elements.outline import Outlines
from ...ir.function import pattern
from ...topology.system import GROUND
from .element_systems import STRUCTURAL
from .nodal_scene import Scene


class Member(NamedTuple):
    """A body or joint as its small system sees it.

    Attributes:
        key: Equal for members that one small system serves.
        data: Expression in the parameters of the scene of every parameter of the small system.
    """

    key: Hashable
    data: tuple[int, ...]


class Motion(NamedTuple):
    """The motion of a body against its parent as expressions see it.

    Attributes:
        key: Equal for joints that move bodies in the same way.
        inputs: (block, entry) of what such expressions may read, in the same order for all.
    """

    key: Hashable
    inputs: tuple[tuple[str, int], ...]


class MemberKeys:
    """Keys of the members of a scene.

    Args:
        scene: Whose bodies and joints.
    """

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._outlines = Outlines()

    def body(self, i: int) -> Member | None:
        """A rigid body by its mass and by gravity; None where these are not parameters alone."""
        body = self.scene.system.bodies[i]
        gravity = self.scene.system.gravity
        return self._member((body.mass, *body.first_moment, *body.inertia, *gravity), ())

    def joint(self, i: int) -> Member | None:
        """A joint between two bodies, by its element, place and numbers.

        None where it is coupled or prescribed, closes a loop, stands on a rigid tree, or has
        friction that its reaction tells.
        """
        scene, joint = self.scene, self.scene.system.joints[i]
        if joint.coupling is not None or joint.motion is not None:
            return None
        parent = scene.system.bodies[i].parent
        if i in scene.joints_of_cuts or i in scene.frictions or parent in scene.in_trees:
            return None
        nodes, shapes = [*joint.rotation, *joint.position], list[tuple[str, int, int]]()
        for name, (rows, columns, entries) in joint.data.items():
            shapes.append((name, rows, columns))
            nodes += entries
        outlined = self._outlines[joint.element]
        return self._member(nodes, (outlined, tuple(shapes), joint.reversed, parent == GROUND))

    def motion(self, i: int) -> Motion | None:
        """The motion of a body by its joint; None where more than inputs and leaders say it."""
        system = self.scene.system
        joint = system.joints[i]
        nodes, shapes = [*joint.rotation, *joint.position], list[Hashable]()
        for name, (rows, columns, entries) in joint.data.items():
            shapes.append((name, rows, columns))
            nodes += entries
        slots = joint
        while slots.coupling is not None:
            nodes += (slots.coupling.ratio, slots.coupling.offset)
            shapes.append("coupled")
            slots = system.joints[slots.coupling.leader]
        if joint.motion is not None:
            moves = joint.motion
            nodes += (moves.value, moves.rate, moves.acceleration, moves.ratio)
            shapes.append("prescribed")
        elif slots.q < 0:
            return None
        expressions, places = pattern(system.graph, nodes, ("p", "t", "r"))
        if expressions is None:
            return None
        inputs = list(places)
        if joint.motion is None:
            inputs += [("q", slots.q + n) for n in range(len(slots.element.coordinates))]
            inputs += [("u", slots.u + n) for n in range(len(slots.element.speeds))]
        from_ground = system.bodies[i].parent == GROUND
        key = (self._outlines[joint.element], tuple(shapes), expressions, from_ground)
        return Motion(key, tuple(inputs))

    def _member(self, nodes: Sequence[int], more: Hashable) -> Member | None:
        """Expressions in local numbers, in the order in which a small system takes them."""
        graph, fixed = self.scene.system.graph.nodes, self.scene.parameters_only
        number: dict[int, int] = {}
        local: list[tuple[int, bool]] = []
        for i in nodes:
            if not fixed[i]:
                return None
            negative = False
            while i not in STRUCTURAL and graph[i][0] == "neg":
                i, negative = graph[i][1], not negative
            # below 0: numbers that the expressions of all members depend on
            place = -1 - i if i in STRUCTURAL else number.setdefault(i, len(number))
            local.append((place, negative))
        return Member((more, tuple(local)), tuple(number))
