"""The record of an assembled mechanism."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import numpy as np
from numpy.typing import DTypeLike

from ...arrays import Array
from ...errors import ModelError, counted, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel

LISTED = 24


@dataclass(frozen=True, repr=False, eq=False)
class AssemblyRecord:
    """A consistent state of a mechanism: positions, speeds and accelerations that loops allow.

    Attributes:
        model: The model.
        t, r: Time [s] and inputs (nr,) of it.
        q, u, udot: Coordinates (nq,), speeds (nu,), accelerations (nu,); udot is None where the
            model has no function ``forward_dynamics``.
        gaps: Cut joint or constraint -> what is left open: a distance [m], and anything else [1].
        unreached: Target that need not be held -> what is reached instead, in words.
        freedoms: Degrees of freedom that loops and held targets leave.
        solutions: Different positions found; None where a freedom is left, as there are many.
        starts: Searches begun.
        energy: Strain energy [J]; None where it was not asked to be least. Then ``u`` is 0, udot
            None, and freedoms are motions that nothing strained resists.
        holding_forces: Held coordinate -> force that holds it [N, N m], by strain energy.
    """

    model: LoadedModel
    t: float
    r: Array
    q: Array
    u: Array
    udot: Array | None
    gaps: Mapping[str, tuple[float, float]]
    unreached: Mapping[str, str]
    freedoms: int
    solutions: int | None
    starts: int
    energy: float | None = None
    holding_forces: Mapping[str, float] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """Name of the model."""
        return self.model.name

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of q."""
        return self.model.coordinates

    @property
    def speeds(self) -> tuple[str, ...]:
        """Names of u."""
        return self.model.speeds

    @property
    def x(self) -> Array:
        """State [q, u] (nx,), as ``simulate(x0=...)`` takes it."""
        return np.concatenate([self.q, self.u])

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Array:
        return np.array(self.x, dtype=dtype)

    def __getitem__(self, name: str) -> float:
        """A coordinate, or a speed such as ``elbow.u``, by name.

        Raises:
            ModelError: no such name.
        """
        for names, values in ((self.coordinates, self.q), (self.speeds, self.u)):
            for entry in (name, name.removesuffix(".u")):
                if entry in names and (entry == name or names is self.speeds):
                    return float(values[names.index(entry)])
        entries = [*self.coordinates, *self.speeds]
        raise ModelError(f"assembly['{name}']: there is no such entry.{near(name, entries)}")

    def __repr__(self) -> str:
        lines = [
            f"assembly of '{self.name}': {self._description}, "
            f"{counted(self.freedoms, 'freedom')} left"
        ]
        lines += _values("q", self.coordinates, self.q)
        if np.any(self.u):
            lines += _values("u", self.speeds, self.u)
        for joint, (length, other) in self.gaps.items():
            angle_text = f" and {other:.1e}" if other else ""
            lines.append(f"  loop of '{joint}' closed to {length:.1e} m{angle_text}")
        lines += [f"  target '{name}' not reached: {said}" for name, said in self.unreached.items()]
        lines += [f"  '{n}' is held by {force:.6g}" for n, force in self.holding_forces.items()]
        return "\n".join(lines)

    @property
    def _description(self) -> str:
        if self.energy is not None:
            return f"least strain energy, {self.energy:.6g} J"
        texts = {None: "one of many positions", 1: "the only position found"}
        description = texts.get(self.solutions, f"1 of {self.solutions} positions found")
        return f"{description} from {counted(self.starts, 'start')}"


def _values(letter: str, names: tuple[str, ...], values: Array) -> list[str]:
    entries = [f"{n} = {v:.9g}" for n, v in zip(names, values.tolist(), strict=True)]
    more = [f"and {len(entries) - LISTED} more"] if len(entries) > LISTED else []
    return [f"  {letter}  {', '.join([*entries[:LISTED], *more])}"]
