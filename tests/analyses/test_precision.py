"""Speed against error of integrators: references, what is left out, recommendations, interrupts."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.simulation.precision import runs
from cardan.analyses.simulation.precision.runs import precision
from cardan.analyses.simulation.precision.work_precision import Point, PrecisionRecord
from cardan.schema.integrators import INTEGRATORS
from mechanisms import ZOO

START: dict[str, Any] = {"q": {"shoulder": 1.0, "elbow": -0.5}}


@cache
def pendulum() -> cd.CompiledModel:
    return cd.compile(ZOO["double_pendulum"].build())


@pytest.fixture(scope="module")
def found() -> PrecisionRecord:
    return precision(pendulum(), 1.0, **START)


def test_every_integrator_is_there_or_named(found: PrecisionRecord) -> None:
    measured = {point.method for point in found.points}
    assert measured | set(found.left_out) == set(INTEGRATORS)
    assert found.left_out["RKMK4"] == "the same as RK4: no joint here turns by a quaternion"
    done = [point for point in found.points if point.status == "finished"]
    assert len(done) > 50
    assert all(point.milliseconds > 0 and point.steps > 0 for point in done)


def test_references_agree_and_errors_fall_with_the_tolerance(found: PrecisionRecord) -> None:
    assert "DOP853 and Radau at rtol 1e-13" in found.reference
    assert found.doubt < 1e-11
    for method in ("DOP853", "RK45", "Radau", "Rosenbrock", "RK4"):
        errors = [point.error for point in found.points if point.method == method]
        assert errors[0] > 1e-6
        assert errors[-1] < 1e-10


def test_errors_are_those_of_a_run(found: PrecisionRecord) -> None:
    point = next(p for p in found.points if p.method == "RK45" and p.value == 1e-4)
    times = np.linspace(0, 1, runs.OUTPUTS)
    model = pendulum()
    rough = model.simulate(times, method="RK45", rtol=1e-4, atol=1e-7, **START)
    fine = model.simulate(times, rtol=1e-13, atol=1e-15, **START)
    assert point.error == pytest.approx(np.abs(rough.q - fine.q).max(), rel=1e-6)
    assert point.evaluations == rough.statistics["evaluations"]


def test_recommendation_names_the_quickest(found: PrecisionRecord) -> None:
    for goal in (1e-3, 1e-6, 1e-9):
        first = found.best(goal)[0]
        assert first.error <= goal
        kept = [p.milliseconds for p in found.points if max(p.error, found.doubt) <= goal]
        assert first.milliseconds == min(kept)
        assert f"for an error of {goal:.0e}: {first.description}" in found.recommendation
        assert INTEGRATORS[first.method].applies in found.recommendation


def test_a_stiff_motion_is_said_to_be() -> None:
    scene = cd.Scene("stiff", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5))
    tip = scene.body("tip", mass=1.0)
    scene.joint("swing", cd.Revolute("y"), scene.ground, rod)
    scene.joint("stretch", cd.Prismatic("z"), rod.at(0, 0, -1), tip)
    scene.force("spring", cd.JointSpring("stretch", stiffness=1e7, damping=1e4))
    made = precision(cd.compile(scene), 1.0, ["DOP853", "Rosenbrock"], q={"swing": 1.0})
    assert "the motion is stiff: stability limited" in made.recommendation
    assert made.best(1e-3)[0].method == "Rosenbrock"


def test_quaternions_of_either_sign_and_lie_groups() -> None:
    model = cd.compile(ZOO["spherical_quaternion"].build())
    start = model.random_state(1)
    made = precision(model, 0.5, ["RK45", "RKMK45", "RK4"], x0=start)
    assert not made.left_out
    assert all(min(p.error for p in made.points if p.method == m) < 1e-9 for m in ("RK45", "RK4"))


def test_what_rests_is_not_compared() -> None:
    made = precision(pendulum(), 0.1, ["RK45", "RK4"])
    assert made.recommendation.startswith("nothing moves from this start")
    # not all settings, none of which has anything to do
    assert made.table().row_count == len({point.method for point in made.points})


def test_patience_ends_a_method_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(runs, "STEPS", (100, 2_000_000_000))
    made = precision(pendulum(), 1.0, ["RK4"], patience=0.05, **START)
    assert [point.steps for point in made.points] == [100]
    assert made.left_out == {"RK4": "step 5e-10 takes more than 0.05 s"}


def test_an_interrupt_keeps_what_was_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = runs.Bench._point

    def third(self: Any, name: str, setting: str, value: float, how: Any) -> Point:
        if value < 5e-5:
            raise KeyboardInterrupt
        return whole(self, name, setting, value, how)

    monkeypatch.setattr(runs.Bench, "_point", third)
    made = precision(pendulum(), 1.0, ["DOP853", "RK45"], **START)
    assert made.interrupted
    assert [point.value for point in made.points] == pytest.approx([1e-2, 1e-3, 1e-4])


REFUSED: dict[str, tuple[dict[str, Any], str]] = {
    "method": ({"methods": ["DOP583"]}, "'DOP583' does not exist.* Did you mean 'DOP853'"),
    "patience": ({"patience": 0.0}, "patience=0: it must be a positive time"),
    "name": ({"q": {"elbw": 1.0}}, "Did you mean 'elbow'"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_wrong_use(case: str) -> None:
    options, words = REFUSED[case]
    with pytest.raises(cd.ModelError, match=words):
        precision(pendulum(), 1.0, **options)


def test_report_with_a_time_has_both(capsys: pytest.CaptureFixture[str]) -> None:
    made = pendulum().report(0.2, methods=["DOP853"], **START)
    assert any(row.function == "rhs" for row in made.rows)
    assert made.methods is not None
    assert "for an error of 1e-06: DOP853" in capsys.readouterr().out
