"""``cardan fit``: parameters and the start of a motion from what was measured of it.

Finds parameters of a scene and the start of a motion from samples of whatever was measured:
coordinates, speeds, outputs such as the position of a hand, any formula in names of the scene.

The search begins with the values of FILE and --set, and goes over many short runs at once, so that
chaotic motions and poor first values do no harm (of models with beams over one run). Printed are
the estimates with standard errors and 95 % intervals, combinations that the data cannot determine,
and a test of the residuals.

examples:
  cardan fit pendulum.yaml swing.csv --unknown length,damping,q0
        from columns t and hinge; two parameters, and the angle at the first sample
  cardan fit arm.yaml run.csv --unknown payload,x0 --measured 'hand.z=z [m]' --measured elbow=angle
        columns of other names; x0 is the whole start
  cardan fit arm.yaml run.csv --unknown m,l --noise hand.z=0.002 --noise elbow=0.01 --plot fit.png
        weighed by the noise of each channel, with a picture
  cardan fit arm.yaml run.csv --unknown m,c,d --seeds identify --input tau=torque
        masses and damping that are far off begin with what identification says
  cardan fit arm.yaml run.csv --unknown m --bounds m=0.1,5 --robust --json > fit.json
        within bounds, some samples are wrong, for another program

A table has a first line of names, with units behind them or not: t [s],hinge [rad]; the
times are called t. Cells are blank, or nan, where nothing was measured. Columns called as inputs
of the scene are these inputs.

exit status 1: the search has not converged; what it has found is printed
"""

from __future__ import annotations

import argparse
import json
import math
from typing import TYPE_CHECKING

from ..errors import ModelError
from . import INTERRUPTED
from .options import run as run_options
from .options import scene as scene_options
from .options.equilibrium import finite
from .options.names import names

if TYPE_CHECKING:
    from ..api.results import Fit
    from ..api.scene import Scene


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    scene_options.arguments(parser)
    parser.add_argument("data", metavar="DATA.csv", type=run_options.file(".csv"),
                        help="table of samples, with the times t")  # fmt: skip
    group = parser.add_argument_group("the fit")
    group.add_argument("--unknown", metavar="NAMES", type=names, action="extend", required=True,
                       help="parameters, and starts: x0, q0, u0, q0.elbow, u0.elbow")  # fmt: skip
    group.add_argument("--measured", metavar="FORMULA=COLUMN", type=pair, action="append",
                       default=[], help="what a column measures; again for another (default: "
                       "coordinates, speeds and outputs of these names)")  # fmt: skip
    group.add_argument("--noise", metavar="[FORMULA=]VALUE", type=noise, action="append",
                       default=[], help="standard deviation of what was measured")  # fmt: skip
    group.add_argument("--bounds", metavar="NAME=LOW,HIGH", type=bounds, action="append",
                       default=[], help="of a parameter; either may be left out")  # fmt: skip
    group.add_argument("--robust", action="store_true",
                       help="some samples are wrong: large ones count less (Huber)")  # fmt: skip
    group.add_argument("--segments", metavar="N", type=segments, default="auto",
                       help="runs that the motion is divided into (default auto)")  # fmt: skip
    group.add_argument("--seeds", choices=("identify",),
                       help="first values of masses, inertias and damping by identification, "
                       "where all coordinates were measured")  # fmt: skip
    group.add_argument("--most", metavar="N", type=run_options.count, default=60,
                       help="iterations (default 60)")  # fmt: skip
    run = parser.add_argument_group("the motion")
    for option, what in (("q", "coordinate"), ("u", "speed"), ("z", "internal state")):
        run.add_argument(f"--{option}", metavar="NAME=VALUE", type=run_options.named,
                         action="append", default=[],
                         help=f"{what} at the first sample, or a first value")  # fmt: skip
    run.add_argument("--set", metavar="NAME=VALUE", type=run_options.named, action="append",
                     default=[], help="value of a parameter, or first one")  # fmt: skip
    run.add_argument("--input", metavar="NAME=COLUMN", type=pair, action="append", default=[],
                     help="input by a column, or a number")  # fmt: skip
    run.add_argument("--method", metavar="NAME",
                     help="integrator (default auto: DOP853, of beams Radau)")  # fmt: skip
    run.add_argument("--rtol", type=run_options.positive,
                     help="relative tolerance per step (default 1e-9)")  # fmt: skip
    results = parser.add_argument_group("results")
    results.add_argument("-o", "--output", metavar="RUN.nc", type=run_options.motion,
                         help="the fitted motion, in a format of simulate")  # fmt: skip
    results.add_argument("--plot", metavar="FIT.png",
                         type=run_options.file(".png", ".pdf", ".svg"),
                         help="samples over the fitted motion (needs matplotlib)")  # fmt: skip
    results.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """Load, compile, fit, report."""
    from ..pipeline import compile
    from .terminal import progress

    scene = scene_options.read(options)
    with progress() as show:
        show("deriving and compiling")
        model = compile(scene)
        show("fitting", 0.0)
        q, u, z = (_start(scene, options, block) for block in "quz")
        fit = model.fit(
            options.data,
            unknown=options.unknown,
            measured=dict(options.measured) or None,
            noise=_noise(options),
            bounds=dict(options.bounds) or None,
            loss="huber" if options.robust else "linear",
            segments=options.segments,
            seeds=options.seeds,
            q=q,
            u=u,
            z=z,
            inputs=_inputs(options),
            parameters=dict(options.set) or None,
            method=options.method or scene.settings.get("method", "auto"),
            rtol=options.rtol or scene.settings.get("rtol", 1e-9),
            most=options.most,
            progress=lambda part: show("fitting", part),
        )
    written = _write(fit, options)
    if options.json:
        print(json.dumps(numbers(fit) | {"files": written}, indent=1))
    else:
        print(fit)
        for path in written:
            print(f"wrote {path}")
    return INTERRUPTED if fit.interrupted else 0 if fit.converged else 1


