"""Parameter values of a compiled model by their dotted names."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ModelError, named, near
from ...schema.manifest import Manifest
from .calling import common, numbers


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
        self._limits = manifest.limits
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
        for limit in self._limits:
            value, least = limit.scale * values[..., self._place[limit.parameter]], limit.least
            low = limit.times * values[..., self._place[least]] if isinstance(least, str) else least
            low = np.full_like(value, -np.inf if low is None else low)
            most = np.inf if limit.most is None else limit.most
            bad = (value < low) | (value > most)
            if limit.open:
                bad |= value == low
            if limit.below:
                bad |= value == most
            if bad.any():
                one = tuple(np.argwhere(bad)[0])
                message = limit.message.replace("{value}", f"{value[one]:g}")
                message = message.replace("{other}", f"{low[one]:g}")
                where = f" at {tuple(map(int, one))}" if one else ""
                name = limit.parameter
                raise ModelError(f"parameter '{name}'{where}: {limit.element}: {message}")

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
