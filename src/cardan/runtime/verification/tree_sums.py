"""Sums over the bodies of a tree, all bodies at once, in NumPy for the verification of every build.

Distances double: after k rounds every body knows the sum over its next 2^k ancestors, or over what
hangs on it nearer than that, so that a chain of n bodies takes log2 n rounds and not n.

Source: Hillis, Steele, Data parallel algorithms (1986), for sums by doubling distances.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from .joint_motion import Array

Indices = NDArray[np.intp]


class BodyTree:
    """Ancestors of bodies, whose entry 0 is the ground.

    Args:
        parents: Of every body, -1 for the ground.
    """

    def __init__(self, parents: Sequence[int]) -> None:
        self.parents: Indices = np.array([0, *(k + 1 for k in parents)], dtype=np.intp)

    def _jumps(self) -> Iterator[Indices]:
        """Ancestors at distances 1, 2, 4 ..., 0 where the ground is nearer than that."""
        at = self.parents
        while at.any():
            yield at
            at = at[at]

    def along_paths(
        self, parts: Array, combine: Callable[[Array, Array], Array], axis: int
    ) -> Array:
        """The part of every body after those of all its ancestors.

        Args:
            parts: Of every body; that of the ground changes nothing.
            combine: (part of an ancestor, part of a body) -> of both; associative.
            axis: Of the bodies.
        """
        for at in self._jumps():
            parts = combine(parts.take(at, axis=axis), parts)
        return parts

    def sums(self, parts: Array) -> Array:
        """Sums (..., 1 + bodies, 3) of vectors of bodies with their ancestors; the ground has 0."""
        return self.along_paths(parts, np.add, -2)

    def rotations(self, parts: Array) -> Array:
        """Rotations (..., 1 + bodies, 3, 3) to ground axes from those to axes of the parents."""
        return self.along_paths(parts, np.matmul, -3)

    def subtree_sums(
        self, wrenches: Array, shift: Callable[[Array, Indices, Indices], Array]
    ) -> Array:
        """Sums over every body and all that hangs on it.

        Args:
            wrenches: (..., 1 + bodies, k); what the ground gets is left out.
            shift: (of bodies, bodies, ancestors) -> what these get of it.
        """
        for at in self._jumps():
            bodies = np.flatnonzero(at)
            # those with one ancestor stand together
            bodies = bodies[np.argsort(at[bodies], kind="stable")]
            above, starts = np.unique(at[bodies], return_index=True)
            moved = shift(wrenches.take(bodies, axis=-2), bodies, at[bodies])
            wrenches = wrenches.copy()
            wrenches[..., above, :] += np.add.reduceat(moved, starts, axis=-2)
        return wrenches
