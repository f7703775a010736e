"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from pathlib import Path
from typing import final

from ..scene.scene import SceneRecord
from ..topology.drawing.graph_view import GraphView

@final
class Scene(SceneRecord):
    """A scene: bodies, joints, beams, forces, parameters, inputs and outputs.
    """
    def save(
        self,
        path: str | Path,
    ) -> None:
        """Write the scene as a file that :func:`cardan.load` reads; whole or not at all.

        Included scenes are written out; numbers keep all their digits.

        Args:
            path: A ``.yaml`` file.

        Raises:
            ModelError: an expression no file can say, or a file that cannot be written.
        """
    def __str__(
        self,
    ) -> str:
        """Bodies with their joints, forces, declared names and notes.
        """
    @property
    def graph(
        self,
    ) -> GraphView:
        """The graph of a model; bodies that nothing joins to the ground are left out of the tree.
        """
