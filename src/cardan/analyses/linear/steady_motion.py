"""A motion that was trimmed, as a record."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING, Any

from ...arrays import Array
from ...records import dataclass
from ..systems.dynamic_system import Moment, NamedState
from .first_order import Choice

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

MAX_PRINTED = 24
ROUNDED = 1e-12  # values below this are printed as none


@dataclass(frozen=True, repr=False, eq=False)
class SteadyMotionRecord(NamedState):
    """A steady motion with target values, or a rest: ``found["steer"]`` is a value by name.

    A run starts there, ``found.model.simulate(10, x0=found, inputs=found.inputs)``; so do
    ``linearize`` and ``modes``.

    Attributes:
        model: The model, with the parameters that were found.
        x: State [q, u, z] (nx,).
        free: What was free and its value: inputs, parameters, speeds, forces.
        targets: Requested values, by name.
        inputs: All inputs by name.
        t: Time [s].
        free_motions: Coordinates of which any value would do: they stay as they started.
        iterations: Linear systems solved.
        converged: Whether it is one.
        message: The same as a sentence.
        trim_arguments: As ``trim`` takes it, beginning here: to find it anew.
        at, tau, choice: For analyses that go on from here.
    """

    model: LoadedModel
    x: Array
    free: Mapping[str, float]
    targets: Mapping[str, float]
    inputs: Mapping[str, float]
    t: float
    free_motions: tuple[str, ...]
    iterations: int
    converged: bool
    message: str
    trim_arguments: Mapping[str, Any] = field(repr=False)
    at: Moment = field(repr=False)
    tau: Array = field(repr=False)
    choice: Choice = field(repr=False)

    @property
    def named(self) -> dict[str, float]:
        """All coordinates, speeds, internal states and free values by name."""
        model = self.model
        names = (*model.coordinates, *model.speeds, *model.internals)
        return {**dict(zip(names, self.x.tolist(), strict=True)), **self.free}

    def __repr__(self) -> str:
        lines = [f"'{self.model.name}': {self.message}"]
        named_values = {**self.targets, **self.free}
        values = {
            n: v
            for n, v in self.named.items()
            if n not in named_values and n not in self.free_motions
        }
        stop = self.model.nq + self.model.nu
        printed = [(n, v) for n, v in list(values.items())[:stop] if abs(v) > ROUNDED][:MAX_PRINTED]
        lines += [f"  {name} = {value:.10g}  (target)" for name, value in self.targets.items()]
        lines += [f"  {name} = {value:.10g}  (free)" for name, value in self.free.items()]
        lines += [f"  {name} = {value:.10g}" for name, value in printed]
        return "\n".join(lines)
