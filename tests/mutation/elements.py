"""Faults in functions of elements: the same questions, asked of one kind."""

from __future__ import annotations

import warnings
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from cardan.runtime.calls.code import Code
from cardan.runtime.verification.differences import BOUND
from cardan.runtime.verification.finite_elements.elements import check_kinds as by_laws
from cardan.runtime.verification.finite_elements.members import Members, members_of

from .judging import ROUNDING
from .scenes import Loaded


def judged(
    base: Loaded, symbol: str, text: dict[str, Any] | None, code: Code, whole: Code | None = None
) -> tuple[bool, str]:
    """Whether results change, and what the verification says; "" where it finds nothing."""
    found = _members(base.name, base)
    own = next((m for m in found if symbol in m.table.kind.functions.values()), None)
    if own is None:
        return False, ""
    form = next(f for f, s in own.table.kind.functions.items() if s == symbol)
    right = own if whole is None else _with(own, form, whole)
    wrong = _with(own, form, code)
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        if not _differs(right.call(form), wrong.call(form)):
            return False, ""
        objects, kept = base.model._objects, dict(base.model._objects._saved)
        if text is not None:
            objects._saved = {**kept, symbol: text}
        try:
            for name, error, _ in by_laws(wrong):
                if not error <= BOUND:
                    return True, f"{name}: {error:.1e}"
        except (ArithmeticError, ValueError, np.linalg.LinAlgError) as problem:
            return True, repr(problem)[:100]
        finally:
            objects._saved = kept
    return True, ""


def _with(members: Members, form: str, code: Code) -> Members:
    return replace(members, codes={**members.codes, form: code}, cache={})


@cache
def _members(name: str, base: Loaded) -> list[Members]:
    model = base.model
    elements = model._source.results(model).mesh
    kinds = {group.kind.name: group.kind for group in elements.tables.groups}
    symbols = [s for kind in kinds.values() for s in kind.functions.values()]
    codes = dict(zip(symbols, model._objects.load(symbols), strict=True))
    return members_of(model, elements, codes, 1)


def _differs(one: Any, other: Any) -> bool:
    good = np.isfinite(one) == np.isfinite(other)
    if not good.all():
        return True
    size = np.abs(np.nan_to_num(one)).max(initial=0.0) or 1.0
    apart = np.abs(np.nan_to_num(one) - np.nan_to_num(other)).max(initial=0.0)
    return bool(apart > ROUNDING * size)
