"""What is kept: against NumPy on all states, with runs that fail, in bounded memory."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import numpy as np
import pytest

import cardan as cd

TIMES = np.linspace(0, 2, 31)
PLAN = cd.sample.random(300, {"elbow": (-1, 1), "shoulder.u": (-2, 2)}, seed=7)
WORDS = {
    "max of elbow": lambda y: y.max(axis=1),
    "min of elbow": lambda y: y.min(axis=1),
    "range of elbow": lambda y: np.ptp(y, axis=1),
    "rms of elbow": lambda y: np.sqrt((y**2).mean(axis=1)),
    "last of elbow": lambda y: y[:, -1],
    "mean of elbow over time": lambda y: y.mean(axis=1),
    "mean of elbow": lambda y: y.mean(axis=0),
    "variance of elbow": lambda y: y.var(axis=0, ddof=1),
    "deviation of elbow": lambda y: y.std(axis=0, ddof=1),
    "max of elbow over runs": lambda y: y.max(axis=0),
    "min of elbow over runs": lambda y: y.min(axis=0),
}


def test_against_numpy(double: cd.CompiledModel) -> None:
    made = double.ensemble(TIMES, vary=PLAN, reduce=["states", *WORDS])
    elbow = made["states"][:, :, 1]
    for word, expected in WORDS.items():
        # sums of 300 numbers of size 1 in another order
        np.testing.assert_allclose(made[word], expected(elbow), rtol=0, atol=300 * 2e-16)
    np.testing.assert_array_equal(made["elbow"], elbow[:, -1])
    np.testing.assert_array_equal(made["states"][:, -1], made.final)


def test_names_functions_outputs_and_bins(double: cd.CompiledModel) -> None:
    reduce = {
        "top": "max of height",
        "bins": "histogram of elbow from -0.5 to 1 in 9",
        "mine": lambda t, x: np.abs(x[:, :, :2]).max(axis=1),
    }
    made = double.ensemble(TIMES, vary=PLAN, reduce=reduce)
    states = double.ensemble(TIMES, vary=PLAN)["states"]
    height = double.outputs(states[:, :, :2], states[:, :, 2:])[:, :, 0]
    np.testing.assert_array_equal(made["top"], height.max(axis=1))
    np.testing.assert_array_equal(made["mine"], np.abs(states[:, :, :2]).max(axis=1))
    bins, last = made["bins"], made["elbow"]
    np.testing.assert_array_equal(bins.counts, np.histogram(last, bins.edges)[0])
    assert bins.counts.sum() + bins.below + bins.above == 300
    assert bins.below == (last < -0.5).sum() > 0


def test_runs_that_fail_are_left_out(edge: cd.CompiledModel) -> None:
    x = np.linspace(-1, 0.9, 40)
    options: dict[str, Any] = {"q": {"slide": x}, "parameters": {"push": -x}}
    reduce = ["states", "mean of slide", "max of slide"]
    with pytest.warns(cd.SolveWarning):
        made = edge.ensemble(np.linspace(0, 2.0, 13), **options, reduce=reduce)
    good = made.finished
    assert 0 < good.sum() < 40
    np.testing.assert_allclose(
        made["mean of slide"], made["states"][good, :, 0].mean(axis=0), rtol=0, atol=1e-14
    )
    assert np.isnan(made["max of slide"][~good]).all()
    assert np.isfinite(made["max of slide"][good]).all()
    # rows up to the time where a run broke down are there
    k = int(np.argmin(good))
    reached = made["states"][k, :, 0]
    assert np.isfinite(reached[made.t <= made.statistics["t"][k]]).all()
    assert np.isnan(reached[made.t > made.statistics["t"][k]]).all()


def test_no_run_reaches_its_end(edge: cd.CompiledModel) -> None:
    with pytest.warns(cd.SolveWarning, match="2 of 2 runs"):
        made = edge.ensemble(1.0, q={"slide": np.array([1.5, 2.0])}, reduce="mean of slide")
    assert np.isnan(made["mean of slide"]).all()


REFUSED = {
    "max elbow": "is not a reduction: it may be 'states'",
    "median of elbow": "is not a reduction",
    "max of ellbow": "no history 'ellbow'.*Did you mean 'elbow'",
    "rms of elbow over runs": "there is no rms over runs",
    "histogram of elbow from 1 to 0 in 5": "from a lower to a higher number",
    "histogram of elbow from 0 to 1 in 0": "in 1 or more",
    "histogram of elbow from 0 to 1..2 in 5": "from a lower to a higher number",
}


@pytest.mark.parametrize("words", REFUSED)
def test_words_that_mean_nothing(words: str, double: cd.CompiledModel) -> None:
    with pytest.raises(cd.ModelError, match=REFUSED[words]):
        double.ensemble(1.0, vary=PLAN, reduce=words)


def test_functions_that_do_not_fit(double: cd.CompiledModel) -> None:
    with pytest.raises(cd.ArgumentError, match="first axis must be that of the runs"):
        double.ensemble(1.0, vary=PLAN, reduce={"mine": lambda t, x: x.max()})
    with pytest.raises(cd.ArgumentError, match="'mine' is 3"):
        double.ensemble(1.0, vary=PLAN, reduce={"mine": 3})
    with pytest.raises(cd.ModelError, match=r"take .* GB, this machine has"):
        double.ensemble(np.linspace(0, 1, 100_000), runs=10_000_000, vary=None)


MANY = """
import resource
from pathlib import Path
import numpy as np
import cardan as cd
scene = cd.Scene("rod", gravity=(0, 0, -9.81))
rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
model = cd.compile(scene)
runs = 1_000_000
made = model.ensemble(
    np.linspace(0, 0.1, 11), q={"pivot": np.linspace(-1, 1, runs)}, rtol=1e-3,
    reduce=["max of pivot", "mean of pivot", "histogram of pivot from -1 to 1 in 100"],
)
assert made.success, made
# of this program alone: getrusage counts what started it too
status = Path("/proc/self/status")
if status.exists():
    lines = dict(line.split(":", 1) for line in status.read_text().splitlines())
    print(int(lines["VmHWM"].split()[0]) / 1e6)
else:
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6)
"""


@pytest.mark.slow
def test_a_million_runs_take_less_than_a_gigabyte() -> None:
    done = subprocess.run([sys.executable, "-c", MANY], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert float(done.stdout) < 1.0
