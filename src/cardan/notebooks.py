"""Notebook views of equations, models and motions.

``explain`` writes it and stands above all of them: the package, which knows both, hands it over.
"""

from __future__ import annotations

from collections.abc import Callable

# kind of text -> who writes it
WRITERS: dict[str, Callable[[object], str]] = {}


def html(result: object) -> str:
    """The document as HTML in the colors and fonts of the page around it."""
    return WRITERS["html"](result)
