"""Articulated bodies: forward dynamics in one inward and one outward sweep.

The accelerations at udot = 0, with gravity, come first, as in the recursion of Newton and Euler. A
body with all bodies outboard of it answers a further acceleration (alpha, a) of its origin with the
moment and force [[I, H], [Hᵀ, M]] [alpha; a] + bias. The inward sweep eliminates the speeds of a
joint; the outward sweep computes udot. Accelerations are classical ones of the body origins, not
spatial ones as in the source. So linear velocities are not needed, and velocity products do not
pass through the articulated inertias, which saves a tenth of the operations.

Source: Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 7.
"""

from __future__ import annotations

from ...errors import DerivationError
from ...ir.graph import ONE, ZERO
from ...ir.matrix import Matrix, inner
from ...ir.solve import solve
from ...records import dataclass
from ...spatial.moments import turn_general, turn_symmetric
from ...topology.system import System
from ..kinematics.accelerations import Accelerations, accelerations, inertial_wrench
from ..kinematics.composite_bodies import composites, projected
from ..kinematics.inertia import of_body
from ..kinematics.joint_forces import bias, forces, inverse_dynamics
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads
from ..recursion.recursion_boundary import CELLS, Sums
from .formalism import RECURSIONS, Formalism, every

# deepest tree whose inertias are regrouped (constant parts of several bodies added up beforehand):
# regrouped inertias grow with the number of bodies outboard, and so does the rounding error of the
# differences; in chains of 30 joints it costs a digit
DEEPEST = 12


@dataclass(frozen=True)
class Articulated:
    """[[I, H], [Hᵀ, M]] (3, 3 each) and the bias moment and force (6, 1)."""

    I: Matrix
    H: Matrix
    M: Matrix
    bias: Matrix

    @property
    def parts(self) -> tuple[Matrix, Matrix, Matrix, Matrix]:
        return self.I, self.H, self.M, self.bias

    def times(self, x: Matrix) -> Matrix:
        """Moment and force of an acceleration (6, n)."""
        w, v = x.block(slice(0, 3)), x.block(slice(3, 6))
        return Matrix.vstack(self.I @ w + self.H @ v, self.H.T @ w + self.M @ v)


@dataclass(frozen=True)
class Elimination:
    """udot of a joint = free - gain · (further acceleration the parent imposes)."""

    free: Matrix
    gain: Matrix


def forward_dynamics(k: Kinematics, tau: Matrix, loads: Loads, gravity: Matrix) -> Matrix:
    """udot (nu, 1) of the applied forces and tau.

    Raises:
        DerivationError: a joint is coupled to another, or carries no inertia along its motion.
    """
    _refuse_coupled(k)
    still = [Matrix.zeros(k.graph, len(j.element.speeds)) for j in k.system.joints]
    eliminations = _inward(k, tau, loads, accelerations(k, still, gravity, word="still_"))
    return _outward(k, eliminations)


def _refuse_coupled(k: Kinematics) -> None:
    coupled = [j.name for j in k.system.joints if j.coupling is not None or j.closure >= 0]
    if coupled:
        raise DerivationError(
            f"method 'articulated' cannot eliminate the coupled joints {', '.join(coupled)}: "
            "use method='composite' (or 'auto')"
        )


def _inward(k: Kinematics, tau: Matrix, loads: Loads, imposed: Accelerations) -> list[Elimination]:
    """Articulated inertias from the leaves to the ground, eliminating each joint's speeds.

    ``articulated = I + sum Xᵀ (I_A - U D⁻¹ Uᵀ)_child X`` of the children, with
    ``elimination = U, D: U = I_A S, D = Sᵀ U``,
    ``free = D⁻¹ (tau + f - Sᵀ bias)``, f the forces along the joint, ``gain = D⁻¹ Uᵀ`` and
    ``bias = own bias + sum Xᵀ (bias + U free)_child``.
    """
    k.graph.describe(_inward)
    n = len(k.system.bodies)
    sums = Sums(k, ("I", "H", "M", "bias"), [_rigid(k, i, loads, imposed).parts for i in range(n)])
    eliminations: dict[int, Elimination] = {}
    for i in range(n - 1, -1, -1):
        joint, parent, name = k.system.joints[i], k.system.bodies[i].parent, k.owner(i)
        body = Articulated(*sums[i])
        for block, letter in ((body.I, "I"), (body.H, "H"), (body.M, "M")):
            block.label(name, f"articulated_{letter}", CELLS)
        with k.graph.made_by(name, "elimination"):
            if joint.motion is not None:
                eliminations[i] = Elimination(Matrix.zeros(k.graph, 0), Matrix(k.graph, 0, 6, ()))
                remaining = body
            else:
                eliminations[i], remaining = _eliminate(k, i, body, tau, loads)
        if parent >= 0:
            with k.graph.made_by(k.owner(parent), "articulated"):
                sums.add(parent, i, _transported(k, i, remaining).parts)
    return [eliminations[i] for i in range(n)]


