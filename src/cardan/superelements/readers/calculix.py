"""CalculiX: what ``*FREQUENCY, SOLVER=MATRIXSTORAGE`` writes.

``job.sti`` and ``job.mas`` have one triangle of stiffness and mass, ``job.dof`` node and direction
of each row. Positions of nodes are in ``job.inp``.

Source: G. Dhondt, CalculiX CrunchiX User's Manual, version 2.20, *FREQUENCY.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ...errors import ModelError, brief
from ..node_dofs import COMPONENTS
from .labeled import component, with_positions
from .matrix_files import MOST_ROWS, ComponentMatricesRecord, MatrixReader
from .records import assembled, integer, integers, numbered_lines, table, text_lines

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse


def _read(contents: Mapping[str, bytes], names: Mapping[str, str]) -> ComponentMatricesRecord:
    """Stiffness, mass, directions of the rows and, where it is there, the input."""
    dofs = _dofs(contents["dofs"], names["dofs"])
    K, M = (
        _matrix(contents[role], names[role], len(dofs), names["dofs"])
        for role in ("stiffness", "mass")
    )
    numbered, plain = with_positions(contents.get("nodes"), names.get("nodes", ""))
    if plain is not None:
        raise ModelError(f"{names['nodes']}: give the number of each node before x, y, z")
    return component(M, K, dofs, numbered, names["stiffness"], names["dofs"])


def _dofs(content: bytes, file: str) -> tuple[tuple[int, str], ...]:
    """Node and direction of each row.

    Raises:
        ModelError: a line that is not one, or too many.
    """
    rows: list[tuple[int, str]] = []
    for k, line in numbered_lines(text_lines(content, file)):
        node, dot, direction = line.strip().partition(".")
        place = integer(direction, file, k) if dot else 0
        if not 1 <= place <= len(COMPONENTS) or len(rows) >= MOST_ROWS:
            raise ModelError(f"{file}:{k}: {brief(line.strip())}, expected node.direction")
        rows.append((integer(node, file, k), COMPONENTS[place - 1]))
    return tuple(rows)


def _matrix(content: bytes, file: str, size: int, dofs_file: str) -> Sparse:
    """One triangle: row, column, value.

    Raises:
        ModelError: rows that have no direction.
    """
    values = table(text_lines(content, file), 1, 3, file)
    rows, columns = (integers(values[:, k], file, "row or column") - 1 for k in (0, 1))
    last = int(max(rows.max(initial=-1), columns.max(initial=-1)))
    if last >= size:
        raise ModelError(f"{dofs_file}: it names {size} rows, {file} has one of number {last + 1}")
    return assembled(rows, columns, values[:, 2], size, file)


CALCULIX = MatrixReader(
    "CalculiX", (".sti",), _read, {"mass": ".mas", "dofs": ".dof", "nodes": ".inp"}
)
