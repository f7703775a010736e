"""Pieces of HTML that notebooks show: they take colors and letters from the page they stand in.

Text that comes from outside is escaped here; what is already HTML is said to be so.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

CELL = "text-align:left;padding:1px 10px 1px 0;vertical-align:top"


class Html(str):
    """Text that is HTML already and is not escaped again."""

    __slots__ = ()


def written(text: object) -> str:
    """Anything as HTML."""
    return str(text) if isinstance(text, Html) else escape(str(text))


def table(head: Sequence[object], rows: Iterable[Sequence[object]]) -> Html:
    """Rows below their titles."""

    def row(tag: str, cells: Sequence[object]) -> str:
        made = (f'<{tag} style="{CELL}">{written(cell)}</{tag}>' for cell in cells)
        return f"<tr>{''.join(made)}</tr>"

    body = "".join(row("td", cells) for cells in rows)
    return Html(f'<table style="border-collapse:collapse">{row("th", head)}{body}</table>')


def details(summary: object, body: Html, shown: bool = False) -> Html:
    """What unfolds by a click."""
    state = ' open="open"' if shown else ""
    return Html(f"<details{state}><summary>{written(summary)}</summary>{body}</details>")


def paragraph(text: object) -> Html:
    return Html(f'<p style="margin:4px 0">{written(text)}</p>')


def text_block(text: object) -> Html:
    """Text that keeps its lines."""
    return Html(f'<pre style="margin:4px 0">{written(text)}</pre>')


def block(*parts: Html) -> str:
    """A whole output; what is wider than the page scrolls by itself."""
    return f'<div style="overflow-x:auto">{"".join(parts)}</div>'
