"""``cardan report``: speed against error of every integrator on a scene, and which one to take.

Run a scene or robot with every integrator, from rough tolerances to fine ones, and set the time of
each run beside its error. Then say which method to take for which error, and why.

Errors are taken from a reference: two methods at the tightest tolerances, or, where a motion is too
stiff for those, two implicit ones in fixed steps extrapolated to 0; their difference says how far
they can be trusted. A method goes no further than the reference, or than --patience.

examples:
  cardan report pendulum.yaml
        the motion that the file describes under simulate:
  cardan report arm.urdf --time 10 --q elbow=0.3
        ten seconds from a start of your own
  cardan report arm.urdf -o arm.html
        a page with the picture and the table; .png, .pdf or .svg for the picture alone
  cardan report arm.urdf --methods DOP853 Radau --json
        two methods, for another program

reading it: the error is the largest one of a coordinate at 41 times, in rad or m; ms is the least
time of some runs on one core. Ctrl-C ends measuring and shows what there is.
"""

from __future__ import annotations

import argparse
import json
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import ImpossibleWarning, ModelError
from ..schema.integrators import INTEGRATORS
from . import INTERRUPTED
from .options import run as run_options
from .options import scene as scene_options

if TYPE_CHECKING:
    from ..api.results import Precision
    from ..api.scene import Scene


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    scene_options.arguments(parser)
    run_options.start(parser)
    contest = parser.add_argument_group("what is measured")
    contest.add_argument("--methods", nargs="+", choices=tuple(INTEGRATORS), metavar="METHOD",
                         help=f"of {', '.join(INTEGRATORS)} (default all)")  # fmt: skip
    contest.add_argument("--patience", metavar="SECONDS", type=run_options.positive, default=5.0,
                         help="longest time for one run (default 5)")  # fmt: skip
    results = parser.add_argument_group("results")
    endings = (".html", ".htm", ".png", ".pdf", ".svg")
    results.add_argument("-o", "--output", metavar="FILE", type=run_options.file(*endings),
                         help="page (.html) or picture; needs matplotlib")  # fmt: skip
    results.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """Load, compile, measure, report."""
    from ..analyses.simulation.precision.runs import precision
    from ..api.faces import face
    from ..compilation import compile
    from .terminal import console, progress

    scene = _real(options)
    start = run_options.begin(scene, options)
    end = start.pop("t")
    with progress() as show:
        show("deriving and compiling")
        model = compile(scene)
        curves: Precision = face(
            precision(model, end, options.methods, options.patience, show, **start)
        )
    written = [write(curves, options.output)] if options.output is not None else []
    if options.json:
        print(json.dumps(summary(curves) | {"files": written}, indent=1, allow_nan=False))
    else:
        out = console()
        out.print(curves.table())
        for name, why in curves.left_out.items():
            out.print(f"{name}: {why}", soft_wrap=True)
        out.print(curves.recommendation, soft_wrap=True)
        for line in curves.undetermined:
            out.print(line, soft_wrap=True)
        for path in written:
            out.print(f"wrote {path}", soft_wrap=True)
    return INTERRUPTED if curves.interrupted else 0


def _real(options: argparse.Namespace) -> Scene:
    """The scene.

    Raises:
        ModelError: nothing real has its numbers: measuring its motion would say nothing.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("error", ImpossibleWarning)
        try:
            return scene_options.read(options)
        except ImpossibleWarning as doubt:
            raise ModelError(str(doubt)) from None


def write(curves: Precision, path: Path) -> str:
    """The page or picture asked for."""
    if path.suffix.lower() in (".html", ".htm"):
        from ..view.page import publish
        from .report_page import page

        publish(path, page(curves))
    else:
        curves.plot(path)
    return str(path)


def summary(curves: Precision) -> dict[str, Any]:
    """Measurements as numbers; an error is null where a run did not reach its end."""
    points = [
        {
            "method": point.method,
            point.setting: point.value,
            "status": point.status,
            "error": point.error if point.error < float("inf") else None,
            "ms": point.milliseconds,
            "steps": point.steps,
            "evaluations": point.evaluations,
        }
        for point in curves.points
    ]
    return {
        "model": curves.model,
        "time": list(curves.span),
        "points": points,
        "reference": curves.reference,
        "doubt": curves.doubt,
        "left_out": curves.left_out,
        "recommendation": curves.recommendation.splitlines(),
        "undetermined": list(curves.undetermined),
        "interrupted": curves.interrupted,
    }
