"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, final

from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from ..analyses.continuation.record import ContinuationRecord
from ..analyses.cycles.cycle_record import CycleRecord
from ..analyses.ensembles.result import EnsembleRecord
from ..analyses.fits.record import FitRecord
from ..analyses.identification.excitation import ExcitationRecord
from ..analyses.identification.result import IdentificationRecord
from ..analyses.identification.torques import TorquesRecord
from ..analyses.linear.campbell import CampbellRecord
from ..analyses.linear.linear_model import LinearModelRecord
from ..analyses.linear.mode_shapes import ModesRecord
from ..analyses.linear.root_locus import LocusRecord
from ..analyses.linear.steady_motion import SteadyMotionRecord
from ..analyses.mechanisms.assembly import AssemblyRecord
from ..analyses.mechanisms.sweep import SweepRecord
from ..analyses.mechanisms.workspace import WorkspaceRecord
from ..analyses.simulation.precision.path_report import PathReport
from ..analyses.simulation.precision.work_precision import PrecisionRecord
from ..analyses.statics.equilibrium import EquilibriumRecord
from ..analyses.statics.static_path import StaticPathRecord
from ..arguments import Count
from ..arrays import Array
from ..view.page import Page
from .trajectory import Trajectory

@final
class Continuation(ContinuationRecord):
    """Equilibria, positions or cycles along a path, and branches that leave it.
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
        title: str | None = None,
        branch: str = "main",
    ) -> Page:
        """A self-contained page of the positions, over the load or the driver where there are several.

        Args:
            branch: Of a continuation: the name of a branch.
            path, show, follow, traces, meshes, page, title: As :meth:`.Trajectory.animate`.
            plots: Names of histories below the picture, as ``result[name]``.

        Returns:
            The page; ``.path`` is its file. Without a path it is opened, or shown in a notebook.

        Raises:
            ModelError, ArgumentError: as :meth:`.Trajectory.animate`; or there are no positions, or
                histories of a single one.
        """
    def explain(
        self,
        file: str | Path,
        along: str | None = None,
        up: str | None = None,
    ) -> Path:
        """Write a page on a path: its equations, steps, branches, special points and stability.

        Args:
            file: Its ending says how: ``.html``, ``.tex`` or ``.md``.
            along, up: Names of the histories on the axes of the diagram, as for ``plot``; what is swept
                and what moves most by default.

        Returns:
            The file.

        Raises:
            DerivationError: another ending. ModelError: unknown names.
        """
    def plot(
        self,
        along: str,
        up: str,
        file: str | Path | None = None,
    ) -> Figure:
        """Draw a path and its branches as a Matplotlib figure, written to ``file`` if given.

        Unstable solutions are thin and dashed, all else are lines; special points carry their names.

        Args:
            along, up: Names of the histories on the axes, such as ``"P"`` and ``"elbow"``.
            file: Picture file; the ending says the format.

        Raises:
            ModelError: unknown names, or a file that is not a picture.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """
    def report(
        self,
    ) -> PathReport:
        """Measure a path: what every branch took and what its points miss; prints a table.

        Residuals are computed anew from the coordinates, forces and loads of every point, special ones
        among them: of equilibria by a system of its own for the parameters there, of positions over all
        conditions of the loops, of cycles by laps of another method. Times are of the following alone.
        """
    def save(
        self,
        file: str | Path,
    ) -> Path:
        """Write all branches and their special points; the ending says the format.

        .nc (netCDF), .npz (NumPy archive), .csv (a table with a row for every point of every branch)
        or .mat (MATLAB). The file appears complete or not at all; it is for other programs.

        Returns:
            Its path.

        Raises:
            ModelError: a file that cannot be written, or of another format.
        """
    def table(
        self,
    ) -> dict[str, Array]:
        """Columns (n,) over the points of all branches, one branch after the other.

        What is swept, coordinates, outputs, of cycles ``period`` and ``multiplier`` (the largest
        modulus), ``stable`` and ``stable_held`` (1, 0, or -1 where they are not known), and ``branch``,
        the number of the branch in ``path.branches``.
        """

@final
class Cycle(CycleRecord):
    """A motion that repeats, and how stable it is.
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
        """A self-contained page that plays a period of the motion in any browser.

        Args:
            path, show, plots, follow, traces, meshes, page, fps, title: As
                :meth:`.Trajectory.animate`.

        Returns:
            The page; ``.path`` is its file. Without a path it is opened, or shown in a notebook.

        Raises:
            ModelError, ArgumentError: as :meth:`.Trajectory.animate`.
        """
    @property
    def motion(
        self,
    ) -> Trajectory:
        """The motion over a period; with a symmetry over one lap.
        """
    def plot(
        self,
        path: str | Path | None = None,
        names: Iterable[str] | None = None,
        *,
        against: str | None = None,
    ) -> Figure:
        """The motion over a period as a Matplotlib figure, written to ``path`` if given.

        ``cycle.plot("orbit.png", "elbow.u", against="elbow")`` is the orbit in the state space.

        Args:
            path: Picture file; the ending says the format.
            names: What to draw, such as ``["elbow", "elbow.u"]``; by default all coordinates, all
                speeds and the energies over time, against another one all speeds.
            against: What is along the horizontal axis, such as ``"elbow"``; the time by default.

        Raises:
            ModelError: unknown names, no picture file. ModuleNotFoundError: no Matplotlib.
        """

