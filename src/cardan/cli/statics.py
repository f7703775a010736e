"""``cardan statics``: a mechanism under loads that change.

Equilibria under loads that change slowly: parameters, inputs and held coordinates are swept
together, in steps that suit. Says where stability changes and why a path ends.

examples:
  cardan statics column.yaml --sweep P=0,10
        a parameter or input, from 0 to 10
  cardan statics column.yaml --sweep P=0,10 --sweep F=0,1 --steps 50 --plot path.png
        two together, in about 50 steps, as a picture
  cardan statics press.yaml --sweep lever=0,0.5
        a coordinate: what it takes to move it there (column lever.holding)
  cardan statics arm.urdf --sweep gravity.z=-1,-9.81 --lock elbow=0.2 --json
        from weak to full gravity, for another program

exit status 1: the end was not reached; the path up to there is printed
"""

from __future__ import annotations

import argparse
import json
import math
import warnings
from typing import Any

from .options import equilibrium as equilibrium_options
from .options import run as run_options


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    group = equilibrium_options.arguments(parser)
    group.add_argument("--sweep", metavar="NAME=FROM,TO", type=swept, action="append",
                       required=True, help="parameter, input or coordinate; repeat")  # fmt: skip
    group.add_argument("--steps", metavar="COUNT", type=run_options.count, default=10,
                       help="rows, more where the way is hard (default 10)")  # fmt: skip
    parser.add_argument("--plot", metavar="PATH.png", type=run_options.file(".png", ".pdf", ".svg"),
                        help="picture of all coordinates (needs matplotlib)")  # fmt: skip


def swept(text: str) -> tuple[str, list[float]]:
    """The type of ``P=0,10``."""
    name, separator, numbers = text.rpartition("=")
    try:
        values = [float(x) for x in numbers.split(",")]
    except ValueError:
        values = []
    if not (separator and name and len(values) > 1 and all(map(math.isfinite, values))):
        raise argparse.ArgumentTypeError(f"'{text}' does not read NAME=FROM,TO, such as P=0,10")
    return name, values


def run(options: argparse.Namespace) -> int:
    """Load, compile, follow, report."""
    scene, model = equilibrium_options.model(options)
    conditions = equilibrium_options.loads(scene, model, options)
    moved = {n: v for n, v in options.sweep if n in model.coordinates}
    loads = {n: v for n, v in options.sweep if n not in moved}
    conditions["locked"] = {**conditions["locked"], **moved}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        path = model.statics(loads, steps=options.steps, **conditions)
    if options.plot is not None:
        path.plot(options.plot)
    if options.json:
        print(json.dumps(numbers(path), indent=1))
    else:
        table(path)
    return 0 if path.success else 1


def numbers(path: Any) -> dict[str, Any]:
    """A path for JSON."""
    return {
        "success": path.success,
        "message": path.message,
        "values": {name: column.tolist() for name, column in path.values.items()},
        "rows": [equilibrium_options.numbers(row) for row in path.rows],
        "stability_changes": path.critical(),
    }


def table(path: Any) -> None:
    """The path on a screen."""
    from rich.table import Table

    from .terminal import console

    model = path.rows[0].model
    names = [n for n in model.coordinates if n not in path.values][:8]
    locked = list(path.rows[0].holding_forces)
    rows = Table(box=None, pad_edge=False)
    for heading in (
        *path.values,
        *names,
        *(f"{n}.holding_force" for n in locked),
        "stable",
        "iterations",
    ):
        rows.add_column(heading, justify="right")
    labels = {True: "yes", False: "no", None: "-"}
    for k, row in enumerate(path.rows):
        values = [column[k] for column in path.values.values()]
        values += [row.named[n] for n in names] + [row.holding_forces[n] for n in locked]
        rows.add_row(*(f"{v:.6g}" for v in values), labels[row.stable], str(row.iterations))
    out = console()
    out.print(rows)
    for place in path.critical():
        said = ", ".join(f"{name} = {value:.9g}" for name, value in place.items())
        out.print(f"stability changes at {said}")
    out.print(path.message, soft_wrap=True)
