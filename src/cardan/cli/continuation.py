"""``cardan continuation``: every equilibrium, position or cycle that a change leads to.

Follows equilibria through limit loads and snaps, tells folds, branch points and points where an
oscillation begins, and follows the branches that leave them. --of positions follows a mechanism
without forces, --of cycles motions that repeat.

examples:
  cardan continuation column.yaml --vary P=0:10
        a parameter or input, from 0 to 10, or however far the equilibria go
  cardan continuation column.yaml --vary P=0:10 --branches 1 --bound foot=-1.5:1.5 \\
      --plot column.png --axes P,foot
        with the branches that leave it, as a picture
  cardan continuation column.yaml --vary P=0:10 --branches 1 --explain column.html --report
        a page that tells what was solved and how to read it; what points cost and miss
  cardan continuation press.yaml --vary lever=0:0.5 --json
        a coordinate that is moved, for another program
  cardan continuation truss.yaml --vary P=0:1 --until apex=-2 --save truss.csv
        to a value of a coordinate or an output, as a table
  cardan continuation four_bar --of positions --vary D=2:3
        of a mechanism without forces, through dead points of what drives
  cardan continuation duffing.yaml --of cycles --vary omega=0.7:3 --period 2*pi/omega --settle 20
        of a motion that is forced, through its resonance
  cardan continuation rotor.yaml --of cycles --vary speed=0:4 --hopf --plot whirl.png
        of the whirl that begins where rest loses its stability
  cardan continuation double_pendulum --of cycles --mode 0 --vary energy=0:5
        of a free vibration, by its energy [J] over the state of rest
  cardan continuation biped.yaml --of cycles --vary slope=0.01:0.02 --section heel --u leg=-0.2
        of a gait from event to event

exit status 1: the path ended before; what was found of it is printed
"""

from __future__ import annotations

import argparse
import json
import math
import warnings
from functools import partial
from typing import TYPE_CHECKING

from .options import cycles as cycle_options
from .options import equilibrium as equilibrium_options
from .options import run as run_options

if TYPE_CHECKING:
    from ..analyses.continuation.record import BranchRecord, ContinuationRecord
    from ..analyses.simulation.precision.path_report import PathReport
    from ..api.compiled_model import CompiledModel
    from ..api.results import Continuation
    from ..api.scene import Scene


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    group = equilibrium_options.arguments(parser)
    group.add_argument("--vary", metavar="NAME=FROM:TO", type=interval, action="append",
                       required=True, help="parameter, input or coordinate; repeat")  # fmt: skip
    group.add_argument("--of", choices=("equilibria", "positions", "cycles"), default="equilibria",
                       help="what the path consists of; positions of a mechanism need no forces"
                       )  # fmt: skip
    group.add_argument("--until", metavar="NAME=VALUE", type=run_options.named, action="append",
                       default=[], help="end where this has the value")  # fmt: skip
    group.add_argument("--bound", metavar="NAME=LOW:HIGH", type=interval, action="append",
                       default=[], help="end where this leaves the range")  # fmt: skip
    group.add_argument("--branches", metavar="COUNT", type=int, default=0,
                       help="generations of branches to follow (default 0)")  # fmt: skip
    group.add_argument("--points", metavar="COUNT", type=run_options.count, default=300,
                       help="points of a branch at most (default 300)")  # fmt: skip
    cycle_options.arguments(parser)
    parser.add_argument("--plot", metavar="PATH.png", type=run_options.file(".png", ".pdf", ".svg"),
                        help="picture of all branches (needs matplotlib)")  # fmt: skip
    parser.add_argument("--axes", metavar="NAME,NAME", type=axes,
                        help="what pictures show, such as P,elbow or omega,x.max (default: what "
                             "varies, first coordinate)")  # fmt: skip
    parser.add_argument("--explain", metavar="PAGE.html",
                        type=run_options.file(".html", ".md", ".tex"),
                        help="page on what was solved, and how to read it")  # fmt: skip
    parser.add_argument("--save", metavar="FILE", type=run_options.saved,
                        help="points of all branches: .csv, .nc, .npz or .mat")  # fmt: skip
    parser.add_argument("--report", action="store_true",
                        help="what points cost, and what they miss their equations by"
                        )  # fmt: skip


