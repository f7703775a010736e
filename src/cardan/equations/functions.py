"""The functions of a system by their public names, each derived from scratch when asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..errors import DerivationError, near
from ..ir.arithmetic import Scalar
from ..ir.function import Output
from ..ir.graph import ZERO
from ..ir.matrix import Matrix
from ..topology.system import System
from . import increments, outputs
from .blocks import entries
from .constraints import VELOCITY
from .dynamics import Dynamics
from .kinematics import Kinematics


@dataclass(frozen=True)
class Context:
    """What a builder works with.

    Attributes:
        d: The dynamics, underived.
        names, units: Of the entries of every input block, and of ``qdot``.
        of: The frame or joint asked for.
    """

    d: Dynamics
    names: dict[str, tuple[str, ...]]
    units: dict[str, tuple[str, ...]]
    of: str | None = None

    @property
    def k(self) -> Kinematics:
        return self.d.k

    @property
    def udot(self) -> Matrix:
        """The block udot as a vector."""
        return self.d.block("udot", self.k.system.nu)

    @property
    def frame(self) -> int:
        return frame_number(self.k.system, self.of or "")

    def vector(self, name: str, x: Matrix, like: str) -> tuple[Output, ...]:
        """A result with the names and units of an input block."""
        return (Output(name, (x.rows,), x.nodes, self.names[like], self.units[like]),)


Builder = Callable[[Context], tuple[Output, ...]]

TWIST = (("wx", "wy", "wz", "vx", "vy", "vz"), ("rad/s",) * 3 + ("m/s",) * 3)
WRENCH = (("mx", "my", "mz", "fx", "fy", "fz"), ("N*m",) * 3 + ("N",) * 3)
XYZ = ("x", "y", "z")


def frame_number(system: System, name: str) -> int:
    """Index of a frame by its name.

    Raises:
        DerivationError: no such frame.
    """
    for i, frame in enumerate(system.frames):
        if frame.name == name:
            return i
    names = [f.name for f in system.frames]
    raise DerivationError(f"frame '{name}' does not exist.{near(name, names)}")


def _rhs(c: Context) -> tuple[Output, ...]:
    rest = Matrix.zeros(c.k.graph, c.k.system.nu)
    return c.vector("qdot", c.k.rates, "qdot") + c.vector("udot", c.d.forward(rest), "udot")


def _forward(c: Context) -> tuple[Output, ...]:
    return c.vector("udot", c.d.forward(c.d.tau), "udot")


def _inverse(c: Context) -> tuple[Output, ...]:
    return c.vector("tau", c.d.inverse(c.udot), "tau")


def _mass_matrix(c: Context) -> tuple[Output, ...]:
    m, speeds = c.d.mass_matrix, c.names["u"]
    names = tuple(f"{a},{b}" for a in speeds for b in speeds)
    return (Output("M", (m.rows, m.columns), m.nodes, names),)


def _bias(c: Context) -> tuple[Output, ...]:
    return c.vector("h", c.d.bias(), "tau")


def _gravity(c: Context) -> tuple[Output, ...]:
    return c.vector("gravity", c.d.bias(moving=False), "tau")


def _coriolis(c: Context) -> tuple[Output, ...]:
    return c.vector("coriolis", c.d.bias(gravity=False), "tau")


def _forces(c: Context) -> tuple[Output, ...]:
    return c.vector("f", c.d.forces(), "tau")


def _qdot(c: Context) -> tuple[Output, ...]:
    return c.vector("qdot", c.k.rates, "qdot")


def _energy(c: Context) -> tuple[Output, ...]:
    kinetic, potential = outputs.energy(c.d)
    total = kinetic + potential
    values = {"kinetic": kinetic, "potential": potential, "total": total}
    return tuple(Output(n, (), (x.node,), (n,), ("J",)) for n, x in values.items())


def _pose(c: Context) -> tuple[Output, ...]:
    names = tuple(f"{a}{b}" for a in "xyz1" for b in "xyz1")
    return (Output("pose", (4, 4), outputs.pose(c.k, c.frame).nodes, names),)


def _velocity(c: Context) -> tuple[Output, ...]:
    return (Output("velocity", (6,), outputs.velocity(c.k, c.frame).nodes, *TWIST),)


def _acceleration(c: Context) -> tuple[Output, ...]:
    acc = outputs.system_accelerations(c.d, c.udot)
    value = outputs.acceleration(c.d, acc, c.frame)
    units = ("rad/s^2",) * 3 + ("m/s^2",) * 3
    return (
        Output("acceleration", (6,), value.nodes, ("alx", "aly", "alz", "ax", "ay", "az"), units),
    )


def _frame_jacobian(c: Context) -> tuple[Output, ...]:
    value = outputs.frame_jacobian(c.k, c.frame)
    names = tuple(f"{a},{b}" for a in TWIST[0] for b in c.names["u"])
    return (Output("jacobian", (6, value.columns), value.nodes, names),)


def _com(c: Context) -> tuple[Output, ...]:
    return (Output("com", (3,), outputs.center_of_mass(c.k).nodes, XYZ, ("m",) * 3),)


def _momentum(c: Context) -> tuple[Output, ...]:
    units = ("kg*m^2/s",) * 3 + ("kg*m/s",) * 3
    names = ("lx", "ly", "lz", "px", "py", "pz")
    return (Output("momentum", (6,), outputs.momentum(c.k).nodes, names, units),)


def _reaction(c: Context) -> tuple[Output, ...]:
    system = c.k.system
    joints = [*system.moving_joints, *system.fixed]
    if c.of not in joints:
        raise DerivationError(f"joint '{c.of}' does not exist.{near(c.of or '', joints)}")
    return (Output("reaction", (6,), outputs.reaction(c.d, c.of).nodes, *WRENCH),)


def _rows(c: Context, positions: bool) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units of the residuals at position level, or at velocity level of all."""
    rows = c.d.constraints.rows
    if positions:
        rows = rows[: c.d.constraints.positions]
        return tuple(r.name for r in rows), tuple(r.unit for r in rows)
    units = (r.unit if r.level == VELOCITY else f"{r.unit or '1'}/s" for r in rows)
    return tuple(r.name for r in rows), tuple(units)


