"""Eigenmodes of large sparse systems: shift and invert with our factors."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigs, eigsh

from ...errors import ArgumentError, SolveError
from .solver import Solver, assembled, checked, guess


def modes(
    by: Solver,
    stiffness: ArrayLike,
    mass: ArrayLike,
    count: int,
    shift: float = 0.0,
    symmetric: bool = True,
) -> tuple[NDArray[Any], NDArray[Any]]:
    """The eigenvalues nearest to a shift of: stiffness x = value mass x.

    Args:
        by: Solver of the pattern of both; it holds factors of stiffness - shift mass afterwards.
        stiffness, mass: Values of the pattern. The constraints stand in the stiffness; the mass may
            be singular, and is zero at multipliers.
        count: How many, fewer than unknowns by two.
        shift: In units of the eigenvalues; not an eigenvalue itself.
        symmetric: Whether both are, and the mass is not negative.

    Returns:
        The values (count,), by size of the difference to the shift, and the modes (n, count).

    Raises:
        ArgumentError: more modes than there can be. SolveError: the shift is an eigenvalue, or
            the iteration does not converge.
    """
    n = by.plan.pattern.n
    if not 0 < count < n - 1:
        raise ArgumentError(f"{count} modes of {n} unknowns: 1 to {n - 2} can be found")
    k, m = (checked(name, x, by.plan.pattern.values) for name, x in
            (("stiffness", stiffness), ("mass", mass)))  # fmt: skip
    by.factor(k - shift * m)
    whole, weight = assembled(by.plan, k), assembled(by.plan, m)
    inverse = LinearOperator((n, n), matvec=by.solve, dtype=float)
    # what multipliers and massless speeds would add to the start stands for infinite values
    start = by.solve(weight @ guess(n))
    find = eigsh if symmetric else eigs
    try:
        values, vectors = find(whole, count, weight, sigma=shift, OPinv=inverse, v0=start)
    except ArpackNoConvergence as problem:
        raise SolveError(
            f"{len(problem.eigenvalues)} of {count} modes converged: ask for fewer, or shift nearer"
        ) from problem
    order = np.argsort(np.abs(values - shift), kind="stable")
    return values[order], vectors[:, order]
