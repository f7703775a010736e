"""The command line: one command per file, loaded when it is called.

Exit status: 0 done, 1 the scene or the numbers are at fault, 2 wrong use. Messages go to standard
error, results to standard output.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import NoReturn

from .. import __version__
from ..errors import CardanError

# command -> module of this package and what it does, in one line
COMMANDS = {
    "demo": (".demo", "derive, compile and simulate a robot, and show every step"),
    "inspect": (".inspect", "graph, coordinates, equations and counts of a scene"),
    "simulate": (".simulate", "simulate a mechanism from its scene file, a robot from its URDF"),
    "doctor": (".doctor", "compiler, cache, versions: what works here, what to do about the rest"),
}

DESCRIPTION = """\
cardan compiles multibody mechanics: bodies and joints become equations of motion, the equations
become C, the C becomes fast functions and simulations."""

EPILOG = """\
start here:
  cardan demo                                a small arm, offline, in seconds
  cardan simulate arm.urdf --time 10         your own robot, or a scene (.yaml)
  cardan inspect arm.urdf -o arm.html        its equations, on a page to read
  cardan simulate --help                     all that can be said about a run
  cardan doctor                              what works on this machine

exit status: 0 done, 1 the scene or the numbers are at fault, 2 wrong use"""


class Parser(argparse.ArgumentParser):
    """Keeps the line breaks of the help texts, and says where help is."""

    def __init__(self, **options: object) -> None:
        options.setdefault("formatter_class", argparse.RawDescriptionHelpFormatter)
        super().__init__(**options)  # type: ignore[arg-type]

    def error(self, message: str) -> NoReturn:
        self.print_usage(sys.stderr)
        self.exit(2, f"{self.prog}: {message}\nTry '{self.prog} --help'.\n")


def parser(command: str | None = None) -> Parser:
    """The parser; only the named command is loaded and gets its options."""
    top = Parser(prog="cardan", description=DESCRIPTION, epilog=EPILOG)
    top.add_argument("--version", action="version", version=f"cardan {__version__}")
    commands = top.add_subparsers(dest="command", metavar="COMMAND", parser_class=Parser)
    for name, (module, summary) in COMMANDS.items():
        if name == command:
            loaded = import_module(module, __package__)
            own = commands.add_parser(
                name, help=summary, description=loaded.DESCRIPTION, epilog=loaded.EPILOG
            )
            loaded.arguments(own)
            own.set_defaults(run=loaded.run)
        else:
            commands.add_parser(name, help=summary)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Returns:
        The exit status.
    """
    words = list(sys.argv[1:] if arguments is None else arguments)
    command = next((word for word in words if not word.startswith("-")), None)
    top = parser(command)
    options = top.parse_args(words)
    if options.command is None:
        top.print_help(sys.stderr)
        return 2
    try:
        return int(options.run(options))
    except (CardanError, OSError) as problem:
        print(f"cardan {options.command}: {problem}", file=sys.stderr)
    except KeyboardInterrupt:
        print(f"cardan {options.command}: interrupted", file=sys.stderr)
    return 1
