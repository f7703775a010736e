"""Periods of what forces a motion."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from ...errors import ArgumentError, ModelError, brief, near
from ...runtime.models.loaded_model import LoadedModel
from .cycle_problem import PeriodRule, Values


def period_rule(model: LoadedModel, period: object) -> PeriodRule | None:
    """The period by parameters and inputs.

    Args:
        model: Whose.
        period: Time [s], a function of the named values, or an expression in parameters and inputs.

    Raises:
        ModelError: an unknown name, a time that is not positive. ArgumentError: something else.
    """
    if period is None:
        return None
    rule = _rule(model, period)
    defaults = {str(row.name): float(row.default) for row in model.manifest.inputs}
    value = rule({**defaults, **model.parameters})
    if not (math.isfinite(value) and value > 0):
        raise ModelError(f"cycle: period={value:g}: it is a positive time [s]")
    return lambda values: rule({**defaults, **values})


def _rule(model: LoadedModel, period: Any) -> PeriodRule:
    if hasattr(period, "free_symbols"):
        return _expression(model, period)
    if isinstance(period, Callable):  # type: ignore[arg-type]
        return lambda values: float(period(values))
    try:
        constant = float(period)
    except (TypeError, ValueError):
        raise ArgumentError(
            f"cycle: period={brief(period)}; give a time [s], a function of the named parameters, "
            "or an expression in them"
        ) from None
    return lambda values: constant


def _expression(model: LoadedModel, period: Any) -> PeriodRule:
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
