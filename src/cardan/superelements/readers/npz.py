"""NumPy archives with M, K and nodes in one file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...number_file import unpacked
from ..storage import ABOUT
from .labeled import in_order
from .matrix_files import ComponentMatricesRecord, MatrixReader
from .records import assembled, integers

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse


def _read(contents: Mapping[str, bytes], names: Mapping[str, str]) -> ComponentMatricesRecord:
    """M and K dense, or sparse as ``K_rows``, ``K_columns``, ``K_values`` counted from 0."""
    file = names["stiffness"]
    try:
        arrays = unpacked(contents["stiffness"])
    except ValueError as error:
        raise ModelError(f"{file} is not a NumPy archive of numbers: {error}") from None
    if ABOUT in arrays:
        raise ModelError(f"{file} is a reduced component; cd.superelement.load reads it")
    M, K = _matrix(arrays, "M", file), _matrix(arrays, "K", file)
    if "nodes" in contents or "nodes" not in arrays:
        source = names.get("nodes", "")
        return in_order(M, K, contents.get("nodes"), source, file)
    nodes, ids = _numbers(arrays, "nodes", file), None
    if "node_ids" in arrays:
        numbers = integers(_numbers(arrays, "node_ids", file).reshape(-1), file, "node", least=0)
        ids = tuple(int(one) for one in numbers)
    return ComponentMatricesRecord(M, K, nodes, ids, None, file)


def _matrix(arrays: Mapping[str, Array], name: str, file: str) -> Sparse:
    """A matrix of the file.

    Raises:
        ModelError: there is none.
    """
    from scipy.sparse import csc_matrix

    if name in arrays:
        return csc_matrix(np.atleast_2d(_numbers(arrays, name, file)))
    parts = [f"{name}_{part}" for part in ("rows", "columns", "values")]
    if not {*parts} <= {*arrays}:
        raise ModelError(
            f"{file}: there is no '{name}' and no {', '.join(parts)}. It has {', '.join(arrays)}"
        )
    rows, columns, values = (_numbers(arrays, part, file).reshape(-1) for part in parts)
    if not len(rows) == len(columns) == len(values):
        raise ModelError(f"{file}: {', '.join(parts)} differ in length")
    if not len(values):
        raise ModelError(f"{file}: '{parts[2]}' has no entries")
    places = [integers(one, file, "row or column", least=0) for one in (rows, columns)]
    size = 1 + int(max(places[0].max(), places[1].max()))
    return assembled(places[0], places[1], values, size, file)


def _numbers(arrays: Mapping[str, Array], name: str, file: str) -> Array:
    array = arrays[name]
    if array.dtype.kind not in "fiu" or array.ndim > 2:
        raise ModelError(f"{file}: '{name}' is {array.dtype} of shape {array.shape}, no numbers")
    return array.astype(np.float64)


NPZ = MatrixReader("NumPy archive", (".npz",), _read, {})
