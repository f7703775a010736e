"""Beams and cables as the user describes them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from ..elements.centerlines import Centerline
from ..elements.forces import cable as pieces
from ..elements.joints.cylindrical import Cylindrical
from ..elements.joints.joint import Joint as JointElement
from ..elements.joints.planar import Planar
from ..elements.joints.prismatic import Prismatic
from ..elements.joints.revolute import Revolute
from ..elements.joints.spherical import Spherical
from ..elements.joints.translation import Translation
from ..elements.joints.universal import Universal
from ..elements.limits import Limit, not_negative
from ..elements.material import Material
from ..elements.quantity import Value
from ..elements.sections import Section
from ..elements.validation import is_expression
from ..errors import ModelError
from ..records import dataclass
from . import checks
from .body import Body
from .frame import Place

if TYPE_CHECKING:
    from .scene import SceneRecord


# what is let go at an end -> the joint that lets it
RELEASED: dict[frozenset[str], JointElement] = {
    **{frozenset({f"r{axis}"}): Revolute(axis) for axis in "xyz"},
    **{frozenset({axis}): Prismatic(axis) for axis in "xyz"},
    **{frozenset({axis, f"r{axis}"}): Cylindrical(axis) for axis in "xyz"},
    frozenset({"rx", "ry"}): Universal("x", "y"),
    frozenset({"ry", "rz"}): Universal("y", "z"),
    frozenset({"rx", "rz"}): Universal("x", "z"),
    frozenset({"x", "y", "rz"}): Planar("z"),
    frozenset({"y", "z", "rx"}): Planar("x"),
    frozenset({"x", "z", "ry"}): Planar("y"),
    frozenset({"rx", "ry", "rz"}): Spherical(),
    frozenset({"x", "y", "z"}): Translation(),
}


# numbers of a cable, and its parameters
UNITS = {"EA": "N", "rhoA": "kg/m", "length": "m", "damping": "s"}
# of a cable with nodes that are free to move
MASSIVE = Limit(
    "rhoA",
    "rhoA is {value}: its nodes have no mass, so that their accelerations are not determined; give "
    "rhoA, or one element between two frames",
    0.0,
    open=True,
)


@dataclass(frozen=True)
class End:
    """An end of a beam.

    Attributes:
        place: The frame (or body) it is joined to; None for a free one.
        point: Where a free end is, in ground axes at the reference configuration (3).
        released: Directions in which it is let go.
    """

    place: Place | None
    point: tuple[Value, Value, Value] | None = None
    released: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False, repr=False)
class Beam:
    """A beam; made by :meth:`Model.beam`.

    Attributes:
        model: The model it belongs to.
        name: Its name.
        ends: Start and end.
        section, material: What it is made of.
        elements: Number of finite elements.
        up: Direction of e3, or None.
        line: Its centerline in the reference configuration.
        element: Kind of finite element.
        inertia: How its mass moves with its nodes.
        temperature: Rise against the reference configuration [K].
        prestrain: What it has without stress beyond the reference configuration, by name.
        base: Body in whose axes points and directions are given, None for the ground.
        stops: Where nodes were asked for by :meth:`at`: name -> place in 0 ... 1.
    """

    model: SceneRecord = field(repr=False)
    name: str
    ends: tuple[End, End]
    section: Section
    material: Material
    elements: int
    up: tuple[Value, ...] | None
    line: Centerline
    element: str
    inertia: str
    temperature: Value
    prestrain: Mapping[str, Value]
    base: Body | None = None
    stops: dict[str, float] = field(default_factory=dict)

    @property
    def start(self) -> Place:
        """The frame it starts from, or its node there; see :meth:`at`."""
        return self.model.nodes[f"{self.name}.start"]

    @property
    def end(self) -> Place:
        """The frame it ends in, or its node there; see :meth:`at`."""
        return self.model.nodes[f"{self.name}.end"]

    def at(self, s: float, *, name: str | None = None) -> Place:
        """A node of the beam, which is a frame: origin on the centerline, axes e1, e2, e3.

        Args:
            s: Place in 0 ... 1 of its arc length, 0 its start and 1 its end. A node is put there.
            name: Under which it is known to ``pose``, ``velocity`` and the like.

        Returns:
            The node; where an end is joined to a frame and not released, that frame.

        Raises:
            ModelError: a number outside 0 ... 1, or a name that is taken.
        """
        where = checks.number(f"beam '{self.name}': at", s)
        if name is not None:
            checks.name("node", name)
        if not 0 <= where <= 1:
            raise ModelError(
                f"beam '{self.name}': at({where:g}) lies outside; s runs from 0 (start) to 1 (end) "
                "of its length"
            )
        end_name = {0.0: "start", 1.0: "end"}.get(where)
        if end_name is not None and name is None:
            return self.start if end_name == "start" else self.end
        if end_name is not None:
            raise ModelError(
                f"beam '{self.name}': at({where:g}) is called '{self.name}.{end_name}'"
            )
        for stop_name, stop in self.stops.items():
            if stop == where and name in (None, stop_name):
                return self.model.nodes[stop_name]
        if name is None:
            count = len(self.stops) + 1
            while f"{self.name}.at{count}" in self.model.nodes:
                count += 1
            name = f"{self.name}.at{count}"
        self.model.new_place("node", name)
        self.stops[name] = where
        self.model.nodes[name] = place = node(self.model, name)
        return place

    def releases(self) -> dict[str, JointElement]:
        """The joints of ends that are not clamped, by name."""
        ends = zip(("start", "end"), self.ends, strict=True)
        return {
            f"{self.name}.{role}": RELEASED[frozenset(end.released)]
            for role, end in ends
            if end.released
        }

    def __repr__(self) -> str:
        return f"Beam({self.name!r}, {self.section.kind}, {self.elements} elements)"


@dataclass(frozen=True, eq=False, repr=False)
class Cable:
    """A cable; made by :meth:`Scene.cable`.

    Attributes:
        model: The model it belongs to.
        name: Its name.
        ends: Start and end.
        EA: Stiffness of the section [N].
        rhoA: Mass per length [kg/m].
        length: Without load [m]; None: it follows from the tension.
        tension: With which it is straight between its ends in the reference configuration [N].
        damping: Tension of a rate of the strain is EA times this time [s].
        elements: Number of straight pieces.
        base: Body in whose axes points are given, None for the ground.
        compression: True for a bar, which pushes too.
    """

    model: SceneRecord = field(repr=False)
    name: str
    ends: tuple[End, End]
    EA: Value
    rhoA: Value
    length: Value | None
    tension: float
    damping: Value
    elements: int
    base: Body | None = None
    compression: bool = False

    @property
    def start(self) -> Place:
        """The frame it starts from, or its free end."""
        return self.model.nodes[f"{self.name}.start"]

    @property
    def end(self) -> Place:
        """The frame it ends in, or its free end."""
        return self.model.nodes[f"{self.name}.end"]

    def at(self, s: float) -> Place:
        """A node of the cable: a point without axes of its own, which keeps those of the ground.

        Args:
            s: Place in 0 ... 1 of its length: a multiple of 1 / elements.

        Raises:
            ModelError: there is no node.
        """
        where = checks.number(f"cable '{self.name}': at", s) * self.elements
        k = round(where)
        if abs(where - k) > 1e-9 or not 0 <= k <= self.elements:
            raise ModelError(
                f"cable '{self.name}': at({s:g}) is not a node; nodes are at multiples of "
                f"1/{self.elements} from 0 to 1. Change elements="
            )
        return self.model.nodes[self.node_name(k)]

    def limits(self) -> tuple[Limit, ...]:
        """Limits of its numbers: those of a piece, and of the mass of its nodes."""
        free = self.elements > 1 or None in (end.place for end in self.ends)
        return (*pieces.LIMITS, *not_negative("rhoA"), *(MASSIVE,) * free)

    def node_name(self, k: int) -> str:
        """Name of the node behind k elements."""
        role = {0: "start", self.elements: "end"}.get(k, f"node{k}")
        return f"{self.name}.{role}"

    def symbol(self, key: str) -> Value:
        """A number of the cable as pieces use it: its parameter ``<name>.<key>``, or as written."""
        value: Value | None = getattr(self, key)
        if value is None or (not is_expression(value) and value != 0):
            from sympy import Symbol

            return Symbol(f"{self.name}.{key}")
        return value

    def node_mass(self, k: int) -> Value:
        """Mass of the node behind k elements [kg]."""
        share = 2 if k in (0, self.elements) else 1
        return self.symbol("rhoA") * self.symbol("length") / (share * self.elements)

    def inner_nodes(self) -> list[str]:
        """Names of the nodes that are bodies of their own: all inside, and free ends."""
        names = [self.node_name(k) for k in range(self.elements + 1)]
        return [name for name in names if self.model.nodes[name].name == name]

    def __repr__(self) -> str:
        return f"Cable({self.name!r}, {self.elements} elements)"


def node(model: SceneRecord, name: str) -> Body:
    """A node of beams: a body without mass, whose place follows from its beam."""
    return Body(model, name, 0, (0, 0, 0), (0,) * 6)
