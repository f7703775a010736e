"""Where the elements of a model stand in its sparse matrices, and how these are factored."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

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
            own = (start + np.arange(count))[:, None]
            cliques.append(np.concatenate([group.place, own], axis=1) if count else group.place)
        total = np.concatenate(sizes)
        poses = [kind.node for kind in tables.kinds]
        massless = np.zeros(len(total), bool)
        massless[:places] = ~np.array(poses, bool)[tables.kind] if places else False
        found = plan(total, cliques, np.arange(len(total)) >= places, massless)
        matrix, unknown, spots = found.pattern, np.empty(tables.m, dtype=np.intp), []
        for number, (group, count, start) in enumerate(
            zip(tables.groups, having, starts, strict=False)
        ):
            if count:
                own = matrix.first[start : start + count, None] + np.arange(group.kind.m)
                unknown[tables.lines(number)] = own
            stride = matrix.stride[cliques[number]].astype(np.intp)
            both = np.concatenate([matrix.places[number], stride[:, :, None]], axis=2)
            spots.append(both.astype(np.intp))
        return cls(found, tuple(spots), unknown, _diagonal(tables, found))


def _diagonal(tables: Tables, found: Plan) -> Integers:
    """Where the diagonal entry of every speed stands in the values of a matrix."""
    matrix = found.pattern
    own = np.flatnonzero(matrix.rows == matrix.column)[: len(tables.kind)]
    sizes = matrix.sizes[: len(tables.kind)].astype(np.intp)
    inside = np.arange(tables.nu) - np.repeat(tables.u[:-1], sizes)
    start = np.repeat(matrix.value[own].astype(np.intp), sizes)
    step = np.repeat(matrix.stride[: len(sizes)].astype(np.intp) + 1, sizes)
    return np.asarray(start + inside * step, dtype=np.intp)
