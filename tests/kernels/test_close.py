"""Projection onto constraints: what is kept is closed, what cannot be closed ends the run."""

from __future__ import annotations

import inspect
import pickle
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cardan.analyses.simulation.stepper import stepper
from cardan.errors import SolveWarning
from cardan.runtime.trajectory.storage import load
from cardan.runtime.trajectory.trajectory import TrajectoryRecord
from cardan.view.motion_files import save
from kernels.problem import METHODS, PENDULUM_POSITION, PENDULUM_VELOCITY, Problem, pendulum

FINE: dict[str, dict[str, Any]] = {
    name: {"method": name} | ({"rtol": 1e-8, "atol": 1e-10} if m.adaptive else {"step": 1e-3})
    for name, m in METHODS.items()
}
BOTH = pytest.mark.parametrize("options", FINE.values(), ids=FINE)
START = [1.0, 0, 0, 0]


def residuals(motion: TrajectoryRecord) -> tuple[float, float]:
    """Largest residual of length and of its rate."""
    return rest(motion.q, motion.u)


def rest(q: np.ndarray, u: np.ndarray) -> tuple[float, float]:
    length = 0.5 * ((q * q).sum(axis=1) - 1)
    return float(np.abs(length).max()), float(np.abs((q * u).sum(axis=1)).max())


@BOTH
def test_every_state_that_is_kept_is_closed(options: dict[str, Any], tmp_path: Path) -> None:
    motion = pendulum(tmp_path).run(20.0, START, **options)
    position, velocity = residuals(motion)
    # the bound of the projection and a rounding; rates at speeds up to 4.5
    assert position <= 1.1e-14
    assert velocity <= 5e-14
    # what came out is what the ledger says, to the rounding of this sum
    ledger = motion.ledger
    assert ledger is not None
    worst = ledger.position["rod.length"]
    assert abs(worst.after - position) <= 1e-15
    assert worst.before >= worst.after
    assert abs(ledger.velocity["rod.length"].after - velocity) <= 5e-15
    assert 0 <= worst.before_at <= 20


@BOTH
def test_rows_between_steps_are_closed(options: dict[str, Any], tmp_path: Path) -> None:
    motion = pendulum(tmp_path).run(np.linspace(0, 5, 321), START, **options)
    position, velocity = residuals(motion)
    assert position <= 1.1e-14
    assert velocity <= 5e-14


def test_same_motion_as_in_the_angle(tmp_path: Path) -> None:
    angle = Problem(tmp_path / "angle", "out[0] = u[0]; out[1] = -9.81 * sin(q[0]);")
    (tmp_path / "angle").mkdir()
    times = np.linspace(0, 10, 101)
    options = {"rtol": 1e-12, "atol": 1e-13}
    free = angle.run(times, [np.pi / 2, 0], **options)
    closed = pendulum(tmp_path).run(times, START, **options)
    expected = np.stack([np.sin(free.q[:, 0]), -np.cos(free.q[:, 0])], axis=1)
    np.testing.assert_allclose(closed.q, expected, rtol=0, atol=1e-9)


def test_projection_does_not_lower_the_order(tmp_path: Path) -> None:
    ends = [
        pendulum(tmp_path).run(2.0, START, method="RK4", step=h).x[-1]
        for h in (0.02, 0.01, 0.005, 5e-4)
    ]
    errors = [np.abs(x - ends[-1]).max() for x in ends[:-1]]
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert (orders > 3.7).all(), orders


def test_start_is_projected(tmp_path: Path) -> None:
    motion = pendulum(tmp_path).run(1.0, [1.2, 0.1, 0.3, 1.0])
    assert np.hypot(*motion.q[0]) == pytest.approx(1, abs=1e-14)
    assert motion.q[0] @ motion.u[0] == pytest.approx(0, abs=1e-14)
    np.testing.assert_allclose(motion.q[0] * np.hypot(1.2, 0.1), [1.2, 0.1], rtol=0, atol=1e-12)


@BOTH
def test_restart_is_bit_for_bit(options: dict[str, Any], tmp_path: Path) -> None:
    problem: Any = pendulum(tmp_path)
    walk = inspect.unwrap(stepper)(problem, x0=START, **options)
    walk.step(0.37)
    saved = walk.save()
    first = [walk.step(0.1) for _ in range(5)]
    ledger = walk._runner.ledger
    walk.restore(saved)
    assert walk._runner.ledger != ledger
    again = [walk.step(0.1) for _ in range(5)]
    np.testing.assert_array_equal(first, again)
    assert walk._runner.ledger == ledger


