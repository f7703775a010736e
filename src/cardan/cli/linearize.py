"""``cardan linearize``: the linear model of a mechanism."""

from __future__ import annotations

import argparse
import json
from typing import Any

from . import formulas, resting, running

DESCRIPTION = """\
The linear model x' = A x + B r, y = C x + D r about the equilibrium next to a start, or about a
steady motion (--u), with names and eigenvalues; constraints are eliminated exactly."""

EPILOG = """\
examples:
  cardan linearize trolley.yaml
        about its equilibrium: states, eigenvalues, damping ratios
  cardan linearize trolley.yaml --q pole=3.14 --input cart --output pole
        about the other one; a force along the cart's speed drives, the angle is seen
  cardan linearize bicycle.yaml --u wheel=14
        in steady motion
  cardan linearize bicycle.yaml --symbolic --about rear_contact.u.x=v \\
        --independent rear_contact.lean --independent steer
        M, D, G, K and N as formulas in the speed and the parameters
  cardan linearize trolley.yaml --json > model.json
        A, B, C and D for another program"""


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    group = resting.arguments(parser)
    group.add_argument("--u", metavar="JOINT=VALUE", type=running.named, action="append",
                       default=[], help="speed of a steady motion")  # fmt: skip
    group.add_argument("--input", metavar="NAME", action="append",
                       help="input, or joint whose force drives (default all inputs)")  # fmt: skip
    group.add_argument("--output", metavar="NAME", action="append",
                       help="output, coordinate or speed (default: all outputs)")  # fmt: skip

    formulas.arguments(parser)


def run(options: argparse.Namespace) -> int:
    """Load, compile, linearize, report."""
    if formulas.wanted(options):
        return formulas.show(options)
    scene, model = resting.model(options)
    given = resting.loads(scene, model, options)
    rest = model.equilibrium(**given, u=dict(options.u), check=True)
    found = model.linearize(rest, inputs=options.input, outputs=options.output)
    print(json.dumps(numbers(found), indent=1) if options.json else found)
    return 0


def numbers(found: Any) -> dict[str, Any]:
    """A linear model for JSON; eigenvalues as [real, imaginary]."""
    matrices = {name: getattr(found, name).tolist() for name in "ABCD"}
    return {
        "states": list(found.states),
        "inputs": list(found.inputs),
        "outputs": list(found.outputs),
        "stable": found.stable,
        "eigenvalues": [[v.real, v.imag] for v in found.eigenvalues.tolist()],
        **matrices,
    }
