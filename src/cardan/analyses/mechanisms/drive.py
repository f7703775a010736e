"""A mechanism that follows what drives it, step by step, on one branch.

Source: E. Allgower, K. Georg, Introduction to Numerical Continuation Methods, chapter 2 (predictor,
corrector, step control).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from .mechanism import Mechanism
from .position_solver import PositionSolver
from .redundancy import rank_of
from .targets import Target, read

SMALLEST = 2.0**-44  # of the way from one value to the next
SINGULAR = 1e-7  # quality below which the drive has no hold


class Stuck(Exception):
    """The mechanism cannot follow; says where and why."""


class Drive:
    """Coordinates or inputs that move a mechanism, and what is held beside them."""

    def __init__(self, m: Mechanism, names: Sequence[str], locked: Mapping[str, object]) -> None:
        """Args:
        m: The mechanism.
        names: Coordinates, or inputs that prescribe a motion.
        hold: Coordinates and frames that keep their values.
        """
        self.m, self.names = m, list(names)
        self.locked = read(m, locked)
        self.inputs = [name for name in self.names if name not in m.model.coordinates]

    @cached_property
    def places(self) -> list[int]:
        """Places in q of the driven coordinates."""
        coordinates = self.m.model.coordinates
        return [coordinates.index(name) for name in self.names if name in coordinates]

    def speeds(self, rates: Sequence[float]) -> dict[str, float]:
        """Speeds of all that is driven or held, by name, where they are derivatives of q."""
        rows = self.m.model._layout.slots["u"]
        rates_by_name = dict(zip(self.names, rates, strict=True))
        rates_by_name |= {target.name: 0.0 for target in self.locked if target.kind == "coordinate"}
        speeds: dict[str, float] = {}
        for name, value in rates_by_name.items():
            place = rows.get(name, rows.get(f"{name}.u"))
            if name not in self.inputs and place is not None:
                names = self.m.model.speeds[place]
                speeds |= dict.fromkeys(names, float(value))
        return speeds

    def at(
        self, values: Array, rates: Sequence[float] = (), more: Sequence[float] = ()
    ) -> Mechanism:
        """The mechanism at values of its drivers, with their first and second derivatives."""
        if not self.inputs:
            return self.m
        names, inputs = self.m.model.inputs, self.m.r
        r = (self.m.model._layout.start("r") if inputs is None else inputs).copy()
        for k, name in enumerate(self.names):
            for ending, derivatives in (("", values), (".rate", rates), (".acceleration", more)):
                if f"{name}{ending}" in names and len(derivatives):
                    r[names.index(f"{name}{ending}")] = derivatives[k]
        return self.m.moved_to(self.m.t, r)

    def targets(self, values: Array) -> list[Target]:
        """Targets at given values of the drivers."""
        driven = {
            name: float(value)
            for name, value in zip(self.names, values, strict=True)
            if name not in self.inputs
        }
        return [*self.locked, *read(self.m, driven)]

    # how well it holds

    def matrix(self, m: Mechanism, q: Array) -> Array:
        """Jacobian (n, nu) of loops and of all that is held."""
        values = np.zeros(len(self.names))
        return PositionSolver(m, self.targets(values)).hard_jacobian(q)

    def rank_margin(self, m: Mechanism, q: Array) -> tuple[float, float]:
        """Smallest singular value of the driven mechanism, and the sign of its determinant."""
        K = self.matrix(m, q)
        s = np.linalg.svd(K, compute_uv=False)
        quality = float(s[-1]) if len(s) == K.shape[1] else 0.0
        square = K.shape[0] == K.shape[1]
        return quality, float(np.linalg.slogdet(K)[0]) if square else 1.0

    def check(self, m: Mechanism, q: Array) -> None:
        """Refuse drivers that leave freedoms, or that have no hold at the start.

        Raises:
            ModelError: either of the two.
        """
        G, nu = m.jacobian(q), m.model.nu
        K = self.matrix(m, q)
        rank = rank_of(np.linalg.svd(K, compute_uv=False))
        if rank == nu:
            return
        freedoms = nu - rank_of(np.linalg.svd(G, compute_uv=False))
        conditions = len(K) - m.closing.positions
        who = " and ".join(f"'{name}'" for name in self.names)
        if conditions < freedoms:
            raise ModelError(
                f"the mechanism has {freedoms} degrees of freedom, {who} "
                f"{'drive' if len(self.names) > 1 else 'drives'} {conditions}: give the "
                "others by locked="
            )
        raise ModelError(
            f"{who} cannot drive the mechanism from here: the position is singular. Start from "
            "another value"
        )

    # moving

    def go(self, q: Array, before: Array, after: Array) -> Array:
        """The position at the next values, next to that at the last ones.

        Raises:
            Stuck: there is none, or another branch begins on the way.
        """
        done, part = 0.0, 1.0
        while done < 1:
            part = min(part, 1 - done)
            new = self._step(q, before, after, done, part)
            if new is not None:
                q, done, part = new, done + part, 2 * part
                continue
            part *= 0.5
            if part < SMALLEST:
                raise Stuck(self._stuck(q, before + done * (after - before), after))
        return q

    def _step(
        self, q: Array, before: Array, after: Array, done: float, part: float
    ) -> Array | None:
        """The position a part of the way further, None where a shorter step is needed."""
        here, there = before + done * (after - before), before + (done + part) * (after - before)
        m, old = self.at(there), self.at(here)
        solution = PositionSolver(m, self.targets(there)).follow(q)
        if solution is None:
            return None
        quality, sign = self.rank_margin(m, solution.q)
        if quality < SINGULAR or sign != self.rank_margin(old, q)[1]:
            return None
        return m.nearest(solution.q, q)

    def _stuck(self, q: Array, values: Array, goals: Array) -> str:
        """Why it does not go on from a position."""
        where = " and ".join(
            f"'{name}' = {value:.6g} (of {goal:g})"
            for name, value, goal in zip(self.names, values, goals, strict=True)
        )
        m = self.at(values)
        s = np.linalg.svd(m.jacobian(q), compute_uv=False)
        if len(s) and s[-1] < 1e-4 * s[0]:
            return (
                f"the sweep stops at {where}: branches of the mechanism meet in a singular "
                "position, and which one follows is not defined. Begin on the other side of it"
            )
        who = " and ".join(f"'{name}'" for name in self.names)
        return (
            f"the sweep stops at {where}: a dead point, {who} cannot go further on this branch. "
            "Drive another coordinate through it"
        )
