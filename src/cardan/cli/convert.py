"""``cardan convert``: a scene in another format.

Read a scene, or a robot described by a URDF, SDF or MJCF file, and write it as a scene file or as
URDF. A scene file says everything; what URDF cannot say is listed.

examples:
  cardan convert arm.yaml -o arm.urdf
        links, joints, limits, damping and shapes; the parameters become numbers
  cardan convert arm.yaml -o arm.urdf --strict
        refused where URDF cannot say all of it: loops, springs, events, beams, ...
  cardan convert hand.xml -o hand.yaml
        a model of MuJoCo as a scene file
"""

from __future__ import annotations

import argparse
import json
import warnings
from pathlib import Path

from ..errors import ModelWarning
from .options import scene as scene_options


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    scene_options.arguments(parser)
    what = parser.add_argument_group("what is written")
    what.add_argument("-o", "--output", metavar="FILE", type=Path, required=True,
                      help="a .yaml or .urdf file")  # fmt: skip
    what.add_argument("--strict", action="store_true",
                      help="refuse to write what does not say everything")  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """Load, write, say what is lost."""
    scene = scene_options.read(options)
    with warnings.catch_warnings():
        # the list below says more
        warnings.filterwarnings("ignore", "file '.*' does not say", ModelWarning)
        losses = scene.save(options.output, strict=options.strict)
    if options.json:
        print(json.dumps({"file": str(options.output), "losses": losses}, indent=1))
        return 0
    print(f"wrote {options.output}")
    if losses:
        print("it does not say", *losses, sep="\n  ")
    return 0
