"""Results of fits."""

from __future__ import annotations

from dataclasses import field

import numpy as np

from ...arguments import checked
from ...arrays import Array
from ...errors import ArgumentError, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord

# of one channel in a hundred, residuals that are independent look like others
ONE_PERCENT = 2.576
LEVEL = 0.95


@dataclass(frozen=True, eq=False, repr=False)
class FitRecord:
    """A fit of a model to measurements.

    Attributes:
        model: The model with the parameters that were found.
        parameters: Them by name.
        start: State [q, u, z] (nx,) at the first sample.
        names: Of the unknowns: those of the start, then parameters.
        values: Of the unknowns by name; of a start along a rotation in space nan.
        standard_errors: Of every unknown by name, infinite where the data cannot determine it.
        covariance: Of the unknowns (k, k), in this order.
        t: Times of the samples (nt,).
        measured: The samples, channel by channel (nt,); nan where nothing was measured.
        residuals: Measured less computed, channel by channel (nt,).
        sigma: Standard deviation of the residuals over the noise: 1 where the noise was right.
        freedom: Number of residuals less that of unknowns.
        durbin_watson: Of every channel: near 2 where residuals are independent; far below, the
            standard errors are too small.
        undetermined: Combinations of unknowns that the data cannot determine: name -> change, of
            parameters as a part of their value.
        at_bounds: Parameters that their bounds hold. Their standard errors are infinite, those of
            the others are for these held.
        motion: The motion from the start, in one run.
        segments: Runs that the motion was divided into.
        cost: Half the sum of the squares of all residuals over the noise.
        iterations: Linear problems solved.
        converged: Whether it is a minimum.
        interrupted: Whether Ctrl-C ended the search.
        message: The same as a sentence.
    """

    model: LoadedModel
    parameters: dict[str, float]
    start: Array
    names: tuple[str, ...]
    values: dict[str, float]
    standard_errors: dict[str, float]
    covariance: Array = field(repr=False)
    t: Array
    measured: dict[str, Array]
    residuals: dict[str, Array]
    sigma: float
    freedom: int
    durbin_watson: dict[str, float]
    undetermined: tuple[dict[str, float], ...]
    at_bounds: tuple[str, ...]
    motion: TrajectoryRecord
    segments: int
    cost: float
    iterations: int
    converged: bool
    interrupted: bool
    message: str

    @property
    def correlation(self) -> Array:
        """Of the unknowns (k, k)."""
        deviations = np.sqrt(np.diag(self.covariance))
        with np.errstate(invalid="ignore"):
            return np.asarray(self.covariance / np.outer(deviations, deviations))

    @checked
    def interval(self, name: str, level: float = LEVEL) -> tuple[float, float]:
        """Confidence interval of an unknown, by the t distribution.

        Args:
            name: Of the unknown.
            level: Part of all fits to such data whose interval contains the truth.

        Raises:
            ArgumentError: no unknown of that name, or no level.
        """
        if name not in self.names:
            raise ArgumentError(f"interval: '{name}' was not an unknown.{near(name, self.names)}")
        if not 0 < level < 1:
            raise ArgumentError(f"interval: level={level:g}: give a number between 0 and 1")
        from scipy.special import stdtrit

        width = float(stdtrit(self.freedom, (1 + level) / 2)) * self.standard_errors[name]
        return self.values[name] - width, self.values[name] + width

    @property
    def serially_correlated(self) -> tuple[str, ...]:
        """Channels whose residuals depend on those before them, by Durbin and Watson, at 1 %.

        The model misses something there, and standard errors are too small.
        """
        return tuple(
            name
            for name, number in self.durbin_watson.items()
            if 2 - number > 2 * ONE_PERCENT / np.sqrt(np.isfinite(self.residuals[name]).sum())
        )

    def __repr__(self) -> str:
        lines = [f"fit of '{self.model.name}': {self.message}"]
        width = max(map(len, self.names))
        lines += [f"  {'':{width}}  {'estimate':>13} {'+-':>9}  95 % interval"]
        for name in self.names:
            low, high = self.interval(name)
            error = self.standard_errors[name]
            if np.isnan(low):
                # along a rotation in space: no number of its own
                lines.append(f"  {name:{width}}  {'':13} {error:9.2g}")
            else:
                row = f"  {name:{width}}  {self.values[name]:13.8g} {error:9.2g}"
                lines.append(f"{row}  {low:.6g} ... {high:.6g}")
        lines += [f"  the data cannot determine {one}" for one in self.combinations]
        lines += [f"  {name} is held by its bound" for name in self.at_bounds]
        tests = [f"{name} {number:.2f}" for name, number in self.durbin_watson.items()]
        lines.append(f"sigma {self.sigma:.4g}, Durbin-Watson {', '.join(tests)}")
        if self.serially_correlated:
            names = ", ".join(self.serially_correlated)
            lines.append(
                f"residuals of {names} are serially correlated: the model misses something, and "
                "the true errors are larger than the standard errors"
            )
        return "\n".join(lines)

    @property
    def combinations(self) -> tuple[str, ...]:
        """Combinations that the data cannot determine, as text."""
        return tuple(
            " ".join(f"{x:+.3g} {name}" for name, x in one.items()) for one in self.undetermined
        )
