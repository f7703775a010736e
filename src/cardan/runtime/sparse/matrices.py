"""Places of the elements of a model in its sparse matrices, and their factorization."""

from __future__ import annotations

import numpy as np

from ...records import dataclass
from ..models.finite_elements.tables import Integers, Tables
from .plan import Plan, plan


@dataclass(frozen=True, eq=False)
class Matrices:
    """The matrices of a model: blocks are its places, then the rows of every element with some.

    Attributes:
        plan: How they are factored.
        spots: Of every group (n, blocks, blocks + 1): where the blocks of its elements begin among
            the values, then the numbers from one of their rows to the next.
        unknown: (m,) the unknown that every multiplier is.
        diagonal: (nu,) where the diagonal entry of every speed stands among the values.
    """

    plan: Plan
    spots: tuple[Integers, ...]
    unknown: Integers
    diagonal: Integers

    @classmethod
    def of(cls, tables: Tables) -> Matrices:
        """Plan the matrices of a model."""
        places = len(tables.kind)
        having = [len(g) if g.kind.m else 0 for g in tables.groups]
        starts = places + np.concatenate(([0], np.cumsum(having))).astype(np.intp)
        sizes = [np.diff(tables.u)]
        cliques = []
        for group, count, start in zip(tables.groups, having, starts, strict=False):
            sizes.append(np.full(count, group.kind.m))
            lines = (start + np.arange(count))[:, None]
            cliques.append(np.concatenate([group.place, lines], axis=1) if count else group.place)
        total = np.concatenate(sizes)
        poses = [kind.node for kind in tables.kinds]
        massless = np.zeros(len(total), bool)
        massless[:places] = ~np.array(poses, bool)[tables.kind] if places else False
        bound = [place for g in tables.groups if g.kind.m for place in np.unique(g.place)]
        for group in tables.groups:
            # its coordinates have masses of their own, unlike those of joints between nodes
            if group.kind.name.startswith("superelement"):
                massless[np.setdiff1d(group.place, bound)] = False
        switched = np.zeros(len(total), bool)
        for group, count, start in zip(tables.groups, having, starts, strict=False):
            switched[start : start + count] = "H" in group.kind.parts
        matrix_plan = plan(total, cliques, np.arange(len(total)) >= places, massless, switched)
        matrix, unknown, spots = matrix_plan.pattern, np.empty(tables.m, dtype=np.intp), []
        for number, (group, count, start) in enumerate(
            zip(tables.groups, having, starts, strict=False)
        ):
            if count:
                lines = matrix.first[start : start + count, None] + np.arange(group.kind.m)
                unknown[tables.lines(number)] = lines
            stride = matrix.stride[cliques[number]].astype(np.intp)
            both = np.concatenate([matrix.places[number], stride[:, :, None]], axis=2)
            spots.append(both.astype(np.intp))
        return cls(matrix_plan, tuple(spots), unknown, _diagonal(tables, matrix_plan))


def _diagonal(tables: Tables, matrix_plan: Plan) -> Integers:
    """Index of the diagonal entry of every speed in the values of a matrix."""
    matrix = matrix_plan.pattern
    diagonal = np.flatnonzero(matrix.rows == matrix.column)[: len(tables.kind)]
    sizes = matrix.sizes[: len(tables.kind)].astype(np.intp)
    inside = np.arange(tables.nu) - np.repeat(tables.u[:-1], sizes)
    start = np.repeat(matrix.value[diagonal].astype(np.intp), sizes)
    step = np.repeat(matrix.stride[: len(sizes)].astype(np.intp) + 1, sizes)
    return np.asarray(start + inside * step, dtype=np.intp)
