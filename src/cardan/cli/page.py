"""``cardan page``: a page in which a model runs, with sliders and a mouse.

Write one HTML file in which the equations of a scene are integrated while it is open: parameters
and inputs are sliders, bodies are pulled with the mouse, a link holds the values. It needs no
network, no server and no compiler.

examples:
  cardan page double_pendulum -o pendulum.html --q shoulder=1.6
        the parameters that the scene declares are sliders
  cardan page four_bar -o four_bar.html --slider C.position.x=0.2:1 --trace coupler
        the length of a link; the loop is assembled again while the slider moves
  cardan page arm.urdf -o arm.html --plot energy --plot elbow
        a robot with its meshes, and two histories
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from .options import run as run_options
from .options import scene as scene_options


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    scene_options.arguments(parser)
    what = parser.add_argument_group("the page")
    what.add_argument("-o", "--output", metavar="FILE", type=Path, required=True,
                      help="HTML file to write")  # fmt: skip
    what.add_argument("--slider", metavar="NAME[=LOW:HIGH]", type=_slider, action="append",
                      help="parameter or input, and its range; may be repeated (default: all that "
                           "the scene declares)")  # fmt: skip
    what.add_argument("--q", metavar="JOINT=VALUE", type=run_options.named, action="append",
                      default=[], help="initial coordinate; may be repeated")  # fmt: skip
    what.add_argument("--u", metavar="JOINT=VALUE", type=run_options.named, action="append",
                      default=[], help="initial speed; may be repeated")  # fmt: skip
    what.add_argument("--plot", metavar="NAME", action="append",
                      help="history: a coordinate, speed, output or energy (default)")  # fmt: skip
    what.add_argument("--trace", metavar="FRAME", action="append", default=[],
                      help="frame whose path is drawn; may be repeated")  # fmt: skip
    what.add_argument("--page", choices=("auto", "3d", "plain"), default="auto",
                      help="plain: drawn without WebGL, a tenth of the size (default: plain "
                           "without meshes)")  # fmt: skip
    what.add_argument("--no-drag", action="store_true", help="the mouse pulls nothing")
    what.add_argument("--rtol", metavar="TOL", type=float, default=1e-6,
                      help="relative tolerance (default 1e-6)")  # fmt: skip
    what.add_argument("--title", metavar="TEXT", help="headline (default: name of the scene)")
    parser.add_argument("--json", action="store_true", help="print JSON for another program")


def _slider(text: str) -> tuple[str, tuple[float, float] | None]:
    """The type of ``m=0.1:5`` or ``m``."""
    name, equals, ends = text.partition("=")
    if not equals and name:
        return name, None
    try:
        low, high = (float(end) for end in ends.split(":"))
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"'{text}' does not read NAME=LOW:HIGH, such as m=0.1:5"
        ) from None
    return name, (low, high)


def run(options: argparse.Namespace) -> int:
    """Load, derive, write."""
    from ..live import page
    from .terminal import console, progress

    scene = scene_options.read(options)
    with progress() as show:
        show("deriving and writing")
        written = page(
            scene,
            options.output,
            sliders=dict(options.slider) if options.slider else None,
            q=dict(options.q) or None,
            u=dict(options.u) or None,
            plots=options.plot,
            traces=options.trace,
            drag=not options.no_drag,
            page=options.page,
            rtol=options.rtol,
            title=options.title,
        )
    size = Path(written).stat().st_size
    if options.json:
        print(json.dumps({"file": str(options.output), "bytes": size}, indent=1))
        return 0
    console().print(f"wrote {options.output}: {size / 1e3:.0f} KB, open it in a browser")
    return 0
