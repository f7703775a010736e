"""The scenes of the examples, whatever says them."""

from __future__ import annotations

import os
import runpy
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import cardan as cd

ROOT = Path(__file__).parents[2]
FUNCTIONS = ("forward_dynamics", "inverse_dynamics", "mass_matrix")
# a script has a variable ``scene``; a file is one. Of beams the C is that of their elements, which
# no scene changes
EXAMPLES = sorted(
    path
    for path in (ROOT / "examples").iterdir()
    if path.suffix in (".py", ".yaml", ".urdf") and "scene.beam(" not in path.read_text("utf-8")
)


@cache
def scene_of(example: Path) -> cd.Model:
    """The scene of an example; a script runs in a folder of its own."""
    if example.suffix != ".py":
        return cd.load(example)
    before = Path.cwd()
    with TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            scene: cd.Model = runpy.run_path(str(example))["scene"]
        finally:
            os.chdir(before)
    return scene
