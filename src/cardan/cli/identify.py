"""``cardan identify``: inertial parameters from measured motions and forces.

What forces and motion tell about masses, centers of mass, inertias, damping and friction.

Only some combinations of them act on the forces: the base parameters. Alone, FILE lists them.
With --excite a motion is found that shows them well, within the limits of the joints, and written
as a table for the robot. With --data measured motion and forces give estimates, each with its
standard deviation, beside the values of the file.

examples:
  cardan identify arm.urdf
        the base parameters: what can be told at all
  cardan identify arm.urdf --excite motion.csv --period 10 --rate 200
        a motion of 10 s to be repeated, sampled at 200 Hz
  cardan identify arm.urdf --data run.csv --period 10
        estimates from columns t, elbow, elbow.tau ...; positions become a Fourier series
  cardan identify arm.urdf --data run.csv --cutoff 10 --plot fit.png
        of any motion: positions are filtered at 10 Hz before they are differentiated
  cardan identify arm.urdf --data run.csv --form energy --json > found.json
        without accelerations, for another program

A table has a first line of names: t, a coordinate by its name, its speed and acceleration with .u
and .udot where they were measured, its force with .tau; or it is a run that simulate
wrote (.nc, .npz).
Friction is told where the file has some: a joint's <dynamics damping=""/>, or forces of type
damping and friction, which may be 0.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .options import run as run_options
from .options import scene as scene_options
from .options.equilibrium import finite

if TYPE_CHECKING:
    from ..analyses.identification.base_parameters import Base
    from ..api.compiled_model import CompiledModel
    from ..api.results import Excitation, Identification


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    scene_options.arguments(parser)
    group = parser.add_argument_group("estimates")
    group.add_argument("--data", metavar="RUN.csv", type=run_options.data,
                       help="measured motion and forces, or a run")  # fmt: skip
    group.add_argument("--form", choices=("torque", "energy"), default="torque",
                       help="forces at every sample, or energies (default torque)")  # fmt: skip
    group.add_argument("--cutoff", metavar="HZ", type=run_options.positive,
                       help="filter positions and forces above")  # fmt: skip
    group.add_argument("--noise", metavar="JOINT=VALUE", type=run_options.named, action="append",
                       default=[], help="standard deviation of a force (default: told by what "
                       "is left over)")  # fmt: skip
    group.add_argument("--actuator", metavar="JOINT", action="append",
                       help="joint whose force was measured (default all)")  # fmt: skip
    group.add_argument("--plot", metavar="FIT.png", type=Path,
                       help="measured and estimated forces as a picture")  # fmt: skip
    motion = parser.add_argument_group("a motion that excites")
    motion.add_argument("--excite", metavar="MOTION.csv", type=run_options.file(".csv"),
                        help="find a motion and write it as a table")  # fmt: skip
    motion.add_argument("--period", metavar="SECONDS", type=run_options.positive,
                        help="of the motion (default 10), or of the measured one")  # fmt: skip
    motion.add_argument("--harmonics", type=run_options.count, default=5,
                        help="of its Fourier series (default 5)")  # fmt: skip
    motion.add_argument("--rate", metavar="HZ", type=run_options.positive, default=100.0,
                        help="samples per second in the table (default 100)")  # fmt: skip
    motion.add_argument("--speed", metavar="VALUE", type=run_options.positive,
                        help="most of every joint (default: limits of the file)")  # fmt: skip
    motion.add_argument("--acceleration", metavar="VALUE", type=run_options.positive,
                        help="most of every joint (default any)")  # fmt: skip
    motion.add_argument("--seed", type=int, default=0, help="of the search (default 0)")
    parser.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """Load, compile, then list, excite or estimate."""
    from ..compilation import compile
    from .terminal import progress

    scene = scene_options.read(options)
    with progress() as show:
        show("deriving and compiling")
        model = compile(scene)
        record: Base | Excitation | Identification
        if options.excite is not None:
            record = _excited(model, options, show)
        elif options.data is not None:
            show("estimating")
            record = _estimated(model, options)
        else:
            record = model.base_parameters()
    if options.json:
        print(json.dumps(numbers(record), indent=1))
    else:
        print(record)
        for path in (options.excite, options.plot if options.data is not None else None):
            if path is not None:
                print(f"wrote {path}")
    return 0


def _excited(model: CompiledModel, options: argparse.Namespace, show: Any) -> Excitation:
    """A motion, written as a table."""
    excitation = model.excitation(
        options.period or 10.0,
        harmonics=options.harmonics,
        speed=options.speed,
        acceleration=options.acceleration,
        seed=options.seed,
        progress=lambda part: show("looking for a motion", part),
    )
    excitation.save(options.excite, options.rate)
    return excitation


def _estimated(model: CompiledModel, options: argparse.Namespace) -> Identification:
    """Estimates from a file."""
    estimate = model.identify(
        options.data,
        form=options.form,
        noise=dict(options.noise) or None,
        cutoff=options.cutoff,
        period=options.period,
        harmonics=options.harmonics,
        actuators=options.actuator,
    )
    if options.plot is not None:
        estimate.plot(options.plot)
    return estimate


def numbers(record: Base | Excitation | Identification) -> dict[str, object]:
    """The result as data for JSON."""
    from ..analyses.identification.base_parameters import Base
    from ..api.results import Excitation

    if isinstance(record, Base):
        return {
            "base_parameters": record.expressions,
            "without_effect": list(record.without_effect),
        }
    if isinstance(record, Excitation):
        series = {name: getattr(record.series, name).tolist() for name in "cab"}
        return {
            "period": record.period,
            "coordinates": list(record.model.coordinates),
            "condition_before": record.before,
            "condition": record.condition,
            **series,
        }
    columns = (record.estimates, record.deviations, record.expected)
    rows = zip(record.names, *(x.tolist() for x in columns), strict=True)
    return {
        "base_parameters": {
            name: {
                "estimate": value,
                "deviation": deviation,
                "nominal": components,
                "is": record.base.expressions[name],
            }
            for name, value, deviation, components in rows
        },
        "covariance": record.covariance.tolist(),
        "condition": finite(record.condition),
        "chi": record.chi,
        "noise": dict(zip(record.channels, record.noise.tolist(), strict=True)),
        "explained": dict(zip(record.channels, record.explained.tolist(), strict=True)),
        "parameters": record.parameters,
        "implausible": list(record.implausible),
    }