def _rigid(k: Kinematics, i: int, loads: Loads, imposed: Accelerations) -> Articulated:
    """A body by itself: its inertia, and what it needs at udot = 0 as bias."""
    inertia, g = of_body(k, i), k.graph
    mass = Matrix.identity(g, 3) * inertia.mass
    bias = Matrix.vstack(*inertial_wrench(k, i, imposed, loads))
    return Articulated(inertia.tensor, inertia.moment.skew, mass, bias)


def _eliminate(
    k: Kinematics, i: int, body: Articulated, tau: Matrix, loads: Loads
) -> tuple[Elimination, Articulated]:
    """Solve the joint's equation for its udot and put it into the body's."""
    joint, s, g = k.system.joints[i], k.joints[i].S, k.graph
    reach = body.times(s)
    d = s.T @ reach
    if i in loads.rotors:
        d = d + loads.rotors[i]
    _check_inertia(joint.name, d)
    force = tau.block(slice(joint.u, joint.u + s.columns))
    if i in loads.joints:
        force = force + loads.joints[i]
    available = force - s.T @ body.bias
    if s.columns == 1:
        inverse = g.label(g.div(ONE, d.nodes[0]), joint.name, "D_inverse")
        gain = reach.T.map(lambda x: g.mul(inverse, x))
        free = available.map(lambda x: g.mul(inverse, x))
    else:
        both = solve("spd", d, Matrix.hstack(reach.T, available))
        gain, free = both.block(slice(None), slice(0, 6)), both.column(6)
    names = [c.name for c in joint.element.speeds]
    free = k.carry(i, "free", free, names, joint.name)
    gain = k.carry(i, "gain", gain, (), joint.name)
    elimination = Elimination(free, gain)
    if k.system.bodies[i].parent < 0:
        return elimination, body
    plain = s.columns == 1 and i not in loads.rotors
    return elimination, _remaining(body, reach, gain, free, _unit(s) if plain else None)


def _check_inertia(name: str, d: Matrix) -> None:
    if any(d.nodes[j * d.columns + j] == ZERO for j in range(d.rows)):
        raise DerivationError(
            f"joint '{name}': nothing outboard of it has inertia along its motion, so that M is "
            "singular. Give the bodies there a mass or an inertia, or fix or prescribe the joint"
        )


def _unit(s: Matrix) -> int | None:
    """k if S is the k-th unit vector or its negative: row k of what remains is exactly zero."""
    used = [j for j, node in enumerate(s.nodes) if node != ZERO]
    return used[0] if len(used) == 1 and s.nodes[used[0]] in (1, 2) else None


def _remaining(
    body: Articulated, reach: Matrix, gain: Matrix, free: Matrix, zero: int | None
) -> Articulated:
    """Articulated inertia of the body with its joint free: A - U D^-1 Uᵀ, symmetric."""
    g = reach.graph

    def part(x: Matrix, row: int, column: int, symmetric: bool) -> Matrix:
        nodes: dict[tuple[int, int], int] = {}
        for a in range(3):
            for b in range(3):
                if symmetric and b < a:
                    nodes[a, b] = nodes[b, a]
                elif zero in (row + a, column + b):
                    nodes[a, b] = ZERO
                else:
                    lost = reach.block(slice(row + a, row + a + 1)) @ gain.column(column + b)
                    nodes[a, b] = g.sub(x.nodes[3 * a + b], lost.nodes[0])
        return Matrix(g, 3, 3, [nodes[a, b] for a in range(3) for b in range(3)])

    bias = body.bias + reach @ free
    return Articulated(
        part(body.I, 0, 0, True), part(body.H, 0, 3, False), part(body.M, 3, 3, True), bias
    )


