"""Texts are no expressions: SymPy would run them as Python."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ...errors import ModelError


def refuse_texts(what: str, given: Any) -> None:
    """Complain about a text where an expression belongs.

    Args:
        what: What was given, for the message.
        given: An expression; lists, arrays and dicts of some, whose keys may be texts.

    Raises:
        ModelError: there is one.
    """
    if isinstance(given, (str, bytes)):
        raise ModelError(
            f"from_sympy: {what}: {given[:40]!r} is a text, which is not run as an expression; "
            "give one of SymPy, such as sympy.Symbol('m')"
        )
    if isinstance(given, Mapping):
        for key, value in given.items():
            refuse_texts(f"{what}[{str(key)[:40]!r}]", value)
    elif isinstance(given, np.ndarray):
        refuse_texts(what, given.tolist())
    elif isinstance(given, (list, tuple, set, frozenset)):
        for value in given:
            refuse_texts(what, value)
