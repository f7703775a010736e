"""Mass, damping and stiffness of a system in nodes, by the functions of its elements, at rest."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array, Integers
from ...ir.interpreter import evaluate
from ...records import dataclass
from ..finite_elements.record import FiniteElementRecord, Group

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix as Sparse

Q, U = 7, 6  # coordinates and speeds of a node in space


@dataclass(frozen=True, eq=False)
class ElementMatrices:
    """Matrices in displacements along ground axes and rotations about them, six rows per node.

    Attributes:
        M, C, K: (6 n, 6 n) [kg, N s/m, N/m; rotations in rad].
    """

    M: Sparse
    C: Sparse
    K: Sparse


def element_matrices(record: FiniteElementRecord, q: Array, rotations: Array) -> ElementMatrices:
    """Matrices of all elements, all of whose places are nodes in space, at rest.

    Args:
        record: The elements.
        q: Coordinates (7 n,).
        rotations: Of the nodes at q (n, 3, 3).
    """
    from scipy.sparse import block_diag, coo_matrix

    entries: dict[str, list[tuple[Integers, Array]]] = {"M": [], "C": [], "K": []}
    p = np.array([parameter.value for parameter in record.system.parameters])
    for group in record.groups:
        results = element_tangents(group, q, p)
        columns = (U * group.places[:, :, None] + np.arange(U)).reshape(len(group.places), -1)
        for name in entries.keys() & results.keys():
            entries[name].append((columns, results[name]))
    size = U * len(rotations)
    # speeds are angular velocity in axes of the node, then velocity
    blocks_of_nodes = np.zeros((len(rotations), U, U))
    blocks_of_nodes[:, :3, 3:] = np.swapaxes(rotations, 1, 2)
    blocks_of_nodes[:, 3:, :3] = np.eye(3)
    by_ground = block_diag(list(blocks_of_nodes), format="csr")
    matrices = {}
    for name, blocks in entries.items():
        row, column, value = (np.zeros(0, dtype) for dtype in (np.intp, np.intp, float))
        for columns, values in blocks:
            shape = values.shape
            row = np.append(row, np.broadcast_to(columns[:, :, None], shape))
            column = np.append(column, np.broadcast_to(columns[:, None, :], shape))
            value = np.append(value, values)
        summed = coo_matrix((value, (row, column)), shape=(size, size)).tocsr()
        matrices[name] = (by_ground.T @ summed @ by_ground).tocsr()
    return ElementMatrices(**matrices)


def element_tangents(group: Group, q: Array, p: Array) -> dict[str, Array]:
    """Matrices of the elements of a group by name (n, k, k)."""
    function = group.kind.functions.get("balance_tangent")
    if function is None:
        return {}
    n, k = group.places.shape
    data = [] if group.common is None else [_common(group, p)]
    data += [] if group.attributes is None else [group.attributes]
    blocks = {
        "q": q[(Q * group.places[:, :, None] + np.arange(Q)).reshape(n, -1)],
        "p": np.concatenate(data, axis=1) if data else np.zeros((n, 0)),
        **dict.fromkeys(("u", "udot"), np.zeros((n, U * k))),
    }
    results: dict[str, Array] = evaluate(function, blocks, "numpy")
    return {name: np.broadcast_to(x, (n, *x.shape[-2:])) for name, x in results.items()}


def _common(group: Group, p: Array) -> Array:
    """Data that parameters give, of every element (n, k)."""
    assert group.common is not None
    values = np.asarray(evaluate(group.common, {"p": p}, "numpy")["data"], dtype=float)
    return np.broadcast_to(values, (len(group.places), values.shape[-1]))
