"""Factors of a stiffness matrix, which say at which row it is singular."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from ..errors import ModelError
from .elimination_order import nested_dissection

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

# least stiffness of a shape, of that of its rows alone: rounding leaves 1e-17 to 1e-16, a beam of
# 2000 elements has 3e-14
SINGULAR = 2e-15
SWEEPS = 4  # of the search for the softest shape


class Factor:
    """Solutions of ``K x = f`` for a sparse positive definite K.

    Args:
        K: Stiffness, by columns.
        places: Position of each row [m] (n, 3), by which the order of elimination is chosen.
        label: Name of a row in messages.
        where: What K is, in messages.
        cure: What to do where it is singular.

    Raises:
        ModelError: K is singular or indefinite; it names a row that moves.

    Source: X. S. Li, An overview of SuperLU, ACM TOMS 31 (2005).
    """

    def __init__(
        self, K: Sparse, places: Array, label: Callable[[int], str], where: str, cure: str
    ) -> None:
        from scipy.sparse import diags
        from scipy.sparse.linalg import splu

        self.size = K.shape[0]
        if not self.size:
            return
        diagonal = K.diagonal()
        unsupported = np.flatnonzero(diagonal <= 0)
        if len(unsupported):
            raise ModelError(f"{where} has no stiffness at {label(int(unsupported[0]))}: {cure}")
        # rows in units of their own stiffness: forces and moments compare
        self._scale = 1 / np.sqrt(diagonal)
        scaling = diags(self._scale)
        scaled = (scaling @ K @ scaling).tocsc()
        self._order = nested_dissection(scaled, places)
        ordered = scaled[self._order][:, self._order]
        options = {"SymmetricMode": True}
        try:
            self._factors = splu(
                ordered.tocsc(), permc_spec="NATURAL", diag_pivot_thresh=0.0, options=options
            )
        except RuntimeError:
            # exactly singular: a little more stiffness shows the shape
            self._factors = splu(
                (ordered + diags(np.full(self.size, SINGULAR))).tocsc(),
                permc_spec="NATURAL",
                options=options,
            )
        self._check(scaled, label, where, cure)

    def solve(self, force: Array) -> Array:
        """Displacements (n,) or (n, k) by forces."""
        if not self.size:
            return force
        scale = self._scale if force.ndim == 1 else self._scale[:, None]
        solution: Array = scale * self._solve(scale * force)
        return solution

    def _solve(self, force: Array) -> Array:
        """Of the scaled stiffness."""
        solution: Array = np.empty_like(force)
        solution[self._order] = self._factors.solve(np.ascontiguousarray(force[self._order]))
        return solution

    def _check(self, scaled: Sparse, label: Callable[[int], str], where: str, cure: str) -> None:
        """Search the softest shape by inverse iteration."""
        shape = np.random.default_rng(22).standard_normal(self.size)
        shape /= np.linalg.norm(shape)
        softness = 0.0
        for _ in range(SWEEPS):
            shape = self._solve(shape)
            softness = float(np.linalg.norm(shape))
            if not np.isfinite(softness):
                break
            shape /= softness
        stiffness = float(shape @ (scaled @ shape)) if np.isfinite(softness) else 0.0
        row = int(np.argmax(abs(np.nan_to_num(shape * self._scale))))
        if softness * SINGULAR > 0.5 or not np.isfinite(softness):
            raise ModelError(f"{where} is singular: {label(row)} moves without a force: {cure}")
        if stiffness < 0:
            raise ModelError(
                f"{where} is indefinite: a shape with most motion at {label(row)} has negative "
                "energy. Give the stiffness of a stable state, with its load in geometric="
            )
