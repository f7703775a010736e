"""The equations of Gibbs and Appell: the energy of acceleration differentiated by udot.

G = sum over bodies of 1/2 integral a . a dm, in which a contains udot, and gravity as an
acceleration of the ground. With a of the origin of a body, its angular velocity and acceleration,

    G = 1/2 m a.a + a.(alpha x h + omega x (omega x h))
        + 1/2 alpha.I alpha + alpha.(omega x I omega)

up to what has no udot; h and I are first moment and inertia about the origin. Accelerations are the
velocities differentiated. dG/dudot = M udot + h for any generalized speeds.

Source: Gibbs, Am. J. Math. 2 (1879); Appell, J. reine angew. Math. 121 (1900); Lurie, Analytical
Mechanics (2002), sections 8.1 to 8.3.
"""

from __future__ import annotations

from ...ir.arithmetic import Scalar
from ...ir.derivative import gradient, jacobian
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ..kinematics.inertia import of_body
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads
from ..kinematics.partial_velocities import generalized_forces
from ..kinematics.rotation_rates import derivative
from .formalism import Formalism, within_bodies


def _udot(k: Kinematics) -> Matrix:
    """The accelerations by which G is differentiated."""
    nu = k.system.nu
    return Matrix(k.graph, nu, 1, [k.graph.var("udot", slot) for slot in range(nu)])


def gibbs(k: Kinematics, loads: Loads, gravity: Matrix, moving: bool = True) -> Scalar:
    """G as a function of ``_udot``; without ``moving`` speeds and prescribed motions rest.

    ``gibbs = sum of 1/2 m a·a + 1/2 alpha·I alpha + a·(alpha x h + omega x (omega x h)) + ...``.
    """
    k.graph.describe(gibbs)
    g, total = k.graph, Scalar(k.graph, ZERO)
    for i in range(len(k.system.bodies)):
        inertia, omega, v = of_body(k, i), k.omega[i], k.v[i]
        with g.made_by(k.owner(i), "gibbs"):
            alpha, a = _changed(k, omega, moving), _changed(k, v, moving)
            a = a - k.ground_rotation[i].T @ gravity
            rotated = inertia.tensor @ alpha
            field = alpha.cross(inertia.moment)
            if moving:
                a = a + omega.cross(v)
                field = field + omega.cross(omega.cross(inertia.moment))
                total = total + alpha.dot(omega.cross(inertia.tensor @ omega))
            total = total + (a.dot(a) * inertia.mass + alpha.dot(rotated)) * 0.5 + a.dot(field)
    for i, rotor in loads.rotors.items():
        spin = _changed(k, k.speeds[i], moving)
        total = total + spin.dot(rotor @ spin) * 0.5
    return total


def _changed(k: Kinematics, x: Matrix, moving: bool) -> Matrix:
    """Time derivative of a velocity, with udot."""
    total = derivative(k, x) if moving else Matrix.zeros(k.graph, x.rows)
    for slot, column in k.partials_of(x).items():
        total = total + column * _udot(k)[slot]
    return total


def _differentiated(k: Kinematics, function: Scalar) -> Matrix:
    """dG/dudot (nu, 1)."""
    nodes = gradient(k.graph, function.node, _udot(k).nodes)
    return Matrix(k.graph, len(nodes), 1, nodes)


def mass_matrix(k: Kinematics, loads: Loads) -> Matrix:
    """M (nu, nu): second derivatives of G."""
    still = Matrix.zeros(k.graph, 3)
    function = _differentiated(k, gibbs(k, loads, still, moving=False))
    rows = jacobian(k.graph, function.nodes, _udot(k).nodes)
    # mixed derivatives agree: the lower triangle stands for both
    return Matrix(k.graph, len(rows), len(rows), [x for row in rows for x in row]).mirrored


def bias(k: Kinematics, loads: Loads, gravity: Matrix, moving: bool = True) -> Matrix:
    """h (nu, 1): dG/dudot at udot = 0."""
    function = _differentiated(k, gibbs(k, loads, gravity, moving))
    zero_udot = dict.fromkeys(_udot(k).nodes, ZERO)
    return Matrix(
        k.graph, function.rows, 1, rebuild(k.graph, function.nodes, zero_udot, into=k.graph)[1]
    )


def inverse(k: Kinematics, udot: Matrix, loads: Loads, gravity: Matrix) -> Matrix:
    """tau (nu, 1) with dG/dudot = f + tau."""
    function = _differentiated(k, gibbs(k, loads, gravity))
    values = dict(zip(_udot(k).nodes, udot.nodes, strict=True))
    nodes = rebuild(k.graph, function.nodes, values, into=k.graph)[1]
    return Matrix(k.graph, function.rows, 1, nodes) - generalized_forces(k, loads)


GIBBS_APPELL = Formalism(
    "gibbs_appell",
    "the energy of acceleration differentiated by udot",
    "Gibbs, Am. J. Math. 2 (1879); Appell, J. reine angew. Math. 121 (1900); Lurie, Analytical "
    "Mechanics (2002), sections 8.1 to 8.3.",
    mass_matrix,
    bias,
    generalized_forces,
    inverse,
    rewrites=within_bodies,
    refused=("parallel",),
)
