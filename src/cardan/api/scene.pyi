"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import final

from ..elements.quantity import Value
from ..equations.components.beams import Where
from ..scene.beam import Beam
from ..scene.body import Body
from ..scene.frame import Place
from ..scene.scene import SceneRecord
from ..scene.superelement_arguments import FlexibleBody
from ..topology.drawing.graph_view import GraphView
from .components import Superelement

@final
class Scene(SceneRecord):
    """A scene: bodies, joints, beams, forces, parameters, inputs and outputs.
    """
    def save(
        self,
        path: str | Path,
        strict: bool = False,
    ) -> tuple[str, ...]:
        """Write the scene as a file that :func:`cardan.load` reads; whole or not at all.

        A ``.yaml`` file says everything: included scenes are written out, numbers keep all their
        digits, records of superelements are written beside it (``crane.boom.npz``). A ``.urdf`` file
        has links, joints, limits, damping, friction, shapes and their numbers, for the parameters as
        they are; what it cannot say is listed, and warned of.

        Args:
            path: A ``.yaml`` or ``.urdf`` file.
            strict: Refuse to write a file that does not say everything.

        Returns:
            What the file does not say, a sentence each; nothing for ``.yaml``.

        Raises:
            ModelError: another ending, what no file of this format can say, or a file that cannot be
                written.
        """
    def __str__(
        self,
    ) -> str:
        """Bodies with their joints, forces, declared names and notes.
        """
    def superelement(
        self,
        name: str,
        record: Superelement,
        interfaces: Mapping[str, Place | str] | None = None,
        *,
        frame: str | None = None,
        weights: Sequence[float] | None = None,
        stiffening: bool = False,
        inertia: str = "nodal",
        loads: Mapping[str, Value] | None = None,
    ) -> FlexibleBody:
        """Add a flexible body that was reduced from finite elements: see ``cd.superelement``.

        It moves as far as it likes and deforms by little: displacements and rotations of its
        interfaces against a frame that goes along with them are linear in the forces, which turn with
        the frame. Its inertia is that of all its nodes.

        Args:
            name: Its name; that of an interface is ``<name>.<interface>``.
            record: Its matrices.
            interfaces: Frames or bodies that interfaces are fixed to; joints and forces hold others
                at ``at(interface)``, as they do bodies.
            frame: An interface that the frame is fixed to; ``"mean"``, the default of several
                interfaces: the weighted mean of their displacements and rotations vanishes;
                ``"chord"``: of rotations only those about the line from the first to the last count.
            weights: Of the interfaces in the mean, equal ones by default.
            stiffening: Whether the centrifugal forces of its rotation stiffen it; needs a record with
                the geometric stiffness by these.
            inertia: ``"nodal"``: of all nodes, whatever the velocity of the frame; ``"projected"``:
                by projection of the mass matrix as it is, which for beams and shells depends on that
                velocity a little; ``"corotated"``: by the velocities of interfaces and modal rates
                alone, the simpler form of the source. Its modal coordinates feel neither their
                centrifugal force nor that the frame moves, so that a spin beside a velocity of the
                body bends it.
            loads: Factors of loads of the record, by name: numbers, parameters, inputs or expressions
                in these and t. The loads act where the body is without deformation and turn with its
                frame. ``scene.superelement("arm", link, loads={"temperature": 40.0})``.

        Returns:
            The superelement; ``at`` gives its interfaces as frames.

        Raises:
            ModelError: unknown interfaces, a frame that they leave loose, or a name that is taken.

        Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), chapter 8.
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
        stiffening: str | None = None,
        report: bool = True,
    ) -> Superelement:
        """Beams of the scene as a superelement; what that costs is printed.

        Args:
            beams: One or several, by name.
            modes: How many, lowest first; 10 by default.
            interfaces: Ends, nodes, bodies or frames by the names of interfaces; both ends by default.
            bodies: Rigid bodies that belong to the component.
            method, damping, rayleigh, static_shapes: As for ``cd.superelement.reduce``.
            stiffening: As for ``cd.superelement.from_beams``.
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
