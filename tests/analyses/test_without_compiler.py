"""Runs against SciPy's integrators, with a compiler and without one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd

# two routes to one solution: each is right to some multiple of its tolerance
FINE = {"rtol": 1e-11, "atol": 1e-12}
AGREE = {"rtol": 0, "atol": 1e-8}


CASES: dict[str, tuple[str, Any, dict[str, Any]]] = {
    "adaptive": ("double", 1.0, {"q": {"elbow": 0.4}, **FINE}),
    "fixed step": ("double", 0.3, {"q": {"elbow": 0.4}, "method": "RK4", "step": 1e-3}),
    "implicit": ("double", 0.3, {"q": {"elbow": 0.4}, "method": "Radau", **FINE}),
    "implicit quaternion": (
        "ball",
        0.2,
        {"u": {"base": [1, 2, 3, 0, 1, 2]}, "method": "Radau", "rtol": 1e-9, "atol": 1e-10},
    ),
    "order 5": ("double", 1.0, {"q": {"elbow": 0.4}, "method": "RK45", **FINE}),
    "backward": ("double", (1.0, 0.2), {"u": {"elbow": 0.4}, **FINE}),
    "at times": ("double", np.linspace(0, 1, 13), {"q": {"elbow": 0.4}, **FINE}),
    "corners": ("double", 1.0, {"inputs": {"torque": ([0, 0.3, 0.3, 1], [0, 1, -1, 0.5])}, **FINE}),
    "function": ("double", 0.5, {"inputs": {"torque": lambda t, x: np.sin(t) - x[0]}, **FINE}),
    "sampled": (
        "double",
        0.5,
        {"inputs": {"torque": lambda t, x: np.sin(t) - x[0]}, "sample": 0.1, **FINE},
    ),
    "quaternion": ("ball", 1.0, {"u": {"base": [1, 2, 3, 0, 1, 2]}, **FINE}),
    "quaternion at times": (
        "ball",
        np.linspace(0, 1, 7),
        {"u": {"base": [1, 2, 3, 0, 1, 2]}, **FINE},
    ),
    "moved": (
        "crank",
        1.0,
        {"inputs": {"angle": (np.linspace(0, 1, 6), np.sin(np.linspace(0, 1, 6)))}, **FINE},
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_same_motion_as_compiled(case: str, bare: Any, request: pytest.FixtureRequest) -> None:
    name, t, options = CASES[case]
    model = request.getfixturevalue(name)
    compiled = model.simulate(t, **options)
    # what it reads is compiled too, while there is a compiler
    summary = repr(compiled)
    plain = bare(model).simulate(t, **options)
    assert plain.success
    assert "pip install 'cardan[compiler]'" in repr(plain)
    assert "pip install" not in summary
    assert plain.t[-1] == compiled.t[-1]
    np.testing.assert_allclose(plain.x[-1], compiled.x[-1], **AGREE)
    np.testing.assert_allclose(plain.work_done[-1], compiled.work_done[-1], **AGREE)
    np.testing.assert_allclose(plain.r[-1], compiled.r[-1], **AGREE)
    assert plain.solver_info.defaulted == compiled.solver_info.defaulted
    assert plain.sources == compiled.sources
    np.testing.assert_allclose(plain.energy_residual[-1], compiled.energy_residual[-1], **AGREE)
    if np.ndim(t) == 1 and not isinstance(t, tuple):
        np.testing.assert_array_equal(plain.t, compiled.t)
        np.testing.assert_allclose(plain.x, compiled.x, **AGREE)
        return
    # dense output means the same: between the steps too
    inside = np.linspace(*sorted((compiled.t[0], compiled.t[-1])), 40)
    np.testing.assert_allclose(plain.at(inside), compiled.at(inside), **AGREE)
    resampled = plain.resample(inside)
    np.testing.assert_allclose(resampled.r, compiled.resample(inside).r, rtol=0, atol=1e-3)


@pytest.mark.parametrize("options", [FINE, {"method": "RK4", "step": 1e-3}], ids=str)
def test_stepper(double: cd.CompiledModel, bare: Any, options: dict[str, Any]) -> None:
    motion = double.simulate(0.4, q={"elbow": 0.4}, inputs={"torque": 0.3}, **options)
    stepper = bare(double).stepper(q={"elbow": 0.4}, inputs={"torque": 0.3}, **options)
    stepper.step(0.2)
    saved = stepper.save()
    state = stepper.step(0.2)
    np.testing.assert_allclose(state, motion.x[-1], **AGREE)
    stepper.restore(saved)
    assert stepper.t == pytest.approx(0.2)
    np.testing.assert_array_equal(stepper.step(0.2), state)
    stepper.step(-0.4)
    np.testing.assert_allclose(stepper.state, motion.x[0], **AGREE)
    with pytest.raises(cd.ModelError, match="another stepper"):
        stepper.restore(double.stepper().save())


def test_interrupt_keeps_what_was_computed(double: cd.CompiledModel, bare: Any) -> None:
    def torque(t: float, x: np.ndarray) -> float:
        if t > 0.3:
            raise KeyboardInterrupt
        return 0.0

    model = bare(double)
    with pytest.warns(cd.SolveWarning, match="interrupted at"):
        motion = model.simulate(1.0, q={"elbow": 0.4}, inputs={"torque": torque})
    assert motion.status == "interrupted"
    assert 0.0 < motion.t[-1] <= 0.3


def test_error_of_an_input_is_the_users(double: cd.CompiledModel, bare: Any) -> None:
    def torque(t: float, x: np.ndarray) -> float:
        if t > 0.5:
            raise ZeroDivisionError("mine")
        return 0.0

    with pytest.raises(cd.FunctionError, match="ZeroDivisionError: mine") as told:
        bare(double).simulate(1.0, inputs={"torque": torque})
    assert isinstance(told.value.__cause__, ZeroDivisionError)
    assert 0 < told.value.motion.t[-1] <= 0.5


def test_breakdown_is_told(bare: Any) -> None:
    """A force that grows without bound in finite time: u' = u^2 ends at t = 1."""
    scene = cd.Scene("burst", gravity=(0, 0, 0))
    body = scene.body("body", mass=1.0, com=(0, 0, 0), inertia=(1, 1, 1))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, body, u0=1.0)
    scene.force("push", cd.JointForce("rail", scene.u("rail") ** 2))
    model = bare(cd.compile(scene))
    with pytest.warns(cd.SolveWarning, match="stopped at t = "):
        motion = model.simulate(2.0)
    assert motion.status in ("step_too_small", "not_finite")
    assert motion.t[-1] == pytest.approx(1.0, abs=1e-3)


