"""Derivatives of what closes loops along joints, from rows of constraints of joints and nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...records import dataclass

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

    from .nodal_mechanism import NodalMechanism

Entries = NDArray[np.intp]
ALWAYS = 1e-9  # residuals without units of conditions that hold wherever joints stand
PROBE = 0.3  # radians, or sizes of the mechanism: a position like any other
RANDOM_SPEEDS = 2  # at which rates of constraints are looked at


@dataclass(frozen=True)
class Structure:
    """What closes loops, by entries.

    Attributes:
        rows: Rows of the model that joints alone do not fulfill (m,).
        steps: Steps along which these change (n,).
    """

    rows: Entries
    steps: Entries


def start_key(m: NodalMechanism) -> tuple[bytes, ...]:
    """What the structure of a mechanism depends on besides its model."""
    r = b"" if m.r is None else np.asarray(m.r).tobytes()
    return np.float64(m.t).tobytes(), r, m._start.tobytes(), m.carrier.fixed.tobytes()


def probe(nu: int) -> Array:
    """A step (nu,) to a position like any other."""
    return np.random.default_rng(0).uniform(-PROBE, PROBE, nu)


def structure(m: NodalMechanism, q: Array) -> Structure:
    """What closes the loops of a mechanism, from a position (nq,) like any other."""
    speeds, rng = np.zeros((RANDOM_SPEEDS + 1, m.model.nu)), np.random.default_rng(1)
    speeds[1:, m.lead] = rng.standard_normal((RANDOM_SPEEDS, m.nu)) * m.columns
    T = m.carrier.moving(q, speeds)
    still = m._evaluated("constraint_rates", q, T[0])
    rates = m._gradient(q) @ (T[1:] - T[0]).T
    open_by = np.abs(still) + np.abs(rates).max(axis=1, initial=0.0)
    gaps = m._evaluated("constraints", q)
    open_by[: len(gaps)] += np.abs(gaps)
    rows = np.flatnonzero(~(open_by <= ALWAYS * max(1.0, m.size)))
    if not len(rows):
        return Structure(rows, rows)
    T = m.carrier.moving(q, m._unit_steps(np.arange(m.nu)))
    G = m._gradient(q)[rows] @ (T[1:] - T[0]).T
    return Structure(rows, np.flatnonzero(np.abs(G).max(axis=0, initial=0.0) > ALWAYS))


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
