"""Sensitivities along motions, at their times and between them."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

from analyses.gradients.test_gradients import TIGHT, difference, double_pendulum
from cardan import compile as compile_scene
from cardan import cost as cost_of
from cardan.errors import ModelError, SolveError
from laws.circuits import compiled
from laws.circuits import start as closed_start
from laws.event_scenes import bouncing


def test_sensitivities_at_any_time() -> None:
    """Between the rows, and against differences of whole motions."""
    model, names = double_pendulum(), ("m2", "q0.a", "x0")
    given = {"q": {"a": 1.0, "b": 0.5}, "u": {"a": 0.2}, **TIGHT}
    motion = model.simulate(2.0, sensitivity=names, **given)
    times = np.array([0.0, 0.123, 1.7, 2.0])
    found = motion.sensitivity.at(times)
    assert found["m2"].shape == (4, 4)
    assert found["x0"].shape == (4, 4, 4)
    np.testing.assert_array_equal(found["m2"][0], 0.0)
    np.testing.assert_array_equal(found["x0"][0], np.eye(4))
    np.testing.assert_allclose(found["m2"][-1], motion.sensitivity["m2"][-1], rtol=1e-14)

    def states(by: float) -> Any:
        return model.simulate(times, parameters={"m2": 1.0 + by}, **given).x

    slope = (states(1e-4) - states(-1e-4)) / 2e-4
    np.testing.assert_allclose(found["m2"], slope, atol=1e-6)
    with pytest.raises(SolveError, match="from 0 s to 2 s"):
        motion.sensitivity.at(2.5)
    with pytest.raises(ModelError, match=r"'m1' was not asked for"):
        motion.sensitivity["m1"]
    with pytest.raises(ModelError, match="checkpoint"):
        model.simulate(1.0, sensitivity="m2", checkpoint="x.run", **given)
    with pytest.raises(ModelError, match=r"sensitivity.at"):
        model.simulate(times, sensitivity="m2", **given)


def test_pickles_keep_sensitivities() -> None:
    motion = double_pendulum().simulate(0.5, q={"a": 1.0}, sensitivity=("m2", "x0"))
    copy = pickle.loads(pickle.dumps(motion))
    for name in ("m2", "x0"):
        np.testing.assert_array_equal(copy.sensitivity[name], motion.sensitivity[name])


def test_one_coordinate_of_a_joint_is_named() -> None:
    """The others of its joint follow from the loop, and so do their derivatives."""
    model = compiled("cam")
    q, u = closed_start(model, "cam", 0.3)
    place, speed = model.coordinates.index("edge.s"), model.speeds.index("edge.u.s")
    cost = cost_of(final="edge.s + 0.3*post.a")

    def run(dq: float = 0.0, du: float = 0.0, **given: Any) -> Any:
        start = {"q": {"edge.s": q[place] + dq}, "u": {"edge.u.s": u[speed] + du}}
        return model.gradient(0.1, cost, wrt=("q0", "u0", "p"), **TIGHT, **start, **given)

    slope = run().slope
    by_q, by_u = slope["q0"][speed], slope["u0"][speed]
    assert by_q == pytest.approx(difference(lambda s: run(dq=s).value, 1e-3), rel=1e-7)
    assert by_u == pytest.approx(difference(lambda s: run(du=s).value, 1e-3), rel=1e-7)
    # what was not named follows
    np.testing.assert_allclose(np.delete(slope["q0"], speed), 0.0, atol=1e-14)
    names = list(model.parameters)
    for name in ("post.position.x", "edge.child.position.z"):

        def value(by: float, name: str = name) -> float:
            return run(parameters={name: model.parameters[name] + by}).value

        found = slope["p"][names.index(name)]
        assert found == pytest.approx(difference(value, 1e-3), rel=1e-7)


def test_steps_too_long_for_a_stiff_force_are_refused() -> None:
    """A ball falls straight: nothing slides, but a change would, and friction damps it in 4 us."""
    scene, q = bouncing()
    model = compile_scene(scene)
    given = {"x0": model.initial(q=q)}
    cost = cost_of(final="J.u.px")
    with pytest.raises(SolveError, match=r"stiff force.*Radau"):
        model.gradient(0.3, cost, wrt="u0", **given)
    with pytest.raises(SolveError, match=r"stiff force.*Radau"):
        model.simulate(0.3, sensitivity="u0", method="DOP853", **given)
    slope = model.gradient(0.3, cost, wrt="u0", method="Radau", **given).slope["u0"]

    def speed(by: float) -> float:
        x0 = given["x0"].copy()
        x0[model.nq + 3] += by
        return float(
            model.simulate(0.3, x0=x0, method="Radau", rtol=1e-10, atol=1e-13)["J.u.px"][-1]
        )

    assert slope[3] == pytest.approx((speed(1e-7) - speed(-1e-7)) / 2e-7, rel=1e-5)
