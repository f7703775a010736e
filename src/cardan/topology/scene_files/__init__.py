"""Scenes as files: the ending of the name says the format; a new one is a file and a line here."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from ...arguments import checked
from ...errors import ModelError, ModelWarning, counted, likely, warn
from ...scene.files.yaml import writer as yaml
from ...scene.scene import SceneRecord
from . import urdf

# writes a scene; what the file does not say, a sentence each, is refused where that is asked for
Writer = Callable[[SceneRecord, Path, bool], tuple[str, ...]]
WRITERS: Mapping[str, Writer] = {
    **dict.fromkeys((".yaml", ".yml"), yaml.write),
    ".urdf": urdf.write,
}


@checked
def save(scene: SceneRecord, path: str | Path, strict: bool = False) -> tuple[str, ...]:
    """Write the scene as a file that :func:`cardan.load` reads; whole or not at all.

    A ``.yaml`` file says everything: included scenes are written out, numbers keep all their
    digits, records of superelements are written beside it (``crane.boom.npz``). A ``.urdf`` file
    has links, joints, limits, damping, friction, shapes and their numbers, for the parameters as
    they are; what it cannot say is listed, and warned of.

    Args:
        scene: The scene.
        path: A ``.yaml`` or ``.urdf`` file.
        strict: Refuse to write a file that does not say everything.

    Returns:
        What the file does not say, a sentence each; nothing for ``.yaml``.

    Raises:
        ModelError: another ending, what no file of this format can say, or a file that cannot be
            written.
    """
    path = Path(path)
    ending = path.suffix.lower()
    if ending not in WRITERS:
        close = likely(ending, [*WRITERS])
        hint = f". Did you mean {' or '.join(close)}?" if close else ""
        raise ModelError(
            f"file '{path.name}': scenes are saved as {', '.join(WRITERS)}, not '{ending}'{hint}"
        )
    losses = WRITERS[ending](scene, path, strict)
    if losses:
        said = counted(len(losses), "thing")
        warn(
            f"file '{path.name}' does not say {said} of '{scene.name}', which save() returns; "
            f"first: {losses[0]}",
            ModelWarning,
        )
    return losses
