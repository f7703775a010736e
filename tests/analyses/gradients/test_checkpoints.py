"""Gradients with little memory: the schedule against its formula, repeated steps against rows."""

from __future__ import annotations

import functools
import re
import signal
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from analyses.gradients.test_gradients import TIGHT, ball, double_pendulum
from analyses.gradients.test_passes import UP, windows
from cardan.analyses.gradients.checkpoints import StepStore
from cardan.analyses.gradients.schedule import Action, repeated_steps, repeats, schedule
from cardan.analyses.simulation import run_record as abi
from cardan.analyses.simulation.run import Runner
from cardan.errors import ArgumentError, SolveError
from table import each


@functools.cache
def least(steps: int, checkpoints: int) -> int:
    """The fewest steps taken again, over every place of the next checkpoint."""
    if steps <= 1:
        return 0
    if checkpoints == 1:
        return steps * (steps - 1) // 2
    return min(
        ahead + least(steps - ahead, checkpoints - 1) + least(ahead, checkpoints)
        for ahead in range(1, steps)
    )


def counted(steps: int, checkpoints: int) -> tuple[int, dict[int, int]]:
    """Steps that a schedule repeats, in all and of each; what it does is checked on the way."""
    at, stored, reversed_steps = 0, [0], list[int]()
    taken: dict[int, int] = {}
    for action, step in schedule(steps, checkpoints):
        if action is Action.RESUME:
            stored = [one for one in stored if one <= step]
            assert stored[-1] == step
            at = step
        elif action is Action.ADVANCE:
            for one in range(at, step):
                taken[one] = taken.get(one, 0) + 1
            at = step
        elif action is Action.STORE:
            assert at == step
            stored.append(step)
            assert len(stored) <= checkpoints
        else:
            assert at == step
            reversed_steps.append(step)
            at += 1
    assert reversed_steps == list(range(steps))[::-1]
    return sum(taken.values()), taken


def test_the_schedule_is_as_short_as_can_be() -> None:
    for checkpoints in range(1, 9):
        for steps in range(1, 71):
            total, _ = counted(steps, checkpoints)
            assert total == repeated_steps(steps, checkpoints) == least(steps, checkpoints)


def test_repeats_follow_the_binomial_formula() -> None:
    """binomial(c + r, c) steps are the most that r repeats of each of them reverse."""
    for c, r, steps in ((3, 4, 35), (5, 3, 56), (10, 4, 1001), (20, 3, 1771), (1, 9, 10)):
        total, taken = counted(steps, c)
        assert max(taken.values()) == r == repeats(steps, c)
        assert repeats(steps + 1, c) == r + 1
        assert total == repeated_steps(steps, c) == r * steps - sp.binomial(c + r, r - 1)


Case = tuple[cd.CompiledModel, float, Any, Mapping[str, Any]]


def tree() -> Case:
    given = {"q": {"a": 1.0, "b": 0.5}, "wrt": ("x0", "p"), **TIGHT}
    return double_pendulum(), 3.0, cd.cost(final="a^2", running="b.u^2"), given


def stiff() -> Case:
    *case, given = tree()
    return (*case, {**given, "method": "Radau", "rtol": 1e-10, "atol": 1e-12})  # type: ignore


def fixed_steps() -> Case:
    *case, given = tree()
    return (*case, {**given, "method": "RK4", "step": 2e-3})  # type: ignore


def driven() -> Case:
    """Sampled controller, table of an input, unit quaternion."""
    scene = cd.Scene("driven", gravity=(0, 0, -9.81))
    body = scene.body("top", mass=2.0, com=(0.1, 0.05, 0.3), inertia=(0.1, 0.2, 0.25))
    scene.joint("tip", cd.Spherical(), scene.ground, body)
    scene.joint("x", cd.Prismatic("x"), body, scene.body("cart", mass=2.0))
    gain, total = scene.parameter("gain", 30.0), sp.Symbol("total")
    off = scene.q("x") - 0.2
    force = -gain * off - 8.0 * scene.u("x") - 5.0 * total
    pid = cd.Controller("x", states=[total], changes=[total + 0.02 * off], force=force, sample=0.02)
    scene.force("pid", pid)
    scene.force("push", cd.JointForce("x", scene.input("f")))
    table = (np.linspace(0, 2, 5), np.array([0.3, 1.0, -2.0, 0.5, 0.1]))
    given = {"q": {"x": 0.1}, "inputs": {"f": table}, "wrt": ("q0", "gain", "f"), **TIGHT}
    return cd.compile(scene), 2.0, cd.cost(final="x^2", running="x.u^2 + f^2"), given


def impacts() -> Case:
    given = {"q": {"z": 1.0}, "wrt": ("q0.z", "e"), "max_step": 5e-3, **TIGHT}
    return ball(), 2.5, cd.cost(final="z", running="z^2"), given


def ended() -> Case:
    *case, given = tree()
    events = {"low": ("b", -1.0)}
    return case[0], 9.0, cd.cost(final="t + a"), {**given, "events": events}


def branches() -> Case:
    """Loops, and a step over a place where they could fold: it has several rows."""
    given = {"wrt": ("u0.A0", "gravity.y"), "max_step": 4e-3, **TIGHT, **UP}
    return windows(), 1.0, cd.cost(final="x", running="A0^2"), given


