"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from typing import final

from ..scene.scene import SceneRecord
from ..topology.drawing.graph_view import GraphView

@final
class Scene(SceneRecord):
    """A scene: bodies, joints, beams, forces, parameters, inputs and outputs.
    """
    @property
    def graph(
        self,
    ) -> GraphView:
        """The graph of a model; bodies that nothing joins to the ground are left out of the tree.
        """
