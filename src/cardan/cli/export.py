"""``cardan export``: a scene as C that needs no cardan, or as an FMU.

Write the functions of a scene as C99 that compiles alone, with headers, a manifest, an example, and
a package for NumPy, CasADi, JAX or JavaScript. What is written needs no cardan. A name that ends
with .fmu makes a Functional Mock-up Unit, which other simulation programs load.

examples:
  cardan export arm.urdf -o arm_c
        dynamics, mass matrix and energy; arm_c/README.md says how to build and call them
  cardan export arm.urdf -o arm_c --functions forward_dynamics pose:hand --language c
        these two and no package; a frame or joint stands behind the colon
  cardan export pendulum.yaml -o pendulum_c --integrators dop853
        with an integrator: pendulum_c/example.c simulates one second
  cardan export pendulum.yaml -o pendulum_c --integrators dop853 --gradient 'pivot^2'
        with the gradient of a cost of the motion by its start, parameters and inputs: a formula in
        names of the scene at the end, --running 'tau^2' along the way
  cardan export arm.urdf -o arm_casadi --language casadi --functions forward_dynamics
        a module for CasADi, or for JAX, with exact first derivatives
  cardan export arm.urdf -o arm_wasm --language wasm
        WebAssembly and a module of JavaScript that calls it, for node and pages
  cardan export crane.yaml -o crane_c --integrators alpha
        a scene with beams: C of its elements, tables of them, sparse matrices, and a run
  cardan export arm.urdf -o arm.fmu --q elbow=0.5
        FMI 3.0, model exchange and co-simulation, with directional derivatives; try it:
        fmpy simulate arm.fmu --show-plot
  cardan export arm.urdf -o arm.fmu --fmi 2.0 --kind cs --platform linux windows
        FMI 2.0, co-simulation alone, binaries for two platforms (ziglang links the foreign one)
"""

from __future__ import annotations

import argparse
import json
import zipfile
from pathlib import Path
from typing import TYPE_CHECKING

from .options import run as run_options
from .options import scene as scene_options

if TYPE_CHECKING:
    from ..api.scene import Scene
    from ..schema.cost import Cost

SUFFIX = ".fmu"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    from ..codegen.languages import BINDINGS

    scene_options.arguments(parser)
    what = parser.add_argument_group("what is written")
    what.add_argument("-o", "--output", metavar="DIR", type=Path, required=True,
                      help="a new or empty directory, an earlier export, or NAME.fmu")  # fmt: skip
    what.add_argument("--functions", metavar="NAME", nargs="+", type=_function,
                      help="such as forward_dynamics or pose:hand")  # fmt: skip
    what.add_argument("--language", choices=tuple(BINDINGS),
                      help="cython adds a package for NumPy (default, but for beams), casadi and "
                           "jax modules for these, wasm one for node and pages")  # fmt: skip
    what.add_argument("--integrators", metavar="METHOD", nargs="+", default=[],
                      help="such as dop853, radau or alpha: C that simulates; of an FMU the method "
                           "of co-simulation")  # fmt: skip
    what.add_argument("--gradient", metavar="FORMULA",
                      help="cost at the end of a motion, whose gradient is written too: C, cython "
                           "or jax, with --integrators")  # fmt: skip
    what.add_argument("--running", metavar="FORMULA",
                      help="cost that is integrated along the motion")  # fmt: skip
    scene_options.method(what)
    what.add_argument("--reproducible", action="store_true",
                      help="flags under which every compiler gives equal bits")  # fmt: skip
    what.add_argument("--prefix", metavar="NAME", default="",
                      help="before all names, such as arm_: several in one program")  # fmt: skip
    what.add_argument("--precision", choices=("double", "single"), default="double",
                      help="single: float everywhere, for microcontrollers")  # fmt: skip
    unit = parser.add_argument_group("an FMU")
    unit.add_argument("--fmi", choices=("2.0", "3.0"), help="version (default 3.0)")
    unit.add_argument("--kind", choices=("me", "cs"), nargs="+",
                      help="model exchange, co-simulation (default both; of beams cs)")  # fmt: skip
    unit.add_argument("--platform", metavar="NAME", nargs="*",
                      help="linux, linux-aarch64, windows, macos, macos-x86_64 (default this "
                           "machine's); none: sources alone")  # fmt: skip
    unit.add_argument("--q", metavar="JOINT=VALUE", type=run_options.named, action="append",
                      default=[], help="coordinate to start from; again for another")  # fmt: skip
    unit.add_argument("--u", metavar="JOINT=VALUE", type=run_options.named, action="append",
                      default=[], help="speed to start from")  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print JSON for another program")


