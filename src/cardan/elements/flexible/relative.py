"""From an energy of the relative pose of two ends to forces and tangents of the nodes.

The pose of end 2 seen from end 1 is a rotation r and a position d. Forces and tangents are made in
the six increments of these, rho in axes of end 2 and those of d in axes of end 1, and only then
told in those of the nodes: rotations R exp(dtheta), positions in ground axes.

Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), chapter 6; the exact tangents are
our own arrangement.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.short_rotations import HALF_COSINE, HALF_SINE, INVERSE_TANGENT, Slopes, slopes
from .element_ends import relative_rotation
from .node_set import Pose


@dataclass(frozen=True)
class Relative:
    """The pose of end 2 seen from end 1.

    Attributes:
        start, end: The two poses.
        turn: Rotation vector theta of r (3, 1) [rad], shorter than pi.
        position: d (3, 1) [m], from end 1 to end 2 in axes of end 1.
        rotation: r (3, 3), coordinates in axes of end 2 to those of end 1.
        inverse: a of the inverse tangent operator 1 + [v]/2 + a [v]², a function of |theta|².
        slope: D (3, 3): theta changes by D rho.
    """

    start: Pose
    end: Pose
    turn: Matrix
    position: Matrix
    rotation: Matrix
    inverse: Slopes
    slope: Matrix

    @staticmethod
    def of(start: Pose, end: Pose) -> Relative:
        """The pose of end 2 seen from end 1.

        ``pose = theta, d: exp[theta] = R_1ᵀ R_2 = r, d = R_1ᵀ (p_2 - p_1)``; theta' = D rho.
        """
        start.rotation.graph.describe(Relative.of)
        turn, rotation = relative_rotation(start, end)
        inverse = slopes(INVERSE_TANGENT, turn.dot(turn).note("theta_squared"), "a")
        slope = transport(turn, Slopes(0.5), inverse).note("D")
        span = (end.position - start.position).note("apart")
        position = (start.rotation.T @ span).note("d")
        return Relative(start, end, turn, position, rotation, inverse, slope)


def transport(turn: Matrix, first: Slopes, second: Slopes) -> Matrix:
    """U = 1 + first [theta] + second [theta]², (3, 3)."""
    g = turn.graph
    square = (turn.outer(turn) - Matrix.identity(g, 3) * turn.dot(turn)).note("theta_skew_squared")
    return Matrix.identity(g, 3) + turn.skew * first.value + square * second.value


def transport_slope(
    turn: Matrix, first: Slopes, second: Slopes, d: Matrix, word: str = "d"
) -> Matrix:
    """Derivative of U d by theta, (3, 3), with U of :func:`transport`; d is called ``word``."""
    across = turn.cross(d).note(f"theta_cross_{word}")
    twice = turn.cross(across).note(f"theta_cross_theta_cross_{word}")
    along = Matrix.identity(turn.graph, 3) * turn.dot(d).note(f"theta_dot_{word}")
    along = (along + turn.outer(d) - d.outer(turn) * 2.0).note(f"U_{word}_slope_along")
    change = across * (2.0 * first.first) + twice * (2.0 * second.first)
    change = change.note(f"U_{word}_slope_by_squared")
    return along * second.value - d.skew * first.value + change.outer(turn)


def transport_bend(turn: Matrix, first: Slopes, second: Slopes, d: Matrix, g: Matrix) -> Matrix:
    """Second derivative of g · U d by theta, symmetric (3, 3)."""
    identity = Matrix.identity(turn.graph, 3)
    c = d.cross(g).note("d_cross_force")
    once, both = turn.dot(c).note("theta_dot_d_cross_force"), g.dot(d).note("force_dot_d")
    along_g, along_d = turn.dot(g).note("theta_dot_force"), turn.dot(d)
    twice = (along_g * along_d - both * turn.dot(turn)).note("force_dot_theta_cross_theta_cross_d")
    r = (g * along_d + d * along_g - turn * (2.0 * both)).note("bend_by_theta")
    # terms of slopes with theta at one side, those of second slopes at both
    side = c * (2.0 * first.first) + r * (2.0 * second.first)
    side = side + turn * (2.0 * (first.second * once + second.second * twice))
    side = side.note("bend_side")
    round_about = 2.0 * (first.first * once + second.first * twice) - 2.0 * second.value * both
    round_about.note("bend_diagonal")
    pair = (g.outer(d) * second.value + turn.outer(side)).note("bend_pair")
    return pair + pair.T + identity * round_about


def mean_axes(turn: Matrix) -> tuple[Slopes, Slopes]:
    """Slopes of U where it rotates from axes of end 1 to those halfway, exp(-theta/2)."""
    x = turn.dot(turn)
    return -slopes(HALF_SINE, x, "half_sine"), slopes(HALF_COSINE, x, "half_cosine")


@dataclass(frozen=True)
class Response:
    """Force and tangent of an element in the increments of the relative pose.

    Attributes:
        moment, force: Derivatives of the energy by rho and by d (3, 1).
        by_rho: Derivative of the moment along rho (3, 3), its antisymmetric part [moment]/2.
        mixed: Derivative of the force along rho (3, 3).
        stretching: Derivative of the force by d, symmetric (3, 3).
    """

    moment: Matrix
    force: Matrix
    by_rho: Matrix
    mixed: Matrix
    stretching: Matrix


def forces(at: Relative, moment: Matrix, force: Matrix) -> list[Matrix]:
    """Forces that hold the ends: moment and force on end 1, on end 2.

    ``loads = [n x d - r m, -R_1 n, m, R_1 n]`` of m and n by rho and d.

    Moments are in axes of their end, forces in ground axes.

    Args:
        at: The relative pose.
        moment, force: What works along rho and along d (3, 1).
    """
    force.graph.describe(forces)
    on_end = (at.start.rotation @ force).note("force_on_end")
    first = (force.cross(at.position) - at.rotation @ moment).note("moment_on_start")
    return [first, -on_end, moment.note("moment_on_end"), on_end]


def tangent(at: Relative, response: Response) -> list[list[Matrix]]:
    """Derivatives of :func:`forces` along the increments of the ends: 4 x 4 blocks (3, 3).

    ``tangent = d(loads) along theta_1, p_1, theta_2, p_2: rho = theta_2 - rᵀ theta_1``.
    """
    response.force.graph.describe(tangent)
    R, r, d = at.start.rotation, at.rotation, at.position.skew
    moment, _, _, _ = forces(at, response.moment, response.force)
    # columns of end 1: rho = -rᵀ theta_1, d changes by [d] theta_1
    by_force = (response.stretching @ d - response.mixed @ r.T).note("force_by_start")
    by_moment = (response.mixed.T @ d - response.by_rho @ r.T).note("moment_by_start")
    pp = R.congruence(response.stretching).note("K_pp")
    p2 = (R @ response.mixed).note("K_p2")
    p1 = (R @ (by_force - response.force.skew).note("force_turned_by_start")).note("K_p1")
    inner = (by_moment + response.moment.skew @ r.T).note("moment_turned_by_start")
    diagonal = upper(response.force.skew @ d - r @ inner - d @ by_force, moment)
    return [
        [diagonal, -p1.T, by_moment.T, p1.T],
        [-p1, pp, -p2, -pp],
        [by_moment, -p2.T, response.by_rho, p2.T],
        [p1, -pp, p2, pp],
    ]


def moved(at: Relative, increments: Sequence[Matrix], first: Slopes, second: Slopes) -> Matrix:
    """Change of (theta, e), (6, 1), where e = U d.

    Args:
        at: The relative pose.
        increments: Of end 1 and 2: rotation in axes of the end, position in ground axes.
        first, second: What U is made of, see :func:`transport`.
    """
    turn_1, move_1, turn_2, move_2 = increments
    rho = (turn_2 - at.rotation.T @ turn_1).note("rho")
    d = at.start.rotation.T @ (move_2 - move_1).note("apart_step") + at.position.cross(turn_1)
    theta = (at.slope @ rho).note("theta_step")
    bent = transport_slope(at.turn, first, second, at.position)
    e = bent @ theta + transport(at.turn, first, second) @ d.note("d_step")
    return Matrix.vstack(theta, e.note("e_step"))


def upper(matrix: Matrix, moment: Matrix) -> Matrix:
    """A matrix X with X - Xᵀ = [moment], made of its upper triangle."""
    g, skew = matrix.graph, moment.skew
    nodes = [
        matrix.nodes[3 * i + j] if i <= j else g.add(matrix.nodes[3 * j + i], skew.nodes[3 * i + j])
        for i in range(3)
        for j in range(3)
    ]
    return Matrix(g, 3, 3, nodes)


def mirrored(matrix: Matrix) -> Matrix:
    """The symmetric matrix of an upper triangle."""
    n = matrix.rows
    nodes = [matrix.nodes[n * min(i, j) + max(i, j)] for i in range(n) for j in range(n)]
    return Matrix(matrix.graph, n, n, nodes)
