"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import final

from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from ..arrays import Array
from ..runtime.models.finite_elements.superelements import DeformedSuperelementRecord
from ..superelements.readers.matrix_files import ComponentMatricesRecord
from ..superelements.record import SuperelementRecord
from ..view.page import Page

@final
class Superelement(SuperelementRecord):
    """A component, reduced to motions of its interfaces and some modes.
    """
    def animate(
        self,
        mode: int | str = 1,
        path: str | Path | None = None,
        *,
        which: str = "fixed",
        locked: Sequence[str] | None = None,
        scale: float | None = None,
        color: str | None = "displacement",
        title: str | None = None,
    ) -> Page:
        """A page that plays a mode of the component in any browser, one period again and again.

        Without a path, a notebook shows the page in place; elsewhere it is opened in the browser.

        Args:
            mode: Number from 1; of static shapes also the motion, such as ``"hinge.rx"``.
            path: HTML file. It appears complete or not at all.
            which: ``"fixed"``, modes with interfaces fixed; ``"free"``, modes of the free component;
                ``"static"``, shapes by unit motions of interfaces.
            locked: Interfaces or motions that are fixed, of ``"fixed"``; all by default.
            scale: Factor of the shape, of unit modal mass, or of 1 m or 1 rad. By default one can see
                it well.
            color: ``"displacement"``; ``"stress"`` of von Mises, where the record has stress at nodes;
                None for one color. The legend has values of the largest deflection that is drawn.
            title: Headline.

        Returns:
            The page; ``.path`` is its file.

        Raises:
            ModelError: no such mode or interface, or no stress. ArgumentError: other unknown words.
            SolveError: as :meth:`.Superelement.modes`.
        """
    def plot(
        self,
        mode: int | str = 1,
        path: str | Path | None = None,
        *,
        which: str = "fixed",
        locked: Sequence[str] | None = None,
        scale: float | None = None,
        color: str | None = "displacement",
    ) -> Figure:
        """A mode of the component as a Matplotlib figure, written to ``path`` if given.

        Args:
            mode, which, locked, scale, color: As :meth:`.Superelement.animate`.
            path: Picture file; the ending says the format.

        Raises:
            ModelError, ArgumentError, SolveError: as there, or no picture file.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """
    def save(
        self,
        path: str | Path,
    ) -> Path:
        """Write the component; the ending of the name says the format.

        ``.npz`` holds everything and is read by ``cd.superelement.load``. ``.mat`` (MATLAB, Octave) and
        ``.json`` hold, for other programs, ``M``, ``C`` and ``K`` of the coordinates named in
        ``coordinates``, the loads, the frequencies [rad/s] of the modes, and positions and axes of the
        interfaces. The file appears complete or not at all.

        Args:
            path: The file; one that exists is replaced.

        Returns:
            The path.

        Raises:
            ModelError: another ending, or the file cannot be written.
        """

@final
class DeformedSuperelement(DeformedSuperelementRecord):
    """A superelement of a scene with its deformation, at one state or along a motion.
    """
    def plot(
        self,
        path: str | Path | None = None,
        *,
        row: int = -1,
        color: str | None = None,
    ) -> Figure:
        """The deformed superelement as a Matplotlib figure, written to ``path`` if given.

        Args:
            path: Picture file; the ending says the format.
            row: Of the motion, the last one by default.
            color: ``"stress"`` of von Mises or ``"displacement"``; by default stress, where it is
                known.

        Raises:
            ModelError: no stress, or no picture file. ArgumentError: there is no such row or color.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """

@final
class ComponentMatrices(ComponentMatricesRecord):
    """Mass and stiffness of a component, read from files.
    """
    def reduce(
        self,
        interface: Mapping[str, object],
        *,
        nodes: Array | None = None,
        method: str = "craig_bampton",
        modes: int | None = None,
        rigid: str | Mapping[str, str] = "rbe2",
        at: Mapping[str, object] | None = None,
        frame_dofs: str | Sequence[str] | None = None,
        node_dofs: str | Sequence[str] | None = None,
        order: str = "node",
        supported: bool = False,
        C: object = None,
        damping: object = None,
        rayleigh: tuple[float, float] | None = None,
        loads: Mapping[str, object] | None = None,
        static_shapes: Sequence[str] = (),
        stress: object = None,
        stress_names: Sequence[str] | None = None,
        load_stresses: Mapping[str, object] | None = None,
        geometric: Mapping[str, object] | None = None,
        triangles: ArrayLike | None = None,
        lines: ArrayLike | None = None,
        make_free: bool = False,
    ) -> Superelement:
        """The component, reduced to its interfaces; as :func:`cardan.superelement.reduce`.

        Args:
            interface: Nodes by the names of interfaces, by the numbers that the files give them.
            nodes: Positions (n_nodes, 3) [m] where the files have none, nodes in rising numbers.
            method, modes, rigid, at, frame_dofs, node_dofs, order: As there.
            supported, C, damping, rayleigh, loads, static_shapes, stress, stress_names: As there.
            load_stresses, geometric, triangles, lines, make_free: As there.

        Raises:
            ModelError: no positions of nodes, or as there.
        """
