"""Derivatives of functions against differences of these."""

from __future__ import annotations

import numpy as np

from ...schema.request import Request
from .differences import missing, ways, worst_of
from .evaluation import ELSEWHERE, Asked
from .joint_motion import Array, times

LETTERS = ("t", "q", "u", "z", "udot", "tau", "r")


def derivative(asked: Asked, of: str) -> float | str:
    """A derivative of a function by blocks, inputs and parameters."""
    request = Request.read(of)
    name, own = request.function, request.of
    if (name, own) not in asked.known or asked.redundant:
        return ELSEWHERE
    flat, at, worst, judged = asked.call("derivative", of), 0, np.nan, 0
    entry = asked.model._function("derivative", of).outputs
    for output in entry:
        letter, size = output.name.removeprefix("d_"), int(np.prod(output.shape))
        part, at = flat[:, at : at + size], at + size
        if letter not in LETTERS or (letter == "q" and not asked.knows("qdot")):
            continue
        worst = worst_of(worst, _columns(asked, name, own, letter, part))
        judged += 1
    return worst if judged else ELSEWHERE


def _columns(asked: Asked, name: str, of: str | None, letter: str, part: Array) -> float:
    """The columns of one block, added up along random ways."""
    n, size = len(part), len(asked.model._layout.names(letter)) if letter != "t" else 1
    size = asked.model.nu if letter == "q" else size
    if not size:
        return 0.0
    columns, worst = part.reshape(n, part[0].size // size, size), np.nan
    scale = np.abs(columns).max(axis=(1, 2), initial=0.0)
    for way in ways(n, size):
        rate = asked.along_speeds(way) if letter == "q" else way
        found, off = asked.slope(name, of, {letter: rate})
        worst = worst_of(worst, missing(found, off, times(columns, way), scale))
    return worst


def rhs_jacobian(asked: Asked, of: str | None) -> float | str:
    """By the state as it is stored, by t and by inputs."""
    if not asked.knows("rhs") or asked.redundant:
        return ELSEWHERE
    model, n = asked.model, len(asked.truth.q)
    nx, nr = model.nx, model.nr
    flat, worst = asked.call("rhs_jacobian"), np.nan
    by_x, by_t, by_r = np.split(flat, [nx * nx, nx * nx + nx], axis=-1)
    matrix = by_x.reshape(n, nx, nx)
    scale = np.abs(matrix).max(axis=(1, 2), initial=0.0)
    for way in ways(n, nx):
        rates = dict(zip("quz", model.parts_of(_turning(asked, way)), strict=True))
        found, off = asked.slope("rhs", None, rates)
        whole = np.concatenate(list(rates.values()), axis=-1)
        worst = worst_of(worst, missing(found, off, times(matrix, whole), scale))
    found, off = asked.slope("rhs", None, {"t": np.ones((n, 1))})
    worst = worst_of(worst, missing(found, off, by_t, scale))
    for way in ways(n, nr) if nr else ():
        found, off = asked.slope("rhs", None, {"r": way})
        worst = worst_of(worst, missing(found, off, times(by_r.reshape(n, nx, nr), way), scale))
    return worst


def _turning(asked: Asked, way: Array) -> Array:
    """A way of the state along which quaternions turn and keep their lengths."""
    way = way.copy()
    for first in asked.model.manifest.quaternions:
        own = slice(first, first + 4)
        whole = asked.truth.q[:, own]
        way[:, own] -= whole * (whole * way[:, own]).sum(axis=-1, keepdims=True)
    return way


JUDGES = {"derivative": derivative, "rhs_jacobian": rhs_jacobian}
