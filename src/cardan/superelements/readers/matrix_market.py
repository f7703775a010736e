"""MatrixMarket texts, dense or by coordinates.

Source: R. F. Boisvert, R. Pozo, K. A. Remington, The Matrix Market exchange formats, NISTIR 5935,
1996.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ...errors import ModelError, brief
from .labeled import in_order
from .matrix_files import MOST_ENTRIES, MOST_ROWS, ComponentMatricesRecord, MatrixReader
from .records import assembled, integer, integers, table, text_lines

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

MAGIC = "%%matrixmarket"


def _read(contents: Mapping[str, bytes], names: Mapping[str, str]) -> ComponentMatricesRecord:
    """Two texts and the positions of the nodes."""
    K, M = (_matrix(contents[role], names[role]) for role in ("stiffness", "mass"))
    source = names.get("nodes", "")
    return in_order(M, K, contents.get("nodes"), source, names["stiffness"])


def _matrix(content: bytes, file: str) -> Sparse:
    """A square real matrix.

    Raises:
        ModelError: another kind of text, or numbers that do not fit its sizes.
    """
    lines = text_lines(content, file)
    head = lines[0].lower().split() if lines else []
    if len(head) != 5 or head[0] != MAGIC or head[1] != "matrix":
        raise ModelError(f"{file}:1: expected '%%MatrixMarket matrix ...'")
    layout, field, symmetry = head[2:]
    if layout not in ("coordinate", "array") or field not in ("real", "integer", "double"):
        raise ModelError(
            f"{file}:1: '{layout} {field}': expected coordinate or array, of real numbers"
        )
    if symmetry not in ("symmetric", "general"):
        raise ModelError(f"{file}:1: {brief(symmetry)}, expected symmetric or general")
    first = next((k for k, x in enumerate(lines) if x.strip() and not x.startswith("%")), None)
    if first is None:
        raise ModelError(f"{file}: it ends before its sizes")
    sizes = [integer(word, file, first + 1) for word in lines[first].split()]
    if len(sizes) != (3 if layout == "coordinate" else 2) or sizes[0] != sizes[1]:
        raise ModelError(f"{file}:{first + 1}: {brief(lines[first])}: expected a square matrix")
    size = sizes[0]
    if not 0 < size <= MOST_ROWS:
        raise ModelError(f"{file}:{first + 1}: {size} rows, expected 1 to {MOST_ROWS}")
    body = lines[first + 1 :]
    if layout == "coordinate":
        values = table(body, first + 2, 3, file)
        if len(values) != sizes[2]:
            raise ModelError(f"{file}: {len(values)} entries, its head says {sizes[2]}")
        rows, columns = (integers(values[:, k], file, "row or column") - 1 for k in (0, 1))
        return assembled(rows, columns, values[:, 2], size, file, symmetry == "symmetric")
    column, row = np.divmod(np.arange(size * size if size**2 <= MOST_ENTRIES else 0), size)
    if symmetry == "symmetric":
        # the lower triangle, by columns
        row, column = row[row >= column], column[row >= column]
    values = table(body, first + 2, 1, file)
    if len(values) != len(row):
        raise ModelError(f"{file}: {len(values)} entries, its head says {len(row)}")
    return assembled(row, column, values[:, 0], size, file, symmetry == "symmetric")


MATRIX_MARKET = MatrixReader("MatrixMarket", (".mtx", ".mm"), _read, {})
