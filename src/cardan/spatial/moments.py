"""Mass m, first moment m c and inertia about the origin, as three numbers that add up.

They know no center of mass: nothing is divided by a mass, which may be zero here.
"""

from __future__ import annotations

from ..ir.arithmetic import Scalar
from ..ir.graph import ONE, ZERO
from ..ir.matrix import Matrix
from ..records import dataclass


@dataclass(frozen=True)
class Inertia:
    """Mass m, first moment h = m c (3, 1) and inertia tensor about the origin (3, 3)."""

    mass: Scalar
    moment: Matrix
    tensor: Matrix

    def __add__(self, other: Inertia) -> Inertia:
        return Inertia(
            self.mass + other.mass, self.moment + other.moment, self.tensor + other.tensor
        )

    @property
    def is_zero(self) -> bool:
        return self.mass.node == ZERO and self.moment.is_zero and self.tensor.is_zero

    def momentum(self, twist: Matrix) -> Matrix:
        """Angular and linear momentum (6, 1) of a twist (6, 1), about the origin."""
        w, v = twist.block(slice(0, 3)), twist.block(slice(3, 6))
        return Matrix.vstack(
            self.tensor @ w + self.moment.cross(v), v * self.mass - self.moment.cross(w)
        )


def second_moment(tensor: Matrix) -> Matrix:
    """Integral of x xᵀ dm from the inertia tensor: J = tr(I)/2 - I."""
    g = tensor.graph
    half = (tensor[0, 0] + tensor[1, 1] + tensor[2, 2]) * 0.5
    g.note(half.node, "half_trace")
    diagonal = [half.node if i == j else ZERO for i in range(3) for j in range(3)]
    return Matrix(g, 3, 3, diagonal) - tensor


def inertia_tensor(second: Matrix) -> Matrix:
    """The inertia tensor from the second moment: I = tr(J) - J."""
    g = second.graph
    rows = [
        [
            (second[(i + 1) % 3, (i + 1) % 3] + second[(i + 2) % 3, (i + 2) % 3])
            if i == j
            else -second[i, j]
            for j in range(3)
        ]
        for i in range(3)
    ]
    return Matrix.of(g, rows)


def planar_axis(r: Matrix) -> int | None:
    """0, 1 or 2 where r is structurally a rotation about that axis, else None."""
    for axis in range(3):
        a, b = (axis + 1) % 3, (axis + 2) % 3
        n = r.nodes
        zeros = (n[3 * axis + a], n[3 * axis + b], n[3 * a + axis], n[3 * b + axis])
        if n[4 * axis] == ONE and not any(zeros):
            return axis
    return None


def turn_symmetric(r: Matrix, x: Matrix) -> Matrix:
    """r X rᵀ for a rotation r and a symmetric X (3, 3).

    About a coordinate axis, c^2 + s^2 = 1 leaves four products of the 2 x 2 block:
    t = s (X_aa - X_bb) + 2 c X_ab, X_aa - s t, X_bb + s t, c t - X_ab.
    """
    axis = planar_axis(r)
    if axis is None:
        return r.congruence(x)
    a, b = (axis + 1) % 3, (axis + 2) % 3
    c, s = r[a, a], r[b, a]
    t = s * (x[a, a] - x[b, b]) + c * (x[a, b] + x[a, b])
    x.graph.note(t.node, "shear")
    entries = {
        (axis, axis): x[axis, axis],
        (a, a): x[a, a] - s * t,
        (b, b): x[b, b] + s * t,
        (a, b): c * t - x[a, b],
        (axis, a): c * x[axis, a] - s * x[axis, b],
        (axis, b): s * x[axis, a] + c * x[axis, b],
    }
    rows = [
        [entries[i, j] if (i, j) in entries else entries[j, i] for j in range(3)] for i in range(3)
    ]
    return Matrix.of(x.graph, rows)


def turn_general(r: Matrix, x: Matrix) -> Matrix:
    """r X rᵀ for a rotation r and any X (3, 3): symmetric and skew parts turn separately."""
    axis = planar_axis(r)
    if axis is None:
        return r @ x @ r.T
    a, b = (axis + 1) % 3, (axis + 2) % 3
    c, s = r[a, a], r[b, a]
    t = s * (x[a, a] - x[b, b]) + c * (x[a, b] + x[b, a])
    entries = {
        (axis, axis): x[axis, axis],
        (a, a): x[a, a] - s * t,
        (b, b): x[b, b] + s * t,
        (a, b): c * t - x[b, a],
        (b, a): c * t - x[a, b],
        (axis, a): c * x[axis, a] - s * x[axis, b],
        (axis, b): s * x[axis, a] + c * x[axis, b],
        (a, axis): c * x[a, axis] - s * x[b, axis],
        (b, axis): s * x[a, axis] + c * x[b, axis],
    }
    return Matrix.of(x.graph, [[entries[i, j] for j in range(3)] for i in range(3)])


def moved(inertia: Inertia, p: Matrix) -> Inertia:
    """The same body about a point from which its origin is seen at p."""
    m, g = inertia.mass, p.graph
    if not any(inertia.moment.nodes):
        s, second = _of_mass(m, p)
        shift = Matrix.identity(g, 3) * s.dot(p) - second
        return Inertia(m, s, inertia.tensor + shift)
    s = (inertia.moment + p * (m * 0.5)).note("mean_moment")
    twice = s.dot(p) * 2
    g.note(twice.node, "shift")
    rows = [
        [(twice - s[i] * p[i] * 2) if i == j else -(s[i] * p[j] + s[j] * p[i]) for j in range(3)]
        for i in range(3)
    ]
    return Inertia(m, inertia.moment + p * m, inertia.tensor + Matrix.of(g, rows))


def moved_second(mass: Scalar, moment: Matrix, second: Matrix, p: Matrix) -> Matrix:
    """Second moment about a point from which the origin is seen at p."""
    if not any(moment.nodes):
        return second + _of_mass(mass, p)[1]
    s = (moment + p * (mass * 0.5)).note("mean_moment")
    upper = {(i, j): s[i] * p[j] + s[j] * p[i] for i in range(3) for j in range(i, 3)}
    rows = [[upper[min(i, j), max(i, j)] for j in range(3)] for i in range(3)]
    return second + Matrix.of(p.graph, rows)


def _of_mass(mass: Scalar, p: Matrix) -> tuple[Matrix, Matrix]:
    """First moment m p (3, 1) and second moment m p pᵀ, symmetric (3, 3), of a point of mass."""
    s = (p * mass).note("mass_moment")
    rows = [[s[min(i, j)] * p[max(i, j)] for j in range(3)] for i in range(3)]
    return s, Matrix.of(p.graph, rows)
