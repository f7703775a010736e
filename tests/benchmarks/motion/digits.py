"""The end of a motion in 40 digits: extrapolation of midpoint steps.

Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, II.9.
"""

from __future__ import annotations

import mpmath as mp
import numpy as np

import cardan as cd
from benchmarks.motion.problem import Array
from cardan.ir.interpreter import evaluate
from cardan.ir.serialize import from_dict

DIGITS = 40
# columns of the tableau: order 24; steps in a second
COLUMNS, STEPS = 12, 72


def final(model: cd.CompiledModel, x0: Array, end: float) -> Array:
    """State (nx,) at ``end``, rounded once; right to about 1e-15.

    Args:
        model: Of a tree without inputs or internal states.
        x0: State at time 0 (nx,).
        end: Time [s].
    """
    function = from_dict(model._objects.saved()[model._function("rhs").symbol])
    p, nq = list(model.parameters.vector), model.nq

    def rhs(x: list[mp.mpf]) -> list[mp.mpf]:
        blocks = {"t": [0.0], "q": x[:nq], "u": x[nq:], "r": [], "z": [], "s": [], "p": p}
        found = evaluate(function, blocks, "mp", DIGITS)
        return [value for output in function.outputs for value in found[output.name]]

    with mp.workdps(DIGITS):
        x, count = [mp.mpf(float(value)) for value in x0], round(STEPS * end)
        for _ in range(count):
            x = _step(rhs, x, mp.mpf(end) / count)
        return np.array([float(value) for value in x])


def _step(rhs: object, x: list[mp.mpf], h: mp.mpf) -> list[mp.mpf]:
    """One step: 2, 4, 6, ... midpoint steps, extrapolated to none in the square of their size."""
    first = rhs(x)  # type: ignore[operator]
    rows: list[list[list[mp.mpf]]] = []
    for j in range(1, COLUMNS + 1):
        n = 2 * j
        small, before = h / n, x
        now = [a + small * b for a, b in zip(x, first, strict=True)]
        for _ in range(n - 1):
            slope = rhs(now)  # type: ignore[operator]
            after = [a + 2 * small * b for a, b in zip(before, slope, strict=True)]
            before, now = now, after
        row = [now]
        for k in range(1, j):
            weight = 1 / ((mp.mpf(j) / (j - k)) ** 2 - 1)
            pairs = zip(row[-1], rows[-1][k - 1], strict=True)
            row.append([a + weight * (a - b) for a, b in pairs])
        rows.append(row)
    return rows[-1][-1]
