"""What was computed survives kill -9, a full disk and a cut file; nothing is done twice."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.ensembles.test_bits import same
from cardan.analyses.ensembles import executors, job
from cardan.analyses.simulation.files.append_log import magic
from cardan.version import ENSEMBLE_FILE
from full_disk import full_disk

OPTIONS: dict[str, Any] = {
    "t": 1.0,
    "vary": cd.sample.latin_hypercube(2000, {"elbow": (-1, 1), "upper.mass": (0.5, 2)}, seed=5),
    "reduce": ["max of elbow", "mean of elbow", "histogram of elbow from -3 to 3 in 7"],
}


@pytest.fixture
def computed(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """First runs of the blocks that were computed."""
    found: list[int] = []
    usual = job.compute

    def compute(*arguments: Any) -> job.BlockResult:
        found.append(arguments[2])
        return usual(*arguments)

    monkeypatch.setattr(executors, "compute", compute)
    return found


def alike(one: cd.Ensemble, other: cd.Ensemble) -> None:
    bins = "histogram of elbow from -3 to 3 in 7"
    np.testing.assert_array_equal(one[bins].counts, other[bins].counts)
    for ensemble in (one, other):
        ensemble.results.pop(bins)  # type: ignore[attr-defined]
    same(one, other)


KILLED = """
import sys, time
import cardan as cd
from analyses.ensembles.test_checkpoint import OPTIONS
from cardan.analyses.ensembles import checkpoint
usual = checkpoint.Checkpoint.add
def slowly(self, piece):
    usual(self, piece)
    print(piece.first, flush=True)
    time.sleep(0.05)
checkpoint.Checkpoint.add = slowly
import pickle
with open(sys.argv[1], "rb") as file:
    model = pickle.load(file)