def _dependents(c: Context) -> tuple[Output, ...]:
    system, found = c.k.system, dict[str, tuple[list[str], list[int], list[str]]]()
    for block, values in (("q", c.k.coordinates), ("u", c.k.speeds)):
        names, nodes, units = found[block] = [], [], []
        for i, joint in enumerate(system.joints):
            if joint.closure >= 0:
                parts = joint.element.coordinates if block == "q" else joint.element.speeds
                head = joint.name if block == "q" else f"{joint.name}.u"
                names += entries(head, parts)
                nodes += values[i].nodes
                units += [part.unit for part in parts]
    return tuple(
        Output(block, (len(nodes),), tuple(nodes), tuple(names), tuple(units))
        for block, (names, nodes, units) in found.items()
    )


def residuals_of_rows(c: Context) -> Output:
    """g with names and units."""
    g = c.d.constraints.position
    return Output("g", (g.rows,), g.nodes, *_rows(c, True))


def rates_of_rows(c: Context) -> Output:
    """G u + g_t with names and units."""
    rates = c.d.constraints.rates
    return Output("rates", (rates.rows,), rates.nodes, *_rows(c, False))


def _constraints(c: Context) -> tuple[Output, ...]:
    return (residuals_of_rows(c),)


def _constraint_rates(c: Context) -> tuple[Output, ...]:
    return (rates_of_rows(c),)


def _constraint_jacobian(c: Context) -> tuple[Output, ...]:
    G = c.d.constraints.jacobian
    names = tuple(f"{r.name},{u}" for r in c.d.constraints.rows for u in c.names["u"])
    return (Output("G", (G.rows, G.columns), G.nodes, names),)


def _closure(c: Context) -> tuple[Output, ...]:
    cuts = c.k.system.cuts
    names = tuple(f"{cut.name}.{h.name}" for cut in cuts for h in cut.element.held)
    units = tuple(h.unit for cut in cuts for h in cut.element.held)
    return (Output("closure", (len(names),), c.d.constraints.closure.nodes, names, units),)


