"""Derivatives of what closes loops along joints, from rows of constraints of joints and nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

    from .nodal_mechanism import NodalMechanism

Entries = NDArray[np.intp]


def tree_rows(m: NodalMechanism, loops: Entries) -> Entries | None:
    """Rows that determine the speeds of nodes by those of joints; None where others do too.

    Args:
        m: The mechanism.
        loops: The rows of what closes loops.
    """
    nodes = node_speeds(m)
    rows = np.setdiff1d(np.arange(m.model.nlam), loops)
    fixed = m.carrier.fixed[m.model.nq :][nodes].any()
    return None if fixed or len(rows) != len(nodes) else rows


def node_speeds(m: NodalMechanism) -> Entries:
    """Entries of u that are speeds of nodes."""
    return np.setdiff1d(np.arange(m.model.nu), m.lead)


def along_joints(
    m: NodalMechanism, G: csr_matrix, loops: Entries, tree: Entries | None
) -> Array | None:
    """Rows of G (m, nu) that close loops along speeds of joints: nodes follow by those of the tree.

    Of the tree [A B] by nodes and joints, of what closes loops [C D]: D - C A^-1 B. None where A is
    singular, or rows of the tree do not determine the nodes.
    """
    if tree is None or not len(loops):
        return None
    from scipy.sparse.linalg import splu

    nodes, by_loops, by_tree = node_speeds(m), G[loops], G[tree]
    try:
        factors = splu(by_tree[:, nodes].T.tocsc())
    except RuntimeError:
        return None
    shares = factors.solve(by_loops[:, nodes].T.toarray()).T
    along: Array = by_loops[:, m.lead].toarray() - shares @ by_tree[:, m.lead]
    return along
