"""How steeply branches leave a branch point: W. T. Koiter's coefficients of their loads.

Source: W. T. Koiter, On the Stability of Elastic Equilibrium (1945); B. Budiansky, Advances in
Applied Mechanics 14 (1974), 1-65.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from .family import along_parameter
from .singular_point import HalfBranch
from .solutions import Quantity, Solutions
from .special_points import Special

ZERO = 1e-9  # a load that is none, as a part of its range
STEP = 1e-3  # length of increments over which quantities are differentiated


class Postbuckling(NamedTuple):
    """P = P_c (1 + a x + b x^2) along a branch, x from the branch point on.

    With a = 0 and b < 0, or with a other than 0, small imperfections lower the largest load.

    Attributes:
        a: Slope [1 / unit of x].
        b: Curvature [1 / unit of x^2].
    """

    a: float
    b: float


def postbuckling(
    solutions: Solutions, special: Special, load: str, name: str
) -> list[Postbuckling]:
    """Coefficients of every branch that leaves a point, by a quantity; NaN where it stays as it is.

    Args:
        solutions, special: Of what.
        load: Name of the load.
        name: Name of the quantity x.

    Raises:
        ModelError: the load is 0 at the point.
    """
    x, P = solutions.quantity(name), solutions.quantity(load)
    critical = P(special.place.point)
    family = solutions.family
    reach = P(family.moved(special.place.point, along_parameter(family))) - critical
    if abs(critical) <= ZERO * abs(reach):
        raise ModelError(
            f"postbuckling: '{load}' is 0 at the point, and a and b are parts of it; shift the "
            "parameter, or name another load: load="
        )
    coefficients = list[Postbuckling]()
    for half in special.halves:
        (dx, ddx), (dP, ddP) = (_derivatives(solutions, special, half, of) for of in (x, P))
        if abs(dx) < 1e-6:
            coefficients.append(Postbuckling(np.nan, np.nan))
            continue
        slope = dP / dx
        coefficients.append(
            Postbuckling(slope / critical, 0.5 * (ddP - slope * ddx) / dx**2 / critical)
        )
    return coefficients


def _derivatives(
    solutions: Solutions, special: Special, half: HalfBranch, of: Quantity
) -> tuple[float, float]:
    """First and second derivative of a quantity along a branch."""
    family, start = solutions.family, special.place.point

    def at(s: float) -> float:
        dz: Array = s * half.tangent + 0.5 * s**2 * half.curvature
        return of(family.moved(start, dz))

    h = STEP
    near, far = (at(h), at(-h)), (at(2 * h), at(-2 * h))
    first = (8 * (near[0] - near[1]) - (far[0] - far[1])) / (12 * h)
    second = (16 * sum(near) - sum(far) - 30 * at(0.0)) / (12 * h**2)
    return first, second
