"""What method="auto" takes, and why."""

from __future__ import annotations

from typing import Any

import numpy as np

import cardan as cd
from cardan.analyses.simulation.method_choice import RULES, Case, choose
from cardan.schema.integrators import INTEGRATORS
from mechanisms import ZOO
from table import each

CHOICES: list[tuple[Case, str, str]] = [
    (Case(1e-6), "DOP853", "the motion is not stiff so far"),
    (Case(1e-2), "DOP853", "the motion is not stiff so far"),
    (Case(1e-6, period=1e-3, length=1.0), "RK45", "samples or ticks"),
    (Case(1e-6, period=1e-3), "RK45", "samples or ticks"),
    (Case(1e-6, period=0.1, length=1.0), "DOP853", "the motion is not stiff so far"),
    (Case(1e-10, period=1e-3, length=1.0), "DOP853", "the motion is not stiff so far"),
    (Case(1e-6, stiff=True), "Rosenbrock", "stability limited"),
    (Case(1e-9, stiff=True), "Radau", "stability limited"),
    (Case(1e-6, stiff=True, input_functions=True), "Radau", "slopes of f(t, x)"),
    (Case(1e-6, stiff=True, derived=False), "DOP853", "functions=[..., 'rhs_jacobian']"),
    (Case(1e-6, elements=True), "DOP853", "not stiff so far"),
    (Case(1e-6, elements=True, flexible=True), "Radau", "stiff, with constraints"),
    (Case(1e-9, elements=True, flexible=True), "Radau", "stiff, with constraints"),
    (Case(1e-6, elements=True, stiff=True), "Radau", "stiff, with constraints"),
]


@each(("case", "method", "words"), CHOICES)
def test_the_first_rule_that_holds(case: Case, method: str, words: str) -> None:
    rule = choose(case)
    assert rule.method == method
    assert words in rule.why


def test_every_rule_is_reached_and_exists() -> None:
    assert {choose(case) for case, _, _ in CHOICES} == {*RULES}
    assert {rule.method for rule in RULES} <= {*INTEGRATORS}


def knee(**options: Any) -> cd.CompiledModel:
    """A pendulum whose second link is held by a spring and a damper of 1e7 1/s."""
    scene = cd.Scene("knee", gravity=(0, 0, -9.81))
    rod = {"com": (0, 0, -0.5), "inertia": cd.inertia.rod(1.0, 1.0, axis="z")}
    thigh, shin = scene.body("thigh", mass=1.0, **rod), scene.body("shin", mass=1.0, **rod)
    scene.joint("hip", cd.Revolute("y"), scene.ground, thigh)
    scene.joint("knee", cd.Revolute("y"), thigh.at(0, 0, -1), shin)
    scene.force("spring", cd.JointSpring("knee", stiffness=1e6, damping=1e4))
    return cd.compile(scene, **options)


def test_a_stiff_scene_goes_on_with_an_implicit_method() -> None:
    model = knee()
    motion = model.simulate(1.0, q={"hip": 1.0})
    assert motion.solver_info.method == "Rosenbrock"
    assert "stability limited the steps of DOP853" in repr(motion)
    assert motion.statistics["steps"] < 200
    fine = model.simulate(1.0, t_eval=[0.0, 1.0], q={"hip": 1.0}, rtol=1e-10, atol=1e-12)
    assert fine.solver_info.method == "Radau"
    np.testing.assert_allclose(motion.x[-1], fine.x[-1], rtol=0, atol=1e-4)


def test_what_would_be_better_is_said() -> None:
    short = {"t": 0.01, "q": {"hip": 1.0}}
    asked = knee().simulate(**short, method="DOP853")
    assert "method='Rosenbrock' or 'Radau' takes longer ones" in asked.solver_info.reason
    bare = knee(functions=["rhs"]).simulate(**short)
    assert bare.solver_info.method == "DOP853"
    assert "functions=[..., 'rhs_jacobian']" in bare.solver_info.reason


def test_what_is_not_stiff_is_not_said_to_be() -> None:
    model = cd.compile(ZOO["double_pendulum"].build())
    for rtol in (1e-2, 1e-4, 1e-6, 1e-9):
        motion = model.simulate(10.0, q={"shoulder": 1.5}, rtol=rtol)
        assert motion.solver_info.method == "DOP853"
        assert motion.solver_info.reason.startswith("the motion is not stiff so far")
        assert motion.statistics["limited"] <= 0.2 * motion.statistics["looked"]
    assert model.simulate(1.0, method="RK45").solver_info.reason == ""


def test_samples_take_the_short_method() -> None:
    scene = cd.Scene("driven")
    wheel = scene.body("wheel", mass=1.0, inertia=(1, 1, 1))
    scene.joint("axle", cd.Revolute("z"), scene.ground, wheel)
    torque = scene.input("torque")
    scene.force("motor", cd.JointForce("axle", torque))
    model = cd.compile(scene)
    often = model.simulate(1.0, inputs={"torque": lambda t, x: -x[0]}, sample=1e-3)
    assert often.solver_info.method == "RK45"
    rarely = model.simulate(1.0, inputs={"torque": lambda t, x: -x[0]}, sample=0.1)
    assert rarely.solver_info.method == "DOP853"
