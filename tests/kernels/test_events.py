"""When events happen, against closed forms."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.special import ellipk

from cardan.errors import ModelError, SolveWarning
from cardan.runtime.trajectory.trajectory import TrajectoryRecord
from kernels.problem import OSCILLATOR, Problem, pendulum

G, RESTITUTION = 9.81, 0.8
FALL = "out[0] = u[0]; out[1] = -9.81;"
BOUNCE = "out[0] = e[0] != 0 ? -0.8 * u[0] : u[0];"


def ball(folder: Path, **changed: Any) -> Problem:
    """A ball that falls from a height and bounces."""
    given: dict[str, Any] = {"events": "out[0] = q[0];", "transition": BOUNCE, "kinds": ("impact",)}
    return Problem(folder, FALL, **(given | changed))


def bounces(height: float, count: int) -> Any:
    """When the ball meets the floor (count,)."""
    first = np.sqrt(2 * height / G)
    flights = 2 * first * RESTITUTION ** np.arange(1, count)
    return first + np.concatenate([[0.0], np.cumsum(flights)])


def when(motion: TrajectoryRecord, name: str = "") -> Any:
    """Times of the events of a name, of all without one."""
    return np.array([event.t for event in motion.events if name in ("", event.name)])


# transitions


@pytest.mark.parametrize("options", [{}, {"method": "RK4", "step": 0.01}, {"method": "RK45"}])
def test_a_ball_bounces_when_it_must(options: dict[str, Any], tmp_path: Path) -> None:
    motion = ball(tmp_path).run(3.0, [1, 0], **options)
    times = bounces(1.0, 6)
    # parabolas are followed to rounding
    np.testing.assert_allclose(when(motion), times, rtol=0, atol=1e-12)
    for event in motion.events:
        assert event.kind == "impact"
        assert event.element == "a0"
        assert event.x_after[1] == -RESTITUTION * event.x[1]
        # two rows, and the one behind counts
        np.testing.assert_array_equal(motion.x[motion.t == event.t], [event.x, event.x_after])
        np.testing.assert_array_equal(motion.at(event.t), event.x_after)
        assert motion.at(np.nextafter(event.t, 0.0))[1] == pytest.approx(event.x[1], rel=1e-12)
    assert motion.statistics["events"] == 6
    # what is between is as good as what is kept
    inside = np.linspace(0, 3, 301)
    height = motion.at(inside)[:, 0]
    k = np.searchsorted(times, inside, side="right")
    start = np.where(k > 0, times[np.maximum(k, 1) - 1], 0.0)
    speed = np.where(k > 0, times[0] * G * RESTITUTION**k, 0.0)
    d = inside - start
    np.testing.assert_allclose(height, (k == 0) + speed * d - G / 2 * d**2, rtol=0, atol=1e-12)


def test_wanted_times_get_what_lies_behind_events(tmp_path: Path) -> None:
    # falls for 1 s from such a height; the event is at a wanted time
    start = [G / 2, 0.0]
    dense = ball(tmp_path).run(2.0, start)
    t = when(dense)[0]
    motion = ball(tmp_path).run(np.array([0.0, 0.5, t, 2.0]), start)
    assert len(motion) == 4
    assert motion.u[2, 0] == pytest.approx(RESTITUTION * G, rel=1e-12)
    np.testing.assert_allclose(motion.x, dense.at(motion.t), rtol=0, atol=1e-12)


def test_bounces_that_do_not_end_are_chatter(tmp_path: Path) -> None:
    with pytest.warns(SolveWarning, match=r"'e0' of 'a0' happens ever again"):
        motion = ball(tmp_path).run(30.0, [1, 0])
    assert motion.status == "chatter"
    fall = np.sqrt(2 / G)
    end = fall + 2 * fall * RESTITUTION / (1 - RESTITUTION)
    # bounces below the rounding of heights are not told apart: some 1e-7 s each
    assert motion.t[-1] == pytest.approx(end, abs=1e-5)
    assert len(motion.events) > 50
    assert np.abs(motion.x[-1]).max() < 1e-5


def test_a_ball_at_rest_on_the_floor_is_chatter(tmp_path: Path) -> None:
    with pytest.warns(SolveWarning, match="comes to rest"):
        motion = ball(tmp_path).run(1.0, [0, 0])
    assert motion.status == "chatter"
    assert motion.t[-1] < 1e-4


def test_what_is_violated_at_the_start_happens_there(tmp_path: Path) -> None:
    motion = ball(tmp_path).run(0.1, [-0.5, -2.0])
    assert when(motion).tolist() == [0.0]
    np.testing.assert_array_equal(motion.x[:2], [[-0.5, -2.0], [-0.5, 1.6]])
    np.testing.assert_array_equal(motion.t[:2], [0.0, 0.0])


def test_events_that_cause_themselves_are_a_storm(tmp_path: Path) -> None:
    stuck = ball(tmp_path, transition="out[0] = u[0];", events="out[0] = u[0] + 1;")
    with pytest.warns(SolveWarning, match=r"'e0' of 'a0' happens (again and again|ever again)"):
        motion = stuck.run(1.0, [0, 0.0])
    assert motion.status in ("event_storm", "chatter")
    assert motion.t[-1] < 0.2
    jump = ball(tmp_path, transition="out[0] = 2 * u[0];", events="out[0] = u[0] + 1;")
    with pytest.warns(SolveWarning, match="again and again at this one time"):
        assert jump.run(1.0, [0, -2.0]).status == "event_storm"


def test_two_events_of_one_time_happen_together(tmp_path: Path) -> None:
    # two balls from heights that differ by rounding only
    both = Problem(
        tmp_path,
        "out[0] = u[0]; out[1] = u[1]; out[2] = out[3] = -9.81;",
        nq=2,
        nu=2,
        events="out[0] = q[0]; out[1] = q[1];",
        transition="out[0] = e[0] ? -u[0] : u[0]; out[1] = e[1] ? -0.5 * u[1] : u[1];",
        kinds=("impact", "impact"),
    )
    motion = both.run(0.6, [1.0, 1.0 + 2e-16, 0, 0])
    assert [event.name for event in motion.events] == ["e0", "e1"]
    assert motion.events[0].t == motion.events[1].t
    speed = np.sqrt(2 * G)
    np.testing.assert_allclose(motion.events[0].x_after[2:], [speed, 0.5 * speed], rtol=1e-12)
    assert len(motion.event_log.log) == 1


def test_events_one_after_the_other_in_one_step(tmp_path: Path) -> None:
    # uniform motion: one step would do for all of it
    steady = Problem(
        tmp_path,
        "out[0] = u[0]; out[1] = 0;",
        s=("count",),
        events="out[0] = s[0] == 0 ? 0.301 - q[0] : 1; out[1] = 0.3010001 - q[0];",
        transition="out[0] = u[0]; out[1] = s[0] + e[0];",
        kinds=("mode", "mark"),
    )
    motion = steady.run(1.0, [0, 1])
    assert [event.name for event in motion.events] == ["e0", "e1"]
    np.testing.assert_allclose(when(motion), [0.301, 0.3010001], rtol=1e-14)
    np.testing.assert_array_equal(
        motion["count"], np.arange(len(motion)) > np.flatnonzero(motion.t == when(motion)[0])[0]
    )
    assert motion.resample([0.3, when(motion)[0], 0.4])["count"].tolist() == [0, 1, 1]


# times


@pytest.mark.parametrize("method", ["DOP853", "RK45", "Radau"])
def test_a_pendulum_passes_its_lowest_point_in_time(method: str, tmp_path: Path) -> None:
    swing = Problem(tmp_path, "out[0] = u[0]; out[1] = -9.81 * sin(q[0]);")
    amplitude = 2.0
    period = 4 / np.sqrt(G) * ellipk(np.sin(amplitude / 2) ** 2)
    seen = {"low": (("q0", 0.0), "mark")}
    tolerances, errors = 10.0 ** -np.arange(4, 12), []
    for rtol in tolerances:
        motion = swing.run(9.5, [amplitude, 0], rtol=rtol, atol=rtol, method=method, events=seen)
        times = when(motion)
        wanted = period * (0.25 + 0.5 * np.arange(len(times)))
        assert len(times) == 7
        # later ones have the error of some 50 steps before them
        assert abs(times[0] - wanted[0]) <= 10 * rtol
        errors.append(np.abs(times - wanted).max())
    assert (errors <= 30 * tolerances).all()
    slope = np.polyfit(np.log(tolerances), np.log(errors), 1)[0]
    assert 0.85 < slope < 1.3


def test_times_converge_with_the_order_of_the_dense_output(tmp_path: Path) -> None:
    problem = Problem(tmp_path, OSCILLATOR)
    errors, steps = [], np.array([0.2, 0.1, 0.05])
    for step in steps:
        options = {"method": "RK4", "step": step, "events": {"up": (("q0", 0.3), "mark")}}
        found = when(problem.run(6.0, [1, 0], **options))
        wanted = [np.arccos(0.3), 2 * np.pi - np.arccos(0.3)]
        errors.append(np.abs(found - wanted).max())
    slopes = np.diff(np.log(errors)) / np.diff(np.log(steps))
    # steps and the cubic between them are both of order 4
    assert (slopes > 3.7).all()


def test_an_event_that_only_just_happens_is_seen(tmp_path: Path) -> None:
    # cos t dips below -1 + depth for a moment inside a long step
    problem = Problem(tmp_path, OSCILLATOR)
    for depth in (1e-3, 1e-6, 1e-9):
        touch = {"low": (("q0", -1 + depth), "mark")}
        motion = problem.run(6.0, [1, 0], rtol=1e-12, atol=1e-12, events=touch)
        half = np.arccos(1 - depth)
        np.testing.assert_allclose(when(motion), [np.pi - half, np.pi + half], rtol=0, atol=1e-6)
    miss = {"low": (("q0", -1 - 1e-9), "mark")}
    assert not problem.run(6.0, [1, 0], rtol=1e-12, atol=1e-12, events=miss).events


@pytest.mark.parametrize("at", [0.5, 1.0])
def test_an_event_at_a_stop_or_at_the_end(at: float, tmp_path: Path) -> None:
    steady = Problem(tmp_path, "out[0] = 1; out[1] = r[0];", inputs=("push",))
    push = {"push": ([0, 0.5, 0.5, 1], [0, 0, 1, 1])}
    end = steady.run(1.0, [-at, 0], inputs=push, events={"zero": ("q0", 0.0)})
    mark = steady.run(1.0, [-at, 0], inputs=push, events={"zero": (("q0", 0.0), "mark")})
    assert end.status == "event"
    assert end.t[-1] == pytest.approx(at, abs=1e-15)
    assert len(when(mark)) == 1
    assert mark.t[-1] == 1.0
    assert mark.u[-1, 0] == pytest.approx(0.5, abs=1e-13)


def test_an_event_at_the_start_needs_to_come_from_above(tmp_path: Path) -> None:
    problem = Problem(tmp_path, OSCILLATOR)
    # sin t: zero at the start, then at pi and 2 pi
    motion = problem.run(7.0, [0, 1], rtol=1e-10, events={"zero": (("q0", 0.0), "mark")})
    np.testing.assert_allclose(when(motion), [np.pi, 2 * np.pi], rtol=0, atol=1e-8)


def test_directions(tmp_path: Path) -> None:
    problem = Problem(tmp_path, OSCILLATOR)
    options: dict[str, Any] = {"rtol": 1e-10, "atol": 1e-12}
    found = {}
    for way in ("down", "up", "both"):
        watch = {"half": (lambda t, x: x[0] - 0.5, "mark", way)}
        found[way] = when(problem.run(7.0, [0, 1], events=watch, **options))
    up, down = np.pi / 6, 5 * np.pi / 6
    np.testing.assert_allclose(found["up"], [up, up + 2 * np.pi], rtol=0, atol=1e-8)
    np.testing.assert_allclose(found["down"], [down], rtol=0, atol=1e-8)
    np.testing.assert_allclose(found["both"], [up, down, up + 2 * np.pi], rtol=0, atol=1e-8)


def test_backward_runs_know_marks_and_ends(tmp_path: Path) -> None:
    problem = Problem(tmp_path, OSCILLATOR)
    watch = {"zero": (("q0", 0.0), "mark"), "stop": (lambda t, x: t + 4.0)}
    motion = problem.run((0.0, -7.0), [1, 0], rtol=1e-10, events=watch)
    assert motion.status == "event"
    assert motion.t[-1] == pytest.approx(-4.0, abs=1e-14)
    np.testing.assert_allclose(when(motion, "zero"), [-np.pi / 2], rtol=0, atol=1e-9)
    with pytest.raises(ModelError, match=r"'e0' changes the state.*forward only"):
        ball(tmp_path).run((0.0, -1.0), [1, 0])


def test_many_events(tmp_path: Path) -> None:
    fast = Problem(tmp_path, "out[0] = u[0]; out[1] = -40000 * q[0];")
    end = 3.0
    motion = fast.run(end, [1, 0], rtol=1e-9, atol=1e-9, events={"zero": (("q0", 0.0), "mark")})
    count = int(200 * end / np.pi + 0.5)
    wanted = (0.5 + np.arange(count)) * np.pi / 200
    np.testing.assert_allclose(when(motion), wanted, rtol=0, atol=1e-7)


def test_marks_change_nothing(tmp_path: Path) -> None:
    problem = Problem(tmp_path, OSCILLATOR)
    alone = problem.run(20.0, [1, 0])
    watched = problem.run(20.0, [1, 0], events={"zero": (("q0", 0.0), "mark")})
    np.testing.assert_array_equal(alone.t, watched.t)
    np.testing.assert_array_equal(alone.x, watched.x)


# loops, internal states, samples


def test_events_are_found_on_the_constraints(tmp_path: Path) -> None:
    rod = pendulum(tmp_path)
    motion = rod.run(3.0, [1, 0, 0, 0], rtol=1e-9, events={"low": ("q0", 0.0)})
    x = motion.x[-1]
    # at the lowest point: speed from the height it fell
    np.testing.assert_allclose(x[:2], [0, -1], rtol=0, atol=1e-12)
    assert x[2] == pytest.approx(-np.sqrt(2 * G), abs=1e-7)


def test_internal_states_and_ticks(tmp_path: Path) -> None:
    # z' = s - z, and s is set to 1 - z every 0.25 s: a sampled controller of a lag
    lag = Problem(
        tmp_path,
        "out[0] = u[0]; out[1] = 0; out[2] = s[0] - z[0];",
        z=("motor.lag",),
        s=("held",),
        events="out[0] = 1;",
        transition="out[0] = u[0]; out[1] = z[0]; out[2] = e[0] ? 1 - z[0] : s[0];",
        kinds=("tick",),
        ticks=({"event": 0, "period": 0.25, "phase": 0.0},),
    )
    motion = lag.run(1.1, [0, 0, 0], rtol=1e-11, atol=1e-12)
    assert motion.events == ()
    np.testing.assert_array_equal([tick.t for tick in motion.ticks], [0, 0.25, 0.5, 0.75, 1.0])
    # one row of each time, with what is held from there on
    assert len(np.unique(motion.t)) == len(motion)
    for tick in motion.ticks:
        assert motion["held"][motion.t == tick.t] == tick.s_after
    z, wanted = 0.0, []
    for _ in range(4):
        held = 1 - z
        z = held + (z - held) * np.exp(-0.25)
        wanted.append(z)
    np.testing.assert_allclose(motion.at([0.25, 0.5, 0.75, 1.0])[:, 2], wanted, rtol=0, atol=1e-11)
    np.testing.assert_array_equal(motion["motor.lag"], motion.z[:, 0])
    assert motion["held"][-1] == pytest.approx(1 - wanted[-1], abs=1e-11)
    # a run over times sees the same
    listed = lag.run(np.array([0.0, 0.25, 0.6]), [0, 0, 0], rtol=1e-11, atol=1e-12)
    np.testing.assert_allclose(listed.x, motion.at(listed.t), rtol=0, atol=1e-10)
    np.testing.assert_array_equal(listed["held"][0], 1.0)
