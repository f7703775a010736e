"""``cardan equilibrium``: where a mechanism rests under its forces.

Where a mechanism rests under gravity and its other forces, next to a start, and whether stably.

Loops stay closed, joints keep their prescribed positions; locked joints (--lock) are held by a
force that is told. Unstable positions are found too: --stable goes downhill instead.

examples:
  cardan equilibrium crane.yaml
        next to the initial position
  cardan equilibrium crane.yaml --stable
        where it comes to rest if it is let go
  cardan equilibrium arm.urdf --lock elbow=0.5 --lock shoulder=1
        the torques that hold these joints there; the others hang
  cardan equilibrium crane.yaml --set load.mass=500 --json
        with another parameter, for another program

exit status 1: none was found; the message tells what moves, and the cure
"""

from __future__ import annotations

import argparse
import json
import warnings

from .options import equilibrium as equilibrium_options


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    group = equilibrium_options.arguments(parser)
    group.add_argument("--stable", action="store_true", help="go downhill to a stable one")


def run(options: argparse.Namespace) -> int:
    """Load, compile, search, report."""
    from ..errors import SolveError

    scene, model = equilibrium_options.model(options)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        equilibrium = model.equilibrium(
            **equilibrium_options.loads(scene, model, options), stable=options.stable
        )
    if options.json:
        print(json.dumps(equilibrium_options.numbers(equilibrium), indent=1))
        return 0 if equilibrium.converged else 1
    if not equilibrium.converged:
        raise SolveError(equilibrium.message)
    print(equilibrium)
    return 0
