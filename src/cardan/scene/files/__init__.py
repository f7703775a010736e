"""Files that describe scenes."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from warnings import catch_warnings, simplefilter

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


def read(
    path: str | Path,
    options: Options,
    parameters: Mapping[str, float] | None,
    limits: str,
    friction: bool,
) -> SceneRecord:
    """The scene of a file, see :func:`cardan.load`."""
    if limits not in LIMITS:
        raise ModelError(f"limits must be {' or '.join(map(repr, LIMITS))}, not {limits!r}")
    file, options = Path(path), dataclasses.replace(options, load=_read)
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
        endings = f"Known: {', '.join(READERS)}"
        if not file.suffix:
            raise ModelError(
                f"file '{file.name}': its name has no ending that tells what it is. {endings}. "
                "Scenes that come with cardan are cardan.examples[name]"
            )
        raise ModelError(f"file '{file.name}': cannot read '{file.suffix}' files. {endings}")
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
