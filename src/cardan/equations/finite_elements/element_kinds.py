"""Kinds of elements: pieces that differ in their data only, and the functions they share."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import Any

from ...elements.formulas import RIGID, Lines
from ...ir.arithmetic import Scalar
from ...ir.derivative import directional
from ...ir.function import Block, Function, Output
from ...ir.graph import ONE, ZERO
from ...ir.matrix import Matrix
from ...schema.blocks import ABI_ORDER
from ...topology.system import System
from ..constraints.constraints import VELOCITY, rows
from ..constraints.loop_loads import with_closing
from ..functions import event_functions, outputs, residuals
from ..functions.blocks import blocks
from ..functions.context import Context
from ..functions.dynamics import Dynamics
from ..functions.element_forces import force_of
from ..functions.functions import WRENCH
from ..kinematics.accelerations import Accelerations
from ..kinematics.joint_forces import driving_force, joint_forces
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads
from ..kinematics.loads import places as force_places
from .element_events import ElementEvents, switches
from .joint_constraints import JointConstraint, increments
from .joint_formulas import joint_lines
from .parts import Part
from .record import BlockKind, Kind

METHOD = "composite"
MOTION = 24  # numbers of the motion of a body
# functions that stay where they are zero throughout
ALWAYS = ("outputs", "signs", "jumps", "change")
ABOUT = {
    "balance": "M udot + h - f - Gᵀ lam, then g and G u + g_t",
    "balance_tangent": "derivatives of the balance along q, u, udot, of the rates along q, and G",
    "gamma": "G udot = gamma",
    "energy": "kinetic and potential energy",
    "momentum": "angular (about the ground origin) and linear momentum",
    "power": "power of what has no potential",
    "zdot": "rates of internal states",
    "reaction": "wrench of parent on child at the child joint frame, in its axes",
    "outputs": "contributions to outputs",
    "bodies": "of bodies of a rigid tree R (9), p (3), velocity (6), acceleration (6), ground axes",
    "reactions": "shares of the wrenches of joints that carry it, parent on child at its frame",
    "signs": "values of its events, which happen where they fall through zero",
    "jumps": "impulses at events, and velocities whose responses are asked for",
    "change": "internal states and modes behind events",
    "element_forces": "force along a line or a joint, or force and moment on a frame",
}


def kind_of(name: str, part: Part, places: tuple[BlockKind, ...]) -> Kind:
    """The kind of a piece.

    Args:
        name: Of the kind.
        part: Any of its members.
        places: What its places hold.
    """
    context = _context(part)
    builder = _Builder(context, part)
    functions = builder.functions()
    listed = blocks(part.system)
    listed["z"] = _states("z", len(part.cutting.z))
    listed["s"] = _states("s", len(part.cutting.s))
    if builder.events is not None:
        listed["tau"] = _states("tau", builder.events.responses)
    inputs = tuple(listed[letter] for letter in ABI_ORDER)
    return Kind(
        name=name,
        blocks=places,
        rows=tuple((_suffix(row.name), row.unit) for row in rows(part.system)),
        mp=sum(row.level != VELOCITY for row in rows(part.system)),
        data=listed["p"].entries,
        functions={
            function: Function(
                f"{name}__{function}",
                context.k.graph,
                inputs,
                results,
                tuple(_owners(part.system)),
                ABOUT[function],
            )
            for function, results in functions.items()
        },
        source=part.source,
        formulas=_lines(part, context.k),
        element=part.kind,
        part=_family(part),
    )


def _family(part: Part) -> str:
    """Body, joint or force; "" for relations and outputs."""
    if part.joint:
        return "joint"
    return "body" if part.rigid else "force" * bool(part.system.forces)


def _lines(part: Part, k: Kinematics) -> Lines:
    """Formulas for readers."""
    if part.joint:
        return joint_lines(k)
    if part.system.forces:
        (force,) = part.system.forces
        return force.element.formulas(force_places(k, force))
    return RIGID if part.rigid else ()


def _suffix(name: str) -> str:
    """Name of a row behind that of its member."""
    return name.partition(".")[2]


def _states(letter: str, count: int) -> Block:
    names = tuple(f"{letter}{k + 1}" for k in range(count))
    return Block(letter, names, ("",) * count)


def _owners(system: System) -> Iterable[str]:
    names = [body.name for body in system.bodies]
    names += [joint.name for joint in system.joints]
    names += [force.name for force in system.forces]
    names += [entry.name for entry in system.constraints]
    return dict.fromkeys(names)


def _context(part: Part) -> Context:
    listed = blocks(part.system).values()
    names = {block.name: block.entries for block in listed}
    units = {block.name: block.units for block in listed}
    return Context(Dynamics(Kinematics(part.system), METHOD), names, units)


class _Builder:
    """Results of the functions of one kind."""

    def __init__(self, context: Context, part: Part) -> None:
        self.c, self.part, self.system = context, part, part.system
        self.k, self.d = context.k, context.d

    def functions(self) -> dict[str, tuple[Output, ...]]:
        """Functions that are not zero throughout; outputs and events are kept in any case."""
        outputs = {
            "balance": self._balance(),
            "balance_tangent": self._tangent(),
            "gamma": self._gamma(),
            "energy": self._energy(),
            "momentum": self._momentum(),
            "power": self._power(),
            "zdot": self._zdot(),
            "reaction": self._reaction(),
            "outputs": self._outputs(),
            "element_forces": self._element_forces(),
            "bodies": self._bodies(),
            "reactions": self._reactions(),
            **self._events(),
        }
        return {
            name: results
            for name, results in outputs.items()
            if any(node != ZERO or name in ALWAYS for o in results for node in o.nodes)
        }

    def _vector(self, name: str, x: Matrix, entries: tuple[str, ...] = ()) -> Output:
        return Output(name, (x.rows,), x.nodes, entries)

    def _balance(self) -> tuple[Output, ...]:
        if self.part.joint:
            constraint = self.constraint
            return (
                *self.c.vector(
                    "balance", constraint.settled(-constraint.forces(self._lam())), "tau"
                ),
                self._vector("g", constraint.settled(constraint.position)),
                self._vector("rates", constraint.settled(constraint.rates)),
            )
        return residuals.balance(self.c) if self.system.nu or self.system.closed else ()

    def _tangent(self) -> tuple[Output, ...]:
        if not self.system.nu:
            return ()
        if self.part.joint:
            outputs = self._constraint_tangent()
        elif self.system.closed:
            outputs = (*residuals.balance_tangent(self.c), *switches(self.d))
        else:
            outputs = self._free_tangent()
        return tuple(output for output in outputs if any(node != ZERO for node in output.nodes))

    def _free_tangent(self) -> tuple[Output, ...]:
        """K, C and M of what binds nothing."""
        g, nu = self.k.graph, self.system.nu
        b = self.d.inverse(self.c.udot)
        slots = [{g.var("u", n): ONE} for n in range(nu)]
        K, C = (directional(g, b.nodes, along) for along in (increments(self.k), slots))
        return (
            Output("K", (nu, nu), tuple(column[i] for i in range(nu) for column in K)),
            Output("C", (nu, nu), tuple(column[i] for i in range(nu) for column in C)),
            Output("M", (nu, nu), self.d.mass_matrix.nodes),
        )

    def _constraint_tangent(self) -> tuple[Output, ...]:
        """K, R and G of a joint: it has no mass, and what it holds no damping."""
        constraint, nu = self.constraint, self.system.nu
        m = constraint.rates.rows
        K = constraint.settled(constraint.along(-constraint.forces(self._lam())))
        R = constraint.settled(constraint.along(constraint.rates))
        return (
            Output("K", (nu, nu), K.nodes),
            Output("R", (m, nu), R.nodes),
            Output("G", (m, nu), constraint.settled(constraint.jacobian).nodes),
        )

    def _gamma(self) -> tuple[Output, ...]:
        if self.part.joint:
            return (self._vector("gamma", self.constraint.settled(self.constraint.gamma)),)
        return (self._vector("gamma", self.d.constraints.gamma),) if self.system.closed else ()

    def _energy(self) -> tuple[Output, ...]:
        pair = zip(("kinetic", "potential"), outputs.energy(self.d), strict=True)
        return tuple(Output(name, (), (value.node,), (name,), ("J",)) for name, value in pair)

    def _momentum(self) -> tuple[Output, ...]:
        return (self._vector("momentum", outputs.momentum(self.k)),)

    def _zdot(self) -> tuple[Output, ...]:
        return (self._vector("zdot", event_functions.rates(self.d)),)

    @cached_property
    def events(self) -> ElementEvents | None:
        """Events of the force that it is; None without."""
        forces = self.system.forces
        having = forces and (forces[0].element.events() or forces[0].element.modes())
        return ElementEvents(self.d) if having else None

    def _events(self) -> dict[str, tuple[Output, ...]]:
        if self.events is None:
            return {}
        change = self.events.change
        return {"signs": self.events.signs(), "jumps": self.events.jumps(), "change": change}

    def _lam(self) -> Matrix:
        return self.d.block("lam", len(rows(self.system)))

    @cached_property
    def constraint(self) -> JointConstraint:
        """The constraint of the joint."""
        return JointConstraint(self.k)

    def _reaction(self) -> tuple[Output, ...]:
        if not self.part.joint:
            return ()
        wrench, reversed_joint = (
            self.constraint.transmitted(self._lam()).wrench,
            self.part.reversed_joint,
        )
        if reversed_joint >= 0:
            wrench = outputs.on_declared_child(self.k, reversed_joint, wrench)
        return (Output("reaction", (6,), wrench.nodes, *WRENCH),)

    @cached_property
    def _accelerations(self) -> Accelerations:
        return outputs.system_accelerations(self.d, self.c.udot)

    def _bodies(self) -> tuple[Output, ...]:
        """Motion of the bodies of a rigid tree, in the order of the tree."""
        if not self.part.tree:
            return ()
        nodes = list[int]()
        for number in self.part.cutting.moved.values():
            frame = self.system.joints[number].child_frame
            nodes += [*self.k.rotation(frame).nodes, *self.k.position(frame).nodes]
            nodes += outputs.velocity(self.k, frame).nodes
            nodes += outputs.acceleration(self.d, self._accelerations, frame).nodes
        return (Output("bodies", (len(nodes) // MOTION, MOTION), tuple(nodes)),)

    def _reactions(self) -> tuple[Output, ...]:
        """What joints of rigid trees transmit on account of this element."""
        moved, nodes = self.part.cutting.moved, list[int]()
        if not moved or not (self.part.tree or self.part.joint or self.system.forces):
            return ()
        forces = joint_forces(self.k, self._accelerations, self._loads)
        for i, number in moved.items():
            wrench = Matrix.vstack(forces.moment[number], forces.force[number])
            if self.part.cutting.system.joints[i].reversed:
                wrench = outputs.on_declared_child(self.k, number, wrench)
            nodes += wrench.nodes
        return (Output("reactions", (len(moved), 6), tuple(nodes)),)

    @cached_property
    def _loads(self) -> Loads:
        """Loads with the wrench of the joint that the element is made of."""
        closings = [self.constraint.transmitted(self._lam())] if self.part.joint else []
        return with_closing(self.k, self.d.loads, closings)

    def _driving(self) -> list[tuple[int, Any]]:
        """(joint, force along it) of prescribed joints, as far as this element needs it."""
        if not self.part.driven:
            return []
        d = self.d
        forces = joint_forces(self.k, self._accelerations, self._loads)
        still = Matrix.zeros(self.k.graph, 1)
        return [(i, driving_force(self.k, i, forces, d.loads, still)[0]) for i in self.part.driven]

    def _outputs(self) -> tuple[Output, ...]:
        d = self.d
        if any(atom.quantity == "acceleration" for atom in self.system.atoms.values()):
            acc = self._accelerations
            self.k.acceleration = lambda frame: outputs.acceleration(d, acc, frame)
        nodes = list(self.k.resolve([entry.node for entry in self.system.outputs]))
        nodes += [force.node for _, force in self._driving()]
        return (Output("outputs", (len(nodes),), tuple(nodes)),)

    def _element_forces(self) -> tuple[Output, ...]:
        if not self.part.force:
            return ()
        (force,) = self.system.forces
        return (self._vector("element_forces", force_of(self.k, force)),)

    def _power(self) -> tuple[Output, ...]:
        nodes: list[int] = []
        if self.system.forces:
            power = sum((x for _, x in self.d.loads.power), self._zero())
            nodes.append((power + self._surface_power()).node)
        nodes += [(force * self.k.u(i)[0]).node for i, force in self._driving()]
        if self.system.constraints:
            (rate,), (lam,) = self.d.constraints.prescribed, self._lam()
            nodes.append((-lam * rate).node)
        return (Output("power", (len(nodes),), tuple(nodes)),)

    def _surface_power(self) -> Scalar:
        """Power of what the element holds on surfaces that move by themselves."""
        if not any(force.element.locked_velocities() for force in self.system.forces):
            return self._zero()
        lam, surfaces = self._lam(), self.d.constraints.surfaces
        return sum((-lam[row] * rate for row, rate in surfaces), self._zero())

    def _zero(self) -> Scalar:
        return Matrix.zeros(self.k.graph, 1)[0]
