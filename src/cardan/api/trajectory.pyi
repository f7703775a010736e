"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, final

from matplotlib.figure import Figure

from ..analyses.mechanisms.screw_axis import ScrewAxis
from ..arguments import Count
from ..runtime.models.finite_elements.beams import BeamStress
from ..runtime.trajectory.cables import CableTension
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..view.page import Page
from .components import DeformedSuperelement
from .results import Torques

@final
class Trajectory(TrajectoryRecord):
    """Motion of a model over time, as :meth:`CompiledModel.simulate` returns it.

    ``motion["elbow"]`` is the history of a coordinate, ``motion["elbow.u"]`` of a speed,
    ``motion["base"]`` of all coordinates of a joint; outputs and inputs by their names.
    """
    def beam(
        self,
        name: str,
    ) -> BeamStress:
        """Forces, moments and strains (nt, 2 n, 3) along a beam, in axes of the section.
        """
    def superelement(
        self,
        name: str,
    ) -> DeformedSuperelement:
        """A superelement with its deformation (nt, ...): points of its surface and their stress.

        Args:
            name: Of the superelement.

        Raises:
            ModelError: there is no such superelement, or the file of the run does not hold it.
        """
    def cable(
        self,
        name: str,
    ) -> CableTension:
        """Tension along a cable at all times (nt, n).

        Args:
            name: Of the cable.

        Raises:
            ArgumentError: there is no such cable.
        """
    def screw_axis(
        self,
        frame: str,
    ) -> ScrewAxis:
        """Instantaneous screw axis of a body or frame at all times.

        Args:
            frame: Name of the frame or body.

        Returns:
            The axis at every time (nt).

        Raises:
            ModelError: there is no such frame, or the motion was read from a file without its model.
        """
    def torques(
        self,
        *,
        actuators: Sequence[str] | None = None,
        norm: Any = "minimum",
        inputs: Mapping[str, float] | None = None,
        cutoff: float | None = None,
        period: float | None = None,
        harmonics: Count = 5,
    ) -> Torques:
        """Forces that actuators add to make this motion, as :meth:`CompiledModel.torques` has them.
        """
    def to_xarray(
        self,
    ) -> Any:
        """An ``xarray.Dataset`` with named coordinates, speeds, inputs and energies.

        Raises:
            ModuleNotFoundError: xarray is not installed (extra ``data``).
        """
    def to_pandas(
        self,
    ) -> Any:
        """A ``pandas.DataFrame``: a row for every time, a column for every history.

        Columns are coordinates, speeds, inputs, internal states, modes and outputs, by the names that
        ``motion[name]`` takes. The index is the time ``t`` [s]; at an event two rows may have one time.
        ``frame.attrs["units"]`` has the unit of every column, and of ``t``; ``frame.attrs`` also says
        model, method and status.

        Raises:
            ModuleNotFoundError: pandas is not installed (extra ``data``).
        """
    def save(
        self,
        path: str | Path,
    ) -> Path:
        """Write the motion; the ending of the name says the format.

        ``.nc`` (netCDF) and ``.npz`` (NumPy archive) hold everything but the model, and are read by
        :func:`cardan.load_motion`. For other programs: ``.csv`` (a table of what changes over time,
        with units), ``.mat`` (MATLAB, Octave), ``.json``, ``.nc4`` (netCDF-4), ``.glb`` (animated
        glTF) and ``.mcap`` (Foxglove, PlotJuggler); ``docs/exchange.md`` says what is in each. The file
        appears complete or not at all.

        Args:
            path: The file.

        Returns:
            Its path.

        Raises:
            ModelError: the ending of another format, a variable too large for the format, places that
                are not finite, or a file that cannot be written.
            ModuleNotFoundError: a package that the format needs is not installed; the message names the
                extra.
        """
    def plot(
        self,
        path: str | Path | None = None,
        names: Iterable[str] | None = None,
    ) -> Figure:
        """Histories over time as a Matplotlib figure, written to ``path`` if given.

        Args:
            path: Picture file; the ending says the format.
            names: What to draw, such as ``["elbow", "elbow.u"]``; all coordinates, all speeds and the
                energies by default.

        Raises:
            ModelError: unknown names, no picture file. ModuleNotFoundError: no Matplotlib.
        """
    def animate(
        self,
        path: str | Path | None = None,
        *,
        show: str | Sequence[str] | None = None,
        plots: str | Sequence[str] | None = None,
        follow: str | None = None,
        traces: str | Sequence[str] = (),
        meshes: str | float | bool = "auto",
        page: str = "3d",
        fps: float = 60.0,
        title: str | None = None,
    ) -> Page:
        """A self-contained page that plays the motion in any browser.

        Without a path, a notebook shows the page in place; elsewhere it is opened in the browser.

        Args:
            path: HTML file. It appears complete or not at all.
            show: What shows from the start, of ``"reactions"``, ``"forces"``, ``"contacts"``,
                ``"frames"``, ``"springs"``, ``"stress"``, ``"strain"``, ``"displacement"`` and
                ``"floor"``. Reactions are computed only if they are named; the page can hide each.
                Beams and superelements are colored by stress where it is known, of von Mises in
                superelements; ``"strain"`` colors beams, ``"displacement"`` superelements.
            plots: Names of histories below the picture, as ``motion[name]``, and ``"energy"``; by
                default energies, coordinates and outputs.
            follow: Body, superelement or frame that the camera goes with.
            traces: Frames whose paths are drawn.
            meshes: ``"auto"`` reduces meshes to 200,000 triangles, ``"full"`` keeps all, a
                number from 0 to 1 that share of them; False draws links.
            page: ``"3d"``, or ``"plain"``: drawn on a 2-D canvas, for browsers without WebGL.
            fps: Pictures per second of play; long motions get fewer.
            title: Headline, the name of the model by default.

        Returns:
            The page; ``.path`` is its file.

        Raises:
            ModelError: a motion without poses or with places that are not finite, or a file that
                cannot be written. ArgumentError: an unknown layer, body or kind of page.
        """
