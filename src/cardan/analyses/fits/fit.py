"""Parameters and starts from measured motions, by multiple shooting."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Inputs, checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, near
from ...runtime.models.loaded_model import LoadedModel
from ..gradients.unknowns import start_blocks, start_places
from ..simulation.settings import Values, start
from ..simulation.simulate import simulate
from .division import divided
from .record import Fit
from .samples import Samples, samples_of
from .search import Search
from .shooting import Shooting

SAMPLES = 8  # of a segment at least, by default
MOST_SEGMENTS = 60


@checked
def fit(
    model: LoadedModel,
    data: object,
    *,
    unknown: str | Sequence[str],
    measured: Mapping[str, object] | None = None,
    noise: float | Mapping[str, float] | None = None,
    bounds: Mapping[str, Sequence[float]] | None = None,
    loss: str = "linear",
    segments: str | int = "auto",
    q: Values | ArrayLike | None = None,
    u: Values | ArrayLike | None = None,
    z: Values | ArrayLike | None = None,
    inputs: Inputs | None = None,
    parameters: Values | None = None,
    method: str = "DOP853",
    rtol: float = 1e-9,
    most: int = 60,
    progress: bool | Callable[[float], None] | None = None,
) -> Fit:
    """Parameters and the start of a motion from measurements, by multiple shooting.

    ``fit = model.fit("run.csv", unknown=("m2", "damping", "q0"), measured={"hand.z": "z"})``

    Args:
        model: The model; its parameters are where the search begins.
        data: A mapping with the times ``t`` (nt,) and columns (nt,), or a file .csv; NaN where
            nothing was measured.
        unknown: Names of parameters, and of starts as :meth:`gradient` takes them: ``"q0"``,
            ``"u0"``, ``"x0"``, ``"q0.elbow"``.
        measured: Formula in names of the model -> column, or its values (nt,); by default the
            columns that are coordinates, speeds and outputs.
        noise: Standard deviation of measurements, one number or by formula; its ratios weigh them.
        bounds: Parameter -> (least, most).
        loss: ``"linear"`` for least squares, ``"huber"`` where some samples are wrong.
        segments: Number of runs that the motion is divided into; ``"auto"``: as many as errors
            grow by e^2, and as leave what was measured, at most one for every eight samples and 60.
        q, u, z: Start at the first sample, where the search begins; what is no unknown stays.
        inputs, parameters, method, rtol, progress: As :meth:`simulate` takes them.
        most: Iterations.

    Returns:
        A :class:`cardan.Fit`.

    Raises:
        ArgumentError, ModelError: data or names that do not fit the model, and what has no
            gradient. SolveError: no run from where the search begins.

    Source: Bock (1983).
    """
    if loss not in ("linear", "huber"):
        raise ArgumentError(f"fit: loss='{loss}': give 'linear' or 'huber'")
    model = model if parameters is None else model.with_parameters(parameters)
    samples = samples_of(model, data, measured, noise)
    chosen, places = _unknowns(model, unknown)
    limits = _bounds(chosen, bounds)
    nodes = _nodes(samples, segments)
    values = np.array([model.parameters[name] for name in chosen])
    shooting = Shooting(model, samples, nodes, chosen, inputs, method, rtol)
    first = _first_nodes(shooting, start(model, None, q, u, z).x, values)
    if segments == "auto":
        begins = divided(shooting, first, values)
        shooting = replace(shooting, nodes=(*(nodes[k] for k in begins), nodes[-1]))
        first = first[begins]
    search = Search(shooting, places, limits, loss, values)
    return search.run(first, values, most, progress)


def _unknowns(
    model: LoadedModel, unknown: str | Sequence[str]
) -> tuple[tuple[str, ...], dict[str, slice]]:
    """Names of parameters, and where unknown starts are."""
    names = (unknown,) if isinstance(unknown, str) else tuple(unknown)
    places = start_places(model) | start_blocks(model)
    chosen, starts = [], {}
    for name in names:
        if name in model.parameters:
            chosen.append(name)
        elif name in places:
            starts[name] = places[name]
        else:
            candidates = [*model.parameters, *places]
            raise ModelError(
                f"fit: unknown: '{name}' is no parameter and no start.{near(name, candidates)}"
            )
    if not names:
        raise ArgumentError("fit: unknown is empty; name parameters or starts, such as 'q0'")
    return tuple(dict.fromkeys(chosen)), starts


def _bounds(chosen: tuple[str, ...], bounds: Mapping[str, Sequence[float]] | None) -> Array:
    limits = np.tile([-np.inf, np.inf], (len(chosen), 1))
    for name, pair in (bounds or {}).items():
        if name not in chosen:
            raise ArgumentError(
                f"fit: bounds: '{name}' is no unknown parameter.{near(name, chosen)}"
            )
        ends = np.asarray(pair, dtype=float)
        if ends.shape != (2,) or not ends[0] < ends[1]:
            raise ArgumentError(f"fit: bounds of '{name}': {brief(pair)}: give (least, most)")
        limits[chosen.index(name)] = ends
    return limits


def _nodes(samples: Samples, segments: str | int) -> tuple[int, ...]:
    count = len(samples.t) - 1
    number = min(MOST_SEGMENTS, max(1, count // SAMPLES)) if segments == "auto" else segments
    if not isinstance(number, int) or not 1 <= number <= count:
        raise ArgumentError(
            f"fit: segments={brief(segments)}: give 'auto' or a number from 1 to {count}"
        )
    return tuple(int(k) for k in np.round(np.linspace(0, count, number + 1)))


def _first_nodes(shooting: Shooting, first: Array, values: Array) -> Array:
    """States at the nodes: measured coordinates and their slopes, the rest along the first run."""
    model, samples = shooting.model, shooting.samples
    t, names = samples.t, samples.formulas
    begin = first.copy()
    # entries that were not measured come from a run with the first values, if there is one
    run = None
    if len(shooting.nodes) > 2:
        try:
            present = dict(zip(shooting.parameters, values, strict=True))
            run = simulate(
                model, t_eval=t[list(shooting.nodes[:-1])], x0=begin, inputs=shooting.inputs,
                parameters=present, method=shooting.method, rtol=1e-6, progress=False,
            ).x  # fmt: skip
        except SolveError:
            run = None
    # the first one is the start that was named; others begin where the measurements are
    states = []
    for number, node in enumerate(shooting.nodes[:-1]):
        x = begin.copy() if run is None or len(run) <= number else run[number].copy()
        for k, name in enumerate(names if number else ()):
            column, present_rows = samples.values[:, k], samples.present[:, k]
            if name in model.coordinates and present_rows[node]:
                place = model.coordinates.index(name)
                x[place] = column[node]
                slope = np.gradient(column[present_rows], t[present_rows])
                at = int(np.count_nonzero(present_rows[:node]))
                for speed, joint in enumerate(model.manifest.joints):
                    if joint.q == (place, 1) and joint.u is not None and joint.u[1] == 1:
                        del speed
                        x[model.nq + joint.u[0]] = slope[at]
            elif name in model.speeds and present_rows[node]:
                x[model.nq + model.speeds.index(name)] = column[node]
        states.append(x)
    return np.array(states)
