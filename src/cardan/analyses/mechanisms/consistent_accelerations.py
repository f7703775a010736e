"""Accelerations that constraints allow, as those under the forces of a model."""

from __future__ import annotations

import warnings
from collections.abc import Callable

import numpy as np

from ...arrays import Array
from ...errors import SolveError, SolveWarning


def accelerations(
    name: str, forward: Callable[[], Array], mass_matrix: Callable[[], Array]
) -> Array | None:
    """Accelerations that the constraints allow; None where no force depends on any, without mass.

    Args:
        name: Of the model.
        forward: Its accelerations (..., nu) under its forces.
        mass_matrix: Its M (..., nu, nu).

    Raises:
        SolveError: M is singular, and not 0.
    """
    reason: SolveError | None = None
    with warnings.catch_warnings():
        # what it says of states without a solution is said here
        warnings.simplefilter("ignore", SolveWarning)
        try:
            possible = forward()
            if np.isfinite(possible).all():
                return possible
        except SolveError as error:
            reason = error
    if not np.any(mass_matrix()):
        return None
    raise SolveError(
        f"model '{name}': whether the constraints allow these accelerations follows from "
        "those under the forces of the model, but the mass matrix is singular at these "
        "parameters. Give the bodies without mass a small one; the forces change as little"
    ) from reason