# where motion is not defined

NEVER = """
    {position}
    if (t > 0.5) {{ out[0] = q[0]; out[1] = q[1]; out[2] = 1e-3; }}
"""
JUMP = """
    {position}
    if (t > 0.5 && q[0] < 100) {{ out[0] = q[0] + 1000; out[1] = q[1]; out[2] = 1e-6; }}
    if (q[0] > 100) out[2] = 0;
"""


@BOTH
def test_what_does_not_close_names_time_and_joint(options: dict, tmp_path: Path) -> None:
    problem = pendulum(tmp_path, position=NEVER.format(position=PENDULUM_POSITION))
    said = r"at t = 0\.(5|49\d*) s of 2 s: motion is not defined here: joint 'rod' \(position of"
    with pytest.warns(SolveWarning, match=said):
        motion = problem.run(2.0, START, **options)
    assert motion.status == "not_closed"
    assert motion.t[-1] == pytest.approx(0.5, abs=2e-3)
    assert residuals(motion)[0] <= 1.1e-14


@BOTH
def test_a_jump_to_another_branch_is_refused(options: dict, tmp_path: Path) -> None:
    problem = pendulum(tmp_path, position=JUMP.format(position=PENDULUM_POSITION))
    said = "jump to another branch" if "rtol" in options else "Take step= shorter"
    with pytest.warns(SolveWarning, match=said):
        motion = problem.run(2.0, START, **options)
    assert motion.status == "not_closed"
    assert np.abs(motion.q).max() < 1.1


@BOTH
def test_a_start_that_cannot_be_closed(options: dict, tmp_path: Path) -> None:
    problem = pendulum(tmp_path, position=PENDULUM_POSITION + "out[2] = 1;")
    with pytest.warns(SolveWarning, match=r"'rod'.* cannot be closed from this start.*assemble"):
        motion = problem.run(2.0, START, **options)
    np.testing.assert_array_equal(motion.x, [START])


@BOTH
def test_rates_that_do_not_close(options: dict, tmp_path: Path) -> None:
    problem = pendulum(tmp_path, velocity=PENDULUM_VELOCITY + "if (t > 0.5) out[2] = 0.0 / 0.0;")
    with pytest.warns(SolveWarning, match=r"joint 'rod' \(velocity of 'rod.length'\)"):
        motion = problem.run(2.0, START, **options)
    assert motion.status == "not_closed"


def test_constraints_of_speeds_alone(tmp_path: Path) -> None:
    """A blade that cannot slip sideways: its force alone would let it drift."""
    problem = pendulum(
        tmp_path,
        # the velocity turns at 1 rad/s by a force from its side
        rhs="out[0] = u[0]; out[1] = u[1]; out[2] = -u[1]; out[3] = u[0];",
        position="",
        velocity="""
            real a = u[1] * cos(t) - u[0] * sin(t);
            out[0] = u[0] + a * sin(t); out[1] = u[1] - a * cos(t); out[2] = a;
        """,
        held="out[0] = -sin(t); out[1] = cos(t);",
        multipliers=({"name": "blade.side", "unit": "N", "joint": "blade", "level": "velocity"},),
    )
    motion = problem.run(20.0, [0, 0, 1, 0], rtol=1e-6)
    side = motion.u[:, 1] * np.cos(motion.t) - motion.u[:, 0] * np.sin(motion.t)
    assert np.abs(side).max() <= 2e-14
    assert motion.ledger is not None
    assert motion.ledger.position == {}
    assert motion.ledger.velocity["blade.side"].before > 1e-12


def test_the_ledger_travels_with_the_motion(tmp_path: Path) -> None:
    motion = pendulum(tmp_path).run(2.0, START)
    energy = {"kinetic": 0.5 * (motion.u**2).sum(axis=1), "potential": 9.81 * motion.q[:, 1]}
    history = {"constraints": 0.5 * ((motion.q**2).sum(axis=1) - 1)[:, None]}
    alone = replace(motion, model=None, sources=(), stored=energy | history)
    ledger = alone.ledger
    assert ledger is not None
    words = str(ledger.position["rod.length"])
    assert f"position of 'rod.length' to {words}" in repr(alone)
    assert "velocity of 'rod.length' to " in repr(alone)
    back = load(save(alone, tmp_path / "run.nc"))
    again = pickle.loads(pickle.dumps(alone))
    for other in (back, again):
        assert other.ledger == motion.ledger
        assert repr(other) == repr(alone)
        np.testing.assert_array_equal(other.constraints["rod.length"], history["constraints"][:, 0])
