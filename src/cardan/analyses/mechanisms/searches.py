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


def search(
    m: Mechanism, targets: Sequence[Target], begin: Array, starts: int, seed: int
) -> list[Solution]:
    """Ends of searches from a start and from random coordinates.

    Where the start is outside limits, the second one is the same with these coordinates in the
    middle of their ranges: all others stay where they were meant to be.

    Ctrl-C ends them once one of them has met the targets.

    Warns:
        SolveWarning: they were interrupted.
    """
    solutions, solver = list[Solution](), PositionSolver(m, targets)
    start = start_of(m.model, {}, {})[0][: m.model.nq]
    rng = np.random.default_rng(seed)
    inner = [m.inward(begin)] if m.outside(begin) else []
    for k in range(starts):
        try:
            from_here = begin if k == 0 else inner.pop() if inner else drawn(m, start, rng)
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
