"""Gradients of many runs that differ by starts, parameters or inputs, as those of ensembles do."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Inputs
from ...errors import CardanError
from ...runtime.calls.parameters import Parameters
from ...runtime.models.loaded_model import LoadedModel
from ..ensembles.sampling import Plan
from ..ensembles.variations import Varied, varied
from ..simulation.progress import showing

Block = Mapping[str, ArrayLike] | ArrayLike | None
R = TypeVar("R")


class Variation(NamedTuple):
    """Number of runs, and what they differ by, as :func:`.ensemble` takes it.

    Attributes:
        vary: Plan, or name -> values (runs,) or a distribution.
        runs: Number of runs.
        seed: Of distributions.
    """

    vary: Plan | Mapping[str, object] | None
    runs: int | None
    seed: int


class OneRun(NamedTuple):
    """What a single run is made of.

    Attributes:
        model: With the parameters of the run.
        q, u, z: Its start, as of ``simulate``.
        inputs: By name.
    """

    model: LoadedModel
    q: Block
    u: Block
    z: Block
    inputs: Inputs


def over_runs(
    model: LoadedModel,
    variation: Variation,
    t: object,
    state: Mapping[str, object],
    inputs: Inputs,
    parameters: Mapping[str, object] | None,
    single: Callable[[OneRun], R],
    progress: bool | Callable[[float], None] | None,
) -> tuple[list[R], int]:
    """What a function gives for every run, and how many runs there are.

    After Ctrl-C there is less: of the runs that were done.

    Raises:
        ModelError, ArgumentError: as of ensembles. CardanError: of a run, which it names.
        KeyboardInterrupt: by Ctrl-C before any run was done.
    """
    span = np.atleast_1d(np.asarray(t, dtype=float))
    over = (float(span[0]), float(span[-1])) if len(span) > 1 else (0.0, float(span[0]))
    variations, _ = varied(
        model, **{name: state[name] for name in ("x0", "q", "u", "z")}, parameters=parameters,
        inputs=inputs, sample_time=None, vary=variation.vary, runs=variation.runs,
        seed=variation.seed, over=over,
    )  # fmt: skip
    results, total = list[R](), variations.runs
    with showing(progress, model.name) as show:
        for k, run in enumerate(_each(model, variations, inputs)):
            try:
                results.append(single(run))
                show((k + 1) / total)
            except CardanError as error:
                # which of them it was, in words of the same kind
                raise type(error)(f"run {k}: {error}") from error
            except KeyboardInterrupt:
                if not results:
                    raise
                break
    return results, total


def _each(model: LoadedModel, variations: Varied, inputs: Inputs) -> Iterator[OneRun]:
    """All runs."""
    columns = [c for c in variations.columns if c.block == "r"]
    for k in range(variations.runs):
        part, model_of_run = variations.part(k, k + 1), model
        if variations.varies_parameters:
            model_of_run = model._with(Parameters(model.manifest, part.block("p")[0]))
        q, u, z = (part.named(letter, 0) for letter in "quz")
        numbers = {c.name: float(c.values[k % len(c.values), 0]) for c in columns}
        yield OneRun(model_of_run, q, u, z, {**inputs, **numbers})
