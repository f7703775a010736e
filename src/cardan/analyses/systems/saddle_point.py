"""Linear systems with constraints, K x - Gᵀ y = a and G x = b, without units.

Dense ones go through a basis of what G allows: redundant constraints and directions that nothing
holds show as such. Sparse ones are factored as they stand.

Source: M. Benzi, G. H. Golub, J. Liesen, Acta Numerica 14 (2005), sections 5 and 6 (null space).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar, Protocol, TypeAlias, final

import numpy as np
from scipy.linalg.lapack import dgecon, dgetrf, dgetrs
from scipy.sparse import block_array, csc_array, csr_array, diags_array
from scipy.sparse.linalg import ArpackError, LinearOperator, eigs, eigsh, splu

from ...arrays import Array, Complex
from ...errors import SolveError
from ...records import dataclass

Matrix: TypeAlias = Any  # an array, or a sparse one of scipy
Factored: TypeAlias = Callable[[Array], Array]
Factor: TypeAlias = Callable[[Matrix, Matrix], Factored]
Count: TypeAlias = Callable[[Matrix, Matrix, bool], tuple[int | None, float]]
RANK, ROUGH = 1e-9, 1e-2  # singular values of G below this part of the largest hold nothing
FULL = 300  # unknowns up to which full matrices are quick, and show what is singular
WEAK, REFINED = 1e-9, 2  # what redundant multipliers give way; corrections
SMALL = 24  # directions that are all looked at
OPEN, ROUNDING = 1e-8, 1e-13  # forces along loose directions: of all forces, of K
REGULAR = 1e-10  # reciprocal condition numbers above which nothing is loose
SKEW = 1e-11  # above this forces have no potential: 1e5 times the rounding of a projection
FREE_TOL = 1e-13  # of K on what G allows: below this part of the largest nothing holds
# stiffnesses and forces along them, of the largest stiffness, that may be rounding alone
ROUNDED, PUSHED = 5e-16, 4e-15
GROWTH = 4.0  # of shifts, until they are below all eigenvalues
PROBES = 3  # products that tell how large a projected matrix is


class Singular(SolveError):
    """The system has no solution; what it leaves free.

    Attributes:
        motion: A direction (n,) that nothing holds, None where it is not known.
    """

    def __init__(self, motion: Array | None = None) -> None:
        super().__init__(
            "the stiffness and the constraints of this position have no common solution: something "
            "is free to move, or numbers are not finite. Support it, or hold it: "
            "locked={'...': value}"
        )
        self.motion = motion


@dataclass(frozen=True, eq=False)
class Lowest:
    """The weakest directions of a stiffness on what constraints allow.

    Attributes:
        values: Eigenvalues of its symmetric part, from the lowest (k,).
        vectors: Their directions (n, k).
        largest: Against which they are small or not.
        skew: Size of its skew part on what constraints allow, over ``largest``.
        below: Eigenvalues below 0, counted by signs of pivots; None where they were not.
        firmly: Eigenvalues below all rounding, counted likewise where some are not.
        sign: Of the determinant of the stiffness on what constraints allow, skew part included;
            0 where that is not known.
    """

    values: Array
    vectors: Array
    largest: float
    skew: float = 0.0
    below: int | None = None
    sign: float = 0.0
    firmly: int | None = None

    @property
    def signed(self) -> int:
        """Eigenvalues below 0, rounding or not."""
        return int(np.sum(self.values < 0)) if self.below is None else self.below

    @property
    def negative(self) -> int:
        """Directions in which it pushes away: beyond rounding."""
        counted = self.firmly if self.free_directions.size else self.below
        if counted is not None:
            return counted
        return int(np.sum(self.values < -FREE_TOL * self.largest))

    @property
    def free_directions(self) -> Array:
        """Directions (n, k) in which it does nothing."""
        return self.vectors[:, np.abs(self.values) <= FREE_TOL * self.largest]


class Saddle(Protocol):
    """A way to solve systems with constraints."""

    def solve(self, K: Any, G: Any, a: Array, b: Array) -> tuple[Array, Array]:
        """x and y with K x - Gᵀ y = a and G x = b; the smallest of several.

        Args:
            K, G: (n, n), (m, n).
            a, b: (n,), (m,); or columns of several (n, k), (m, k).

        Raises:
            Singular: there is none.
        """

    def lowest(self, K: Any, G: Any) -> Lowest:
        """The weakest directions of K on what G allows.

        Raises:
            Singular: they are not found, or numbers are not finite.
        """


@final
class Dense:
    """LAPACK on arrays."""

    def solve(self, K: Array, G: Array, a: Array, b: Array) -> tuple[Array, Array]:
        """Same as :meth:`Saddle.solve`; of redundant constraints the smallest multipliers too."""
        if not (np.isfinite(K).all() and np.isfinite(G).all()):
            raise Singular
        # redundant rows look independent as far as they are open
        U, s, Z, V = split(G, max(RANK, min(ROUGH, 3 * float(np.abs(b).max(initial=0.0)))))
        s = s.reshape(-1, *[1] * (a.ndim - 1))
        x = V @ ((U.T @ b) / s)
        inner = Z.T @ K @ Z
        if inner.size:
            x = x + Z @ _regular(inner, Z.T @ (a - K @ x), Z)
        return x, -(U @ ((V.T @ (a - K @ x)) / s))

    def lowest(self, K: Array, G: Array) -> Lowest:
        """Same as :meth:`Saddle.lowest`: all directions."""
        if not (np.isfinite(K).all() and np.isfinite(G).all()):
            raise Singular
        Z = split(G)[2]
        inner = Z.T @ K @ Z
        if not inner.size:
            return Lowest(np.zeros(0), np.zeros((len(K), 0)), 0.0)
        values, vectors = np.linalg.eigh(0.5 * (inner + inner.T))
        largest = float(np.abs(K).max())
        skew = float(np.abs(inner - inner.T).max()) / max(largest, 1e-300)
        return Lowest(values, Z @ vectors, largest, skew, sign=float(np.linalg.slogdet(inner)[0]))


def split(G: Array, part: float = RANK) -> tuple[Array, Array, Array, Array]:
    """U (m, k), s (k,), Z (n, n - k), V (n, k): G = U s Vᵀ, and G Z = 0.

    Args:
        G: (m, n).
        part: Of the largest singular value, below which others count as zero.
    """
    U, s, Vt = np.linalg.svd(G, full_matrices=True)
    rank = int(np.sum(s > part * s.max(initial=0.0)))
    return U[:, :rank], s[:rank], Vt[rank:].T, Vt[:rank].T


def _regular(inner: Array, right: Array, Z: Array) -> Array:
    """The smallest solution of a system; refused where it is singular and has none."""
    if not (np.isfinite(inner).all() and np.isfinite(right).all()):
        raise Singular
    if (solution := _quick(inner, right)) is not None:
        return solution
    U, s, Vt = np.linalg.svd(inner)
    along, largest = U.T @ right, max(float(s[0]), 1e-300)
    # a soft direction is followed where more than rounding pushes along it: next to a limit load
    pushed = np.abs(along).reshape(len(s), -1).max(axis=1) > PUSHED * largest
    firm = (s > FREE_TOL * largest) | (pushed & (s > ROUNDED * largest))
    solution = Vt[firm].T @ (along[firm] / s[firm].reshape(-1, *[1] * (right.ndim - 1)))
    left = along[~firm]
    if len(left) and np.abs(left).max() > max(OPEN * np.abs(right).max(), ROUNDING * s[0]):
        # along what nothing holds something pushes
        push = Vt[~firm].T @ (Vt[~firm] @ right.reshape(len(right), -1)[:, 0])
        raise Singular(Z @ (push if np.any(push) else Vt[-1]))
    return np.asarray(solution)


def _quick(inner: Array, right: Array) -> Array | None:
    """The solution by LU; None of a matrix that is close to a singular one."""
    lu, swaps, status = dgetrf(inner)
    if status or dgecon(lu, np.abs(inner).sum(axis=0).max())[0] < REGULAR:
        return None
    solution: Array = dgetrs(lu, swaps, right)[0]
    return solution.reshape(right.shape)


def joined(K: Matrix, G: Matrix) -> Matrix:
    """[K Gᵀ; G 0], in columns."""
    return csc_array(block_array([[K, G.T], [G, None]]) if G.shape[0] else K)


def factored(K: Matrix, G: Matrix, weak: float = 0.0) -> Factored:
    """Solver of [K Gᵀ; G -weak] for one right-hand side, by SuperLU.

    Raises:
        Singular: it has no unique solution.
    """
    matrix, n = joined(K, G), K.shape[0]
    if weak:
        amount = weak / max(float(abs(K).max()), 1e-300)
        diagonal = np.concatenate([np.zeros(n), np.full(G.shape[0], amount)])
        matrix = csc_array(matrix - diags_array(diagonal))
    try:
        solve: Factored = splu(matrix).solve
    except RuntimeError:
        raise Singular from None
    return solve


def _giving_way(K: Matrix, G: Matrix) -> Factored:
    """The same where redundant multipliers give way a little."""
    return factored(K, G, WEAK)


def uncounted(K: Matrix, G: Matrix, symmetric: bool) -> tuple[int | None, float]:
    """Nothing of what signs of pivots tell."""
    return None, 0.0


@final
@dataclass(frozen=True)
class Sparse:
    """Sparse matrices; small ones as full ones.

    Attributes:
        factored: ``factored(K, G)`` gives a solver of [K Gᵀ; G 0] for one right-hand side.
        counted: ``counted(K, G, symmetric)`` gives ``below`` and ``sign`` of :class:`Lowest`.
    """

    COUNT: ClassVar = 6
    factored: Factor = factored
    counted: Count = uncounted

    def solve(self, K: Matrix, G: Matrix, a: Array, b: Array) -> tuple[Array, Array]:
        """Same as :meth:`Saddle.solve`; redundant constraints share their forces."""
        right = np.concatenate([a, b])
        if len(right) <= FULL:
            return Dense().solve(K.toarray(), G.toarray(), a, b)
        matrix, why = joined(K, G), Singular()
        for way in (self.factored, _giving_way):
            try:
                solution = _refined(matrix, way(K, G), right)
            except Singular as singular:
                # the first that knows what moves
                why = why if why.motion is not None else singular
                continue
            if solution is not None:
                return solution[: len(a)], -solution[len(a) :]
        raise why

    def lowest(self, K: Matrix, G: Matrix) -> Lowest:
        """Same as :meth:`Saddle.lowest`: those next to 0; from afar those of beams look alike."""
        if is_small(G):
            return Dense().lowest(K.toarray(), G.toarray())
        n, largest = K.shape[0], float(np.abs(K.data).max(initial=0.0))
        half = csr_array(0.5 * (K + K.T))
        unit, shift = diags_array(np.ones(n)), -FREE_TOL * largest
        skew = skewness(K, G, self.factored) / max(largest, 1e-300)
        symmetric = skew <= SKEW
        below, sign = self.counted(half if symmetric else K, G, symmetric)
        try:
            values, vectors = near(half, unit, G, shift, self.COUNT, self.factored)
            if symmetric and below is not None and below > np.sum(values < 0):
                # the lowest ones lie far from 0
                shift = -self._beyond(half, G, float(np.abs(values).max()))
                values, vectors = near(half, unit, G, shift, self.COUNT, self.factored)
        except ArpackError:
            raise Singular from None
        order = np.argsort(values)
        firmly, rounding = below, FREE_TOL * largest
        if symmetric and (np.abs(values) <= rounding).any():
            firmly = self.counted(csr_array(half + rounding * unit), G, True)[0]
        return Lowest(values[order], vectors[:, order], largest, skew, below, sign, firmly)

    def _beyond(self, half: Matrix, G: Matrix, amount: float) -> float:
        """An amount, or a multiple, that no eigenvalue below 0 exceeds."""
        unit = diags_array(np.ones(half.shape[0]))
        while self.counted(csr_array(half + amount * unit), G, True)[0]:
            amount *= GROWTH
        return amount


def skewness(K: Matrix, G: Matrix, by: Factor = factored) -> float:
    """Size of the skew part of K on what G allows: entries elsewhere do no work.

    Moments about axes that a joint holds have entries that no motion meets. The size is the norm,
    by a few products with the projected matrix; 0 where no entry is above rounding.

    Args:
        K, G: Sparse (n, n), (m, n).
        by: How matrices are factored.
    """
    n, m, skew_part = K.shape[0], G.shape[0], csr_array(K - K.T)
    if float(abs(skew_part).max()) <= SKEW * float(abs(K).max()) or not m:
        return float(abs(skew_part).max())
    onto = by(csr_array(diags_array(np.ones(n))), G)

    def projected(x: Array) -> Array:
        projection: Array = onto(np.concatenate([x, np.zeros(m)]))[:n]
        return projection

    x, size = projected(np.random.default_rng(0).normal(size=n)), 0.0
    for _ in range(PROBES):
        x = x / max(float(np.linalg.norm(x)), 1e-300)
        x = projected(skew_part @ x)
        size = max(size, float(np.linalg.norm(x)))
    return size


def is_small(G: Any) -> bool:
    """True when G (m, n) allows so few directions that all of them are looked at."""
    return bool(G.shape[1] - G.shape[0] <= SMALL)


def _refined(matrix: Matrix, solve: Any, right: Array) -> Array | None:
    """The solution of a system by factors of one next to it; None where it is not solved."""
    solution: Array = solve(right)
    for _ in range(REFINED):
        left = right - matrix @ solution
        solution = solution + solve(left)
    if not np.isfinite(solution).all():
        return None
    left, largest = right - matrix @ solution, float(abs(matrix).max())
    # what is left may be rounding of the solution, and of the right-hand side
    most = 1e-9 * np.abs(right).max(initial=0.0) + 1e-13 * largest * np.abs(solution).max(
        initial=0.0
    )
    return solution if np.abs(left).max(initial=0.0) <= most else None


def near(
    K: Any, M: Any, G: Any, shift: float, count: int, by: Factor = factored
) -> tuple[Array, Array]:
    """Eigenvalues next to a shift, and eigenvectors, of K x = value M x on what G allows.

    Args:
        K, M: Sparse and symmetric (n, n).
        G: What holds (m, n).
        shift: Not an eigenvalue itself.
        count: How many.
        by: How matrices are factored.
    """
    n, m = K.shape[0], G.shape[0]
    inverse = by(csr_array(K - shift * M), G)

    def apply(x: Array) -> Array:
        solution: Array = inverse(np.concatenate([np.ravel(x), np.zeros(m)]))[:n]
        return solution

    operator = LinearOperator((n, n), matvec=apply, dtype=np.float64)
    start = apply(np.random.default_rng(0).normal(size=n))
    count = min(count, n - m - 1)
    values, vectors = eigsh(K, count, M, sigma=shift, OPinv=operator, v0=start)
    return np.asarray(values), np.asarray(vectors)


def near_quadratic(
    K: Any, C: Any, M: Any, G: Any, shift: float, count: int, by: Factor = factored
) -> tuple[Complex, Complex]:
    """Eigenvalues next to a shift, and eigenvectors, of (v^2 M + v C + K) x = 0 on what G allows.

    Args:
        K, C, M: Sparse (n, n).
        G: What holds (m, n).
        shift: Real, and not an eigenvalue itself.
        count: How many.
        by: How matrices are factored.
    """
    n, m = K.shape[0], G.shape[0]
    solve = by(csr_array(K + shift * C + shift**2 * M), G)
    more = csr_array(C + shift * M)

    def apply(v: Array) -> Array:
        first, second = np.ravel(v)[:n], np.ravel(v)[n:]
        right = -(M @ second + more @ first)
        x: Array = solve(np.concatenate([right, np.zeros(m)]))[:n]
        return np.concatenate([x, first + shift * x])

    operator = LinearOperator((2 * n, 2 * n), matvec=apply, dtype=np.float64)
    start = apply(np.random.default_rng(0).normal(size=2 * n))
    count = min(count, 2 * (n - m) - 2)
    # in pairs, and with others that are infinite: room for them
    room = min(2 * n, max(3 * count + 2, 40))
    values, vectors = eigs(operator, count, v0=start, ncv=room)
    return shift + 1.0 / values, vectors[:n]


def fit(hard: Array, right: Array, desired: Array, target: Array) -> Array:
    """Solve equations exactly, and others as well as possible; the smallest of all solutions."""
    U, s, Z, V = split(hard)
    solution: Array = V @ ((U.T @ right) / s)
    if len(desired) and Z.shape[1]:
        solution = solution + Z @ np.linalg.lstsq(desired @ Z, target - desired @ solution, RANK)[0]
    return solution
