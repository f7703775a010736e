"""Inertial parameters from measured motions and forces.

Source: Khalil and Dombre, Modeling, Identification and Control of Robots (2002), chapter 12;
Swevers, Verdonck and De Schutter, Dynamic Model Identification for Industrial Robots, IEEE Control
Systems Magazine 27 (2007).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, checked
from ...arrays import Array
from ...errors import ArgumentError, near
from ...runtime.calls.argument_values import numbers
from ..mechanisms.actuation import named_speeds
from .base_parameters import REQUIRED, Base, base_parameters, circuits, needed
from .data import Data, columns, measured
from .estimate import fitted
from .regression_rows import Rows, of_energy, of_forces
from .result import IdentificationRecord

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

FORMS = ("torque", "energy")
# columns that loops make dependent, seen at measured positions
RANK = 1e-6
# of the forces that the nominal model could take: rounding
NOTHING = 1e-9


@checked
def identify(
    model: LoadedModel,
    data: Any,
    *,
    form: str = "torque",
    noise: float | Mapping[str, float] | ArrayLike | None = None,
    cutoff: float | None = None,
    period: float | None = None,
    harmonics: Count = 5,
    actuators: Sequence[str] | None = None,
    base: Base | None = None,
    stretch: Count = 10,
) -> IdentificationRecord:
    """Base parameters of a model from data, by weighted least squares.

    Args:
        model: Its parameters are those the estimates are compared with.
        data: A Trajectory, a file (of a saved run, or .csv), or a mapping with ``t`` and ``q``,
            ``u``, ``udot``, ``tau``, ``r`` or their columns; speeds and accelerations that are
            missing are found by differentiation. See :func:`.data.measured`.
        form: ``"torque"``: forces at every sample; ``"energy"``: what stretches of the motion have
            gained, which needs no accelerations but keeps less of the information.
        noise: Standard deviation of measured forces, one number or by speed or joint; None: from
            the residuals, for every joint its own.
        cutoff: [Hz] of a low-pass filter without delay on positions, forces and regressor.
        period, harmonics: Of a periodic motion [s]: positions become a Fourier series.
        actuators: Speeds or joints whose forces were measured; all by default. Those of others are
            0 and tell nothing here. With loops as many as freedoms.
        base: Of an earlier call, for the same combinations.
        stretch: Steps of a row of energy, an even number.

    Raises:
        ArgumentError: data that do not fit the model; unknown words.
        SolveError: the data do not tell all base parameters.
    """
    if form not in FORMS:
        raise ArgumentError(f"form='{form}' does not exist.{near(form, FORMS)}")
    energies = ("energy_regressor", "energy", "power") if form == "energy" else ()
    needed(model, "identify", (*energies, *REQUIRED))
    chosen = named_speeds(model, actuators)
    samples = measured(model, data, cutoff=cutoff, period=period, harmonics=harmonics)
    sigma = _noise(model, noise)
    # regressor rows of all samples, weighted by the noise of their channels
    rows = _rows(model, samples, form, cutoff, chosen, stretch, sigma)
    _acting(model, rows)
    if base is None:
        bound = circuits(model)
        base = base_parameters(model, rows.A, rank=RANK) if bound else base_parameters(model)
    if form == "energy":
        # weights hold the noise of the joints already
        deviations = None if sigma is None else np.ones(1)
    else:
        deviations = None if sigma is None else sigma[chosen]
    fit = fitted(base.regressor(rows.A), rows.b, rows.relative_noise, deviations, base.names)
    return IdentificationRecord(
        model,
        base,
        fit.x,
        fit.covariance,
        rows.channels,
        fit.noise,
        rows.t,
        fit.residuals,
        rows.b,
        fit.condition,
        fit.chi,
        form,
    )


def _rows(
    model: LoadedModel,
    samples: Data,
    form: str,
    cutoff: float | None,
    chosen: list[int],
    stretch: int,
    sigma: Array | None,
) -> Rows:
    if form == "energy":
        return of_energy(model, samples, stretch, np.ones(model.nu) if sigma is None else sigma)
    return of_forces(model, samples, cutoff, chosen)


def _acting(model: LoadedModel, rows: Rows) -> None:
    """Nothing is told by motions in which no force acts.

    Raises:
        ArgumentError: all forces are zero.
    """
    nominal = np.abs(list(model.inertial_parameters().values()))
    if np.abs(rows.b).max(initial=0.0) <= NOTHING * (np.abs(rows.A) @ nominal).max(initial=0.0):
        names = list(columns(model)["tau"])
        raise ArgumentError(
            "identify: there are no forces in the data: give tau (nt, nu), or columns such as "
            f"'{names[0]}'; of a run the forces are those of the motors in the model. Motion alone "
            "would fit a robot without mass"
        )


def _noise(model: LoadedModel, noise: object) -> Array | None:
    """Standard deviation of forces along every speed (nu,).

    Raises:
        ArgumentError: one is missing or not positive.
    """
    if noise is None:
        return None
    if isinstance(noise, Mapping):
        deviations = np.zeros(model.nu)
        for name, value in noise.items():
            deviations[named_speeds(model, [name])] = value
    else:
        values = numbers("noise", noise)
        if values.shape not in ((), (1,), (model.nu,)):
            raise ArgumentError(
                f"noise has shape {values.shape}, expected () or ({model.nu},): a number for every "
                "speed, or one for all"
            )
        deviations = np.broadcast_to(values, (model.nu,)).copy()
    if not np.all(deviations > 0):
        raise ArgumentError("noise: a positive number for every speed is wanted, or one for all")
    return deviations