def _transported(k: Kinematics, i: int, remaining: Articulated) -> Articulated:
    """What remains of body i, in the axes and about the origin of its parent."""
    joint = k.joints[i]
    r, p = joint.rotation, joint.position
    bias = remaining.bias
    tensor, coupling, mass = remaining.I, remaining.H, remaining.M
    for turn in reversed(joint.turns):
        tensor, mass = turn_symmetric(turn, tensor), turn_symmetric(turn, mass)
        coupling = turn_general(turn, coupling)
    force = r @ bias.block(slice(3, 6))
    moment = r @ bias.block(slice(0, 3)) + p.cross(force)
    # a = a_p - [p] alpha_p, moment about the parent's origin: + [p] force
    moved = coupling + p.skew @ mass
    added = _symmetric(p.skew, coupling.T) - _symmetric(moved, p.skew)
    return Articulated(tensor + added, moved, mass, Matrix.vstack(moment, force))


def _symmetric(a: Matrix, b: Matrix) -> Matrix:
    """Upper triangle of a b (3, 3), mirrored; for terms of a sum that is symmetric."""
    upper = {(i, j): a.row(i) for i in range(3) for j in range(i, 3)}
    nodes = {at: inner(a.graph, row, b.nodes[at[1] :: 3]) for at, row in upper.items()}
    return Matrix(a.graph, 3, 3, [nodes[min(i, j), max(i, j)] for i in range(3) for j in range(3)])


def _outward(k: Kinematics, eliminations: list[Elimination]) -> Matrix:
    """Accelerations of the bodies by udot, and the udot of their joints.

    ``udot = free - gain X reached_parent``, ``reached = X reached_parent + S udot``.
    """
    k.graph.describe(_outward)
    g, body_accelerations = k.graph, list[Matrix]()
    udot = [ZERO] * k.system.nu
    for i, elimination in enumerate(eliminations):
        parent, joint, record = k.system.bodies[i].parent, k.joints[i], k.system.joints[i]
        with g.made_by(k.owner(i), "a"):
            if parent < 0:
                imposed = Matrix.zeros(g, 6)
            else:
                alpha, a = (
                    body_accelerations[parent].block(slice(0, 3)),
                    body_accelerations[parent].block(slice(3, 6)),
                )
                linear = joint.rotation.T @ (a + alpha.cross(joint.position))
                imposed = Matrix.vstack(joint.rotation.T @ alpha, linear)
        if record.motion is not None:
            body_accelerations.append(k.carry(i, "reached", imposed, ()))
            continue
        with g.made_by(record.name, "udot"):
            free_acceleration = elimination.free - elimination.gain @ imposed
            names = [c.name for c in record.element.speeds]
            free_acceleration = k.carry(i, "udot", free_acceleration, names, record.name)
            udot[record.u : record.u + free_acceleration.rows] = free_acceleration.nodes
        with g.made_by(k.owner(i), "a"):
            body_accelerations.append(
                k.carry(i, "reached", imposed + joint.S @ free_acceleration, ())
            )
    return Matrix(g, k.system.nu, 1, udot)


def mass_matrix(k: Kinematics, loads: Loads) -> Matrix:
    """M (nu, nu) by composite bodies, for users: the elimination does not need it."""
    return projected(k, composites(k), loads)


def rewrites(system: System) -> tuple[str, ...]:
    """Names of the rewrites to apply: all, but no regrouped inertias in deep trees."""
    deep = system.depth() > DEEPEST
    return tuple(name for name in every(system) if not (deep and name == "base_parameters"))


ARTICULATED = Formalism(
    "articulated",
    "joints eliminated one by one, without M",
    "Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 7.",
    mass_matrix,
    bias,
    forces,
    inverse_dynamics,
    forward_dynamics,
    rewrites,
    loops=(*RECURSIONS, "rhs", "forward_dynamics", "outputs", "power"),
    binds=False,
    couples=False,
    chooses=False,
)
