"""Nodes between the segments of a fit, and the states that the search begins with there."""

from __future__ import annotations

import warnings

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arrays import Array
from ...errors import ArgumentError, SolveError, SolveWarning, brief
from ...runtime.models.loaded_model import LoadedModel
from ..simulation.settings import Values, start
from ..simulation.simulate import simulate
from .samples import Samples
from .shooting import Shooting

SAMPLES = 8  # of a segment at least, by default
MOST_SEGMENTS = 60
ROUGH = 1e-6  # tolerance of a run that only says where states are about
Begin = tuple[Values | ArrayLike | None, ...]


def nodes_of(samples: Samples, segments: str | int) -> tuple[int, ...]:
    """Numbers of the samples at which segments begin, and of the last one.

    Raises:
        ArgumentError: more segments than samples, or none.
    """
    count = len(samples.t) - 1
    number = min(MOST_SEGMENTS, max(1, count // SAMPLES)) if segments == "auto" else segments
    if not isinstance(number, int) or not 1 <= number <= count:
        raise ArgumentError(
            f"fit: segments={brief(segments)}: give 'auto' or a number from 1 to {count}"
        )
    return tuple(int(k) for k in np.round(np.linspace(0, count, number + 1)))


def first_states(shooting: Shooting, begin: Begin, free: NDArray[np.intp]) -> Array:
    """States (segments, nx) that the search begins with.

    Measured coordinates and their slopes, the rest along the run from the first state. In that
    one, what was named stays, and so does what is no unknown.

    Args:
        shooting: The samples and the nodes.
        begin: q, u and z of the start as they were named.
        free: Places of unknown starts along the speeds.
    """
    model, nodes = shooting.model, list(shooting.nodes[:-1])
    known = _measured(model, shooting.samples)[nodes]
    named = start(model, None, *begin)
    # where nobody said where an unknown start is, the measurements do
    names = (*model.coordinates, *model.speeds, *model.internals)
    places = _places(model)
    stays = [n not in named.defaulted or p not in free for n, p in zip(names, places, strict=True)]
    known[0, stays] = named.x[stays]
    first = np.where(np.isfinite(known[0]), known[0], named.x)
    states = np.tile(first, (len(nodes), 1))
    if len(nodes) > 1 and not np.isfinite(known[1:]).all():
        run = _run(shooting, first, nodes)
        states[: len(run)] = run
    return np.where(np.isfinite(known), known, states)


def _run(shooting: Shooting, first: Array, nodes: list[int]) -> Array:
    """States at the nodes along one run, as far as it goes (m, nx)."""
    t = shooting.samples.t[nodes]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SolveWarning)
        try:
            return np.asarray(
                simulate(
                    shooting.model, t_eval=t, x0=first, inputs=shooting.inputs,
                    method=shooting.method, rtol=ROUGH, progress=False,
                ).x
            )  # fmt: skip
        except SolveError:
            return first[None, :]


def _measured(model: LoadedModel, samples: Samples) -> Array:
    """States (nt, nx) as far as they were measured or are slopes of what was, else NaN."""
    known = np.full((len(samples.t), model.nx), np.nan)
    rates = {joint.q: joint.u for joint in model.manifest.joints if joint.u is not None}
    columns = dict(zip(samples.formulas, samples.values.T, strict=True))
    for name, column in columns.items():
        present = np.isfinite(column)
        if name in model.coordinates and present.any():
            place = model.coordinates.index(name)
            known[:, place] = _between(samples.t, column)
            speed = rates.get((place, 1))
            if speed is not None and speed[1] == 1 and np.count_nonzero(present) > 1:
                slopes = np.full(len(column), np.nan)
                slopes[present] = np.gradient(column[present], samples.t[present])
                known[:, model.nq + speed[0]] = _between(samples.t, slopes)
    # what was measured itself is better than a slope
    for name, column in columns.items():
        if name in model.speeds and np.isfinite(column).any():
            known[:, model.nq + model.speeds.index(name)] = _between(samples.t, column)
    return known


def _between(t: Array, column: Array) -> Array:
    """A column (nt,) by straight lines where nothing was measured, NaN before and behind."""
    present = np.isfinite(column)
    return np.interp(t, t[present], column[present], left=np.nan, right=np.nan)


def _places(model: LoadedModel) -> list[int]:
    """Place along the speeds (nx,) of every entry of the state; -1 of a coordinate without one."""
    places = [-1] * model.nq
    for joint in model.manifest.joints:
        if joint.q is not None and joint.u is not None and joint.q[1] == joint.u[1] == 1:
            places[joint.q[0]] = joint.u[0]
    return [*places, *range(model.nu, 2 * model.nu + model.nz)]
