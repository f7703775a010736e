"""Many runs of one model: side by side in lanes, shared by threads or a client, reduced on the way.

What a run gives depends on its own numbers alone: it has the same bits whether it is computed in
lanes, one by one, in threads or elsewhere with the same build.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing, nullcontext
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, Inputs, Seed, checked
from ...errors import CardanError, ModelError, SolveWarning, brief, collected_warnings, warn
from ...runtime.calls.batch import threads as threads_of
from ...runtime.models.loaded_model import LoadedModel
from ..gradients.differentiable import exact_method
from ..simulation.driving import case_of, chosen
from ..simulation.events import event_table_of
from ..simulation.files.append_log import build_key, digest, model_key
from ..simulation.method_choice import Limited
from ..simulation.progress import showing
from ..simulation.settings import default_rtol, settings, watched
from ..simulation.times import Span, span
from .checkpoint import Checkpoint
from .collection import UNFINISHED, Gathered, PartResults
from .energy_check import energy_checks, unaccounted
from .executors import Client, Threads, interruptible
from .job import BlockResult, Job, histories_of
from .lane_runner import width_of
from .reductions import reductions
from .request_record import written
from .result import EnsembleRecord, Request, reported
from .sampling import Plan
from .sensitivity import requested
from .share import Block, part_of, share_of
from .single_runs import motion
from .variations import varied

__all__ = ["EnsembleRecord", "ensemble"]

POINTS = 201  # output times of reductions where the user gave none
LARGEST = 1024  # runs of a block
ROOM = 16e6  # bytes of its rows
SHARES = 16  # blocks at least, where runs suffice
ALONE = 8  # runs of a block that are done one by one in Python
AGAIN = "and the same call goes on from there"
CURE = f"checkpoint= (--checkpoint FILE) keeps finished runs in a file, {AGAIN}"


@checked
def ensemble(
    model: LoadedModel,
    t: float | ArrayLike | None = None,
    *,
    t_eval: ArrayLike | None = None,
    vary: Plan | Mapping[str, object] | None = None,
    x0: Any = None,
    q: Any = None,
    u: Any = None,
    z: Any = None,
    parameters: Mapping[str, object] | None = None,
    inputs: Inputs | None = None,
    sample: float | None = None,
    events: Mapping[str, object] | None = None,
    runs: Count | None = None,
    seed: Seed = 0,
    reduce: str | Sequence[str] | Mapping[str, object] | None = None,
    sensitivity: str | Sequence[str] = (),
    method: str = "auto",
    rtol: float | None = None,
    atol: float | None = None,
    step: float | None = None,
    max_step: float | None = None,
    threads: int | None = None,
    lanes: int | None = None,
    client: Any = None,
    part: Sequence[int] | None = None,
    checkpoint: str | Path | None = None,
    check: bool = False,
    progress: bool | Callable[[float], None] | None = None,
) -> EnsembleRecord:
    """Many runs that differ by their start, parameters or inputs.

    Args:
        model: The compiled model.
        t: End, ``(start, end)`` or output times [s], which ``t_eval`` takes too.
        vary: A plan of :mod:`cardan.analyses.ensembles.sampling`, or name -> values, distributions.
        x0: States (runs, nx); or q, u, z: arrays (runs, nq), (runs, nu) or by names,
            ``{"elbow": values}``. One is that of all runs; ``cd.sample.normal(0, 0.1)`` is drawn.
        parameters, inputs: Name -> number, values (runs,) or a distribution; inputs of all runs
            alike also ``(times, values)`` or ``f(t, x)``, which ``sample`` [s] holds.
        events: As of ``simulate``; runs with them, loops or Python on the way take no lanes.
        runs, seed: How many, where nothing else says so; of the distributions.
        reduce: What to keep beside the last states: ``"max of elbow"``, several, or name -> words
            or a function of t (nt,) and states (runs, nt, nx) of some runs. By default the states
            at output times; reductions take 201 where there are none.
        sensitivity: Starts, parameters and inputs, as :meth:`gradient` takes them, by which
            ``runs.sensitivity["m"]``, (runs, nt, nx), are derivatives; done one after the other.
        method, rtol, atol, step, max_step: As of ``simulate``; ``"auto"`` looks at the first run.
        threads: By default ``$CARDAN_THREADS``, else the cores of this process.
        lanes: 1: no lanes. By default as many as vectors have, once they pay.
        client: Computes instead of threads: of ``dask.distributed``, or an executor.
        part: ``(k, n)``: only part k of n, from 1 on: ``part=(3, 8)`` in job 3 of 8 that share a
            disk. ``cd.Ensemble.join`` makes the whole of them, to the bit.
        checkpoint: A file of finished blocks; the same call goes on from there. One per part.
        check, progress: As of ``simulate``.

    Returns:
        Last states, status and reductions; after Ctrl-C of what was computed.

    Raises:
        ModelError: unknown names, nothing that differs, a checkpoint of other runs. ArgumentError:
            shapes that do not fit. FunctionError: a function of yours raised. SolveError: a number
            that is not finite; no room for the checkpoint; a run that failed, with ``check``.
            BuildError: a client whose machine builds other bits.
    """
    rtol = default_rtol(rtol, sensitivity)
    over, event_table = span(t, t_eval), event_table_of(model, events)
    event_table.forward(over.start, over.end)
    method = exact_method(model) if method == "auto" and sensitivity else method
    how = settings(method, rtol, atol, step, max_step, over.length)
    variations, input_signals = varied(
        model, x0=x0, q=q, u=u, z=z, parameters=parameters, inputs=inputs, sample_time=sample,
        vary=vary, runs=runs, seed=seed, over=(over.start, over.end),
    )  # fmt: skip
    how = watched(how, input_signals, over.length, max_step)
    job = Job(model, how, input_signals, event_table, over, variations, {})
    job = _settled(_with_results(job, reduce, sensitivity, inputs), method, rtol)
    portion, executor, file = part_of(part), _executor(client, threads), _file(checkpoint)
    return reported(*_computed(_sized(job, lanes), portion, executor, file, progress), check)


def _with_results(
    job: Job,
    reduce: str | Sequence[str] | Mapping[str, object] | None,
    sensitivity: str | Sequence[str],
    inputs: Inputs | None,
) -> Job:
    """The job with reductions and sensitivities, and output times where there are any.

    Raises:
        ModelError: names that mean nothing, or one name for both.
    """
    by_name = reductions(reduce, histories_of(job.model), job.over.times is not None)
    request, histories = requested(sensitivity, job.model, job.how, job.input_signals, inputs)
    for name in histories:
        if name in by_name:
            raise ModelError(f"reduce: '{name}' is the name of a sensitivity: take another one")
    by_name |= histories
    over = _observed(job.over, bool(by_name))
    return replace(job, over=over, reductions=by_name, sensitivity=request)


def _executor(client: Any, threads: Any) -> Threads | Client:
    """Who computes.

    Raises:
        ModelError: no number of threads. ArgumentError: no client.
    """
    integer = isinstance(threads, int | np.integer) and not isinstance(threads, bool)
    if threads is not None and (not integer or threads < 1):
        raise ModelError(
            f"threads={brief(threads)} is not a number of threads: 1, 2, ..., or leave "
            "it out for all cores"
        )
    return Client(client) if client is not None else Threads(threads_of(threads))


def _file(checkpoint: object) -> Path | None:
    """File in which finished runs are kept; None without one."""
    if checkpoint is None or isinstance(checkpoint, str | Path):
        return None if checkpoint is None else Path(checkpoint)
    raise ModelError(f"checkpoint={brief(checkpoint)}: name a file, such as 'runs.part'")


def _observed(over: Span, with_reductions: bool) -> Span:
    """A span with output times where something is made of them, and without where not."""
    if not with_reductions:
        return replace(over, times=None)
    usual = np.linspace(over.start, over.end, POINTS) if over.times is None else over.times
    return replace(over, times=usual)


def _settled(job: Job, method: str, rtol: float) -> Job:
    """The job with the method that ``simulate`` takes for the first run, where none is named."""
    if method != "auto":
        return job
    case = case_of(job.model, rtol, job.over, job.input_signals, job.event_table)
    how, first = chosen(job.how, case), job.varied.part(0, 1)
    try:
        with collected_warnings():  # that run warns where its turn comes
            motion(
                job.model,
                how,
                job.input_signals,
                job.event_table,
                replace(job.over, times=None),
                first,
                case,
            )
    except Limited as found:
        how = chosen(job.how, found.case)
    except CardanError:
        # it cannot begin, which is said where its turn comes
        return replace(job, how=how)
    return replace(job, how=how)


def _sized(job: Job, lanes: int | None) -> Job:
    """The job with its lanes and the build of the model."""
    return replace(job, width=_width(job, lanes), build=build_key(job.model))


def _width(job: Job, lanes: int | None) -> int:
    """Lanes side by side; the first run tells whether they pay."""
    if lanes not in (None, 1):
        raise ModelError(f"lanes={lanes}: give 1 for none, or leave it out for those that pay")
    if lanes == 1 or not job.in_lanes:
        return 1
    runner, first = job.runner(), job.varied.part(0, 1)
    runner.run(first)
    before = time.perf_counter()
    runner.run(first)
    spent = time.perf_counter() - before
    per_run = job.varied.varies_parameters
    return width_of(job.model, job.how, job.event_table, per_run, spent * job.varied.runs)


def blocks(job: Job) -> list[Block]:
    """First and last run of every block: the same for every way of computing them."""
    runs, times = job.varied.runs, 0 if job.over.times is None else len(job.over.times)
    row = 8 * (1 + job.model.nx + job.model.nr)
    most = min(LARGEST, ROOM / max(1, row * times), runs / SHARES)
    if not job.in_lanes:
        most = ALONE
    size = max(8, int(most) // 8 * 8)
    return [(first, min(first + size, runs)) for first in range(0, runs, size)]


def whose(job: Job) -> dict[str, str]:
    """Hashes of everything that decides about the answers."""
    model, input_signals = job.model, job.input_signals
    columns = [x for c in job.varied.columns for x in (c.block, c.name, repr(c.place), c.values)]
    tables = [x for p in input_signals.tabulated for x in (p.input, p.breaks, p.coefficients)]
    times = np.empty(0) if job.over.times is None else job.over.times
    functions = sorted(input_signals.functions), input_signals.sample
    return {
        "model": model_key(model),
        "build": job.build,
        "plan": digest(job.varied.runs, *columns, input_signals.constants, *tables, functions),
        "settings": digest(
            job.how, job.over.start, job.over.end, times, job.event_table.descriptions
        ),
        "reductions": digest({name: _reduction_key(one) for name, one in job.reductions.items()}),
    }


def _reduction_key(reduction: object) -> str:
    """A reduction in words that are the same in every process."""
    function = getattr(reduction, "function", None)
    return repr(reduction) if function is None else f"{function.__module__}.{function.__qualname__}"


def _computed(
    job: Job, part: tuple[int, int] | None, executor: Threads | Client, path: Path | None,
    progress: Any,
) -> tuple[EnsembleRecord, dict[int, str]]:  # fmt: skip
    """All blocks of a part, those of the checkpoint first; what finished runs in lanes miss."""
    # the same blocks for any number of parts, so that sums over them have the same bits
    share, left = share_of(part or (1, 1), blocks(job), job.model.name)
    request = Request.of(job, share)
    local = replace(job, varied=job.varied.part(share.first, share.last))
    hashes = whose(job) if path or part else {}
    gathered, block_results = Gathered(local.sizes), dict[int, BlockResult]()
    clock = time.perf_counter()
    file = None
    if path is not None:
        stated = {**hashes, "part": str(share)}
        file = Checkpoint(path, stated, written(request, share, job.reductions), part is None)
    # what the file has is not computed again; a block is on the disk before it counts
    with closing(file) if file else nullcontext():
        with interruptible() as stop:
            for block_result in file.block_results(local.sizes, left) if file else ():
                block_results[block_result.first] = gathered.add(block_result)
                left.remove((block_result.first, block_result.last))
            restored = gathered.done
            with showing(progress, job.model.name) as show:
                for block_result in executor.block_results(local, left, stop) if left else ():
                    if file and not np.isin(block_result.status, UNFINISHED).any():
                        file.add(block_result)
                    block_results[block_result.first] = gathered.add(block_result)
                    show(gathered.done / len(share))
        with collected_warnings():  # runs that are made again have warned before
            checks = energy_checks(local, gathered.x, gathered.numbers, gathered.finished)
        # the last record says that nothing is missing
        done = gathered.done == len(share)
        if file and done:
            file.finish(checks)
    missed = unaccounted(checks)
    gathered.add_messages(missed)
    results = None
    if part is not None:
        ordered = tuple(block_results[k] for k in sorted(block_results))
        results = PartResults(hashes, local.sizes, ordered, tuple(checks) if done else None, job)
    record = EnsembleRecord.of(
        gathered,
        request,
        time.perf_counter() - clock,
        repr(executor),
        restored,
        f"{file.runs} runs are kept in {file.path}, {AGAIN}" if file else CURE,
        local,
        results,
    )
    for text in gathered.merged_warnings():
        warn(text, SolveWarning)
    return record, missed
