"""Sampling plans: their values, their balance, what they refuse."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import stats

import cardan as cd
from cardan.analyses.ensembles import sampling
from table import each


def test_grid() -> None:
    plan = cd.sample.grid({"elbow": [0.0, 1.0]}, m=(1, 2, 3))
    assert len(plan) == 6
    np.testing.assert_array_equal(plan.values["elbow"], [0, 0, 0, 1, 1, 1])
    np.testing.assert_array_equal(plan.values["m"], [1, 1.5, 2, 1, 1.5, 2])
    assert "grid plan of 6 runs" in repr(plan)
    assert "m: 1 ... 2" in repr(plan)


def test_latin_hypercube_has_one_value_in_every_slice() -> None:
    plan = cd.sample.latin_hypercube(50, {"a": (2, 4), "b": cd.sample.normal(1, 0.5)}, seed=3)
    for name, kind in (("a", stats.uniform(2, 2)), ("b", stats.norm(1, 0.5))):
        slices = np.floor(50 * kind.cdf(plan.values[name])).astype(int)
        assert sorted(slices) == list(range(50))


def test_sobol_is_balanced() -> None:
    plan = cd.sample.sobol(64, {"a": (0, 1), "b": cd.sample.log_uniform(1e-3, 1e3)}, seed=1)
    a, b = plan.values["a"], (np.log10(plan.values["b"]) + 3) / 6
    # every elementary rectangle of a net holds the same number of points
    counts, _, _ = np.histogram2d(a, b, bins=(4, 4), range=((0, 1), (0, 1)))
    assert (counts == 4).all()


@pytest.mark.parametrize("make", [sampling.random, sampling.latin_hypercube, sampling.sobol])
def test_a_seed_is_a_plan(make: Any) -> None:
    one, again, other = (make(32, {"a": (0, 1)}, seed=s).values["a"] for s in (1, 1, 2))
    np.testing.assert_array_equal(one, again)
    assert (one != other).any()


def test_distributions_of_scipy() -> None:
    plan = cd.sample.random(2000, {"a": stats.expon(scale=2)}, seed=5)
    # the standard error of the mean is 2 / sqrt(2000)
    assert abs(plan.values["a"].mean() - 2) < 4 * 2 / np.sqrt(2000)


def test_a_name_is_drawn_on_its_own() -> None:
    kind = cd.sample.normal(0, 1)
    np.testing.assert_array_equal(
        sampling.drawn("elbow", kind, 9, 4), sampling.drawn("elbow", kind, 9, 4)
    )
    assert (sampling.drawn("elbow", kind, 9, 4) != sampling.drawn("m", kind, 9, 4)).all()


def test_distributions_in_an_ensemble(double: cd.CompiledModel) -> None:
    plan = {"elbow": cd.sample.normal(0, 0.1)}
    made = double.ensemble(
        0.1, q={"elbow": cd.sample.normal(0, 0.1)}, parameters={"upper.mass": (1.0)}, runs=16
    )
    again = double.ensemble(
        0.1, q={"elbow": cd.sample.normal(0, 0.1), "shoulder": cd.sample.uniform(-1, 1)}, runs=16
    )
    np.testing.assert_array_equal(made.varied["elbow"], again.varied["elbow"])
    assert made.varied.keys() == {"elbow"}
    mixed = double.ensemble(0.1, vary=plan, runs=16, inputs={"torque": [0.0] * 16})
    np.testing.assert_array_equal(mixed.final, made.final)


REFUSED: list[tuple[Any, type[Exception], str]] = [
    (lambda: cd.sample.grid(), cd.ModelError, "name what is varied"),
    (lambda: cd.sample.grid(m=(1, 2, 2.5)), cd.ModelError, "2.5 is not a number of values"),
    (lambda: cd.sample.grid(m=(1, np.inf, 3)), cd.SolveError, "'m': value 1 is inf"),
    (lambda: cd.sample.grid(m=3.0), cd.ArgumentError, "give .low, high, count."),
    (lambda: cd.sample.grid(a=(0, 1, 1 << 20), b=(0, 1, 1 << 20)), cd.ModelError, "are more than"),
    (lambda: cd.sample.grid([1, 2]), cd.ArgumentError, "by name"),
    (
        lambda: cd.sample.random(9, {"a": (0, 1)}, seed=-1),
        cd.ArgumentError,
        "seed=-1: give a whole number",
    ),
    (lambda: cd.sample.uniform("a", 1), cd.ArgumentError, "low='a': give a number"),
    (lambda: cd.sample.random(0, {"a": (0, 1)}), cd.ArgumentError, "runs=0: give a whole number"),
    (lambda: cd.sample.random(9, {"a": (1, 0)}), cd.ModelError, "low must be below high"),
    (lambda: cd.sample.random(9, {"a": "x"}), cd.ArgumentError, "'a' is 'x'; give"),
    (lambda: cd.sample.sobol(100, {"a": (0, 1)}), cd.ModelError, "Take 64 or 128"),
    (lambda: cd.sample.normal(0, 0), cd.ModelError, "deviation must be positive"),
    (lambda: cd.sample.log_uniform(-1, 1), cd.ModelError, "0 < low < high"),
]


@each(("call", "kind", "words"), REFUSED)
def test_refused(call: Any, kind: type[Exception], words: str) -> None:
    with pytest.raises(kind, match=words):
        call()