def _facing(c: Context) -> tuple[Output, ...]:
    owners, numbers = c.d.constraints.facing
    names = tuple(f"{owner}.facing{k}" for k, owner in enumerate(owners))
    return (Output("facing", (len(names),), numbers.nodes, names),)


def _multipliers(c: Context) -> tuple[Output, ...]:
    _, lam = c.d.bound(c.d.tau)
    rows = c.d.constraints.rows
    names, units = tuple(r.name for r in rows), tuple(r.force_unit for r in rows)
    return (Output("lam", (lam.rows,), lam.nodes, names, units),)


def _close_position(c: Context) -> tuple[Output, ...]:
    own, g = c.d.constraints, c.d.constraints.position
    jacobian = own.jacobian.block(slice(0, own.positions))
    step = c.d.projected(c.d.mass_matrix, jacobian, g)
    nodes = [ZERO] * c.k.system.nq
    for i, joint in enumerate(c.k.system.joints):
        if joint.q >= 0:
            du = step.block(slice(joint.u, joint.u + len(joint.element.speeds)))
            moved = joint.element.integrate(c.k.coordinates[i], du, **c.k.data[i])
            nodes[joint.q : joint.q + moved.rows] = moved.nodes
    moved = Matrix(c.k.graph, len(nodes), 1, nodes)
    return (*c.vector("q", moved, "q"), residuals_of_rows(c))


def _close_velocity(c: Context) -> tuple[Output, ...]:
    own = c.d.constraints
    speeds = c.d.block("u", c.k.system.nu)
    moved = speeds + c.d.projected(c.d.mass_matrix, own.jacobian, own.rates)
    return (*c.vector("u", moved, "u"), rates_of_rows(c))


def _motion(c: Context) -> dict[int, Scalar]:
    """Driving forces of prescribed joints at the udot of the model's own forces."""
    if not any(joint.motion is not None for joint in c.k.system.joints):
        return {}
    udot = c.d.forward(Matrix.zeros(c.k.graph, c.k.system.nu))
    return outputs.motion_forces(c.d, udot, outputs.system_accelerations(c.d, udot))


def _outputs(c: Context) -> tuple[Output, ...]:
    system = c.k.system
    _give_accelerations(c)
    values = [(o.name, c.k.resolve([o.node])[0], o.unit) for o in system.outputs]
    for i, force in _motion(c).items():
        unit = "N" if system.joints[i].element.speeds[0].unit == "m/s" else "N*m"
        values.append((f"{system.joints[i].name}.force", force.node, unit))
    return _list("outputs", values)


def _give_accelerations(c: Context) -> None:
    """Accelerations may stand in outputs: they follow from udot."""
    if any(atom.quantity == "acceleration" for atom in c.k.system.atoms.values()):
        udot = c.d.forward(Matrix.zeros(c.k.graph, c.k.system.nu))
        acc = outputs.system_accelerations(c.d, udot)
        c.k.acceleration = lambda frame: outputs.acceleration(c.d, acc, frame)


def _power(c: Context) -> tuple[Output, ...]:
    values = [(name, value.node, "W") for name, value in c.d.loads.power]
    for i, force in _motion(c).items():
        name = f"{c.k.system.joints[i].name}.motion"
        values.append((name, (force * c.k.u(i)[0]).node, "W"))
    values += _relations_power(c)
    return _list("power", values)


def _relations_power(c: Context) -> list[tuple[str, int, str]]:
    """Power of relations that contain the time: lam G u = -lam g_t."""
    relations = c.k.system.constraints
    if not relations or c.d.constraints.prescribed.is_zero:
        return []
    own = c.d.constraints
    _, lam = c.d.bound(Matrix.zeros(c.k.graph, c.k.system.nu))
    at = {row.owner: i for i, row in enumerate(own.rows)}
    return [
        (f"{entry.name}.motion", (-lam[at[entry.name]] * rate).node, "W")
        for entry, rate in zip(relations, own.prescribed, strict=True)
        if rate.node != ZERO
    ]


