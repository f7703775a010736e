"""Internal states in steps of generalized-alpha: solved to rounding, or the step fails."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

import cardan as cd

SPAN, STEP = 0.05, 1e-3
both = pytest.mark.parametrize("coordinates", ["relative", "absolute"])


def free_body(name: str) -> cd.Scene:
    """A body that floats beside what is looked at."""
    scene = cd.Scene(name, gravity=(0, 0, 0))
    block = scene.body("block", mass=1.0, inertia=(0.1, 0.2, 0.3))
    scene.joint("J", cd.Free(), scene.ground, block)
    return scene


def diffusion(count: int, rate: float) -> tuple[cd.Scene, np.ndarray]:
    """A chain of states that level out, the last ones as fast as the first; its matrix."""
    scene = free_body("diffusion")
    z = [sp.Symbol(f"z{k}") for k in range(count)]
    A = rate * (np.eye(count, k=1) + np.eye(count, k=-1) - 2 * np.eye(count))
    changes = [sum(A[i, j] * z[j] for j in range(count) if A[i, j]) for i in range(count)]
    start = [float(k + 1) for k in range(count)]
    scene.force("chain", cd.Controller(states=z, changes=changes, start=start))
    return scene, A


@both
@pytest.mark.parametrize("rate", [1e2, 1e6])
def test_many_states_of_one_element_are_solved_together(rate: float, coordinates: str) -> None:
    scene, A = diffusion(12, rate)
    model = cd.compile(scene, coordinates=coordinates)
    errors = []
    for step in (STEP, STEP / 2):
        motion = model.simulate(SPAN, method=cd.GeneralizedAlpha(0.5), step=step)
        assert motion.success
        expected = expm(A * SPAN) @ np.arange(1.0, 13.0)
        errors.append(np.abs(motion.z[-1] - expected).max())
    if rate < 1e3:
        assert 3 < errors[0] / errors[1] < 5
    # stiff ones die out
    assert errors[1] < 1e-3


@both
def test_states_that_no_step_solves_stop_a_run_by_name(coordinates: str) -> None:
    scene, z = free_body("relay"), sp.Symbol("z")
    # towards 0.1 from either side, at once: an equation of a step has no solution there
    change = -1e6 * sp.sign(z - sp.Float(0.1))
    scene.force("relay", cd.Controller(states=[z], changes=[change], start=[0.0]))
    model = cd.compile(scene, coordinates=coordinates)
    with pytest.warns(cd.SolveWarning, match=r"relay.*step="):
        motion = model.simulate(SPAN, method=cd.GeneralizedAlpha(0.5), step=STEP)
    assert motion.status == "not_solved"
    assert motion.t[-1] < SPAN


@both
def test_states_that_a_shorter_step_solves_shorten_it(coordinates: str) -> None:
    # beyond its range a root is no number: a long step looks there, a short one does not
    scene, z = free_body("tank"), sp.Symbol("z")
    change = -40 * sp.sqrt(z) + 38
    scene.force("tank", cd.Controller(states=[z], changes=[change], start=[1.0]))
    model = cd.compile(scene, coordinates=coordinates)
    motion = model.simulate(1.0, method="GeneralizedAlpha", rtol=1e-7, atol=1e-9)
    assert motion.success
    assert motion["tank.z"][-1] == pytest.approx((38 / 40) ** 2, abs=1e-6)


@both
def test_small_states_are_solved_as_well_as_large_ones(coordinates: str) -> None:
    finals = []
    for size in (1.0, 1e-12):
        scene, z = free_body("scale"), sp.Symbol("z")
        change = -300 * z - (100 / size**2) * z**3
        scene.force("scale", cd.Controller(states=[z], changes=[change], start=[size]))
        model = cd.compile(scene, coordinates=coordinates)
        motion = model.simulate(0.01, method=cd.GeneralizedAlpha(0.5), step=STEP)
        finals.append(motion["scale.z"][-1] / size)
    assert finals[1] == pytest.approx(finals[0], rel=1e-11)


@both
def test_newmark_takes_internal_states_by_the_trapezoidal_rule(coordinates: str) -> None:
    scene, A = diffusion(3, 1e2)
    model = cd.compile(scene, coordinates=coordinates)
    motion = model.simulate(SPAN, method="Newmark", step=STEP)
    rule = np.linalg.solve(np.eye(3) - STEP / 2 * A, np.eye(3) + STEP / 2 * A)
    expected = np.linalg.matrix_power(rule, round(SPAN / STEP)) @ [1.0, 2.0, 3.0]
    assert motion.z[-1] == pytest.approx(expected, rel=1e-12)


def servo(time_constant: float = 0.05) -> cd.Scene:
    """A turning disk on a motor with current, which a controller with an integral commands."""
    scene = cd.Scene("servo", gravity=(0, 0, 0))
    disk = scene.body("disk", mass=1.0, inertia=(0.02, 0.02, 0.02))
    scene.joint("J", cd.Revolute("z"), scene.ground, disk, q0=0.4)
    q, u = scene.q("J"), scene.u("J")
    i, e = sp.symbols("i e")
    volts = -8 * q + 5 * e
    law = cd.Controller("J", (i, e), ((volts - i - 0.3 * u) / time_constant, -q), 0.3 * i)
    scene.force("winding", law)
    return scene


def servo_matrix(time_constant: float = 0.05) -> np.ndarray:
    """The same as x' = A x with x = [q, u, i, e]."""
    A = np.zeros((4, 4))
    A[0, 1], A[1, 2] = 1.0, 0.3 / 0.02
    A[2] = np.array([-8.0, -0.3, -1.0, 5.0]) / time_constant
    A[3, 0] = -1.0
    return A


