"""Kinds of elements: pieces that differ in their data only, and the functions they share."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import cached_property
from itertools import compress
from typing import Any

from ...elements.formulas import RIGID, RIGID_SHAPES, Lines, Shapes
from ...ir.arithmetic import Scalar
from ...ir.derivative import directional
from ...ir.function import Block, Function, Output
from ...ir.graph import ONE, ZERO
from ...ir.matrix import Matrix
from ...schema.blocks import ABI_ORDER
from ...schema.finite_elements import MOTION_NUMBERS
from ...topology.system import Force, System
from ..constraints.constraints import VELOCITY, rows
from ..constraints.driven_rows import working
from ..constraints.loop_loads import with_closing
from ..constraints.reaction_friction import friction_forces
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
from ..kinematics.partial_velocities import strain_of
from .element_events import ElementEvents, switches
from .joint_constraints import JointConstraint, increments
from .joint_formulas import joint_lines
from .joint_friction import JointFriction
from .parts import Part
from .record import ALWAYS, BlockKind, Kind

METHOD = "composite"
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
    "reaction_friction": "friction per force of the reaction, its action, force by multipliers",
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
        frictions = len(friction_forces(part.system))
        listed["tau"] = _states("tau", frictions + builder.events.responses)
    inputs = tuple(listed[letter] for letter in ABI_ORDER)
    return Kind(
        name=name,
        blocks=places,
        rows=part.rows,
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
        symbol_shapes=_symbol_shapes(part),
        element=part.kind,
        part=part.family,
        switched=sum(row.switched for row in rows(part.system)),
        strain=strain_of(context.k),
    )


def _lines(part: Part, k: Kinematics) -> Lines:
    """Formulas for readers."""
    if part.joint:
        return joint_lines(k)
    if part.system.forces:
        (force,) = part.system.forces
        return force.element.formulas(force_places(k, force))
    return RIGID if part.rigid else ()


def _symbol_shapes(part: Part) -> Shapes:
    """Shapes of what these formulas read."""
    if part.system.forces and not part.joint:
        return part.system.forces[0].element.symbol_shapes
    return RIGID_SHAPES if part.rigid else {}


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
        if self.friction:
            outputs |= {"reaction_friction": self.friction.outputs()}
            outputs = {name: self._with_friction(results) for name, results in outputs.items()}
        return {
            name: results
            for name, results in outputs.items()
            if any(node != ZERO or name in ALWAYS for o in results for node in o.nodes)
        }

    @cached_property
    def friction(self) -> JointFriction | None:
        """Friction that follows from the reaction of the joint that it is."""
        return JointFriction(self.d, self.constraint) if friction_forces(self.system) else None

    def _with_friction(self, results: Iterable[Output]) -> tuple[Output, ...]:
        """Results with the friction that multipliers tell in place of what stands for it."""
        assert self.friction is not None
        outputs = list[Output]()
        for output in results:
            column = Matrix(self.k.graph, len(output.nodes), 1, output.nodes)
            outputs.append(replace(output, nodes=self.friction.settled(column).nodes))
        return tuple(outputs)

    def _vector(self, name: str, x: Matrix, entries: tuple[str, ...] = ()) -> Output:
        return Output(name, (x.rows,), x.nodes, entries)

    def _balance(self) -> tuple[Output, ...]:
        if self.part.joint:
            constraint = self.constraint
            return (
                *self.c.vector("balance", constraint.settled(self._joint_balance()), "tau"),
                self._vector("g", constraint.settled(constraint.position)),
                self._vector("rates", constraint.settled(self._joint_rates())),
            )
        return residuals.balance(self.c) if self.system.nu or self.system.closed else ()

    def _joint_balance(self) -> Matrix:
        """Share of a joint, with friction in it, in the balance (nu, 1), by leaves of the joint."""
        constraint = self.constraint
        lam = self._lam().block(slice(0, constraint.rates.rows))
        balance = -constraint.forces(lam)
        return balance if self.friction is None else balance + self.friction.balance

    def _joint_rates(self) -> Matrix:
        """Rates of all rows of a joint, likewise."""
        rates = self.constraint.rates
        return rates if self.friction is None else Matrix.vstack(rates, self.friction.rates)

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
        """K, R and G of a joint: it has no mass, and what it holds no damping; C and L with
        friction."""
        constraint, friction, nu = self.constraint, self.friction, self.system.nu
        along = constraint.along if friction is None else friction.along
        balance, rates, G = self._joint_balance(), self._joint_rates(), constraint.jacobian
        matrices = {"K": along(balance)}
        if friction is not None:
            matrices["C"] = friction.by_speeds(balance)
            G = Matrix.vstack(G, friction.locked)
        matrices |= {"R": along(rates), "G": G}
        outputs = tuple(
            Output(name, (x.rows, nu), constraint.settled(x).nodes) for name, x in matrices.items()
        )
        if friction is None:
            return outputs
        L = constraint.settled(G - friction.by_multipliers)
        return (*outputs, *switches(self.d), Output("L", (L.rows, nu), L.nodes))

    def _gamma(self) -> tuple[Output, ...]:
        if self.part.joint:
            gamma = self.constraint.gamma
            if self.friction is not None:
                gamma = Matrix.vstack(gamma, self.friction.gamma)
            return (self._vector("gamma", self.constraint.settled(gamma)),)
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
        """Events of its forces; None without."""
        elements = [force.element for force in self.system.forces]
        having = any(element.events() or element.modes() for element in elements)
        return ElementEvents(self.d, self.friction) if having else None

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
        return (Output("bodies", (len(nodes) // MOTION_NUMBERS, MOTION_NUMBERS), tuple(nodes)),)

    def _reactions(self) -> tuple[Output, ...]:
        """What joints of rigid trees transmit on account of this element."""
        moved = self.part.cutting.moved
        if not moved or not (self.part.tree or self.part.joint or self.system.forces):
            return ()
        forces = joint_forces(self.k, self._accelerations, self._loads)
        wrenches = self.part.cutting.joint_wrenches(self.k, forces)
        return (Output("reactions", (len(moved), 6), wrenches),)

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
        still, lam = Matrix.zeros(self.k.graph, 1), self._lam()
        return [
            (i, driving_force(self.k, i, forces, d.loads, still)[0] - d.driven_rows.along(i, lam))
            for i in self.part.driven
        ]

    def _ratio(self, i: int) -> Scalar:
        """Rate of a prescribed joint per rate of the joint that is driven, which it may follow."""
        motion = self.system.joints[i].motion
        assert motion is not None
        return Scalar(self.k.graph, self.k.resolve([motion.ratio])[0])

    def _outputs(self) -> tuple[Output, ...]:
        d = self.d
        if any(atom.quantity == "acceleration" for atom in self.system.atoms.values()):
            acc = self._accelerations
            self.k.acceleration = lambda frame: outputs.acceleration(d, acc, frame)
        nodes = list(self.k.resolve([entry.node for entry in self.system.outputs]))
        nodes += [(force * self._ratio(i)).node for i, force in self._driving()]
        return (Output("outputs", (len(nodes),), tuple(nodes)),)

    def _element_forces(self) -> tuple[Output, ...]:
        if not self.part.forces:
            return ()
        parts = [force_of(self.k, f, self._locking(f)) for f in self.system.forces]
        return (self._vector("element_forces", Matrix.vstack(*parts)),)

    def _locking(self, force: Force) -> Matrix | None:
        """Multipliers of what an element holds in some modes; None where it holds nothing."""
        at = [i for i, row in enumerate(rows(self.system)) if row.owner == force.name]
        if not force.element.locked_velocities():
            return None
        return Matrix.vector(self.k.graph, [self._lam()[i] for i in at])

    def _power(self) -> tuple[Output, ...]:
        nodes: list[int] = []
        powers = dict(self.d.loads.power)
        for force in self.system.forces:
            power = powers.get(force.name, self._zero())
            nodes.append((power + self._timed_power(force.name)).node)
        for entry in compress(self.system.constraints, working(self.system)):
            nodes.append(self._timed_power(entry.name).node)
        nodes += [(force * self.k.u(i)[0]).node for i, force in self._driving()]
        return (Output("power", (len(nodes),), tuple(nodes)),)

    def _timed_power(self, owner: str) -> Scalar:
        """Power of what holds against something that moves by itself."""
        at = [i for i, row in enumerate(rows(self.system)) if row.owner == owner]
        return self.d.driven_rows.power(at, self._lam())

    def _zero(self) -> Scalar:
        return Matrix.zeros(self.k.graph, 1)[0]
