"""Derivatives of functions against differences of these."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...schema.blocks import COORDINATES, DIRECTIONS
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


def _weights(trial: Trial, name: str, of: str) -> Array:
    """Random weights, or a direction, (n, k)."""
    size = len(trial.model._function(name, of).entry.vector)
    return np.random.default_rng(9).uniform(-1, 1, (len(trial.reference.q), size))


def _splits(trial: Trial, request: Request) -> dict[str, slice]:
    """Where the columns along each block or name are, by its name."""
    places, start = {}, 0
    for name in request.wrt:
        block = {"q": "u", COORDINATES: "q"}.get(name, name)
        single = name == "t" or name not in DIRECTIONS
        count = len(trial.model.manifest.parameters if block == "p" else ())
        size = 1 if single else count or len(trial.model._layout.names(block))
        places[name] = slice(start, start + size)
        start += size
    return places


def _rates(trial: Trial, places: Mapping[str, slice], way: Array) -> dict[str, Array]:
    """Rates of blocks along a way of all columns; of what cannot be moved here the way is 0."""
    rates: dict[str, Array] = {}
    for name, place in places.items():
        if name not in LETTERS or (name == "q" and not trial.knows("qdot")):
            way[:, place] = 0.0
            continue
        if name == COORDINATES:
            way[:, place] = _tangential(trial, way[:, place])
        rate = trial.along_speeds(way[:, place]) if name == "q" else way[:, place]
        block = "q" if name == COORDINATES else name
        rates[block] = rates.get(block, 0.0) + rate
    return rates


def _ways_of(
    trial: Trial, request: Request
) -> tuple[dict[str, slice], list[tuple[Array, dict[str, Array]]]]:
    """Random ways of all columns and the rates along them."""
    places = _splits(trial, request)
    total = max((place.stop for place in places.values()), default=0)
    listed = ways(len(trial.reference.q), total)
    return places, [(way, _rates(trial, places, way)) for way in listed]


def vjp(trial: Trial, of: str) -> float | str:
    """The gradient of a weighted sum, against slopes of the function."""
    request = Request.read(of)
    if (request.function, request.of) not in trial.callable_keys or trial.redundant:
        return ELSEWHERE
    weights, worst = _weights(trial, "vjp", of), np.nan
    gradient = trial.call("vjp", of, {"v": weights})
    n = len(gradient)
    scale = np.abs(gradient).max(axis=-1, initial=0.0)
    for way, rates in _ways_of(trial, request)[1]:
        if rates:
            slope, off = trial.slope(request.function, request.of, rates)
            total = (slope.reshape(n, -1) * weights).sum(axis=-1, keepdims=True)
            expected = (gradient.reshape(n, -1) * way).sum(axis=-1)
            terms = np.abs(slope.reshape(n, -1) * weights).max(axis=-1, initial=0.0)
            worst = worst_of(worst, missing(total, off, expected, scale, terms))
    return worst if not np.isnan(worst) else ELSEWHERE


def jvp(trial: Trial, of: str) -> float | str:
    """The change along a direction, against the slope there."""
    request = Request.read(of)
    if (request.function, request.of) not in trial.callable_keys or trial.redundant:
        return ELSEWHERE
    worst = np.nan
    for way, rates in _ways_of(trial, request)[1]:
        if rates:
            slope, off = trial.slope(request.function, request.of, rates)
            value = trial.call("jvp", of, {"v": way})
            worst = worst_of(worst, missing(slope, off, value.reshape(slope.shape)))
    return worst if not np.isnan(worst) else ELSEWHERE


def hessian(trial: Trial, of: str) -> float | str:
    """Second derivatives, against slopes of the gradient: the mean of both orders."""
    request = Request.read(of)
    if ("vjp", of) not in trial.callable_keys or trial.redundant:
        return ELSEWHERE
    v = {"v": _weights(trial, "hessian", of)}
    matrix = trial.call("hessian", of, v)
    n, size = len(matrix), matrix.shape[-1]
    (a, rates_a), (b, rates_b) = _ways_of(trial, request)[1]
    if not rates_a:
        return ELSEWHERE
    slopes, offs = [], []
    for rates, other in ((rates_a, b), (rates_b, a)):
        slope, off = trial.slope("vjp", of, rates, v)
        slopes.append((slope.reshape(n, size) * other).sum(axis=-1, keepdims=True))
        offs.append(off)
    value = np.einsum("ni,nij,nj->n", a, matrix, b)
    scale = np.abs(matrix).max(axis=(1, 2), initial=0.0)
    return missing(0.5 * (slopes[0] + slopes[1]), np.maximum(*offs), value, scale)


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
    "hessian": hessian,
    "jvp": jvp,
    "rhs_jacobian": rhs_jacobian,
    "strain_balance": strain,
    "strain_energy": strain,
    "vjp": vjp,
}
