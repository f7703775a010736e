"""Batches as they may lie in memory, in doubles and floats; and what a second thread gains."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import cardan as cd
from benchmarks.cases import Case

STATES = 4096
MANY = 1 << 18  # states that two threads share
ROUNDS = 20
# what others may take of the processor while threads are measured [cores]
IDLE = 0.05
STAT = Path("/proc/stat")


@dataclass(frozen=True)
class Way:
    """Forward dynamics of a batch.

    Attributes:
        name: How it lies in memory, and the type of its numbers.
        seconds: Least time of a state, called from Python.
        error: Largest difference from rows of doubles, by the largest entry.
    """

    name: str
    seconds: float
    error: float


def ways(case: Case, rounds: int) -> list[Way]:
    """Rows, arrays entry by entry, and both in single precision, measured in turn."""
    model = cd.compile(case.build(), loops=case.loops, dtype="float32", threads=1)
    model.prepare("forward_dynamics", batch=True)
    q, u, tau = arguments(model, STATES)
    calls: dict[str, Callable[[], np.ndarray]] = {}
    for dtype in (np.float64, np.float32):
        for order, name in (("C", "rows"), ("F", "structure of arrays")):
            a, b, c = (np.array(x, dtype, order=order) for x in (q, u, tau))
            title = name if dtype is np.float64 else f"{name}, float32"
            calls[title] = lambda a=a, b=b, c=c: model.forward_dynamics(a, b, tau=c)
    exact = calls["rows"]()
    results = {name: call() for name, call in calls.items()}
    least = dict.fromkeys(calls, np.inf)
    for _ in range(max(rounds, ROUNDS)):
        for name, call in calls.items():
            for _ in range(ROUNDS):
                least[name] = min(least[name], _seconds(call))
    scale = np.abs(exact).max()
    return [
        Way(name, least[name] / STATES, float(np.abs(results[name] - exact).max() / scale))
        for name in calls
    ]


def arguments(model: cd.CompiledModel, count: int) -> tuple[np.ndarray, ...]:
    """q, u and tau of random states."""
    q, u = (np.ascontiguousarray(x) for x in model.split(model.random_state(1, (count,))))
    return q, u, np.random.default_rng(2).uniform(-1, 1, u.shape)


def second_thread(case: Case) -> float | None:
    """Time of a batch by one thread over that by two, each the best of some rounds.

    None where that cannot be measured: one core, or other work on the processor.
    """
    if (os.cpu_count() or 1) < 2 or not STAT.exists():
        return None
    models = [cd.compile(case.build(), loops=case.loops, threads=n) for n in (1, 2)]
    best = [np.inf, np.inf]
    calls = []
    for model in models:
        model.prepare("forward_dynamics", batch=True)
        q, u, tau = arguments(model, MANY)
        out = np.empty_like(u)
        calls.append(
            lambda m=model, q=q, u=u, c=tau, out=out: m.forward_dynamics(q, u, tau=c, out=out)
        )
        calls[-1]()
    began, others = time.perf_counter(), _others()
    for _ in range(ROUNDS):
        for k, call in enumerate(calls):
            best[k] = min(best[k], _seconds(call))
    busy = (_others() - others) / (time.perf_counter() - began)
    return best[0] / best[1] if busy <= IDLE else None


def _seconds(call: Callable[[], object]) -> float:
    began = time.perf_counter()
    call()
    return time.perf_counter() - began


def _others() -> float:
    """Seconds that all cores have worked for other processes."""
    fields = [int(x) for x in STAT.read_text("ascii").splitlines()[0].split()[1:9]]
    # user, nice, system, and behind idle and waiting: interrupts, and what other machines took
    worked = sum(fields[:3]) + sum(fields[5:])
    return worked / os.sysconf("SC_CLK_TCK") - sum(os.times()[:2])
