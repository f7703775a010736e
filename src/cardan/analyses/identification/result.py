"""Results of an identification."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arguments import checked
from ...arrays import Array, Booleans
from ...errors import ArgumentError, near
from ...records import dataclass
from .base_parameters import Base
from .nearest_parameters import nearest

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...runtime.models.loaded_model import LoadedModel

# standard deviations below this part of the estimate: it is known well
WELL = 0.1
# eigenvalues of pseudo-inertias below this, relative to the largest, belong to no body
CONSISTENT = 1e-9


@dataclass(frozen=True, repr=False, eq=False)
class IdentificationRecord:
    """Estimates of base parameters with their covariance.

    Attributes:
        nominal: The model the data were held against, with its own parameters (CAD).
        base: Which combinations of inertial parameters were estimated.
        estimates: Of the base parameters (nb,).
        covariance: Of the estimates (nb, nb).
        channels: What was measured (c,).
        noise: Standard deviation of every channel (c,) [N m], [N] or [J].
        t, residuals: Measured less estimated (m,), (m, c); filtered where the data were.
        measured: What was measured, less forces that do not depend on inertial parameters (m, c).
        condition: Of the scaled and weighted base regressor.
        chi: Mean square of weighted residuals: 1 where the noise is as it was given.
        form: ``"torque"`` or ``"energy"``.
    """

    nominal: LoadedModel
    base: Base
    estimates: Array
    covariance: Array = field(repr=False)
    channels: tuple[str, ...]
    noise: Array
    t: Array
    residuals: Array
    measured: Array
    condition: float
    chi: float
    form: str

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the base parameters (nb,); ``base.expressions`` holds their definitions."""
        return self.base.names

    @property
    def deviations(self) -> Array:
        """Standard deviations of the estimates (nb,)."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))

    @property
    def relative(self) -> Array:
        """Standard deviations relative to the estimates (nb,)."""
        return np.asarray(self.deviations / np.maximum(np.abs(self.estimates), 1e-300))

    @property
    def well(self) -> Booleans:
        """Mask of the parameters known to within a tenth of their value (nb,)."""
        return np.asarray(self.relative < WELL)

    @cached_property
    def expected(self) -> Array:
        """Base parameters of the nominal model (nb,)."""
        return self.base.of(list(self.nominal.inertial_parameters().values()))

    def __getitem__(self, name: str) -> float:
        """Estimate of one base parameter.

        Raises:
            ArgumentError: there is none of that name.
        """
        if name not in self.names:
            raise ArgumentError(f"'{name}' is not a base parameter here.{near(name, self.names)}")
        return float(self.estimates[self.names.index(name)])

    @checked
    def interval(self, name: str, deviations: float = 1.96) -> tuple[float, float]:
        """Confidence interval of a base parameter, 95 % by default."""
        value = self[name]
        width = deviations * float(self.deviations[self.names.index(name)])
        return value - width, value + width

    @cached_property
    def parameters(self) -> dict[str, float]:
        """Parameters of the model for ``with_parameters``: the least change that has the estimates.

        What data cannot tell stays as near to the nominal model as it can. Where a model has fewer
        parameters (exact zeros of a scene are none), the nearest it can have.
        """
        return self.nearest_to(self.nominal)

    def nearest_to(self, model: LoadedModel, only: Sequence[str] | None = None) -> dict[str, float]:
        """The same for another model of the same bodies, and some of its parameters alone.

        Args:
            model: Whose values they are nearest to.
            only: Names of the parameters that may change; by default all.

        Raises:
            ArgumentError: it has other inertial parameters.
        """
        if tuple(model.inertial_parameters()) != self.base.parameters:
            raise ArgumentError(
                f"the identification is of '{self.base.name}', whose bodies and forces are others "
                f"than those of '{model.name}'"
            )
        # of the covariance C = L Lᵀ: errors times the inverse of L have variance 1
        root = np.linalg.inv(np.linalg.cholesky(self.covariance))
        return nearest(model, self.base, self.estimates, root, only)

    @cached_property
    def model(self) -> LoadedModel:
        """The model with the identified parameters."""
        return self.nominal.with_parameters(self.parameters)

    @property
    def missed(self) -> float:
        """Distance of the identified model from the estimates: root mean square of deviations."""
        identified = self.base.of(list(self.model.inertial_parameters().values()))
        return float(np.sqrt(np.mean(((identified - self.estimates) / self.deviations) ** 2)))

    @cached_property
    def implausible(self) -> tuple[str, ...]:
        """Bodies of the identified model that no distribution of mass can be."""
        return implausible(self.model)

    @property
    def explained(self) -> Array:
        """Part of the measured forces, squared, that the estimates explain (c,).

        Negative where more is left over than there was, as of joints that nothing drives.
        """
        total = (self.measured**2).sum(axis=0)
        unexplained = (self.residuals**2).sum(axis=0)
        return np.asarray(1 - unexplained / np.where(total > 0, total, 1.0))

    def __repr__(self) -> str:
        head = (
            f"'{self.nominal.name}': {len(self.base)} base parameters from {self.residuals.size} "
            f"equations of {'forces' if self.form == 'torque' else 'energy'}, "
            f"condition {self.condition:.3g}"
        )
        width = max((len(name) for name in self.names), default=0)
        lines = [head, f"  {'':{width}}  {'estimate':>11} {'+-':>9} {'%':>7} {'nominal':>11}"]
        columns = (self.estimates, self.deviations, self.relative, self.expected)
        rows = zip(self.names, *columns, strict=True)
        for name, value, deviation, part, nominal in rows:
            percent = f"{100 * part:7.1f}" if part < 10 else "      -"
            lines.append(
                f"  {name:{width}}  {value:11.5g} {deviation:9.2g} {percent} {nominal:11.5g}"
            )
        parts = zip(self.channels, self.noise, self.explained, strict=True)
        noise = [f"{name} {sigma:.3g}{_explained(part)}" for name, sigma, part in parts]
        lines.append("noise: " + ", ".join(noise))
        poor = int(np.sum(~self.well))
        lines.append(f"{len(self.base) - poor} known to {WELL:.0%} of themselves, {poor} worse")
        return "\n".join(lines)


def _explained(part: float) -> str:
    """In words, where there was something to explain: no force on a passive joint."""
    return f" ({100 * part:.2f} % explained)" if part > 0 else ""


def implausible(model: LoadedModel) -> tuple[str, ...]:
    """Bodies of a model that no distribution of mass can be."""
    phi = model.inertial_parameters()
    names = [name.removesuffix(".mass") for name in phi if name.endswith(".mass")]
    return tuple(name for name in names if not _consistent(phi, name))


def _consistent(phi: dict[str, Any], body: str) -> bool:
    """True when some distribution of mass has these ten numbers: the pseudo-inertia is positive.

    Source: Wensing, Kim and Slotine, IEEE Robotics and Automation Letters 3 (2018).
    """
    xx, yy, zz, xy, xz, yz = (phi[f"{body}.{e}"] for e in ("xx", "yy", "zz", "xy", "xz", "yz"))
    second = np.array([[0, -xy, -xz], [-xy, 0, -yz], [-xz, -yz, 0]])
    second += np.diag([(yy + zz - xx) / 2, (xx + zz - yy) / 2, (xx + yy - zz) / 2])
    moment = np.array([phi[f"{body}.moment_{axis}"] for axis in "xyz"])
    pseudo_inertia = np.zeros((4, 4))
    pseudo_inertia[:3, :3], pseudo_inertia[:3, 3], pseudo_inertia[3, :3] = second, moment, moment
    pseudo_inertia[3, 3] = phi[f"{body}.mass"]
    values = np.linalg.eigvalsh(pseudo_inertia)
    return bool(values[0] >= -CONSISTENT * max(abs(values[-1]), 1e-300))


@checked
def plot(identification: IdentificationRecord, path: str | Path | None = None) -> Figure:
    """Measured and estimated histories as a Matplotlib figure, written to ``path`` if given."""
    from ...view.plot import plot_over

    curves = {}
    for k, name in enumerate(identification.channels):
        pair = [
            identification.measured[:, k],
            identification.measured[:, k] - identification.residuals[:, k],
        ]
        curves[name] = np.column_stack(pair)
    title = f"{identification.nominal.name}: measured [0] and estimated [1]"
    return plot_over(title, "t [s]", identification.t, curves, path)
