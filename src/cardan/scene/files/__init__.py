"""Files that describe scenes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from warnings import catch_warnings, simplefilter

from ...arguments import checked
from ...errors import ModelError, TopologyError, warn
from ..joint_properties import add_friction, add_stops
from ..origins import Origins, gathered
from ..scene import SceneRecord
from . import mjcf, sdf, urdf, yaml
from .document import PLACE, content, parse
from .options import Options

# by the root element of an XML file, whatever its name ends in
ROOTS = {"robot": urdf.of_root, "mujoco": mjcf.of_root, "sdf": sdf.of_root}


def _xml(path: Path, options: Options) -> SceneRecord:
    """The model of a URDF, SDF or MJCF file."""
    root = parse(content(path), path.name)
    reader = ROOTS.get(root.tag)
    if reader is None:
        raise ModelError(
            f"file '{path.name}': the root is <{str(root.tag)[:60]}>; read are "
            + ", ".join(f"<{tag}>" for tag in ROOTS)
        )
    return reader(root, options, path.name, path.parent)


LIMITS = ("note", "stop")
READERS = {
    **dict.fromkeys((".urdf", ".sdf", ".world", ".xml", ".mjcf"), _xml),
    **dict.fromkeys((".yaml", ".yml"), yaml.read),
}


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
) -> SceneRecord:
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
    if limits not in LIMITS:
        raise ModelError(f"limits must be {' or '.join(map(repr, LIMITS))}, not {limits!r}")
    file, options = Path(path), Options(base, mimic, snap, roots, load=_read)
    origins: Origins = {}
    try:
        with catch_warnings(record=True) as said, _named(file):
            simplefilter("always")
            model = _read(file, options)
            origins = model.origins
            if limits == "stop":
                add_stops(model)
            if friction:
                add_friction(model)
    finally:
        # a doubt may say why the file cannot be read
        for doubt in gathered(said, origins):
            warn(str(doubt), type(doubt))
    model.values.update(parameters or {})
    return model


def _read(file: Path, options: Options) -> SceneRecord:
    """The model of a file of any known sort."""
    reader = READERS.get(file.suffix.lower())
    if reader is None:
        raise ModelError(
            f"file '{file.name}': cannot read '{file.suffix}' files. Known: {', '.join(READERS)}"
        )
    options.budget.take()
    with _named(file):
        return reader(file, options)


@contextmanager
def _named(file: Path) -> Iterator[None]:
    """Errors about a scene name the file it was read from."""
    try:
        yield
    except (ModelError, TopologyError) as problem:
        if file.name in str(problem) or PLACE.match(str(problem)):
            raise
        raise type(problem)(f"file '{file.name}': {problem}") from problem
