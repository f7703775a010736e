"""Find the runs of an ensemble that cannot account for their energy.

Runs that are done one by one say so themselves. Of runs in lanes nothing is kept but their ends:
where all forces have a potential, energy at both ends points at runs, and those that look worst are
done again to be looked at from step to step. Where sources give or take energy that is done with
the first run and those with the most and the fewest steps.

Parts of an ensemble look at runs of their own, by the same criteria: those of the whole are among
them.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ..simulation.energy_accounting import tolerated
from .job import Job
from .lane_runner import NUMBERS

Bools = NDArray[np.bool_]
# why a run is done again -> how many runs are, at most: those with the highest scores
CRITERIA = {"missed": 16, "first": 1, "most steps": 1, "fewest steps": 1}


class EnergyCheck(NamedTuple):
    """A run that was looked at from step to step.

    Attributes:
        criterion: Why, one of ``CRITERIA``.
        score: By that criterion; of equal ones the first run counts.
        run: Its number.
        text: What it misses, as a sentence; empty where it misses nothing.
    """

    criterion: str
    score: float
    run: int
    text: str = ""


def energy_checks(job: Job, final: Array, numbers: Array, finished: Bools) -> list[EnergyCheck]:
    """Energy that runs in lanes miss.

    Args:
        job: The ensemble.
        final: Their last states (runs, nx).
        numbers: (runs, 4): end time, steps, rejections, evaluations.
        finished: Which of them reached their end (runs,).
    """
    model = job.model
    has_energy = {"energy", "power"} <= set(model.manifest.available)
    if not (has_energy and finished.any() and job.in_lanes):
        return []
    steps = numbers[:, NUMBERS.index("steps")]
    if _conservative(job):
        with np.errstate(all="ignore"):  # runs that broke down have no energy
            ratios = _ratios(job, final, steps, finished)
        chosen = _highest("missed", ratios, ratios > 0)
    else:
        scores = {"first": 0 * steps, "most steps": steps, "fewest steps": -steps}
        chosen = [one for why, score in scores.items() for one in _highest(why, score, finished)]
    texts = {
        k: str(job.motion(k, None).solver_info.warning or "")
        for k in sorted({one.run for one in chosen})
    }
    return [one._replace(text=texts[one.run]) for one in chosen]


def _highest(criterion: str, scores: Array, mask: Bools) -> list[EnergyCheck]:
    """The runs of a mask with the highest scores, as many as the criterion takes."""
    runs = np.flatnonzero(mask)
    runs = runs[np.argsort(-scores[runs], kind="stable")[: CRITERIA[criterion]]]
    return [EnergyCheck(criterion, float(scores[k]), int(k)) for k in runs]


def selected(checks: Iterable[EnergyCheck]) -> list[EnergyCheck]:
    """As many as each criterion takes, of those with the highest scores."""
    ordered = sorted(checks, key=lambda one: (-one.score, one.run))
    return [
        one
        for criterion, count in CRITERIA.items()
        for one in [one for one in ordered if one.criterion == criterion][:count]
    ]


def unaccounted(checks: Iterable[EnergyCheck]) -> dict[int, str]:
    """Energy that runs miss, as a sentence by number of the run."""
    return {one.run: one.text for one in sorted(checks, key=lambda one: one.run) if one.text}


def _conservative(job: Job) -> bool:
    """True when nothing gives or takes energy."""
    outputs = job.model._function("power").outputs
    return not (outputs and outputs[0].entries) and not job.event_table.rows


def _ratios(job: Job, final: Array, steps: Array, finished: Bools) -> Array:
    """Energy that runs gained or lost over what their tolerance is worth (runs,); 0 up to that."""
    model, part = job.model, job.varied
    parameters = None
    if part.varies_parameters:
        parameters = dict(zip(model.parameters, part.block("p").T, strict=True))
    r = part.block("r") if model.nr else None
    ends, fastest = [], np.zeros(len(final))
    for t, x in ((job.over.start, part.states()), (job.over.end, final)):
        q, u = model.split(x)[:2]
        fastest = np.maximum(fastest, np.abs(u).max(axis=1, initial=0.0))
        ends.append(model.energy(q, u, t=np.full(len(x), t), r=r, parameters=parameters))
    first, last = ends
    moved = np.abs(last.potential - first.potential)
    energy_scale = np.maximum(first.kinetic, last.kinetic) + moved
    missed = np.abs(last.total - first.total)
    most = tolerated(job.how, fastest, energy_scale, energy_scale + np.abs(last.potential), steps)
    ratios: Array = np.where(finished & (missed > most), missed / most, 0.0)
    return ratios
