"""First values of inertial parameters from the linear problem of identification.

Where all coordinates and the inputs were measured, forces along the motion are linear in base
parameters. These need no first values; the unknown parameters are taken nearest to what they are
in the model with these base parameters.
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, CardanError, ModelError, SolveError, brief
from ...runtime.models.loaded_model import LoadedModel
from ..identification.base_parameters import REQUIRED, needed
from ..identification.identify import identify
from ..identification.nearest_parameters import inertial
from ..identification.result import IdentificationRecord, implausible
from ..simulation.signals import signals
from .shooting import Shooting

IDENTIFY = "identify"
POOR = (
    "the motion excites too little, or noise hides it; model.excitation() finds a better one, "
    "seeds=model.identify(..., cutoff=) takes another filter"
)
FILTERS = 6  # each with half the cutoff of the one before


def seed_models(shooting: Shooting, seeds: str | IdentificationRecord) -> list[LoadedModel]:
    """The model with first values of its unknown inertial parameters, as several filters give them.

    Args:
        shooting: What was measured of which model, and its unknown parameters.
        seeds: ``"identify"``, or an identification.

    Raises:
        ArgumentError: neither; not all coordinates were measured; no unknown inertial parameter.
        ModelError: no regressor. SolveError: the data do not tell the base parameters, or values
            come out that no body has.
    """
    if isinstance(seeds, str) and seeds != IDENTIFY:
        raise ArgumentError(
            f"fit: seeds={brief(seeds)}: give 'identify', or what model.identify(...) returns"
        )
    model = shooting.model
    try:
        names = _inertial(model, shooting.parameters)
        if isinstance(seeds, IdentificationRecord):
            return [_plausible(model, seeds.nearest_to(model, names))]
        data = _measured(shooting)
    except (ArgumentError, SolveError) as problem:
        raise type(problem)(f"fit: seeds: {problem}") from problem
    models, problems = list[LoadedModel](), list[CardanError]()
    for cutoff in _cutoffs(data["t"]):
        try:
            identification = identify(model, data, cutoff=cutoff)
            models.append(_plausible(model, identification.nearest_to(model, names)))
        except (ArgumentError, SolveError) as problem:
            problems.append(problem)
    if not models:
        raise type(problems[0])(f"fit: seeds='identify': {problems[0]}")
    return models


def _inertial(model: LoadedModel, unknown: tuple[str, ...]) -> list[str]:
    """Unknown parameters that base parameters consist of.

    Raises:
        ArgumentError: there is none. ModelError: no regressor.
    """
    needed(model, "fit: seeds", REQUIRED)
    names = [name for name in inertial(model) if name in unknown]
    if not names:
        raise ArgumentError(
            f"no unknown of {', '.join(unknown) or 'the start'} is a mass, center of mass, inertia "
            "or coefficient of a force, of which identification speaks"
        )
    return names


def _plausible(model: LoadedModel, values: dict[str, float]) -> LoadedModel:
    """The model with values that bodies can have.

    Raises:
        SolveError: they cannot.
    """
    try:
        seeded = model.with_parameters(values)
    except ModelError as problem:
        raise SolveError(f"{problem}: {POOR}") from problem
    wrong = sorted({*implausible(seeded)} - {*implausible(model)})
    if wrong:
        raise SolveError(
            f"no body has the mass, center and inertia that come out for '{wrong[0]}': {POOR}"
        )
    return seeded


def _cutoffs(t: Array) -> list[float | None]:
    """Cutoffs of filters [Hz], None for none: noise is amplified in accelerations.

    Which one is right, the misfit tells.
    """
    highest = 0.5 / float(np.median(np.diff(t)))
    return [None, *(highest / 2**k for k in range(1, FILTERS + 1))]


def _measured(shooting: Shooting) -> dict[str, Array]:
    """The samples as identification takes them.

    Raises:
        ArgumentError: a coordinate was not measured, or an input is a function.
    """
    model, samples = shooting.model, shooting.samples
    missing = [name for name in model.coordinates if name not in samples.formulas]
    if missing:
        raise ArgumentError(
            f"identification needs all coordinates, and '{missing[0]}' was not measured"
        )
    span = float(samples.t[0]), float(samples.t[-1])
    input_signals = signals(model.manifest.inputs, shooting.inputs, None, span)
    if input_signals.functions:
        name = model.inputs[next(iter(input_signals.functions))]
        raise ArgumentError(f"input '{name}' is a function: give it as (times, values)")
    blocks = {"q": model.coordinates}
    if model.nu and all(name in samples.formulas for name in model.speeds):
        blocks["u"] = model.speeds
    places = {
        block: [samples.formulas.index(name) for name in names] for block, names in blocks.items()
    }
    rows = samples.present[:, [k for one in places.values() for k in one]].all(axis=1)
    t = samples.t[rows]
    r = input_signals.recorded(t[:1], input_signals.constants[None])(t)
    return {"t": t, "r": r} | {b: samples.values[rows][:, one] for b, one in places.items()}
