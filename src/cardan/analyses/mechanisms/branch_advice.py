"""Lines for messages, to paste, that choose one of several positions of a loop."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ...arrays import Array
from .branches import SIGNS, Branch
from .mechanism import Mechanism
from .position_solver import Solution
from .targets import Target

SAME = 1e-6  # values nearer than this do not tell positions apart
DIGITS = 6  # of printed values: named ones fit well within the tolerance of a start


def tie_advice(
    m: Mechanism, goals: Sequence[Target], best: Solution, alternatives: list[Array]
) -> str:
    """How to choose between positions that are equally near to a start.

    Args:
        m: The mechanism.
        goals: What is named at the start.
        best: The position that is taken.
        alternatives: Coordinates (nq,) of the other positions.
    """
    names, named_entries = m.model.coordinates, {k for g in goals for k in g.entries_of(m).tolist()}
    free = [k for k in m.led.tolist() if k not in named_entries]
    differing = [
        k for k in free if any(abs(_gap(m, k, best.q[k] - q[k])) > SAME for q in alternatives)
    ]
    k = next((k for k in differing if _range(m, k, best.q, alternatives)), differing[0])
    named = _literal(m, goals, {names[k]: f"{best.q[k]:.{DIGITS}g}"})
    if best.freedoms or m.model.manifest.absolute:
        return f"Name '{names[k]}' at the start to say which is meant, such as q={named}"
    line = _assembly(m, goals, k, _range(m, k, best.q, alternatives))
    return f"To say which is meant, give {line}{_guess(m, k, best.q[k])}"


def guess_advice(
    m: Mechanism, remaining: Sequence[Target], dropped: Target, solutions: Sequence[Solution]
) -> str:
    """How to use a named value that does not fit as a guess; "" where it would choose nothing.

    Args:
        m: The mechanism.
        remaining: The other named values.
        dropped: The one that does not fit.
        solutions: Positions found with these alone.
    """
    k = dropped.place.start
    met = [one for one in solutions if one.met and not one.freedoms]
    if dropped.kind != "coordinate" or len(dropped.value) != 1 or not met:
        return ""
    requested = float(dropped.value[0])

    def away(one: Solution) -> float:
        return abs(_gap(m, k, one.q[k] - requested))

    best = min(met, key=away)
    name, value = m.model.coordinates[k], best.q[k]
    start = f". Named values must fit to 1e-4. If '{name}' is a guess that tells which position"
    if m.model.manifest.absolute:
        named = _literal(m, remaining, {name: f"{value:.{DIGITS}g}"})
        return f"{start} is meant, give the fitting value: q={named}{_guess(m, k, requested)}"
    alternatives = [one.q for one in met if away(one) > away(best) + SAME]
    line = _assembly(m, remaining, k, _range(m, k, best.q, alternatives))
    return f"{start} is meant, give {line}{_guess(m, k, requested)}"


def _assembly(m: Mechanism, goals: Sequence[Target], k: int, requested: str) -> str:
    """An argument ``q=`` with the position on a branch."""
    arguments = [_literal(m, goals, {})] if goals else []
    arguments.append(f"branch={{'{m.model.coordinates[k]}': {requested or repr('+')}}}")
    if m.t:
        arguments.append(f"t={m.t!r}")
    if m.r is not None and not np.array_equal(m.r, m.model._layout.start("r")):
        arguments.append(f"r={m.r.tolist()}")
    return f"q=model.assemble({', '.join(arguments)}).q"


def _range(m: Mechanism, k: int, q: Array, alternatives: Sequence[Array]) -> str:
    """A sign or range of a coordinate that one position (nq,) has and others have not; else ""."""
    name, angle = m.model.coordinates[k], m.model.manifest.coordinates[k].unit == "rad"
    for sign, (low, high) in SIGNS.items():
        branch = Branch(name, k, low, high, angle)
        if branch.holds(q) and not any(branch.holds(other) for other in alternatives):
            return f"'{sign}'"
    value = Branch(name, k, 0.0, 0.0, angle).value(q)
    half = 0.5 * min((abs(_gap(m, k, q[k] - other[k])) for other in alternatives), default=0.0)
    return f"({value - half:.4g}, {value + half:.4g})" if half > SAME else ""


def _gap(m: Mechanism, k: int, difference: float) -> float:
    """A difference between two values of a coordinate; of angles without whole turns."""
    angle = m.model.manifest.coordinates[k].unit == "rad"
    return math.remainder(difference, 2 * math.pi) if angle else float(difference)


def _guess(m: Mechanism, k: int, value: float) -> str:
    """The other way: a guess with the joint."""
    name = m.model.coordinates[k]
    if name not in {joint.name for joint in m.model.manifest.joints}:
        return ""
    return f"; or a guess with the joint: scene.joint('{name}', ..., q0={value:.{DIGITS}g})"


def _literal(m: Mechanism, goals: Sequence[Target], more: dict[str, str]) -> str:
    """Named values as a dict to paste."""
    entries = {}
    for goal in goals:
        value = goal.value.tolist()
        entries[goal.name] = repr(
            value[0] if goal.kind == "coordinate" and len(value) == 1 else value
        )
    return "{" + ", ".join(f"'{name}': {text}" for name, text in (entries | more).items()) + "}"
