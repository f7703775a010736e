"""Choose between several ways to assemble a mechanism, and lines for messages that do."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NoReturn

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, brief, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from .mechanism import Mechanism
from .position_solver import Solution
from .targets import Target

OFFSET = 1e-3  # of the size, and radians: beside a start that may be singular
# singular values of G below this part of the largest are zero: a search for a place where branches
# meet ends the root of rounding beside it
SINGULAR = 1e-7
# step of central differences of G along directions without units, and the rate of change that is
# more than their error and what rounded lengths leave [of the largest singular value]
ASIDE, CURVED = 1e-4, 1e-5
SAME = 1e-6  # values nearer than this do not tell positions apart
DIGITS = 6  # of printed values: named ones fit well within the tolerance of a start
SIGNS = {"+": (0.0, math.inf), "-": (-math.inf, 0.0)}


@dataclass(frozen=True)
class Branch:
    """A range that a coordinate must lie in; an angle up to whole turns.

    Attributes:
        name: Of the coordinate.
        place: In q.
        low, high: The range.
        angle: Whether whole turns do not count.
    """

    name: str
    place: int
    low: float
    high: float
    angle: bool

    def value(self, q: Array) -> float:
        """The coordinate; an angle between -pi and pi."""
        value = float(q[self.place])
        return math.remainder(value, 2 * math.pi) if self.angle else value

    def holds(self, q: Array) -> bool:
        """True when coordinates (nq,) lie on it."""
        value = self.value(q)
        turns = (-1, 0, 1) if self.angle and math.isfinite(self.low + self.high) else (0,)
        return any(self.low <= value + 2 * math.pi * k <= self.high for k in turns)

    def __str__(self) -> str:
        if math.isinf(self.high):
            return f"'{self.name}' > {self.low:g}"
        if math.isinf(self.low):
            return f"'{self.name}' < {self.high:g}"
        return f"'{self.name}' between {self.low:g} and {self.high:g}"


def branches(model: LoadedModel, named: Mapping[str, Any]) -> list[Branch]:
    """Branches out of what the user wrote.

    Raises:
        ModelError: an unknown coordinate. ArgumentError: neither a sign nor a range.
    """
    ranges = []
    for name, value in named.items():
        if name not in model.coordinates:
            raise ModelError(
                f"branch: there is no coordinate '{name}'.{near(name, model.coordinates)}"
            )
        k = model.coordinates.index(name)
        if isinstance(value, str) and value in SIGNS:
            low, high = SIGNS[value]
        elif not isinstance(value, str) and np.shape(value) == (2,) and value[0] < value[1]:
            low, high = float(value[0]), float(value[1])
        else:
            raise ArgumentError(f"branch: '{name}' is {brief(value)}; give '+', '-' or (low, high)")
        ranges.append(Branch(name, k, low, high, model.manifest.coordinates[k].unit == "rad"))
    return ranges


def refuse(requested: Sequence[Branch], positions: Sequence[Array]) -> NoReturn:
    """Raise the error for positions that are all on other branches.

    Raises:
        ModelError: always.
    """
    said = " and ".join(str(branch) for branch in requested)
    values = [
        ", ".join(f"{branch.name} = {branch.value(q):.6g}" for branch in requested)
        for q in positions
    ]
    listed = "; ".join(dict.fromkeys(values[:6])) + ("; ..." if len(values) > 6 else "")
    many = "1 position was" if len(positions) == 1 else f"{len(positions)} positions were"
    raise ModelError(
        f"no assembled position has {said}. {many} found, with {listed}. Ask for one of these "
        "branches, or for more starts="
    )


def lost_conditions(m: Mechanism, q: Array) -> Array:
    """Combinations (m, n) of constraints that are dependent at a position and not along motions.

    Combinations w with wᵀ G = 0 are redundant where that holds along the motion as well: wᵀ dG(v)
    v' = 0 for all directions v, v' that G allows. Otherwise the rank is lost here alone: branches
    meet, or nothing moves although G lets it.
    """
    U, s = m.decomposition(q)
    rank = int(np.sum(s > SINGULAR * s.max(initial=0.0)))
    W = U[:, rank:]
    if not W.size or rank == m.nu:
        return W[:, :0]
    V = np.linalg.svd(m.jacobian(q))[2][rank:].T
    steps = ASIDE * V.T
    slopes = [m.jacobian(m.advance(q, v)) - m.jacobian(m.advance(q, -v)) for v in steps]
    curvature = np.stack([W.T @ slope @ V for slope in slopes], axis=1) / (2 * ASIDE)
    curvature = curvature.reshape(W.shape[1], -1)
    lost = int(np.sum(np.linalg.svd(curvature, compute_uv=False) > CURVED * s.max(initial=1.0)))
    # what is lost here, and not what is redundant everywhere
    along: Array = W @ np.linalg.svd(curvature)[0][:, :lost]
    return along


def refuse_singular(m: Mechanism, q: Array) -> None:
    """Refuse a start at which branches meet, unless all speeds say which one is meant.

    Raises:
        ModelError: the rank of the constraints is lower here than along the motion.
    """
    along = lost_conditions(m, q)
    if not along.size:
        return
    s, lost = m.decomposition(q)[1], along.shape[1]
    rank = int(np.sum(s > SINGULAR * s.max(initial=0.0)))
    weakest = int(np.abs(along).max(axis=1).argmax())
    raise ModelError(
        f"the start is a singular position: {rank} of {rank + lost} independent constraints hold "
        f"there, branches of the motion meet at joint '{m.closing.rows[weakest].joint}'. Give all "
        "speeds, u=: they say which branch is meant; or start beside it"
    )


# advice, to paste


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
