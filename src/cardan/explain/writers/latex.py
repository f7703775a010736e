"""A document as a LaTeX file that compiles by itself with pdflatex, xelatex or lualatex."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING
from unicodedata import name as unicode_name

from ...equations.reading.notation import GREEK
from .. import content as d
from ..tex import TeX

if TYPE_CHECKING:
    import sympy

# letters of a piece of a formula
ROOM = 44.0
# rows of a table that stand before the words "and so on"
ROWS = 400
DISPLAYED = r"\displaystyle "

PREAMBLE = r"""\documentclass[11pt,a4paper]{article}
\usepackage{iftex}
\ifPDFTeX\usepackage[T1]{fontenc}\usepackage[utf8]{inputenc}\fi
\usepackage{lmodern}
\usepackage{textcomp}
\usepackage{amsmath,amssymb}
\usepackage{array,booktabs,longtable}
\usepackage{tikz}
\usepackage[margin=27mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt plus 2pt}
\emergencystretch=3em
\newcommand{\formula}[1]{{\par\medskip\raggedright\hangindent=3em\hangafter=1 #1\par}}
\newcommand{\share}[2]{{\par\raggedright\leftskip=2em\hangindent=9em\hangafter=1
  \parbox[t]{8.5em}{\raggedright\small\itshape #1}\hspace{0.5em}#2\par}}
"""
# what TeX takes for commands or layout, in text
_TEXT = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "%": r"\%",
    "_": r"\_\allowbreak{}",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': r"\textquotedbl{}",
    "`": r"\textasciigrave{}",
    "'": r"\textquotesingle{}",
    "[": "{[}",
    "]": "{]}",
}
# characters of our own text
_MARKS = {"·": r"\textperiodcentered{}", "–": "--", "−": r"\ensuremath{-}", "…": r"\ldots{}",
          "²": r"\textsuperscript{2}", "³": r"\textsuperscript{3}",
          "ᵀ": r"\textsuperscript{T}"}  # fmt: skip


def write(document: d.Document, path: Path) -> dict[str, str]:
    """Endings of files -> their text."""
    return {".tex": text(document)}


def text(document: d.Document) -> str:
    """The file; every name in it is the user's and is escaped."""
    writer = _Writer(document)
    lines = [PREAMBLE, rf"\title{{{escaped(document.title)}}}", r"\author{}\date{}"]
    lines += [r"\begin{document}", r"\maketitle"]
    lines += [part for one in document.lead for part in writer.block(one)]
    for section in document.sections:
        lines += ["", rf"\section{{{escaped(section.title)}}}"]
        lines += [part for one in section.blocks for part in writer.block(one)]
    return "\n".join([*lines, r"\end{document}", ""])


class _Writer:
    """Writes blocks.

    Args:
        document: Whose notation is used.
    """

    def __init__(self, document: d.Document) -> None:
        from ..breaking import Breaker

        self._tex = TeX(document.symbols, plain)
        self._breaker = Breaker(document.symbols, ROOM)

    def block(self, block: d.Block) -> Iterator[str]:
        """A block as lines of LaTeX."""
        if isinstance(block, d.Paragraph):
            size = r"\small " if block.quiet else ""
            yield f"{{{size}{self._text(block.text)}\\par}}"
        elif isinstance(block, d.Formula):
            origin = (
                rf"\quad{{\small\itshape from {escaped(block.origin)}}}" if block.origin else ""
            )
            left = self._tex.sign(block.left)
            yield rf"\formula{{${left} =$ {self._flow(block.right)}{origin}}}"
            for n, (who, expression) in enumerate(block.terms):
                mark = "$+$" * (not d.is_negative(expression)) if n else "$=$"
                yield rf"\share{{{escaped(who)}}}{{{mark} {self._flow(expression)}}}"
        elif isinstance(block, d.Table):
            yield from self._table(block)
        elif isinstance(block, d.Figure):
            yield r"\begin{center}"
            yield block.tikz
            yield rf"\\[4pt]{{\small {escaped(block.caption)}}}"
            yield r"\end{center}"
        elif isinstance(block, d.Listing):
            yield r"\begin{itemize}"
            yield from (rf"\item {self._text(item)}" for item in block.items)
            yield r"\end{itemize}"
        else:
            yield rf"\subsection*{{{escaped(block.title)}}}"
            for inner in block.blocks:
                yield from self.block(inner)

    def _text(self, parts: d.Text) -> str:
        return "".join(self._inline(part) for part in parts)

    def _inline(self, part: d.Inline) -> str:
        if isinstance(part, str):
            return escaped(part)
        return f"${part.latex}$" if isinstance(part, d.Written) else self._flow(part.expression)

    def _flow(self, expression: sympy.Expr) -> str:
        return " ".join(
            f"${self._tex.segment(segment, DISPLAYED)}$"
            for segment in self._breaker.segments(expression)
        )

    def _table(self, table: d.Table) -> Iterator[str]:
        if not table.rows:
            return
        yield rf"{{\small\begin{{longtable}}{{{_columns(table)}}}"
        yield r"\toprule"
        yield " & ".join(escaped(name) for name in table.head) + r" \\"
        yield r"\midrule\endhead"
        for row in table.rows[:ROWS]:
            yield " & ".join(self._cell(cell) for cell in row) + r" \\"
        yield r"\bottomrule"
        yield r"\end{longtable}}"
        if len(table.rows) > ROWS:
            yield f"{len(table.rows) - ROWS} more rows.\n"

    def _cell(self, cell: str | float | d.Math) -> str:
        if isinstance(cell, d.Math):
            return self._flow(cell.expression)
        return escaped(cell) if isinstance(cell, str) else f"${cell:.6g}$"


def _columns(table: d.Table) -> str:
    """Numbers to the right; the others share the measure by what is in them."""
    columns = [[row[k] for row in table.rows] for k in range(len(table.head))]
    numbers = [all(isinstance(cell, (int, float)) for cell in column) for column in columns]
    sizes = [
        0 if number else min(max(len(head), *(_length(cell) for cell in column)), 40)
        for head, column, number in zip(table.head, columns, numbers, strict=True)
    ]
    share = (0.9 - 0.11 * sum(numbers)) / (sum(sizes) or 1)
    text = r">{{\raggedright\arraybackslash}}p{{{:.3f}\linewidth}}"
    return "".join(text.format(max(share * size, 0.06)) if size else "r" for size in sizes)


def _length(cell: str | float | d.Math) -> int:
    return len(str(cell.expression if isinstance(cell, d.Math) else cell))


def plain(math: str) -> str:
    """Math mode in ASCII: letters that fonts have are text, others their number."""
    return "".join(c if c.isascii() else _foreign(c, math=True) for c in math)


def escaped(text: str) -> str:
    """Text of users for text mode."""
    characters = "".join(
        _TEXT.get(c, c) if c.isascii() else _MARKS.get(c) or _foreign(c, math=False)
        for c in re.sub(r"\s+", " ", text)
    )
    # names break at their dots; two signs are not dash
    return re.sub(r"-(?=-)", "-{}", re.sub(r"\.(?=[^\s.])", r".\\allowbreak{}", characters))


def _foreign(c: str, math: bool) -> str:
    """Latin letters as they are, Greek ones by their command, others by their number."""
    character_name = unicode_name(c, "")
    if character_name.startswith("LATIN") and ord(c) < 0x180:
        return rf"\text{{{c}}}" if math else c
    parts = character_name.split()
    if character_name.startswith("GREEK") and len(parts) == 4 and parts[2] == "LETTER":
        letter = parts[3].lower().replace("lamda", "lambda")
        letter = letter.capitalize() if parts[1] == "CAPITAL" else letter
        if letter in GREEK:
            return f"\\{letter}{{}}" if math else rf"\ensuremath{{\{letter}}}"
    number = rf"\texttt{{U+{ord(c):04X}}}"
    return rf"\text{{{number}}}" if math else number