def interval(text: str) -> tuple[str, tuple[float, float]]:
    """The type of ``P=0:10``."""
    name, separator, numbers = text.rpartition("=")
    try:
        low, high = (float(x) for x in numbers.split(":"))
    except ValueError:
        low = high = math.nan
    if not (separator and name and math.isfinite(low) and math.isfinite(high)):
        raise argparse.ArgumentTypeError(f"'{text}' does not read NAME=FROM:TO, such as P=0:10")
    return name, (low, high)


def axes(text: str) -> tuple[str, str]:
    """The type of ``P,foot``."""
    names = text.split(",")
    if len(names) != 2 or not all(names):
        raise argparse.ArgumentTypeError(f"'{text}' does not read NAME,NAME, such as P,elbow")
    return names[0], names[1]


def run(options: argparse.Namespace) -> int:
    """Load, compile, follow, report."""
    scene, model = equilibrium_options.model(options)
    cycle_options.refuse(options, model.coordinates)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        path = _followed(scene, model, options)
        written = _written(path, options)
    report: PathReport | None = None
    if options.report:
        from ..analyses.simulation.precision.path_report import measured

        report = measured(path)
    if options.json:
        print(json.dumps(numbers(path, report) | {"files": written}, indent=1))
        return 0 if path.success else 1
    print(path)
    if report is not None:
        from .terminal import console

        console().print(report.table())
    for file in written:
        print(f"wrote {file}")
    return 0 if path.success else 1


def _followed(scene: Scene, model: CompiledModel, options: argparse.Namespace) -> Continuation:
    """The path."""
    follow = partial(
        model.continuation, of=options.of, until=dict(options.until), bounds=dict(options.bound),
        branches=options.branches, points=options.points,
    )  # fmt: skip
    if options.of == "cycles":
        return follow(dict(options.vary), start=cycle_options.start(scene, model, options))
    conditions = equilibrium_options.loads(scene, model, options)
    moved = {n: v for n, v in options.vary if n in model.coordinates}
    loads = {n: v for n, v in options.vary if n not in moved}
    conditions["locked"] = {**conditions["locked"], **moved}
    return follow(loads, **conditions)


def _written(path: Continuation, options: argparse.Namespace) -> list[str]:
    """The files that were asked for."""
    if options.plot is not None:
        swept = dict(options.vary)
        free = [name for name in path.model.coordinates if name not in swept]
        extreme = ".max" * (options.of == "cycles")
        along, up = options.axes or (options.vary[0][0], (free or [*swept])[0] + extreme)
        path.plot(along, up, options.plot)
    if options.explain is not None:
        path.explain(options.explain, *(options.axes or ()))
    if options.save is not None:
        path.save(options.save)
    files = (options.plot, options.explain, options.save)
    return [str(file) for file in files if file is not None]


def numbers(path: ContinuationRecord, report: PathReport | None = None) -> dict[str, object]:
    """A path for JSON."""
    data: dict[str, object] = {
        "success": path.success,
        "message": path.message,
        "branches": {name: branch_numbers(branch) for name, branch in path.branches.items()},
    }
    if report is None:
        return data
    rows = [vars(row) | {"residual": equilibrium_options.finite(row.residual)}
            for row in report.rows]  # fmt: skip
    return data | {"report": {"note": report.note, "branches": rows}}


def branch_numbers(branch: BranchRecord) -> dict[str, object]:
    """A branch for JSON."""
    histories = ("period", "multiplier") if branch.solutions.kind == "cycles" else ()
    return {
        "status": branch.status,
        "values": {name: column.tolist() for name, column in branch.values.items()},
        "q": {
            name: column.tolist()
            for name, column in zip(branch.model.coordinates, branch.q.T, strict=True)
        },
        "stable": branch.stable,
        **{name: branch[name].tolist() for name in histories},
        "points": [
            {
                "name": point.name,
                "kind": point.kind,
                "values": dict(point.values),
                "branches": list(point.branches),
                "frequency": equilibrium_options.finite(point.frequency),
                "accurate": point.accurate,
                "description": point.description,
            }
            for point in branch.points
        ],
    }
