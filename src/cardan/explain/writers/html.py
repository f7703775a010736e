"""A document as one self-contained HTML page, or as the output of a cell of a notebook.

Formulas are MathML; there is no script, and nothing is fetched.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...equations.reading.notation import Notation
from .. import content as d
from ..style import STYLE

if TYPE_CHECKING:
    import sympy

    from ...equations.reading.mathml import Printer
    from ..breaking import Breaker

# letters of a piece of a formula: what fits a telephone
ROOM = 26.0
# letters of a name, and of its index, that a formula shows in full
LONGEST, INDEX = 24, 18
# letters of a formula that fits a table on a telephone, and rows of a table that are not folded
COLUMN, ROWS = 14.0, 60
# what blocks are told to look like: on pages by the style sheet, in notebooks each by itself, in
# the colors and letters of what stands around it
CELL = "padding:1px 10px 1px 0;vertical-align:top;text-align:"
LOOKS = {
    "paragraph": "margin:4px 0",
    "quiet": "margin:4px 0;opacity:.75",
    "formula": "margin:4px 0 4px 2em;text-indent:-2em;line-height:1.8",
    "origin": "margin-left:1.5em;opacity:.75;font-style:italic",
    "figure": "margin:8px 0",
    "table": "border-collapse:collapse;margin:6px 0",
    "cell": CELL + "left",
    "number": CELL + "right",
    "wide": CELL + "left",
}
PAGE = {name: f' class="{name}"' for name in ("quiet", "formula", "origin", "number", "wide")}
FRAGMENT = {name: f' style="{style}"' for name, style in LOOKS.items()}


def write(document: d.Document, path: Path) -> dict[str, str]:
    """Endings of files -> their text."""
    return {".html": page(document)}


def page(document: d.Document) -> str:
    """The page; every name in it is the user's and is escaped."""
    writer = _Writer(document, PAGE)
    title = escape(document.title)
    body = [f"<header><h1>{title}</h1>", *writer.blocks(document.lead), "</header>"]
    for number, section in enumerate(document.sections, 1):
        body.append(f"<section><h2><span>{number}</span> {escape(section.title)}</h2>")
        body += [*writer.blocks(section.blocks), "</section>"]
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta http-equiv="Content-Security-Policy" '
        "content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
        f"<title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
        + "\n".join(body)
        + "\n</body>\n</html>\n"
    )


def fragment(document: d.Document) -> str:
    """The output of a cell; what is wider than the page around it scrolls by itself."""
    writer = _Writer(document, FRAGMENT)
    body = [*writer.heading(document.title), *writer.blocks(document.lead)]
    for section in document.sections:
        body += [*writer.heading(section.title), *writer.blocks(section.blocks)]
    return "\n".join(['<div style="overflow-x:auto">', *body, "</div>"])


