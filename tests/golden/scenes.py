"""The scenes of the examples, whatever says them."""

from __future__ import annotations

from pathlib import Path

from explain.scenes import scene_of

__all__ = ["EXAMPLES", "FUNCTIONS", "ROOT", "scene_of"]

ROOT = Path(__file__).parents[2]
FUNCTIONS = ("forward_dynamics", "inverse_dynamics", "mass_matrix")
# a script has a variable ``scene``; a file is one. Of beams the C is that of their elements, which
# no scene changes
EXAMPLES = sorted(
    path
    for path in (ROOT / "examples").iterdir()
    if path.suffix in (".py", ".yaml", ".urdf") and "scene.beam(" not in path.read_text("utf-8")
)