@pytest.mark.parametrize(
    ("method", "coordinates"),
    [
        *(
            (name, kind)
            for name in ("GeneralizedAlpha", "HHT")
            for kind in ("relative", "absolute")
        ),
        # undamped, it takes no constraints
        ("Newmark", "relative"),
    ],
)
def test_a_linear_servo_converges_to_its_exponential(method: str, coordinates: str) -> None:
    model = cd.compile(servo(), coordinates=coordinates)
    expected = expm(servo_matrix() * 0.5) @ [0.4, 0.0, 0.0, 0.0]
    errors = []
    for step in (4e-3, 2e-3, 1e-3):
        motion = model.simulate(0.5, method=method, step=step)
        final = [motion["J"][-1], motion["J.u"][-1], *motion.z[-1]]
        errors.append(np.abs(final - expected).max())
    assert 3.5 < errors[0] / errors[1] < 4.5
    assert 3.7 < errors[1] / errors[2] < 4.3
    assert errors[2] < 1e-3


def test_steps_of_a_servo_are_those_of_the_rule() -> None:
    """One step of Newmark's method solves the trapezoidal rule for motion and states together."""
    model, A, h = cd.compile(servo()), servo_matrix(), 1e-2
    with pytest.warns(cd.SolveWarning, match="energy"):
        motion = model.simulate(h, method="Newmark", step=h)
    rule = np.linalg.solve(np.eye(4) - h / 2 * A, np.eye(4) + h / 2 * A)
    final = [motion["J"][-1], motion["J.u"][-1], *motion.z[-1]]
    assert final == pytest.approx(rule @ [0.4, 0.0, 0.0, 0.0], abs=1e-12)


def test_a_motor_faster_than_the_step_is_a_damper() -> None:
    model = cd.compile(servo(1e-6))
    A = servo_matrix(1e-6)
    motion = model.simulate(0.5, method="GeneralizedAlpha", rtol=1e-6, atol=1e-9)
    assert motion.success
    expected = expm(A * 0.5) @ [0.4, 0.0, 0.0, 0.0]
    assert motion["J"][-1] == pytest.approx(expected[0], abs=4e-5)


def test_states_go_on_from_files_and_in_ensembles(tmp_path: Path) -> None:
    model = cd.compile(servo())
    alone = [model.simulate(0.3, method="HHT", q={"J": q}) for q in (0.4, 0.1)]
    together = model.ensemble(0.3, method="HHT", q={"J": np.array([0.4, 0.1])})
    for k, motion in enumerate(alone):
        np.testing.assert_array_equal(together.run(k).x[-1], motion.x[-1])
    stepper = model.stepper(method="HHT")
    stepper.step(0.1)
    stepper.save(tmp_path / "run.npz")
    further = model.resume(tmp_path / "run.npz")
    np.testing.assert_array_equal(stepper.step(0.1), further.step(0.1))
