"""Consistent inertia of a beam: the shape follows the positions and the axes of its ends."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import Scalar
from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines, Shapes
from .element_ends import NAMES, Ends
from .formulas import LINKED, SPIN_SHAPES
from .inertia import DENSITY, SHEAR, InertiaElement, cubic_share, spin
from .node_set import Motion, Pose
from .section import GRAVITY

# of p_1, p_2, t_1, t_2
LABELS = ("start", "end", "start_tangent", "end_tangent")


@dataclass(frozen=True)
class LinkedInertia(InertiaElement):
    """Mass of the cubic through both ends along their tangents, and of rotations between them.

    x is linear in the positions p_1, p_2 and in the tangents t_i = R_i e_1, so that the mass of
    these four vectors is constant:
    ``kinetic = 1/2 sum mass_ij x_i'·x_j' + 1/2 integral omega·rhoI omega``.

    Where shear is soft the cubic share is 1/(1 + Φ), that of the straight beam's own shape,
    Φ = 12 EI/(GA L²). Frequencies of bending are of fourth order with a beam that is exact for
    small displacements. Momentum, angular momentum and weight are those of the shape. Angular
    velocities vary linearly in section axes.

    Source: Archer, J. Structural Division ASCE 89 (1963); Przemieniecki, Theory of Matrix
        Structural Analysis (1968), section 11.4, for small displacements; its finite form is our
        own.
    """

    kind: ClassVar[str] = "linked_inertia"
    geometric: ClassVar[tuple[str, ...]] = ("length",)
    symbol_shapes: ClassVar[Shapes] = SPIN_SHAPES
    formulas: ClassVar[Lines] = LINKED

    @property
    def common(self) -> tuple[str, ...]:
        return (*DENSITY, *SHEAR, *GRAVITY)

    def loads(self, ends: Ends) -> list[Matrix]:
        gravity = ends.vector(*GRAVITY)
        poses, motions = _poses(ends)
        # accelerations against free fall, and those of the tangents in axes of their end
        linear = [
            (motion.acceleration - gravity).note(f"{name}_a")
            for motion, name in zip(motions, NAMES, strict=True)
        ]
        curved = [_tangent_acceleration(motion) for motion in motions]
        tangent_rates = [
            (pose.rotation @ c.note(f"{name}_own_tangent_a")).note(f"{name}_tangent_a")
            for pose, c, name in zip(poses, curved, NAMES, strict=True)
        ]
        mass = _mass(ends)
        inertia = spin(ends, 1 / 3)
        loads: list[Matrix] = []
        for i, (pose, motion) in enumerate(zip(poses, motions, strict=True)):
            other = motions[1 - i]
            name = NAMES[i]
            along = _combined(mass[2 + i], [*linear, *tangent_rates]).note(f"{name}_tangent_force")
            rate = inertia @ (motion.omega_rate + other.omega_rate * 0.5)
            momentum = (inertia @ (motion.omega + other.omega * 0.5)).note(f"{name}_spin")
            tangent_force = (pose.rotation.T @ along).note(f"{name}_own_tangent_force")
            moment = _about_axis(tangent_force) + rate + motion.omega.cross(momentum)
            force = _combined(mass[i], [*linear, *tangent_rates])
            loads += [moment.note(f"{name}_moment"), force.note(f"{name}_force")]
        return loads

    def energies(self, ends: Ends) -> tuple[Matrix, Matrix]:
        poses, motions = _poses(ends)
        mass, inertia = _mass(ends), spin(ends, 1 / 3)
        rates = _rates(poses, motions)
        one, two = (motion.omega for motion in motions)
        kinetic = one.T @ (inertia @ (one + two)) + two.T @ (inertia @ two)
        for i, rate in enumerate(rates):
            momentum = _combined(mass[i], rates).note(f"momentum_{LABELS[i]}")
            kinetic = kinetic + rate.T @ momentum
        gravity = ends.vector(*GRAVITY)
        weight = _combined(_column_sums(mass), _vectors(poses)).note("first_moment")
        return kinetic * 0.5, -(gravity.T @ weight)

    def momentum(self, ends: Ends) -> Matrix:
        poses, motions = _poses(ends)
        mass, inertia = _mass(ends), spin(ends, 1 / 3)
        rates, vectors = _rates(poses, motions), _vectors(poses)
        angular = Matrix.zeros(ends.graph, 3)
        for i, vector in enumerate(vectors):
            part = _combined(mass[i], rates).note(f"momentum_{LABELS[i]}")
            angular = angular + vector.cross(part)
        for i, pose in enumerate(poses):
            part = inertia @ (motions[i].omega + motions[1 - i].omega * 0.5)
            angular = angular + pose.rotation @ part.note(f"{NAMES[i]}_spin")
        return Matrix.vstack(angular, _combined(_column_sums(mass), rates))


def _poses(ends: Ends) -> tuple[list[Pose], list[Motion]]:
    return [ends.pose(k) for k in range(2)], [ends.motion(k) for k in range(2)]


def _mass(ends: Ends) -> list[list[Scalar]]:
    """Mass of p_1, p_2, t_1, t_2, symmetric (4, 4)."""
    length = ends.number("length")
    total = ends.number("rhoA") * length
    share = cubic_share(ends)
    # integrals of the squares of 1, of what is odd, and of its product with the cubic
    odd = (1 / 12 + share / 30.0 + share * share / 210.0).note("odd")
    mixed = (share / 120.0 + share * share / 420.0).note("mixed")
    cubic = (share * share / 840.0).note("cubic")
    first, second = total.note("mass") * length, total * length * length
    pp, pq = (total * (0.25 + odd)).note("mass_pp"), (total * (0.25 - odd)).note("mass_pq")
    pt, pu = first * (1 / 24 + mixed), first * (mixed - 1 / 24)
    tt, tu = second * (1 / 120 + cubic), second * (cubic - 1 / 120)
    for entry, word in ((pt, "pt"), (pu, "pu"), (tt, "tt"), (tu, "tu")):
        entry.note(f"mass_{word}")
    return [[pp, pq, pt, pu], [pq, pp, -pu, -pt], [pt, -pu, tt, tu], [pu, -pt, tu, tt]]


def _column_sums(mass: list[list[Scalar]]) -> list[Scalar]:
    """Sums of columns: a rigid shift of both ends."""
    return [a + b for a, b in zip(mass[0], mass[1], strict=True)]


def _combined(factors: list[Scalar], vectors: list[Matrix]) -> Matrix:
    total = Matrix.zeros(vectors[0].graph, 3)
    for factor, vector in zip(factors, vectors, strict=True):
        total = total + vector * factor
    return total


def _axis(graph_of: Matrix) -> Matrix:
    return Matrix.vector(graph_of.graph, [1.0, 0.0, 0.0])


def _about_axis(force: Matrix) -> Matrix:
    """e_1 x f."""
    return _axis(force).cross(force)


def _tangent_acceleration(motion: Motion) -> Matrix:
    """Second derivative of the tangent in axes of its end."""
    axis = _axis(motion.omega)
    return motion.omega_rate.cross(axis) + motion.omega.cross(motion.omega.cross(axis))


def _vectors(poses: list[Pose]) -> list[Matrix]:
    """p_1, p_2, t_1, t_2."""
    return [pose.position for pose in poses] + [pose.rotation.column(0) for pose in poses]


def _rates(poses: list[Pose], motions: list[Motion]) -> list[Matrix]:
    """Derivatives of p_1, p_2, t_1, t_2."""
    tangent_rates = [
        (pose.rotation @ motion.omega.cross(_axis(motion.omega))).note(f"{name}_tangent_rate")
        for pose, motion, name in zip(poses, motions, NAMES, strict=True)
    ]
    return [motion.velocity for motion in motions] + tangent_rates