model.ensemble(**OPTIONS, checkpoint=sys.argv[2], threads=2)
"""


def test_kill_and_go_on(double: cd.CompiledModel, tmp_path: Path, computed: list[int]) -> None:
    import pickle

    (tmp_path / "model").write_bytes(pickle.dumps(double))
    path = tmp_path / "runs"
    tests = str(Path(__file__).parents[2])
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([*sys.path, tests])}
    child = subprocess.Popen(
        [sys.executable, "-c", KILLED, str(tmp_path / "model"), str(path)],
        stdout=subprocess.PIPE,
        text=True,
        env=environment,
    )
    assert child.stdout is not None
    done = [int(child.stdout.readline()) for _ in range(5)]
    child.send_signal(signal.SIGKILL)
    child.wait(timeout=60)
    made = double.ensemble(**OPTIONS, checkpoint=path)
    # what the file said it had was not computed again
    assert not set(done) & set(computed)
    assert len(set(computed)) == len(computed)
    assert {*done, *computed} <= set(range(0, 2000, 120))
    computed.clear()
    again = double.ensemble(**OPTIONS, checkpoint=path)
    assert computed == []
    np.testing.assert_array_equal(again.final, made.final)
    alike(made, double.ensemble(**OPTIONS))


@pytest.mark.parametrize(("cut", "lost"), [(1, 0), (40, 0), (1000, 1), (3000, 1)])
def test_a_cut_file_loses_its_last_record(
    cut: int, lost: int, double: cd.CompiledModel, tmp_path: Path, computed: list[int]
) -> None:
    path = tmp_path / "runs"
    made = double.ensemble(**OPTIONS, checkpoint=path)
    size = path.stat().st_size
    blocks = len(computed)
    computed.clear()
    os.truncate(path, size - cut)
    alike(double.ensemble(**OPTIONS, checkpoint=path), made)
    assert len(computed) == lost
    assert blocks > 10
    assert path.stat().st_size == size


def test_a_file_cut_at_its_head_begins_anew(double: cd.CompiledModel, tmp_path: Path) -> None:
    path = tmp_path / "runs"
    options = OPTIONS | {"reduce": None}
    made = double.ensemble(**options)
    for size in (0, 5, len(magic(ENSEMBLE_FILE)), len(magic(ENSEMBLE_FILE)) + 20):
        double.ensemble(**options, checkpoint=path)
        os.truncate(path, size)
        same(double.ensemble(**options, checkpoint=path), made)


OTHERS = {
    "settings: tolerance": ({"rtol": 1e-7}, "another time, method or tolerance"),
    "settings: time": ({"t": 1.1}, "another time, method or tolerance"),
    "plan": ({"q": {"shoulder": 0.2}}, "its runs start elsewhere"),
    "reductions": ({"reduce": "min of elbow"}, "it keeps other reductions"),
}


@pytest.mark.parametrize("case", OTHERS)
def test_other_runs_are_refused(case: str, double: cd.CompiledModel, tmp_path: Path) -> None:
    path = tmp_path / "runs"
    double.ensemble(**OPTIONS, checkpoint=path)
    changed, words = OTHERS[case]
    with pytest.raises(cd.ModelError, match=f"belongs to another ensemble: .*{words}"):
        double.ensemble(**OPTIONS | changed, checkpoint=path)
    other = double.with_parameters({"lower.mass": 3.0})
    with pytest.raises(cd.ModelError, match="computed with another model"):
        other.ensemble(**OPTIONS, checkpoint=path)


def test_what_is_no_checkpoint(double: cd.CompiledModel, tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.write_text("dear diary")
    with pytest.raises(cd.ModelError, match="is not a file of an ensemble"):
        double.ensemble(**OPTIONS, checkpoint=path)
    assert path.read_text() == "dear diary"
    with pytest.raises(cd.ModelError, match="cannot be opened: No such file or directory"):
        double.ensemble(**OPTIONS, checkpoint=tmp_path / "none" / "runs")


def test_one_process_at_a_time(double: cd.CompiledModel, tmp_path: Path) -> None:
    path = tmp_path / "runs"
    words = "import fcntl, sys, time; f = open(sys.argv[1], 'w'); fcntl.flock(f, fcntl.LOCK_EX)"
    command = [sys.executable, "-c", f"{words}; print(1, flush=True); time.sleep(60)", str(path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as other:
        assert other.stdout is not None
        other.stdout.readline()
        with pytest.raises(cd.ModelError, match="in use by another process"):
            double.ensemble(**OPTIONS, checkpoint=path)
        other.kill()


def test_a_full_disk(double: cd.CompiledModel, tmp_path: Path) -> None:
    path, whole = tmp_path / "runs", double.ensemble(**OPTIONS)
    full = r"written to: File too large.*go on from"
    with full_disk(30_000), pytest.raises(cd.SolveError, match=full):
        double.ensemble(**OPTIONS, checkpoint=path)
    assert path.stat().st_size > 10_000
    alike(double.ensemble(**OPTIONS, checkpoint=path), whole)


def test_ctrl_c_keeps_what_was_computed(double: cd.CompiledModel, tmp_path: Path) -> None:
    path, started, sent = tmp_path / "runs", time.perf_counter(), []

    def tick(done: float) -> None:
        if done > 0.2 and not sent:
            sent.append(done)
            os.kill(os.getpid(), signal.SIGINT)

    words = (
        r"interrupted when \d+ of 2000 .* \d+ runs are kept in .*runs, and the same call goes on"
    )
    with pytest.warns(cd.SolveWarning, match=words):
        made = double.ensemble(**OPTIONS, checkpoint=path, progress=tick, threads=2)
    assert time.perf_counter() - started < 60
    assert 0 < made.finished.sum() < 2000
    assert {"finished", "not_run"} <= set(made.status)
    assert made.interrupted
    assert np.isnan(made.final[made.status == "not_run"]).all()
    whole = double.ensemble(**OPTIONS, checkpoint=path)
    assert whole.success
    assert 0 < whole.restored <= made.done < 2000
    assert f"{whole.restored} runs from the checkpoint" in repr(whole)
    # nothing is computed the third time, so that it has no speed
    told = repr(double.ensemble(**OPTIONS, checkpoint=path))
    assert "2000 runs from the checkpoint" in told
    assert "runs per second" not in told
    np.testing.assert_array_equal(whole.final[made.finished], made.final[made.finished])
