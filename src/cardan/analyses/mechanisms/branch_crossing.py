"""Starts at which branches of a motion meet."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from .mechanism import Mechanism
from .position_solver import PositionSolver
from .redundancy import rank_of

BESIDE = 1e-3  # of the size, and radians


def refuse_singular(m: Mechanism, q: Array) -> None:
    """Refuse a start at which branches meet, unless all speeds say which one is meant.

    Raises:
        ModelError: constraints are fewer here than at a position beside it.
    """
    U, s = m.decomposition(q)
    rank = rank_of(s)
    if rank == len(U):
        return
    aside = np.random.default_rng(0).uniform(-BESIDE, BESIDE, m.nu)
    beside = PositionSolver(m).search(m.advance(q, aside)).q
    usual = rank_of(np.linalg.svd(m.jacobian(beside), compute_uv=False))
    if usual <= rank:
        return
    # what is lost here, and not what is redundant everywhere
    weakest = int(np.abs(U[:, rank:]).max(axis=1).argmax())
    raise ModelError(
        f"the start is a singular position: {rank} of {usual} independent constraints hold there, "
        f"branches of the motion meet at joint '{m.closing.rows[weakest].joint}'. Give all "
        "speeds, u=: they say which branch is meant; or start beside it"
    )
