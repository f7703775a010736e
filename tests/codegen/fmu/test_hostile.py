"""Calls that make no sense: refused with a message, and the instance goes on."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from codegen.fmu.importing import Instance, description, unit
from codegen.running import compilers

pytestmark = pytest.mark.skipif(not compilers(), reason="needs a C compiler")
BOTH = pytest.mark.parametrize("version", ["3.0", pytest.param("2.0", marks=pytest.mark.slow)])


def refused(one: Instance, call: Callable[[], Any], message: str, status: int = 3) -> None:
    with pytest.raises(Exception, match=f"failed with status {status}"):
        call()
    assert message in one.messages[-1]


@BOTH
def test_value_references_that_do_not_exist(version: str) -> None:
    with Instance(unit("door", version)) as one:
        one.references["nothing"] = 99_999
        refused(one, lambda: one.get("nothing"), "value reference 99999")
        refused(one, lambda: one.set({"nothing": 1.0}), "value reference 99999")
        one.begin()
        refused(one, lambda: one.derivative(["nothing"], ["rail"], [1.0]), "99999")
        refused(one, lambda: one.derivative(["der(rail)"], ["nothing"], [1.0]), "99999")
        refused(one, lambda: one.derivative(["der(rail)"], ["energy.total"], [1.0]), "not one to")
        one.step(0.0, 0.1)


@BOTH
def test_calls_out_of_order(version: str) -> None:
    with Instance(unit("door", version)) as one:
        refused(one, lambda: one.step(0.0, 0.1), "not allowed in the state Instantiated")
        refused(one, lambda: one.get("energy.total"), "from Initialization Mode on")
        refused(one, one.fmu.exitInitializationMode, "not allowed in the state Instantiated")
        one.enter()
        refused(one, lambda: one.step(0.0, 0.1), "Initialization Mode")
        one.fmu.exitInitializationMode()
        refused(one, one.fmu.exitInitializationMode, "Step Mode")
        one.step(0.0, 0.1)
        one.fmu.terminate()
        refused(one, lambda: one.step(0.1, 0.1), "Terminated")
        one.fmu.reset()
        one.begin()
        one.step(0.0, 0.1)


@BOTH
@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_numbers_that_are_not_finite(version: str, value: float) -> None:
    with Instance(unit("door", version)) as one:
        one.begin()
        before = one.get("goal")
        refused(one, lambda: one.set({"goal": value}), "'goal'")
        assert one.get("goal") == before
        refused(one, lambda: one.step(0.0, value), "positive and finite")
        one.step(0.0, 0.1)


@BOTH
@pytest.mark.parametrize(
    ("name", "message"),
    [("rail", "is a state"), ("energy.total", "is computed"), ("friction", "is computed")],
)
def test_what_cannot_be_set(version: str, name: str, message: str) -> None:
    with Instance(unit("door", version)) as one:
        one.begin()
        refused(one, lambda: one.set({name: 0.5}), message)


@BOTH
def test_steps_that_make_no_sense(version: str) -> None:
    with Instance(unit("door", version)) as one:
        one.begin()
        refused(one, lambda: one.step(0.0, 0.0), "must be positive")
        refused(one, lambda: one.step(0.0, -0.1), "must be positive")
        refused(one, lambda: one.step(0.5, 0.1), "the FMU is at")
        one.step(0.0, 0.1)
        assert one.get("time") == [0.1]


@BOTH
def test_parameters_out_of_range(version: str) -> None:
    with Instance(unit("door", version)) as one:
        refused(one, lambda: one.set({"ends.restitution": 1.5}), "out of its range")
        least = {v.name: (v.min, v.max) for v in one.about.modelVariables}["ends.restitution"]
        assert [float(x) for x in least] == [0.0, 1.0]


@BOTH
def test_a_start_behind_a_stop(version: str) -> None:
    with Instance(unit("door", version)) as one:
        one.set({"rail": -0.5})
        refused(one, one.begin, "start within its range")


@BOTH
def test_loops_that_cannot_be_closed(version: str) -> None:
    with Instance(unit("four_bar", version)) as one:
        one.set({"B.position.x": 5.0})
        refused(one, one.begin, "loops cannot be closed")


@BOTH
def test_the_wrong_token(version: str) -> None:
    about = description(unit("door", version))
    guid = about.guid
    try:
        about.guid = "{wrong}"
        with pytest.raises(Exception, match=r"instantiate|Instantiate|Failed"):
            Instance(unit("door", version))
    finally:
        about.guid = guid


def test_other_types_are_refused() -> None:
    with Instance(unit("door", "3.0")) as one:
        refused(one, lambda: one.fmu.getInt32([1]), "of the type Float64")
        refused(one, lambda: one.fmu.setBoolean([1], [True]), "of the type Float64")


@pytest.mark.slow
def test_other_types_are_refused_by_fmi_2() -> None:
    with Instance(unit("door", "2.0")) as one:
        refused(one, lambda: one.fmu.getInteger([1]), "of the type Real")


@BOTH
def test_a_motion_that_ends_within_a_step(version: str, tmp_path: Path) -> None:
    scene = cd.Scene("ending")
    scene.joint("x", cd.Prismatic("z"), scene.ground, scene.body("mass", mass=1.0))
    scene.force("end", cd.Event(scene.q("x") + 1.0, terminal=True))
    path = cd.derive(scene).export(tmp_path / "x.fmu", fmi=version)
    expected = math.sqrt(2 / 9.81)
    with Instance(path) as one:
        one.begin()
        one.step(0.0, 0.4)
        if version == "3.0":
            _, terminate, _, last = one.step(0.4, 0.4)
            assert terminate
            assert last == pytest.approx(expected, abs=1e-9)
        else:
            refused(one, lambda: one.step(0.4, 0.4), "the motion ended", 2)
            assert one.fmu.getBooleanStatus(3)
            assert one.fmu.getRealStatus(2) == pytest.approx(expected, abs=1e-9)
        assert one.get("x") == pytest.approx([-1.0], abs=1e-9)


@BOTH
def test_a_singular_model_says_so(version: str, tmp_path: Path) -> None:
    """A body whose mass is set to 0 cannot accelerate."""
    scene = cd.Scene("light")
    mass = scene.parameter("m", 1.0, unit="kg")
    scene.joint("x", cd.Prismatic("z"), scene.ground, scene.body("mass", mass=mass))
    path = cd.derive(scene).export(tmp_path / "x.fmu", fmi=version)
    with Instance(path) as one:
        one.set({"m": 0.0})
        with pytest.raises(Exception, match="failed with status"):
            one.begin()
        assert "first at 'x.u'" in one.messages[-1]


@BOTH
def test_tunable_parameters(version: str) -> None:
    """A mass that changes between two steps: what moves from there is as if it had been so."""
    with Instance(unit("pendulum", version)) as one, Instance(unit("pendulum", version)) as other:
        one.begin(1e-10, 2.0)
        one.step(0.0, 0.5)
        names = ["shoulder", "elbow", "shoulder.u", "elbow.u"]
        x = one.get(*names)
        one.set({"l": 0.7})
        one.step(0.5, 0.5)
        other.set({"l": 0.7, **dict(zip(names, x, strict=True))})
        other.begin(1e-10, 2.0)
        other.step(0.0, 0.5)
        assert one.get(*names) == pytest.approx(other.get(*names), abs=1e-8)


@pytest.mark.slow
def test_input_derivatives_of_fmi_2() -> None:
    """Inputs as polynomials over a step: a cubic push by one long step and by many short ones."""
    with Instance(unit("cart", "2.0")) as one, Instance(unit("cart", "2.0")) as other:
        for each in (one, other):
            each.set({"push": 1.0})
            each.begin(1e-10, 1.0)
        reference = [one.references["push"]]
        one.fmu.setRealInputDerivatives(reference * 3, [1, 2, 3], [2.0, -4.0, 6.0])
        one.step(0.0, 1.0)
        n = 2000
        for k in range(n):
            t = (k + 0.5) / n
            other.set({"push": 1 + 2 * t - 2 * t**2 + t**3})
            other.step(k / n, 1 / n)
        assert one.get("push") == pytest.approx([2.0])
        assert one.get("track", "pin") == pytest.approx(other.get("track", "pin"), abs=1e-6)
    with Instance(unit("cart", "2.0")) as one:
        one.begin()
        call = one.fmu.setRealInputDerivatives
        refused(one, lambda: call(reference, [4], [1.0]), "orders are 1 to 3")
        refused(one, lambda: call([one.references["track"]], [1], [1.0]), "is not an input")


def test_quaternions_drift_and_come_back() -> None:
    """In model exchange the direction of a quaternion counts; far off, an event normalizes it."""
    with Instance(unit("tumbling"), "me") as one:
        one.begin()
        one.update()
        one.fmu.enterContinuousTimeMode()
        x, rates = one.states(), one.rates()
        longer = x.copy()
        longer[:4] *= 1.01
        one.set_states(longer)
        stretched = rates.copy()
        stretched[:4] *= 1.01
        assert one.rates() == pytest.approx(stretched, rel=1e-13, abs=1e-13)
        enter, _ = one.fmu.completedIntegratorStep()
        assert enter
        one.fmu.enterEventMode()
        assert one.update()[3]
        assert np.linalg.norm(one.states()[:4]) == pytest.approx(1.0, abs=1e-15)
        assert one.states() == pytest.approx(x, abs=1e-14)


def test_loops_drift_and_close_again() -> None:
    with Instance(unit("four_bar"), "me") as one:
        one.begin(1e-8)
        one.update()
        one.fmu.enterContinuousTimeMode()
        x = one.states()
        assert not one.fmu.completedIntegratorStep()[0]
        one.set_states(x + 1e-4)
        assert one.fmu.completedIntegratorStep()[0]
        one.fmu.enterEventMode()
        assert one.update()[3]
        one.fmu.enterContinuousTimeMode()
        assert not one.fmu.completedIntegratorStep()[0]
        assert np.abs(one.states() - x).max() < 1e-3
