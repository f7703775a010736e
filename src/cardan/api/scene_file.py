"""Files of scenes as users read them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ..arguments import checked
from ..scene import read
from ..scene.files.options import Options
from .faces import face

if TYPE_CHECKING:
    from ..superelements.record import Superelement
    from .scene import Scene


@checked
def load(
    path: str | Path,
    base: str = "fixed",
    mimic: str = "couple",
    snap: bool = True,
    packages: str | Path | Sequence[str | Path] = (),
    parameters: Mapping[str, float] | None = None,
    limits: str = "note",
    friction: bool = False,
) -> Scene:
    """Read a scene from a file.

    Args:
        path: A scene (``.yaml``), a robot (``.urdf``, ``.sdf``) or a model of MuJoCo (``.xml``,
            ``.mjcf``); the root element tells these apart.
        base: For URDF and SDF robots: ``"fixed"``: the root is fixed to the ground; ``"free"``: it
            floats.
        mimic: For URDF and SDF robots: ``"couple"``: a joint that mimics another follows it;
            ``"free"``: it moves freely.
        snap: Replace rounded multiples of a quarter turn by exact ones, within half a unit of the
            last printed digit; all are listed in ``Model.snaps``. With False numbers stay as they
            are printed.
        packages: Folder or folders below which ``package://`` and ``model://`` paths and absolute
            paths must lie.
        parameters: Values by dotted name that replace those of the file.
        limits: ``"stop"``: limits of position act as a :class:`cardan.Stop`, ``<joint>.stop``, on
            joints of one coordinate that are neither coupled nor prescribed; where 0 is outside,
            the joint starts in the middle of its range. ``"note"``: limits are only listed.
        friction: Dry friction of the file acts as a :class:`cardan.Friction`,
            ``<joint>.friction``; otherwise it is only listed.

    Returns:
        The model. What the file says and the model does not act on is listed in ``Model.notes``;
        ``print(model)`` shows these, and joints whose limits or friction no force acts for.

    Raises:
        ModelError: the file cannot be read or is at fault.
        TopologyError: links form a loop or nothing joins them.
    """
    folders = [packages] if isinstance(packages, str | Path) else packages
    roots = tuple(Path(root) for root in folders)
    options = Options(base, mimic, snap, roots, mesh_reduction=_mesh_reduction)
    scene: Scene = face(read(path, options, parameters, limits, friction))
    return scene


def _mesh_reduction() -> Callable[..., Superelement]:
    from ..solids import from_mesh

    return from_mesh
