"""Messages for the status codes of the integrators."""

from __future__ import annotations

import math

import numpy as np

from ...runtime.models.finite_elements.elements import State
from ...runtime.models.finite_elements.massless import refusal
from ...runtime.models.named_rotations import is_bounded
from ...runtime.trajectory.solver_info import FINISHED
from . import run_record as abi
from .run import Runner
from .times import Span

HUGE = 1e100  # beyond this squares overflow before long


def explain(runner: Runner, answer: int, over: Span) -> tuple[str, str]:
    """Status and a sentence with time, coordinate and remedy.

    Args:
        runner: The run.
        answer: What the kernels said last.
        over: What was asked for.
    """
    if answer == abi.DONE:
        return FINISHED, "reached the end"
    at = f"at t = {runner.record.t:.6g} s of {over.end:g} s"
    who = _culprit(runner)
    if answer == abi.STOPPED or isinstance(runner.error, KeyboardInterrupt):
        return "interrupted", f"interrupted {at}; what was computed is kept"
    if answer == abi.TOO_SMALL:
        # the limit is the user's own, or the step controller shrank until time stood still
        longest = float(runner.record.max_step)
        if longest <= np.spacing(abs(over.end)):
            why = f"max_step={longest:g} s does not change the time"
            return "step_too_small", f"stopped {at}: {why}"
        return "step_too_small", (
            f"stopped {at}: no step is small enough to keep the error{who} within the tolerance. "
            f"{_rotation(runner)}The motion is singular there, or rtol and atol are tighter than "
            "it can be computed"
        )
    if answer == abi.UNSOLVED:
        return "not_solved", (
            f"stopped {at}: the equations of a step of {abs(runner.record.h):g} s were not solved"
            f"{', at worst that' + who if who else ''}. {_rotation(runner)}Take step= or max_step= "
            "shorter; or the motion is singular there"
        )
    if answer == abi.ROTATION_TOO_LARGE:
        return "step_too_long", (
            f"stopped {at}: a rotation in a step of {abs(runner.record.h):g} s is most of a turn, "
            "more than its increment can tell. Take step= shorter"
        )
    if answer == abi.ROTATION_UNRESOLVED:
        return "singular_rotation", (
            f"stopped {at}: a step of {abs(runner.record.h):g} s does not tell how "
            f"'{runner.model.coordinates[runner.record.culprit]}' turns. {_rotation(runner)}"
            "Otherwise take step= shorter, or a method that chooses its steps"
        )
    if answer in (abi.EVENT, abi.EVENT_LIMIT, abi.CHATTER):
        return _event(runner, answer, at)
    if answer == abi.CONSTRAINT_OPEN:
        return "not_closed", f"stopped {at}: {_open(runner)}"
    if answer == abi.NOT_FINITE:
        return "not_finite", f"stopped {at}: {_not_finite(runner, who)}"
    if answer == abi.INPUT and runner.in_c is not None:
        return "function_failed", f"stopped {at}: {runner.in_c.failure()}"
    if answer == abi.SIZE:
        return "too_large", (
            f"not begun: {runner.n} numbers and their output rows are more than memory can address"
        )
    status = runner.record.model_status
    return "model_failed", (
        f"stopped {at}: the equations have no solution (status {status}). {_masses(runner)}"
    )


def _masses(runner: Runner) -> str:
    """Names of massless directions."""
    model, views = runner.model, runner.views
    if not model.manifest.absolute:
        return "The mass matrix is singular there: look at the state motion.x[-1]"
    q, u = model.split(views["y"][: model.nx])[:2]
    at = State(q, u, t=float(runner.record.t), r=views["r"])
    mesh = model._source.results(model).mesh  # type: ignore[attr-defined]
    return refusal(mesh, at)


def _not_finite(runner: Runner, who: str) -> str:
    """Message about a number that is not finite, and possible reasons."""
    model = runner.model
    if runner.record.culprit >= runner.n:
        return f"what says when {_event_name(runner)} happens is not finite"
    for name, value in zip(model.inputs, runner.views["r"].tolist(), strict=True):
        if not math.isfinite(value):
            return f"input '{name}' is {value} there: its function must give finite numbers"
    names = (*model.coordinates, *model.speeds, *model.internals)
    state = runner.views["y"][: model.nx]
    k = int(np.abs(state).argmax())
    if abs(state[k]) > HUGE:
        return (
            f"the motion grows beyond all bounds, '{names[k]}' is {state[k]:.3g}. Something feeds "
            "it: motion.balance says where energy comes from"
        )
    long = "" if runner.settings.method.adaptive else ", or step= is too long"
    return (
        f"the derivative{who} is not finite. {_domain(runner)}{long}: look at the state "
        "motion.x[-1]"
    )


