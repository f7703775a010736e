"""A scene as users hold it."""

from __future__ import annotations

from typing import final

from ..scene.scene import SceneRecord
from .faces import attribute, verb


@final
class Scene(SceneRecord):
    """A scene: bodies, joints, beams, forces, parameters, inputs and outputs."""

    save = verb("cardan.topology.scene_files:save")
    __str__ = verb("cardan.scene.summary:summary")
    superelement = verb("cardan.scene.superelement_arguments:add_superelement")
    reduce = verb("cardan.equations.components.beams:reduce")
    graph = attribute("cardan.topology.drawing.graph_view:view")
