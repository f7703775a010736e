"""Equations of loops and rolling bodies reduced in numbers, to be differentiated.

Positions follow by Newton's method, speeds and accelerations from linear systems in maximal form,
M udot + h = f + Gᵀ lam, G udot = gamma with gamma from differences of G u along the motion.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from cardan.ir.interpreter import evaluate
from laws.cases import values

STEP = 1e-3
# of the central difference of fourth order
WEIGHTS = {-2: 1 / 12, -1: -2 / 3, 1: 2 / 3, 2: -1 / 12}
Array = np.ndarray


def along(f: Callable[[float], Array]) -> Array:
    """df/dh at 0, a central difference of fourth order."""
    return np.asarray(sum(weight * f(k * STEP) for k, weight in WEIGHTS.items()) / STEP)


def slope(f: Callable[[Array], Array], x: Array) -> Array:
    """The Jacobian of f at x, columns by :func:`along`."""
    return np.stack([along(lambda h, e=e: f(x + h * e)) for e in np.eye(len(x))], axis=1)


class Reduced:
    """Independent coordinates and speeds y, and their rates.

    Args:
        equations: Of the system.
        y, w: Names of independent coordinates and speeds.
        q: A closed position.

    Attributes:
        inputs: Blocks that are not at their defaults, such as ``{"r": [1.0]}``.
    """

    def __init__(self, equations: Any, y: Any, w: Any, q: Array) -> None:
        self.equations, self.last, self.inputs = equations, q, dict[str, Any]()
        self.y = [equations.coordinates.index(name) for name in y]
        self.w = [equations.speeds.index(name) for name in w]
        self.count = sum(row.level == "position" for row in equations.constraint_rows)

    def call(self, name: str, **given: Any) -> Array:
        function = self.equations.function(name)
        blocks = values(self.equations, t=[0.0], z=[], s=[], **self.inputs, **given)
        (found,) = evaluate(function, blocks, "numpy").values()
        return np.asarray(found, dtype=float)

    @cached_property
    def _nothing(self) -> Array:
        return np.zeros(len(self.equations.speeds))

    def moves(self, q: Array) -> Array:
        """N (nq, nu)."""
        unit = np.eye(len(self._nothing))
        return np.stack([np.broadcast_to(self.call("qdot", q=q, u=u), q.shape) for u in unit], 1)

    def jacobian(self, q: Array) -> Array:
        if not self.equations.constraint_rows:
            return np.zeros((0, len(self._nothing)))
        return self.call("constraint_jacobian", q=q)

    def position(self, goal: Array) -> Array:
        q = self.last.copy()
        for _ in range(8):
            off = q[self.y] - goal
            kept = self.moves(q)[self.y]
            if self.count:
                off = np.concatenate([self.call("constraints", q=q), off])
                kept = np.concatenate([self.jacobian(q)[: self.count], kept])
            q = self.call("integrate", q=q, du=-np.linalg.lstsq(kept, off, rcond=1e-10)[0])
        return q

    def moved(self, q: Array, du: Array) -> Array:
        return self.call("integrate", q=q, du=du)

    def speeds(self, q: Array, w: Array) -> Array:
        G = self.jacobian(q)
        kept = np.concatenate([G, np.eye(G.shape[1])[self.w]])
        right = np.concatenate([np.zeros(len(G)), w])
        return np.linalg.lstsq(kept, right, rcond=1e-10)[0]

    def accelerations(self, q: Array, u: Array) -> Array:
        shapes = {"mass_matrix": (len(u),) * 2, "bias": u.shape, "applied_forces": u.shape}
        M, h, f = (np.broadcast_to(self.call(n, q=q, u=u), s) for n, s in shapes.items())
        G = self.jacobian(q)
        gamma = -along(lambda h: self.jacobian(self.moved(q, h * u)) @ u)
        system = np.block([[M, G.T], [G, np.zeros((len(G),) * 2)]])
        right = np.concatenate([f - h, gamma])
        return np.linalg.lstsq(system, right, rcond=1e-10)[0][: len(u)]

    def rates(self, x: Array) -> Array:
        n = len(self.y)
        q = self.position(x[:n])
        u = self.speeds(q, x[n:])
        return np.concatenate([(self.moves(q) @ u)[self.y], self.accelerations(q, u)[self.w]])
