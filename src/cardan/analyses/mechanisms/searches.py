"""Searches for positions that meet what must hold, from a start and from random coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import SolveWarning, warn
from ...runtime.models.initial import start_of
from .mechanism import Mechanism
from .position_solver import PositionSolver, Solution
from .targets import Target

INWARD = 8  # searches that begin where the one before ended, outside of limits


def search(
    m: Mechanism, targets: Sequence[Target], begin: Array, starts: int, seed: int
) -> list[Solution]:
    """Ends of searches from a start and from random coordinates.

    Where a search ends outside limits, the next ones begin there, with these coordinates in the
    middle of their ranges: all others stay near to where they were meant to be.

    Ctrl-C ends them once one of them has met the targets.

    Warns:
        SolveWarning: they were interrupted.
    """
    solutions, solver = list[Solution](), PositionSolver(m, targets)
    start = start_of(m.model, {}, {})[0][: m.model.nq]
    rng = np.random.default_rng(seed)
    from_here, inward = begin, True
    for k in range(starts):
        if not inward:
            from_here = drawn(m, start, rng)
        try:
            end = solver.search(from_here)
        except KeyboardInterrupt:
            if not any(one.met for one in solutions):
                raise
            warn(
                f"interrupted after {k} of {starts} searches: there may be more positions, and one "
                "that is nearer to the start",
                SolveWarning,
            )
            break
        inward = inward and k < INWARD and end.met and m.outside(end.q) > 0
        from_here = m.inward(end.q)
        solutions.append(replace(end, q=m.nearest(end.q, begin), first=k == 0))
    return solutions


def drawn(m: Mechanism, start: Array, rng: np.random.Generator) -> Array:
    """Random coordinates; lengths without limits as far from their start as the mechanism is."""
    manifest = m.model.manifest
    q = m.drawn(rng)
    bound = {joint.name for joint in manifest.joints if joint.limits}
    for k, row in enumerate(manifest.coordinates):
        if row.unit == "m" and row.joint not in bound:
            q[k] = start[k] + m.size * (q[k] - (row.default or 0.0))
    return q
