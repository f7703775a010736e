"""Options shared by the commands that read a scene: its file and how to read it."""

from __future__ import annotations

import argparse
import sys
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

from ...errors import ModelError, near, warn
from .spelling import spelled

if TYPE_CHECKING:
    from ...api.scene import Scene


# formalisms; these words are no reason to load the compiler
METHODS = (
    "auto (the fewest operations)", "kane", "newton_euler", "composite", "articulated", "lagrange",
    "hamilton", "gibbs_appell", "barycentric",
)  # fmt: skip


def arguments(parser: argparse.ArgumentParser, optional: bool = False) -> None:
    """Declare the file, which may be left out if it is optional, and how it is read."""
    parser.add_argument(
        "file",
        metavar="FILE",
        nargs="?" if optional else None,
        type=Path,
        help="a scene (.yaml), robot (.urdf, .sdf) or MJCF (.xml); or the name of an example",
    )
    file = parser.add_argument_group("reading a robot")
    file.add_argument("--base", choices=("fixed", "free"), default="fixed",
                      help="is the first link fixed to the ground? (default fixed)")  # fmt: skip
    file.add_argument("--mimic", choices=("couple", "free"), default="couple",
                      help="do mimic joints follow their leader? (default couple)")  # fmt: skip
    file.add_argument("--no-snap", action="store_true",
                      help="keep angles as printed: 1.5708 stays 1.5708, not pi/2")  # fmt: skip
    file.add_argument("--limits", choices=("note", "stop"), default="note",
                      help="joint limits are noted (default) or act as stops")  # fmt: skip
    file.add_argument("--friction", action="store_true", help="let dry friction of joints act")
    file.add_argument("--packages", metavar="DIR", type=Path, action="append", default=[],
                      help="folder of package:// and model:// paths; may be repeated")  # fmt: skip


def method(group: argparse._ArgumentGroup) -> None:
    """Declare the formalism; unknown ones are refused with their near names when they are used."""
    group.add_argument("--method", metavar="METHOD", default="auto", help=", ".join(METHODS))


def load(options: argparse.Namespace) -> Scene:
    """The scene."""
    from ...api.scene_file import example_files, load

    file = options.file
    if not file.exists() and not file.suffix:
        # a name without an ending may be that of an example
        examples = example_files()
        if str(file) not in examples:
            raise ModelError(f"there is no file or example '{file}'.{near(str(file), examples)}")
        file = examples[str(file)]
    return load(
        file,
        base=options.base,
        mimic=options.mimic,
        snap=not options.no_snap,
        packages=options.packages,
        limits=options.limits,
        friction=options.friction,
    )


def read(options: argparse.Namespace) -> Scene:
    """The scene; its notes go to standard error."""
    from ...scene.summary import notes_of

    notes = list[str]()
    try:
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            scene = load(options)
        notes = notes_of(scene)
    finally:
        # warnings first, without those that a note repeats
        for one in said:
            if not any(note in str(one.message) for note in notes):
                warn(str(one.message), one.category)
    for note in notes:
        print(f"note: {spelled(note, options)}", file=sys.stderr)
    return scene