def cable() -> Case:
    scene = cd.Scene("hanging bar", gravity=(0, 0, -9.81))
    E = scene.parameter("E", 5e6, unit="Pa")
    hub = scene.body("hub", mass=0.5, inertia=(0.01, 0.01, 0.01))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    rubber = cd.material(E=E, nu=0.45, rho=1100, damping=1e-3)
    bar = scene.beam("bar", hub, (1, 0, 0), cd.section.rectangle(0.02, 0.03), rubber, elements=1)
    scene.output("tip", bar.end.position()[2])
    given = {"wrt": ("E", "u0.hinge"), "u": {"hinge": 1.0}, "max_step": 1e-4}
    model = cd.compile(scene, coordinates="absolute")
    return model, 0.08, cd.cost(final="tip", running="hinge.u^2"), {**given, "method": "Radau"}


CASES = [tree, stiff, fixed_steps, driven, impacts, ended, branches, cable]


@each("make", CASES)
def test_repeated_steps_change_no_bit(make: Callable[[], Case]) -> None:
    model, t, cost, given = make()
    expected = model.gradient(t, cost, **given)
    assert expected.note == ""
    with pytest.raises(ArgumentError, match="at least") as refused:
        model.gradient(t, cost, memory=1.0, **given)
    smallest = int(re.findall(r"at least (\d+)", str(refused.value))[0])
    found = model.gradient(t, cost, memory=smallest, **given)
    assert found.motion is None
    assert "taken again" in found.note
    assert float(re.findall(r"again ([\d.]+) times", found.note)[0]) > 0
    assert found.value == expected.value
    for name, slope in expected.slope.items():
        np.testing.assert_array_equal(found.slope[name], slope, err_msg=name)


def test_more_memory_repeats_less() -> None:
    model, t, cost, given = fixed_steps()
    expected = model.gradient(t, cost, **given)
    again = []
    for memory in (3e4, 6e4, 2e5, 1e9):
        found = model.gradient(t, cost, memory=memory, **given)
        np.testing.assert_array_equal(found.slope["p"], expected.slope["p"])
        again += [float(x) for x in re.findall(r"again ([\d.]+) times", found.note)]
    # blocks but the last one are taken again at least once
    assert again == sorted(again, reverse=True)
    assert len(again) == 3
    assert again[0] > 1 > again[-1] > 0.5


def test_steps_that_differ_are_refused() -> None:
    """A function that is watched and remembers: it ends the run when steps are repeated."""
    model, calls = double_pendulum(), [0]

    def watched(t: float, x: np.ndarray) -> float:
        calls[0] += 1
        return 1.0 if calls[0] < first_pass + 100 else -1.0

    given = {"q": {"a": 1.0}, "method": "RK4", "step": 2e-3, "events": {"end": watched}}
    first_pass = 10**9
    expected = model.gradient(2.0, cd.cost(final="a"), **given)
    first_pass = calls[0]
    calls[0] = 0
    with pytest.raises(SolveError, match=r"differently.*depend on t and x alone"):
        model.gradient(2.0, cd.cost(final="a"), memory=4e4, **given)
    assert expected.note == ""


def test_ctrl_c_is_heard_while_steps_are_repeated(monkeypatch: pytest.MonkeyPatch) -> None:
    model, t, cost, given = fixed_steps()
    given = {**given, "memory": 3e4}
    expected = model.gradient(t, cost, **given)
    again, number = StepStore._again, [0]

    def interrupted(store: StepStore, *arguments: Any) -> Any:
        number[0] += 1
        drive = store.runner.drive

        def signaled(budget: int) -> int:
            store.runner.drive = drive  # type: ignore[method-assign]
            signal.raise_signal(signal.SIGINT)
            return drive(budget)

        if number[0] == last:
            store.runner.drive = signaled  # type: ignore[method-assign]
        return again(store, *arguments)

    monkeypatch.setattr(StepStore, "_again", interrupted)
    # ahead to a checkpoint, and with rows
    for last in range(1, 6):
        number[0] = 0
        with pytest.raises(KeyboardInterrupt):
            model.gradient(t, cost, **given)
        assert number[0] == last
    last = 0
    np.testing.assert_array_equal(model.gradient(t, cost, **given).slope["p"], expected.slope["p"])


def test_ctrl_c_is_heard_before_the_first_row(monkeypatch: pytest.MonkeyPatch) -> None:
    """As in a model in Python, whose first call it may come in."""
    model, t, cost, given = tree()
    monkeypatch.setattr(Runner, "start", lambda *_: abi.STOPPED)
    with pytest.raises(KeyboardInterrupt):
        model.gradient(t, cost, **given)


def test_several_runs_say_each() -> None:
    model, t, cost, _ = fixed_steps()
    found = model.gradient(
        t, cost, wrt="m1", method="RK4", step=2e-3, memory=1e5, vary={"a": [0.2, 0.3]}
    )
    assert found.motion == (None, None)
    assert len(found.note.splitlines()) == 2


def test_growth_within_a_motion_is_no_matter_of_memory() -> None:
    """Speeds that fall by 1e14 and rise again: their gradient is 1, however long blocks are."""
    scene = cd.Scene("brake")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("law", cd.JointForce("x", -100 * sp.cos(sp.pi * cd.t) * scene.u("x")))
    model, cost = cd.compile(scene), cd.cost(final="x.u")
    for memory in (1e9, 1.2e4):
        slope = model.gradient(1.0, cost, wrt="u0.x", u={"x": 1.0}, memory=memory, atol=1e-25).slope
        # the integral of the drag over a half turn is 0
        assert slope["u0.x"] == pytest.approx(1.0, rel=1e-4)
