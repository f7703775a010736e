"""Which runs have derivatives, and their rows."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveError
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.solver_info import EVENT, FINISHED
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..simulation.discontinuities import jump_parameters
from ..simulation.run import Runner
from ..simulation.settings import Settings
from ..simulation.signals import Signals
from .jumps import EventInstant
from .unknowns import Unknowns


def exact_method(model: LoadedModel) -> str:
    """The method that ``"auto"`` stands for where a run is differentiated."""
    return "Radau" if model.manifest.absolute else "DOP853"


def refuse(model: LoadedModel, how: Settings, input_signals: Signals, unknowns: Unknowns) -> None:
    """Refuse what has no gradient.

    Args:
        model, how, input_signals: Of the run.
        unknowns: What it is differentiated by.

    Raises:
        ModelError: with the cure.
    """
    if how.method.name == "Rosenbrock":
        raise ModelError(
            "gradient: method 'Rosenbrock': the Jacobian stands in its steps, which would need "
            "second derivatives. Take Radau, which is for stiff models too"
        )
    if input_signals.functions:
        names = [model.inputs[k] for k in input_signals.functions]
        raise ModelError(
            f"gradient: input '{names[0]}' is a function, whose derivative is not known. Give it "
            "as (times, values), or write it into the scene as a force"
        )

    # the time of such a jump is no event: nothing would move it along
    listed = unknowns.names
    moving = [name for name in jump_parameters(model) if "p" in listed or name in listed]
    if moving:
        raise ModelError(
            f"gradient: parameter '{moving[0]}' decides when the model jumps, by a comparison of "
            "t, and such times are held. Name the parameters that you need without it, or write "
            "the jump as an event of the scene"
        )


def check_complete(motion: TrajectoryRecord, runner: Runner) -> None:
    """Refuse a motion that has no derivative.

    Raises:
        SolveError: it ended early, or passes more places where branches meet than are noted.
    """
    if motion.solver_info.status not in (FINISHED, EVENT):
        raise SolveError(f"gradient: the motion is not complete: {motion.message}")
    run = runner.record
    if run.passes and run.pass_count > run.pass_capacity:
        raise SolveError(
            f"gradient: the motion passes more than {run.pass_capacity} places where branches "
            "meet. Take a shorter one"
        )


def rows_of(motion: TrajectoryRecord, runner: Runner) -> Array:
    """Rows t, y, r, s, lam of a motion that has one at the end of every step.

    Multipliers are left 0: those of a state follow from it.
    """
    modes, lam = motion.event_log.s.reshape(len(motion.t), -1), (len(motion.t), runner.record.nlam)
    states = (motion.t[:, None], motion.x, motion.work_done, motion.r, modes, np.zeros(lam))
    return np.hstack(states)


def row_behind(t: Array, end: int, at: EventInstant) -> int:
    """The first row behind an event: the last one at its time, before row ``end``."""
    return int(np.searchsorted(t[:end], at.t, side="right")) - 1
