"""Stresses at nodes: an operator on displacements, and what temperature adds."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arguments import checked
from ..arrays import Array, Integers
from .record import Place
from .solid import Pattern, Solid

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix


@checked
def stress_operator(solid: Solid, place: Place | None = None) -> csr_matrix:
    """The matrix that gives stresses at nodes from displacements: rows 6 k to 6 k + 5 of node k.

    Stresses are taken at the points where they are most accurate, extrapolated to the nodes of
    each cell, and averaged over the cells of a node, also where two materials meet.

    Args:
        solid: The body.
        place: The nodes: a name or numbers, ascending; all by default.

    Returns:
        A ``scipy.sparse.csr_matrix`` (6 * nodes, dofs) [Pa/m]; components xx, yy, zz, yz, zx, xy.

    Source: E. Hinton, J. S. Campbell, Int. J. Numer. Methods Eng. 8 (1974), 461-480.
    """
    from scipy.sparse import bsr_matrix

    nodes = _nodes(solid, place)
    row, share, pattern = _rows(solid, nodes)
    values = np.zeros((len(pattern.column), 6, 3))
    for group in solid.groups:
        rule = group.cell.stress
        extrapolation = np.ascontiguousarray(group.cell.extrapolation)
        solid.call("recovery", group, rule, extrapolation, row, share, values, pattern=pattern)
    shape = (6 * len(nodes), solid.mesh.dofs)
    return bsr_matrix((values, pattern.column, pattern.first), shape).tocsr()


@checked
def thermal_stresses(solid: Solid, temperature: ArrayLike, place: Place | None = None) -> Array:
    """Stresses at nodes that a temperature gives where all displacements are zero.

    Args:
        solid: The body.
        temperature: Rise of temperature at the nodes (nodes,) [K].
        place: The nodes: a name or numbers, ascending; all by default.

    Returns:
        Stresses (6 * nodes,) [Pa], to be added to the operator times displacements.
    """
    nodes = _nodes(solid, place)
    row, share, _ = _rows(solid, nodes)
    rise = solid.field("temperature", temperature, 1)[:, 0]
    sums = np.zeros((len(nodes), 6))
    for group in solid.groups:
        stress = solid.stresses(group, group.cell.stress, None, rise)
        at_nodes = np.einsum("ap,cps->cas", group.cell.extrapolation, stress, optimize=True)
        chosen = row[group.nodes] >= 0
        weighted = at_nodes * share[group.nodes][:, :, None]
        np.add.at(sums, row[group.nodes][chosen], weighted[chosen])
    return sums.ravel()


def _nodes(solid: Solid, place: Place | None) -> Integers:
    return np.arange(len(solid.mesh.points)) if place is None else solid.mesh.nodes(place)


def _rows(solid: Solid, nodes: Integers) -> tuple[NDArray[np.int32], Array, Pattern]:
    """Row of each node, weight of each of its cells, and the nodes that a row couples with."""
    row = np.full(len(solid.mesh.points), -1, np.int32)
    row[nodes] = np.arange(len(nodes))
    count = np.zeros(len(solid.mesh.points))
    for group in solid.groups:
        np.add.at(count, group.nodes, 1.0)
    first, column = solid.pattern.first, solid.pattern.column
    length = np.diff(first)[nodes]
    start = np.concatenate([[0], np.cumsum(length)])
    # places of the lists of these rows, one list after the other
    places = np.arange(start[-1]) + np.repeat(first[nodes] - start[:-1], length)
    pattern = Pattern(start.astype(np.int32), np.ascontiguousarray(column[places]))
    return row, 1.0 / count, pattern
