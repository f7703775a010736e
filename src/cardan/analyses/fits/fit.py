"""Parameters and starts from measured motions, by multiple shooting."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arguments import Inputs, checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, near
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.node_names import nodes_last
from ...schema.blocks import DIRECTIONS
from ..gradients.differentiable import exact_method
from ..gradients.unknowns import listed, refuse_two_meanings, start_blocks, start_places
from ..identification.base_parameters import circuits
from ..identification.result import IdentificationRecord
from ..simulation.settings import DERIVATIVE_RTOL, Values
from .division import divided
from .joint_start import JointStart
from .nodes import Begin, first_states, locked_names, nodes_of
from .record import FitRecord
from .samples import inputs_of, samples_of, table_of
from .search import Search
from .seeds import seed_models
from .shooting import Shooting

Places = NDArray[np.intp]


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
    seeds: str | IdentificationRecord | None = None,
    q: Values | ArrayLike | None = None,
    u: Values | ArrayLike | None = None,
    z: Values | ArrayLike | None = None,
    inputs: Inputs | None = None,
    parameters: Values | None = None,
    method: str = "auto",
    rtol: float = DERIVATIVE_RTOL,
    most: int = 60,
    progress: bool | Callable[[float], None] | None = None,
) -> FitRecord:
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
        seeds: ``"identify"``: unknown masses, inertias and coefficients of forces begin with what
            :meth:`identify` says of the measured coordinates and the inputs, however far off their
            values are; or an identification, such as ``model.identify(data, cutoff=10)``.
        q, u, z: Start at the first sample, where the search begins; what is not unknown stays. In
            absolute coordinates by names of joints, which nodes follow.
        inputs: As :meth:`simulate` takes them; else columns of data with their names.
        parameters, rtol, progress: As :meth:`simulate` takes them.
        method: As of :meth:`gradient`: ``"auto"`` takes DOP853, of elements Radau.
        most: Iterations.

    Returns:
        A fit: ``parameters``, ``standard_errors``, ``interval(name)``, ``residuals``, ``motion``.

    Raises:
        ArgumentError, ModelError: data or names that do not fit, and what has no gradient.
            SolveError: no run from where the search begins.

    Source: Bock (1983).
    """
    if loss not in ("linear", "huber"):
        raise ArgumentError(f"fit: loss='{loss}': give 'linear' or 'huber'")
    model = model if parameters is None else model.with_parameters(parameters)
    table = table_of(data)
    samples, inputs = samples_of(model, table, measured, noise), inputs_of(model, table, inputs)
    chosen, free, starts = _unknowns(model, unknown)
    limits, begin, absolute = _bounds(chosen, bounds), (q, u, z), model.manifest.absolute
    method = exact_method(model) if method == "auto" else method
    nodes = nodes_of(samples, segments)
    locked = None if absolute else locked_names(model, begin, free)
    joints = JointStart.of(model, begin, starts) if absolute else None
    shooting = Shooting(model, samples, nodes, chosen, free, inputs, method, rtol, locked, joints)
    if seeds is not None:
        shooting = replace(shooting, model=_seeded(shooting, begin, seeds))
    values = np.clip([shooting.model.parameters[name] for name in chosen], *limits.T)
    first = first_states(shooting, begin)
    if segments == "auto":
        begins = divided(shooting, first, values)
        shooting = replace(shooting, nodes=(*(nodes[k] for k in begins), nodes[-1]))
        first = first[begins]
    return Search(shooting, limits, loss, values).run(first, values, most, progress)


def _seeded(shooting: Shooting, begin: Begin, seeds: str | IdentificationRecord) -> LoadedModel:
    """Of the models that filters of the noise give, the one nearest to the measurements."""

    def misfit(model: LoadedModel) -> float:
        alone = replace(shooting, model=model, parameters=())
        try:
            residuals = alone.every(first_states(alone, begin), np.zeros(0)).residuals
        except SolveError:
            return np.inf
        return float(residuals @ residuals)

    return min(seed_models(shooting, seeds), key=misfit)


def _unknowns(
    model: LoadedModel, unknown: str | Sequence[str]
) -> tuple[tuple[str, ...], Places, tuple[str, ...]]:
    """Names of parameters, places of unknown starts along the speeds, and names of these."""
    names = (unknown,) if isinstance(unknown, str) else tuple(unknown)
    # measured formulas have derivatives by blocks and by these names together
    refuse_two_meanings("fit: unknown", model, names, DIRECTIONS)
    blocks = start_blocks(model)
    places = start_places(model) | blocks
    chosen, starts, start_names = list[str](), set[int](), list[str]()
    for name in names:
        if name in model.parameters:
            chosen.append(name)
        elif name in blocks and circuits(model):
            one = next(iter(start_places(model)))
            raise ModelError(
                f"fit: unknown: '{name}': loops determine most of it. Name what is free, such as "
                f"'{one}'"
            )
        elif name in places:
            starts |= {*range(places[name].start, places[name].stop)}
            start_names.append(name)
        else:
            candidates = nodes_last(model.manifest, [*model.parameters, *listed(model, places)])
            raise ModelError(
                f"fit: unknown: '{name}' is neither a parameter nor a start."
                f"{near(name, candidates)}"
            )
    if not names:
        raise ArgumentError("fit: unknown is empty; name parameters or starts, such as 'q0'")
    free = np.array(sorted(starts), dtype=np.intp)
    return tuple(dict.fromkeys(chosen)), free, tuple(dict.fromkeys(start_names))


def _bounds(chosen: tuple[str, ...], bounds: Mapping[str, Sequence[float]] | None) -> Array:
    limits = np.tile([-np.inf, np.inf], (len(chosen), 1))
    for name, pair in (bounds or {}).items():
        if name not in chosen:
            raise ArgumentError(
                f"fit: bounds: '{name}' is not an unknown parameter.{near(name, chosen)}"
            )
        ends = np.asarray(pair, dtype=float)
        if ends.shape != (2,) or not ends[0] < ends[1]:
            raise ArgumentError(f"fit: bounds of '{name}': {brief(pair)}: give (least, most)")
        limits[chosen.index(name)] = ends
    return limits
