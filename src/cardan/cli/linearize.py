r"""``cardan linearize``: the linear model of a mechanism.

The linear model x' = A x + B r, y = C x + D r about the equilibrium next to a start, or about a
steady motion (--u, --target), with names and eigenvalues; constraints are eliminated exactly. What
changes (--vary) gives a root locus, or a Campbell diagram, with the places where stability does.

examples:
  cardan linearize trolley.yaml
        about its equilibrium: states, eigenvalues, damping ratios
  cardan linearize cart_pole.yaml --q pole=pi --input cart --output pole
        about the other one; a force along the cart's speed drives, the angle is seen
  cardan linearize rotor.yaml --u spin=14
        in steady motion
  cardan linearize bicycle.yaml --symbolic --about rear_contact.u.x=v \
        --independent rear_contact.lean --independent steer
        M, D, G, K and N as formulas in the speed and the parameters
  cardan linearize bicycle.yaml --target rear_contact.lean=0 \
        --vary 'rear_hub.u=linspace(0, -33, 34)' --plot locus.png
        the eigenvalues of a bicycle that goes faster and faster
  cardan linearize rotor.yaml --vary 'spin=0,300' --campbell --plot campbell.png
        frequencies over the speed, whirl, critical speeds
  cardan linearize column.yaml --sensitivity P --sensitivity bar.mass
        how eigenvalues change with parameters
  cardan linearize trolley.yaml --save model.mat
        A, B, C and D with names and units for MATLAB and Octave; also .json, .npz, .nc
  cardan linearize trolley.yaml --json > model.json
        A, B, C and D for another program
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..errors import ModelError
from . import formulas
from .options import equilibrium as equilibrium_options
from .options import run as run_options
from .options import sweep as sweep_options

if TYPE_CHECKING:
    from ..api.results import LinearModel, Locus


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    group = equilibrium_options.arguments(parser)
    group.add_argument("--u", metavar="JOINT=VALUE", type=run_options.named, action="append",
                       default=[], help="speed of a steady motion")  # fmt: skip
    group.add_argument("--input", metavar="NAME", action="append",
                       help="input, or joint whose force drives (default all inputs)")  # fmt: skip
    group.add_argument("--output", metavar="NAME", action="append",
                       help="output, coordinate or speed (default: all outputs)")  # fmt: skip
    equilibrium_options.trim_arguments(group)
    family = parser.add_argument_group("what changes")
    family.add_argument("--vary", metavar="NAME=VALUES", type=sweep_options.vary, action="append",
                        help="parameter, input or joint whose speed it is: FROM,TO, "
                        "linspace(FROM,TO,COUNT) or a list; repeat: they go together")  # fmt: skip
    family.add_argument("--coordinate", metavar="NAME", action="append",
                        help="whose motions count in a locus (default all)")  # fmt: skip
    family.add_argument("--campbell", action="store_true",
                        help="frequencies and whirl over the speed that varies")  # fmt: skip
    family.add_argument("--sensitivity", metavar="NAME", action="append",
                        help="derivatives of eigenvalues by a parameter; repeat")  # fmt: skip
    parser.add_argument("--save", metavar="MODEL.mat", type=run_options.linear,
                        help="the linear model: .mat, .json, .npz or .nc")  # fmt: skip
    parser.add_argument("--plot", metavar="PATH.png", type=run_options.file(".png", ".pdf", ".svg"),
                        help="locus, Campbell diagram or frequency response "
                        "(needs matplotlib)")  # fmt: skip

    formulas.arguments(parser)


def run(options: argparse.Namespace) -> int:
    """Load, compile, linearize, report."""
    if formulas.is_symbolic(options):
        return formulas.show(options)
    scene, model = equilibrium_options.model(options)
    trimmed = bool(options.target or options.free)
    loads = equilibrium_options.trim_values(scene, model, options) if trimmed else {
        **equilibrium_options.loads(scene, model, options), "u": dict(options.u)
    }  # fmt: skip
    if options.save is not None and (options.vary or options.sensitivity):
        raise ModelError("--save goes with one linear model: leave out --vary and --sensitivity")
    record, table = _linear_record(model, loads, trimmed, options)
    if options.save is not None:
        record.save(options.save)
    if options.plot is not None:
        record.plot(options.plot)
    print(json.dumps(table(record), indent=1) if options.json else record)
    return 0


def _linear_record(
    model: Any, loads: dict[str, Any], trimmed: bool, options: argparse.Namespace
) -> tuple[Any, Callable[[Any], dict[str, Any]]]:
    """The requested record, and the function that turns it into numbers.

    Raises:
        ModelError: options that do not go together.
    """
    if options.vary:
        swept = dict(options.vary)
        odd = next((n for n, values in swept.items() if not hasattr(values, "tolist")), None)
        if odd is not None:
            raise ModelError(f"--vary {odd}: a locus needs values in their order, not chances")
        if options.campbell:
            return model.campbell(swept, **loads), diagram
        return model.root_locus(swept, coordinates=options.coordinate, **loads), locus
    if options.campbell or options.coordinate:
        raise ModelError("--campbell and --coordinate go with --vary: say what changes")
    equilibrium = (model.trim if trimmed else model.equilibrium)(**loads, check=True)
    if options.sensitivity:
        if options.plot is not None:
            raise ModelError("--plot does not go with --sensitivity: there is nothing to draw")
        return model.sensitivity(options.sensitivity, equilibrium), changes
    return equilibrium.model.linearize(
        equilibrium, inputs=options.input, outputs=options.output
    ), numbers


def numbers(linear: LinearModel) -> dict[str, object]:
    """A linear model for JSON; eigenvalues as [real, imaginary]."""
    matrices = {name: getattr(linear, name).tolist() for name in "ABCD"}
    return {
        "states": list(linear.states),
        "inputs": list(linear.inputs),
        "outputs": list(linear.outputs),
        "stable": linear.stable,
        "eigenvalues": [[v.real, v.imag] for v in linear.eigenvalues.tolist()],
        **matrices,
    }


def locus(record: Locus) -> dict[str, object]:
    """A root locus for JSON."""
    return {
        "message": record.message,
        "values": {name: column.tolist() for name, column in record.values.items()},
        "stable": record.stable.tolist(),
        "eigenvalues": [[[v.real, v.imag] for v in row] for row in record.eigenvalues.tolist()],
        "stability_changes": [
            {"kind": c.kind, "lost": c.lost, "frequency": c.frequency, "values": dict(c.values)}
            for c in record.changes
        ],
    }


def diagram(campbell: Any) -> dict[str, Any]:
    """A Campbell diagram for JSON; frequencies [rad/s]."""
    rows = [[equilibrium_options.finite(f) for f in row] for row in campbell.frequencies.tolist()]
    return {
        **locus(campbell.locus),
        "speed": campbell.speed.tolist(),
        "frequencies": rows,
        "whirl": campbell.whirl.tolist(),
        "critical": campbell.critical(),
    }


def changes(sensitivity: Any) -> dict[str, object]:
    """Derivatives of eigenvalues for JSON, null where there are none."""
    return {
        "eigenvalues": [[v.real, v.imag] for v in sensitivity.eigenvalues.tolist()],
        "derivatives": {
            name: [
                [equilibrium_options.finite(v.real), equilibrium_options.finite(v.imag)]
                for v in sensitivity[name].tolist()
            ]
            for name in sensitivity.parameters
        },
    }
