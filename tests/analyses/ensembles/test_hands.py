"""Who computes does not matter: executors, dask, another build is refused by name."""

from __future__ import annotations

import multiprocessing
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.ensembles.test_bits import same
from cardan.analyses.ensembles import executors
from cardan.analyses.simulation.files.append_log import build_key


class Here:
    """A client that computes at once, in this process, from what would have been sent."""

    def __init__(self) -> None:
        self.calls = 0

    def submit(self, function: Any, *arguments: Any) -> Future[Any]:
        self.calls += 1
        future: Future[Any] = Future()
        try:
            future.set_result(function(*arguments))
        except Exception as problem:
            future.set_exception(problem)
        return future


def options() -> dict[str, Any]:
    return {
        "t": np.linspace(0, 1, 11),
        "vary": cd.sample.sobol(128, {"elbow": (-1, 1), "upper.mass": (0.5, 2)}),
        "reduce": ["states", "mean of elbow", "deviation of height", "max of torque"],
    }


def test_a_client_gives_the_same(double: cd.CompiledModel) -> None:
    client = Here()
    made = double.ensemble(**options(), client=client)
    assert client.calls == 16
    assert "client Here" in repr(made)
    same(made, double.ensemble(**options(), threads=1, lanes=1))


def test_processes_give_the_same(double: cd.CompiledModel) -> None:
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        made = double.ensemble(**options(), client=pool)
    same(made, double.ensemble(**options()))


def test_dask_gives_the_same(double: cd.CompiledModel) -> None:
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        made = double.ensemble(**options(), client=client)
        parts = [double.ensemble(**options(), client=client, part=(k, 3)) for k in (1, 2, 3)]
    same(made, double.ensemble(**options()))
    same(cd.Ensemble.join(parts), made)


def test_another_build_is_refused(double: cd.CompiledModel) -> None:
    made = double.ensemble(**options())
    job = replace(made.job, build="0123-4567")
    with pytest.raises(cd.BuildError) as told:
        list(executors.Client(Here()).block_results(job, [(0, 8)], executors.threading.Event()))
    assert "0123-4567" in str(told.value)
    assert build_key(double) in str(told.value)
    assert "model 'double'" in str(told.value)


def test_what_a_client_raises_has_the_runs_in_it(double: cd.CompiledModel) -> None:
    class Broken(Here):
        def submit(self, function: Any, *arguments: Any) -> Future[Any]:
            future: Future[Any] = Future()
            future.set_exception(OSError("the network is down"))
            return future

    with pytest.raises(cd.SolveError, match="runs 0 to 7 failed on the client: OSError: the net"):
        double.ensemble(**options(), client=Broken())
    with pytest.raises(cd.ArgumentError, match="has no submit"):
        double.ensemble(**options(), client=3)
