"""Sparse systems with constraints whose unknowns come in blocks, by the solver of the runtime."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from hashlib import sha256
from typing import final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csr_array

from ...arrays import Array, Booleans
from ...errors import SolveError
from ...records import dataclass
from ...runtime.models.finite_elements.tables import Tables
from ...runtime.sparse.block_solver import BlockSolver, solution, solver
from ...runtime.sparse.plan import Plan, plan
from ...runtime.sparse.systems import balanced
from .saddle_point import Matrix, Singular

Longs = NDArray[np.int64]
CACHED_PATTERNS = 4  # patterns: of searches and of eigenvalues
MOTION = 1e-3  # of a direction without units: below this part nothing moves along it


@dataclass(frozen=True, eq=False)
class _PlannedPattern:
    """A pattern that was planned.

    Attributes:
        plan: The plan.
        order, place: Which unknown stands where in it, and where each unknown stands (n + m,).
        at: Where the numbers of K, G and Gᵀ go in its values.
    """

    plan: Plan
    order: Longs
    place: Longs
    at: Longs


@final
@dataclass(frozen=True, eq=False)
class Near:
    """Factors of [K -Gᵀ; G 0]; of a singular one those of one next to it with other pivots.

    Attributes:
        solve, solve_transposed: For a right-hand side (n + m,), or several (n + m, k).
        sign: Of the determinant; 0 where it is not known.
        below: Eigenvalues below 0 of a symmetric K on what G allows; None where not known.
    """

    solve: Callable[[Array], Array]
    solve_transposed: Callable[[Array], Array]
    sign: float
    below: int | None


@final
@dataclass(eq=False)
class SparseSaddle:
    """Factors [K Gᵀ; G 0] block by block; plans of the last patterns are kept.

    Attributes:
        places: First speed of every place, and how many there are (places + 1,). What comes behind
            them, such as internal states, has places of its own.
        massless: Which places may have nothing on their diagonal (places,).
        elements: To which element every row of G belongs (m,). More rows stand for themselves.
    """

    places: NDArray[np.integer]
    massless: Booleans
    elements: NDArray[np.integer]
    _planned: dict[bytes, _PlannedPattern] = field(default_factory=dict)
    _plans: dict[bytes, Plan] = field(default_factory=dict)
    _units: dict[tuple[bytes, bool], tuple[Array, Array]] = field(default_factory=dict)
    _last: tuple[tuple[NDArray[np.integer], ...], bytes] = (), b""

    @classmethod
    def of(cls, tables: Tables) -> SparseSaddle:
        """The blocks of speeds and multipliers of elements in tables."""
        poses = np.array([kind.name == "node" for kind in tables.kinds], dtype=bool)
        elements, count = np.zeros(tables.m, dtype=np.intp), 0
        for number, group in enumerate(tables.groups):
            lines = tables.lines(number)
            elements[lines] = count + np.arange(len(group))[:, None]
            count += len(group)
        return cls(tables.u, ~poses[tables.kind], elements)

    def __call__(self, K: Matrix, G: Matrix) -> Callable[[Array], Array]:
        """Solver of [K Gᵀ; G 0] for a right-hand side (n + m,), or several (n + m, k).

        Raises:
            Singular: nothing holds an unknown; the solver, where no solution exists.
        """
        planned, by = self._factors(csr_array(K), csr_array(G), False)
        n = K.shape[0]

        def solve(right: Array) -> Array:
            sides = np.asarray(right, float)[planned.order].reshape(len(planned.order), -1)
            try:
                columns = [solution(by, side) for side in sides.T]
            except SolveError:
                raise Singular(_motion(by, planned.place[:n])) from None
            return np.stack(columns, axis=1)[planned.place].reshape(np.shape(right))

        return solve

    def near(self, K: Matrix, G: Matrix, symmetric: bool = False) -> Near:
        """Factors of [K -Gᵀ; G 0]; ``symmetric``: and eigenvalues of a symmetric K below 0."""
        planned, by = self._factors(csr_array(K), csr_array(G), symmetric)
        signs = np.where(np.arange(len(planned.order)) < K.shape[0], 1.0, -1.0)

        def solved(right: Array, transposed: bool) -> Array:
            solution: Array = by.solve(right[planned.order], transposed)
            return solution[planned.place]

        def solve(right: Array) -> Array:
            return (solved(right, False).T * signs).T

        def solve_transposed(right: Array) -> Array:
            return solved((right.T * signs).T, True)

        sign = 0.0 if len(by.shifts) else by.determinant()[0]
        below = _below(by, sign, G.shape[0]) if symmetric and sign else None
        return Near(solve, solve_transposed, sign, below)

    def counted(self, K: Matrix, G: Matrix, symmetric: bool) -> tuple[int | None, float]:
        """Eigenvalues below 0 of K on what G allows, and the sign of its determinant there.

        By Sylvester's law the rows of G add as many eigenvalues below 0 as above, and their part of
        the determinant has the sign (-1)^m.

        Returns:
            Their number, None where it is not known; 1, -1, or 0 where that is not known.
        """
        try:
            _planned, by = self._factors(csr_array(K), csr_array(G), symmetric)
        except Singular:
            return None, 0.0
        m, shifts = G.shape[0], by.shifts
        # as long as the matrix is further from a singular one than from the one that was factored
        if len(shifts) and not by.smallest()[0] > 2 * np.abs(shifts).max():
            return None, 0.0
        sign = by.determinant()[0]
        if not symmetric:
            return None, sign * (-1) ** m
        return _below(by, sign, m), sign * (-1) ** m

    def _factors(
        self, K: csr_array, G: csr_array, symmetric: bool
    ) -> tuple[_PlannedPattern, BlockSolver]:
        """Plan of the pattern of K and G, and its factors."""
        key = self._key((K.indptr, K.indices, G.indptr, G.indices))
        if key not in self._planned:
            if len(self._planned) == CACHED_PATTERNS:
                self._planned.clear()
                self._units.clear()
            self._planned[key] = self._look(K, G)
        planned = self._planned[key]
        values = np.bincount(
            planned.at, np.concatenate([K.data, G.data, G.data]), planned.plan.pattern.values
        ).astype(np.float64)
        by = solver(planned.plan)
        units = balanced(planned.plan, values, start=self._units.get((key, symmetric)))
        self._units[key, symmetric] = units
        try:
            by.factor(values, *units, symmetric=symmetric)
        except SolveError:
            raise Singular from None
        return planned, by

    def _key(self, parts: tuple[NDArray[np.integer], ...]) -> bytes:
        """A hash of a pattern; of the arrays that came last it is known."""
        last, key = self._last
        # arrays that are kept keep their memory: what lies there is the same pattern
        if not last or any(map(_differ, last, parts)):
            key = sha256(b"".join(part.tobytes() for part in parts)).digest()
            self._last = parts, key
        return key

    def _blocks(self, n: int, m: int) -> Longs:
        """The block of every unknown (n + m,)."""
        count, node_speeds = len(self.places) - 1, int(self.places[-1])
        speeds = np.repeat(np.arange(count), np.diff(self.places))
        single_speeds = count + np.arange(n - node_speeds)
        elements = np.unique(self.elements, return_inverse=True)[1]
        single_rows = int(elements.max(initial=-1)) + 1 + np.arange(m - len(self.elements))
        rows = count + (n - node_speeds) + np.concatenate([elements, single_rows])
        return np.concatenate([speeds, single_speeds, rows]).astype(np.int64)

    def _look(self, K: Matrix, G: Matrix) -> _PlannedPattern:
        """Plan matrices of the pattern of K and G."""
        n, m = K.shape[0], G.shape[0]
        block = self._blocks(n, m)
        order = np.argsort(block, kind="stable")
        place = np.empty_like(order)
        place[order] = np.arange(n + m)
        block = block[order]
        # triplets of [[K, G^T], [G, 0]] in the order of the blocks
        (down, across), (row, constrained) = (coo_array(x).coords for x in (K, G))
        i = place[np.concatenate([down, n + row.astype(np.int64), constrained])]
        j = place[np.concatenate([across, constrained, n + row.astype(np.int64)])]
        nb = int(block[-1]) + 1 if len(block) else 0
        pairs, pair = np.unique(block[i] * nb + block[j], return_inverse=True)
        sizes = np.bincount(block, minlength=nb)
        multiplier, massless = np.cumsum(sizes) > n, np.zeros(nb, bool)
        massless[: len(self.massless)] = self.massless
        coupled = np.stack(np.divmod(pairs, max(nb, 1)), 1)
        # the symbolic factorization depends on the pattern alone and is reused
        key = pairs.tobytes() + sizes.tobytes() + n.to_bytes(8, "little")
        if key not in self._plans:
            through = _through_rows(coupled, multiplier)
            self._plans.clear()
            self._plans[key] = plan(sizes, [coupled, through], multiplier, massless)
        pattern_plan = self._plans[key]
        matrix = pattern_plan.pattern
        entries = matrix.rows.astype(np.int64) * nb + matrix.column
        start = matrix.value[np.searchsorted(entries, pairs)][pair]
        at = start + (i - matrix.first[block[i]]) * matrix.stride[block[i]]
        return _PlannedPattern(pattern_plan, order, place, at + j - matrix.first[block[j]])


def _below(by: BlockSolver, sign: float, m: int) -> int | None:
    """Eigenvalues below 0 of K on what G (m, n) allows; None where pivots do not tell.

    Args:
        by: Factors of a symmetric matrix.
        sign: Of the determinant of these.
        m: Number of rows of G.
    """
    _, negative, zero = by.inertia()
    shifts = by.shifts
    # pivots that were replaced count as zero
    negative, zero = negative + int(np.sum(shifts < 0)), zero - len(shifts)
    return negative - m if zero == 0 and (-1) ** negative == sign else None


def _differ(a: NDArray[np.integer], b: NDArray[np.integer]) -> bool:
    """True unless two arrays are one part of memory."""
    return a.ctypes.data != b.ctypes.data or a.size != b.size or a.dtype != b.dtype


def _through_rows(coupled: Longs, multiplier: Booleans) -> Longs:
    """Blocks of speeds that meet in the rows of an element, which couples them."""
    rows = coupled[multiplier[coupled[:, 0]]]
    shape = (len(multiplier), len(multiplier))
    incidence = coo_array((np.ones(len(rows)), (rows[:, 0], rows[:, 1])), shape).tocsr()
    return np.stack((incidence.T @ incidence).nonzero(), 1).astype(np.int64)


def _motion(by: BlockSolver, speeds: Longs) -> Array | None:
    """The direction of speeds that is held least, None where rows contradict each other alone."""
    vector = by.smallest()[1]
    motion = vector[speeds]
    moved, all_of_it = np.abs(motion).max(initial=0.0), np.abs(vector).max(initial=0.0)
    return motion / np.linalg.norm(motion) if moved > MOTION * all_of_it else None
