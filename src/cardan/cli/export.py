"""``cardan export``: the functions of a scene as C that needs no cardan.

Write the functions of a scene as C99 that compiles alone, with headers, a manifest, an example, and
a package for NumPy, CasADi or JAX. What is written needs no cardan.

examples:
  cardan export arm.urdf -o arm_c
        dynamics, mass matrix and energy; arm_c/README.md says how to build and call them
  cardan export arm.urdf -o arm_c --functions forward_dynamics pose:hand --language c
        these two and no package; a frame or joint stands behind the colon
  cardan export pendulum.yaml -o pendulum_c --integrators dop853
        with an integrator: pendulum_c/example.c simulates one second
  cardan export arm.urdf -o arm_casadi --language casadi --functions forward_dynamics
        a module for CasADi, or for JAX, with exact first derivatives
  cardan export crane.yaml -o crane_c --integrators alpha
        a scene with beams: C of its elements, tables of them, sparse matrices, and a run
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from .options import scene as scene_options


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    from ..codegen.languages import BINDINGS

    scene_options.arguments(parser)
    what = parser.add_argument_group("what is written")
    what.add_argument("-o", "--output", metavar="DIR", type=Path, required=True,
                      help="a new or empty directory, or an earlier export")  # fmt: skip
    what.add_argument("--functions", metavar="NAME", nargs="+", type=_function,
                      help="such as forward_dynamics or pose:hand")  # fmt: skip
    what.add_argument("--language", choices=tuple(BINDINGS),
                      help="cython adds a package for NumPy (default, but for beams), casadi and "
                           "jax modules for these")  # fmt: skip
    what.add_argument("--integrators", metavar="METHOD", nargs="+", default=[],
                      help="such as dop853, radau or alpha: C that simulates")  # fmt: skip
    scene_options.method(what)
    what.add_argument("--reproducible", action="store_true",
                      help="flags under which every compiler gives equal bits")  # fmt: skip
    what.add_argument("--prefix", metavar="NAME", default="",
                      help="before all names, such as arm_: several in one program")  # fmt: skip
    what.add_argument("--precision", choices=("double", "single"), default="double",
                      help="single: float everywhere, for microcontrollers")  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print JSON for another program")


def _function(text: str) -> object:
    """``bias`` or ``pose:hand``."""
    name, colon, of = text.partition(":")
    return (name, of) if colon else name


def run(options: argparse.Namespace) -> int:
    """Load, derive, write."""
    from ..pipeline import derive
    from .terminal import console, progress

    scene = scene_options.read(options)
    with progress() as show:
        show("deriving and writing")
        chosen = {"language": options.language} if options.language else {}
        folder = derive(scene, method=options.method).export(
            options.output,
            options.functions,
            integrators=options.integrators,
            reproducible=options.reproducible,
            prefix=options.prefix,
            precision=options.precision,
            **chosen,
        )
    files = sorted(path.name for path in folder.iterdir())
    if options.json:
        print(json.dumps({"directory": str(folder), "files": files}, indent=1))
        return 0
    out = console()
    out.print(f"wrote {folder}: {', '.join(files)}", soft_wrap=True)
    # the first line of the example is a comment that says how to compile it
    first = (folder / "example.c").read_text("utf-8").splitlines()[0]
    command = first.removeprefix("/* Try it:").removesuffix("*/").strip()
    out.print(f"try it there:  {command}", soft_wrap=True)
    return 0
