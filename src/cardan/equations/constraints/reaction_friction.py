"""Friction in joints that are pressed together by their own reactions.

A friction force D = c |R| in one joint changes the accelerations, and with them every reaction:
R = R0 + sum of R_j D_j. The equations D_i = c_i |R_i(D)| are solved by Newton steps from D = 0;
where sum_j c_i |R_ij| < 1 for all i they have one solution. Beyond that they may have several or
none: the configurations of P. Painleve.

Source: F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 5;
P. Painleve, C. R. Acad. Sci. Paris 121 (1895) 112.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ...elements.forces.force import Places
from ...ir.arithmetic import Scalar, norm, select
from ...ir.derivative import forward
from ...ir.function import Function, Output, live
from ...ir.graph import ONE, ZERO
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...ir.solve import solve
from ...records import dataclass
from ...spatial.axis import unit
from ...topology.system import Force, System
from ..functions.blocks import blocks
from ..kinematics.accelerations import accelerations
from ..kinematics.joint_forces import along_joint, joint_forces
from ..kinematics.loads import places
from .loop_loads import closing_wrenches, with_closing

if TYPE_CHECKING:
    from ..functions.dynamics import Dynamics

MAX_VERIFIED = 200  # speeds: a judge writes M out
STEPS = 6  # of Newton: each doubles the digits, the first has one


@dataclass(frozen=True)
class ReactionFriction:
    """The friction forces of a system that follow from reactions.

    Attributes:
        values: D of every element, by its placeholder.
        certainty: 1 - sum_j c_i |R_ij| of every element: where it is positive for all, D is the
            only solution.
    """

    values: dict[int, int]
    certainty: dict[str, Scalar]


def friction_forces(system: System) -> list[Force]:
    """Elements whose force follows from the reaction of their joint."""
    return [force for force in system.forces if force.element.by_reaction]


def solved(d: Dynamics, tau: Matrix, udot: Matrix) -> ReactionFriction:
    """The friction forces at accelerations that contain their placeholders.

    Args:
        d: The dynamics.
        tau: Generalized applied force (nu, 1).
        udot: The accelerations under it (nu, 1).
    """
    k, g = d.k, d.k.graph
    forces_of_friction = friction_forces(k.system)
    atoms = [_placeholder(places(k, force)) for force in forces_of_friction]
    reactions = _reactions(d, tau, udot, forces_of_friction)
    still = dict.fromkeys(atoms, ZERO)
    start, shares = [], []
    for reaction in reactions:
        start.append(with_values(reaction, still))
        along = [forward(g, reaction.nodes, {atom: ONE}) for atom in atoms]
        shares.append([Matrix(g, 3, 1, rebuild(g, x, still, into=g)[1]) for x in along])
    coefficients = [force.element.reaction_force(places(k, force)) for force in forces_of_friction]
    values = _newton(start, shares, coefficients)
    certainty = {
        force.name: 1 - c * sum((norm(*x) for x in row), Scalar(g, ZERO))
        for force, c, row in zip(forces_of_friction, coefficients, shares, strict=True)
    }
    return ReactionFriction(dict(zip(atoms, (v.node for v in values), strict=True)), certainty)


def verified_joints(system: System, chosen: Sequence[object]) -> list[tuple[int, bool]]:
    """Joint of every friction element that verification can derive from reactions, and if it has a
    line.

    None in closed loops, where accelerations alone do not tell reactions.
    """
    closed = bool(system.cuts or system.constraints or system.closures)
    if closed or chosen or system.nu > MAX_VERIFIED:
        return []
    joints = [i for force in friction_forces(system) for i in force.joints.values()]
    return [(i, bool(system.joints[i].element.line)) for i in joints]


def function(d: Dynamics) -> Function:
    """The Function ``scene_pressing``: what a judge solves for in another way.

    Outputs: rest (nu), generalized forces without friction that follows from reactions; along
    (k, nu), generalized force per unit of friction of every element; coefficient (k), friction per
    force of reaction.
    """
    k, g = d.k, d.k.graph
    forces_of_friction = friction_forces(k.system)
    atoms = [_placeholder(places(k, force)) for force in forces_of_friction]
    force, still = d.forces().nodes, dict.fromkeys(atoms, ZERO)
    without_friction = rebuild(g, force, still, into=g)[1]
    along = [forward(g, force, {atom: ONE}) for atom in atoms]
    rows = [node for row in along for node in rebuild(g, row, still, into=g)[1]]
    coefficients = [
        force.element.reaction_force(places(k, force)).node for force in forces_of_friction
    ]
    outputs = (
        Output("rest", (len(without_friction),), tuple(without_friction)),
        Output("along", (len(forces_of_friction), len(without_friction)), tuple(rows)),
        Output("coefficient", (len(forces_of_friction),), tuple(coefficients)),
    )
    roots = [node for output in outputs for node in output.nodes]
    read = {g.nodes[i][1] for i in live(g, roots) if g.nodes[i][0] == "var"}
    all_blocks = blocks(k.system)
    about = "friction that follows from reactions"
    inputs = tuple(all_blocks[name] for name in all_blocks if name in read)
    return Function("scene_pressing", g, inputs, outputs, about=about)


def with_values(x: Matrix, values: dict[int, int]) -> Matrix:
    """Expressions with the friction forces in place of what stands for them."""
    return Matrix(x.graph, x.rows, x.columns, rebuild(x.graph, x.nodes, values, into=x.graph)[1])


def _placeholder(at: Places) -> int:
    assert at.reaction_force is not None
    return at.reaction_force.node


def _reactions(
    d: Dynamics, tau: Matrix, udot: Matrix, forces_of_friction: list[Force]
) -> list[Matrix]:
    """Force across the line of every joint concerned (3, 1), in axes of its child."""
    k = d.k
    acc = accelerations(k, [along_joint(k, i, udot) for i in range(len(k.joints))], d.gravity)
    closing = closing_wrenches(d, tau, udot, acc)
    forces = joint_forces(k, acc, with_closing(k, d.loads, closing)).force
    normals = []
    for force in forces_of_friction:
        (i,) = force.joints.values()
        line = k.system.joints[i].element.line
        reaction = forces[i]
        if line:
            axis = unit(k.matrix(*k.system.joints[i].data[line]))
            reaction = reaction - axis * axis.dot(reaction)
        normals.append(reaction)
    return normals


def _newton(start: list[Matrix], shares: list[list[Matrix]], c: list[Scalar]) -> list[Scalar]:
    """D_i = c_i |R_i0 + sum_j R_ij D_j|."""
    g, n = start[0].graph, len(start)
    D = [Scalar(g, ZERO)] * n
    for _ in range(STEPS if _feeds(shares) else 1):
        R = [sum((x * v for x, v in zip(shares[i], D, strict=True)), start[i]) for i in range(n)]
        size = [norm(*r) for r in R]
        # where nothing presses the direction is no matter
        along = [r / select((s * 0).apply("lt", s), s, 1) for r, s in zip(R, size, strict=True)]
        slopes = [[along[i].dot(shares[i][j]) * c[i] for j in range(n)] for i in range(n)]
        left = [[(1 if i == j else 0) - slopes[i][j] for j in range(n)] for i in range(n)]
        right = [c[i] * size[i] - D[i] for i in range(n)]
        step = solve(
            "rank_revealing",
            Matrix(g, n, n, [x.node for row in left for x in row]),
            Matrix.vector(g, right),
        )
        D = [v + step[i] for i, v in enumerate(D)]
    return D


def _feeds(shares: list[list[Matrix]]) -> bool:
    """True when friction changes any of the reactions."""
    return any(not x.is_zero for row in shares for x in row)
