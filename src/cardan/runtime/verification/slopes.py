"""Derivatives of functions against differences of these."""

from __future__ import annotations

import numpy as np

from ...schema.blocks import COORDINATES
from ...schema.request import Request
from .differences import missing, ways, worst_of
from .evaluation import ELSEWHERE, Trial
from .joint_motion import Array, times

LETTERS = ("t", "q", COORDINATES, "u", "z", "udot", "tau", "r")


def derivative(trial: Trial, of: str) -> float | str:
    """A derivative of a function by blocks, inputs and parameters."""
    request = Request.read(of)
    name, owner = request.function, request.of
    if (name, owner) not in trial.callable_keys or trial.redundant:
        return ELSEWHERE
    flat, at, worst, count = trial.call("derivative", of), 0, np.nan, 0
    entry = trial.model._function("derivative", of).outputs
    for output in entry:
        letter, size = output.name.removeprefix("d_"), int(np.prod(output.shape))
        part, at = flat[:, at : at + size], at + size
        if letter not in LETTERS or (letter == "q" and not trial.knows("qdot")):
            continue
        worst = worst_of(worst, _columns(trial, name, owner, letter, part))
        count += 1
    return worst if count else ELSEWHERE


def _columns(trial: Trial, name: str, of: str | None, letter: str, part: Array) -> float:
    """The columns of one block, added up along random ways."""
    block = "q" if letter == COORDINATES else letter
    n, size = len(part), len(trial.model._layout.names(block)) if letter != "t" else 1
    size = trial.model.nu if letter == "q" else size
    if not size:
        return 0.0
    columns, worst = part.reshape(n, part[0].size // size, size), np.nan
    scale = np.abs(columns).max(axis=(1, 2), initial=0.0)
    for way in ways(n, size):
        way = _tangential(trial, way) if letter == COORDINATES else way
        rate = trial.along_speeds(way) if letter == "q" else way
        slope, off = trial.slope(name, of, {block: rate})
        worst = worst_of(worst, missing(slope, off, times(columns, way), scale))
    return worst


def strain(trial: Trial, of: str | None) -> float | str:
    """Forces of strains, made of wrenches, against the slope of their energy, less Gᵀ lam; g."""
    if not trial.knows("strain_energy", "strain_balance", "qdot"):
        return ELSEWHERE
    model, n, worst = trial.model, len(trial.reference.q), np.nan
    lam, value = trial.blocks["lam"], trial.call("strain_balance")
    force, gaps = value[:, : model.nu], value[:, model.nu :]
    if lam.shape[-1]:
        if not trial.knows("constraint_jacobian", "constraints"):
            return ELSEWHERE
        force = force + times(np.swapaxes(trial.call("constraint_jacobian"), -1, -2), lam)
        if not np.abs(gaps - trial.call("constraints")).max(initial=0.0) <= 1e-9:
            return 1.0
    scale = np.maximum(1.0, np.abs(force).max(axis=1, initial=0.0))
    for way in ways(n, model.nu) if model.nu else ():
        slope, off = trial.slope("strain_energy", None, {"q": trial.along_speeds(way)})
        work = (force * way).sum(axis=-1)
        worst = worst_of(worst, missing(slope.reshape(n, 1), off, work, scale))
    return worst


def rhs_jacobian(trial: Trial, of: str | None) -> float | str:
    """By the state as it is stored, by t and by inputs."""
    if not trial.knows("rhs") or trial.redundant:
        return ELSEWHERE
    model, n = trial.model, len(trial.reference.q)
    nx, nr = model.nx, model.nr
    flat, worst = trial.call("rhs_jacobian"), np.nan
    by_x, by_t, by_r = np.split(flat, [nx * nx, nx * nx + nx], axis=-1)
    matrix = by_x.reshape(n, nx, nx)
    scale = np.abs(matrix).max(axis=(1, 2), initial=0.0)
    for way in ways(n, nx):
        rates = dict(zip("quz", model.parts_of(_tangential(trial, way)), strict=True))
        slope, off = trial.slope("rhs", None, rates)
        direction = np.concatenate(list(rates.values()), axis=-1)
        worst = worst_of(worst, missing(slope, off, times(matrix, direction), scale))
    slope, off = trial.slope("rhs", None, {"t": np.ones((n, 1))})
    worst = worst_of(worst, missing(slope, off, by_t, scale))
    for way in ways(n, nr) if nr else ():
        slope, off = trial.slope("rhs", None, {"r": way})
        worst = worst_of(worst, missing(slope, off, times(by_r.reshape(n, nx, nr), way), scale))
    return worst


def _tangential(trial: Trial, way: Array) -> Array:
    """A way of coordinates or states along which quaternions turn and keep their lengths."""
    way = way.copy()
    for first in trial.model.manifest.quaternions:
        part = slice(first, first + 4)
        quaternion = trial.reference.q[:, part]
        way[:, part] -= quaternion * (quaternion * way[:, part]).sum(axis=-1, keepdims=True)
    return way


JUDGES = {
    "derivative": derivative,
    "rhs_jacobian": rhs_jacobian,
    "strain_balance": strain,
    "strain_energy": strain,
}
