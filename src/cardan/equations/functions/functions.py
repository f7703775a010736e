"""Derivations of the functions of a system, each from scratch when it is requested."""

from __future__ import annotations

from ...errors import DerivationError, near
from ...ir.arithmetic import Scalar
from ...ir.function import Output
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...topology.prescribed_motion import driving_outputs
from ..kinematics import increments
from ..kinematics.loads import generalized
from . import event_functions
from . import outputs as of_system
from .context import Context, recipe

TWIST = (("wx", "wy", "wz", "vx", "vy", "vz"), ("rad/s",) * 3 + ("m/s",) * 3)
WRENCH = (("mx", "my", "mz", "fx", "fy", "fz"), ("N*m",) * 3 + ("N",) * 3)
XYZ = ("x", "y", "z")


@recipe
def rhs(c: Context) -> tuple[Output, ...]:
    zero_tau = Matrix.zeros(c.k.graph, c.k.system.nu)
    rates = c.vector("qdot", c.k.rates, "qdot") + c.vector("udot", c.d.forward(zero_tau), "udot")
    return rates + (internal_rates(c) if c.k.system.nz else ())


@recipe
def internal_rates(c: Context) -> tuple[Output, ...]:
    return c.vector("zdot", event_functions.rates(c.d), "zdot")


@recipe
def events(c: Context) -> tuple[Output, ...]:
    return c.vector("events", event_functions.signs(c.d), "e")


@recipe
def transition(c: Context) -> tuple[Output, ...]:
    u, z, s = event_functions.transition(c.d)
    return c.vector("u", u, "u") + c.vector("z", z, "z") + c.vector("s", s, "s")


@recipe
def forward_dynamics(c: Context) -> tuple[Output, ...]:
    return c.vector("udot", c.d.forward(c.d.tau), "udot")


@recipe
def inverse_dynamics(c: Context) -> tuple[Output, ...]:
    c.with_friction_at(c.udot)
    return c.vector("tau", c.d.inverse(c.udot), "tau")


@recipe
def mass_matrix(c: Context) -> tuple[Output, ...]:
    m, speeds = c.d.mass_matrix, c.names["u"]
    names = tuple(f"{a},{b}" for a in speeds for b in speeds)
    return (Output("M", (m.rows, m.columns), m.nodes, names),)


@recipe
def bias(c: Context) -> tuple[Output, ...]:
    return c.vector("h", c.d.bias(), "tau")


@recipe
def gravity(c: Context) -> tuple[Output, ...]:
    return c.vector("gravity", c.d.bias(moving=False), "tau")


@recipe
def coriolis(c: Context) -> tuple[Output, ...]:
    return c.vector("coriolis", c.d.bias(gravity=False), "tau")


@recipe
def applied_forces(c: Context) -> tuple[Output, ...]:
    return c.vector("f", c.d.forces(), "tau")


@recipe
def wrenches(c: Context) -> tuple[Output, ...]:
    bodies, zero = range(len(c.k.system.bodies)), Matrix.zeros(c.k.graph, 3)
    pairs = [c.d.loads.wrenches.get(i, (zero, zero)) for i in bodies]
    columns = {"moment": [x for x, _ in pairs], "force": [x for _, x in pairs]}
    outputs = [
        Output(name, (len(bodies), 3), tuple(node for x in rows for node in x.nodes))
        for name, rows in columns.items()
    ]
    return (*outputs, *c.vector("joints", generalized(c.k, c.d.loads), "tau"))


@recipe
def qdot(c: Context) -> tuple[Output, ...]:
    return c.vector("qdot", c.k.rates, "qdot")


@recipe
def energy(c: Context) -> tuple[Output, ...]:
    kinetic, potential = of_system.energy(c.d)
    total = kinetic + potential
    values = {"kinetic": kinetic, "potential": potential, "total": total}
    return tuple(Output(n, (), (x.node,), (n,), ("J",)) for n, x in values.items())


@recipe
def pose(c: Context) -> tuple[Output, ...]:
    names = tuple(f"{a}{b}" for a in "xyz1" for b in "xyz1")
    return (Output("pose", (4, 4), of_system.pose(c.k, c.frame).nodes, names),)


@recipe
def velocity(c: Context) -> tuple[Output, ...]:
    return (Output("velocity", (6,), of_system.velocity(c.k, c.frame).nodes, *TWIST),)


@recipe
def acceleration(c: Context) -> tuple[Output, ...]:
    acc = of_system.system_accelerations(c.d, c.udot)
    value = of_system.acceleration(c.d, acc, c.frame)
    units = ("rad/s^2",) * 3 + ("m/s^2",) * 3
    return (
        Output("acceleration", (6,), value.nodes, ("alx", "aly", "alz", "ax", "ay", "az"), units),
    )


