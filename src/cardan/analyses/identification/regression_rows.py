"""Data as linear equations for the inertial parameters: A phi = b plus noise.

Forces: a row per sample and channel. Energies: a row per stretch of time; the energies at its ends
and the powers between need no accelerations.

Source: Gautier, Dynamic Identification of Robots with Power Model, IEEE ICRA (1997).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, SolveError
from ...records import dataclass
from . import smoothing
from .base_parameters import circuits
from .data import Data

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

# singular values of constraints below this part of the largest are those of redundant ones
RANK = 1e-9
# actuators that have less hold of a freedom than this have none
MIN_SINGULAR_VALUE = 1e-6


@dataclass(frozen=True)
class Rows:
    """Equations A phi = b.

    Attributes:
        channels: What is measured: actuators, or the energy.
        t: Time of every sample (nt,).
        A: (nt, channels, n).
        b: (nt, channels).
        relative_noise: Standard deviation of the noise relative to that of its channel (nt,
            channels).
    """

    channels: tuple[str, ...]
    t: Array
    A: Array
    b: Array
    relative_noise: Array


def time_and_inputs(model: LoadedModel, data: Data, states: bool = False) -> dict[str, Any]:
    """Time and inputs of samples for functions of the model; internal states too on request."""
    internal = {"z": data.z if model.nz else None} if states else {}
    return {"t": data.t, "r": data.r if model.nr else None, **internal}


def of_forces(model: LoadedModel, data: Data, cutoff: float | None, actuators: list[int]) -> Rows:
    """Rows of forces; filtered on both sides like the signals where those were.

    Args:
        actuators: Speeds along which forces were measured.
    """
    arguments = time_and_inputs(model, data, states=True)
    phi = np.array(list(model.inertial_parameters().values()))
    A = model.regressor(data.q, data.u, data.udot, **arguments)
    # what does not depend on phi: other forces of the model
    without_parameters = model.inverse_dynamics(data.q, data.u, data.udot, **arguments) - A @ phi
    b = data.tau - without_parameters
    names = tuple(model.speeds[k] for k in actuators)
    if circuits(model):
        back = _through_circuits(model, data, actuators)
        A, b = back @ A, (back @ b[..., None])[..., 0]
    else:
        A, b = A[:, actuators], b[:, actuators]
    t = data.t
    if cutoff is not None:
        step = smoothing.every(t, cutoff)
        A, b = (smoothing.lowpass(t, x, cutoff)[::step] for x in (A, b))
        t = t[::step]
    return Rows(names, t, A, b, np.ones_like(b))


def _through_circuits(model: LoadedModel, data: Data, actuators: list[int]) -> Array:
    """Matrix that turns generalized forces into those of the actuators (nt, na, nu).

    Forces of constraint do no work along the motions Z that are left: Zᵀ tau is what they cannot
    bear, and the actuators must supply it.

    Raises:
        SolveError: more or fewer actuators than freedoms, or they have no hold of one.
    """
    G = model.constraint_jacobian(data.q, **time_and_inputs(model, data))
    _, values, right = np.linalg.svd(G)
    ranks = np.sum(values > RANK * values.max(axis=-1, keepdims=True, initial=1e-300), axis=-1)
    rank = int(ranks.max(initial=0))
    freedoms = model.nu - rank
    if int(ranks.min(initial=rank)) != rank:
        raise SolveError(f"model '{model.name}': the data pass through a singular position")
    if freedoms != len(actuators):
        raise SolveError(
            f"model '{model.name}' has {freedoms} freedoms, but forces of {len(actuators)} "
            "speeds are to tell: name as many actuators= as freedoms, those that were measured"
        )
    Z = np.swapaxes(right[:, rank:], -1, -2)
    actuation = np.swapaxes(Z[:, actuators], -1, -2)
    if np.linalg.svd(actuation, compute_uv=False).min(initial=1.0) < MIN_SINGULAR_VALUE:
        raise SolveError(f"model '{model.name}': these actuators lose hold of the motion")
    return np.asarray(np.linalg.solve(actuation, np.swapaxes(Z, -1, -2)))


def of_energy(model: LoadedModel, data: Data, stretch: int, noise: Array) -> Rows:
    """Rows of energy: what is gained over stretches of samples is what forces have given.

    Args:
        stretch: Steps of a row, an even number.
        noise: Of the forces along every speed, for the weights of the rows (nu,).
    """
    arguments = time_and_inputs(model, data, states=True)
    step = smoothing.step_of(data.t, "form='energy'")
    count = (len(data.t) - 1) // stretch
    if stretch < 2 or stretch % 2 or count < 1:
        raise ArgumentError(
            f"stretch={stretch}: an even number of steps, of which the data have {len(data.t) - 1}"
        )
    phi = np.array(list(model.inertial_parameters().values()))
    E = model.energy_regressor(data.q, data.u, **arguments)
    stored, power = E[:, 0] + E[:, 1], E[:, 2]
    # what does not depend on phi: other forces of the model and their potentials
    rates = model.power(data.q, data.u, **arguments).sum(axis=-1) - power @ phi
    left = model.energy(data.q, data.u, **time_and_inputs(model, data)).total - stored @ phi
    supplied = (data.tau * data.u).sum(axis=-1) + rates
    starts = stretch * np.arange(count)
    # Simpson's rule over each stretch
    weights = np.tile([2.0, 4.0], stretch // 2)
    weights = np.append(weights, 1.0) * step / 3
    weights[0] = step / 3
    places = starts[:, None] + np.arange(stretch + 1)
    A = stored[starts + stretch] - stored[starts] - np.einsum("w,kwn->kn", weights, power[places])
    b = supplied[places] @ weights - (left[starts + stretch] - left[starts])
    scale = np.sqrt(((data.u * noise) ** 2).sum(axis=-1)[places] @ weights**2)
    t = data.t[starts + stretch // 2]
    return Rows(("energy",), t, A[:, None], b[:, None], scale[:, None])
