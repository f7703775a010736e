"""Events of one force element in coordinates of its own places.

What an element reads of the motion of the whole scene is an input here: accelerations ``udot`` and
multipliers ``lam`` of its own rows; behind an event the speeds as ``du``, and as ``tau`` how
velocities that it names respond to forces along them.

Source: F. Pfeiffer and Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapters 5
and 8.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property

from ...elements.internal_states import Impulse
from ...ir.arithmetic import Scalar
from ...ir.derivative import forward
from ...ir.function import Output, live, operands
from ...ir.graph import ONE, ZERO, Graph
from ...ir.rewrite import rebuild
from ..constraints.constraints import VELOCITY
from ..functions.dynamics import Dynamics
from ..kinematics.loads import places

# kinds of rows of "impulses" in mesh_events.c; the last asks for a response, and pushes nothing
BILATERAL, UNILATERAL, SLOW_RELEASE, RESPONSE = range(4)
# numbers of a row: its kind, whether it is active, missing speed, release speed
ROW = 4


class LocalSolution:
    """The part of the solution of the equations of motion that the element may read."""

    def __init__(self, d: Dynamics) -> None:
        self._k = d.k
        self.certainty: Scalar | None = None
        count = sum(len(f.element.locked_velocities()) for f in d.k.system.forces)
        self.multipliers = d.block("lam", count)

    def derivative(self, x: Scalar) -> Scalar:
        """Time derivative of an expression along the motion."""
        g, seeds = self._k.graph, dict(self._k.time_seeds)
        for i in range(self._k.system.nu):
            seeds[g.var("u", i)] = g.var("udot", i)
        return Scalar(g, forward(g, [x.node], seeds)[0])


class LocalJump:
    """The events of the element, and the speeds behind all that happen together."""

    def __init__(self, d: Dynamics) -> None:
        self._d, self._g = d, d.k.graph
        self.rows: list[list[int]] = []

    @cached_property
    def before(self) -> LocalSolution:
        """The solution of the equations of motion before the event."""
        return LocalSolution(self._d)

    def fired(self, event: int) -> Scalar:
        """1 where this event of the element happened, else 0."""
        return Scalar(self._g, self._g.var("e", event))

    def after(self, x: Scalar) -> Scalar:
        """Value of an expression with the speeds behind the event."""
        g = self._g
        behind = {g.var("u", i): g.var("du", i) for i in range(self._d.k.system.nu)}
        return Scalar(g, rebuild(g, [x.node], behind, into=g)[1][0])

    def response(self, velocity: Scalar) -> Scalar:
        """Acceleration of a velocity per force along it, loops and what others hold included."""
        row = _gradient(self._d, velocity)
        if row not in self.rows:
            self.rows.append(row)
        return Scalar(self._g, self._g.var("tau", self.rows.index(row)))


class ElementEvents:
    """Functions of the events of the force of a small system.

    Args:
        d: Dynamics of the small system.
    """

    def __init__(self, d: Dynamics) -> None:
        self.d, self.system = d, d.k.system
        (self.force,) = d.k.system.forces
        self.at = places(d.k, self.force)
        self._jump = LocalJump(d)

    def signs(self) -> tuple[Output, ...]:
        """Values of its events, then 1 where they read accelerations or multipliers now."""
        values = self.force.element.signs(self.at, LocalSolution(self.d))
        nodes = tuple(value.node for value in values)
        read = _reads_solution(self.d.k.graph, nodes)
        return (Output("signs", (len(values),), nodes), Output("solved", (1,), (read,)))

    @cached_property
    def change(self) -> tuple[Output, ...]:
        """z and s behind events, of those that are its own."""
        change = self.force.element.change(self.at, self._jump)
        z = self.at.z if change.z is None else change.z
        s = self.at.s if change.s is None else change.s
        return (Output("z", (z.rows,), z.nodes), Output("s", (s.rows,), s.nodes))

    @property
    def responses(self) -> int:
        """How many responses the change of its states reads."""
        return len(self.change) and len(self._jump.rows)

    def jumps(self) -> tuple[Output, ...]:
        """Its impulses, then the velocities whose responses it reads: numbers, then gradients."""
        impulses = self.force.element.impulses(self.at, self._jump)
        numbers, rows = list[int](), list[int]()
        for impulse in impulses:
            numbers += self._numbers(impulse)
            rows += _gradient(self.d, impulse.velocity)
        kind = self.d.k.graph.const(float(RESPONSE))
        for row in self._jump.rows[: self.responses]:
            numbers += [kind, ZERO, ZERO, ZERO]
            rows += row
        count = len(numbers) // ROW
        return (
            Output("impulses", (count, ROW), tuple(numbers)),
            Output("J", (count, self.system.nu), tuple(rows)),
        )

    def _numbers(self, impulse: Impulse) -> list[int]:
        kind = BILATERAL
        if impulse.unilateral:
            kind = UNILATERAL if impulse.release_speed is None else SLOW_RELEASE
        release = ZERO if impulse.release_speed is None else impulse.release_speed.node
        missing = impulse.velocity - impulse.after
        return [self.d.k.graph.const(float(kind)), impulse.active.node, missing.node, release]


def switches(d: Dynamics) -> tuple[Output, ...]:
    """H (m, m): 1 on the diagonal of rows that no mode holds now, whose multipliers are 0."""
    active = [
        constraint.active
        for force in d.k.system.forces
        if force.element.locked_velocities()
        for constraint in force.element.holds(places(d.k, force))
    ]
    if not active:
        return ()
    m, nodes = len(active), [ZERO] * len(active) ** 2
    for i, one in enumerate(active):
        nodes[i * (m + 1)] = (Scalar(d.k.graph, ONE) - one).node
    return (Output("H", (m, m), tuple(nodes)),)


def _reads_solution(g: Graph, nodes: Sequence[int]) -> int:
    """1 where the values of some nodes depend on ``udot`` or ``lam``, by what selections choose."""
    reads: dict[int, int] = {}
    for node in live(g, nodes):
        op, *read = g.nodes[node]
        if op == "var":
            reads[node] = ONE if read[0] in ("udot", "lam") else ZERO
        elif op == "select" and reads[read[0]] == ZERO:
            reads[node] = g.apply("select", read[0], reads[read[1]], reads[read[2]])
        else:
            reads[node] = _any(g, [reads[operand] for operand in operands(g.nodes[node])])
    return _any(g, [reads[node] for node in nodes])


def _any(g: Graph, flags: Iterable[int]) -> int:
    """1 where one of the flags is, else 0."""
    total = ZERO
    for flag in dict.fromkeys(flags):
        total = g.apply("select", flag, ONE, total)
    return total


def _gradient(d: Dynamics, velocity: Scalar) -> list[int]:
    (force,) = d.k.system.forces
    return d.constraints.gradient(force.name, velocity.node, VELOCITY)
