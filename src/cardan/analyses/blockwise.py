"""Sparse systems with constraints whose unknowns come in blocks, by the solver of the runtime."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import block_array, coo_array

from ..errors import SolveError
from ..runtime.absolute.plan import Plan, plan
from ..runtime.absolute.solver import Solver, balanced, solution, solver
from .saddle import Array, Matrix, Singular

Longs = NDArray[np.int64]
MOTION = 1e-3  # of a direction without units: below this part nothing moves along it


@final
@dataclass(eq=False)
class Blockwise:
    """Factors [K Gᵀ; G 0] block by block; plans of matrices of one pattern are kept.

    Attributes:
        places: First speed of every place, and how many there are (places + 1,). What comes behind
            them, such as internal states, has places of its own.
        massless: Which places may have nothing on their diagonal (places,).
        elements: To which element every row of G belongs (m,). More rows stand for themselves.
    """

    places: NDArray[np.integer]
    massless: NDArray[np.bool_]
    elements: NDArray[np.integer]
    _plans: dict[bytes, Plan] = field(default_factory=dict)

    def __call__(self, K: Matrix, G: Matrix) -> Callable[[Array], Array]:
        """Solver of [K Gᵀ; G 0] for a right-hand side (n + m,), or several (n + m, k).

        Raises:
            Singular: nothing holds an unknown; the solver, where no solution exists.
        """
        n, m = K.shape[0], G.shape[0]
        block, order = self._blocks(n, m)
        place = np.empty_like(order)
        place[order] = np.arange(n + m)
        whole = coo_array(block_array([[K, G.T], [G, None]]) if m else K)
        i, j = place[whole.coords[0]], place[whole.coords[1]]
        made, values = self._filled(block[order], n, i, j, whole.data)
        by = solver(made)
        try:
            by.factor(values, *balanced(made, values))
        except SolveError:
            raise Singular from None

        def solve(right: Array) -> Array:
            sides = np.asarray(right, float)[order].reshape(n + m, -1)
            try:
                found = [solution(by, side) for side in sides.T]
            except SolveError:
                raise Singular(_motion(by, place[:n])) from None
            return np.stack(found, axis=1)[place].reshape(np.shape(right))

        return solve

    def _blocks(self, n: int, m: int) -> tuple[Longs, Longs]:
        """The block of every unknown (n + m,), and the order in which blocks stand together."""
        count, known = len(self.places) - 1, int(self.places[-1])
        speeds = np.repeat(np.arange(count), np.diff(self.places))
        own = count + np.arange(n - known)
        elements = np.unique(self.elements, return_inverse=True)[1]
        rest = int(elements.max(initial=-1)) + 1 + np.arange(m - len(self.elements))
        rows = count + (n - known) + np.concatenate([elements, rest])
        block = np.concatenate([speeds, own, rows]).astype(np.int64)
        return block, np.argsort(block, kind="stable")

    def _filled(self, block: Longs, n: int, i: Longs, j: Longs, data: Array) -> tuple[Plan, Array]:
        """The plan of a matrix with entries (i, j), and its values."""
        nb = int(block[-1]) + 1 if len(block) else 0
        pairs, pair = np.unique(block[i] * nb + block[j], return_inverse=True)
        sizes = np.bincount(block, minlength=nb)
        key = np.concatenate([sizes, [n], pairs]).tobytes()
        if key not in self._plans:
            multiplier = np.cumsum(sizes) > n
            massless = np.zeros(nb, bool)
            massless[: len(self.massless)] = self.massless
            coupled = np.stack(np.divmod(pairs, max(nb, 1)), 1)
            cliques = [coupled, _through_rows(coupled, multiplier)]
            self._plans.clear()
            self._plans[key] = plan(sizes, cliques, multiplier, massless)
        made = self._plans[key]
        matrix = made.pattern
        known = matrix.rows.astype(np.int64) * nb + matrix.column
        start = matrix.value[np.searchsorted(known, pairs)][pair]
        down, across = i - matrix.first[block[i]], j - matrix.first[block[j]]
        at = start + down * matrix.stride[block[i]] + across
        return made, np.bincount(at, data, matrix.values).astype(np.float64)


def _through_rows(coupled: Longs, multiplier: NDArray[np.bool_]) -> Longs:
    """Blocks of speeds that meet in the rows of an element, which couples them."""
    rows = coupled[multiplier[coupled[:, 0]]]
    shape = (len(multiplier), len(multiplier))
    held = coo_array((np.ones(len(rows)), (rows[:, 0], rows[:, 1])), shape).tocsr()
    return np.stack((held.T @ held).nonzero(), 1).astype(np.int64)


def _motion(by: Solver, speeds: Longs) -> Array | None:
    """The direction of speeds that is held least, None where rows contradict each other alone."""
    found = by.smallest()[1]
    motion = found[speeds]
    moved, all_of_it = np.abs(motion).max(initial=0.0), np.abs(found).max(initial=0.0)
    return motion / np.linalg.norm(motion) if moved > MOTION * all_of_it else None
