"""Results of analyses as users hold them: records with verbs."""

from __future__ import annotations

from typing import final, overload

from ..analyses.continuation.record import ContinuationRecord, Solution
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
from ..analyses.simulation.precision.work_precision import PrecisionRecord
from ..analyses.statics.equilibrium import EquilibriumRecord
from ..analyses.statics.static_path import StaticPathRecord
from ..arrays import Array
from .faces import attribute, face, maker, verb


@final
class Continuation(ContinuationRecord):
    """Equilibria, positions or cycles along a path, and branches that leave it."""

    animate = verb("cardan.analyses.snapshots:animate")
    explain = verb("cardan.explain.continuation:explain")
    plot = verb("cardan.analyses.continuation.diagram:plot")
    report = verb("cardan.analyses.simulation.precision.path_report:report")
    save = verb("cardan.analyses.continuation.path_file:save")
    table = verb("cardan.analyses.continuation.path_file:table")

    @overload
    def __getitem__(self, name: str) -> Array: ...
    @overload
    def __getitem__(self, name: int) -> Solution: ...
    def __getitem__(self, name: str | int) -> Solution:
        """The solution of a row of the main branch, or a history (n,)."""
        return face(super().__getitem__(name))


@final
class Cycle(CycleRecord):
    """A motion that repeats, and how stable it is."""

    animate = verb("cardan.analyses.cycles.cycle_pictures:animate")
    motion = attribute("cardan.analyses.cycles.cycle_pictures:motion", once=True)
    plot = verb("cardan.analyses.cycles.cycle_pictures:plot")


@final
class Ensemble(EnsembleRecord):
    """Results of an ensemble."""

    join = maker("cardan.analyses.ensembles.joining:join")
    run = verb("cardan.analyses.ensembles.result:run")
    to_xarray = verb("cardan.analyses.ensembles.ensemble_file:to_xarray")
    save = verb("cardan.analyses.ensembles.ensemble_file:save")


@final
class Excitation(ExcitationRecord):
    """A motion that excites base parameters."""

    plot = verb("cardan.analyses.identification.excitation:plot")


@final
class Fit(FitRecord):
    """Parameters and a start fitted to measured motions."""

    plot = verb("cardan.analyses.fits.picture:plot")


@final
class Identification(IdentificationRecord):
    """Estimates of base parameters, and the model with them."""

    plot = verb("cardan.analyses.identification.result:plot")


@final
class Torques(TorquesRecord):
    """Forces of actuators along a motion."""

    plot = verb("cardan.analyses.identification.torques:plot")


@final
class Campbell(CampbellRecord):
    """Frequencies of a rotor over its speed."""

    plot = verb("cardan.analyses.linear.campbell:plot")


@final
class LinearModel(LinearModelRecord):
    """x' = A x + B r, y = C x + D r, with names."""

    plot = verb("cardan.analyses.linear.linear_model:plot")
    save = verb("cardan.analyses.linear.linear_file:save")


@final
class Modes(ModesRecord):
    """Modes of vibration."""

    motion = verb("cardan.analyses.linear.mode_shapes:motion")
    animate = verb("cardan.analyses.linear.mode_shapes:animate")
    plot = verb("cardan.analyses.linear.mode_shapes:plot")


@final
class Locus(LocusRecord):
    """Eigenvalues of a family of linear models."""

    plot = verb("cardan.analyses.linear.root_locus:plot")


@final
class SteadyMotion(SteadyMotionRecord):
    """A steady motion with requested values, or a rest."""

    linear = attribute("cardan.analyses.linear.linearize:about", once=True)

    @property
    def stable(self) -> bool:
        """True when no small motion about it grows exponentially."""
        return bool(self.linear.stable)


@final
class Assembly(AssemblyRecord):
    """A position at which all loops close."""

    animate = verb("cardan.analyses.snapshots:animate")


@final
class Sweep(SweepRecord):
    """Positions of a mechanism over values of its drivers."""

    animate = verb("cardan.analyses.snapshots:animate")
    plot = verb("cardan.analyses.mechanisms.sweep:plot")


@final
class Workspace(WorkspaceRecord):
    """Positions that a frame reaches."""

    plot = verb("cardan.analyses.mechanisms.workspace:plot")


@final
class Precision(PrecisionRecord):
    """Speed against error of every integrator on a motion."""

    plot = verb("cardan.analyses.simulation.precision.work_precision:plot")


@final
class Equilibrium(EquilibriumRecord):
    """A position at which a system rests, or moves steadily."""

    animate = verb("cardan.analyses.snapshots:animate")


@final
class StaticPath(StaticPathRecord):
    """Equilibria of a load path."""

    animate = verb("cardan.analyses.snapshots:animate")
    plot = verb("cardan.analyses.statics.static_path:plot")
