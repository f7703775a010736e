"""What cannot be run is said before anything runs, in the user's names."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd

VALUES = np.linspace(0, 1, 5)
BAD = np.array([0.0, 0.1, np.nan])

CASES: dict[str, tuple[dict[str, Any], type[Exception], str]] = {
    "nothing differs": ({}, cd.ModelError, "nothing differs between the runs"),
    "NaN in x0": (
        {"x0": np.array([[0, 0, 0, 0], [0, np.nan, 0, 0]])},
        cd.SolveError,
        "x0: 'elbow' of run 1 is nan",
    ),
    "NaN in q": ({"q": {"elbow": BAD}}, cd.SolveError, "'elbow' of run 2 is nan"),
    "infinite input": (
        {"inputs": {"torque": np.array([1.0, np.inf])}},
        cd.SolveError,
        "'torque' of run 1 is inf",
    ),
    "unknown coordinate": ({"q": {"ellbow": VALUES}}, cd.ModelError, "Did you mean 'elbow'"),
    "unknown parameter": (
        {"parameters": {"uper.mass": VALUES}},
        cd.ModelError,
        "Did you mean 'upper.mass'",
    ),
    "unknown in plan": ({"vary": {"elbov": VALUES}}, cd.ModelError, "Did you mean 'elbow'"),
    "structural": (
        {"vary": {"shoulder.axis.y": VALUES}},
        cd.ModelError,
        "'shoulder.axis.y' is structural",
    ),
    "negative mass": (
        {"parameters": {"upper.mass": -VALUES - 1}},
        cd.ModelError,
        "'upper.mass' is a mass",
    ),
    "unknown input": ({"inputs": {"torqe": VALUES}}, cd.ModelError, "Did you mean 'torque'"),
    "two lengths": (
        {"q": {"elbow": VALUES}, "u": {"elbow": np.zeros(4)}},
        cd.ArgumentError,
        "has values for 4 runs, q={'elbow': ...} says 5",
    ),
    "wrong width": ({"x0": np.zeros((3, 5))}, cd.ArgumentError, r"x0 has shape \(3, 5\)"),
    "wrong rank": ({"q": {"elbow": np.zeros((3, 2, 2))}}, cd.ArgumentError, "has shape"),
    "text": ({"q": {"elbow": ["a", "b"]}}, cd.ArgumentError, "elbow"),
    "twice": (
        {"q": {"elbow": VALUES}, "vary": {"elbow": VALUES}},
        cd.ModelError,
        "coordinate 'elbow' is given twice",
    ),
    "start twice": (
        {"x0": np.zeros((5, 4)), "q": {"elbow": VALUES}},
        cd.ModelError,
        "the start is given twice",
    ),
    "runs": ({"runs": 0}, cd.ArgumentError, "runs=0: give a whole number"),
    "other runs": ({"runs": 4, "q": {"elbow": VALUES}}, cd.ArgumentError, "runs= says 4"),
    "tolerance": ({"vary": {"elbow": VALUES}, "rtol": -1.0}, cd.ModelError, "rtol=-1"),
    "no tolerance": (
        {"vary": {"elbow": VALUES}, "rtol": 0.0, "atol": 0.0},
        cd.ModelError,
        "one may be 0",
    ),
    "method": ({"vary": {"elbow": VALUES}, "method": "RK54"}, cd.ModelError, "Did you mean 'RK4"),
    "time": ({"vary": {"elbow": VALUES}, "t": -1.0}, cd.ModelError, "t=-1"),
    "lanes": ({"vary": {"elbow": VALUES}, "lanes": 3}, cd.ModelError, "lanes=3"),
    "threads": (
        {"vary": {"elbow": VALUES}, "threads": 0},
        cd.ModelError,
        "threads=0 is not a number of",
    ),
    "threads below 0": ({"vary": {"elbow": VALUES}, "threads": -1}, cd.ModelError, "all cores"),
    "threads in words": ({"vary": {"elbow": VALUES}, "threads": "2"}, cd.ArgumentError, "='2'"),
    "distribution not called": (
        {"vary": {"elbow": cd.sample.normal}, "runs": 3},
        cd.ModelError,
        r"vary 'elbow' is a function; call it .* cd.sample.normal\(1, 2\)",
    ),
    "another function": ({"q": {"elbow": max}}, cd.ModelError, r"cd.sample.uniform\(1, 2\)"),
    "plan not called": ({"vary": cd.sample.grid}, cd.ArgumentError, "vary=.*: give a Plan"),
    "list alone": ({"vary": [1, 2]}, cd.ArgumentError, r"vary=\[1, 2\]: give a Plan"),
    "no names": ({"parameters": [1.0]}, cd.ArgumentError, r"parameters=\[1.0\]: give"),
    "number as name": ({"vary": {3: VALUES}}, cd.ArgumentError, "vary={3: .*by name"),
    "lengths of vary": (
        {"vary": {"elbow": [1, 2], "shoulder": [1, 2, 3]}},
        cd.ArgumentError,
        "vary 'shoulder' has values for 3 runs, vary 'elbow' says 2",
    ),
    "seed": ({"runs": 3, "seed": "x"}, cd.ArgumentError, "seed='x': give a whole number"),
    "reduction": ({"vary": {"elbow": VALUES}, "reduce": 3}, cd.ArgumentError, "reduce=3: give"),
    "file": ({"vary": {"elbow": VALUES}, "checkpoint": 3}, cd.ArgumentError, "checkpoint=3: give"),
    "missing values": (
        {"vary": {"elbow": VALUES}, "inputs": {"torque": ([0, 0.5], [0, 1])}},
        cd.ModelError,
        "has values from 0 s to 0.5 s, the run goes from 0 s to 1 s",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_said_beforehand(case: str, double: cd.CompiledModel) -> None:
    options, kind, words = CASES[case]
    with pytest.raises(kind, match=words):
        double.ensemble(**{"t": 1.0} | options)


def test_a_rotation_of_length_0(ball: cd.CompiledModel) -> None:
    states = np.tile(ball.initial(), (3, 1))
    states[1, :4] = 0
    with pytest.raises(cd.SolveError, match=r"run 1: the quaternion at 'base.qw' has length 0"):
        ball.ensemble(1.0, x0=states)


def test_tolerances_that_cannot_be_met_end_with_a_status(double: cd.CompiledModel) -> None:
    with pytest.warns(cd.SolveWarning, match="3 of 3 runs did not reach their end"):
        made = double.ensemble(1.0, vary={"elbow": [0.1, 0.2, 0.3]}, rtol=0.0, atol=1e-60)
    assert set(made.status) == {"step_too_small"}
    assert "tighter than it can be computed" in made.message(2)
    assert "step_too_small" in repr(made)
    with pytest.raises(cd.SolveError, match="no step is small enough"):
        double.ensemble(1.0, vary={"elbow": [0.1]}, runs=1, rtol=0, atol=1e-60, check=True)


def test_results_by_name(double: cd.CompiledModel) -> None:
    made = double.ensemble(1.0, vary={"elbow": VALUES})
    np.testing.assert_array_equal(made["shoulder.u"], made.final[:, 2])
    np.testing.assert_array_equal(made.varied["elbow"], VALUES)
    with pytest.raises(cd.ModelError, match=r"it was not kept.*Did you mean 'shoulder'"):
        made["sholder"]
    with pytest.raises(cd.ArgumentError, match="there are runs 0 to 4"):
        made.run(5)
    np.testing.assert_array_equal(made.run(-1).x[-1], made.final[4])


def test_a_run_that_starts_beyond_a_stop_is_not_begun() -> None:
    scene = cd.Scene("gate")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("gate", mass=1.0))
    scene.force("limit", cd.Stop("x", upper=0.4))
    model = cd.compile(scene)
    for more in ({}, {"sensitivity": "q0.x"}):
        with pytest.warns(cd.SolveWarning, match="1 of 3 runs"):
            runs = model.ensemble(0.1, vary={"x": [-0.1, 0.5, 0.4]}, **more)
        assert list(runs.status) == ["finished", "not_begun", "finished"]
        assert "beyond its upper stop" in runs.messages[1]
