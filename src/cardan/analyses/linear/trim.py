"""Trim: inputs, parameters, forces and speeds with which a required steady motion holds.

Unknowns are independent increments and speeds, internal states and what is free. Accelerations
along the independent speeds, rates of internal states and the targets less their values are 0;
speeds that are neither targets nor free stay as they were given. Newton's method takes the first-
order equations of the motion that is reached for its matrix, and steps of least size where values
are left open. A motion is steady where its accelerations do not change as it goes on.

Source: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation (2016), section
3.6 (trim); J. E. Marsden, Lectures on Mechanics (1992), chapter 5 (relative equilibria).
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import checked
from ...arrays import Array
from ...errors import ModelError, SolveError, SolveWarning, counted, warn
from ..statics.equilibrium import equilibrium
from ..systems import dynamic_system_of
from ..systems.joint_system import JointSystem
from .steady_motion import SteadyMotionRecord
from .trim_arguments import trimming
from .trim_problem import Guess, Trimming

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

TIGHT = 1e-11  # steps without units that end the search
MET = 1e-9  # of what a unit step changes: conditions that hold
NEWTON, HALVINGS = 60, 14
OPEN = 1e-9  # singular values, of the largest, of directions in which nothing changes
FREE_PART = 1e-6  # of a direction: parts in what is free
STEADY = 1e-8  # of the rates at which accelerations change
AGAIN = 4  # speeds that are set to 0 one after the other


@checked
def trim(
    model: LoadedModel,
    targets: Mapping[str, float] | None = None,
    *,
    free: Iterable[str] = (),
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    u: Mapping[str, ArrayLike] | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    check: bool = False,
) -> SteadyMotionRecord:
    """A steady motion, or a rest, with target values, and what it takes.

    Args:
        model: The compiled model, in relative coordinates.
        targets: Coordinates, speeds and outputs by name -> the value they are to have.
        free: What may change for that: inputs, parameters, speeds (``"spin.u"``), and forces along
            speeds (``"elbow.driving_force"``). Coordinates are free anyway.
        q: Coordinates to start from, by name or (nq,).
        u: Speeds by name, as they stay, or start where they are free; others are 0 or follow.
        inputs, parameters: Values by name, as they stay, or start where they are free.
        t: Time [s], where something is prescribed.
        check: Raise where there is none, instead of warning.

    Returns:
        The motion; where none was found what the search reached, ``converged`` False.

    Raises:
        ModelError: unknown names, loops that cannot be assembled, beams.
        SolveError: with ``check``, there is none, or free values are left over.
    """
    system = dynamic_system_of(model)
    if not isinstance(system, JointSystem):
        raise ModelError(
            f"trim (targets=, free=): '{model.name}' has coordinates='absolute'. Its steady "
            "motions: model.equilibrium(u={'...': speed}, locked={'...': 0}) tells the force in "
            "holding"
        )
    problem = trimming(system, targets, free, u, inputs, parameters, t)
    problem, guess, spent, met, moving = _from(problem, q)
    if not met and (equilibrium_q := _equilibrium_position(model, problem, q)) is not None:
        # forces of what is wanted lead further than the first guess of what is free
        other = _from(problem, equilibrium_q)
        if other[3]:
            problem, guess, spent, met, moving = other
    message = _said(problem, guess, met, moving)
    steady = _record(problem, guess, spent, message, targets or {})
    if not steady.converged:
        if check:
            raise SolveError(steady.message)
        warn(steady.message, SolveWarning)
    return steady


def _from(problem: Trimming, q: object) -> tuple[Trimming, Guess, int, bool, str]:
    """The search from a position: the problem it ended with, where, after how many steps, whether
    conditions hold, and the speed with which accelerations change; "" if none do."""
    for _ in range(AGAIN):
        guess = problem.begin(q)
        problem = problem.searching(guess)
        guess, spent, met = _search(problem, guess)
        moving = problem.unsteady(guess, STEADY) if met else ""
        if not moving or problem.settled(moving):
            break
        problem = problem.with_zero_speed(moving)
    return problem, guess, spent, met, moving


def _equilibrium_position(model: LoadedModel, problem: Trimming, q: Any) -> Array | None:
    """The position in which forces hold wanted coordinates; None where there is none."""
    places = problem.system.speeds
    locked = {name: value for name, value in problem.targets.items() if f"{name}.u" in places}
    inputs = dict(zip(problem.system.inputs, problem.r.tolist(), strict=True))
    arguments: dict[str, Any] = {
        "locked": locked,
        "inputs": inputs,
        "parameters": dict(problem.base),
    }
    if problem.fixed_speeds:
        arguments["u"] = dict(problem.fixed_speeds)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SolveWarning)
            equilibrium_record = equilibrium(model, q=q, t=problem.t, **arguments)
    except (ModelError, SolveError):
        return None
    return equilibrium_record.q if equilibrium_record.converged else None


def _search(problem: Trimming, guess: Guess) -> tuple[Guess, int, bool]:
    """Newton's method: where it ended, how many steps that took, whether the conditions hold."""
    reach, met = problem.system.reach, False
    for k in range(1, NEWTON + 1):
        J, miss = problem.matrix(guess), problem.miss(guess)
        unit = _units(J)
        step = np.asarray(-np.linalg.lstsq(J / unit[:, None], miss / unit, rcond=OPEN)[0], float)
        size = float(np.abs(step).max(initial=0.0))
        share = min(1.0, reach / max(size, 1e-300))
        met = bool(np.all(np.abs(miss) <= MET * unit))
        if size <= TIGHT:
            return guess, k, met
        guess, shortened = _moved(problem, guess, step, share, unit)
        if shortened < 1e-3 and not met:
            return guess, k, False
    return guess, NEWTON, met


