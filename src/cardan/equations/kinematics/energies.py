"""Kinetic energy and potential energies of a tree, as formalisms differentiate them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...ir.arithmetic import Scalar
from ...ir.derivative import gradient, jacobian
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...spatial.moments import Inertia
from ..recursion.recursion_boundary import summed
from .inertia import of_body
from .kinematics import Kinematics


def kinetic(k: Kinematics, rotors: Mapping[int, Matrix]) -> Scalar:
    """Kinetic energy of bodies and rotors; it contains t where motions are prescribed.

    ``energy = sum (1/2 [omega; v] . inertia [omega; v] - m g . c)``, with the work of gravity.
    """
    k.graph.describe(kinetic)
    parts = []
    for i in range(len(k.system.bodies)):
        with k.graph.made_by(k.owner(i), "energy"):
            inertia, twist = of_body(k, i), Matrix.vstack(k.omega[i], k.v[i])
            parts.append(twist.dot(inertia.momentum(twist)) * 0.5)
    spins = [(i, k.u(i).dot(rotor @ k.u(i)) * 0.5) for i, rotor in rotors.items()]
    return total(k, "kinetic_energy", parts, spins)


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
    return total(k, "potential_energy", weights(k, gravity))


def weights(k: Kinematics, gravity: Matrix) -> list[Scalar]:
    """Potential energy of every body in a field of gravity (3, 1)."""
    parts = []
    for i in range(len(k.system.bodies)):
        with k.graph.made_by(k.owner(i), "energy"):
            parts.append(-gravity.dot(ground_moment(k, i, of_body(k, i))))
    return parts


def total(
    k: Kinematics, quantity: str, parts: Sequence[Scalar], more: Sequence[tuple[int, Scalar]] = ()
) -> Scalar:
    """The sum of a number of every body and of more at some; as a recursion body by body.

    Args:
        k: Motion of the tree.
        quantity: Name of the sum.
        parts: Of every body.
        more: (body, number).
    """
    here = list(parts)
    if k.cuts is None or not here:
        return sum((number for _, number in more), start=sum(here, Scalar(k.graph, ZERO)))
    for body, number in more:
        here[body] = here[body] + number
    return summed(k, quantity, [Matrix(k.graph, 1, 1, [part.node]) for part in here])[0]


def ground_moment(k: Kinematics, i: int, inertia: Inertia) -> Matrix:
    """First moment of a body about the ground origin, ground axes."""
    return k.ground_position[i] * inertia.mass + k.ground_rotation[i] @ inertia.moment
