"""Constraints of a model as the runs see them, and the projection of states onto them."""

from __future__ import annotations

import ctypes
from contextlib import nullcontext
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError
from ...records import dataclass
from ...schema.entries import MultiplierRow
from ...schema.records import Run, check
from ..calls.interpreted import called_back
from ..trajectory.closure_errors import Ledger
from .finite_elements.frames import node_frames

if TYPE_CHECKING:
    from .loaded_model import LoadedModel

CLOSED = 1e-11  # residuals relative to the size that are enough, as in kernels/run/close.c
MOST_SIZES = 64  # that are remembered
MAX_WATCHED = 4_000_000  # entries of the rows of elements that runs watch: 32 MB of memory each


@dataclass(frozen=True)
class Closing:
    """Constraint residuals and scales of a model.

    Attributes:
        rows: Multipliers of the manifest, those of positions first.
        size: Of the mechanism, against which residuals count [m].
        watched: Whether runs look out for places where branches meet: of elements those of scenes
            that are not too large for it.
    """

    rows: tuple[MultiplierRow, ...]
    size: float
    watched: bool = True

    @classmethod
    def of(cls, model: LoadedModel) -> Closing:
        """Constraints of a model that states are projected onto; none for a tree."""
        rows = tuple(model.manifest.multipliers)
        if not model.manifest.projected:
            rows = ()
        meshed = model.manifest.absolute
        few = len(rows) * model.nu <= MAX_WATCHED
        return cls(rows, size_of(model) if rows or meshed else 1.0, few or not meshed)

    def unwatched(self) -> Closing:
        """The same for a method that passes places where branches meet by itself."""
        return replace(self, watched=False)

    def loosened(self, tolerance: float) -> Closing:
        """The same where residuals up to a slack, without units, count as none."""
        return replace(self, size=self.size * max(1.0, tolerance / CLOSED))

    @cached_property
    def positions(self) -> int:
        """Number of constraints of positions."""
        return sum(row.level == "position" for row in self.rows)

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
        return Ledger.of(self.rows, numbers.reshape(-1, 4)) if self.rows else None

    def row(self, k: int) -> tuple[str, str]:
        """Level (``position`` or ``velocity``) and multiplier name of a row of the ledger."""
        level = "position" if k < self.positions else "velocity"
        return level, self.rows[k if k < self.positions else k - self.positions].name


def size_of(model: LoadedModel) -> float:
    """Size of a mechanism [m]: the longest way between two joints of a body or along a beam, or
    the largest radius or length of a joint; 1 without any."""
    if model._size is None:
        model._size = _measured(model)
    return model._size


def _measured(model: LoadedModel) -> float:
    """The size from the saved scene."""
    function = model.manifest.elements.frames if model.manifest.absolute else "scene"
    if function not in model.saved:
        return 1.0
    sizes, vector = model._objects.sizes, model.parameters.vector
    size = sizes.get(vector.tobytes())
    if size is None:
        values = model._evaluate_saved(function, p=vector)
        if model.manifest.absolute:
            # where the ground has frames says nothing
            on_nodes = [
                row.node is not None or row.tree is not None for row in model.manifest.frames
            ]
            places = node_frames(model)[1][on_nodes]
        else:
            parts = [np.ravel(values[key]) for key in ("position", "frame_position")]
            places = np.concatenate(parts).reshape(-1, 3)
        lengths = [float(np.linalg.norm(places, axis=1).max(initial=0.0))]
        extents = [
            np.ravel(values[key]) for key in ("lengths", "sizes", "cut_sizes") if key in values
        ]
        lengths += [float(np.abs(some).max(initial=0.0)) for some in extents]
        lengths += [beam.length for beam in model.manifest.beams]
        size = max(lengths) or 1.0
        if len(sizes) >= MOST_SIZES:
            sizes.clear()
        sizes[vector.tobytes()] = size
    return size


def columns_of(model: LoadedModel, size: float) -> Array:
    """Units of the speeds (nu,): sizes of the mechanism, or radians."""
    return np.where(model._layout.lengths, size, 1.0)


def project(model: LoadedModel, t: Array, x: Array, r: Array, s: Array, ledger: Ledger) -> Array:
    """States on the constraints next to given ones.

    Args:
        model: A model with loops.
        t, x, r, s: Times (n,), states (n, nx), inputs (n, nr), discrete states (n, ns).
        ledger: Of the run they belong to: what it let pass is close enough.

    Returns:
        (n, nx); where a state does not close it stays what it was.
    """
    closing = Closing.of(model)
    passed = max((worst.after for worst in ledger.position.values()), default=0.0)
    size = closing.loosened(2 * passed / closing.size).size
    names = closing.functions[: 1 + (closing.positions > 0)]
    functions = [model._function(name) for name in names]
    library = model._kernels()
    check(library, "cardan_run", Run)
    run = Run(nq=model.nq, nu=model.nu, nz=model.nz, nx=model.nx, n=model.nx, nr=model.nr)
    run.ns, run.positions, run.rates, run.size = model.ns, closing.positions, closing.rates, size
    run.atol, quaternions = 1.0, np.array(model.manifest.quaternions, dtype=np.intp)
    for name, function in zip(names, functions, strict=True):
        setattr(run, name, function.address)
        setattr(run, f"{name}_w", function.w.ctypes.data)
    library.cardan_closing_length.restype = ctypes.c_ssize_t
    sizes = {
        "y": model.nx,
        "r": model.nr,
        "s": model.ns,
        "zeros": model.nu + 6 * len(model.manifest.bodies),
        "work": max(function.work_size for function in functions),
        "closing": library.cardan_closing_length(ctypes.byref(run)),
    }
    rooms = {name: np.zeros(count) for name, count in sizes.items()}
    rooms["quaternions"], run.quaternion_count = quaternions, len(quaternions)
    for name, room in rooms.items():
        setattr(run, name, room.ctypes.data)
    if model.manifest.absolute:
        run.mesh = model._source.mesh(model)
    for name, block, count in (("x", x, model.nx), ("r", r, model.nr), ("s", s, model.ns)):
        if block.shape != (len(t), count):
            raise ArgumentError(
                f"{name} of a motion of '{model.name}' has shape {block.shape}, expected "
                f"({len(t)}, {count}): it belongs to another model"
            )
    closed, *rows = (np.array(rows, dtype=np.float64, order="C") for rows in (x, t, r, s))
    pointers = [ctypes.c_void_p(block.ctypes.data) for block in (rows[0], closed, *rows[1:])]
    with called_back() if any(function.interpreted for function in functions) else nullcontext():
        library.cardan_close_states(ctypes.byref(run), ctypes.c_ssize_t(len(t)), *pointers)
    return closed
