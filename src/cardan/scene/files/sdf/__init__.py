"""SDF, the files of Gazebo: models of links and joints, kinematic loops among them.

Source: the SDFormat specification, http://sdformat.org/spec, and its pages on model kinematics and
on the semantics of poses.
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
    if root.tag != "sdf":
        raise ModelError(f"file '{file}': the root is <{root.tag}>, not <sdf>")
    return Reader(root, options, file, folder).model()


def from_text(
    text: str | bytes,
    options: Options | None = None,
    name: str = "text",
    folder: Path | None = None,
) -> SceneRecord:
    """The model of an SDF document.

    Args:
        text: The document.
        options: How to read it.
        name: Of the file, for messages.
        folder: Of the file, for relative mesh paths.

    Raises:
        ModelError: it is not an SDF document, or an item of it is at fault; with file and line.
        TopologyError: nothing joins a link.
    """
    return of_root(parse(text, name), options or Options(), name, folder)
