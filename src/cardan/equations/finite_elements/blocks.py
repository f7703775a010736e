"""Blocks of places: nodes, lines, and joints with rotations, with the motion of their q."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

import numpy as np

from ...arrays import Integers
from ...elements.joints.free import Free
from ...elements.joints.joint import Joint as JointElement
from ...ir.function import Function
from ...records import dataclass
from ...schema.blocks import ABI_ORDER
from ...schema.functions import FUNCTIONS
from ...spatial.plane import Plane
from ...topology.system import System
from ..functions.blocks import blocks, labels
from ..functions.context import Context
from ..functions.dynamics import Dynamics
from ..functions.recipes import RECIPES
from ..kinematics.kinematics import Kinematics
from .element_systems import Cutting
from .nodal_scene import NODE, Key, Scene
from .planar_kinds import plane_node
from .record import BlockKind

MOVING = ("move", "qdot", "difference")


@dataclass(frozen=True)
class Holds:
    """Block kinds of places, in space and in the model, where nodes may be planar.

    Attributes:
        node: What a node holds in space.
        space, here: By place.
        segments: What the nodes inside of every segment hold; none where that is ``node``.
    """

    node: BlockKind
    space: Mapping[Key, BlockKind]
    here: Mapping[Key, BlockKind]
    segments: tuple[BlockKind, ...] = ()

    def inside(self, segment: int) -> BlockKind:
        """Block kind of the nodes inside a segment."""
        return self.segments[segment] if self.segments else self.node


def holds(scene: Scene, bodies: Mapping[int, Plane] | None, segments: Sequence[Plane]) -> Holds:
    """Block kinds of the places of a scene.

    Args:
        scene: The scene.
        bodies: The plane of every node that belongs to a body, None in space.
        segments: That of the nodes inside of every segment.
    """
    kinds, numbers = block_kinds(scene)
    space = {key: kinds[k] for key, k in zip(scene.places, numbers, strict=True)}
    if bodies is None:
        return Holds(kinds[0], space, space)
    planes = dict.fromkeys([*(bodies[i] for kind, i in scene.places if kind == NODE), *segments])
    node_kinds = {plane: plane_node(plane, k) for k, plane in enumerate(planes)}
    here = {
        key: node_kinds[bodies[key[1]]] if key[0] == NODE else kind for key, kind in space.items()
    }
    return Holds(kinds[0], space, here, tuple(node_kinds[plane] for plane in segments))


def block_kinds(scene: Scene) -> tuple[tuple[BlockKind, ...], Integers]:
    """The kinds of places of a scene, nodes first, and the kind of every place."""
    kinds: dict[str, BlockKind] = {NODE: _node(scene)}
    numbers = []
    for key in scene.places:
        text = _structure(scene, key)
        if text not in kinds:
            kinds[text] = _joint_block(scene, key, {kind.name for kind in kinds.values()})
        numbers.append(list(kinds).index(text))
    return tuple(kinds.values()), np.array(numbers, dtype=np.intp)


def _structure(scene: Scene, key: Key) -> str:
    """Text that places of one kind share."""
    if key[0] == NODE:
        return NODE
    element = scene.system.joints[key[1]].element
    rotation = "" if scene.line(key[1]) else f"{element.kind} {getattr(element, 'rotation', '')}"
    return repr((rotation, element.coordinates, element.speeds))


def _joint_block(scene: Scene, key: Key, taken: set[str]) -> BlockKind:
    element, count = scene.system.joints[key[1]].element, scene.line(key[1])
    label = f"line{count}" if count else f"{element.kind}_{getattr(element, 'rotation', '')}"
    name = base = re.sub(r"\W", "_", label)
    while name in taken:
        name = f"{base}_{len(taken)}"
    if count:
        return _block(name, element, {})
    cutting = Cutting(scene)
    cutting.alone(key[1])
    return _block(name, element, _functions(cutting.system_of(), name))


def _node(scene: Scene) -> BlockKind:
    cutting = Cutting(scene)
    cutting.floating(NODE)
    return _block(NODE, Free(), _functions(cutting.system_of(), NODE))


def _block(name: str, element: JointElement, functions: dict[str, Function]) -> BlockKind:
    coordinates, speeds = element.coordinates, element.speeds
    return BlockKind(
        name=name,
        coordinates=tuple(c.name for c in coordinates),
        speeds=tuple(c.name for c in speeds),
        q_units=tuple(c.unit for c in coordinates),
        u_units=tuple(c.unit for c in speeds),
        defaults=tuple(c.default for c in coordinates),
        quaternion=element.quaternion,
        functions=functions,
    )


def _functions(system: System, name: str) -> dict[str, Function]:
    """Motion of the coordinates of a joint."""
    listed = blocks(system)
    context = Context(Dynamics(Kinematics(system), "composite"), *labels(listed))
    return {
        key: Function(
            f"{name}__{key}",
            context.k.graph,
            tuple(listed[letter] for letter in ABI_ORDER),
            RECIPES[key](context),
            (name,),
            FUNCTIONS[key].about,
        )
        for key in MOVING
    }
