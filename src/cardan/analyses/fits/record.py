"""What a fit has found."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ...arrays import Array
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord


@dataclass(frozen=True, eq=False)
class Fit:
    """A fit of a model to measurements.

    Attributes:
        model: The model with the parameters that were found.
        parameters: Them by name.
        start: State [q, u, z] (nx,) at the first sample.
        standard_errors: Of every unknown by name, infinite where the data do not tell.
        names: Of the unknowns: those of the start, then parameters.
        covariance: Of the unknowns (k, k), in this order.
        residuals: Measured less computed, channel by channel (nt,).
        sigma: Standard deviation of the residuals over the noise: 1 where the noise was right.
        durbin_watson: Of every channel: near 2 where residuals are independent; far below, the
            standard errors are too small.
        undetermined: Combinations of unknowns that the data do not tell: name -> change, of
            parameters as a part of their value.
        motion: The motion from the start, in one run.
        segments: Runs that the motion was divided into.
        cost: Half the sum of the squares of all residuals over the noise.
        iterations: Linear problems solved.
        converged: Whether it is a minimum.
        message: The same as a sentence.
    """

    model: LoadedModel = field(repr=False)
    parameters: dict[str, float]
    start: Array
    standard_errors: dict[str, float]
    names: tuple[str, ...]
    covariance: Array = field(repr=False)
    residuals: dict[str, Array] = field(repr=False)
    sigma: float
    durbin_watson: dict[str, float]
    undetermined: tuple[dict[str, float], ...]
    motion: TrajectoryRecord = field(repr=False)
    segments: int
    cost: float
    iterations: int
    converged: bool
    message: str

    @property
    def correlation(self) -> Array:
        """Of the unknowns (k, k)."""
        deviations = np.sqrt(np.diag(self.covariance))
        with np.errstate(invalid="ignore"):
            return np.asarray(self.covariance / np.outer(deviations, deviations))

    def __str__(self) -> str:
        lines = [f"fit of '{self.model.name}': {self.message}"]
        for name in self.names:
            error = self.standard_errors[name]
            value = self.parameters.get(name)
            text = "" if value is None else f"{value:.8g} "
            lines.append(f"  {name:24} {text}+- {error:.2g}")
        for one in self.undetermined:
            terms = " ".join(f"{x:+.3g} {name}" for name, x in one.items())
            lines.append(f"  the data do not tell {terms}")
        return "\n".join(lines)
