"""Periods of what forces a motion."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Protocol, SupportsFloat, cast

from ...errors import ArgumentError, ModelError, SolveError, brief, near
from ...runtime.models.loaded_model import LoadedModel
from .cycle_problem import PeriodRule, Values


class Expression(Protocol):
    """A SymPy expression."""

    @property
    def free_symbols(self) -> Iterable[object]:
        """Its symbols."""

    def subs(self, values: Mapping[object, float]) -> SupportsFloat:
        """Its value for values of symbols."""


def period_rule(model: LoadedModel, period: object) -> PeriodRule | None:
    """The period by parameters and inputs.

    Args:
        model: Whose.
        period: Time [s], a function of the named values, or an expression in parameters and inputs.

    Raises:
        ModelError: an unknown name. ArgumentError: something else. SolveError, when it is called: a
            time that is not positive.
    """
    if period is None:
        return None
    rule = _rule(model, period)
    defaults = {str(row.name): float(row.default) for row in model.manifest.inputs}

    def positive(values: Values) -> float:
        try:
            value = rule({**defaults, **values})
        except (ArithmeticError, TypeError):
            value = math.nan
        if not (math.isfinite(value) and value > 0):
            raise SolveError(f"cycle: period={value:g}: it is a positive time [s]")
        return value

    return positive


def _rule(model: LoadedModel, period: object) -> PeriodRule:
    if hasattr(period, "free_symbols"):
        return _expression(model, cast(Expression, period))
    if callable(period):
        return lambda values: float(period(values))
    try:
        constant = float(cast(float, period))
    except (TypeError, ValueError):
        raise ArgumentError(
            f"cycle: period={brief(period)}; give a time [s], a function of the named parameters, "
            "or an expression in them"
        ) from None
    return lambda values: constant


def _expression(model: LoadedModel, period: Expression) -> PeriodRule:
    """The rule that a SymPy expression states."""
    symbols = {str(symbol): symbol for symbol in period.free_symbols}
    names = [*model.parameters, *model.inputs]
    for name in symbols:
        if name not in names:
            raise ModelError(
                f"cycle: period: there is no parameter or input '{name}'.{near(name, names)}"
            )

    def rule(values: Values) -> float:
        return float(period.subs({symbol: values[name] for name, symbol in symbols.items()}))

    return rule
