"""Files that describe scenes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from ...errors import ModelError
from ..model import Model
from . import urdf

READERS = {".urdf": urdf.read}


def load(
    path: str | Path,
    base: str = "fixed",
    mimic: str = "couple",
    snap: bool = True,
    packages: Sequence[str | Path] = (),
    parameters: Mapping[str, float] | None = None,
) -> Model:
    """Read a scene from a file.

    Args:
        path: A ``.urdf`` file.
        base: ``"fixed"``: the root is fixed to the ground; ``"free"``: it floats.
        mimic: ``"couple"``: a joint that mimics another follows it; ``"free"``: it moves freely.
        snap: Replace rounded multiples of a quarter turn by exact ones, within half a unit of the
            last printed digit; all are listed in ``Model.snaps``. With False numbers stay as they
            are printed.
        packages: Folders below which ``package://`` paths and absolute paths must lie.
        parameters: Values by dotted name that replace those of the file.

    Returns:
        The model. What the file says and the model does not act on is listed in ``Model.notes``.

    Raises:
        ModelError: the file cannot be read or is at fault.
        TopologyError: links form a loop or nothing joins them.
    """
    file = Path(path)
    reader = READERS.get(file.suffix.lower())
    if reader is None:
        raise ModelError(
            f"file '{file.name}': cannot read '{file.suffix}' files. Known: {', '.join(READERS)}"
        )
    model = reader(file, urdf.Options(base, mimic, snap, tuple(Path(root) for root in packages)))
    model.values.update(parameters or {})
    return model
