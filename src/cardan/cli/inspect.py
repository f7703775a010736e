"""``cardan inspect``: a scene and its equations explained, on the screen or on a page.

Show what a scene is made of and the equations that follow from it.

The graph of bodies and joints, coordinates, parameters with units, frames, the equations in the
form of a textbook as far as they can be read, with the bodies and forces their terms come from,
what stays constant, base parameters, and how many operations every part costs. Nothing is
compiled.

examples:
  cardan inspect pendulum.yaml
        everything as text
  cardan inspect arm.urdf -o arm.html
        one page for any browser, offline, with drawn graph and set formulas
  cardan inspect arm.urdf -o arm.tex
        the same for LaTeX; arm.md for Markdown
  cardan inspect arm.urdf -o arm.tex --notation kane
        in the symbols of a book: F_r + F_r* = 0; rs and gc are others
  cardan inspect arm.urdf --json
        names, units, values, frames and counts for another program
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from pathlib import Path
from textwrap import shorten
from typing import TYPE_CHECKING, Any

from .options import scene as scene_options
from .terminal import console

if TYPE_CHECKING:
    from rich.console import Console

    from ..api.scene import Scene
    from ..explain.content import Block, Document, Math, Table, Text, Written


# rows of a table and characters of a formula on a screen
ROWS, WIDTH = 24, 600


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    scene_options.arguments(parser)
    scene_options.method(parser.add_argument_group("the equations"))
    results = parser.add_argument_group("results")
    results.add_argument("-o", "--output", metavar="PAGE", type=Path,
                         help="a page: .html, .tex or .md")  # fmt: skip
    results.add_argument("--notation", metavar="NAME", default="cardan",
                         help="symbols of a book: cardan, rs (Roberson and Schwertassek), gc "
                              "(Géradin and Cardona) or kane")  # fmt: skip
    results.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """Load, derive, show."""
    from ..api.equations import FiniteElementEquations
    from ..equations.reading.book_symbols import book_notation
    from ..explain import document, ending_of, explain, facts
    from ..pipeline import derive
    from .terminal import progress

    if options.output is not None:
        ending_of(options.output)
    book_notation(options.notation)
    scene = scene_options.read(options)
    with progress() as show:
        show("deriving")
        equations = derive(scene, method=options.method)
        if options.json:
            meshed = isinstance(equations, FiniteElementEquations)
            summary = _meshed(equations) if meshed else facts(equations)
            print(json.dumps(summary, indent=1))
        if options.output is not None:
            explain(equations, options.output, show, options.notation)
        written = options.json or options.output
        page = None if written else document(equations, show, options.notation)
    out = console()
    if page is not None:
        display(scene, str(equations), page, out)
    elif not options.json:
        out.print(f"wrote {options.output}", soft_wrap=True)
    return 0


def _meshed(equations: Any) -> dict[str, object]:
    """A scene in absolute coordinates: the elements that stand for its equations."""
    counts = {k.name: sum(len(g) for g in equations.groups if g.kind is k) for k in equations.kinds}
    return {"name": equations.system.name, "coordinates": equations.coordinates, "elements": counts}


def display(scene: Scene, overview: str, page: Document, out: Console) -> None:
    """A document on a screen."""
    from ..explain.content import Figure

    out.print(str(scene.graph), soft_wrap=True)
    out.print()
    out.print(overview, soft_wrap=True)
    for section in page.sections:
        if all(isinstance(block, Figure) for block in section.blocks):
            continue  # the graph stands above
        out.print()
        out.print(section.title.upper(), soft_wrap=True)
        for block in section.blocks:
            _block(block, out)


def _block(block: Block, out: Console) -> None:
    from ..explain import content as d

    if isinstance(block, d.Paragraph):
        out.print(_text(block.text), soft_wrap=True)
    elif isinstance(block, d.Listing):
        for item in block.items:
            out.print(f"- {_text(item)}", soft_wrap=True)
    elif isinstance(block, d.Formula):
        line = f"  {shorten(block.text, WIDTH, placeholder=' ...')}"
        who = ", ".join(dict.fromkeys(who for who, _ in block.terms)) or block.origin
        out.print(line + (f"    from {who}" if who else ""), soft_wrap=True)
    elif isinstance(block, d.Folded):
        out.print(f"{block.title}: -o PAGE.html, .tex or .md has it", soft_wrap=True)
    elif isinstance(block, d.Table):
        _table(block, out)


def _text(text: Text) -> str:
    return "".join(part if isinstance(part, str) else _written(part) for part in text)


def _written(part: Math | Written) -> str:
    return getattr(part, "text", "") or str(getattr(part, "expression", ""))


def _table(table: Table, out: Console) -> None:
    from rich.table import Table as Drawn

    # titles and cells are users' names: no markup in them; symbols are for formulas that are set
    columns = [k for k, name in enumerate(table.head) if name != "symbol"]
    drawn = Drawn(box=None, pad_edge=False, title=None)
    for k in columns:
        drawn.add_column(table.head[k])
    for row in table.rows[:ROWS]:
        cells: Sequence[object] = [row[k] for k in columns]
        drawn.add_row(*(f"{c:.6g}" if isinstance(c, (int, float)) else str(c) for c in cells))
    out.print(drawn)
    if len(table.rows) > ROWS:
        more = len(table.rows) - ROWS
        out.print(f"... {more} more: -o PAGE.html or --json lists all", soft_wrap=True)
