"""Constraints of a model as the runs see them, and the projection onto them in NumPy.

Source: as of ``kernels/close.c``, whose bounds these are.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ..ir.rows import column
from .absolute.frames import standing
from .calling import Array
from .ledger import Ledger
from .rotations import unit

if TYPE_CHECKING:
    from .compiled import CompiledModel

SOUGHT, CLOSED = 1e-15, 1e-11  # residuals relative to the size: what is sought, what is enough
MOST_STEPS = 8
MOST_SIZES = 64  # that are remembered


@dataclass(frozen=True)
class Closing:
    """What closes the circuits of a model.

    Attributes:
        rows: Multipliers of the manifest, those of positions first.
        size: Of the mechanism, against which residuals count [m].
        watched: Whether runs look out for places where branches meet.
    """

    rows: tuple[dict[str, Any], ...]
    size: float
    watched: bool = True

    @classmethod
    def of(cls, model: CompiledModel) -> Closing:
        """Constraints of a model that states are projected onto; none for a tree."""
        rows = tuple(model.manifest.get("multipliers", ()))
        if not model.manifest.get("projected", True):
            rows = ()
        meshed = "mesh" in model.manifest
        return cls(rows, size_of(model) if rows or meshed else 1.0, not meshed)

    def loosened(self, slack: float) -> Closing:
        """The same where residuals up to a slack, without units, count as none."""
        return replace(self, size=self.size * max(1.0, slack / CLOSED))

    @cached_property
    def positions(self) -> int:
        """Number of constraints of positions."""
        return sum(row["level"] == "position" for row in self.rows)

    @property
    def rates(self) -> int:
        """Number of constraints of velocities: all of them."""
        return len(self.rows)

    @property
    def functions(self) -> tuple[str, ...]:
        """The functions of the model that project."""
        if not self.rows:
            return ()
        watch = ("constraint_jacobian",) if self.watched else ()
        close = ("close_position", "close_velocity") if self.positions else ("close_velocity",)
        return (*close, *watch)

    def ledger(self, numbers: Array) -> Ledger | None:
        """The ledger of a run from its numbers (4 (positions + rates),)."""
        return Ledger.of(list(self.rows), numbers.reshape(-1, 4)) if self.rows else None

    def row(self, k: int) -> tuple[str, str]:
        """Level (``position`` or ``velocity``) and multiplier name of a row of the ledger."""
        level = "position" if k < self.positions else "velocity"
        return level, str(self.rows[k if k < self.positions else k - self.positions]["name"])


def size_of(model: CompiledModel) -> float:
    """Size of a mechanism [m]: the longest way between two joints of a body or along a beam, or
    the largest radius or length of a joint; 1 without any."""
    if model._size is None:
        model._size = _measured(model)
    return model._size


def _measured(model: CompiledModel) -> float:
    """The size from the saved scene."""
    told = "scene" if "mesh" not in model.manifest else str(model.manifest["mesh"]["frames"])
    if told not in model.saved:
        return 1.0
    known, vector = model._objects.sizes, model.parameters.vector
    size = known.get(vector.tobytes())
    if size is None:
        found = model._evaluate_saved(told, p=vector)
        if "mesh" in model.manifest:
            # where the ground has frames says nothing
            carried = [row["node"] is not None for row in model.manifest["frames"]]
            places = standing(model)[1][carried]
        else:
            parts = [np.ravel(found[key]) for key in ("position", "frame_position")]
            places = np.concatenate(parts).reshape(-1, 3)
        lengths = [float(np.linalg.norm(places, axis=1).max(initial=0.0))]
        own = [np.ravel(found[key]) for key in ("lengths", "sizes", "cut_sizes") if key in found]
        lengths += [float(np.abs(some).max(initial=0.0)) for some in own]
        lengths += [float(beam["length"]) for beam in model.manifest.get("beams", ())]
        size = max(lengths) or 1.0
        if len(known) >= MOST_SIZES:
            known.clear()
        known[vector.tobytes()] = size
    return size


def columns_of(model: CompiledModel, size: float) -> Array:
    """What every speed counts in (nu,): sizes of the mechanism, or radians."""
    units = column(model.manifest["speeds"], "unit")
    return np.array([size if name == "m/s" else 1.0 for name in units])


@dataclass(frozen=True)
class Level:
    """Coordinates or speeds with the function that closes them.

    Attributes:
        function: Block (..., size) -> (..., size + rows): the closed block, then residuals of the
            given one.
        size: Length of the block.
        scale: Against which residuals count.
        finish: What every new block goes through.
    """

    function: Callable[[Array], Array]
    size: int
    scale: float
    finish: Callable[[Array], Array]

    def close(self, block: Array) -> tuple[Array, Array, Array]:
        """Newton steps until residuals vanish or no longer fall.

        Args:
            block: (..., size).

        Returns:
            The closed block, its residuals (..., rows), and those before.
        """
        last: Array = np.full(block.shape[:-1], np.inf)
        first: Array | None = None
        for k in range(MOST_STEPS + 1):
            found = self.function(block)
            residuals = found[..., self.size :]
            first = residuals if first is None else first
            worst = np.abs(residuals).max(axis=-1, initial=0.0) / self.scale
            # a first step from far away may go up before it goes down
            going = (worst > SOUGHT) & (worst < np.inf) & ((worst <= 0.5 * last) | (k == 1))
            if not going.any():
                break
            block = np.where(going[..., None], self.finish(found[..., : self.size]), block)
            last = np.where(going, worst, last)
        assert first is not None
        return block, residuals, first


def project(model: CompiledModel, t: Array, x: Array, r: Array, s: Array, ledger: Ledger) -> Array:
    """States on the constraints next to given ones.

    Args:
        model: A model with circuits.
        t, x, r, s: Times (n,), states (n, nx), inputs (n, nr), discrete states (n, ns).
        ledger: Of the run they belong to: what it let pass is close enough.

    Returns:
        (n, nx); where a state does not close it stays what it was.
    """
    closing = Closing.of(model)
    passed = max((worst.after for worst in ledger.position.values()), default=0.0)
    closing = closing.loosened(2 * passed / closing.size)
    quaternions = model.manifest["quaternions"]
    q, u, z = model.parts_of(x)
    if closing.positions:
        level = Level(
            lambda q: _closed(model, "close_position", t, q, r),
            model.nq,
            closing.size,
            lambda q: unit(q, quaternions),
        )
        closed, residuals, _ = level.close(q)
        q = np.where(np.abs(residuals).max(axis=-1)[:, None] <= CLOSED * closing.size, closed, q)
    scale = closing.size * max(1.0, float(np.abs(u).max(initial=0.0)))
    level = Level(
        lambda u: _closed(model, "close_velocity", t, q, u, r, z, s),
        model.nu,
        scale,
        np.asarray,
    )
    return np.concatenate([q, level.close(u)[0], z], axis=-1)


def _closed(model: CompiledModel, name: str, *values: Array) -> Array:
    return model._evaluate((name, None), values, None, None)
