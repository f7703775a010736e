"""Kinetic energy and potential energies of a tree, as formalisms differentiate them."""

from __future__ import annotations

from collections.abc import Mapping

from ...ir.arithmetic import Scalar
from ...ir.derivative import gradient, jacobian
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...spatial.moments import Inertia
from .inertia import of_body
from .kinematics import Kinematics


def kinetic(k: Kinematics, rotors: Mapping[int, Matrix]) -> Scalar:
    """Kinetic energy of bodies and rotors; it contains t where motions are prescribed.

    ``energy = sum (1/2 [omega; v] . inertia [omega; v] - m g . c)``, with the work of gravity.
    """
    k.graph.describe(kinetic)
    total = Scalar(k.graph, ZERO)
    for i in range(len(k.system.bodies)):
        with k.graph.made_by(k.owner(i), "energy"):
            inertia, twist = of_body(k, i), Matrix.vstack(k.omega[i], k.v[i])
            total = total + twist.dot(inertia.momentum(twist)) * 0.5
    for i, rotor in rotors.items():
        total = total + k.u(i).dot(rotor @ k.u(i)) * 0.5
    return total


def momenta(k: Kinematics, rotors: Mapping[int, Matrix]) -> Matrix:
    """p = dT/du (nu, 1): canonical momenta where speeds are rates of coordinates."""
    nodes = gradient(k.graph, kinetic(k, rotors).node, _speeds(k))
    return Matrix(k.graph, len(nodes), 1, nodes)


def inertia(k: Kinematics, rotors: Mapping[int, Matrix]) -> Matrix:
    """M = dp/du (nu, nu)."""
    rows = jacobian(k.graph, momenta(k, rotors).nodes, _speeds(k))
    # mixed derivatives agree: the lower triangle stands for both
    return Matrix(k.graph, len(rows), len(rows), [x for row in rows for x in row]).mirrored


def _speeds(k: Kinematics) -> list[int]:
    return [k.graph.var("u", slot) for slot in range(k.system.nu)]


def weight(k: Kinematics, gravity: Matrix) -> Scalar:
    """Potential energy in a field of gravity (3, 1), zero at the ground origin."""
    total = Scalar(k.graph, ZERO)
    for i in range(len(k.system.bodies)):
        with k.graph.made_by(k.owner(i), "energy"):
            total = total - gravity.dot(ground_moment(k, i, of_body(k, i)))
    return total


def ground_moment(k: Kinematics, i: int, inertia: Inertia) -> Matrix:
    """First moment of a body about the ground origin, ground axes."""
    return k.ground_position[i] * inertia.mass + k.ground_rotation[i] @ inertia.moment
