"""Nodes between the segments of a fit, and the states that the search begins with there."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arrays import Array
from ...errors import ArgumentError, SolveError, SolveWarning, brief
from ...runtime.models.loaded_model import LoadedModel
from ...schema.blocks import of_rate
from ..identification.base_parameters import circuits
from ..mechanisms.nodal_mechanism import NodalMechanism
from ..simulation.settings import Values, start
from ..simulation.simulate import simulate
from .samples import Samples
from .shooting import Shooting, Trial

SAMPLES = 8  # of a segment at least, by default
MOST_SEGMENTS = 60
Locked = dict[str, tuple[str, ...]]
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


def first_states(shooting: Shooting, begin: Begin) -> Array:
    """States (segments, nx) that the search begins with.

    Measured coordinates and their slopes, the rest along the run from the first state. In that
    one, what is not unknown stays.

    Args:
        shooting: The samples and the nodes.
        begin: q, u and z of the start as they were named.
    """
    model, nodes = shooting.model, list(shooting.nodes[:-1])
    direct, slopes = (one[nodes] for one in _measured(model, shooting.samples))
    named = start(model, None, *begin)
    # measurements are better than what was named, slopes of them than what nobody has named
    names = (*model.coordinates, *model.speeds, *model.internals)
    unknown = np.isin(speed_places(model), shooting.free)
    nobody = np.array([name in named.defaulted for name in names], dtype=np.bool_)
    direct[0, ~unknown] = slopes[0, ~(unknown & nobody)] = np.nan
    measured = np.where(np.isfinite(direct), direct, slopes)
    first = np.where(np.isfinite(measured[0]), measured[0], named.x)
    trial = Trial(replace(shooting, parameters=()), np.zeros(0), np.zeros((1, 0)))
    first = trial.begin(0, first).x
    states = np.tile(first, (len(nodes), 1))
    if len(nodes) > 1 and not np.isfinite(measured[1:]).all():
        run = _run(shooting, first, nodes)
        states[: len(run)] = run
    for k in range(1, len(states)):
        states[k] = _with(trial, k, states[k], measured[k])
    return np.array([trial.begin(k, x).x for k, x in enumerate(states)])


def _with(trial: Trial, number: int, x: Array, measured: Array) -> Array:
    """A state (nx,) with entries as they were measured (nx,), the others where this is NaN.

    In absolute coordinates nodes and beams go along with the joints, as strained as they are.
    """
    shooting, present = trial.shooting, np.isfinite(measured)
    model = shooting.model
    result = np.where(present, measured, x)
    if not model.manifest.absolute or not present.any():
        return result
    joints = NodalMechanism(model, *trial.time_and_inputs(number))
    unstrained, there = (
        np.concatenate([*joints.state(*model.parts_of(one)[:2]), one[model.nq + model.nu :]])
        for one in (x, result)
    )
    strain = shooting.increments(unstrained[None], x[None])
    strain[:, 2 * model.nu :] = 0.0
    return np.where(present, measured, shooting.moved(there[None], strain)[0])


def locked_names(model: LoadedModel, begin: Begin, free: NDArray[np.intp]) -> Locked | None:
    """Names of coordinates and speeds that a start with loops is given by; None of a tree.

    Args:
        model: The model.
        begin: q, u and z of the start as they were named.
        free: Places of unknown starts along the speeds.

    Raises:
        ModelError: a name that the model does not have.
    """
    start(model, None, *begin)
    if not circuits(model):
        return None
    names, places = {"q": model.coordinates, "u": model.speeds}, speed_places(model)
    locked = {}
    for block, stated, first in zip("qu", begin, (0, model.nq), strict=False):
        slots = model.manifest.slots(block)
        everything = {} if stated is None else dict.fromkeys(names[block])
        keys = stated if isinstance(stated, Mapping) else everything
        # coordinates that follow by formulas have no place
        stated_places = [slots[key] for key in keys if key in slots]
        named = {k for place in stated_places for k in range(*place.indices(len(names[block])))}
        unknown = {k for k in range(len(names[block])) if places[first + k] in free}
        locked[block] = tuple(names[block][k] for k in sorted(named | unknown))
    return locked


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


def _measured(model: LoadedModel, samples: Samples) -> tuple[Array, Array]:
    """States (nt, nx) as far as they were measured, and speeds by slopes (nt, nx), else NaN."""
    direct = np.full((len(samples.t), model.nx), np.nan)
    slopes, places = direct.copy(), speed_places(model)
    entries = {n: k for k, n in enumerate((*model.coordinates, *model.speeds, *model.internals))}
    for name, column in zip(samples.formulas, samples.values.T, strict=True):
        place, present = entries.get(name, -1), np.isfinite(column)
        if place < 0 or not present.any():
            continue
        direct[:, place] = _interpolated(samples.t, column)
        if place < model.nq and places[place] >= 0 and np.count_nonzero(present) > 1:
            rates = np.full(len(column), np.nan)
            rates[present] = np.gradient(column[present], samples.t[present])
            slopes[:, model.nq + places[place]] = _interpolated(samples.t, rates)
    return direct, slopes


def _interpolated(t: Array, column: Array) -> Array:
    """A column (nt,) by straight lines where nothing was measured, NaN before and behind."""
    present = np.isfinite(column)
    return np.interp(t, t[present], column[present], left=np.nan, right=np.nan)


def speed_places(model: LoadedModel) -> list[int]:
    """Place along the speeds (nx,) of every entry of the state; -1 of one that is not a direction.

    Such are coordinates of rotations in space.
    """
    rates = [row.of or of_rate(str(row.name)) for row in model.manifest.speeds]
    places = [rates.index(name) if name in rates else -1 for name in model.coordinates]
    return [*places, *range(model.nu, 2 * model.nu + model.nz)]