@final
class Ensemble(EnsembleRecord):
    """Results of an ensemble.
    """
    @staticmethod
    def join(
        parts: str | Path | Sequence[str | Path | Ensemble],
        *,
        check: bool = False,
    ) -> Ensemble:
        """One ensemble of all its parts, with the bits of ``model.ensemble`` of all runs at once.

        Args:
            parts: A pattern of the files that ``checkpoint=`` named, such as ``"runs-*.part"``; or a
                list of files and of ensembles that ``part=`` made. Nothing in a file is ever executed.
            check: Raise where a run failed.

        Returns:
            Last states, status and reductions of all runs. ``run(i)`` needs the model, which no file
            holds: it is there where one of the parts is an ensemble of this process.

        Raises:
            ModelError: no such files; a part that is missing, there twice, not finished, damaged or of
                another ensemble. SolveError: a run that failed, with ``check``.
        """
    def run(
        self,
        i: int,
        times: Sequence[float] | None = None,
    ) -> Trajectory:
        """One run again, with everything between its steps: the same bits, as a motion.

        Args:
            i: Its number; negative ones count from the end.
            times: Output times instead [s].

        Raises:
            ArgumentError: there is no such run. ModelError: the ensemble comes from a file.
        """
    def to_xarray(
        self,
    ) -> Any:
        """Data set with the dimensions run, entry, time; names have _ for blanks.

        Entries of states are labeled by name, ``status`` is text; the attribute ``name`` of a variable
        is its name here.

        Raises:
            ModuleNotFoundError: xarray is missing.
        """
    def save(
        self,
        path: str | Path,
    ) -> Path:
        """Write everything but the model; :func:`cardan.load_ensemble` reads it.

        The ending says the format: .nc (netCDF), .npz (NumPy archive), .csv (a table with a row for
        every run) or .mat (MATLAB); the last two are not read again. The file appears complete or not
        at all.

        Returns:
            Its path.

        Raises:
            ModelError: a variable too large for the format, or a file that cannot be written.
        """

@final
class Excitation(ExcitationRecord):
    """A motion that excites base parameters.
    """
    def plot(
        self,
        path: str | Path | None = None,
    ) -> Figure:
        """Positions and speeds over a period as a Matplotlib figure, written to ``path``.
        """

@final
class Fit(FitRecord):
    """Parameters and a start fitted to measured motions.
    """
    def plot(
        self,
        path: str | Path | None = None,
    ) -> Figure:
        """Measured samples over the fitted motion, and residuals beside them, as a Matplotlib figure.

        Args:
            path: Picture file; the ending says the format.

        Raises:
            ModelError: no picture file. ModuleNotFoundError: no Matplotlib.
        """

@final
class Identification(IdentificationRecord):
    """Estimates of base parameters, and the model with them.
    """
    def plot(
        self,
        path: str | Path | None = None,
    ) -> Figure:
        """Measured and estimated histories as a Matplotlib figure, written to ``path`` if given.
        """

