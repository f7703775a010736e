"""``cardan modes``: frequencies, damping and shapes of vibration.

Frequencies, damping ratios and shapes of small vibrations about the equilibrium next to a start,
under its loads, or about a steady motion (--u): whirling of rotors, with gyroscopic forces.

examples:
  cardan modes crane.yaml
        about its equilibrium
  cardan modes crane.yaml --count 4 --set load.mass=500 --view mode.html --mode 1
        four of them under another load, and mode 1 as a page that plays
  cardan modes rotor.yaml --u spin=300
        at 300 rad/s
  cardan modes arm.urdf --lock shoulder=0.5 --json
        with a joint that is held, for another program

Modes are of modal mass 1; 'rigid' is what nothing holds.
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
                       default=[], help="speed of a steady motion")  # fmt: skip
    group.add_argument("--count", type=run_options.count, help="how many (default all)")
    group.add_argument("--undamped", action="store_true", help="leave dampers out")
    parser.add_argument("--mode", metavar="NUMBER", type=int, default=0,
                        help="which one --view plays, from 0 (default 0)")  # fmt: skip
    parser.add_argument("--view", metavar="MODE.html", type=run_options.file(".html", ".htm"),
                        help="a mode as a page that plays")  # fmt: skip


def run(options: argparse.Namespace) -> int:
    """Load, compile, solve, report."""
    scene, model = equilibrium_options.model(options)
    loads = equilibrium_options.loads(scene, model, options)
    equilibrium = model.equilibrium(**loads, u=dict(options.u), check=True)
    modes = model.modes(options.count, equilibrium, damped=not options.undamped)
    if options.view is not None:
        modes.animate(options.mode, options.view)
    if options.json:
        print(json.dumps(numbers(modes), indent=1))
    else:
        print(modes)
        if options.view is not None:
            print(f"wrote {options.view}")
    return 0


def numbers(modes: Any) -> dict[str, Any]:
    """Modes for JSON; complex numbers as [real, imaginary]."""
    return {
        "modes": [
            {
                "eigenvalue": [value.real, value.imag],
                "frequency": value.imag / 6.283185307179586,
                "damping": equilibrium_options.finite(ratio),
                "shape": {n: [x.real, x.imag] for n, x in modes.shape(k).items()},
            }
            for k, (value, ratio) in enumerate(
                zip(modes.values.tolist(), modes.damping.tolist(), strict=True)
            )
        ]
    }
