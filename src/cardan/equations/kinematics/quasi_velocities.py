"""Displacements along generalized speeds that need be no rates of coordinates.

Speeds u with qdot = N u + n may be angular velocities or chosen by the user. A displacement e along
speed r moves q by N_r e, and changes u by edot in entry r and by c_r e: c_r are Hamel's symbols
times u, the commutator of the motion and the displacement,
N c_r = d/dt N_r - d(N u + n) along N_r.

Of the speeds of a joint they are what its group says (:meth:`Joint.bracket`), so that no N has to
be inverted and gimbal lock does no harm. Of chosen speeds, u_joint = W u + w, they follow by
W c_r = d/dt W_r - d(W u + w) along r + bracket(u_joint, W_r).

Source: Hamel, Z. Math. Phys. 50 (1904); Boltzmann, Sitzungsber. Akad. Wiss. Wien 111 (1902);
Lurie, Analytical Mechanics (2002), sections 1.5 to 1.8 and 7.6.
"""

from __future__ import annotations

from ...ir.arithmetic import Scalar
from ...ir.derivative import directional, forward
from ...ir.graph import ONE, ZERO
from ...ir.matrix import Matrix
from .kinematics import Kinematics
from .loads import Loads, without_potential
from .partial_velocities import generalized_forces
from .rotation_rates import derivative, rotating_joints, rotation_seeds


def displacements(k: Kinematics) -> list[dict[int, int]]:
    """Coordinates and entries of rotations -> their changes along every speed."""
    g, displacements_of_speeds, rotating = k.graph, [], rotating_joints(k)
    for slot in range(k.system.nu):
        column = forward(g, k.rates.nodes, {g.var("u", slot): ONE})
        seeds = {g.var("q", m): node for m, node in enumerate(column) if node != ZERO}
        for i, speeds in rotating:
            dots = forward(g, speeds.nodes, {g.var("u", slot): ONE})
            seeds |= rotation_seeds(k, i, Matrix(g, speeds.rows, 1, dots))
        displacements_of_speeds.append(seeds)
    return displacements_of_speeds


def slopes(k: Kinematics, x: Scalar) -> Matrix:
    """Derivatives of an expression in q along the speeds (nu, 1), u held."""
    columns = directional(k.graph, [x.node], displacements(k))
    return Matrix(k.graph, len(columns), 1, [column[0] for column in columns])


def transport_terms(k: Kinematics, momenta: Matrix) -> Matrix:
    """Momenta on what displacements along every speed do to the speeds: p . c_r (nu, 1)."""
    if k.chosen:
        return _of_chosen(k, momenta)
    nodes = [ZERO] * k.system.nu
    for i, joint in enumerate(k.system.joints):
        if joint.u < 0:
            continue
        unit = Matrix.identity(k.graph, len(joint.element.speeds))
        joint_momenta = momenta.block(slice(joint.u, joint.u + unit.rows))
        with k.graph.made_by(joint.name, "bracket"):
            for n in range(unit.rows):
                change = joint.element.bracket(k.speeds[i], unit.column(n))
                nodes[joint.u + n] = joint_momenta.dot(change).node
    return Matrix(k.graph, len(nodes), 1, nodes)


def _of_chosen(k: Kinematics, momenta: Matrix) -> Matrix:
    """The same for chosen speeds: by the momenta of the joint speeds."""
    g, nu = k.graph, k.system.nu
    of_joints, total = k.chosen_by_joints.T @ momenta, Matrix.zeros(g, nu)
    along = displacements(k)
    for i, joint in enumerate(k.system.joints):
        if joint.u < 0:
            continue
        speeds, nodes = k.speeds[i], [ZERO] * nu
        joint_momenta = of_joints.block(slice(joint.u, joint.u + speeds.rows))
        columns, zero_column = k.partials_of(speeds), Matrix.zeros(g, speeds.rows)
        for r in range(nu):
            column = columns.get(r, zero_column)
            moved = Matrix(g, speeds.rows, 1, forward(g, speeds.nodes, along[r]))
            change = derivative(k, column) - moved + joint.element.bracket(speeds, column)
            nodes[r] = joint_momenta.dot(change).node
        total = total + Matrix(g, nu, 1, nodes)
    return total


def drawn(k: Kinematics, loads: Loads) -> Matrix:
    """f (nu, 1): the potentials of elements differentiated along the speeds, the rest projected."""
    projected = generalized_forces(k, without_potential(k, loads))
    return projected - slopes(k, loads.potential)