class _Writer:
    """Writes blocks.

    Args:
        document: Whose notation is used.
        looks: Attributes by what a block is.
    """

    def __init__(self, document: d.Document, looks: Mapping[str, str]) -> None:
        self._symbols = _Names({name: _fitting(s) for name, s in document.symbols.items()})
        self._looks = looks

    # these load SymPy, which documents without formulas do not need

    @cached_property
    def _printer(self) -> Printer:
        from ...equations.reading.mathml import Printer

        return Printer(self._symbols)

    @cached_property
    def _breaker(self) -> Breaker:
        from ..breaking import Breaker

        return Breaker(self._symbols, ROOM)

    def _look(self, name: str) -> str:
        return self._looks.get(name, "")

    def heading(self, title: str) -> Iterator[str]:
        """A title within a fragment, where there is one."""
        if title:
            yield f"<p{self._look('paragraph')}><b>{escape(title)}</b></p>"

    def blocks(self, blocks: Iterable[d.Block]) -> Iterator[str]:
        """Blocks as lines of HTML."""
        for block in blocks:
            yield from self.block(block)

    def block(self, block: d.Block) -> Iterator[str]:
        """A block as lines of HTML."""
        if isinstance(block, d.Paragraph):
            look = self._look("quiet" if block.quiet else "paragraph")
            yield f"<p{look}>{self._text(block.text)}</p>"
        elif isinstance(block, d.Formula):
            yield from self._formula(block)
        elif isinstance(block, d.Table):
            yield from self._table(block)
        elif isinstance(block, d.Figure):
            caption = f"<figcaption>{escape(block.caption)}</figcaption>" * bool(block.caption)
            yield f"<figure{self._look('figure')}>{block.svg}{caption}</figure>"
        elif isinstance(block, d.Listing):
            items = "".join(f"<li>{self._text(text)}</li>" for text in block.items)
            yield f"<ul>{items}</ul>"
        else:
            yield f"<details><summary>{escape(block.title)}</summary>"
            yield from self.blocks(block.blocks)
            yield "</details>"

    def _text(self, text: d.Text) -> str:
        return "".join(self._inline(part) for part in text)

    def _inline(self, part: d.Inline) -> str:
        if isinstance(part, str):
            return escape(part)
        if isinstance(part, d.Written):
            return f"<math>{part.mathml}</math>"
        return self._flow(part.expression)

    def _formula(self, formula: d.Formula) -> Iterator[str]:
        left = f"<math>{self._sign(formula.left)}<mo>=</mo></math>"
        origin = f" <span{self._look('origin')}>from {escape(formula.origin)}</span>"
        origin *= bool(formula.origin)
        yield f"<div{self._look('formula')}>{left} {self._flow(formula.right)}{origin}</div>"
        if not formula.terms:
            return
        yield '<dl class="terms">'
        for n, (who, expression) in enumerate(formula.terms):
            sign = "+" * (not d.is_negative(expression)) if n else "="
            mark = f"<math>{_operator(sign, True)}</math> " if sign else ""
            yield f"<dt>{escape(who)}</dt><dd>{mark}{self._flow(expression, n > 0)}</dd>"
        yield "</dl>"

    def _flow(self, expression: sympy.Expr, goes_on: bool = False) -> str:
        """An expression in pieces between which lines may end.

        Args:
            expression: From SymPy.
            goes_on: Something to add it to stands before it.
        """
        parts = []
        for segment in self._breaker.segments(expression):
            parts.append(self._segment(segment, goes_on))
            goes_on = True
        return " ".join(parts)

    def _segment(self, segment: sympy.Expr, goes_on: bool) -> str:
        parts = []
        for sign in segment.before:
            parts.append(_operator(sign, goes_on))
            goes_on = False
        if segment.body is not None:
            parts.append(self._printer.written(segment.body))
        for sign, power in segment.after:
            symbol = _operator(sign)
            raised = (
                f"<msup>{symbol}{self._printer.written(power)}</msup>" if power is not None else ""
            )
            parts.append(raised or symbol)
        return f'<math displaystyle="true">{"".join(parts)}</math>'

    def _sign(self, sign: Notation) -> str:
        """The left side of a formula."""
        sign = _fitting(sign)
        variant = ' mathvariant="normal"' if len(sign.character) > 1 else ""
        base = f"<mi{variant}>{escape(sign.character)}</mi>"
        if sign.mark == "star":
            base = f"<msup>{base}<mo>*</mo></msup>"
        if sign.dots:
            base = f"<mover>{base}<mo>{'.' * sign.dots}</mo></mover>"
        if not sign.index:
            return base
        return f'<msub>{base}<mi mathvariant="normal">{escape(sign.index)}</mi></msub>'

    def _table(self, table: d.Table) -> Iterator[str]:
        columns = [
            self._look(self._column([row[k] for row in table.rows])) for k in range(len(table.head))
        ]
        heads = "".join(
            f"<th{kind}>{escape(name)}</th>" for name, kind in zip(table.head, columns, strict=True)
        )
        rows = "\n".join(
            "<tr>"
            + "".join(f"<td{c}>{self._cell(x)}</td>" for x, c in zip(row, columns, strict=True))
            + "</tr>"
            for row in table.rows
        )
        head = f"<thead><tr>{heads}</tr></thead>\n" * any(table.head)
        markup = f"<table{self._look('table')}>{head}<tbody>{rows}</tbody></table>"
        if len(table.rows) > ROWS:
            markup = f"<details><summary>{len(table.rows)} rows</summary>{markup}</details>"
        yield markup

    def _column(self, cells: list[str | float | d.Math]) -> str:
        """Numbers stand to the right; wide formulas are left out where there is no room."""
        if cells and all(isinstance(cell, (int, float)) for cell in cells):
            return "number"
        formulas = [cell.expression for cell in cells if isinstance(cell, d.Math)]
        wide = any(self._breaker.width(expression) > COLUMN for expression in formulas)
        return "wide" if wide else "cell"

    def _cell(self, cell: str | float | d.Math) -> str:
        if isinstance(cell, d.Math):
            return self._flow(cell.expression)
        if isinstance(cell, str):
            # long names break at their dots
            text = escape(cell)
            return text.replace(".", ".<wbr/>") if _is_name(cell) else text
        return _number(cell)


def _is_name(cell: str) -> bool:
    return "." in cell and " " not in cell


def _number(value: float) -> str:
    """With a true minus, and powers of ten as such."""
    digits, _, power = f"{value:.6g}".partition("e")
    text = digits.replace("-", "−")
    return f"{text}\u202f·\u202f10<sup>{int(power)}</sup>".replace("-", "−") if power else text


def _operator(sign: str, infix: bool = False) -> str:
    """Signs and brackets; words stand upright. ``infix``: with space on both sides."""
    if sign[0].isalpha():
        word, bracket = (sign[:-1], "<mo>(</mo>") if sign.endswith("(") else (sign, "")
        space = '<mspace width="0.3em"/>' if not bracket else ""
        return f'<mi mathvariant="normal">{escape(word)}</mi>{space}{bracket}'
    stretch = ' stretchy="false"' if sign in "(){}" else ""
    form = ' form="infix"' if infix and not stretch else ""
    return f"<mo{stretch}{form}>{escape(sign)}</mo>"


def _fitting(sign: Notation) -> Notation:
    """Names that no line could hold are cut within formulas; tables have them in full."""
    index = ", ".join(_cut(part, INDEX) for part in sign.index.split(", "))
    return Notation(_cut(sign.letter, LONGEST), _cut(index, 2 * INDEX + 2), sign.dots, sign.mark)


def _cut(name: str, most: int) -> str:
    return name if len(name) <= most else name[: most - 1] + "…"


class _Names(dict[str, Notation]):
    """Notation of every name; unknown ones are words."""

    def get(self, name: str, default: object = None) -> Any:
        """Same as ``dict.get``, but never None."""
        return super().get(name) or _fitting(Notation(name))
