"""``cardan simulate``: a motion from a scene or URDF, as a table, file, picture or page.

Simulate a mechanism described by a scene file, or a robot described by a URDF.

The file becomes equations of motion and compiled C (kept for the next run), and a compiled
integrator runs them. A scene may say in simulate: how it wants to be run; options here come
first. Of a URDF damping acts. Joint limits and dry friction act with --limits stop and
--friction; a scene file also has elements for them, stop and friction.

examples:
  cardan simulate pendulum.yaml
        as the file says under simulate:
  cardan simulate arm.urdf --time 10
        from rest at q = 0; prints where every joint ends and how well energy was kept
  cardan simulate arm.urdf --time 10 --q elbow=0.3 --q shoulder=-1 --u elbow=2
        named initial angles and speeds, in radians, meters and seconds; the rest is 0
  cardan simulate arm.urdf --time 10 --view run.html -o run.nc
        a page that plays in any browser, and the numbers as netCDF
  cardan simulate arm.urdf -o run.csv
        a table with units; .mat opens in MATLAB, .glb in Blender, .mcap in Foxglove
  cardan simulate dog.urdf --base free --q base=1,0,0,0,0,0,0.5
        on a floating base: quaternion (w x y z), then position; several numbers for one joint
  cardan simulate lift.yaml --method Radau --z motor.force=100
        another integrator (cardan report compares them), an initial state of an element

A smaller --rtol costs little: DOP853, which auto takes where nothing is stiff, has order 8. The
energy line tells if it helped.
Defaults are those of model.simulate in Python: method auto, rtol 1e-6, atol 1e-3 rtol
(at most 1e-9).
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import CardanError
from . import INTERRUPTED
from .options import run as run_options
from .options import scene as scene_options

if TYPE_CHECKING:
    from ..api.compiled_model import CompiledModel
    from ..api.trajectory import Trajectory

ROWS = 60  # of the table of coordinates


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    scene_options.arguments(parser)
    run_options.arguments(parser)
    parser.add_argument(
        "--checkpoint",
        metavar="FILE",
        type=Path,
        help="keeps what is computed; the same command goes on from there",
    )
    results = parser.add_argument_group("results")
    results.add_argument(
        "-o",
        "--output",
        metavar="RUN.nc",
        type=run_options.motion,
        help="the run: .nc, .npz, .csv, .mat, .json, .nc4, .glb (animated) or .mcap",
    )
    results.add_argument(
        "--view", metavar="RUN.html", type=run_options.file(".html", ".htm"), help="animated page"
    )
    results.add_argument(
        "--plot",
        metavar="RUN.png",
        type=run_options.file(".png", ".pdf", ".svg"),
        help="picture (needs matplotlib)",
    )
    results.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """Load, compile, simulate, report."""
    from ..compilation import compile
    from .terminal import progress

    scene = scene_options.read(options)
    with progress() as show:
        show("deriving and compiling")
        model = compile(scene)
        show("simulating", 0.0)
        motion = model.simulate(
            **run_options.settings(scene, options),
            checkpoint=options.checkpoint,
            progress=lambda fraction: show("simulating", fraction),
        )
    written = write(motion, options)
    if options.json:
        print(json.dumps(summary(model, motion) | {"files": written}, indent=1))
    else:
        table(model, motion, written)
    if motion.status == "interrupted":
        return INTERRUPTED
    return 0 if motion.success else 1


def write(motion: Trajectory, options: argparse.Namespace) -> list[str]:
    """The files asked for."""
    outputs = {"save": options.output, "animate": options.view, "plot": options.plot}
    written = []
    for verb, path in outputs.items():
        if path is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            # what nobody asked for is not loaded
            getattr(motion, verb)(path)
            written.append(str(path))
    return written


def summary(model: CompiledModel, motion: Trajectory) -> dict[str, Any]:
    """The run in numbers."""
    first, last = motion.x[0].tolist(), motion.x[-1].tolist()
    names = [*model.coordinates, *model.speeds, *model.internals]
    return {
        "success": bool(motion.success),
        "message": motion.message,
        "time": float(motion.t[-1]),
        "method": motion.solver_info.method,
        "steps": int(motion.statistics["steps"]),
        "events": [{"time": event.t, "name": event.name} for event in motion.events],
        "start": dict(zip(names, first, strict=True)),
        "end": dict(zip(names, last, strict=True)),
        "energy_residual": _energy_residual(motion),
        **_closed(motion),
    }


def _energy_residual(motion: Trajectory) -> float | None:
    """Energy that the run lost or made; None where its model does not know its powers."""
    try:
        return float(motion.energy_residual[-1])
    except CardanError:
        return None


def _closed(motion: Trajectory) -> dict[str, Any]:
    """The worst residuals of a system with loops, by level."""
    if motion.ledger is None:
        return {}
    levels = {level: motion.ledger.worst(level) for level in ("position", "velocity")}
    return {"residuals": {level: one[1].after for level, one in levels.items() if one}}


def table(model: CompiledModel, motion: Trajectory, written: list[str]) -> None:
    """The run on a screen."""
    from rich.table import Table

    from .terminal import console

    results = summary(model, motion)
    rows = Table(box=None, pad_edge=False)
    for heading in ("coordinate", "start", "end", "speed at end"):
        rows.add_column(heading, justify="left" if heading == "coordinate" else "right")
    speeds = dict(zip(model.speeds, motion.u[-1].tolist(), strict=True))
    names = (*model.coordinates, *model.internals)
    for name in names[:ROWS]:
        rate = speeds.get(f"{name}.u")
        rows.add_row(
            name,
            f"{results['start'][name]:.6g}",
            f"{results['end'][name]:.6g}",
            "" if rate is None else f"{rate:.6g}",
        )
    out = console()
    out.print(rows)
    if len(names) > ROWS:
        out.print(f"... and {len(names) - ROWS} more")
    how = f"{results['steps']} steps of {results['method']}"
    out.print(f"{results['message']}: t = {results['time']:g} s in {how}")
    if results["events"]:
        last = results["events"][-1]
        out.print(f"events {len(results['events'])}, last '{last['name']}' at {last['time']:g} s")
    if results["energy_residual"] is not None:
        out.print(f"energy residual {results['energy_residual']:.1e} J")
    for level, worst in results.get("residuals", {}).items():
        out.print(f"largest {level} residual of the constraints {worst:.1e}")
    for path in written:
        out.print(f"wrote {path}", soft_wrap=True)
