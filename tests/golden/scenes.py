"""The scenes of the examples, whatever says them."""

from __future__ import annotations

from pathlib import Path

import cardan as cd
from cardan.codegen.layout import HEADERS
from cardan.schema import kernel_files
from cardan.schema.seal import sealed, unsealed
from explain.scenes import FILES, scene_of

__all__ = ["EXAMPLES", "FLEXIBLE", "FUNCTIONS", "ROOT", "scene_of", "written"]

ROOT = Path(__file__).parents[2]
FUNCTIONS = ("forward_dynamics", "inverse_dynamics", "mass_matrix")
HAPPENING = ("events", "transition")
# a script has a variable ``scene``; a file is one. Of flexible bodies the C is that of their
# elements, which no scene changes: one of them shows it
ON_NODES = ("scene.beam(", "scene.cable(", "scene.superelement(")
EXAMPLES = sorted(
    path
    for path in (*(ROOT / "examples").iterdir(), *FILES)
    if path.suffix in (".py", ".yaml", ".urdf")
    and not any(call in path.read_text("utf-8") for call in ON_NODES)
)
FLEXIBLE = ROOT / "examples" / "17_flexible_pendulum.py"


def written(example: Path, folder: Path) -> Path:
    """The C of an example, as far as ``generated/`` shows it.

    Kernels of the solver and of the mesh, and expressions for derivatives, stand elsewhere; the
    manifest has no hashes of them.
    """
    equations = cd.derive(scene_of(example))
    if example == FLEXIBLE:
        equations.export(folder, functions=("forward_dynamics",))
        left_out = {"functions.json", *(path.name for path in kernel_files.files())} - {*HEADERS}
        for path in folder.iterdir():
            if path.name in left_out:
                path.unlink()
        manifest = folder / "manifest.json"
        data = unsealed(manifest.read_bytes())
        data["sha256"] = {k: x for k, x in data["sha256"].items() if k not in left_out}
        manifest.write_text(sealed(data, indent=1, ensure_ascii=False), "utf-8")
        return folder
    more = HAPPENING if "events" in equations.names() else ()
    return equations.export(folder, functions=(*FUNCTIONS, *more))