@final
class Torques(TorquesRecord):
    """Forces of actuators along a motion.
    """
    def plot(
        self,
        path: str | Path | None = None,
    ) -> Figure:
        """Forces and powers as a Matplotlib figure, written to ``path`` if given.
        """

@final
class Campbell(CampbellRecord):
    """Frequencies of a rotor over its speed.
    """
    def plot(
        self,
        path: str | Path | None = None,
        orders: Sequence[int] = (1,),
    ) -> Any:
        """The diagram as a Matplotlib figure, written to ``path`` if given.

        Args:
            path: Picture file, or None.
            orders: Multiples of the speed that are drawn, with the critical speeds.

        Raises:
            ModelError: a path that is not a picture file.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """

@final
class LinearModel(LinearModelRecord):
    """x' = A x + B r, y = C x + D r, with names.
    """
    def plot(
        self,
        path: str | Path | None = None,
        omega: ArrayLike | None = None,
        inputs: Iterable[str] | None = None,
        outputs: Iterable[str] | None = None,
    ) -> Figure:
        """Sizes and phases of the frequency response (Bode) as a Matplotlib figure.

        Args:
            path: Picture file, or None.
            omega: Angular frequencies (n,) [rad/s]; a decade around the eigenvalues if left out.
            inputs, outputs: Of which; all if left out.

        Raises:
            ModelError: unknown names, nothing to draw, or a path that is not a picture file.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """
    def save(
        self,
        path: str | Path,
    ) -> Path:
        """Write A, B, C, D with names and units; the ending of the name says the format.

        ``.npz`` (NumPy archive) and ``.nc`` (netCDF) are read by :func:`cardan.load_linear`; ``.mat``
        (MATLAB, Octave), ``.json`` and ``.nc4`` are for other programs. Names stand in ``states``,
        ``inputs``, ``outputs``, their units in ``state_units`` and so on; ``mass`` is that of the
        independent speeds, ``x`` the state of the whole model about which it stands. The file appears
        complete or not at all.

        Args:
            path: The file.

        Returns:
            Its path.

        Raises:
            ModelError: the ending of another format, or a file that cannot be written.
            ModuleNotFoundError: a package that the format needs is not installed.
        """

@final
class Modes(ModesRecord):
    """Modes of vibration.
    """
    def motion(
        self,
        k: int,
        amplitude: float | None = None,
        periods: float = 2.0,
    ) -> Trajectory:
        """A mode as a motion, as large as is good to see, or by an amplitude.

        Args:
            k: Number of the mode, from 0.
            amplitude: Factor of the shape.
            periods: How often it is played; what does not oscillate takes a second.
        """
    def animate(
        self,
        k: int,
        path: str | Path | None = None,
        *,
        amplitude: float | None = None,
        periods: float = 2.0,
        show: str | Sequence[str] | None = (),
        plots: str | Sequence[str] | None = (),
        meshes: str | float | bool = "auto",
        page: str = "3d",
    ) -> Page:
        """A page that plays a mode in any browser; see :meth:`motion` for amplitude and periods.

        Args:
            path, show, plots, meshes, page: As :meth:`.Trajectory.animate`. By default no histories,
                and no stress: a shape as large as one can see it stretches beams, small ones do not.
        """
    def plot(
        self,
        path: str | Path | None = None,
        count: Count = 6,
    ) -> Figure:
        """Shapes of the first modes over the numbers of their entries as a Matplotlib figure.

        Raises:
            ModelError: a path that is not a picture file.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """

@final
class Locus(LocusRecord):
    """Eigenvalues of a family of linear models.
    """
    def plot(
        self,
        path: str | Path | None = None,
    ) -> Figure:
        """Loci in the complex plane, and real and imaginary parts over the first that changes.

        Args:
            path: Picture file, or None.

        Returns:
            The Matplotlib figure.

        Raises:
            ModelError: a path that is not a picture file.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """

