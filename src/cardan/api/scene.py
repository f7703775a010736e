"""A scene as users hold it."""

from __future__ import annotations

from typing import final

from ..scene.scene import SceneRecord
from .faces import attribute


@final
class Scene(SceneRecord):
    """A scene: bodies, joints, beams, forces, parameters, inputs and outputs."""

    graph = attribute("cardan.topology.drawing.graph_view:view")
