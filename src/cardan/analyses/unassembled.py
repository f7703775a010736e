"""Why a mechanism cannot be assembled: the circuit that stays open, or targets in conflict."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NoReturn

import numpy as np

from ..errors import ModelError
from .mechanism import Mechanism
from .meeting import Found
from .targets import Target

WEIGHTS = "Leave one out, or give weights= to what need not be met exactly"
Search = Callable[[Sequence[Target]], list[Found]]


def explain(
    m: Mechanism,
    targets: Sequence[Target],
    found: Sequence[Found],
    again: Search,
    remedy: str = WEIGHTS,
) -> NoReturn:
    """Raise the error for searches of which none met what must hold.

    Args:
        m: The mechanism.
        targets: All of them.
        found: Where the searches ended.
        again: Searches with other targets.
        remedy: What to do about targets that cannot hold.

    Raises:
        ModelError: always.
    """
    held = [target for target in targets if target.weight is None]
    if not held:
        raise ModelError(_open(m, found))
    bare = again([])
    if not any(one.met for one in bare):
        raise ModelError(_open(m, bare))
    conflict = _smallest(held, again)
    raise ModelError(_conflict(m, conflict, [*again(_wished(conflict)), *bare], remedy))


def _smallest(held: Sequence[Target], again: Search) -> list[Target]:
    """Targets that cannot hold together, any of which could if the others were left out."""
    kept = list(held)
    for target in held:
        rest = [one for one in kept if one is not target]
        if not any(one.met for one in again(rest)):
            kept = rest
    return kept


def _wished(targets: Sequence[Target]) -> list[Target]:
    """The same targets, none of which must be held."""
    return [replace(target, weight=1.0) for target in targets]


def _conflict(m: Mechanism, targets: Sequence[Target], found: Sequence[Found], remedy: str) -> str:
    """What is reached where all of them are only wished for."""

    def away(one: Found) -> float:
        return sum(float(np.sum(target.residual(m, one.q) ** 2)) for target in targets)

    q = min((one for one in found if one.met), key=away).q
    said = [f"'{t.name}' (asked {t.asked}; reached {t.reached(m, q)})" for t in targets]
    if len(said) == 1:
        return f"{said[0]} is out of reach. {remedy}"
    return f"{', '.join(said[:-1])} and {said[-1]} cannot hold together. {remedy}"


def turned_round(joint: str) -> str:
    """What to say about a joint that closes with an axis the wrong way."""
    return (
        f"joint '{joint}' closes its circuit here only with an axis turned round, as it is not "
        "built: start nearer to the position that is meant, or turn the axis in the scene"
    )


def _open(m: Mechanism, found: Sequence[Found]) -> str:
    """The circuit with the largest gap where the search came nearest."""
    turned = [one.turned for one in found if one.closed and one.turned]
    if turned:
        return turned_round(turned[0])

    def gap_of(one: Found) -> float:
        return max(max(length / m.size, other) for length, other in m.gaps(one.q).values())

    gaps = m.gaps(min(found, key=gap_of).q)
    name = max(gaps, key=lambda one: max(gaps[one][0] / m.size, gaps[one][1]))
    length, other = gaps[name]
    gap = f"{length:.3g} m" if length / m.size >= other else f"{other:.3g} (of an angle)"
    cut = next((cut for cut in m.cuts if cut["name"] == name), None)
    if cut is None:
        where, who = "", f"constraint '{name}' cannot be met"
    else:
        where = f" between frames '{cut['parent_frame']}' and '{cut['child_frame']}'"
        path = ", ".join(f"'{joint}'" for joint in cut["circuit"] if joint != name)
        who = f"the circuit that joint '{name}' closes ({path}) cannot be assembled"
    many = f"{len(found)} start{'s' if len(found) != 1 else ''}"
    return (
        f"{who}: the smallest gap is {gap}{where}, from {many}. Check lengths and places of its "
        "joints, or give start= near the position that is meant"
    )
