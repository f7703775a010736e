"""A document as Markdown: formulas between dollar signs, the drawing in a file beside it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import quote

from .. import content as d
from ..tex import TeX

if TYPE_CHECKING:
    import sympy

# letters of a line of a formula, and of its pieces
LINE, ROOM = 76.0, 60.0
# signs that mean something to Markdown or to its HTML
_MARKED = re.compile(r"([\\`*_{}\[\]#+!|~$^])")
_HTML = {"&": "&amp;", "<": "&lt;", ">": "&gt;"}
# signs that Markdown or HTML would read before the formula is set
_INSIDE = {"<": r"\lt{}", ">": r"\gt{}", "|": r"\vert{}", "`": r"\unicode{96}"}


def write(document: d.Document, path: Path) -> dict[str, str]:
    """Endings of files -> their text."""
    writer = _Writer(document, path.stem)
    lines = [f"# {escaped(document.title)}", ""]
    lines += [part for one in document.lead for part in writer.block(one)]
    for section in document.sections:
        lines += [f"## {escaped(section.title)}", ""]
        lines += [part for one in section.blocks for part in writer.block(one)]
    text = re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).rstrip() + "\n"
    return {".md": text} | ({".svg": writer.drawing} if writer.drawing else {})


class _Writer:
    """Writes blocks.

    Args:
        document: Whose notation is used.
        stem: Name of the file without its ending: the drawing is called after it.
    """

    def __init__(self, document: d.Document, stem: str) -> None:
        from ..breaking import Breaker

        self._tex = TeX(document.symbols, _safe)
        self._breaker = Breaker(document.symbols, ROOM)
        self._stem = stem
        self.drawing = ""

    def block(self, block: d.Block) -> Iterator[str]:
        """A block as lines of Markdown."""
        if isinstance(block, d.Paragraph):
            yield f"{self._text(block.text)}\n"
        elif isinstance(block, d.Formula):
            yield from self._formula(block)
        elif isinstance(block, d.Table):
            yield from self._table(block)
        elif isinstance(block, d.Figure):
            self.drawing = block.svg
            yield f"![{escaped(block.caption)}]({quote(self._stem)}.svg)\n"
        elif isinstance(block, d.Listing):
            yield from (f"- {self._text(item)}" for item in block.items)
            yield ""
        else:
            yield f"<details><summary>{escaped(block.title)}</summary>\n"
            for inner in block.blocks:
                yield from self.block(inner)
            yield "</details>\n"

    def _text(self, parts: d.Text) -> str:
        return "".join(self._inline(part) for part in parts)

    def _inline(self, part: d.Inline) -> str:
        if isinstance(part, str):
            return escaped(part)
        if isinstance(part, d.Written):
            return f"${part.latex}$"
        return f"${self._tex.expression(part.expression)}$"

    def _formula(self, formula: d.Formula) -> Iterator[str]:
        rows = self._lines(f"{self._tex.sign(formula.left)} &=", formula.right)
        yield "$$\n\\begin{aligned}\n" + " \\\\\n".join(rows) + "\n\\end{aligned}\n$$\n"
        if formula.origin:
            yield f"*from {escaped(formula.origin)}*\n"
        for who, expression in formula.terms:
            yield f"- {escaped(who)}: ${self._tex.expression(expression)}$"
        if formula.terms:
            yield ""

    def _lines(self, left: str, expression: sympy.Expr) -> list[str]:
        """An expression on as many lines as it needs."""
        rows, used = [left], 0.0
        for segment in self._breaker.segments(expression):
            size = 3.0 * len(segment.before) + 2.0 * len(segment.after)
            size += self._breaker.width(segment.body) if segment.body is not None else 0.0
            if used and used + size > LINE:
                rows, used = [*rows, r"&\quad"], 0.0
            rows[-1] += f" {self._tex.segment(segment)}"
            used += size
        return rows

    def _table(self, table: d.Table) -> Iterator[str]:
        if not table.rows:
            return
        numbers = [
            all(isinstance(row[k], (int, float)) for row in table.rows)
            for k in range(len(table.head))
        ]
        yield "| " + " | ".join(escaped(name) or " " for name in table.head) + " |"
        yield "|" + "|".join(" ---: " if number else " --- " for number in numbers) + "|"
        for row in table.rows:
            yield "| " + " | ".join(self._cell(cell) for cell in row) + " |"
        yield ""

    def _cell(self, cell: str | float | d.Math) -> str:
        if isinstance(cell, d.Math):
            return f"${self._tex.expression(cell.expression)}$"
        return escaped(cell) if isinstance(cell, str) else f"{cell:.6g}"


def _safe(math: str) -> str:
    """A name within a formula."""
    return "".join(_INSIDE.get(c, c) for c in " ".join(math.split()))


def escaped(text: str) -> str:
    """Text of users."""
    marked = _MARKED.sub(r"\\\1", re.sub(r"\s+", " ", text))
    return "".join(_HTML.get(c, c) for c in marked)
