"""Searches for positions that meet what must hold, from a start and from random coordinates.

A search that begins where Jacobian and residuals are orthogonal has no direction: a stretched chain
gets no shorter to first order, whatever turns. Directions of negative curvature lead away.
Source: J. Nocedal, S. Wright, Numerical Optimization, 2nd ed., chapter 3.4; G. H. Golub, C. F. Van
Loan, Matrix Computations, 4th ed., chapter 10.1 (Lanczos).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import SolveWarning, warn
from ...runtime.models.initial import start_of
from .mechanism import Mechanism
from .position_solver import PositionSolver, Solution
from .targets import Target

STALLED = 1e-6  # cosine between residuals and what steps change of them: no direction
PROBE = 1e-5  # radians or sizes of the mechanism: of a difference of gradients
VECTORS, FARTHEST = 20, 1.0  # of Lanczos' basis; a step aside, in radians or sizes
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


def aside(m: Mechanism, solver: PositionSolver, q: Array) -> Iterator[Array]:
    """Starts beside a position (nq,) with stationary residuals that stay open; none elsewhere.

    They lie both ways along the direction in which the sum of squares falls most, as far as it
    would fall to zero.
    """

    def slope(at: Array) -> Array:
        return np.asarray(solver.hard_jacobian(at).T @ solver.hard(at))

    open_by = float(np.linalg.norm(solver.hard(q)))
    steepest = float(np.linalg.norm(solver.hard_jacobian(q)))
    if not open_by or float(np.linalg.norm(slope(q))) > STALLED * steepest * open_by:
        return

    def curved(direction: Array) -> Array:
        ahead, behind = (slope(m.advance(q, side * direction)) for side in (PROBE, -PROBE))
        return (ahead - behind) / (2 * PROBE)

    curvature, direction = _lowest(curved, m.nu)
    if curvature >= -STALLED * steepest**2:
        return
    length = min(FARTHEST, open_by / float(np.sqrt(-curvature)))
    for side in (length, -length):
        yield m.advance(q, side * direction)


def _lowest(curved: Callable[[Array], Array], n: int) -> tuple[float, Array]:
    """Lowest eigenvalue of a symmetric matrix (n, n) by its products, with its vector."""
    basis = np.zeros((min(n, VECTORS), n))
    products = np.zeros_like(basis)
    vector = np.random.default_rng(0).standard_normal(n)
    for k, row in enumerate(basis):
        for _ in range(2):
            vector = vector - basis[:k].T @ (basis[:k] @ vector)
        length = float(np.linalg.norm(vector))
        if not length:
            basis, products = basis[:k], products[:k]
            break
        row[:] = vector / length
        products[k] = vector = curved(row)
    small = basis @ products.T
    values, shares = np.linalg.eigh((small + small.T) / 2)
    return float(values[0]), np.asarray(basis.T @ shares[:, 0])
