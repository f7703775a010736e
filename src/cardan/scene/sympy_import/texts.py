"""Texts are not expressions: SymPy would run them as Python."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...errors import ModelError


def refuse_texts(what: str, expression: object) -> None:
    """Complain about a text where an expression belongs.

    Args:
        what: What was given, for the message.
        given: An expression; lists, arrays and dicts of some, whose keys may be texts.

    Raises:
        ModelError: there is one.
    """
    if isinstance(expression, (str, bytes)):
        raise ModelError(
            f"from_sympy: {what}: {expression[:40]!r} is a text, which is not run as an "
            "expression; "
            "give one of SymPy, such as sympy.Symbol('m')"
        )
    if isinstance(expression, Mapping):
        for key, value in expression.items():
            refuse_texts(f"{what}[{str(key)[:40]!r}]", value)
    elif isinstance(expression, np.ndarray):
        refuse_texts(what, expression.tolist())
    elif isinstance(expression, (list, tuple, set, frozenset)):
        for value in expression:
            refuse_texts(what, value)
