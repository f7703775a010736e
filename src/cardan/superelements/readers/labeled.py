"""Matrices whose rows have the numbers of nodes and directions, and positions of nodes in texts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ...arrays import Array, Integers
from ...errors import ModelError, brief
from ..node_dofs import COMPONENTS
from .matrix_files import MOST_ROWS, ComponentMatricesRecord
from .records import assembled, integer, integers, number, numbered_lines, table, text_lines

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

MARK = "*"  # of a keyword in the input of Abaqus and CalculiX


class Positions(NamedTuple):
    """Positions of numbered nodes.

    Attributes:
        ids: Their numbers.
        rows: (n_nodes, 3) [m].
        file: That they are from.
    """

    ids: tuple[int, ...]
    rows: Array
    file: str


def labeled_matrices(
    entries: tuple[Array, Array], files: tuple[str, str], positions: Positions | None
) -> ComponentMatricesRecord:
    """Stiffness and mass whose entries name node and direction of row and column.

    Args:
        entries: Node, direction, node, direction, value in each row, of K and of M.
        files: Their names.
        positions: Of the nodes; a node without rows is left out.

    Raises:
        ModelError: directions that do not exist, or rows that only M has.
    """
    keys = []
    for values, file in zip(entries, files, strict=True):
        if not len(values):
            raise ModelError(f"{file}: it has no entries")
        nodes = integers(np.concatenate([values[:, 0], values[:, 2]]), file, "node")
        directions = integers(np.concatenate([values[:, 1], values[:, 3]]), file, "direction")
        if directions.max() > len(COMPONENTS):
            raise ModelError(f"{file}: direction {directions.max()}, expected 1 to 6")
        keys.append(8 * nodes.astype(np.int64) + directions - 1)
    rows = np.unique(np.concatenate(keys))
    matrices = []
    for values, file, key in zip(entries, files, keys, strict=True):
        place = np.searchsorted(rows, key)
        half = len(values)
        matrices.append(assembled(place[:half], place[half:], values[:, 4], len(rows), file))
    dofs = tuple((int(key) // 8, COMPONENTS[int(key) % 8]) for key in rows)
    return component(matrices[1], matrices[0], dofs, positions, files[0], files[0])


def component(
    M: Sparse,
    K: Sparse,
    dofs: tuple[tuple[int, str], ...],
    positions: Positions | None,
    source: str,
    rows_file: str,
) -> ComponentMatricesRecord:
    """Matrices with named rows, and the positions of the nodes that have rows.

    Raises:
        ModelError: a node without a position.
    """
    nodes = sorted({node for node, _ in dofs})
    if positions is None:
        return ComponentMatricesRecord(M, K, None, tuple(nodes), dofs, source)
    place = {node: k for k, node in enumerate(positions.ids)}
    missing = [node for node in nodes if node not in place]
    if missing:
        raise ModelError(
            f"{rows_file}: node {missing[0]} has rows, but no position in {positions.file}"
        )
    chosen = positions.rows[[place[node] for node in nodes]]
    return ComponentMatricesRecord(M, K, chosen, tuple(nodes), dofs, source)


def node_positions(content: bytes, file: str) -> Positions | Array:
    """Positions of nodes out of a table, or out of the input of Abaqus or CalculiX.

    Args:
        content: x, y, z in each line, or a number of the node before them; between commas or
            spaces. In an input, lines behind ``*NODE``.
        file: Its name.

    Returns:
        Numbers and positions, or positions alone (n_nodes, 3) [m].

    Raises:
        ModelError: lines of another kind.
    """
    lines = text_lines(content, file)
    if any(line.lstrip().startswith(MARK) for line in lines):
        return _of_input(lines, file)
    plain = ["" if line.lstrip().startswith("#") else line for line in lines]
    start, first = next(((k, x) for k, x in enumerate(plain, 1) if x.strip()), (1, ""))
    comma = "," in first
    columns = len(first.split(",") if comma else first.split())
    if columns not in (3, 4):
        raise ModelError(f"{file}:{start}: {columns} numbers, expected x, y, z or node, x, y, z")
    values = table(plain, 1, columns, file, comma)
    if columns == 3:
        return values
    return _numbered(integers(values[:, 0], file, "node", least=0), values[:, 1:], file)


def _of_input(lines: Sequence[str], file: str) -> Positions:
    """Nodes behind ``*NODE``, until the next keyword."""
    numbers, rows, inside = [], [], False
    for k, line in numbered_lines(lines):
        if line.lstrip().startswith(MARK):
            if line.lstrip().startswith(2 * MARK):
                continue
            keyword = line.strip().upper().split(",")
            inside = keyword[0].strip() == "*NODE"
            if inside and any("SYSTEM" in word for word in keyword[1:]):
                raise ModelError(
                    f"{file}:{k}: nodes in another system of axes; write them in x, y, z"
                )
            continue
        if inside:
            parts = line.rstrip(", ").split(",")
            if not 2 <= len(parts) <= 4:
                raise ModelError(f"{file}:{k}: {brief(line)}, expected node, x, y, z")
            numbers.append(integer(parts[0], file, k))
            rows.append([number(word, file, k) for word in parts[1:]] + [0.0] * (4 - len(parts)))
    if not rows:
        raise ModelError(f"{file}: there is no *NODE")
    return _numbered(np.array(numbers, dtype=np.intp), np.array(rows), file)


def _numbered(numbers: Integers, rows: Array, file: str) -> Positions:
    if len(numbers) > MOST_ROWS:
        raise ModelError(f"{file}: {len(numbers)} nodes, at most {MOST_ROWS} are read")
    unique, count = np.unique(numbers, return_counts=True)
    if (count > 1).any():
        raise ModelError(f"{file}: node {unique[count > 1][0]} is there twice")
    return Positions(tuple(int(one) for one in numbers), rows, file)


def with_positions(content: bytes | None, file: str) -> tuple[Positions | None, Array | None]:
    """Positions with numbers, or positions in the order of the rows; None without a file."""
    if content is None:
        return None, None
    positions = node_positions(content, file)
    return (positions, None) if isinstance(positions, Positions) else (None, positions)


def in_order(
    M: Sparse, K: Sparse, content: bytes | None, file: str, source: str
) -> ComponentMatricesRecord:
    """Matrices whose rows are those of all nodes in their order."""
    numbered, plain = with_positions(content, file)
    if numbered is None:
        return ComponentMatricesRecord(M, K, plain, None, None, source)
    order = np.argsort(numbered.ids)
    ids = tuple(int(one) for one in np.array(numbered.ids)[order])
    return ComponentMatricesRecord(M, K, numbered.rows[order], ids, None, source)
