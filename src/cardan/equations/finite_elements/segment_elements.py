"""Nodes of a segment in the reference configuration, and its elements."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from typing import TypeAlias

import numpy as np

from ...elements.flexible import BEAMS, INERTIAS, LOADS
from ...elements.flexible.damping import Damping
from ...elements.flexible.element import FlexibleElement
from ...elements.flexible.element_ends import CENTER
from ...elements.flexible.gravity_field import GravityField
from ...elements.flexible.node_set import FRAME
from ...ir.function import Block, Function, Output, live
from ...ir.graph import ZERO, Graph
from ...ir.interpreter import evaluate
from ...ir.matrix import Matrix
from ...spatial.exponential import quaternion_of
from ...topology.beams.segment_tables import Segment, numbered
from ...topology.conversion import parameters_only
from ...topology.system import System
from .nodal_scene import Scene
from .record import Numbers

# an element, expressions of its common data, of those that vary, the frame of its center
ElementData: TypeAlias = tuple[FlexibleElement, dict[str, int], dict[str, int], int | None]


def elements_of(scene: Scene, segment: Segment) -> Iterator[ElementData]:
    """The elements of a segment, expressions of their common data and of those that more than
    parameters change, and the frame of a center."""
    system, strained = scene.system, BEAMS[segment.element]
    values = numbered({**segment.data, "gravity": (3, 1, system.gravity)})
    yield strained, values, {}, None
    # what it carries for all acts once
    values = values | dict.fromkeys(strained.carries, ZERO)
    if values["rhoA"] != ZERO:
        yield INERTIAS[segment.inertia], values, {}, None
        yield from _fields(scene, segment, values)
    if values["damping"] != ZERO:
        yield Damping(), values, {}, None
    variable = numbered(segment.variable_loads)
    for load in LOADS:
        names = load.quantities
        if any(values[name] != ZERO for name in names):
            yield load(), values, {}, None
        changing = {name: variable[name] for name in names}
        if any(node != ZERO for node in changing.values()):
            yield load(variable=True), values, changing, None


def _fields(scene: Scene, segment: Segment, values: dict[str, int]) -> Iterator[ElementData]:
    """Gravity fields that pull it."""
    system = scene.system
    for one in segment.fields:
        frame = system.frames[scene.frame(one.center)]
        at = zip(FRAME, (*frame.rotation, *frame.position), strict=True)
        place = {f"{CENTER}_{entry}": node for entry, node in at}
        variable_data = {n: entry for n, entry in one.data.items() if _varies(system, entry[2])}
        lumped = segment.inertia == "lumped"
        element = GravityField(one.element, lumped, tuple(variable_data))
        data = values | numbered(one.data) | place
        yield element, data, numbered(variable_data), one.center


def _varies(system: System, nodes: Sequence[int]) -> bool:
    """True when more than parameters change an expression."""
    return not parameters_only(system.graph, live(system.graph, nodes)).issuperset(nodes)


def poses_of(segment: Segment) -> Numbers:
    """Unit quaternions and positions of the nodes (n + 1, 7)."""
    line = segment.line
    quaternions = evaluate(_quaternions(), {"q": line.rotations.reshape(-1, 9)}, "numpy")["q"]
    # of q and -q that beside the one before
    flipped = np.sum(quaternions[1:] * quaternions[:-1], axis=1) < 0
    quaternions[1:] *= np.cumprod(np.where(flipped, -1.0, 1.0))[:, None]
    return np.hstack([quaternions, line.positions])


@cache
def _quaternions() -> Function:
    """Rotation matrix q (9) -> unit quaternion (4)."""
    graph = Graph()
    R = Matrix(graph, 3, 3, [graph.var("q", k) for k in range(9)])
    block = Block("q", tuple(f"R{k}" for k in range(9)), ("",) * 9)
    output = Output("q", (4,), quaternion_of(R).nodes)
    return Function("quaternions", graph, (block,), (output,))
