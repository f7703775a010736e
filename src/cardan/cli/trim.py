"""``cardan trim``: what a wanted steady motion takes.

Inputs, parameters, forces and speeds with which a wanted steady motion, or a rest, holds: a bicycle
in a turn, a rotor at its speed, an arm at its angle; and whether it is stable.

examples:
  cardan trim arm.yaml --target elbow=0.5 --free motor
        the input that holds this angle
  cardan trim bicycle.yaml --target rear_contact.lean=-0.1 --u rear_hub=-15 \\
      --free steer.driving_force
        the torque along the steering axis in a steady turn
  cardan trim governor.yaml --target arm=0.7 --free spin.u --u spin=5
        the speed at which the arm stands like that, looked for from 5 rad/s
  cardan trim crane.yaml --target height=2 --free load.mass --json
        an output and a parameter, for another program

exit status 1: there is none; the message tells what cannot be met, or is left over
"""

from __future__ import annotations

import argparse
import json
from typing import Any

from .options import equilibrium as equilibrium_options
from .options import run as run_options


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    group = equilibrium_options.arguments(parser)
    group.add_argument("--u", metavar="JOINT=VALUE", type=run_options.named, action="append",
                       default=[], help="speed that stays, or starts if it is free")  # fmt: skip
    equilibrium_options.trim_arguments(group)


def run(options: argparse.Namespace) -> int:
    """Load, compile, search, report."""
    scene, model = equilibrium_options.model(options)
    trim = model.trim(**equilibrium_options.trim_values(scene, model, options), check=True)
    print(json.dumps(numbers(trim), indent=1) if options.json else trim)
    return 0


def numbers(trim: Any) -> dict[str, Any]:
    """A trimmed motion for JSON."""
    return {
        "message": trim.message,
        "stable": trim.stable,
        "free": dict(trim.free),
        "targets": dict(trim.targets),
        "free_motions": list(trim.free_motions),
        "iterations": trim.iterations,
        "q": dict(zip(trim.model.coordinates, trim.q.tolist(), strict=True)),
        "u": dict(zip(trim.model.speeds, trim.u.tolist(), strict=True)),
        "eigenvalues": [[v.real, v.imag] for v in trim.linear.eigenvalues.tolist()],
    }
