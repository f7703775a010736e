"""Positions that meet conditions: what must hold exactly, what should as well as it can.

One solver for starts, assemblies, sweeps and paths, in C: ``kernels/position.c`` says how. Models
whose joints alone are moved, and values of joints that follow from loops, are asked from there.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import SolveError
from ..runtime.interpreted import called_back
from ..schema.records import COUNT, PositionRecord, TargetRecord, check
from .mechanism import Mechanism, called
from .targets import Target

Array = NDArray[np.float64]
MET = 1e-11  # residuals without units that count as zero
COORDINATES, PLACE, POSE, GENERAL = range(4)  # kinds of targets, as in position.h
FARTHEST, ASIDE = 0.5, 0.3  # a step along a tangent; a part of it by which it may miss
REACHED = 1e-9
LOST = 1e-8  # singular values that hold nothing
MORE = 1  # the answer of a search that is not over
EFFORT = 4_000_000  # numbers squared of a slice of it: some hundredths of a second


@dataclass(frozen=True)
class Solution:
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


class PositionSolver:
    """Circuits and targets of a mechanism, and the search for positions that meet them."""

    def __init__(self, m: Mechanism, targets: Sequence[Target] = ()) -> None:
        """Connect.

        Args:
            m: The mechanism, at its time and with its inputs.
            targets: Those without a weight must hold.
        """
        self.m, self.targets = m, list(targets)
        self._library = _library(m.model._kernels())
        parts = m.connection
        self._keep: list[Any] = [parts]
        self.record = PositionRecord.from_buffer_copy(parts.record)
        self._work, self._interpreted = parts.work, parts.called_back
        record, layout = self.record, m.model._layout
        record.t = m.t
        for letter in "zsr":
            block = layout.start(letter) if letter != "r" or m.r is None else m.r
            setattr(record, letter, self._pointer(np.ascontiguousarray(block)))
        record.hard = record.kept_count
        rows = (TargetRecord * max(1, len(self.targets)))()
        for row, target in zip(rows, self.targets, strict=False):
            self._connect(row, target)
            if target.weight is None:
                record.hard += row.rows
            else:
                record.soft += row.rows
        self._keep.append(rows)
        record.targets, record.target_count = ctypes.addressof(rows), len(self.targets)
        self._allocate(parts.rows)
        # held values that single coordinates have to the bit
        held = [t for t in self.targets if t.kind == "coordinate" and t.weight is None]
        self._held = [(t.place, t.value) for t in held]
        cost = max(1, (record.hard + record.soft + record.nu) * max(1, record.nu)) ** 1.5
        self._budget = max(1, int(EFFORT / cost))

    def _connect(self, row: TargetRecord, target: Target) -> None:
        """Fill in a target."""
        m = self.m
        row.weight = -1.0 if target.weight is None else np.sqrt(target.weight)
        row.value = self._pointer(np.ascontiguousarray(target.goal))
        if target.kind in ("coordinate", "coordinates"):
            entries = np.ascontiguousarray(target.entries_of(m), dtype=np.intp)
            row.kind, row.rows, row.entries = COORDINATES, len(entries), self._pointer(entries)
            row.scale = self._pointer(target.scales_of(m))
            if not self.record.kinematics:
                self._functions(self.record, qdot="qdot")
        elif target.kind in ("position", "pose"):
            row.kind, row.rows = (POSE, 6) if target.kind == "pose" else (PLACE, 3)
            self._functions(row, residual="pose", jacobian="frame_jacobian", of=target.name)
        else:
            row.kind, row.rows = GENERAL, len(target.value)
            for name, size in (("residual", row.rows), ("jacobian", row.rows * m.nu)):
                made = called(partial(getattr(target, name), m), size, q=m.model.nq)
                self._keep.append(made)
                setattr(row, name, made.address)
            self._interpreted = True

    def _functions(self, record: Any, of: str | None = None, **names: str) -> None:
        """Fill functions of the model into fields of a record."""
        functions = self.m.model._load([(name, of) for name in names.values()])
        for field, function in zip(names, functions, strict=True):
            setattr(record, field, function.address)
            setattr(record, f"{field}_w", self._pointer(function.w))
            self._work = max(self._work, function.work_size)
            self._interpreted |= function.interpreted

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
        self._keep.append(block)
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
        self._keep.append(array)
        return array.ctypes.data

    def _around(self) -> AbstractContextManager[None]:
        """What stands around a call of the kernel."""
        return called_back() if self._interpreted else nullcontext()

    # residuals

    def hard(self, q: Array) -> Array:
        """Residuals (n,) of what must vanish."""
        return self._at(q)[: self.record.hard]

    def soft(self, q: Array) -> Array:
        """Residuals (n,) of what should be small, by their weights."""
        return self._at(q)[self.record.hard :]

    def _at(self, q: Array) -> Array:
        self._q[:] = q
        self._evaluate(self._library.cardan_position_residuals)
        return self._residuals.copy()

    def _evaluate(self, kernel: Callable[[PositionRecord], int]) -> None:
        with self._around():
            status = kernel(self.record)
        if status:
            raise SolveError(
                f"circuits of '{self.m.model.name}' have no residual at a position that a search "
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
        record.rank, record.slack = m.rank, m.slack
        with self._around():
            self._library.cardan_position_begin(record)
            while self._library.cardan_position_solve(record, self._budget) == MORE:
                pass
        turned = ""
        if record.open <= max(MET, m.slack) and (record.turned >= 0 or not record.facings):
            turned = m.turned(self._q)
        return Solution(
            self._q.copy(), record.open, record.cost, record.freedoms, turned, slack=m.slack
        )

    def near(self, guess: Array, length: float) -> Solution | None:
        """The position next to a guess (nq,); None where none is as near as a step promises.

        Args:
            guess: Where a tangent leads.
            length: Of the step along it, without units.
        """
        end = self.solve(guess)
        off = float(np.linalg.norm(self.m.between(guess, end.q)))
        return end if end.met and off <= ASIDE * length + REACHED else None

    def follow(self, q: Array) -> Solution | None:
        """The position that the tangent at another one (nq,) leads to; None where it is far."""
        ahead, *_ = np.linalg.lstsq(self.hard_jacobian(q), -self.hard(q), rcond=LOST)
        length = float(np.linalg.norm(ahead))
        ahead = np.asarray(ahead, dtype=np.float64)
        return self.near(self.m.advance(q, ahead), length) if length < FARTHEST else None

    def search(self, begin: Array) -> Solution:
        """Where a search from a start (nq,) ends; held coordinates have their values to the bit."""
        q = begin.copy()
        for place, value in self._held:
            q[place] = value
        end = self.solve(q)
        if end.met:
            for place, value in self._held:
                if len(value) == 1:
                    end.q[place] = value
        end.q[:] = self.m.nearest(end.q, begin)
        return end


def missed(m: Mechanism, target: Target, q: Array) -> Array:
    """What a position (nq,) misses of a target, without units (n,)."""
    solver = PositionSolver(m, [replace(target, weight=None)])
    return solver.hard(q)[solver.record.kept_count :]


@lru_cache(maxsize=4)
def _library(library: ctypes.CDLL) -> ctypes.CDLL:
    """The kernels with the types of the functions of searches declared.

    Raises:
        BuildError: their records differ from those here.
    """
    for name, structure in (("position", PositionRecord), ("target", TargetRecord)):
        check(library, f"cardan_{name}", structure)
    record = ctypes.POINTER(PositionRecord)
    for name in ("begin", "residuals", "jacobian"):
        getattr(library, f"cardan_position_{name}").argtypes = [record]
    library.cardan_position_length.argtypes = [record]
    library.cardan_position_length.restype = COUNT
    library.cardan_position_solve.argtypes = [record, COUNT]
    return library
