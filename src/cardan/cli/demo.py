"""``cardan demo``: from a URDF to a simulation on one screen, every figure measured live.

Go the whole way from a URDF to a simulation and show every step on one screen: the graph, the
derivation, six lines of the C, its speed and its error, a motion and how well it keeps energy.

examples:
  cardan demo           an acrobat on a bar; takes seconds, also without a C compiler
  cardan demo panda     the Franka Panda arm; needs the packages of  pip install 'cardan[demo]'
  cardan demo --open    the motion at the end in a browser

Everything written goes to out/demo or out/demo-panda below the present folder (--out elsewhere).
"""

from __future__ import annotations

import argparse
import importlib.metadata
import importlib.util
import os
import tempfile
import webbrowser
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..errors import BuildError
from ..records import dataclass


@dataclass(frozen=True)
class Scene:
    """A robot the demo can show: its file, and where its motion starts."""

    load: str
    q: dict[str, float]


PACKAGE = "example-robot-data"
SCENES = {
    "acrobat": Scene("acrobat.urdf", {"grip": 1.8, "left_hip": -0.6, "right_knee": 0.5}),
    "panda": Scene(
        "panda_description/urdf/panda.urdf",
        {"panda_joint2": 0.4, "panda_joint4": -1.8, "panda_joint6": 1.2},
    ),
}


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument(
        "scene", nargs="?", choices=tuple(SCENES), default="acrobat", help="(default acrobat)"
    )
    parser.add_argument("--out", type=Path, metavar="DIR", help="folder for what is written")
    parser.add_argument("--open", action="store_true", help="open the page of the motion")


def run(options: argparse.Namespace) -> int:
    """Take the tour and print the screen."""
    scene = SCENES[options.scene]
    suffix = "" if options.scene == "acrobat" else f"-{options.scene}"
    out = options.out or Path("out") / f"demo{suffix}"
    path = locate(options.scene)
    out.mkdir(parents=True, exist_ok=True)
    # meshes are named from the folder of their package, which the file lies in
    packages = [folder for folder in path.resolve().parents if folder.name == PACKAGE]
    with empty_cache():
        from .terminal import progress
        from .tour import take

        picture = importlib.util.find_spec("matplotlib") is not None
        with progress() as show:
            tour = take(path, packages, out, scene.q, show, picture)
    from .screen import display

    display(tour, path, scene.q)
    if options.open:
        webbrowser.open(tour.page.resolve().as_uri())
    return 0


@contextmanager
def empty_cache() -> Iterator[None]:
    """A compile cache of its own: the demo shows what compiling costs, not what it once did."""
    before = os.environ.get("CARDAN_CACHE")
    with tempfile.TemporaryDirectory(prefix="cardan-demo-") as private:
        os.environ["CARDAN_CACHE"] = private
        try:
            yield
        finally:
            del os.environ["CARDAN_CACHE"]
            if before is not None:
                os.environ["CARDAN_CACHE"] = before


def locate(name: str) -> Path:
    """The URDF of a scene.

    Raises:
        BuildError: the package that ships it is not installed.
    """
    if name == "acrobat":
        from ..api.scene_file import example_files

        return example_files()[name]
    try:
        files = importlib.metadata.files(PACKAGE) or []
    except importlib.metadata.PackageNotFoundError:
        files = []
    for entry in files:
        if str(entry).endswith(SCENES[name].load):
            return Path(str(entry.locate())).resolve()
    raise BuildError(
        f"the URDF of '{name}' comes with the package {PACKAGE}, which is not installed; "
        "say  pip install 'cardan[demo]'  or try  cardan demo"
    )
