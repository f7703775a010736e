"""Parts of an ensemble, computed anywhere and joined: the bits of the whole, or a refusal."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import warnings
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.conftest import double_scene
from cardan.analyses.ensembles.energy_check import CRITERIA, EnergyCheck, selected
from cardan.analyses.ensembles.lane_runner import width_of
from cardan.runtime.build import cache, cpu_levels

PARTS = 8


def second(t: np.ndarray, x: np.ndarray) -> np.ndarray:
    """A reduction that is a function: two numbers of every run."""
    return x[:, -1, :2] * t[-1]


RUNS: dict[str, Any] = {
    "t": 1.0,
    "q": {"elbow": cd.sample.normal(0, 0.5), "shoulder": 0.3},
    "parameters": {"upper.mass": cd.sample.uniform(0.5, 2)},
    "runs": 600,
    "seed": 5,
}
EVERYTHING: dict[str, Any] = {
    "states": "states",
    "max": "max of elbow",
    "mean": "mean of elbow",
    "deviation": "deviation of height",
    "largest": "max of elbow over runs",
    "bins": "histogram of elbow from -1 to 1 in 7",
    "energy": "range of energy",
    "second": second,
}
KEEP: dict[str, Any] = RUNS | {"reduce": EVERYTHING}


def equal(one: cd.Ensemble, other: cd.Ensemble) -> None:
    """Everything of two ensembles but who computed them, and when."""
    assert one.final.tobytes() == other.final.tobytes()
    assert one.numbers.tobytes() == other.numbers.tobytes()
    assert one.status.tolist() == other.status.tolist()
    assert one.messages == other.messages
    assert list(one.results) == list(other.results)
    for name, value in one.results.items():
        for part in ("counts", "edges", "below", "above") if hasattr(value, "counts") else ("T",):
            ours, theirs = (np.asarray(getattr(x[name], part)) for x in (one, other))
            assert ours.dtype == theirs.dtype
            assert ours.tobytes() == theirs.tobytes(), name
    assert list(one.varied) == list(other.varied)
    for name, values in one.varied.items():
        assert values.tobytes() == other.varied[name].tobytes()
    assert one.t.tobytes() == other.t.tobytes()
    assert one.request.axes == other.request.axes
    assert (one.part, other.part) == (None, None)


def divided(
    model: cd.CompiledModel, folder: Path, options: dict[str, Any], count: int = PARTS
) -> list[cd.Ensemble]:
    """All parts, each with a file."""
    return [
        model.ensemble(**options, part=(k, count), checkpoint=folder / f"runs-{k}.part")
        for k in range(1, count + 1)
    ]


def stopped() -> cd.CompiledModel:
    """A pendulum that hits a stop; runs are done one by one, and some break down."""
    scene = cd.Scene("stopped", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    scene.force("stop", cd.Stop("pivot", lower=-0.3, restitution=0.5))
    return cd.compile(scene)


def drifting() -> cd.CompiledModel:
    """A potential that jumps at 0 unseen: runs that pass there cannot account for energy."""
    scene = cd.Scene("drifting", gravity=(0, 0, 0))
    cart = scene.body("cart", mass=1.0, inertia=(1, 1, 1))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, cart)
    scene.force("spring", cd.JointSpring("slide", stiffness=1e4))
    return cd.compile(scene)


COARSE = {"t": 20.0, "method": "RK4", "step": 0.012, "reduce": ["last of slide"]}
CASES: dict[str, tuple[Any, dict[str, Any]]] = {
    "everything": (None, KEEP),
    "one by one": (None, KEEP | {"method": "Radau", "runs": 100, "t": 0.2}),
    "no output times": (None, RUNS),
    "in lanes": ("lanes", KEEP),
    "a grid": (
        None,
        {"t": np.linspace(0, 1, 4), "vary": cd.sample.grid(elbow=(-1, 1, 20), torque=(0, 1, 10))},
    ),
    "states": (None, {"t": (0.0, 0.5), "x0": np.linspace(-1, 1, 800).reshape(200, 4)}),
    "events": (
        stopped,
        {"t": 1.0, "q": {"pivot": np.linspace(-0.2, 1.5, 90)}, "reduce": "mean of pivot"},
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_parts_make_the_whole(case: str, double: cd.CompiledModel, tmp_path: Path) -> None:
    make, options = CASES[case]
    model = make() if callable(make) else double
    if make == "lanes":
        job = model.ensemble(**options).job
        width_of(model, job.how, job.event_table, job.varied.varies_parameters, np.inf)
    whole = model.ensemble(**options)
    parts = divided(model, tmp_path, options)
    assert sum(map(len, parts)) == len(whole)
    assert [part.part for part in parts] == [(k, PARTS) for k in range(1, PARTS + 1)]
    assert "part 3 of 8: runs " in repr(parts[2])
    joined = cd.Ensemble.join(str(tmp_path / "runs-*.part"))
    equal(whole, joined)
    assert "joined from 8 parts" in repr(joined)
    with pytest.raises(cd.ModelError, match="has no model to compute a run again"):
        joined.run(3)
    mixed = cd.Ensemble.join([tmp_path / "runs-2.part", parts[0], *parts[2:][::-1]])
    equal(whole, mixed)
    k = len(whole) - 2
    assert mixed.run(k).x[-1].tobytes() == whole.run(k).x[-1].tobytes()
    # a part by itself is an ensemble like others
    first = len(parts[0]) + len(parts[1])
    assert parts[2].final.tobytes() == whole.final[first : first + len(parts[2])].tobytes()
    assert parts[2].run(0).x[-1].tobytes() == whole.run(first).x[-1].tobytes()


def test_a_saved_join_is_the_saved_whole(double: cd.CompiledModel, tmp_path: Path) -> None:
    parts = divided(double, tmp_path, KEEP, 3)
    joined = cd.Ensemble.join(parts)
    equal(cd.load_ensemble(joined.save(tmp_path / "all.nc")), double.ensemble(**KEEP))
    again = cd.load_ensemble(parts[1].save(tmp_path / "part.nc"))
    assert again.part == (2, 3)
    assert again.final.tobytes() == parts[1].final.tobytes()
    with pytest.raises(cd.ModelError, match="it comes from a saved file"):
        cd.Ensemble.join([parts[0], again, parts[2]])
    with pytest.raises(cd.ModelError, match=r"all\.nc is not a file of an ensemble"):
        cd.Ensemble.join(tmp_path / "all.nc")


def test_runs_that_break_down_and_energy_that_is_missed(tmp_path: Path) -> None:
    """The same sentences and warnings, of the same runs."""
    model = drifting()
    options = COARSE | {"q": {"slide": np.concatenate([np.linspace(0.1, 3, 400), [1e200]])}}
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        whole = model.ensemble(**options)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        divided(model, tmp_path, options)
    with warnings.catch_warnings(record=True) as again:
        warnings.simplefilter("always")
        joined = cd.Ensemble.join(str(tmp_path / "*.part"))
    equal(whole, joined)
    texts = [str(one.message) for one in said]
    assert any("miss far more than their tolerance is worth" in text for text in texts), texts
    assert texts == [str(one.message) for one in again]
    with pytest.raises(cd.SolveError, match="miss far more"):
        cd.Ensemble.join(str(tmp_path / "*.part"), check=True)


def test_checks_of_parts_select_those_of_the_whole() -> None:
    rng = np.random.default_rng(8)
    scores = rng.integers(0, 30, 200).tolist()
    checks = [EnergyCheck(why, float(s), k) for why in CRITERIA for k, s in enumerate(scores)]
    parts = [[one for one in checks if one.run % 7 == k] for k in range(7)]
    assert selected(one for part in parts for one in selected(part)) == selected(checks)


# who computes


def test_executors_compute_parts(double: cd.CompiledModel, tmp_path: Path) -> None:
    """Whatever has ``submit`` and gives futures, as executors of concurrent.futures do."""

    class Workers(Executor):
        def submit(self, function: Any, /, *arguments: Any, **named: Any) -> Future[Any]:
            future: Future[Any] = Future()
            sent = pickle.loads(pickle.dumps((function, arguments, named)))
            future.set_result(sent[0](*sent[1], **sent[2]))
            return future

    with Workers() as pool:
        parts = [double.ensemble(**RUNS, part=(k, 3), client=pool) for k in (1, 2, 3)]
    equal(double.ensemble(**RUNS), cd.Ensemble.join(parts))


def other_level() -> str:
    """Instructions that this processor has beside the ones in use."""
    names = [one.name for one in cpu_levels.family() if one.number < cache.level().number]
    return names[-1] if names else pytest.skip("there is one kind of instructions here")


def test_workers_with_another_processor_are_refused_or_reproducible(
    double: cd.CompiledModel, monkeypatch: pytest.MonkeyPatch
) -> None:
    options = RUNS | {"runs": 16, "t": 0.2}
    here = double.ensemble(**options)
    exact = cd.compile(double_scene(), reproducible=True)
    exactly = exact.ensemble(**options)
    monkeypatch.setenv("CARDAN_LEVEL", other_level())
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        pool.submit(os.getpid).result()
        monkeypatch.undo()
        with pytest.raises(cd.BuildError, match="compile with reproducible=True"):
            double.ensemble(**options, client=pool)
        equal(exactly, exact.ensemble(**options, client=pool))
    np.testing.assert_allclose(exactly.final, here.final, rtol=1e-6, atol=1e-8)


def test_files_of_reproducible_models_go_from_machine_to_machine(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A part of every processor, joined; without reproducible=True they are refused."""
    for exact in (True, False):
        for k in (1, 2):
            if k == 2:
                monkeypatch.setenv("CARDAN_LEVEL", other_level())
            model = cd.compile(double_scene(), reproducible=exact)
            model.ensemble(**RUNS, part=(k, 2), checkpoint=tmp_path / f"{exact}-{k}.part")
        monkeypatch.undo()
        if exact:
            equal(model.ensemble(**RUNS), cd.Ensemble.join(str(tmp_path / "True-*")))
        else:
            with pytest.raises(cd.ModelError, match="reproducible=True"):
                cd.Ensemble.join(str(tmp_path / "False-*"))
