"""Events of scenes with beams against beams written by hand, and against rigid bodies."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd

Array = Any
LENGTH, EI, RHO_A, HEAD, GRAVITY, LOWER = 1.0, 10.0, 1.0, 0.1, 1.0, -0.006


def cantilever(elements: int, **stop: float) -> cd.Scene:
    """A beam that falls from rest, with a body at its tip that meets a stop."""
    scene = cd.Scene("cantilever", gravity=(0, 0, -GRAVITY))
    section = cd.section.general(EA=1e6, GA=1e6, GJ=EI, EI=EI, rhoA=RHO_A, rhoI=1e-6)
    light = {"mass": 1e-6, "inertia": (1e-9,) * 3}
    carrier, runner = scene.body("carrier", **light), scene.body("runner", **light)
    head = scene.body("head", mass=HEAD, inertia=(1e-6,) * 3)
    scene.joint("rail", cd.Prismatic("z"), scene.ground.at(LENGTH, 0, 0), carrier)
    scene.joint("run", cd.Prismatic("x"), carrier, runner)
    scene.joint("tilt", cd.Revolute("y"), runner, head)
    scene.beam("beam", scene.ground, head, section, elements=elements, up="z")
    if stop:
        scene.force("stop", cd.Stop("rail", **stop))
    return scene


def hermite(n: int) -> tuple[Array, Array, Array]:
    """M, K and loads of a clamped Euler-Bernoulli beam with n elements and a body at its tip."""
    h, size = LENGTH / n, 2 * n + 2
    M, K, f = np.zeros((size, size)), np.zeros((size, size)), np.zeros(size)
    k = [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h],
         [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]  # fmt: skip
    m = [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h],
         [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]  # fmt: skip
    for e in range(n):
        at = slice(2 * e, 2 * e + 4)
        K[at, at] += EI / h**3 * np.array(k)
        M[at, at] += RHO_A * h / 420 * np.array(m)
        f[at] -= RHO_A * GRAVITY * np.array([h / 2, h * h / 12, h / 2, -h * h / 12])
    M[-2, -2] += HEAD
    f[-2] -= HEAD * GRAVITY
    return M[2:, 2:], K[2:, 2:], f[2:]


def fine(f: Any, x: Array, what: Any) -> Any:
    """A motion until something passes zero from above."""
    what.terminal, what.direction = True, -1
    return solve_ivp(f, (0, 3), x, events=what, rtol=1e-10, atol=1e-12, method="DOP853")


def test_the_tip_of_a_cantilever_meets_a_stop_and_leaves_it() -> None:
    model = cd.compile(cantilever(2, lower=LOWER, restitution=0.0))
    motion = model.simulate(0.12, step=1e-4, method=cd.GeneralizedAlpha(0.8))
    M, K, f = hermite(2)
    n, tip = len(M), len(M) - 2
    free = fine(
        lambda t, x: np.concatenate([x[n:], np.linalg.solve(M, f - K @ x[:n])]),
        np.zeros(2 * n),
        lambda t, x: x[tip] - LOWER,
    )
    x, hit = free.y[:, -1], free.t[-1]
    # the impulse along the tip takes its speed
    along = np.linalg.solve(M, np.eye(n)[tip])
    x[n:] -= along * x[n + tip] / along[tip]

    def force(x: Array) -> float:
        """Of the stop."""
        return float(-np.linalg.solve(M, f - K @ x[:n])[tip] / along[tip])

    lying = fine(
        lambda t, x: np.concatenate([x[n:], np.linalg.solve(M, f - K @ x[:n]) + along * force(x)]),
        x,
        lambda t, x: force(x),
    )
    names = [event.name for event in motion.events]
    assert names[:2] == ["stop.lower", "stop.release"]
    times = [event.t for event in motion.events]
    # shear and mixed form change frequencies a little
    assert times[0] == pytest.approx(hit, rel=1e-4)
    assert times[1] - times[0] == pytest.approx(lying.t[-1], rel=1e-2)
    between = (motion.t > times[0] + 1e-9) & (motion.t < times[1] - 1e-9)
    assert motion["rail"][between] == pytest.approx(LOWER, abs=1e-9)


ROD, SMALL = 0.4, {"mass": 0.1, "inertia": (1e-3,) * 3}


def slider_crank(stiffness: float, coulomb: float = 1.5) -> cd.Scene:
    """A slider-crank whose coupler is a beam of some stiffness, or rigid for 0."""
    scene = cd.Scene("slider crank", gravity=(0, 0, -9.81))
    crank = scene.body("crank", mass=1.0, com=(0.1, 0, 0), inertia=(0.01, 0.02, 0.02))
    block = scene.body("block", mass=0.4, inertia=(0.01,) * 3)
    one, two = scene.body("one", **SMALL), scene.body("two", **SMALL)
    scene.joint("A", cd.Revolute("y"), scene.ground, crank)
    scene.joint("B", cd.Revolute("y"), crank.at(0.2, 0, 0), one)
    scene.joint("S", cd.Prismatic("x"), scene.ground.at(0.7, 0, 0), block)
    if stiffness:
        scene.joint("C", cd.Revolute("y"), block, two)
        values = {"EA": 1e3, "GA": 1e3, "GJ": 1.0, "EI": 1.0}
        section = cd.section.general(
            **{name: stiffness * value for name, value in values.items()}, rhoA=ROD, rhoI=1e-5
        )
        scene.beam("coupler", one, two, section, elements=2, up="y")
    else:
        # its mass and inertia as of a line
        rod = scene.body("rod", mass=0.5 * ROD, inertia=cd.inertia.rod(0.5 * ROD, 0.5, axis="x"))
        scene.joint("middle", cd.Fixed(), one.at(0.25, 0, 0), rod)
        scene.joint("end", cd.Fixed(), one.at(0.5, 0, 0), two)
        scene.joint("C", cd.Revolute("y"), two, block)
    if coulomb:
        scene.force("rub", cd.Friction("S", coulomb=coulomb))
    return scene


def test_a_stiff_coupler_rubs_as_a_rigid_one() -> None:
    rigid = cd.compile(slider_crank(0)).simulate(1.0, q={"A": 0.3}, rtol=1e-9, atol=1e-10)
    method, errors = cd.GeneralizedAlpha(0.5), []
    assert [event.name for event in rigid.events] == ["rub.stop"]
    for stiffness in (1e2, 1e4):
        model = cd.compile(slider_crank(stiffness))
        motion = model.simulate(1.0, q={"A": 0.3}, step=5e-4, method=method)
        stop = next(event.t for event in motion.events if event.name == "rub.stop")
        errors.append((abs(stop - rigid.events[0].t), abs(motion["A"][-1] - rigid["A"][-1])))
    assert max(errors[1]) < 2e-4
    assert min(errors[0]) > 1e-3
    # friction changes the motion
    without = cd.compile(slider_crank(1e2, 0)).simulate(1.0, q={"A": 0.3}, step=5e-4, method=method)
    assert abs(without["A"][-1] - rigid["A"][-1]) > 0.1


def flexible_arm(stiffness: float, sample: float | None, kp: float = 40.0) -> cd.Scene:
    """A load on an arm that a controller turns, rigid for 0."""
    scene = cd.Scene("arm", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(0.2, 0.3, 0.2))
    load = scene.body("load", mass=0.2, inertia=(1e-4,) * 3)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, hub)
    if stiffness:
        values = {"EA": 1e4, "GA": 1e4, "GJ": 5.0, "EI": 5.0}
        section = cd.section.general(
            **{name: stiffness * value for name, value in values.items()}, rhoA=0.1, rhoI=1e-6
        )
        load_at = scene.ground.at(1, 0, 0)
        scene.joint("held", cd.Free(), load_at, load)
        scene.beam("arm", hub, load, section, elements=2, up="y")
    else:
        rod = scene.body("rod", mass=0.1, inertia=cd.inertia.rod(0.1, 1.0, axis="x"))
        scene.joint("middle", cd.Fixed(), hub.at(0.5, 0, 0), rod)
        scene.joint("end", cd.Fixed(), hub.at(1, 0, 0), load)
    q, u = scene.q("shoulder"), scene.u("shoulder")
    pid = cd.Controller.pid("shoulder", q, u, target=0.5, kp=kp, ki=20.0, kd=8.0, sample=sample)
    scene.force("pid", pid)
    return scene


def test_a_sampled_controller_turns_a_stiff_arm_as_a_rigid_one() -> None:
    rigid = cd.compile(flexible_arm(0, 0.01)).simulate(0.5, rtol=1e-9, atol=1e-10)
    other = cd.compile(flexible_arm(0, 0.01, 30.0)).simulate(0.5, rtol=1e-9, atol=1e-10)
    errors = []
    for stiffness in (1.0, 1e2):
        model = cd.compile(flexible_arm(stiffness, 0.01))
        motion = model.simulate(0.5, step=5e-4, method=cd.GeneralizedAlpha(0.5))
        errors.append(abs(motion["shoulder"][-1] - rigid["shoulder"][-1]))
    assert errors[1] < 1e-4
    assert errors[0] > 1e-3
    assert abs(other["shoulder"][-1] - rigid["shoulder"][-1]) > 1e-2


def test_a_continuous_controller_turns_a_stiff_arm_as_a_rigid_one() -> None:
    rigid = cd.compile(flexible_arm(0, None)).simulate(0.5, rtol=1e-9, atol=1e-10)
    errors = []
    for stiffness in (1.0, 1e2):
        model = cd.compile(flexible_arm(stiffness, None))
        motion = model.simulate(0.5, step=5e-4, method=cd.GeneralizedAlpha(0.5))
        at = [abs(motion[name][-1] - rigid[name][-1]) for name in ("shoulder", "pid.integral")]
        errors.append(max(at))
    assert errors[1] < 3e-4
    assert errors[0] > 5e-3
