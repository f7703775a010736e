"""MJCF, the files of MuJoCo: a subset.

Read are bodies, joints, masses, sites, equality constraints and actuators of joints; all else
is named in ``Model.notes``.

Source: the MuJoCo documentation, XML reference, https://mujoco.readthedocs.io.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ....errors import ModelError
from ...scene import SceneRecord
from ..document import parse
from ..options import Options
from .reader import Reader

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement


def of_root(root: XmlElement, options: Options, file: str, folder: Path | None) -> SceneRecord:
    """The model of a parsed document, see :func:`from_text`."""
    if root.tag != "mujoco":
        raise ModelError(f"file '{file}': the root is <{root.tag}>, not <mujoco>")
    if options.base != "fixed" or options.mimic != "couple":
        raise ModelError(
            f"file '{file}': base= and mimic= are for URDF; MJCF says it by <freejoint/> and "
            "<equality>"
        )
    return Reader(root, options, file, folder).scene


def from_text(
    text: str | bytes,
    options: Options | None = None,
    name: str = "text",
    folder: Path | None = None,
) -> SceneRecord:
    """The model of an MJCF document.

    Args:
        text: The document.
        options: How to read it.
        name: Of the file, for messages.
        folder: Of the file; included files lie below.

    Raises:
        ModelError: it is not an MJCF document, or an item of it is at fault; with file and line.
    """
    return of_root(parse(text, name), options or Options(), name, folder)
