"""Positions that meet conditions: Gauss-Newton on what must hold, least squares on what should.

Source: J. Nocedal, S. Wright, Numerical Optimization, 2nd ed., chapters 10 (damped least squares)
and 18 (steps along and across the constraints).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .mechanism import Mechanism
from .targets import Target

Array = NDArray[np.float64]
MET = 1e-11  # residuals without units that count as zero
SOUGHT = 1e-15
STEPS = 80
LONGEST = 0.7  # radians, or sizes of the mechanism
LEAST_STEP = 1e-13


@dataclass(frozen=True)
class Found:
    """Where a search ended.

    Attributes:
        q: Coordinates (nq,).
        open: Largest residual of what must hold, without units.
        cost: Weighted sum of squares of what should hold.
        freedoms: Steps that keep what must hold, to first order.
        turned: Cut joint of which an axis is turned round there, "" if none.
        first: Whether the search began at the start that was given.
        slack: Residual that counts as none.
    """

    q: Array
    open: float
    cost: float
    freedoms: int
    turned: str = ""
    first: bool = False
    slack: float = 0.0

    @property
    def closed(self) -> bool:
        """Whether all residuals that must vanish do."""
        return self.open <= max(MET, self.slack)

    @property
    def met(self) -> bool:
        """Whether all that must hold does."""
        return self.closed and not self.turned


class Conditions:
    """Circuits and targets at a position, with their Jacobians."""

    def __init__(self, m: Mechanism, targets: Sequence[Target] = ()) -> None:
        self.m = m
        self.held = [target for target in targets if target.weight is None]
        self.wished = [target for target in targets if target.weight is not None]

    def hard(self, q: Array) -> Array:
        """Residuals that must vanish."""
        parts = [self.m.residuals(q), *(target.residual(self.m, q) for target in self.held)]
        return np.concatenate(parts)

    def hard_jacobian(self, q: Array) -> Array:
        """Their derivatives along steps (n, nu)."""
        parts = [self.m.jacobian(q)[: self.m.positions]]
        return np.concatenate([*parts, *(target.jacobian(self.m, q) for target in self.held)])

    def soft(self, q: Array) -> Array:
        """Weighted residuals that should be small."""
        parts = [np.sqrt(t.weight or 0.0) * t.residual(self.m, q) for t in self.wished]
        return np.concatenate([np.zeros(0), *parts])

    def soft_jacobian(self, q: Array) -> Array:
        """Their derivatives along steps (n, nu)."""
        parts = [np.sqrt(t.weight or 0.0) * t.jacobian(self.m, q) for t in self.wished]
        return np.concatenate([np.zeros((0, self.m.nu)), *parts])


def meet(conditions: Conditions, q: Array) -> Found:
    """The position next to a start that meets conditions, as well as it can.

    Args:
        conditions: What must and what should hold.
        q: Where to start (nq,).
    """
    m, damping = conditions.m, 1e-3
    hard, soft = conditions.hard(q), conditions.soft(q)
    rank = 0
    for _ in range(STEPS):
        across, along, rank, gradient = _step(conditions, q, hard, soft, damping)
        step = across + along
        longest = float(np.abs(step).max(initial=0.0))
        if _size(hard) <= SOUGHT and longest <= LEAST_STEP:
            break
        step *= min(1.0, LONGEST / longest) if longest > 0 else 1.0
        # what must hold counts more than anything the step gains on what should
        price = 2 * gradient
        merit = _merit(hard, soft, price)
        for _ in range(12):
            trial = m.advance(q, step)
            new_hard, new_soft = conditions.hard(trial), conditions.soft(trial)
            if _merit(new_hard, new_soft, price) < merit:
                break
            step = 0.3 * step
        else:
            break
        damping = max(1e-12, 0.2 * damping) if np.allclose(step, across + along) else damping * 2
        q, hard, soft = trial, new_hard, new_soft
    return Found(q, _size(hard), float(soft @ soft), m.nu - rank, slack=m.slack)


def _step(
    conditions: Conditions, q: Array, hard: Array, soft: Array, damping: float
) -> tuple[Array, Array, int, float]:
    """A step across what must hold, one along it, the rank, and the price of leaving it."""
    A = conditions.hard_jacobian(q)
    U, s, Vt = np.linalg.svd(A)
    top = float(s.max(initial=0.0))
    rank = int(np.sum(s > conditions.m.rank * max(top, 1.0)))
    # damped by the residual itself: bounded where the rank drops, quadratic at the end
    distance = float(np.linalg.norm(hard)) * 0.1
    inverse = s[:rank] / (s[:rank] ** 2 + distance**2)
    across = -Vt[:rank].T @ (inverse * (U[:, :rank].T @ hard))
    if not len(soft):
        return across, np.zeros_like(across), rank, 1.0
    R, Z = conditions.soft_jacobian(q), Vt[rank:]
    ahead, RZ = soft + R @ across, R @ Z.T
    scale = damping * max(float(np.abs(RZ).max(initial=0.0)) ** 2, 1e-12)
    normal = RZ.T @ RZ + scale * np.eye(len(Z))
    along = -Z.T @ np.linalg.solve(normal, RZ.T @ ahead)
    multipliers = U[:, :rank] @ ((Vt[:rank] @ (R.T @ soft)) / s[:rank])
    return across, along, rank, 1.0 + float(np.abs(multipliers).max(initial=0.0))


def _merit(hard: Array, soft: Array, price: float) -> float:
    return float(0.5 * (soft @ soft) + price * np.linalg.norm(hard))


def _size(residuals: Array) -> float:
    """The largest; infinite where one is no number."""
    return float(np.abs(residuals).max(initial=0.0)) if np.isfinite(residuals).all() else np.inf
