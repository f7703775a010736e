"""Projection onto the constraints in runs without a compiler."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..runtime.closing import CLOSED, Closing, Level
from . import record as abi
from .plain_methods import Broken

if TYPE_CHECKING:
    from ..runtime.loaded import LoadedFunction
    from .plain import PlainRunner

Array = NDArray[np.float64]


class PlainCloser:
    """What ``kernels/close.c`` does, with the same bounds.

    Attributes:
        closing: The constraints.
        numbers: The ledger (4 (positions + rates),): before, when, after, when.
    """

    def __init__(self, runner: PlainRunner) -> None:
        self.runner, model = runner, runner.model
        self.closing = Closing.of(model)
        self.functions = {name: model._function(name) for name in self.closing.functions}
        self.numbers = np.zeros(4 * (self.closing.positions + self.closing.rates))

    def close(self, t: float, y: Array, noted: bool) -> None:
        """Normalize and project y (n,) at t in place; ``correction`` says by how much.

        Args:
            t, y: Time and state.
            noted: Whether the residuals go into the ledger.

        Raises:
            Broken: it does not close, or a function has no result.
        """
        run, nq, nx = self.runner.record, self.runner.model.nq, self.runner.nx
        self.runner.normalize(y)
        run.correction, run.open_row = 0.0, -1
        if not self.closing.rows:
            return
        given = y[:nx].copy()
        self.runner.at(t, y)
        size = self.closing.size
        if self.closing.positions:
            self._level("close_position", t, y, slice(0, nq), size, noted)
        speeds = slice(nq, nq + self.runner.model.nu)
        fastest = max(1.0, float(np.abs(y[speeds]).max(initial=0.0)))
        self._level("close_velocity", t, y, speeds, size * fastest, noted)
        how = self.runner.settings
        scale = how.atol + how.rtol * np.maximum(np.abs(given), np.abs(y[:nx]))
        run.correction = float(np.sqrt(np.mean(((y[:nx] - given) / scale) ** 2)))

    def between(self, t: float, y: Array) -> None:
        """Project what a polynomial says; where that does not close it stays as it is."""
        try:
            self.close(t, y, noted=False)
        except Broken as broken:
            if broken.answer != abi.OPEN:
                raise

    def _level(
        self, name: str, t: float, y: Array, place: slice, scale: float, noted: bool
    ) -> None:
        """Newton steps for coordinates or speeds."""
        function, size = self.functions[name], place.stop - place.start
        level = Level(
            lambda block: self._call(function, t, y, place, block),
            size,
            scale,
            lambda block: self._put(y, place, block),
        )
        block, after, before = level.close(y[place].copy())
        y[place] = block
        first = 0 if name == "close_position" else self.closing.positions
        rows = self.numbers.reshape(-1, 4)[first : first + len(after)]
        run, worst = self.runner.record, int(np.argmax(np.abs(after)))
        run.open_row = first + worst
        if not abs(after[worst]) <= CLOSED * scale:
            raise Broken(abi.OPEN)
        for column, residuals in ((0, before), (2, after)) if noted else ():
            larger = np.abs(residuals) > rows[:, column]
            rows[larger, column], rows[larger, column + 1] = np.abs(residuals)[larger], t

    def _put(self, y: Array, place: slice, block: Array) -> Array:
        """A block as it is in y after normalization."""
        y[place] = block
        self.runner.normalize(y)
        return y[place].copy()

    def _call(
        self, function: LoadedFunction, t: float, y: Array, place: slice, block: Array
    ) -> Array:
        y[place] = block
        self.runner.record.projections += 1
        entries = sum(int(np.prod(output["shape"])) for output in function.outputs)
        result = np.empty(entries)
        self.runner.call(function, t, y, result)
        return result
