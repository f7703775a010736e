"""Find the runs of an ensemble that cannot account for their energy.

Runs that are done one by one say so themselves. Of runs in lanes nothing is kept but their ends:
where all forces have a potential, energy at both ends points at runs, and those that look worst are
done again to be looked at from step to step. Where sources give or take energy that is done with
the first run and those with the most and the fewest steps.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ..simulation.energy_accounting import tolerated
from .job import Job
from .lane_runner import NUMBERS, suits

Bools = NDArray[np.bool_]
AGAIN = 16  # runs that are done again at most


def unaccounted(job: Job, final: Array, numbers: Array, finished: Bools) -> dict[int, str]:
    """Energy that runs in lanes miss, as a sentence by number of the run.

    Args:
        job: The ensemble.
        final: Their last states (runs, nx).
        numbers: (runs, 4): end time, steps, rejections, evaluations.
        finished: Which of them reached their end (runs,).
    """
    model = job.model
    has_energy = {"energy", "power"} <= set(model.manifest.available)
    if not (
        has_energy and finished.any() and suits(model, job.how, job.input_signals, job.event_table)
    ):
        return {}
    steps = numbers[:, NUMBERS.index("steps")]
    if _conservative(job):
        some = _suspicious(job, final, steps, finished)
    else:
        there = np.flatnonzero(finished)
        some = np.unique([there[0], there[steps[there].argmax()], there[steps[there].argmin()]])
    said = ((int(k), str(job.motion(int(k), None).solver_info.warning)) for k in some)
    return {k: text for k, text in said if text}


def _conservative(job: Job) -> bool:
    """True when nothing gives or takes energy."""
    outputs = job.model._function("power").outputs
    return not (outputs and outputs[0].entries) and not job.event_table.rows


def _suspicious(job: Job, final: Array, steps: Array, finished: Bools) -> NDArray[np.intp]:
    """The runs whose energy changed most, beyond what their tolerance is worth."""
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
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(finished & (missed > most), missed / most, 0.0)
    worst = np.argsort(-ratio, kind="stable")[:AGAIN]
    return np.sort(worst[ratio[worst] > 0])
