"""An ensemble in lanes beside the same runs one by one through our own loop in C."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

import cardan as cd
from benchmarks.cases import Case
from cardan.analyses.ensembles.job import Job
from cardan.analyses.ensembles.lane_runner import LaneRunner

SPAN, RTOL = 1.0, 1e-6
BLOCK = 1024  # runs that are timed, as many as a block of a large ensemble has


def beside(case: Case, rounds: int) -> tuple[float, float]:
    """Seconds of one processor core per run: one by one, and in lanes."""
    model = cd.compile(case.build(), loops=case.loops)
    model.prepare("rhs", batch=True)
    states = model.random_state(1, (BLOCK,))
    job = model.ensemble(SPAN, x0=states, rtol=RTOL, threads=1).job
    alone, lanes = _timed(job, 1), _timed(job, job.width)
    pairs = [(alone(), lanes()) for _ in range(max(3, rounds))]
    # of a processor that others share the least time says most
    one, many = (min(column) for column in zip(*pairs, strict=True))
    return one / BLOCK, many / BLOCK


def _timed(job: Job, width: int) -> Callable[[], float]:
    """What all runs take in a thread, and the check that all reach their end."""
    crew = LaneRunner(job.model, job.how, job.input_signals, job.event_table, job.over, width)

    def seconds() -> float:
        before = time.thread_time()
        ends = crew.run(job.varied)
        spent = time.thread_time() - before
        assert set(ends.status) == {"finished"}
        assert np.isfinite(ends.x).all()
        return spent

    return seconds
