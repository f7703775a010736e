"""What is refused, and why: theorems and missing quantities."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Refusal:
    """A refusal that is expected.

    Attributes:
        asked: The uses and integrators that say it.
        message: A pattern of it.
        reason: The theorem, or the quantity that is missing.
    """

    asked: tuple[str, ...]
    message: str
    reason: str


REFUSALS: tuple[Refusal, ...] = (
    Refusal(
        ("EnergyMomentum",),
        "moves bodies as such|keeps the momenta of nodes",
        "Momenta are conserved along increments of poses, which joint coordinates do not have "
        "(J. C. Simo, N. Tarnow, ZAMP 43, 1992). Absolute coordinates have them.",
    ),
    Refusal(
        ("EnergyMomentum",),
        "keeps what is conserved|is not conservative",
        "The discrete gradient of an energy is what the method steps with "
        "(O. Gonzalez, J. Nonlinear Sci. 6, 1996); what changes in events or lags has none.",
    ),
    Refusal(
        ("EnergyMomentum",),
        "the mass of .* couples nodes",
        "Momenta are kept node by node where no mass couples nodes "
        "(J. C. Simo, N. Tarnow, ZAMP 43, 1992); inertia='lumped' gives such beams.",
    ),
    Refusal(
        ("Newmark",),
        "keeps 1 of an error of the constraints",
        "Newmark's method without damping is weakly unstable with constraints "
        "(A. Cardona, M. Géradin, Computers & Structures 33, 1989).",
    ),
)


def expected(names: Iterable[str], asked: str, message: str) -> Refusal:
    """The row that a refusal belongs to.

    Raises:
        AssertionError: there is none.
    """
    for row in REFUSALS:
        if asked in row.asked and re.search(row.message, message, re.DOTALL):
            return row
    raise AssertionError(f"{asked} of {', '.join(names)}: {message}")
