"""Cases of which ``make test`` takes a spread; ``make slow`` runs the others."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def some(cases: Iterable[Any], every: int, first: int = 0) -> list[Any]:
    """One of ``every`` cases as it is, counted from ``first``; the others marked slow.

    Args:
        cases: One value each, a tuple of several, or what ``pytest.param`` made of them.
    """
    found = []
    for k, case in enumerate(cases):
        values, name = getattr(case, "values", case), getattr(case, "id", None)
        values = values if isinstance(values, tuple) else (case,)
        marks = [] if k % every == first else [pytest.mark.slow]
        found.append(pytest.param(*values, id=name, marks=marks))
    return found