def _function(text: str) -> object:
    """``bias`` or ``pose:hand``."""
    name, colon, of = text.partition(":")
    return (name, of) if colon else name


def _start(
    scene: Scene, options: argparse.Namespace, block: str
) -> dict[str, float | list[float]] | None:
    """Start of an FMU, as of ``cardan simulate``: by the file, then as it was typed."""
    unit = options.output.suffix.lower() == SUFFIX
    values = {**(scene.settings.get(block, {}) if unit else {}), **dict(getattr(options, block))}
    return values or None


def _cost(options: argparse.Namespace) -> Cost | None:
    """The cost whose gradient is written."""
    from ..schema.cost import cost

    if options.gradient is None and options.running is None:
        return None
    return cost(final=options.gradient, running=options.running)


def run(options: argparse.Namespace) -> int:
    """Load, derive, write."""
    from ..pipeline import derive
    from .terminal import progress

    scene = scene_options.read(options)
    with progress() as show:
        show("deriving and writing")
        path = derive(scene, method=options.method).export(
            options.output,
            options.functions,
            integrators=options.integrators,
            reproducible=options.reproducible,
            prefix=options.prefix,
            precision=options.precision,
            language=options.language,
            gradient=_cost(options),
            fmi=options.fmi,
            kinds=options.kind,
            platforms=options.platform,
            q=_start(scene, options, "q"),
            u=_start(scene, options, "u"),
        )
    return _report_unit(path, options) if path.is_file() else _report_folder(path, options)


def _report_folder(folder: Path, options: argparse.Namespace) -> int:
    """Say what was written."""
    from .terminal import console

    files = sorted(path.name for path in folder.iterdir())
    if options.json:
        print(json.dumps({"directory": str(folder), "files": files}, indent=1))
        return 0
    out = console()
    out.print(f"wrote {folder}: {', '.join(files)}", soft_wrap=True)
    # the first line of an example is a comment that says how to run it; the last one is of C
    example = next(folder / name for name in reversed(files) if name.startswith("example."))
    first = example.read_text("utf-8").splitlines()[0]
    command = first.strip("/* ").removeprefix("Try it:").strip()
    out.print(f"try it there:  {command}", soft_wrap=True)
    return 0


def _report_unit(path: Path, options: argparse.Namespace) -> int:
    """Say what the FMU is, and how to try it."""
    from defusedxml.ElementTree import fromstring

    from .terminal import console

    with zipfile.ZipFile(path) as archive:
        root = fromstring(archive.read("modelDescription.xml"))
        binaries = sorted(n for n in archive.namelist() if n.startswith("binaries/"))
    kinds = [tag for tag in ("ModelExchange", "CoSimulation") if root.find(tag) is not None]
    about = {
        "file": str(path),
        "fmi": root.get("fmiVersion"),
        "kinds": kinds,
        "binaries": binaries,
        "variables": len(root.findall("ModelVariables/*")),
    }
    if options.json:
        print(json.dumps(about, indent=1))
        return 0
    out = console()
    out.print(
        f"wrote {path}: FMI {about['fmi']}, {' and '.join(kinds)}, {about['variables']} variables, "
        f"{', '.join(binaries) or 'sources alone'}",
        soft_wrap=True,
    )
    out.print(f"try it:  pip install fmpy && fmpy simulate {path} --show-plot", soft_wrap=True)
    return 0
