"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import final

from ..equations.components.beams import Where
from ..scene.beam import Beam
from ..scene.body import Body
from ..scene.scene import SceneRecord
from ..topology.drawing.graph_view import GraphView
from .components import Superelement

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
    def reduce(
        self,
        beams: str | Beam | Sequence[str | Beam],
        modes: int | None = None,
        interfaces: Mapping[str, Where] | None = None,
        *,
        bodies: Sequence[str | Body] = (),
        method: str = "craig_bampton",
        damping: object = None,
        rayleigh: tuple[float, float] | None = None,
        static_shapes: Sequence[str] = (),
        report: bool = True,
    ) -> Superelement:
        """Beams of the scene as a superelement; what that costs is printed.

        Args:
            beams: One or several, by name.
            modes: How many, lowest first; 10 by default.
            interfaces: Ends, nodes, bodies or frames by the names of interfaces; both ends by default.
            bodies: Rigid bodies that belong to the component.
            method, damping, rayleigh, static_shapes: As for ``cd.superelement.reduce``.
            report: Whether ``cost`` of the record is printed.

        Returns:
            The record that ``cd.superelement.from_beams`` gives.

        Raises:
            ModelError: as there.
        """
    @property
    def graph(
        self,
    ) -> GraphView:
        """The graph of a model; bodies that nothing joins to the ground are left out of the tree.
        """
