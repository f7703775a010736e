"""Abaqus: what ``*MATRIX OUTPUT`` writes of ``*MATRIX GENERATE``, as text.

``FORMAT=MATRIX INPUT`` has node, direction, node, direction and value in each line;
``FORMAT=COORDINATE`` row, column and value, rows in the order of nodes and directions. Made by the
manual; no file of the program was at hand.

Source: Dassault Systemes, Abaqus Analysis User's Guide, Generating structural matrices.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ...arrays import Array
from ...errors import ModelError
from .labeled import MARK, in_order, labeled_matrices, with_positions
from .matrix_files import ComponentMatricesRecord, MatrixReader
from .records import assembled, integers, table, text_lines

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse


def _read(contents: Mapping[str, bytes], names: Mapping[str, str]) -> ComponentMatricesRecord:
    """Stiffness and mass in either format, positions of nodes in a table or the input."""
    K, M = (_entries(contents[role], names[role]) for role in ("stiffness", "mass"))
    files, nodes = (names["stiffness"], names["mass"]), contents.get("nodes")
    if K.shape[1] != M.shape[1]:
        raise ModelError(f"{files[1]}: another format than {files[0]}; write both in one")
    if K.shape[1] == 5:
        numbered, plain = with_positions(nodes, names.get("nodes", ""))
        if plain is not None:
            raise ModelError(f"{names['nodes']}: give the number of each node before x, y, z")
        return labeled_matrices((K, M), files, numbered)
    size = int(max(K[:, :2].max(), M[:, :2].max()))
    matrices = [_square(values, size, file) for values, file in zip((K, M), files, strict=True)]
    return in_order(matrices[1], matrices[0], nodes, names.get("nodes", ""), files[0])


def _entries(content: bytes, file: str) -> Array:
    """Rows of 3 or 5 numbers; keywords and comments are left out.

    Raises:
        ModelError: lines of another kind.
    """
    lines = ["" if x.lstrip().startswith(MARK) else x for x in text_lines(content, file)]
    number, first = next(((k, x) for k, x in enumerate(lines, 1) if x.strip()), (1, ""))
    comma = "," in first
    columns = len(first.split(",") if comma else first.split())
    if columns not in (3, 5):
        raise ModelError(
            f"{file}:{number}: {columns} numbers, expected row, column, value or node, direction, "
            "node, direction, value"
        )
    return table(lines, 1, columns, file, comma)


def _square(values: Array, size: int, file: str) -> Sparse:
    rows, columns = (integers(values[:, k], file, "row or column") - 1 for k in (0, 1))
    return assembled(rows, columns, values[:, 2], size, file)


ABAQUS = MatrixReader("Abaqus matrix text", (".mtx", ".txt", ".inp"), _read, {}, untested=True)
