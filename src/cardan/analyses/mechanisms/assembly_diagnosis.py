"""Why a mechanism cannot be assembled: what stays open, or what is inconsistent."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NoReturn, TypeVar

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...runtime.trajectory.closure_errors import residual_unit
from .branches import OFFSET, guess_advice
from .mechanism import Mechanism
from .position_solver import PositionSolver, Solution, missed
from .redundancy import rank_of
from .rounded_loops import ROUNDED
from .targets import Target

WEIGHTS = "Leave one out, or give weights= to what need not be met exactly"
T = TypeVar("T")
Search = Callable[[Mechanism, Sequence[Target]], list[Solution]]
NEAR = 1e-3  # residuals without units that rounding may explain
HALVINGS = 30  # of the way from what is reached to what is asked


def explain(
    m: Mechanism,
    targets: Sequence[Target],
    solutions: Sequence[Solution],
    again: Search,
    remedy: str = WEIGHTS,
    start: str = "start=",
) -> NoReturn:
    """Raise the error for searches of which none met what must hold.

    Args:
        m: The mechanism.
        targets: All of them.
        solutions: Where the searches ended.
        again: Searches for other targets, or without some relations.
        remedy: What to do about targets that cannot hold.
        start: The argument that says where searches begin.

    Raises:
        ModelError: always.
    """
    required = [target for target in targets if target.weight is None]
    bare = again(m, []) if required else solutions
    if not _any_met(bare):
        raise ModelError(_culprits(m, again) or _open(m, bare, start))
    conflict = _smallest(required, lambda some: _any_met(again(m, some)))
    remedy += _guessed(m, required, conflict, again)
    raise ModelError(_conflict(m, conflict, [*again(m, _wished(conflict)), *bare], remedy))


def _guessed(
    m: Mechanism, required: Sequence[Target], conflict: Sequence[Target], again: Search
) -> str:
    """How the last value that conflicts could be used as a guess instead; "" where it could not."""
    dropped = conflict[-1]
    for remaining in ([one for one in required if one is not dropped], conflict[:-1]):
        advice = guess_advice(m, remaining, dropped, again(m, remaining))
        if advice:
            return advice
    return ""


def _any_met(solutions: Sequence[Solution]) -> bool:
    return any(one.met for one in solutions)


def _smallest(required: Sequence[T], holds: Callable[[Sequence[T]], bool]) -> list[T]:
    """Smallest set of conditions that are inconsistent, any of which could without the
    others.
    """
    conflicting = list(required)
    for one in required:
        remaining = [other for other in conflicting if other is not one]
        if not holds(remaining):
            conflicting = remaining
    return conflicting


def _wished(targets: Sequence[Target]) -> list[Target]:
    """The same targets, none of which must be held."""
    return [replace(target, weight=1.0) for target in targets]


def _conflict(
    m: Mechanism, targets: Sequence[Target], solutions: Sequence[Solution], remedy: str
) -> str:
    """Message about the position found when all targets are only wished for."""

    def away(one: Solution) -> float:
        return float(np.sum(missed(m, targets, one.q) ** 2))

    ends = [replace(one, q=_unwrapped(m, one.q, targets)) for one in solutions if one.met]
    q = min(ends, key=away).q
    if len(targets) == 1 and targets[0].kind == "coordinate":
        q = _farthest(m, targets[0], q)
    said = [f"'{t.name}' (asked {t.description}; reached {actual_value(m, t, q)})" for t in targets]
    if len(said) == 1:
        return f"{said[0]} is out of reach{moment(m)}. {remedy}"
    return f"{', '.join(said[:-1])} and {said[-1]} are inconsistent{moment(m)}. {remedy}"


def actual_value(m: Mechanism, target: Target, q: Array) -> str:
    """Value that a position (nq,) gives instead of a target, in words."""
    if target.kind == "coordinate":
        numbers = [f"{x:.6g}" for x in q[target.place]]
        return numbers[0] if len(numbers) == 1 else f"({', '.join(numbers)})"
    away = missed(m, [target], q)
    numbers = [f"{np.linalg.norm(away[-3:]) * m.size:.3g} m"]
    if target.kind == "pose":
        numbers.append(f"{np.linalg.norm(away[:3]):.3g} rad")
    return f"{' and '.join(numbers)} away"


def _unwrapped(m: Mechanism, q: Array, targets: Sequence[Target]) -> Array:
    """The same position with angles as near to what is asked as whole turns bring them."""
    goal = q.copy()
    for target in targets:
        if target.kind == "coordinate":
            goal[target.place] = target.value
    return m.nearest(q, goal)


def _farthest(m: Mechanism, target: Target, q: Array) -> Array:
    """From a position as far towards what is asked as the mechanism goes."""
    part = 0.5
    for _ in range(HALVINGS):
        ahead = q[target.place] + part * (target.value - q[target.place])
        end = PositionSolver(m, [replace(target, value=ahead)]).search(q)
        q, part = (end.q, part) if end.met else (q, 0.5 * part)
    return q


def reversed_axis_message(joint: str) -> str:
    """Message about a joint that closes with an axis reversed."""
    return (
        f"joint '{joint}' closes its loop here only with an axis turned round, as it is not "
        "built: start nearer to the position that is meant, or turn the axis in the scene"
    )


def moment(m: Mechanism) -> str:
    """When and with what prescribed motions, in words; "" where time does not matter."""
    moved = [f"'{j.name}'" for j in m.model.manifest.joints if j.prescribed]
    if moved:
        return f" at t = {m.t:g} s, where the motion of {', '.join(moved)} is prescribed"
    return f" at t = {m.t:g} s" if m.t else ""


def _redundant(m: Mechanism, q: Array) -> bool:
    """True when conditions are redundant beside a position (nq,), where rounding can open them.

    Those of mechanisms such as Bricard's are so only where it closes: there are as many as speeds,
    though it moves.
    """
    aside = np.random.default_rng(0).uniform(-OFFSET, OFFSET, m.nu)
    G = m.jacobian(m.advance(q, aside))
    return len(G) >= m.nu or rank_of(np.linalg.svd(G, compute_uv=False)) < len(G)


def _culprits(m: Mechanism, again: Search) -> str:
    """Relations of the user without which everything else holds; "" where they do not matter."""
    relations = m.relations

    def holds(some: Sequence[str]) -> bool:
        return _any_met(again(m.without(set(relations) - set(some)), []))

    if not relations or not holds([]):
        return ""
    names = [f"'{name}'" for name in _smallest(relations, holds)]
    circuits = " with the loops" if m.cuts else ""
    if len(names) == 1:
        return (
            f"constraint {names[0]} is inconsistent{circuits}{moment(m)}: without it "
            "everything closes. Look at its expression, its numbers and signs"
        )
    return (
        f"constraints {', '.join(names[:-1])} and {names[-1]} are inconsistent{circuits}"
        f"{moment(m)}: without any one of them the others hold. Leave one out, or correct it"
    )


def _open(m: Mechanism, solutions: Sequence[Solution], start: str) -> str:
    """Message about the largest residual at the nearest position of the search."""
    if not m.closing.rows:
        return (
            f"beams of '{m.model.name}' do not fit without strain between the places that are "
            "named: name fewer coordinates"
        )

    def gap_of(one: Solution) -> float:
        return max(max(length / m.size, other) for length, other in m.gaps(one.q).values())

    # a position with a reversed axis closes the loop, but not the way the joint is drawn
    straight = [one for one in solutions if not m.reversed_axis(one.q)]
    reversed_joints = [one.reversed_axis for one in solutions if one.closed and one.reversed_axis]
    if reversed_joints and not any(gap_of(one) < NEAR for one in straight):
        return reversed_axis_message(reversed_joints[0])
    # the constraint with the largest residual at the best position found
    q = min(straight or solutions, key=gap_of).q
    gaps = m.gaps(q)
    name = max(gaps, key=lambda one: max(gaps[one][0] / m.size, gaps[one][1]))
    length, other = gaps[name]
    many = f"{len(solutions)} start{'s' if len(solutions) != 1 else ''}"
    cut = next((cut for cut in m.cuts if cut.name == name), None)
    if cut is None:
        row = next(row for row in m.closing.rows if name in (row.name, row.joint))
        least = f"{max(length, other):.3g} {residual_unit(row)}".strip()
        return (
            f"constraint '{name}' cannot be met{moment(m)}: its residual comes no nearer to 0 than "
            f"{least}, from {many}. Look at its expression, or give {start} near the position that "
            "is meant"
        )
    gap = f"{length:.3g} m" if length / m.size >= other else f"{other:.3g} (of an angle)"
    near = ""
    # nearly closed: rounded geometry is the likely cause
    if max(length / m.size, other) < NEAR and _redundant(m, q):
        near = (
            f". Redundant conditions of rounded numbers leave such residuals: up to {ROUNDED:g} of "
            "the size of the mechanism they are ignored, so give lengths and axes more digits"
        )
    path = ", ".join(f"'{joint}'" for joint in cut.loop if joint != name)
    ends = f"frames '{cut.parent_frame}' and '{cut.child_frame}'"
    if name in cut.loop:
        ends = f"frame '{cut.child_frame}' and where the joint would have it"
    return (
        f"the loop that joint '{name}' closes ({path}) cannot be assembled{moment(m)}: the "
        f"least residual found is {gap}, between {ends}, from {many}. Check lengths and places "
        "of its joints"
        f"{', the prescribed motion' if 'prescribed' in moment(m) else ''}, or give {start} near "
        f"the position that is meant{near}"
    )
