"""``cardan inspect``: the equations of a scene on one sheet, to read or to keep."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from pathlib import Path
from textwrap import shorten
from typing import TYPE_CHECKING, Any

from ..errors import ModelError
from . import reading
from .terminal import console

if TYPE_CHECKING:
    from rich.console import Console

    from ..equations.absolute.record import Absolute
    from ..model import Model
    from .sheet import Sheet

DESCRIPTION = """\
Show what a scene is made of and the equations that follow from it.

The graph of bodies and joints, coordinates, parameters with units, frames, the equations in the
form of a textbook as far as they can be read, and how many operations every part costs. Nothing is
compiled."""

EPILOG = """\
examples:
  cardan inspect pendulum.yaml
        everything as text
  cardan inspect arm.urdf -o arm.html
        one page for any browser, offline, with drawn graph and set formulas
  cardan inspect arm.urdf --json
        names, units, values, frames and counts for another program"""

# rows of a table and characters of a formula on a screen
ROWS, WIDTH = 24, 600


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    reading.arguments(parser)
    reading.method(parser.add_argument_group("the equations"))
    results = parser.add_argument_group("results")
    results.add_argument("-o", "--output", metavar="PAGE.html", type=Path, help="one HTML page")
    results.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """Load, derive, show."""
    from ..equations.absolute.record import Absolute
    from ..pipeline import derive
    from .sheet import facts, sheet
    from .terminal import progress

    scene = reading.read(options)
    with progress() as show:
        show("deriving")
        equations = derive(scene, method=options.method)
        if isinstance(equations, Absolute):
            return _meshed(scene, equations, options)
        if options.json:
            print(json.dumps(facts(equations), indent=1))
        if options.output is None and options.json:
            return 0
        show("simplifying")
        found = sheet(scene, equations)
    if options.output is not None:
        from ..view.page import publish
        from .sheet_page import page

        publish(options.output, page(found))
    if not options.json:
        out = console()
        if options.output is None:
            display(found, out)
        else:
            out.print(f"wrote {options.output}", soft_wrap=True)
    return 0


def _meshed(scene: Model, equations: Absolute, options: argparse.Namespace) -> int:
    """A scene in absolute coordinates: its graph, and the elements that stand for its equations.

    Raises:
        ModelError: a page is asked for.
    """
    if options.output is not None:
        raise ModelError(
            f"{options.file}: a scene with beams has functions of elements, not equations of its "
            "own, so that there is no page of them; leave out -o"
        )
    if options.json:
        counts = {
            k.name: sum(len(g) for g in equations.groups if g.kind is k) for k in equations.kinds
        }
        told = {"name": equations.system.name, "coordinates": equations.coordinates}
        print(json.dumps({**told, "elements": counts}, indent=1))
        return 0
    out = console()
    out.print(str(scene.graph), soft_wrap=True)
    out.print()
    out.print(str(equations), soft_wrap=True)
    return 0


def display(found: Sheet, out: Console) -> None:
    """The sheet on a screen."""
    out.print(found.graph_text, soft_wrap=True)
    out.print()
    out.print(found.overview, soft_wrap=True)
    for title, head, rows in found.tables:
        out.print()
        _table(out, title, head, rows)
    out.print()
    bound = any(formula.letter == "G" for formula in found.formulas)
    general = "M udot + h = f + tau"
    general += " + Gᵀ lam, G udot = gamma" if bound else ""
    out.print(general, soft_wrap=True)
    for formula in found.formulas:
        for line in formula.lines:
            out.print(f"  {shorten(line, WIDTH, placeholder=' ...')}", soft_wrap=True)
    out.print()
    for source in found.sources:
        out.print(f"source: {source}", soft_wrap=True)


def _table(out: Console, title: str, head: Sequence[str], rows: Sequence[Sequence[Any]]) -> None:
    from rich.table import Table

    # titles and cells are users' names: no markup in them
    made = Table(box=None, pad_edge=False, title=None)
    for name in (title, *head[1:]):
        made.add_column(name)
    for row in rows[:ROWS]:
        made.add_row(*(f"{cell:.6g}" if isinstance(cell, float) else str(cell) for cell in row))
    out.print(made)
    if len(rows) > ROWS:
        out.print(f"... {len(rows) - ROWS} more: -o PAGE.html or --json lists all", soft_wrap=True)