def _start(scene: Scene, options: argparse.Namespace, block: str) -> dict[str, float] | None:
    """Start by names: what the file says, then what was typed."""
    return {**scene.settings.get(block, {}), **dict(getattr(options, block))} or None


def _noise(options: argparse.Namespace) -> float | dict[str, float] | None:
    """One number, or one for each channel."""
    stated: dict[str, float] = dict(options.noise)
    if "" in stated and len(stated) > 1:
        raise ModelError("--noise: give one value for all, or one for each FORMULA=")
    return stated.get("", stated or None)


def _inputs(options: argparse.Namespace) -> dict[str, float | tuple[object, object]] | None:
    """Inputs as numbers, or as columns of the table."""
    from ..analyses.fits.samples import column, table_of

    inputs: dict[str, float | tuple[object, object]] = {}
    table = table_of(options.data) if options.input else {}
    for name, text in options.input:
        try:
            inputs[name] = float(text)
        except ValueError:
            inputs[name] = (column(table, "t"), column(table, text))
    return inputs or None


def _write(fit: Fit, options: argparse.Namespace) -> list[str]:
    """The files that were asked for."""
    from ..api.trajectory import Trajectory

    written = list[str]()
    if options.output is not None:
        assert isinstance(fit.motion, Trajectory)
        options.output.parent.mkdir(parents=True, exist_ok=True)
        written.append(str(fit.motion.save(options.output)))
    if options.plot is not None:
        fit.plot(options.plot)
        written.append(str(options.plot))
    return written


def numbers(fit: Fit) -> dict[str, object]:
    """The fit as data for JSON; null where the data do not tell."""
    return {
        "converged": fit.converged,
        "message": fit.message,
        "iterations": fit.iterations,
        "segments": fit.segments,
        "estimates": {
            name: {
                "value": finite(fit.values[name]),
                "standard_error": finite(fit.standard_errors[name]),
                "interval": [finite(x) for x in fit.interval(name)],
            }
            for name in fit.names
        },
        "undetermined": list(fit.undetermined),
        "at_bounds": list(fit.at_bounds),
        "correlation": [[finite(x) for x in row] for row in fit.correlation],
        "start": dict(zip(_entries(fit), fit.start.tolist(), strict=True)),
        "sigma": fit.sigma,
        "freedom": fit.freedom,
        "durbin_watson": fit.durbin_watson,
        "serially_correlated": list(fit.serially_correlated),
        "cost": fit.cost,
    }


def _entries(fit: Fit) -> tuple[str, ...]:
    """Names of the entries of the state."""
    model = fit.model
    return *model.coordinates, *model.speeds, *model.internals


# types of options


def pair(text: str) -> tuple[str, str]:
    """The type of ``hand.z=column``."""
    name, separator, column = (part.strip() for part in text.rpartition("="))
    if not (name and separator and column):
        raise argparse.ArgumentTypeError(f"'{text}' does not read NAME=COLUMN, such as hand.z=z")
    return name, column


def noise(text: str) -> tuple[str, float]:
    """The type of ``0.01`` and ``hand.z=0.01``; of one for all the name is empty."""
    name, _, value = text.rpartition("=")
    return name.strip(), run_options.positive(value)


def bounds(text: str) -> tuple[str, tuple[float, float]]:
    """The type of ``m=0.1,5``; either number may be left out."""
    name, _, ends = text.rpartition("=")
    low, comma, high = ends.partition(",")
    try:
        values = float(low or "-inf"), float(high or "inf")
    except ValueError:
        values = math.nan, math.nan
    if not (name and comma and values[0] < values[1]):
        raise argparse.ArgumentTypeError(f"'{text}' does not read NAME=LOW,HIGH, such as m=0.1,5")
    return name, values


def segments(text: str) -> str | int:
    """The type of ``auto`` and of a number."""
    return text if text == "auto" else run_options.count(text)
