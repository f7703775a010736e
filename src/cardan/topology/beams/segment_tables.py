"""Segments of beams: what lies between two named nodes, as tables of numbers.

What is the same along a segment (section, material, loads) are expressions of the parameters; what
differs from element to element is geometry, and geometry is numbers: a segment of 1e5 elements is
three arrays.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import field

import numpy as np

from ...arrays import Array
from ...elements.forces.gravity.gravitation import Gravitation
from ...elements.sections.section import Outline
from ...records import dataclass

# of what nobody draws
ROUND = Outline(0.0, 0.0, round=True)


@dataclass(frozen=True, eq=False)
class Line:
    """Nodes of a segment in the reference configuration, both ends included.

    Attributes:
        stations: Arc length from the start of the beam (n + 1,) [m]; n is the number of elements.
        positions: Of the nodes in ground axes (n + 1, 3) [m].
        rotations: Of the section axes (n + 1, 3, 3): columns e1 (along the beam), e2, e3 in ground
            axes.
    """

    stations: Array
    positions: Array
    rotations: Array

    def __post_init__(self) -> None:
        for array in (self.stations, self.positions, self.rotations):
            array.setflags(write=False)

    @property
    def elements(self) -> int:
        """Number of elements."""
        return len(self.stations) - 1

    @property
    def lengths(self) -> Array:
        """Lengths of the elements along the beam (n,) [m]."""
        return np.diff(self.stations)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Line) and all(
            np.array_equal(a, b) for a, b in zip(self._arrays, other._arrays, strict=True)
        )

    def __hash__(self) -> int:
        return hash(self._digest())

    def __repr__(self) -> str:
        # the same text for the same numbers: systems are told apart by what they print
        return f"Line({self.elements} elements, {self._digest()})"

    @property
    def _arrays(self) -> tuple[Array, Array, Array]:
        return self.stations, self.positions, self.rotations

    def _digest(self) -> str:
        data = b"".join(np.ascontiguousarray(a).tobytes() for a in self._arrays)
        return hashlib.sha256(data).hexdigest()[:32]


@dataclass(frozen=True)
class GravityOnBeam:
    """A gravity field that pulls a beam.

    Attributes:
        force: Name of its force element.
        element: The field.
        center: Index in ``System.frames`` of the frame at whose origin its center is.
        data: Its quantities over the parameters: name -> (rows, columns, nodes).
    """

    force: str
    element: Gravitation
    center: int
    data: Mapping[str, tuple[int, int, tuple[int, ...]]]


@dataclass(frozen=True)
class Segment:
    """A beam, or the part of it between two named nodes.

    Attributes:
        name: Of the beam; its segments follow each other from start to end.
        element: Kind of finite element by name.
        inertia: ``"linked"`` (that of the interpolated motion) or ``"lumped"``.
        frame_a, frame_b: Indices in ``System.frames`` of its ends. In the reference configuration
            they lie in the section: origin on the centerline, axes e1, e2, e3.
        data: Section and material over the parameters: name -> (rows, columns, nodes).
            Stiffnesses ``EA GA2 GA3 GJ EI2 EI3`` [N, N m^2] (shear-corrected), inertia per length
            ``rhoA rhoI2 rhoI3`` [kg/m, kg m], ``damping`` [s] (stress of a strain rate = stiffness
            times it), ``strain`` (6, 1): what the beam has without stress beyond the reference
            configuration: twist and two curvatures [1/m], stretch and two shears; loads per
            length: ``dead_force dead_moment`` (3, 1) in ground axes and ``follower_force
            follower_moment`` (3, 1) in axes of the section [N/m, N].
        line: Its nodes in the reference configuration.
        outline: For pictures.
        fields: Gravity fields that pull it.
        variable_loads: Loads per length that time, inputs, states or motion change, as in ``data``
            and beside those; 0 where nothing changes an entry.
    """

    name: str
    element: str
    inertia: str
    frame_a: int
    frame_b: int
    data: Mapping[str, tuple[int, int, tuple[int, ...]]]
    line: Line
    outline: Outline = ROUND
    fields: tuple[GravityOnBeam, ...] = ()
    variable_loads: Mapping[str, tuple[int, int, tuple[int, ...]]] = field(default_factory=dict)


def numbered(data: Mapping[str, tuple[int, int, tuple[int, ...]]]) -> dict[str, int]:
    """Expressions by name; entries of vectors are numbered."""
    values: dict[str, int] = {}
    for name, (_, _, nodes) in data.items():
        names = [f"{name}_{k + 1}" for k in range(len(nodes))]
        values |= dict(zip(names if len(nodes) > 1 else [name], nodes, strict=True))
    return values