def _moved(
    problem: Trimming, guess: Guess, step: Array, share: float, unit: Array
) -> tuple[Guess, float]:
    """The guess after a step, shortened until conditions are missed by less."""
    before = float(np.linalg.norm(problem.miss(guess) / unit))
    shortened = guess
    for _ in range(HALVINGS):
        try:
            shortened = problem.moved(guess, share * step)
            after = float(np.linalg.norm(problem.miss(shortened) / unit))
        except (SolveError, ModelError):
            after = np.inf
        if after <= max((1 - 1e-3 * share) * before, 1e-12):
            return shortened, share
        share *= 0.5
    return guess, 0.0


def _units(J: Array) -> Array:
    """Change of every condition by a unit step."""
    size = np.abs(J).max(axis=1, initial=0.0)
    largest = float(size.max(initial=1e-300))
    return np.asarray(np.where(size > OPEN * largest, size, largest))


def _open(problem: Trimming, guess: Guess) -> Array:
    """Directions (k, n) of the unknowns in which no condition changes."""
    J = problem.matrix(guess)
    _, sizes, V = np.linalg.svd(J / _units(J)[:, None])
    rank = int(np.sum(sizes > OPEN * sizes.max(initial=0.0)))
    return np.asarray(V[rank:])


def _ran_away(problem: Trimming, guess: Guess) -> bool:
    """True when forces grew until what is wanted counts for nothing beside them."""
    size = np.abs(problem.matrix(guess)).max(axis=1, initial=0.0)
    wishes = size[problem.wishes(guess)]
    return bool(np.any((wishes > 0) & (wishes <= OPEN * size.max(initial=0.0))))


def _said(problem: Trimming, guess: Guess, met: bool, moving: str) -> str:
    """Why it is not a steady motion, or "" where it is one."""
    if not met:
        miss, J = problem.miss(guess), problem.matrix(guess)
        worst = int(np.abs(miss / _units(J)).argmax())
        return f"no steady motion: {problem.complaint(guess, worst, float(miss[worst]))}"
    if moving:
        return (
            f"no steady motion: as '{moving}' goes on, accelerations change (weight across the "
            "axis, a speed that would have to be 0?). Give other speeds, or simulate it"
        )
    surplus = problem.left_over(guess, _open(problem, guess))
    names = [name for name, size in surplus.items() if size > FREE_PART]
    if names and _ran_away(problem, guess):
        values = problem.values(guess)
        said = ", ".join(f"'{name}' = {values.get(name, 0.0):.3g}" for name in names)
        return (
            f"no steady motion: {said} and still growing where the search ended: it hardly acts "
            f"there. {problem.cure()}"
        )
    if names:
        said = " and ".join(f"'{name}'" for name in names)
        return (
            f"left over: {said} may have other values too, and the motion is wanted as it is. "
            "Leave out of free= what is not needed, or want more"
        )
    return ""


def _record(
    problem: Trimming, guess: Guess, spent: int, message: str, requested: Mapping[str, float]
) -> SteadyMotionRecord:
    """The result as users see it."""
    moving = bool(np.abs(guess.at.u).max(initial=0.0) > 0)
    kind = f"{'steady motion' if moving else 'rest'}, after {counted(spent, 'iteration')}"
    free_motions = (
        problem.free_motions(guess, _open(problem, guess), FREE_PART) if not message else ()
    )
    at = guess.at
    return SteadyMotionRecord(
        model=problem.model(guess),
        x=np.concatenate([at.q, at.u, at.z]),
        free=problem.values(guess),
        targets={name: float(value) for name, value in requested.items()},
        inputs=dict(zip(problem.system.inputs, at.r.tolist(), strict=True)),
        t=at.t,
        free_motions=free_motions,
        iterations=spent,
        converged=not message,
        message=message or kind,
        trim_arguments=_restart_arguments(problem, guess, requested),
        at=at,
        tau=guess.tau,
        choice=problem.first(guess).choice,
    )


def _restart_arguments(
    problem: Trimming, guess: Guess, requested: Mapping[str, float]
) -> dict[str, Any]:
    """Arguments that repeat the trim from its solution."""
    system, values = problem.system, problem.values(guess)
    speeds = {name: value for name, value in values.items() if name in system.speeds}
    return {
        "targets": {name: float(value) for name, value in requested.items()},
        "free": list(problem.kinds),
        "q": guess.at.q,
        "u": {**problem.fixed_speeds, **speeds},
        "inputs": dict(zip(system.inputs, guess.at.r.tolist(), strict=True)),
        "t": guess.at.t,
    }
