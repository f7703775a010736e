"""``cardan continuation``: every equilibrium or position that a change leads to.

Follows equilibria through limit loads and snaps, tells folds, branch points and points where an
oscillation begins, and follows the branches that leave them.

examples:
  cardan continuation column.yaml --vary P=0:10
        a parameter or input, from 0 to 10, or however far the equilibria go
  cardan continuation column.yaml --vary P=0:10 --branches 1 --bound foot=-1.5:1.5 \\
      --plot column.png --axes P,foot
        with the branches that leave it, as a picture
  cardan continuation press.yaml --vary lever=0:0.5 --json
        a coordinate that is moved, for another program
  cardan continuation truss.yaml --vary P=0:1 --until apex=-2
        to a value of a coordinate or an output
  cardan continuation four_bar --of positions --vary D=2:3
        of a mechanism without forces, through dead points of what drives

exit status 1: the path ended before; what was found of it is printed
"""

from __future__ import annotations

import argparse
import json
import math
import warnings
from typing import TYPE_CHECKING

from .options import equilibrium as equilibrium_options
from .options import run as run_options

if TYPE_CHECKING:
    from ..analyses.continuation.record import BranchRecord, ContinuationRecord


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    group = equilibrium_options.arguments(parser)
    group.add_argument("--vary", metavar="NAME=FROM:TO", type=interval, action="append",
                       required=True, help="parameter, input or coordinate; repeat")  # fmt: skip
    group.add_argument("--of", choices=("equilibria", "positions"), default="equilibria",
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
    parser.add_argument("--plot", metavar="PATH.png", type=run_options.file(".png", ".pdf", ".svg"),
                        help="picture of all branches (needs matplotlib)")  # fmt: skip
    parser.add_argument("--axes", metavar="NAME,NAME", type=axes,
                        help="what the picture shows (default: what varies, first coordinate)"
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
    conditions = equilibrium_options.loads(scene, model, options)
    moved = {n: v for n, v in options.vary if n in model.coordinates}
    loads = {n: v for n, v in options.vary if n not in moved}
    conditions["locked"] = {**conditions["locked"], **moved}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        path = model.continuation(
            loads, of=options.of, until=dict(options.until), bounds=dict(options.bound),
            branches=options.branches, points=options.points, **conditions,
        )  # fmt: skip
    if options.plot is not None:
        free = [name for name in model.coordinates if name not in moved]
        along, up = options.axes or (options.vary[0][0], free[0])
        path.plot(along, up, options.plot)
    print(json.dumps(numbers(path), indent=1) if options.json else path)
    return 0 if path.success else 1


def numbers(path: ContinuationRecord) -> dict[str, object]:
    """A path for JSON."""
    return {
        "success": path.success,
        "message": path.message,
        "branches": {name: branch_numbers(branch) for name, branch in path.branches.items()},
    }


def branch_numbers(branch: BranchRecord) -> dict[str, object]:
    """A branch for JSON."""
    return {
        "status": branch.status,
        "values": {name: column.tolist() for name, column in branch.values.items()},
        "q": {
            name: column.tolist()
            for name, column in zip(branch.model.coordinates, branch.q.T, strict=True)
        },
        "stable": branch.stable,
        "points": [
            {
                "name": point.name,
                "kind": point.kind,
                "values": dict(point.values),
                "branches": list(point.branches),
                "description": point.description,
            }
            for point in branch.points
        ],
    }
