"""Beams of a scene in numbers: where their nodes are, and the segments between them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...ir.function import live
from ...records import dataclass
from ...scene.beam import Beam
from ...scene.body import Body
from ...scene.frame import Place
from ..conversion import Converter
from ..placement import Placement
from .beam_nodes import meshed
from .nodal_scene import BeamNodes
from .segment_tables import Line

# rounding in products of rotations
ROUNDING = 4e-16
FARTHEST = 1e30  # m


@dataclass(frozen=True)
class Laid:
    """A beam in the reference configuration.

    Attributes:
        names: Of its named nodes from start to end.
        lines: The pieces between them.
    """

    names: tuple[str, ...]
    lines: tuple[Line, ...]

    @property
    def length(self) -> float:
        """Along the line [m]."""
        return float(self.lines[-1].stations[-1])

    def pose(self, name: str) -> tuple[Array, Array]:
        """Rotation (3, 3) and position (3,) of the section at a named node."""
        k = self.names.index(name)
        line, end = (self.lines[k], 0) if k < len(self.lines) else (self.lines[-1], -1)
        return line.rotations[end], line.positions[end]


class Beams:
    """Geometry of the beams, as soon as what their ends are joined to has its place.

    Args:
        convert: Makes expressions of what is written.
        nodes: The nodes of the scene.
        pose: Pose of a frame in the reference configuration; the second argument names who asks.

    Attributes:
        geometry: Names of the parameters that places of beams depend on.
    """

    def __init__(
        self, convert: Converter, nodes: BeamNodes, pose: Callable[[Place, str], Placement]
    ) -> None:
        self.convert = convert
        self.nodes = nodes
        self.geometry: set[str] = set()
        self._pose = pose
        self._laid: dict[str, Laid] = {}

    def pose(self, body: Body) -> Placement | None:
        """Pose of a node in the reference configuration; None of any other body."""
        beam = self.nodes.beams.get(body)
        return None if beam is None else self.constant(*self.laid(beam).pose(body.name))

    def constant(self, rotation: Array, position: Array) -> Placement:
        """A placement in numbers."""
        rounded = np.round(rotation)
        exact = np.where(np.abs(rotation - rounded) < ROUNDING, rounded, rotation) + 0.0
        const = self.convert.graph.const
        rotation_nodes = tuple([const(float(x)) for x in exact.ravel()])
        return Placement(rotation_nodes, tuple([const(float(x) + 0.0) for x in position]))

    def numbers(self, placement: Placement) -> tuple[Array, Array]:
        """Rotation (3, 3) and position (3,) at the values of the parameters, which stay so."""
        values = self.values((*placement.rotation, *placement.position))
        return values[:9].reshape(3, 3), values[9:]

    def values(self, nodes: Sequence[int]) -> Array:
        """Expressions at the values of the parameters, which stay so."""
        graph = self.convert.graph
        constants = [graph.value(node) for node in nodes]
        if None not in constants:
            return np.array(constants, dtype=np.float64)
        for node in live(graph, nodes):
            if graph.nodes[node][:2] == ("var", "p"):
                self.geometry.add(self.convert.parameters[graph.nodes[node][2]].name)
        return np.array(self.convert.defaults(nodes))

    def laid(self, beam: Beam) -> Laid:
        """The nodes of a beam.

        Raises:
            ModelError: no beam can lie there.
        """
        if beam.name not in self._laid:
            try:
                self._laid[beam.name] = self._lay(beam)
            except ModelError as problem:
                if str(problem).startswith("'"):
                    raise
                raise ModelError(f"beam '{beam.name}': {problem}") from problem
        return self._laid[beam.name]

    def _lay(self, beam: Beam) -> Laid:
        base_rotation, moved = np.eye(3), np.zeros(3)
        if beam.base is not None:
            base_rotation, moved = self.numbers(self._pose(beam.base, beam.name))
        ends = []
        for role, end in zip(("start", "end"), beam.ends, strict=True):
            name = f"{beam.name}.{role}"
            if end.place is None:
                ends.append(moved + base_rotation @ self._numbers_of(end.point, name, "m"))
            else:
                ends.append(self.numbers(self._pose(end.place, name))[1])
        data = {
            key: moved
            + self._numbers_of(entry.value, f"{beam.name}.line.{key}", entry.unit) @ base_rotation.T
            for key, entry in beam.line.quantities().items()
        }
        up = (
            None
            if beam.up is None
            else base_rotation @ self._numbers_of(beam.up, f"{beam.name}.up")
        )
        stops = sorted((s, name) for name, s in beam.stops.items())
        names = (f"{beam.name}.start", *(name for _, name in stops), f"{beam.name}.end")
        where = [0.0, *(s for s, _ in stops), 1.0]
        _near_enough(ends[0], ends[1], *data.values())
        curve = beam.line.curve(ends[0], ends[1], data)
        return Laid(names, tuple(meshed(curve, beam.elements, where, up)))

    def _numbers_of(self, value: object, name: str, unit: str = "") -> Array:
        """Numbers as written, or expressions at the values of the parameters."""
        if isinstance(value, (tuple, list)):
            labels = "xyz" if len(value) == 3 else range(1, len(value) + 1)
            rows = zip(value, labels, strict=True)
            return np.array(
                [self._numbers_of(entry, f"{name}.{label}", unit) for entry, label in rows]
            )
        # the numbers are used up here: no parameter could change them
        self.convert.fixing = True
        try:
            node = self.convert.scalar(value, name, unit)
        finally:
            self.convert.fixing = False
        return np.asarray(self.values([node])[0])

    def coordinates(self, pose: Placement) -> tuple[float, ...]:
        """Coordinates of a free joint from the ground in a pose:

        unit quaternion w x y z, then position.
        """
        rotation, position = self.numbers(pose)
        return (*quaternion(rotation), *(float(x) for x in position))


def quaternion(rotation: Array) -> tuple[float, ...]:
    """Unit quaternion w x y z of a rotation (3, 3), w not negative.

    Source: S. W. Shepperd, Quaternion from rotation matrix, 1978.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation
    # four times the products of its entries: the row of the largest is a multiple of it
    products = np.array(
        [
            [1 + xx + yy + zz, zy - yz, xz - zx, yx - xy],
            [zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx],
            [xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy],
            [yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz],
        ]
    )
    row = products[int(np.argmax(np.diag(products)))]
    row = row / np.linalg.norm(row) * (1 if row[0] >= 0 else -1)
    return tuple(float(x) + 0.0 for x in row)


def _near_enough(*places: Array) -> None:
    """Squares of coordinates must be numbers too.

    Raises:
        ModelError: one is not.
    """
    for place in places:
        farthest = float(np.abs(place).max(initial=0.0))
        if not farthest <= FARTHEST:
            raise ModelError(
                f"a point of its line is {farthest:g} m away; at most {FARTHEST:g} m are taken"
            )