@final
class SteadyMotion(SteadyMotionRecord):
    """A steady motion with requested values, or a rest.
    """
    @property
    def linear(
        self,
    ) -> LinearModel:
        """The linear model about it.
        """
    @property
    def stable(self) -> bool:
        """True when no small motion about it grows exponentially."""

@final
class Assembly(AssemblyRecord):
    """A position at which all loops close.
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
        title: str | None = None,
        branch: str = "main",
    ) -> Page:
        """A self-contained page of the positions, over the load or the driver where there are several.

        Args:
            branch: Of a continuation: the name of a branch.
            path, show, follow, traces, meshes, page, title: As :meth:`.Trajectory.animate`.
            plots: Names of histories below the picture, as ``result[name]``.

        Returns:
            The page; ``.path`` is its file. Without a path it is opened, or shown in a notebook.

        Raises:
            ModelError, ArgumentError: as :meth:`.Trajectory.animate`; or there are no positions, or
                histories of a single one.
        """

@final
class Sweep(SweepRecord):
    """Positions of a mechanism over values of its drivers.
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
        title: str | None = None,
        branch: str = "main",
    ) -> Page:
        """A self-contained page of the positions, over the load or the driver where there are several.

        Args:
            branch: Of a continuation: the name of a branch.
            path, show, follow, traces, meshes, page, title: As :meth:`.Trajectory.animate`.
            plots: Names of histories below the picture, as ``result[name]``.

        Returns:
            The page; ``.path`` is its file. Without a path it is opened, or shown in a notebook.

        Raises:
            ModelError, ArgumentError: as :meth:`.Trajectory.animate`; or there are no positions, or
                histories of a single one.
        """
    def plot(
        self,
        path: str | Path | None = None,
        names: Sequence[str] | None = None,
    ) -> Figure:
        """Histories over the driver as a Matplotlib figure, written to ``path`` if given.

        Raises:
            ModelError: unknown names, or a path that is not a picture file.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """

@final
class Workspace(WorkspaceRecord):
    """Positions that a frame reaches.
    """
    def plot(
        self,
        path: str | Path | None = None,
    ) -> Figure:
        """The places from three sides as a Matplotlib figure, written to ``path`` if given.

        Raises:
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """

@final
class Precision(PrecisionRecord):
    """Speed against error of every integrator on a motion.
    """
    def plot(
        self,
        path: str | Path | None = None,
    ) -> Any:
        """Draw time over error, a line per method.

        Args:
            path: Picture file, or None.

        Returns:
            The Matplotlib figure.

        Raises:
            ModuleNotFoundError: Matplotlib is not installed.
        """

@final
class Equilibrium(EquilibriumRecord):
    """A position at which a system rests, or moves steadily.
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
        title: str | None = None,
        branch: str = "main",
    ) -> Page:
        """A self-contained page of the positions, over the load or the driver where there are several.

        Args:
            branch: Of a continuation: the name of a branch.
            path, show, follow, traces, meshes, page, title: As :meth:`.Trajectory.animate`.
            plots: Names of histories below the picture, as ``result[name]``.

        Returns:
            The page; ``.path`` is its file. Without a path it is opened, or shown in a notebook.

        Raises:
            ModelError, ArgumentError: as :meth:`.Trajectory.animate`; or there are no positions, or
                histories of a single one.
        """

@final
class StaticPath(StaticPathRecord):
    """Equilibria of a load path.
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
        title: str | None = None,
        branch: str = "main",
    ) -> Page:
        """A self-contained page of the positions, over the load or the driver where there are several.

        Args:
            branch: Of a continuation: the name of a branch.
            path, show, follow, traces, meshes, page, title: As :meth:`.Trajectory.animate`.
            plots: Names of histories below the picture, as ``result[name]``.

        Returns:
            The page; ``.path`` is its file. Without a path it is opened, or shown in a notebook.

        Raises:
            ModelError, ArgumentError: as :meth:`.Trajectory.animate`; or there are no positions, or
                histories of a single one.
        """
    def plot(
        self,
        path: str | Path | None = None,
        names: Sequence[str] | None = None,
    ) -> Any:
        """Histories over the first swept value as a Matplotlib figure, written to ``path``.

        Raises:
            ModelError: unknown names, or a path that is not a picture file.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """
