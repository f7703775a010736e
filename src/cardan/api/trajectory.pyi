"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, final

from matplotlib.figure import Figure

from ..arguments import Count
from ..runtime.models.finite_elements.beams import BeamStress
from ..runtime.trajectory.trajectory import TrajectoryRecord
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
    def save(
        self,
        path: str | Path,
    ) -> Path:
        """Write everything but the model; :func:`cardan.load_motion` reads it.

        The ending says the format: .nc (netCDF), .npz (NumPy archive), .csv (a table of what changes
        over time) or .mat (MATLAB); the last two are not read again. The file appears complete or not
        at all.

        Returns:
            Its path.

        Raises:
            ModelError: a variable too large for the format, the ending of another format, or a file
                that cannot be written.
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
        path: str | Path,
        *,
        fps: float = 60.0,
        title: str | None = None,
    ) -> Path:
        """Write one self-contained page that plays the motion in any browser.

        Args:
            path: HTML file. It appears complete or not at all.
            fps: Pictures per second of motion; long motions get fewer.
            title: Headline, the name of the model by default.

        Returns:
            The file.

        Raises:
            ModelError: a motion without poses, or the file cannot be written.
        """
