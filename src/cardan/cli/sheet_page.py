"""The equation sheet as one self-contained HTML page: drawn graph, set formulas, no script."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import Any

from .sheet import Formula, Sheet, Table

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #1c2733; background: #fff;
       max-width: 68rem; margin: 2rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.6rem; margin: 0 0 .2rem; } h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
p { margin: .3rem 0; color: #4a5a6a; } .wide { overflow-x: auto; padding: .3rem 0; }
table.data { border-collapse: collapse; font-size: .9rem; }
table.data th { text-align: left; font-weight: 600; border-bottom: 1px solid #9ab; }
table.data th, table.data td { padding: .15rem 1.2rem .15rem 0; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
math { font-size: 1.05rem; }
mtable { border: solid #1c2733; border-width: 0 1.5px; border-radius: .5em; }
mtable.lines { border: none; } mtable.lines mtd { text-align: left; padding: .1em 0; }
mtd { padding: .25em .8em; } math[display=block] { text-align: left; margin: .4rem 0 .4rem 1rem; }
pre { font-size: .8rem; background: #f4f7fa; padding: .7rem; overflow-x: auto; }
details { margin: .4rem 0; } summary { cursor: pointer; color: #356; }
svg { max-width: 100%; height: auto; }
@media print { body { margin: 0; max-width: none; } details { display: none; } }
"""
# what may open a table at once; longer ones are folded
OPEN_ROWS = 40


def page(found: Sheet) -> str:
    """The page; every name in it is the user's and is escaped."""
    title = escape(found.name)
    body = [
        f"<h1>{title}</h1>",
        *(f"<p>{escape(line.strip())}</p>" for line in found.overview.splitlines()[:2]),
        *(f"<p>Note: {escape(note)}</p>" for note in found.notes),
        "<h2>Bodies and joints</h2>",
        f'<div class="wide">{found.graph_svg}</div>',
        "<h2>Equations of motion</h2>",
        f"<p>{BOUND if any(f.letter == 'G' for f in found.formulas) else GENERAL}</p>",
        *(part for formula in found.formulas for part in _formula(formula)),
        *(part for table in found.tables for part in _table(table)),
        "<h2>Sources</h2>",
        *(f"<p>{escape(source)}</p>" for source in found.sources),
    ]
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta http-equiv="Content-Security-Policy" '
        "content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
        f"<title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
        + "\n".join(body)
        + "\n</body>\n</html>\n"
    )


def _math(content: str, display: str = "inline") -> str:
    return f'<math display="{display}">{content}</math>'


BALANCE = (
    "<mi>M</mi><mover><mi>u</mi><mo>.</mo></mover><mo>+</mo><mi>h</mi>"
    "<mo>=</mo><mi>f</mi><mo>+</mo><mi>τ</mi>"
)
FORCE = "<mo>+</mo><msup><mi>G</mi><mi>T</mi></msup><mi>λ</mi>"
CLOSING = "<mi>G</mi><mover><mi>u</mi><mo>.</mo></mover><mo>=</mo><mi>γ</mi>"
RATES = "where the rates of q are not given below, they are u"
GENERAL = f"{_math(BALANCE)} with τ what is applied from outside; {RATES}"
BOUND = (
    f"{_math(BALANCE + FORCE)} and {_math(CLOSING)} with τ what is applied from outside and λ the "
    f"forces of constraint; {RATES}"
)


def _formula(formula: Formula) -> Iterable[str]:
    yield f"<p><b>{formula.letter}</b>, {escape(formula.about)}</p>"
    for name, math in formula.math:
        symbol = LETTERS.get(formula.letter, f"<mi>{formula.letter}</mi>")
        index = f'<mi mathvariant="normal">{escape(name)}</mi>' if name else ""
        symbol = f"<msub>{symbol}{index}</msub>" if name else symbol
        yield f'<div class="wide">{_math(symbol + "<mo>=</mo>" + math, "block")}</div>'
    if formula.math:
        yield from _folded("as text", formula.lines)
        return
    yield f"<p>{escape(' '.join(formula.lines))}</p>"
    if formula.shared:
        yield from _folded("with named intermediates", formula.shared)


LETTERS = {"qdot": "<mover><mi>q</mi><mo>.</mo></mover>"}


def _folded(title: str, lines: Sequence[str]) -> Iterable[str]:
    text = escape("\n".join(lines))
    yield f"<details><summary>{escape(title)}</summary><pre>{text}</pre></details>"


def _table(table: Table) -> Iterable[str]:
    title, head, rows = table
    heads = "".join(f"<th>{escape(name)}</th>" for name in head)
    cells = "\n".join("<tr>" + "".join(map(_cell, row)) + "</tr>" for row in rows)
    text = f'<table class="data"><tr>{heads}</tr>\n{cells}</table>'
    yield f"<h2>{escape(HEADINGS.get(title, title))}</h2>"
    if len(rows) > OPEN_ROWS:
        text = f"<details><summary>{len(rows)} rows</summary>{text}</details>"
    yield f'<div class="wide">{text}</div>'


HEADINGS = {
    "coordinate": "Coordinates",
    "speed": "Speeds",
    "parameter": "Parameters",
    "input": "Inputs",
    "frame": "Frames",
    "operations in": "Operations",
}


def _cell(value: Any) -> str:
    if isinstance(value, float | int):
        return f'<td class="number">{value:.6g}</td>'
    return f"<td>{escape(str(value))}</td>"
