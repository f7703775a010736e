"""URDF robots, with joints that close loops.

Source: the URDF specification, http://wiki.ros.org/urdf/XML. ``<loop_joint>`` is an extension, see
:mod:`.loops`; ``<constraint>`` a proposal, see :mod:`.constraints`.
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
    if root.tag != "robot":
        raise ModelError(f"file '{file}': the root is <{root.tag}>, not <robot>")
    return Reader(root, options, file, folder).model()


def from_text(
    text: str | bytes,
    options: Options | None = None,
    name: str = "text",
    folder: Path | None = None,
) -> SceneRecord:
    """The model of a URDF document.

    Args:
        text: The document.
        options: How to read it.
        name: Of the file, for messages.
        folder: Of the file, for relative mesh paths.

    Raises:
        ModelError: it is not a URDF document, or a link or joint of it is at fault.
        TopologyError: links form a loop or nothing joins them.
    """
    return of_root(parse(text, name), options or Options(), name, folder)