def test_given_steps_in_a_gimbal_lock_end_alike(bare: Any) -> None:
    scene = cd.Scene("ball", gravity=(0, 0, 0))
    ball = scene.body("ball", mass=1.0, com=(0, 0, 0), inertia=(1, 1, 1))
    scene.joint("pivot", cd.Spherical(rotation="XYZ"), scene.ground, ball)
    start: dict[str, Any] = {"q": {"pivot": [0.3, 1.57, -0.5]}, "u": {"pivot": [0.0, 1.0, 0.3]}}
    start |= {"t": 1.0, "method": "RK4", "step": 0.05}
    model = cd.compile(scene)
    with pytest.warns(cd.SolveWarning, match="rotation='quaternion' has no such limits"):
        compiled = model.simulate(**start)
    with pytest.warns(cd.SolveWarning, match="rotation='quaternion' has no such limits"):
        plain = bare(model).simulate(**start)
    assert plain.status == compiled.status == "singular_rotation"
    assert plain.message == compiled.message
    np.testing.assert_allclose(plain.x, compiled.x, **AGREE)


def test_steps_into_a_contact_that_go_too_far_are_shortened(bare: Any) -> None:
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, inertia=(0.01, 0.02, 0.03))
    scene.joint("base", cd.Free(), scene.ground, body)
    frame = body.at(0.05, 0, 0)
    floor = cd.Contact(frame, scene.ground, radius=0.1, stiffness=1e4, damping=0.3, mu=0.4)
    scene.force("floor", floor)
    compiled = cd.compile(scene)
    given = {"q": {"base": [1, 0, 0, 0, 0, 0, 0.3]}, "u": {"base": [3, 1, -2, 0.5, 0, 0]}}
    fine = compiled.simulate(0.25, rtol=1e-9, atol=1e-12, **given)
    motion = bare(compiled).simulate(0.25, **given)
    assert motion.success, motion.message
    assert [e.name for e in motion.events] == [e.name for e in fine.events]
    np.testing.assert_allclose(motion.x[-1], fine.x[-1], rtol=0, atol=1e-3)
