"""Positions that meet conditions: what must hold exactly, what should as well as it can.

One solver for starts, assemblies, sweeps and paths, in C: ``kernels/solve/position.c`` says how.
Models
whose joints alone are moved, and values of joints that follow from loops, are asked from there.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ...runtime.calls.interpreted import called_back
from ...schema.records import PositionRecord, TargetRecord
from ..simulation.run_record import MORE
from .mechanism import Mechanism
from .mechanism_record import called
from .targets import Target

MET = 1e-11  # residuals without units that count as zero
FARTHEST, ASIDE = 0.5, 0.3  # a step along a tangent; a part of it by which it may miss
TARGET_TOL = 1e-9
LOST = 1e-8  # singular values that hold nothing
EFFORT = 4_000_000  # numbers squared of a slice of it: some hundredths of a second


@dataclass(frozen=True)
class Solution:
    """End of a search.

    Attributes:
        q: Coordinates (nq,).
        open: Largest residual of what must hold, without units.
        cost: Weighted sum of squares of what should hold.
        freedoms: Steps that keep what must hold, to first order.
        reversed_axis: Cut joint of which an axis is turned round there, "" if none.
        first: Whether the search began at the start that was given.
        closure_tol: Residual that counts as none.
    """

    q: Array
    open: float
    cost: float
    freedoms: int
    reversed_axis: str = ""
    first: bool = False
    closure_tol: float = 0.0

    @property
    def closed(self) -> bool:
        """True when all residuals that must vanish do."""
        return self.open <= max(MET, self.closure_tol)

    @property
    def met(self) -> bool:
        """True when all that must hold does."""
        return self.closed and not self.reversed_axis


class PositionSolver:
    """Loops and targets of a mechanism, and the search for positions that meet them."""

    def __init__(self, m: Mechanism, targets: Sequence[Target] = ()) -> None:
        """Connect.

        Args:
            m: The mechanism, at its time and with its inputs.
            targets: Those without a weight must hold.
        """
        self.m, self.targets = m, list(targets)
        parts = m.connection
        self._library = parts.library
        self._references: list[Any] = [parts]
        self.record = PositionRecord.from_buffer_copy(parts.record)
        self._work, self._interpreted = parts.work, parts.called_back
        record = self.record
        record.t = m.t
        if m.r is not None:
            record.r = self._pointer(np.ascontiguousarray(m.r))
        record.hard = record.hard_count
        rows = (TargetRecord * max(1, len(self.targets)))()
        # targets with a weight are minimized, the others are met exactly
        for row, target in zip(rows, self.targets, strict=False):
            self._connect(row, target)
            if target.weight is None:
                record.hard += row.rows
            else:
                record.soft += row.rows
        self._references.append(rows)
        record.targets, record.target_count = ctypes.addressof(rows), len(self.targets)
        self._allocate(parts.rows)
        # held values that single coordinates have to the bit
        exact = [t for t in self.targets if t.kind == "coordinate" and t.weight is None]
        self._exact = [(t.place, t.value) for t in exact]
        # the cost of an iteration grows with the size of the matrix, so the budget falls
        cost = max(1, (record.hard + record.soft + record.nu) * max(1, record.nu)) ** 1.5
        self._budget = max(1, int(EFFORT / cost))

    def _connect(self, row: TargetRecord, target: Target) -> None:
        """Fill in a target."""
        m = self.m
        row.weight = -1.0 if target.weight is None else np.sqrt(target.weight)
        row.rows = target.rows
        if target.kind in ("coordinate", "coordinates"):
            row.entries = self._pointer(np.ascontiguousarray(target.entries_of(m), dtype=np.intp))
            row.value = self._pointer(np.ascontiguousarray(target.value))
            row.scale = self._pointer(target.scales_of(m))
            if not self.record.kinematics:
                qdot = m.model._function("qdot")
                self.record.qdot, self.record.qdot_w = qdot.address, self._pointer(qdot.w)
                self._work = max(self._work, qdot.work_size)
                self._interpreted |= qdot.interpreted
            return
        for name, size in (("residual", row.rows), ("jacobian", row.rows * m.nu)):
            callback = called(partial(getattr(target, name), m), size, q=m.model.nq)
            self._references.append(callback)
            setattr(row, name, callback.address)
        self._interpreted = True

    def _allocate(self, rows: int) -> None:
        """One block of numbers for everything. ``rows``: of the constraint Jacobian."""
        record, n = self.record, self.record.hard + self.record.soft
        sizes = {
            "q": record.nq,
            "residuals": n,
            "jacobian": max(n, rows) * record.nu,
            "memory": self._library.cardan_position_length(record),
            "work": self._work,
        }
        block, start = np.zeros(sum(sizes.values()) + 1), 0
        self._references.append(block)
        for name, size in sizes.items():
            setattr(record, name, block.ctypes.data + 8 * start)
            if name in ("q", "residuals", "jacobian"):
                setattr(self, f"_{name}", block[start : start + size])
            start += size

    _q: Array
    _residuals: Array
    _jacobian: Array

    def _pointer(self, array: NDArray[Any]) -> int:
        """Address of an array that must live as long as this."""
        self._references.append(array)
        return array.ctypes.data

    def _around(self) -> AbstractContextManager[None]:
        """Context of a call of the kernel."""
        return called_back() if self._interpreted else nullcontext()

    # residuals

    def hard(self, q: Array) -> Array:
        """Residuals (n,) of what must vanish."""
        self._q[:] = q
        self._evaluate(self._library.cardan_position_residuals)
        return self._residuals[: self.record.hard].copy()

    def _evaluate(self, kernel: Callable[[PositionRecord], int]) -> None:
        with self._around():
            status = kernel(self.record)
        if status:
            raise SolveError(
                f"loops of '{self.m.model.name}' have no residual at a position that a search "
                f"came to (status {status})"
            )

    def hard_jacobian(self, q: Array) -> Array:
        """Derivatives along steps (n, nu) of what must vanish."""
        record = self.record
        self._q[:] = q
        self._evaluate(self._library.cardan_position_jacobian)
        return self._jacobian[: record.hard * record.nu].reshape(record.hard, record.nu).copy()

    # searches

    def solve(self, q: Array) -> Solution:
        """The position next to a start (nq,) that meets the conditions, as well as it can."""
        record, m = self.record, self.m
        self._q[:] = q
        record.rank, record.residual_noise = m.rank, m.closure_tol
        with self._around():
            self._library.cardan_position_begin(record)
            while self._library.cardan_position_solve(record, self._budget) == MORE:
                pass
        reversed_joint = ""
        if record.open <= max(MET, m.closure_tol) and (
            record.wrong_sign >= 0 or not record.assembly_sign_count
        ):
            reversed_joint = m.reversed_axis(self._q)
        return Solution(
            self._q.copy(),
            record.open,
            record.cost,
            record.freedoms,
            reversed_joint,
            closure_tol=m.closure_tol,
        )

    def near(self, guess: Array, length: float) -> Solution | None:
        """The position next to a guess (nq,); None where none is as near as a step promises.

        Args:
            guess: Where a tangent leads.
            length: Of the step along it, without units.
        """
        end = self.solve(guess)
        off = float(np.linalg.norm(self.m.difference(guess, end.q)))
        return end if end.met and off <= ASIDE * length + TARGET_TOL else None

    def follow(self, q: Array) -> Solution | None:
        """The position that the tangent at another one (nq,) leads to; None where it is far."""
        step = np.linalg.lstsq(self.hard_jacobian(q), -self.hard(q), rcond=LOST)[0]
        ahead = np.asarray(step, dtype=np.float64)
        length = float(np.linalg.norm(ahead))
        return self.near(self.m.advance(q, ahead), length) if length < FARTHEST else None

    def search(self, begin: Array) -> Solution:
        """End of a search from a start (nq,); locked coordinates have their values to the bit."""
        q = begin.copy()
        for place, value in self._exact:
            q[place] = value
        end = self.solve(q)
        if end.met:
            for place, value in self._exact:
                if len(value) == 1:
                    end.q[place] = value
        end.q[:] = self.m.nearest(end.q, begin)
        return end


def missed(m: Mechanism, targets: Sequence[Target], q: Array) -> Array:
    """Distances of a position (nq,) from targets, without units, one after the other (n,)."""
    solver = PositionSolver(m, [replace(target, weight=None) for target in targets])
    return solver.hard(q)[solver.record.hard_count :]
