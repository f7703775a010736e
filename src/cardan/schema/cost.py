"""Costs of motions."""

from __future__ import annotations

from ..errors import ArgumentError, brief
from ..records import dataclass


@dataclass(frozen=True)
class Cost:
    """A cost of a motion: a formula at its end, plus the integral of another one along it.

    Formulas are those of scene files, in names of the model: outputs, coordinates, speeds, internal
    states, inputs, parameters and ``t``: ``cd.cost(final="(hand.x - 0.4)^2",
    running="1e-3*tau^2")``.

    Attributes:
        final: Formula at the end, None without.
        running: Formula whose integral over time counts, None without.
    """

    final: str | None = None
    running: str | None = None


def cost(final: str | float | None = None, running: str | float | None = None) -> Cost:
    """A cost of a motion, for :meth:`cardan.CompiledModel.gradient`.

    Args:
        final: Formula at the end of the motion, such as ``"(hand.x - 0.4)^2"``.
        running: Formula whose integral over time counts, such as ``"1e-3*tau^2"``.

    Raises:
        ArgumentError: neither is given, or one is not a formula.
    """
    texts = []
    for name, formula in (("final", final), ("running", running)):
        if isinstance(formula, int | float) and not isinstance(formula, bool):
            formula = repr(float(formula))
        if formula is not None and not (isinstance(formula, str) and formula.strip()):
            raise ArgumentError(f"cost: {name}={brief(formula)}: give a formula as text")
        texts.append(formula)
    if texts == [None, None]:
        raise ArgumentError('cost: give final= or running=, such as cd.cost(final="elbow^2")')
    return Cost(*texts)