@recipe
def frame_jacobian(c: Context) -> tuple[Output, ...]:
    value = of_system.frame_jacobian(c.k, c.frame)
    names = tuple(f"{a},{b}" for a in TWIST[0] for b in c.names["u"])
    return (Output("jacobian", (6, value.columns), value.nodes, names),)


@recipe
def com(c: Context) -> tuple[Output, ...]:
    return (Output("com", (3,), of_system.center_of_mass(c.k).nodes, XYZ, ("m",) * 3),)


@recipe
def momentum(c: Context) -> tuple[Output, ...]:
    units = ("kg*m^2/s",) * 3 + ("kg*m/s",) * 3
    names = ("lx", "ly", "lz", "px", "py", "pz")
    return (Output("momentum", (6,), of_system.momentum(c.k).nodes, names, units),)


@recipe
def reaction(c: Context) -> tuple[Output, ...]:
    system = c.k.system
    joints = [*system.moving_joints, *system.fixed]
    if c.of not in joints:
        raise DerivationError(f"joint '{c.of}' does not exist.{near(c.of or '', joints)}")
    return (Output("reaction", (6,), of_system.reaction(c.d, c.of).nodes, *WRENCH),)


def _motion(c: Context) -> dict[int, Scalar]:
    """Driving forces of prescribed joints at the udot of the model's own forces."""
    if not any(joint.motion is not None for joint in c.k.system.joints):
        return {}
    udot = c.d.forward(Matrix.zeros(c.k.graph, c.k.system.nu))
    return of_system.motion_forces(c.d, udot, of_system.system_accelerations(c.d, udot))


@recipe
def outputs(c: Context) -> tuple[Output, ...]:
    system = c.k.system
    give_accelerations(c)
    values = [(o.name, c.k.resolve([o.node])[0], o.unit) for o in system.outputs]
    named = driving_outputs(system)
    for i, force in _motion(c).items():
        name, unit = named[i]
        values.append((name, force.node, unit))
    return _list("outputs", values)


def give_accelerations(c: Context) -> None:
    """Accelerations may stand in outputs: they follow from udot."""
    if any(atom.quantity == "acceleration" for atom in c.k.system.atoms.values()):
        udot = c.d.forward(Matrix.zeros(c.k.graph, c.k.system.nu))
        acc = of_system.system_accelerations(c.d, udot)
        c.k.acceleration = lambda frame: of_system.acceleration(c.d, acc, frame)


@recipe
def power(c: Context) -> tuple[Output, ...]:
    moved = _constraint_power(c)
    values = []
    for name, value in c.d.loads.power:
        values.append((name, (value + moved.pop(name, 0)).node, "W"))
    values += [(name, value.node, "W") for name, value in moved.items()]
    for i, force in _motion(c).items():
        name = f"{c.k.system.joints[i].name}.motion"
        values.append((name, (force * c.k.u(i)[0]).node, "W"))
    values += _relations_power(c)
    return _list("power", values)


def _constraint_power(c: Context) -> dict[str, Scalar]:
    """Power of what elements hold on surfaces that move by themselves."""
    powers: dict[str, Scalar] = {}
    if not any(force.element.locked_velocities() for force in c.k.system.forces):
        return powers
    for row, rate in c.d.driven_rows.still.items():
        _, lam = c.d.bound(Matrix.zeros(c.k.graph, c.k.system.nu))
        entry = c.d.constraints.rows[row]
        if entry.switched:
            powers[entry.owner] = powers.get(entry.owner, Scalar(c.k.graph, ZERO)) - lam[row] * rate
    return powers


def _relations_power(c: Context) -> list[tuple[str, int, str]]:
    """Power of relations that contain the time themselves."""
    if not c.k.system.constraints or not c.d.driven_rows.still:
        return []
    rows, (_, lam) = c.d.constraints.rows, c.d.bound(Matrix.zeros(c.k.graph, c.k.system.nu))
    return [
        (f"{rows[row].owner}.motion", (-lam[row] * rate).node, "W")
        for row, rate in c.d.driven_rows.still.items()
        if not rows[row].switched
    ]


def _list(name: str, values: list[tuple[str, int, str]]) -> tuple[Output, ...]:
    names = tuple(v[0] for v in values)
    nodes = tuple(v[1] for v in values)
    return (Output(name, (len(values),), nodes, names, tuple(v[2] for v in values)),)


@recipe
def integrate(c: Context) -> tuple[Output, ...]:
    return c.vector("q", increments.integrated(c.d), "q")


@recipe
def difference(c: Context) -> tuple[Output, ...]:
    return c.vector("du", increments.difference(c.d), "du")
