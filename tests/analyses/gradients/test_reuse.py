"""Gradients one after the other serve each other's memory: nothing of one is left in the next."""

from __future__ import annotations

import gc
import weakref
from concurrent.futures import ThreadPoolExecutor
from functools import partial

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.gradients.adjoint import Sweep

COSTS = (
    cd.cost(final="swing^2 + 0.1*swing.u^2"),
    cd.cost(running="swing^2 + 1e-2*push^2"),
    cd.cost(final="swing", running="swing^2 + 1e-2*push^2"),
)


def pendulum() -> cd.CompiledModel:
    """A pendulum that an input pushes."""
    scene = cd.Scene("pushed pendulum", gravity=(0, 0, -9.81))
    m = scene.parameter("m", 1.0)
    bob = scene.body("bob", mass=m, com=(0, 0, -0.7), inertia=(0.1, 0.1, 0.02))
    scene.joint("swing", cd.Revolute("y"), scene.ground, bob)
    scene.force("motor", cd.JointForce("swing", scene.input("push", unit="N*m")))
    return cd.compile(scene)


def numbers(found: cd.Gradient) -> np.ndarray:
    """Value and slopes, one after the other."""
    return np.concatenate([[found.value], *(np.ravel(x) for x in found.slope.values())])


def calls() -> list[partial]:
    """Gradients that differ by all that may differ from one call to the next."""
    start = {"q": {"swing": 0.8}}
    table = (np.linspace(0, 1, 5), np.arange(5.0))
    gradient = cd.CompiledModel.gradient
    return [
        partial(gradient, t=1.0, cost=COSTS[0], wrt=("x0", "p"), **start),
        partial(gradient, t=0.7, cost=COSTS[0], wrt=("x0", "p"), rtol=1e-5, **start),
        partial(gradient, t=1.0, cost=COSTS[0], wrt="x0", **start),
        partial(gradient, t=1.0, cost=COSTS[1], wrt=("p", "push"), inputs={"push": 0.4}, **start),
        partial(gradient, t=1.0, cost=COSTS[2], wrt=("p", "push"), **start),
        partial(gradient, t=1.0, cost=COSTS[2], wrt="push", inputs={"push": table}, **start),
        partial(gradient, t=1.0, cost=COSTS[0], wrt="m", parameters={"m": 2.0}, **start),
        partial(gradient, t=1.0, cost=COSTS[0], wrt="m", method="RK4", step=0.01, **start),
        partial(gradient, t=1.0, cost=COSTS[0], wrt="m", method="Radau", **start),
        partial(gradient, t=1.0, cost=COSTS[0], wrt="m", events={"low": ("swing", 0.2)}, **start),
    ]


def test_every_order_of_calls_gives_the_bits_of_the_first_call():
    model = pendulum()
    # every one by a model that has run nothing
    expected = [numbers(call(model.with_parameters(m=1.0))) for call in calls()]
    rng = np.random.default_rng(3)
    for k in rng.permutation(np.tile(np.arange(len(expected)), 3)):
        np.testing.assert_array_equal(numbers(calls()[k](model)), expected[k], err_msg=str(k))
        if rng.random() < 0.3:
            model.simulate(0.5, method="DOP853", inputs={"push": 3.0})


def test_threads_share_a_model():
    model = pendulum()
    expected = [numbers(call(model)) for call in calls()[:5]]
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda k: numbers(calls()[k % 5](model)), range(60)))
    for k, one in enumerate(found):
        np.testing.assert_array_equal(one, expected[k % 5])


def test_a_refused_gradient_leaves_nothing_behind():
    model = pendulum()
    call = calls()[0]
    expected = numbers(call(model))
    with pytest.raises(cd.SolveError):
        model.gradient(1.0, cd.cost(final="sqrt(swing - 10)"), wrt="p", q={"swing": 0.8})
    np.testing.assert_array_equal(numbers(call(model)), expected)


def test_memory_goes_with_the_model():
    model = pendulum().with_parameters(m=1.5)
    first = calls()[0](model)
    # what was given back is the caller's: the next call does not write to it
    copy = numbers(first)
    calls()[1](model)
    np.testing.assert_array_equal(numbers(first), copy)
    kept = weakref.ref(model)
    del model, first
    gc.collect()
    assert kept() is None


def test_what_serves_no_other_run_is_freed_at_once():
    """Rows are large, and cycles are looked for when many objects were made, not many numbers."""
    model, runners = pendulum(), []

    def noted(runner, cost, parameters):
        runners.append(weakref.ref(runner))
        return of(runner, cost, parameters)

    with pytest.MonkeyPatch.context() as patch:
        of = Sweep.of
        patch.setattr(Sweep, "of", noted)
        gc.disable()
        try:
            calls()[5](model)
            left = [one() for one in runners]
        finally:
            gc.enable()
    assert left == [None]