def _list(name: str, values: list[tuple[str, int, str]]) -> tuple[Output, ...]:
    names = tuple(v[0] for v in values)
    nodes = tuple(v[1] for v in values)
    return (Output(name, (len(values),), nodes, names, tuple(v[2] for v in values)),)


def _integrate(c: Context) -> tuple[Output, ...]:
    return c.vector("q", increments.integrated(c.d), "q")


def _difference(c: Context) -> tuple[Output, ...]:
    return c.vector("du", increments.difference(c.d), "du")


@dataclass(frozen=True)
class Recipe:
    """How a function comes about.

    Attributes:
        about: One line for the reader.
        build: Its builder.
        of: What ``of`` names.
        told: Whether it is the same in whatever frames and by whatever grouping of inertia the
            bodies are told.
        bound: Whether there is one only of systems with constraints.
        solved: Whether there is one only of systems with circuits in closed form.
        moves: Whether it moves coordinates along the speeds of the joints, whatever speeds the
            user chose.
    """

    about: str
    build: Builder
    of: str = ""
    told: bool = False
    bound: bool = False
    solved: bool = False
    moves: bool = False


RECIPES: dict[str, Recipe] = {
    "rhs": Recipe("time derivative of the state [q, u]", _rhs, told=True),
    "forward_dynamics": Recipe("udot with M udot + h = f + tau", _forward, told=True),
    "inverse_dynamics": Recipe("tau with M udot + h = f + tau", _inverse, told=True),
    "mass_matrix": Recipe("M: kinetic energy is 1/2 uᵀ M u", _mass_matrix, told=True),
    "bias": Recipe("h: velocity products and gravity", _bias, told=True),
    "gravity": Recipe("part of h that is left at rest", _gravity, told=True),
    "coriolis": Recipe("h without gravity", _coriolis, told=True),
    "applied": Recipe("f: generalized forces of the model's elements", _forces),
    "qdot": Recipe("qdot = N(q) u + n(t, q)", _qdot),
    "dependents": Recipe(
        "coordinates, then speeds, of joints that circuits determine", _dependents, solved=True
    ),
    "constraints": Recipe("g: what vanishes at position level", _constraints, bound=True),
    "constraint_rates": Recipe(
        "G u + g_t: what vanishes at velocity level", _constraint_rates, bound=True
    ),
    "constraint_jacobian": Recipe("G: G udot = gamma", _constraint_jacobian, bound=True),
    "closure": Recipe(
        "closing conditions of all cut joints, dependent ones too", _closure, bound=True
    ),
    "facing": Recipe(
        "cosines, all positive where no cut joint is turned round", _facing, bound=True
    ),
    "multipliers": Recipe(
        "lam: forces of constraint, M udot + h = f + tau + Gᵀ lam",
        _multipliers,
        told=True,
        bound=True,
    ),
    "close_position": Recipe(
        "q moved onto the constraints by one step, and g before it",
        _close_position,
        told=True,
        bound=True,
        moves=True,
    ),
    "close_velocity": Recipe(
        "u moved onto the constraints, and their rates before",
        _close_velocity,
        told=True,
        bound=True,
    ),
    "energy": Recipe("kinetic, potential and total energy", _energy),
    "com": Recipe("center of mass in ground axes", _com),
    "momentum": Recipe("angular (about the ground origin) and linear momentum", _momentum),
    "outputs": Recipe("declared outputs, then forces of prescribed motions", _outputs),
    "power": Recipe("power of everything that has no potential, by source", _power),
    "integrate": Recipe("q moved by a finite increment du along the speeds", _integrate),
    "difference": Recipe("du that moves q0 to q", _difference),
    "pose": Recipe("transform from frame axes to ground axes", _pose, "frame"),
    "velocity": Recipe(
        "angular velocity and velocity of the origin, ground axes", _velocity, "frame"
    ),
    "acceleration": Recipe(
        "angular acceleration and acceleration of the origin, ground axes", _acceleration, "frame"
    ),
    "frame_jacobian": Recipe("velocity = J u, ground axes", _frame_jacobian, "frame"),
    "reaction": Recipe(
        "wrench of parent on child at the child joint frame, in its axes", _reaction, "joint"
    ),
}
