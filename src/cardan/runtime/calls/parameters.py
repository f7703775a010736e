"""Parameter values of a compiled model by their dotted names."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ModelError, named, near
from ...schema.entries import LimitRow
from ...schema.manifest import Manifest
from .argument_values import common, numbers


class Parameters(Mapping[str, float]):
    """Ordered, read-only: name -> value in SI units. Prints as a table with units."""

    def __init__(self, manifest: Manifest, values: ArrayLike | None = None) -> None:
        self._rows = manifest.parameters
        self._structural = manifest.structural
        self._place = {row.name: k for k, row in enumerate(self._rows)}
        self._values = np.array(
            [row.default for row in self._rows] if values is None else values, dtype=np.float64
        )
        self._values.flags.writeable = False
        self._limits = ParameterLimits(manifest.limits, self._place)
        self.judge(self._values)

    @property
    def vector(self) -> Array:
        """The values in the order of the manifest, (np,); read-only."""
        return self._values

    def __getitem__(self, name: str) -> float:
        if name not in self._place:
            raise KeyError(f"parameter '{name}' does not exist.{near(name, self._place)}")
        return float(self._values[self._place[name]])

    def __iter__(self) -> Iterator[str]:
        return iter(self._place)

    def __len__(self) -> int:
        return len(self._place)

    def __repr__(self) -> str:
        width = max((len(name) for name in self._place), default=0)
        lines = [f"{name:{width}}  {self[name]:12.6g} {self.unit(name)}" for name in self]
        return "\n".join(line.rstrip() for line in lines) or "no parameters"

    def unit(self, name: str) -> str:
        """Unit of a parameter."""
        return str(self._rows[self._place[name]].unit)

    def changed(self, values: Mapping[str, ArrayLike]) -> Array:
        """The vector with some values replaced; values of shape (...) give (..., np).

        Raises:
            ModelError: unknown or structural name; a value that is not finite, or that an element
                cannot have; a negative mass.
        """
        named_values = named("parameters", values, "'mass': 1.0")
        read = {name: self.checked(name, value) for name, value in named_values.items()}
        lead = common("parameters", {name: value.shape for name, value in read.items()})
        result = np.broadcast_to(self._values, (*lead, len(self))).copy()
        for name, value in read.items():
            result[..., self._place[name]] = value
        self.judge(result)
        return result

    def judge(self, values: Array) -> None:
        """Refuse numbers that elements cannot have.

        Args:
            values: (..., np), in the order of the manifest.

        Raises:
            ModelError: what the element said where the scene was written.
        """
        for k in np.flatnonzero(self._limits.exceeded(values)):
            self._limits.refuse(int(k), values)

    def checked(self, name: str, value: ArrayLike, what: str = "value") -> Array:
        """Values (...) that a parameter may have; ``what`` one of several is, for messages.

        Raises:
            ModelError: unknown or structural name; a value that is not finite; a negative mass.
        """
        if name in self._structural:
            raise ModelError(
                f"parameter '{name}' is structural: its value {self._structural[name]} is built "
                "into the equations. Declare it with model.parameter(name, value), and leave it "
                "out of specialize=, to set it later"
            )
        if name not in self._place:
            names = [*self._place, *self._structural]
            raise ModelError(f"parameter '{name}' does not exist.{near(name, names)}")
        array = numbers(f"parameter '{name}'", value)
        if not np.isfinite(array).all():
            bad = np.argwhere(~np.isfinite(array))[0]
            where = f" at {tuple(map(int, bad))}" if array.ndim else ""
            raise ModelError(f"parameter '{name}' must be finite, not {array[tuple(bad)]}{where}")
        # the number written as the mass of a body, under the name the model gave it
        if name.endswith(".mass") and self.unit(name) == "kg" and (array < 0).any():
            bad = np.argwhere(array < 0)[0]
            where = f" ({what} {bad[0]} of {len(array)}, from 0)" if array.ndim else ""
            raise ModelError(
                f"parameter '{name}' is a mass and cannot be {array[tuple(bad)]:g} kg{where}"
            )
        return array


class ParameterLimits:
    """Rows of limits as arrays.

    Args:
        rows: Of the manifest.
        places: Name of a parameter -> its entry in the vector of all.

    Raises:
        ModelError: a row names no parameter.
    """

    def __init__(self, rows: Sequence[LimitRow], places: Mapping[str, int]) -> None:
        names = {row.parameter for row in rows} | {
            row.least for row in rows if isinstance(row.least, str)
        }
        if unknown := sorted(names - places.keys()):
            raise ModelError(
                f"manifest.json: limits name '{unknown[0]}', which the model does not have as a "
                "parameter. Compile or export it again"
            )
        self._rows = rows
        self._parameter = np.array([places[row.parameter] for row in rows], dtype=int)
        self._scale = np.array([row.scale for row in rows])
        # one row of values gives either the least number or the parameter that has it
        named = [row.least if isinstance(row.least, str) else None for row in rows]
        self._other = np.array([0 if name is None else places[name] for name in named], dtype=int)
        pairs = zip(rows, named, strict=True)
        self._times = np.array([0.0 if name is None else row.times for row, name in pairs])
        self._least = np.array([_least(row) for row in rows])
        self._most = np.array([np.inf if row.most is None else row.most for row in rows])
        self._open = np.array([row.open for row in rows], dtype=bool)
        self._below = np.array([row.below for row in rows], dtype=bool)
        self._nonzero = np.array([row.nonzero for row in rows], dtype=bool)

    def exceeded(self, values: Array) -> Array:
        """Limits that are exceeded by any of the vectors (..., np)."""
        if not self._rows:
            return np.zeros(0, dtype=bool)
        bad = self._bad(values)
        return np.asarray(bad.any(axis=tuple(range(bad.ndim - 1))))

    def refuse(self, k: int, values: Array) -> None:
        """Refuse the first vector that exceeds a limit.

        Raises:
            ModelError: what the element said where the scene was written.
        """
        row = self._rows[k]
        one = tuple(map(int, np.argwhere(self._bad(values)[..., k])[0]))
        value, low = (x[(*one, k)] for x in self._numbers(values))
        message = row.message.replace("{value}", f"{value:g}").replace("{other}", f"{low:g}")
        where = f" at {one}" if one else ""
        raise ModelError(f"parameter '{row.parameter}'{where}: {row.element}: {message}")

    def _numbers(self, values: Array) -> tuple[Array, Array]:
        """The quantities, and what they may be least (..., number of limits)."""
        quantities = values[..., self._parameter] * self._scale
        return quantities, self._least + values[..., self._other] * self._times

    def _bad(self, values: Array) -> Array:
        quantities, low = self._numbers(values)
        bad = (quantities < low) | (quantities > self._most)
        bad |= self._open & (quantities == low)
        bad |= self._below & (quantities == self._most)
        return np.asarray(bad | (self._nonzero & (quantities == 0)))


def _least(row: LimitRow) -> float:
    """The least number; 0 where a parameter has it, and -inf where there is none."""
    if isinstance(row.least, str):
        return 0.0
    return -np.inf if row.least is None else row.least
