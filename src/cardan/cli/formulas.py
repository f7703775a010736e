"""``cardan linearize --symbolic``: the matrices of a linear model as formulas."""

from __future__ import annotations

import argparse
import json
import re
from typing import TYPE_CHECKING, Any

from ..errors import DerivationError, ModelError
from .options import scene as scene_options

if TYPE_CHECKING:
    from ..api.equations import Equations

# what formulas have no use for
NUMBERS = ("lock", "set", "target", "free", "vary", "coordinate", "campbell", "sensitivity", "plot")
# names in an expression, but for functions
NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*(?!\w|\.\w|\s*\()")


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what formulas take besides."""
    group = parser.add_argument_group("formulas")
    group.add_argument("--symbolic", action="store_true",
                       help="M, D, G, K, N, or A, B, C, D, as formulas; nothing is "
                       "compiled, nor an equilibrium sought")  # fmt: skip
    group.add_argument("--about", metavar="NAME=EXPRESSION", type=expression, action="append",
                       default=[], help="coordinate or speed (joint.u) of the motion about which, "
                       "with any symbols; with --symbolic")  # fmt: skip
    group.add_argument("--independent", metavar="NAME", action="append", default=[],
                       help="coordinate from which others follow, and whose equations are "
                       "shown; with --symbolic")  # fmt: skip


def expression(text: str) -> tuple[str, str]:
    """The type of ``wheel.u=v/r``."""
    name, separator, value = text.partition("=")
    if not (separator and name.strip() and value.strip()):
        raise argparse.ArgumentTypeError(f"'{text}' does not read NAME=EXPRESSION")
    return name.strip(), value.strip()


def is_symbolic(options: argparse.Namespace) -> bool:
    """True when formulas are asked for.

    Raises:
        ModelError: options of formulas without ``--symbolic``, or with it those of numbers.
    """
    if not options.symbolic and (options.about or options.independent):
        raise ModelError("--about and --independent go with --symbolic")
    odd = next((name for name in NUMBERS if options.symbolic and getattr(options, name)), None)
    if odd is not None:
        raise ModelError(
            f"--{odd} does not go with --symbolic: formulas are about what --q, --u and --about say"
        )
    return bool(options.symbolic)


def show(options: argparse.Namespace) -> int:
    """Load, derive, linearize, print."""
    from ..api.equations import FiniteElementEquations
    from ..pipeline import derive
    from .terminal import progress

    scene = scene_options.read(options)
    with progress() as show:
        show("deriving")
        equations = derive(scene)
        if isinstance(equations, FiniteElementEquations):
            raise ModelError(
                "--symbolic: there are no formulas of a scene with beams; leave it out"
            )
        q, u = _reference(equations, options)
        linear = equations.linearize(
            {**scene.settings.get("q", {}), **q}, u, inputs=options.input, outputs=options.output,
            independent=options.independent or None,
        )  # fmt: skip
        representation = linear.second_order(options.independent) if options.independent else linear
        show("simplifying")
        text = (
            json.dumps(_formulas(linear, representation), indent=1)
            if options.json
            else str(representation)
        )
    print(text)
    return 0


def _reference(
    equations: Equations, options: argparse.Namespace
) -> tuple[dict[str, object], dict[str, object]]:
    """Coordinates and speeds by name."""
    import sympy

    from ..equations.linearized.reference_input import places_of
    from ..scene.files.expression import parse

    q, u = dict(options.q), dict(options.u)
    for name, text in options.about:
        symbols = {word: sympy.Symbol(word) for word in NAME.findall(text) if word != "pi"}
        value = parse(text, symbols, where=f"--about {name}")
        (q if places_of(name, equations.coordinates) else u)[name] = value
    return q, u


def _formulas(linear: Any, representation: Any) -> dict[str, object]:
    """Names and matrices as text; null where they are too long to write out."""
    names = (
        ["A", "B", "C", "D"] if representation is linear else list(representation.matrices.matrices)
    )
    labels = (
        ("states", "inputs", "outputs") if representation is linear else ("coordinates", "inputs")
    )
    return {word: list(getattr(representation, word)) for word in labels} | {
        name: _matrix(representation, name) for name in names
    }


def _matrix(representation: object, name: str) -> list[list[str]] | None:
    try:
        matrix = getattr(representation, name)
    except DerivationError:
        return None
    return [[str(x) for x in matrix.row(i)] for i in range(matrix.rows)]