def _domain(runner: Runner) -> str:
    """Message about a function evaluated outside its domain."""
    rows = [joint.solved for joint in runner.model.manifest.joints]
    circuits = dict.fromkeys(f"'{row.loop}'" for row in rows if row)
    if not circuits:
        return f"{_rotation(runner)}A force or a rotation leaves its domain there"
    return (
        f"The loop that {' or '.join(circuits)} closes is at a dead point there, or cannot "
        "reach it; run through with constraints='multipliers'. Or a force leaves its domain"
    )


def _rotation(runner: Runner) -> str:
    """Message about a singular rotation, and a parametrization that is not; "" if none is."""
    model, k = runner.model, runner.record.culprit
    if not 0 <= k < len(model.coordinates):
        return ""
    owner = model.manifest.coordinates[k].joint
    joint = next((row for row in model.manifest.joints if row.name == owner), None)
    if joint is None or not is_bounded(joint):
        return ""
    return (
        f"Joint '{owner}' turns by rotation='{joint.rotation}' ({joint.domain}); "
        "rotation='quaternion' has no such limits. "
    )


def _open(runner: Runner) -> str:
    """Message about the loop that does not stay closed, with a remedy."""
    run, closing = runner.record, runner.closing
    level, name = closing.row(run.open_row)
    row = next(row for row in closing.rows if row.name == name)
    kind = "force" if row.switched else "constraint" if row.joint == name else "joint"
    who = f"motion is not defined here: {kind} '{row.joint}' ({level} of '{name}')"
    if run.steps == 0 and run.correction <= 1:
        return f"{who} cannot be closed from this start. model.assemble(...) finds one that can"
    if not runner.settings.method.adaptive:
        return f"{who} does not close after a step of {abs(run.h):g} s. Take step= shorter"
    driven = _driven(runner)
    if driven:
        return (
            f"{who} cannot stay closed. What is prescribed ({driven}) asks for more than the "
            "mechanism can follow from here: it is at a dead point, where branches meet or at "
            "the end of its range"
        )
    if run.correction > 1:
        return (
            f"{who} would jump to another branch however short the step is. The position is "
            "singular: model.singular_positions(...) finds such positions"
        )
    return f"{who} cannot stay closed. The mechanism is at a dead point or at the end of its range"


def _driven(runner: Runner) -> str:
    """Joints and constraints that time or inputs move, in words."""
    joints = [j.name for j in runner.model.manifest.joints if j.prescribed]
    written = [row.name for row in runner.closing.rows if row.name == row.joint]
    moved = [name for name in written if f"{name}.motion" in runner.sources]
    return ", ".join(f"'{name}'" for name in (*joints, *moved))


def _culprit(runner: Runner) -> str:
    """`` of 'elbow.u'``, or nothing when no entry is to blame."""
    k = runner.record.culprit
    model = runner.model
    names = (*model.coordinates, *model.speeds, *model.internals, *runner.sources)
    return f" of '{names[k]}'" if 0 <= k < len(names) else ""


def _event_name(runner: Runner) -> str:
    """The event that is to blame, with the element it happens to."""
    row = runner.event_table.rows[runner.record.culprit - runner.n]
    owner = f" of '{row['element']}'" if row["element"] and row["element"] != row["name"] else ""
    return f"'{row['name']}'{owner}"


def _event(runner: Runner, answer: int, at: str) -> tuple[str, str]:
    """A run that events ended."""
    what = _event_name(runner)
    if answer == abi.EVENT:
        return "event", f"ended {at} by {what}"
    if answer == abi.EVENT_LIMIT:
        return "event_storm", (
            f"stopped {at}: {what} happens again and again at this one time: what it changes does "
            "not end what causes it"
        )
    # steps longer than a vibration go on through a stop at once
    shorter = "" if runner.settings.method.adaptive else "take step= shorter, "
    return "chatter", (
        f"stopped {at}: {what} happens ever again within no time to speak of, such as the last "
        "bounces of a ball that comes to rest. Let it stick below a speed (Stop: settle=), let "
        "when= of a latch be positive while release= is negative (Lock), "
        f"{shorter}take a smooth law (Friction: smooth=), or end the run there with events="
    )
