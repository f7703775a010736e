"""Numbers of a cycle by name, for the histories of a path."""

from __future__ import annotations

import numpy as np

from ...errors import ModelError, near
from ..continuation.solutions import Quantity
from .cycle_family import CycleFamily, CyclePoint
from .named_states import state_names

PERIOD, MULTIPLIER = "period", "multiplier"
EXTREMES = {".max": 1.0, ".min": -1.0}
SAMPLES = 361  # of a lap


def quantity(family: CycleFamily, name: str) -> Quantity:
    """An entry of the state, its extreme over a lap, a swept value, the period, the multiplier.

    Raises:
        ModelError: there is no such number.
    """
    names = state_names(family.problem.model)
    if name in names:
        k = names.index(name)
        return lambda point: float(point.at.x[k])
    if name in family.way.swept:
        return lambda point: family.way.values(point.s)[name]
    if name == PERIOD:
        return lambda point: family.finished(point).period
    if name == MULTIPLIER:
        return lambda point: float(np.abs(family.multipliers(point)).max(initial=0.0))
    of, dot, extreme = name.rpartition(".")
    if dot + extreme in EXTREMES and of in names:
        k, sign = names.index(of), EXTREMES[dot + extreme]
        return lambda point: sign * _largest(family, point, k, sign)
    extremes = [f"{one}{end}" for one in names for end in EXTREMES]
    candidates = [*names, *family.way.swept, PERIOD, MULTIPLIER, *extremes]
    raise ModelError(f"continuation: there is no '{name}' to watch.{near(name, candidates)}")


def _largest(family: CycleFamily, point: CyclePoint, k: int, sign: float) -> float:
    """The largest value of an entry over a lap, by the parabola through three samples."""
    motion = family.problem.motion(family.finished(point))
    times = np.linspace(motion.t[0], motion.t[-1], SAMPLES)
    values = sign * motion.at(times)[:, k]
    top = int(values.argmax())
    if not 0 < top < len(values) - 1:
        return float(values[top])
    a, b, c = values[top - 1 : top + 2].tolist()
    bend = a - 2 * b + c
    return float(b - (c - a) ** 2 / (8 * bend)) if bend else float(b)
