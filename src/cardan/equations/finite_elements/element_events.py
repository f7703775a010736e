"""Events of the force elements of a small system in coordinates of its own places.

What an element reads of the motion of the whole scene is an input here: accelerations ``udot`` and
multipliers ``lam`` of its own rows; behind an event the speeds as ``du``; as ``tau`` how certain
friction is that follows from reactions, then how velocities that it names respond to forces along
them.

Source: F. Pfeiffer and Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapters 5
and 8.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property

from ...elements.forces.force import Places
from ...elements.internal_states import Impulse
from ...ir.arithmetic import Scalar
from ...ir.derivative import forward
from ...ir.function import Output, live, operands
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...schema.finite_elements import JUMP_NUMBERS
from ...topology.system import Force
from ..constraints.constraints import VELOCITY, rows
from ..constraints.reaction_friction import friction_forces
from ..functions.dynamics import Dynamics
from ..kinematics.loads import places
from .joint_friction import JointFriction

# kinds of rows of "impulses" in mesh_jumps.h; the last asks for a response, and pushes nothing
BILATERAL, UNILATERAL, SLOW_RELEASE, RESPONSE = range(4)


class LocalSolution:
    """The part of the solution of the equations of motion that an element may read."""

    def __init__(self, d: Dynamics, force: Force) -> None:
        self._k = d.k
        g, frictions = d.k.graph, friction_forces(d.k.system)
        self.certainty: Scalar | None = None
        if force in frictions:
            self.certainty = Scalar(g, g.var("tau", frictions.index(force)))
        at = [i for i, row in enumerate(rows(d.k.system)) if row.owner == force.name]
        self.multipliers = Matrix(g, len(at), 1, [g.var("lam", i) for i in at])

    def derivative(self, x: Scalar) -> Scalar:
        """Time derivative of an expression along the motion."""
        g, seeds = self._k.graph, dict(self._k.time_seeds)
        for i in range(self._k.system.nu):
            seeds[g.var("u", i)] = g.var("udot", i)
        return Scalar(g, forward(g, [x.node], seeds)[0])


class LocalJump:
    """The events of an element, and the speeds behind all that happen together.

    Args:
        d: Dynamics of the small system.
        force: The element.
        rows: Velocities whose responses are read, by all elements; it adds its own.
    """

    def __init__(self, d: Dynamics, force: Force, rows: list[list[int]]) -> None:
        self._d, self._g, self._force = d, d.k.graph, force
        self._rows = rows

    @cached_property
    def before(self) -> LocalSolution:
        """The solution of the equations of motion before the event."""
        return LocalSolution(self._d, self._force)

    def fired(self, event: int) -> Scalar:
        """1 where this event of the element happened, else 0."""
        return Scalar(self._g, self._g.var("e", self._force.e + event))

    def after(self, x: Scalar) -> Scalar:
        """Value of an expression with the speeds behind the event."""
        g = self._g
        behind = {g.var("u", i): g.var("du", i) for i in range(self._d.k.system.nu)}
        return Scalar(g, rebuild(g, [x.node], behind, into=g)[1][0])

    def response(self, velocity: Scalar) -> Scalar:
        """Acceleration of a velocity per force along it, loops and what others hold included."""
        row = _gradient(self._d, self._force, velocity)
        if row not in self._rows:
            self._rows.append(row)
        first = len(friction_forces(self._d.k.system))
        return Scalar(self._g, self._g.var("tau", first + self._rows.index(row)))


class ElementEvents:
    """Functions of the events of the forces of a small system.

    Args:
        d: Dynamics of the small system.
        friction: Friction of its joint that follows from the reaction.
    """

    def __init__(self, d: Dynamics, friction: JointFriction | None = None) -> None:
        self.d, self.system, self._friction = d, d.k.system, friction
        self.forces = d.k.system.forces
        self._responses: list[list[int]] = []
        self._jumps = [LocalJump(d, force, self._responses) for force in self.forces]

    def _at(self, force: Force) -> Places:
        if self._friction is not None and force.element.by_reaction:
            return self._friction.at(force)
        return places(self.d.k, force)

    def signs(self) -> tuple[Output, ...]:
        """Values of its events, then 1 where they read accelerations or multipliers now."""
        nodes = list[int]()
        for force in self.forces:
            values = force.element.signs(self._at(force), LocalSolution(self.d, force))
            nodes += [value.node for value in values]
        read = _reads_solution(self.d.k.graph, nodes)
        return (Output("signs", (len(nodes),), tuple(nodes)), Output("solved", (1,), (read,)))

    @cached_property
    def change(self) -> tuple[Output, ...]:
        """z and s behind events, of those that are its own."""
        z, s = list[int](), list[int]()
        for force, jump in zip(self.forces, self._jumps, strict=True):
            at = self._at(force)
            change = force.element.change(at, jump)
            z += (at.z if change.z is None else change.z).nodes
            s += (at.s if change.s is None else change.s).nodes
        return (Output("z", (len(z),), tuple(z)), Output("s", (len(s),), tuple(s)))

    @property
    def responses(self) -> int:
        """Number of responses that the change of its states reads."""
        return len(self.change) and len(self._responses)

    def jumps(self) -> tuple[Output, ...]:
        """Its impulses, then the velocities whose responses it reads: numbers, then gradients."""
        numbers, gradients = list[int](), list[int]()
        for force, jump in zip(self.forces, self._jumps, strict=True):
            for impulse in force.element.impulses(self._at(force), jump):
                numbers += self._numbers(impulse)
                gradients += _gradient(self.d, force, impulse.velocity)
        kind = self.d.k.graph.const(float(RESPONSE))
        for row in self._responses[: self.responses]:
            numbers += [kind, ZERO, ZERO, ZERO]
            gradients += row
        count = len(numbers) // JUMP_NUMBERS
        return (
            Output("impulses", (count, JUMP_NUMBERS), tuple(numbers)),
            Output("J", (count, self.system.nu), tuple(gradients)),
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
    at = [i for i, row in enumerate(rows(d.k.system)) if row.switched]
    m = len(rows(d.k.system))
    nodes = [ZERO] * m**2
    for i, one in zip(at, active, strict=True):
        nodes[i * (m + 1)] = (Scalar(d.k.graph, ONE) - one).node
    return (Output("H", (m, m), tuple(nodes)),)


def _reads_solution(g: Graph, nodes: Sequence[int]) -> int:
    """1 where the values of some nodes depend on ``udot`` or ``lam``, by what selections choose."""
    reads: dict[int, int] = {}
    for node in live(g, nodes):
        op, *read = g.nodes[node]
        if op == "var":
            reads[node] = ONE if read[0] in ("udot", "lam", "tau") else ZERO
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


def _gradient(d: Dynamics, force: Force, velocity: Scalar) -> list[int]:
    return d.constraints.gradient(force.name, velocity.node, VELOCITY)
