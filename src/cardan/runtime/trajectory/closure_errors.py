"""Closure errors of the loops of a run."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, final

import numpy as np

from ...arrays import Array
from ...records import dataclass
from ...schema.entries import MultiplierRow

if TYPE_CHECKING:
    from .trajectory import TrajectoryRecord


@dataclass(frozen=True)
class Worst:
    """The largest residuals of a constraint over a run.

    Attributes:
        before: Largest residual of a step before it was projected, and when [s].
        after: Largest residual of a state that was kept, and when [s].
        unit: Of the residuals.
    """

    before: float
    before_at: float
    after: float
    after_at: float
    unit: str

    def __str__(self) -> str:
        return (
            f"{self.after:.1e} {self.unit or '-'} (at {self.after_at:.6g} s; "
            f"{self.before:.1e} before projection)"
        )


@final
@dataclass(frozen=True)
class Ledger:
    """Residuals of all constraints over a run; empty without loops.

    Attributes:
        position, velocity: Multiplier name -> :class:`Worst`; velocity rows are the rates of the
            position rows, then the constraints of speeds alone.
    """

    position: dict[str, Worst]
    velocity: dict[str, Worst]

    @classmethod
    def of(cls, rows: Sequence[MultiplierRow], table: Array) -> Ledger:
        """A ledger from the numbers of a run.

        Args:
            rows: Multipliers of the manifest, those of positions first.
            table: (positions + rates, 4): before, when, after, when.
        """
        count = len(table) - len(rows)

        def named(some: Sequence[MultiplierRow], numbers: Array, rate: bool) -> dict[str, Worst]:
            return {
                row.name: Worst(b, b_at, a, a_at, _unit(row.unit, row.level, rate))
                for row, (b, b_at, a, a_at) in zip(some, numbers.tolist(), strict=True)
            }

        return cls(named(rows[:count], table[:count], False), named(rows, table[count:], True))

    @property
    def table(self) -> Array:
        """The numbers, as :meth:`of` takes them (positions + rates, 4)."""
        rows = [*self.position.values(), *self.velocity.values()]
        values = [(w.before, w.before_at, w.after, w.after_at) for w in rows]
        return np.array(values, dtype=np.float64).reshape(-1, 4)

    def worst(self, level: str) -> tuple[str, Worst] | None:
        """Name and :class:`Worst` of the largest residual kept; None without rows.

        Args:
            level: ``"position"`` or ``"velocity"``.
        """
        rows: dict[str, Worst] = getattr(self, level)
        return max(rows.items(), key=lambda item: item[1].after, default=None)

    def __repr__(self) -> str:
        lines = []
        for level in ("position", "velocity"):
            lines += [f"{level} {name}: {w}" for name, w in getattr(self, level).items()]
        return "\n".join(lines)


def residual_unit(row: MultiplierRow) -> str:
    """Unit of a residual, at the level where it holds first, from that of its multiplier.

    Args:
        row: Of the multipliers of the manifest: a force belongs to a length.
    """
    return _unit(row.unit, row.level, False)


@cache
def _unit(unit: str, level: str, rate: bool) -> str:
    """Unit of a residual or of its rate, from that of its multiplier; few are there, rows many."""
    moved = {"N": "m", "N*m": "rad"}.get(unit)
    if moved is None:
        moved = unit.removeprefix("J").removeprefix("/(").removesuffix(")")
    elif level != "position":
        return f"{moved}/s"
    return f"{moved or '1'}/s" if rate and level == "position" else moved


def residuals_of(motion: TrajectoryRecord) -> dict[str, Array]:
    """Residual (nt,) of every constraint of positions by multiplier."""
    rows = [row for row in motion.manifest.multipliers if row.level == "position"]
    if rows and "constraints" not in motion.stored:
        model = motion._model("the constraints")
        motion.stored["constraints"] = model._evaluate(
            ("constraints", None), (motion.t, motion.q, motion._r), None, None
        )
    return {row.name: motion.stored["constraints"][:, k] for k, row in enumerate(rows)}


def multipliers_of(motion: TrajectoryRecord) -> dict[str, Array]:
    """History (nt,) of every multiplier [N, N m].

    Those that the method found along with the motion, else those of the accelerations at its
    states. Where rows follow from others their forces are not unique: then one set of them.
    """
    rows = motion.manifest.multipliers
    if rows and "multipliers" not in motion.stored:
        model = motion._model("the multipliers")
        motion.stored["multipliers"] = model.multipliers(
            motion.q, motion.u, t=motion.t, r=motion._r, **motion._arguments
        )
    return {row.name: motion.stored["multipliers"][:, k] for k, row in enumerate(rows)}
