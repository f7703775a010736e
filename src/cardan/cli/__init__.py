"""The command line: one command per file, loaded when it is called.

cardan compiles multibody mechanics: bodies and joints become equations of motion, the equations
become C, the C becomes fast functions and simulations.

start here:
  cardan demo                                an acrobat on a bar, offline, in seconds
  cardan simulate arm.urdf --time 10         your own robot, or a scene (.yaml)
  cardan inspect arm.urdf -o arm.html        its equations, on a page to read
  cardan ensemble arm.urdf --vary 'elbow=uniform(-1, 1)' --runs 1000
                                             many runs that differ
  cardan modes arm.urdf --lock elbow=0.3     how it vibrates; how it rests: equilibrium, statics
  cardan identify arm.urdf --data run.csv    its masses and inertias, from measurements
  cardan report arm.urdf --time 10           which integrator for which error
  cardan check arm.urdf                      what is wrong with it, and the cure
  cardan export arm.urdf -o arm_c            C to take away
  cardan page arm.urdf -o arm.html           a page in which it runs
  cardan bench arm.urdf                      how fast, how exact, beside other programs
  cardan simulate --help                     all that can be said about a run
  cardan parts                               ready subsystems, to simulate or to include
  cardan doctor                              what works on this machine

completion of commands and options:  eval "$(cardan --completion bash)"   (or zsh, fish)

exit status: 0 done, 1 the scene or the numbers are at fault, 2 wrong use,
130 interrupted (what was computed until then is told)
"""

from __future__ import annotations

import argparse
import os
import re
import signal
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib import import_module
from typing import Any, NoReturn, cast

from ..errors import BuildWarning, CardanError, ModelWarning, SolveWarning
from ..version import VERSION
from .options.spelling import spelled

INTERRUPTED = 128 + signal.SIGINT
# where the examples begin in the docstring of a command
EXAMPLES = re.compile(r"\n\n(?=(?:examples|start here):\n)")
# command -> module of this package and what it does, in one line
COMMANDS = {
    "demo": (".demo", "derive, compile and simulate a robot, and show every step"),
    "check": (".check", "complaints about a scene, each with its cure"),
    "page": (".page", "a page in which the model runs, with sliders and a mouse"),
    "inspect": (".inspect", "graph, coordinates, equations and counts of a scene"),
    "simulate": (".simulate", "simulate a mechanism from its scene file, a robot from its URDF"),
    "equilibrium": (".equilibrium", "where a mechanism rests, and whether stably"),
    "statics": (".statics", "equilibria under loads that change, and where stability ends"),
    "continuation": (".continuation", "every equilibrium a load leads to, with branches"),
    "modes": (".modes", "frequencies and shapes of vibration, at rest or whirling"),
    "linearize": (".linearize", "the linear model, root loci, Campbell diagrams"),
    "trim": (".trim", "what a wanted steady motion takes, and whether it is stable"),
    "identify": (".identify", "masses, inertias and friction from measured motions and forces"),
    "fit": (".fit", "parameters and starts from measured motions, with their errors"),
    "ensemble": (".ensemble", "simulate many runs that differ, and keep what is asked for"),
    "report": (".report", "speed against error of every integrator on a scene"),
    "bench": (".bench", "speed, error and agreement beside other programs"),
    "export": (".export", "C that needs no cardan, with a package for NumPy"),
    "parts": (".parts", "ready subsystems: list them, write one as a scene file"),
    "convert": (".convert", "a scene as URDF, or a robot as a scene file"),
    "doctor": (".doctor", "what works on this machine, and what to do about the rest"),
}


class Parser(argparse.ArgumentParser):
    """Keeps the line breaks of the help texts, and says where help is."""

    def __init__(self, **options: object) -> None:
        options.setdefault("formatter_class", argparse.RawDescriptionHelpFormatter)
        super().__init__(**options)  # type: ignore[arg-type]

    def error(self, message: str) -> NoReturn:
        self.print_usage(sys.stderr)
        self.exit(2, f"{self.prog}: {message}\nTry '{self.prog} --help'.\n")


class Completion(argparse.Action):
    """``--completion SHELL`` prints a script and ends."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: str | Sequence[object] | None,
        option_string: str | None = None,
    ) -> NoReturn:
        from .completion import script

        summaries = {name: summary for name, (_, summary) in COMMANDS.items()}
        print(script(str(values), build_parser(*COMMANDS), summaries))
        parser.exit(0)


def help_of(docstring: str | None) -> tuple[str, str]:
    """Description and examples of a command, from the docstring of its file."""
    title_and_text = (docstring or "").strip().split("\n\n", 1)
    description, *examples = EXAMPLES.split(title_and_text[-1], maxsplit=1)
    return description, "".join(examples)


def build_parser(*loaded: str) -> Parser:
    """The parser; only the named commands are loaded and get their options."""
    description, epilog = help_of(__doc__)
    top = Parser(prog="cardan", description=description, epilog=epilog)
    top.add_argument("--version", action="version", version=f"cardan {VERSION}")
    top.add_argument("--completion", metavar="SHELL", choices=("bash", "zsh", "fish"),
                     action=Completion, help="print completion for bash, zsh or fish")  # fmt: skip
    commands = top.add_subparsers(dest="command", metavar="COMMAND", parser_class=Parser)
    for name, (module, summary) in COMMANDS.items():
        if name in loaded:
            command = import_module(module, __package__)
            description, epilog = help_of(command.__doc__)
            subparser = commands.add_parser(
                name, help=summary, description=description, epilog=epilog
            )
            command.arguments(subparser)
            subparser.set_defaults(run=command.run, parser=subparser)
        else:
            commands.add_parser(name, help=summary)
    return top


@contextmanager
def _warnings(options: argparse.Namespace) -> Iterator[None]:
    """Warnings of cardan as messages of a command, without the line of code that gave them."""
    usual = warnings.showwarning

    def show(message: Any, category: type[Warning], *where: Any, **more: Any) -> None:
        if issubclass(category, ModelWarning | SolveWarning | BuildWarning):
            said = spelled(str(message), options)
            print(f"cardan {options.command}: {said}", file=sys.stderr)
        else:
            usual(message, category, *where, **more)

    with warnings.catch_warnings():
        # typeshed knows no other function there than the usual one
        warnings.showwarning = cast(Any, show)
        yield


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Returns:
        The exit status.
    """
    arguments_typed = list(sys.argv[1:] if arguments is None else arguments)
    command = next((word for word in arguments_typed if not word.startswith("-")), "")
    top = build_parser(command)
    options, unknown = top.parse_known_args(arguments_typed)
    if unknown:
        # the command has help on its own options
        getattr(options, "parser", top).error(f"unrecognized arguments: {' '.join(unknown)}")
    if options.command is None:
        top.print_help(sys.stderr)
        return 2
    try:
        with _warnings(options):
            status = int(options.run(options))
        sys.stdout.flush()
        return status
    except BrokenPipeError:
        # the reader has seen enough; nothing may be written at exit either
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 128 + signal.SIGPIPE
    except (CardanError, OSError) as problem:
        said = spelled(str(problem).removeprefix(f"{options.command}: "), options)
        print(f"cardan {options.command}: {said}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"cardan {options.command}: interrupted", file=sys.stderr)
        return INTERRUPTED
