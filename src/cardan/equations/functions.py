"""The functions of a system by their public names, each derived from scratch when asked for."""

from __future__ import annotations

from ..errors import DerivationError, near
from ..ir.arithmetic import Scalar
from ..ir.function import Output
from ..ir.graph import ZERO
from ..ir.matrix import Matrix
from . import binding, canonical, happening, increments, outputs, regressor
from .context import Context, Recipe
from .loads import generalized

TWIST = (("wx", "wy", "wz", "vx", "vy", "vz"), ("rad/s",) * 3 + ("m/s",) * 3)
WRENCH = (("mx", "my", "mz", "fx", "fy", "fz"), ("N*m",) * 3 + ("N",) * 3)
XYZ = ("x", "y", "z")


def _rhs(c: Context) -> tuple[Output, ...]:
    rest = Matrix.zeros(c.k.graph, c.k.system.nu)
    found = c.vector("qdot", c.k.rates, "qdot") + c.vector("udot", c.d.forward(rest), "udot")
    return found + (c.vector("zdot", happening.rates(c.d), "zdot") if c.k.system.nz else ())


def _events(c: Context) -> tuple[Output, ...]:
    return c.vector("events", happening.signs(c.d), "e")


def _transition(c: Context) -> tuple[Output, ...]:
    u, z, s = happening.transition(c.d)
    return c.vector("u", u, "u") + c.vector("z", z, "z") + c.vector("s", s, "s")


def _forward(c: Context) -> tuple[Output, ...]:
    return c.vector("udot", c.d.forward(c.d.tau), "udot")


def _inverse(c: Context) -> tuple[Output, ...]:
    c.with_friction_at(c.udot)
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


def _wrenches(c: Context) -> tuple[Output, ...]:
    bodies, zero = range(len(c.k.system.bodies)), Matrix.zeros(c.k.graph, 3)
    pairs = [c.d.loads.wrenches.get(i, (zero, zero)) for i in bodies]
    found = {"moment": [x for x, _ in pairs], "force": [x for _, x in pairs]}
    outputs = [
        Output(name, (len(bodies), 3), tuple(node for x in rows for node in x.nodes))
        for name, rows in found.items()
    ]
    return (*outputs, *c.vector("joints", generalized(c.k, c.d.loads), "tau"))


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
    moved = _held_power(c)
    values = []
    for name, value in c.d.loads.power:
        values.append((name, (value + moved.pop(name, 0)).node, "W"))
    values += [(name, value.node, "W") for name, value in moved.items()]
    for i, force in _motion(c).items():
        name = f"{c.k.system.joints[i].name}.motion"
        values.append((name, (force * c.k.u(i)[0]).node, "W"))
    values += _relations_power(c)
    return _list("power", values)


def _held_power(c: Context) -> dict[str, Scalar]:
    """Power of what elements hold on surfaces that move by themselves: lam G u = -lam g_t."""
    found: dict[str, Scalar] = {}
    if not any(force.element.holding() for force in c.k.system.forces):
        return found
    own = c.d.constraints
    for row, rate in own.surfaces:
        if rate.node != ZERO:
            _, lam = c.d.bound(Matrix.zeros(c.k.graph, c.k.system.nu))
            owner = own.rows[row].owner
            found[owner] = found.get(owner, Scalar(c.k.graph, ZERO)) - lam[row] * rate
    return found


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


RECIPES: dict[str, Recipe] = {
    "rhs": Recipe("time derivative of the state [q, u, z]", _rhs, told=True),
    "forward_dynamics": Recipe("udot with M udot + h = f + tau", _forward, told=True),
    "inverse_dynamics": Recipe("tau with M udot + h = f + tau", _inverse, told=True),
    "mass_matrix": Recipe("M: kinetic energy is 1/2 uᵀ M u", _mass_matrix, told=True),
    "bias": Recipe("h: velocity products and gravity", _bias, told=True),
    "gravity": Recipe("part of h that is left at rest", _gravity, told=True),
    "coriolis": Recipe("h without gravity", _coriolis, told=True),
    "applied": Recipe("f: generalized forces of the model's elements", _forces),
    "wrenches": Recipe(
        "what elements do on every body, at its origin in its axes, and along joints", _wrenches
    ),
    "qdot": Recipe("qdot = N(q) u + n(t, q)", _qdot),
    "dependents": Recipe(
        "coordinates, then speeds, of joints that circuits determine",
        binding.dependents,
        solved=True,
    ),
    "constraints": Recipe("g: what vanishes at position level", binding.constraints, bound=True),
    "constraint_rates": Recipe(
        "G u + g_t: what vanishes at velocity level", binding.constraint_rates, bound=True
    ),
    "constraint_jacobian": Recipe("G: G udot = gamma", binding.constraint_jacobian, bound=True),
    "constraint_bias": Recipe("gamma: G udot = gamma", binding.constraint_bias, bound=True),
    "closure": Recipe(
        "closing conditions of all cut joints, dependent ones too", binding.closure, bound=True
    ),
    "facing": Recipe(
        "cosines, all positive where no cut joint is turned round", binding.facing, bound=True
    ),
    "multipliers": Recipe(
        "lam: forces of constraint, M udot + h = f + tau + Gᵀ lam",
        binding.multipliers,
        told=True,
        bound=True,
    ),
    "close_position": Recipe(
        "q moved onto the constraints by one step, and g before it",
        binding.close_position,
        told=True,
        bound=True,
        moves=True,
    ),
    "close_velocity": Recipe(
        "u moved onto the constraints, and their rates before",
        binding.close_velocity,
        told=True,
        bound=True,
    ),
    "events": Recipe(
        "numbers that fall through zero where an event happens", _events, told=True, happens=True
    ),
    "transition": Recipe(
        "speeds, internal and discrete states behind the events e",
        _transition,
        told=True,
        happens=True,
    ),
    "regressor": Recipe(
        "Y: tau is Y phi and what does not depend on phi, the inertial parameters",
        regressor.regressor,
        linear=True,
    ),
    "energy_regressor": Recipe(
        "kinetic and potential energy, and power without a potential, per inertial parameter",
        regressor.energy_regressor,
        linear=True,
    ),
    "inertial_parameters": Recipe(
        "phi: what forces and energies are linear in", regressor.inertial_parameters
    ),
    "energy": Recipe("kinetic, potential and total energy", _energy),
    "com": Recipe("center of mass in ground axes", _com),
    "momentum": Recipe("angular (about the ground origin) and linear momentum", _momentum),
    "momenta": Recipe("p = dT/du: momenta along the speeds", canonical.momenta),
    "momentum_rates": Recipe(
        "rates of the momenta under forces and constraints", canonical.momentum_rates
    ),
    "hamiltonian": Recipe("H = p . u - T + V", canonical.hamiltonian),
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
