"""What stays and what is swept along a path of cycles."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...errors import ModelError
from ...runtime.models.loaded_model import LoadedModel
from ..continuation.path_request import PathRequest
from ..statics.equilibrium import read
from ..statics.load_path import Loading, loading
from ..statics.statics import sweepable
from ..systems import dynamic_system_of
from .cycle_problem import CycleProblem
from .energy_level import ENERGY


def problem_and_way(
    problem: CycleProblem, model: LoadedModel, request: PathRequest
) -> tuple[CycleProblem, Loading]:
    """The problem with what stays, and what is swept.

    Raises:
        ModelError: an unknown name, values between the ends, an energy that is not told.
    """
    model = model.with_parameters(dict(request.parameters)) if request.parameters else model
    system = dynamic_system_of(model)
    kinds = {name: kind for name, kind in sweepable(model).items() if kind != "t"}
    level = problem.level
    if level is not None:
        kinds[ENERGY] = ENERGY
    elif ENERGY in request.swept and ENERGY not in kinds:
        raise ModelError(
            "continuation of cycles: energy= is swept from a mode, start=model.modes()[0], or from "
            "a cycle of such a path"
        )
    base = read(system, {}, None, None, problem.t)
    way = loading(system, kinds, base, request.swept, {}, "continuation")
    if way.stations is not None:
        raise ModelError("continuation: give (start, end) of what is swept, and no values within")
    if level is not None and ENERGY in way.swept:
        level = replace(level, size=float(np.ptp(way.swept[ENERGY])))
    inputs = {**problem.inputs, **(request.inputs or {})}
    problem = replace(problem, model=model, system=system, inputs=inputs, level=level, _flows={})
    return problem, way


def place_of(way: Loading, values: Mapping[str, float]) -> float:
    """The place of swept values on a way."""
    (name, ends), *_ = way.swept.items()
    return float((values[name] - ends[0]) / (ends[-1] - ends[0]))
