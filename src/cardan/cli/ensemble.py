r"""``cardan ensemble``: many runs of a scene that differ by starts, parameters or inputs.

Simulate a scene or robot many times, with other values in every run, on all cores and side by side
in the vectors of each. Prints how the runs went and what was kept of them.

examples:
  cardan ensemble arm.yaml --vary 'm=linspace(1, 2, 100)' --time 10
        100 masses; a name is a coordinate, a speed (elbow.u), a parameter or an input
  cardan ensemble arm.yaml --vary 'elbow=normal(0, 0.1)' --vary m=1,2,5 --runs 3000
        1000 random angles for each of three masses
  cardan ensemble arm.yaml --vary 'elbow=uniform(-1, 1)' --runs 1024 --plan sobol \
        --reduce 'max of elbow' --reduce 'mean of elbow' -o runs.nc
        a number of every run, a mean over runs at every output time
  cardan ensemble arm.yaml --vary 'elbow=linspace(0, 1, 11)' --sensitivity m,q0.elbow -o runs.nc
        what the states of every run change by, per unit of a parameter and of a start
  cardan ensemble arm.yaml --vary 'm=uniform(1, 2)' --runs 1000000 --checkpoint runs.part
        the same command goes on where it was stopped
  cardan ensemble arm.yaml --vary 'm=uniform(1, 2)' --runs 1000000 --part 3/8 \
        --checkpoint runs-3.part
        part 3 of 8, on any machine; when all are done:
  cardan ensemble --join 'runs-*.part' -o runs.nc
        the ensemble of all parts, to the bit

values: linspace(first, last, count), geomspace(first, last, count), 1,2,5,
        uniform(low, high), normal(mean, deviation), log_uniform(low, high)
reductions: max, min, range, rms, last of NAME: of every run; mean, variance, deviation of NAME:
        over runs; 'mean of NAME over time', 'max of NAME over runs';
        'histogram of NAME from LOW to HIGH in COUNT'
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import INTERRUPTED
from .options import run as run_options
from .options import scene as scene_options
from .options import sweep as sweep_options
from .options.names import names

if TYPE_CHECKING:
    from ..api.results import Ensemble


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    scene_options.arguments(parser, optional=True)
    run_options.arguments(parser)
    many = parser.add_argument_group("the runs")
    many.add_argument("--vary", metavar="NAME=VALUES", type=sweep_options.vary, action="append",
                      default=[], help="what differs; give it again for another")  # fmt: skip
    many.add_argument("--runs", metavar="N", type=run_options.count, help="how many in all")
    many.add_argument("--plan", choices=tuple(sweep_options.PLANS), default="random",
                      help="how distributions are drawn (default random)")  # fmt: skip
    many.add_argument("--seed", type=int, default=0, help="of what is drawn (default 0)")
    many.add_argument("--threads", metavar="N", type=run_options.count, help="default: all cores")
    many.add_argument("--checkpoint", metavar="FILE", type=Path,
                      help="keeps finished runs; the same command goes on from there")  # fmt: skip
    many.add_argument(
        "--reproducible",
        action="store_true",
        help="equal bits from every compiler and processor, 10-30 %% slower",
    )
    jobs = parser.add_argument_group("several jobs that share a disk")
    jobs.add_argument(
        "--part",
        metavar="K/N",
        type=part,
        help="only part K of N; with --checkpoint, a file for each part",
    )
    jobs.add_argument("--join", metavar="PATTERN", action="append", default=[],
                      help="put the files of all parts together, instead of FILE; a pattern such "
                           "as 'runs-*.part', or give it again for another file")  # fmt: skip
    results = parser.add_argument_group("results")
    results.add_argument("--reduce", metavar="WORDS", action="append", default=[],
                         help="such as 'max of elbow'; give it again for another")  # fmt: skip
    results.add_argument("--sensitivity", metavar="NAMES", type=names, action="extend", default=[],
                         help="by what states are differentiated: parameters, inputs, and starts "
                              "such as x0, q0.elbow, u0.elbow")  # fmt: skip
    results.add_argument("--points", metavar="N", type=run_options.count,
                         help="output times of what is kept (default 201)")  # fmt: skip
    results.add_argument("-o", "--output", metavar="RUNS.nc", type=run_options.saved,
                         help="the runs: .nc, .npz, .csv or .mat")  # fmt: skip
    results.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """Load, compile, run, report."""
    ensemble = _joined(options) if options.join else _computed(options)
    written = []
    if options.output is not None:
        options.output.parent.mkdir(parents=True, exist_ok=True)
        written = [str(ensemble.save(options.output))]
    _print(ensemble, written, options.json)
    return INTERRUPTED if ensemble.interrupted else 0 if ensemble.success else 1


def _joined(options: argparse.Namespace) -> Ensemble:
    """The ensemble of all parts."""
    from ..api.results import Ensemble

    set_here = {"command", "run", "parser", "join", "output", "json"}
    for name in vars(options).keys() - set_here:
        if getattr(options, name) != options.parser.get_default(name):
            word = "FILE" if name == "file" else f"--{name.replace('_', '-')}"
            options.parser.error(f"{word}: --join takes the files alone, which say what they are")
    patterns = options.join
    return Ensemble.join(patterns[0] if len(patterns) == 1 else patterns)


def _computed(options: argparse.Namespace) -> Ensemble:
    """The runs, computed."""
    from ..pipeline import compile
    from .terminal import progress

    if options.file is None:
        options.parser.error("name a FILE, or --join the files of parts")
    if options.part and options.checkpoint is None:
        options.parser.error("--part needs --checkpoint FILE: that file is what --join reads")
    plan = sweep_options.plan(options.vary, options.runs, options.plan, options.seed)
    scene = scene_options.read(options)
    with progress() as show:
        show("deriving and compiling")
        model = compile(scene, reproducible=options.reproducible)
        show("running", 0.0)
        return model.ensemble(
            **settings(scene, options),
            vary=plan,
            reduce=options.reduce,
            sensitivity=options.sensitivity,
            threads=options.threads,
            part=options.part,
            checkpoint=options.checkpoint,
            progress=lambda fraction: show("running", fraction),
        )


def _print(ensemble: Ensemble, written: list[str], as_json: bool) -> None:
    from .terminal import console

    if as_json:
        print(json.dumps(summary(ensemble) | {"files": written}, indent=1))
    else:
        out = console()
        for line in (
            repr(ensemble),
            *result_lines(ensemble),
            *(f"wrote {path}" for path in written),
        ):
            out.print(line, soft_wrap=True)


def part(text: str) -> tuple[int, int]:
    """The type of ``3/8``, part 3 of 8."""
    numbers = text.split("/")
    if len(numbers) != 2 or not all(one.isascii() and one.isdigit() for one in numbers):
        raise argparse.ArgumentTypeError(f"'{text}' does not read K/N, such as 3/8")
    k, n = map(int, numbers)
    if not 1 <= k <= n:
        raise argparse.ArgumentTypeError(f"'{text}': parts are counted from 1 to N")
    return k, n


def settings(scene: Any, options: argparse.Namespace) -> dict[str, Any]:
    """Arguments of the runs; what is varied comes before what the file says."""
    run_settings = run_options.settings(scene, options)
    varied = {name for name, _ in options.vary}
    for block, ending in (("q", ""), ("u", ".u"), ("z", "")):
        typed = dict(getattr(options, block))
        run_settings[block] = {
            name: value
            for name, value in run_settings[block].items()
            if name in typed or f"{name}{ending}" not in varied
        }
    if options.points:
        run_settings["t"] = np.linspace(0.0, run_settings["t"], options.points)
    return run_settings


def summary(ensemble: Ensemble) -> dict[str, Any]:
    """The runs in numbers."""
    statuses, counts = np.unique(ensemble.status, return_counts=True)
    return {
        "success": ensemble.success,
        "interrupted": ensemble.interrupted,
        "runs": len(ensemble),
        "statuses": dict(zip(statuses.tolist(), counts.tolist(), strict=True)),
        "messages": {str(k): text for k, text in list(ensemble.messages.items())[:10]},
        "seconds": ensemble.seconds,
        "restored": ensemble.restored,
        "varied": {name: _range(values) for name, values in ensemble.varied.items()},
        "steps": _range(ensemble.statistics["steps"]),
        "results": {name: _numbers(ensemble, value) for name, value in ensemble.results.items()},
    }


def _numbers(ensemble: Ensemble, value: Any) -> Any:
    """A range of what every run has; all of the rest."""
    counts = getattr(value, "counts", None)
    if counts is not None:
        return {"counts": counts.tolist(), "edges": value.edges.tolist()}
    return _range(value) if len(value) == len(ensemble) else np.asarray(value).tolist()


def _range(values: Any) -> dict[str, float | None]:
    there = np.asarray(values)[np.isfinite(values)]
    if not there.size:
        return {"min": None, "mean": None, "max": None}
    return {"min": float(there.min()), "mean": float(there.mean()), "max": float(there.max())}


def result_lines(ensemble: Ensemble) -> list[str]:
    """Reductions on a screen."""
    lines = []
    for name, value in ensemble.results.items():
        counts = getattr(value, "counts", None)
        if counts is not None:
            lines.append(f"{name}: {' '.join(map(str, counts.tolist()))}")
        else:
            what = "over the runs" if len(value) == len(ensemble) else "over the output times"
            span = _range(value)
            if span["mean"] is not None:
                lines.append(f"{name}: {span['min']:.6g} ... {span['max']:.6g} {what}")
    return lines
