r"""``cardan parts``: ready subsystems, listed, explained or written as scene files.

List the parts of the library, say what one of them takes, or write it as a scene file to simulate,
to change, or to include in another.

examples:
  cardan parts                         all of them, with a line on each
  cardan parts four_bar                its parameters, inputs, outputs and frames
  cardan parts four_bar --set crank_length=0.08 -o four_bar.yaml
        a scene file;  cardan simulate four_bar.yaml --view four_bar.html  shows it move
"""

from __future__ import annotations

import argparse
import inspect
import json
from typing import TYPE_CHECKING

from ..errors import ModelError, near
from .options import run as run_options

if TYPE_CHECKING:
    from ..api.scene import Scene


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument("part", nargs="?", metavar="PART", help="its name")
    parser.add_argument("--set", metavar="NAME=VALUE", type=setting, action="append", default=[],
                        help="a number or choice of it; give it again for another")  # fmt: skip
    parser.add_argument("-o", "--output", metavar="FILE.yaml", type=run_options.file(".yaml"),
                        help="write the part as a scene file")  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """List parts, or show or write one."""
    from ..parts import PARTS

    if options.part is None:
        if options.set or options.output:
            options.parser.error("name the PART that --set and -o speak of")
        if options.json:
            print(json.dumps({name: summary(make()) for name, make in PARTS.items()}, indent=1))
            return 0
        width = max(map(len, PARTS))
        for name, make in PARTS.items():
            print(f"{name:{width}}  {(inspect.getdoc(make) or '').splitlines()[0]}")
        return 0
    if options.part not in PARTS:
        raise ModelError(f"there is no part '{options.part}'.{near(options.part, PARTS)}")
    make = PARTS[options.part]
    scene = make(**dict(options.set))
    if options.output is not None:
        options.output.parent.mkdir(parents=True, exist_ok=True)
        scene.save(options.output)
    if options.json:
        print(json.dumps(summary(scene), indent=1))
    elif options.output is not None:
        print(f"wrote {options.output}; next: cardan simulate {options.output}")
    else:
        print(inspect.getdoc(make))
        print(f"\n{scene}")
    return 0


def summary(scene: Scene) -> dict[str, object]:
    """Names of a part and its numbers."""
    return {
        "parameters": {
            one.name: {"value": one.value, "unit": one.unit} for one in scene.parameters.values()
        },
        "inputs": {
            one.name: {"value": one.value, "unit": one.unit} for one in scene.inputs.values()
        },
        "outputs": {one.name: one.unit for one in scene.outputs.values()},
        "frames": [frame.name for frame in scene.frames.values() if frame.named],
        "joints": list(scene.joints),
    }


def setting(text: str) -> tuple[str, float | int | str | list[float]]:
    """The type of ``crank_length=0.08``, ``planets=4``, ``fixed=sun`` or ``hub=0,0.7,0``."""
    name, separator, value = text.partition("=")
    if not (separator and name.isidentifier() and value):
        raise argparse.ArgumentTypeError(f"'{text}' does not read NAME=VALUE, such as lift=0.01")
    if value.isascii() and value.isdigit():
        return name, int(value)
    try:
        numbers = [float(x) for x in value.split(",")]
    except ValueError:
        return name, value
    return name, numbers[0] if len(numbers) == 1 else numbers
