"""Base parameters: inertia that moves as if it were the parent's is given to the parent.

Mass on the axis of a revolute joint does not feel the joint: whether it belongs to the body
outboard or inboard, the equations of motion are the same. Such parts go inward, body by body, and
what reaches the ground is dropped. What is left are the combinations that motion depends on, some
of them zero; as bodies they need not be possible (the mass of an arm's hand is 0). M, tau, udot and
kinetic energy stay; reactions, momentum and center of mass belong to the original.

A part of an inertia I can go if the motion S of the joint carries no momentum of it, I S = 0, and
does not change it, S x* I = I S x.

Source: Gautier and Khalil, Direct Calculation of Minimum Set of Inertial Parameters of Serial
Robots, IEEE Trans. Robotics and Automation 6 (1990); here by the invariance, for every joint.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from typing import TypeAlias

from ...ir.arithmetic import Scalar
from ...ir.graph import ZERO, Graph
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.moments import Inertia, moved, moved_second, second_moment, turn_symmetric
from ..system import Body, Joint, System

Row: TypeAlias = tuple[Fraction, ...]
# motions that span those of a joint, in body axes
Modes: TypeAlias = tuple[tuple[float, ...], ...]
# the ten numbers of an inertia: m, m c, then the tensor or the second moment
ENTRIES = ("m", "hx", "hy", "hz", "xx", "yy", "zz", "xy", "xz", "yz")
DIAGONAL = slice(4, 7)
CELLS = tuple(i + j for i in "xyz" for j in "xyz")


@dataclass(frozen=True)
class Direction:
    """A part that can go inward.

    Attributes:
        pivot: Entry that becomes zero in the body.
        parts: (entry, multiple of what the pivot loses) of all entries that change.
    """

    pivot: int
    parts: tuple[tuple[int, Fraction], ...]


@dataclass(frozen=True)
class Ten:
    """The ten numbers of a body.

    Attributes:
        mass: m.
        moment: m c (3, 1).
        tensor: Inertia or second moment about the origin (3, 3).
        second: Which of the two it is.
    """

    mass: Scalar
    moment: Matrix
    tensor: Matrix
    second: bool

    @property
    def entries(self) -> tuple[int, ...]:
        """Nodes in the order of ``ENTRIES``."""
        x = self.tensor.nodes
        return (self.mass.node, *self.moment.nodes, x[0], x[4], x[8], x[1], x[2], x[5])

    def like(self, entries: Sequence[int]) -> Ten:
        """Another one of the same form."""
        g = self.tensor.graph
        m, hx, hy, hz, xx, yy, zz, xy, xz, yz = entries
        tensor = Matrix(g, 3, 3, (xx, xy, xz, xy, yy, yz, xz, yz, zz))
        return Ten(Scalar(g, m), Matrix(g, 3, 1, (hx, hy, hz)), tensor, self.second)

    def inward(self, rotation: Matrix, at: Matrix) -> Ten:
        """The same in axes turned by ``rotation`` and about a point that sees its origin at p."""
        moment, tensor = rotation @ self.moment, turn_symmetric(rotation, self.tensor)
        if self.second:
            tensor = moved_second(self.mass, moment, tensor, at)
        else:
            tensor = moved(Inertia(self.mass, moment, tensor), at).tensor
        word = "second" if self.second else "inertia"
        return Ten(
            self.mass, (moment + at * self.mass).note("moment"), tensor.note(word), self.second
        )

    def __add__(self, other: Ten) -> Ten:
        mass, moment = self.mass + other.mass, self.moment + other.moment
        return Ten(mass, moment, self.tensor + other.tensor, self.second)


def base_parameters(system: System) -> System:
    """The system with inertias regrouped.

    What goes inward leaves a zero in the inertia tensor, which composite and articulated bodies
    read, or in the second moment, which the recursion of forces reads; each body gets both.
    """
    if any(body.second_moment is not None for body in system.bodies):
        return system
    graph = system.graph.fork()
    scratch = graph.fork()
    modes = [_modes(scratch, joint) for joint in system.joints]
    forms = [_regrouped(graph, system, modes, second) for second in (False, True)]
    bodies = [
        _with(body, *both)
        for body, both in zip(system.bodies, zip(*forms, strict=True), strict=True)
    ]
    return replace(system, graph=graph, bodies=tuple(bodies))


def _regrouped(graph: Graph, system: System, modes: Sequence[Modes], second: bool) -> list[Ten]:
    """The ten numbers of every body after all that can go inward went."""
    tens = [_of_body(graph, body, second) for body in system.bodies]
    for i in range(len(tens) - 1, -1, -1):
        body, joint = system.bodies[i], system.joints[i]
        with graph.made_by(body.name, "base"):
            tens[i], gone = _split(tens[i], _directions(modes[i], second))
            if body.parent >= 0:
                rotation, at = Matrix(graph, 3, 3, joint.rotation), joint.position
                inward = gone.inward(rotation, Matrix(graph, 3, 1, at))
                tens[body.parent] = tens[body.parent] + inward
    return tens


def _of_body(graph: Graph, body: Body, second: bool) -> Ten:
    tensor = Matrix(graph, 3, 3, body.inertia)
    if second:
        with graph.made_by(body.name, "base"):
            tensor = second_moment(tensor)
    return Ten(Scalar(graph, body.mass), Matrix(graph, 3, 1, body.first_moment), tensor, second)


def _with(body: Body, first: Ten, second: Ten) -> Body:
    """The body with regrouped numbers, which are called what they are.

    ``base = inertia + what the joints outboard do not feel of theirs - what its own does not``.
    """
    name = body.name
    first.tensor.graph.describe(_with)
    first.tensor.graph.label(first.mass.node, name, "base_mass")
    first.moment.label(name, "base_moment")
    first.tensor.label(name, "base_inertia", CELLS)
    second.tensor.label(name, "base_second_moment", CELLS)
    return replace(
        body,
        mass=first.mass.node,
        first_moment=first.moment.nodes,
        inertia=first.tensor.nodes,
        second_moment=second.tensor.nodes,
    )


def _modes(graph: Graph, joint: Joint) -> Modes:
    """Numbers that span the motions of a joint in body axes: S, or unit motions that contain it."""
    element = joint.element
    slots = [graph.var("q", k) for k in range(len(element.coordinates))]
    q = Matrix(graph, len(slots), 1, slots)
    data = {name: Matrix(graph, *entry) for name, entry in joint.data.items()}
    s = element.motion(q, **data)
    modes: dict[tuple[float, ...], None] = {}
    for j in range(s.columns):
        values = [graph.value(node) for node in s.column(j).nodes]
        if None not in values:
            modes[tuple(v for v in values if v is not None)] = None
        else:
            for k, value in enumerate(values):
                if value != 0.0:
                    modes[tuple(float(k == row) for row in range(6))] = None
    return tuple(modes)


def _split(ten: Ten, directions: tuple[Direction, ...]) -> tuple[Ten, Ten]:
    """Split the inertia into the part that stays with a body, and the part that goes inward."""
    graph, entries = ten.tensor.graph, ten.entries
    remaining, gone = list(entries), [ZERO] * len(entries)
    for direction in directions:
        amount = entries[direction.pivot]
        for entry, multiple in direction.parts:
            part = graph.mul(graph.const(float(multiple)), amount)
            gone[entry] = graph.add(gone[entry], part)
            remaining[entry] = graph.sub(remaining[entry], part)
    return ten.like(remaining), ten.like(gone)


@lru_cache(maxsize=256)
def _directions(modes: Modes, second: bool) -> tuple[Direction, ...]:
    """The parts of an inertia that motions along ``modes`` do not feel, in reduced form."""
    basis = [_spatial(entry, second) for entry in range(len(ENTRIES))]
    conditions: list[Row] = []
    for mode in modes:
        columns = [_unfelt(inertia, tuple(map(Fraction, mode))) for inertia in basis]
        conditions += zip(*columns, strict=True)
    directions = _reduced(_null_space(conditions))
    return tuple(
        Direction(
            next(k for k, x in enumerate(row) if x), tuple((k, x) for k, x in enumerate(row) if x)
        )
        for row in directions
    )


def _spatial(entry: int, second: bool) -> list[list[Fraction]]:
    """The 6 x 6 inertia of a unit of one of the ten numbers."""
    ten = [Fraction(k == entry) for k in range(len(ENTRIES))]
    mass, (x, y, z), diagonal, (xy, xz, yz) = ten[0], ten[1:4], ten[DIAGONAL], ten[7:]
    if second:
        total = sum(diagonal, Fraction(0))
        diagonal = [total - d for d in diagonal]
        xy, xz, yz = -xy, -xz, -yz
    n = Fraction(0)
    return [
        [diagonal[0], xy, xz, n, -z, y],
        [xy, diagonal[1], yz, z, n, -x],
        [xz, yz, diagonal[2], -y, x, n],
        [n, z, -y, mass, n, n],
        [-z, n, x, n, mass, n],
        [y, -x, n, n, n, mass],
    ]


def _unfelt(inertia: list[list[Fraction]], mode: Row) -> list[Fraction]:
    """Numbers that vanish where a motion carries no momentum of an inertia and keeps it."""
    (wx, wy, wz, vx, vy, vz), n = mode, Fraction(0)
    # d/dt of a motion along the mode: crm; of a force: crf = -crmᵀ
    crm = [
        [n, -wz, wy, n, n, n],
        [wz, n, -wx, n, n, n],
        [-wy, wx, n, n, n, n],
        [n, -vz, vy, n, -wz, wy],
        [vz, n, -vx, wz, n, -wx],
        [-vy, vx, n, -wy, wx, n],
    ]
    momentum = [_inner(row, mode) for row in inertia]
    columns = [*zip(*crm, strict=True)]
    # of symmetric matrices rows are columns
    change = [
        -_inner(columns[i], inertia[j]) - _inner(inertia[i], columns[j])
        for i in range(6)
        for j in range(6)
    ]
    return momentum + change


def _inner(a: Sequence[Fraction], b: Sequence[Fraction]) -> Fraction:
    """Inner product; most entries are 0, and exact products are slow."""
    return sum((x * y for x, y in zip(a, b, strict=True) if x and y), Fraction(0))


def _null_space(conditions: list[Row]) -> list[Row]:
    """Vectors that all conditions make zero."""
    rows, size = _reduced(conditions), len(ENTRIES)
    pivots = [next(k for k, x in enumerate(row) if x) for row in rows]
    vectors = []
    for free in (k for k in range(size) if k not in pivots):
        vector = [Fraction(k == free) for k in range(size)]
        for pivot, row in zip(pivots, rows, strict=True):
            vector[pivot] = -row[free]
        vectors.append(tuple(vector))
    return vectors


def _reduced(rows: list[Row]) -> list[Row]:
    """Reduced echelon form: every row has a leading 1 where no other row has anything."""
    left, done = [list(row) for row in rows], list[list[Fraction]]()
    for k in range(len(ENTRIES)):
        pivot = next((row for row in left if row[k]), None)
        if pivot is None:
            continue
        left.remove(pivot)
        pivot = [x / pivot[k] for x in pivot]
        for rows_there in (left, done):
            for n, row in enumerate(rows_there):
                if row[k]:
                    rows_there[n] = [x - row[k] * y for x, y in zip(row, pivot, strict=True)]
        done.append(pivot)
    return [tuple(row) for row in done]
