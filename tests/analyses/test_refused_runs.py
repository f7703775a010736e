"""Input that no run can do anything with, and motions that end: a message for each of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd


def slider(name: str) -> cd.Scene:
    """A mass of 1 kg on a rail, without gravity."""
    scene = cd.Scene(name, gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    return scene


@pytest.fixture(scope="module")
def models() -> dict[str, cd.CompiledModel]:
    """Scenes that go wrong, each in its own way."""
    pushed = slider("pushed")
    pushed.force("engine", cd.JointForce("x", pushed.input("push")))
    burst = slider("burst")
    burst.force("engine", cd.JointForce("x", burst.u("x") ** 3))
    runaway = slider("runaway")
    runaway.force("spring", cd.JointSpring("x", stiffness=-1e6))
    rooted = slider("rooted")
    rooted.force("root", cd.JointForce("x", -(rooted.q("x") ** 0.5)))
    bounce = slider("bounce")
    bounce.force("weight", cd.JointForce("x", -9.81))
    bounce.force("wall", cd.Stop("x", lower=0.0, restitution=0.5, settle=0.0))
    moved = cd.Scene("moved", gravity=(0, 0, -9.81))
    rod = moved.body("rod", mass=1.0, com=(0, 0, -0.5))
    angle = moved.input("angle")
    moved.joint("drive", cd.Revolute("y"), moved.ground, rod, prescribed=angle)
    moved.joint(
        "tip", cd.Revolute("y"), rod.at(0, 0, -1), moved.body("bob", mass=1.0, com=(0, 0, -1))
    )
    scenes = (pushed, burst, runaway, rooted, bounce, moved)
    return {scene.name: cd.compile(scene) for scene in scenes}


# what is refused before a run begins
REFUSED: dict[str, tuple[str, Any, dict[str, Any], type[Exception], str]] = {
    "a state that is NaN": ("pushed", 1.0, {"q": {"x": np.nan}}, cd.SolveError, "'x' is nan"),
    "a speed that is infinite": ("pushed", 1.0, {"u": [np.inf]}, cd.SolveError, r"'x\.u' is inf"),
    "a state that is short": (
        "pushed",
        1.0,
        {"x0": [0.0]},
        ValueError,
        r"expected \(2,\): x, x\.u",
    ),
    "a negative time": ("pushed", -1.0, {}, cd.ModelError, r"Give \(start, end\).*t=\(0, -1\)"),
    "no time": ("pushed", 0.0, {}, cd.ModelError, "goes forward"),
    "an empty span": ("pushed", (2, 2), {}, cd.ModelError, "the run has no length"),
    "times to and fro": ("pushed", [0, 2, 1], {}, cd.ModelError, "must ascend or descend"),
    "an end that is NaN": ("pushed", np.nan, {}, cd.SolveError, "must be finite"),
    "an end that is infinite": ("pushed", np.inf, {}, cd.SolveError, "Times must be finite"),
    "backward over impacts": (
        "bounce",
        (1, 0),
        {},
        cd.ModelError,
        "'wall.lower' changes the state",
    ),
    "a negative tolerance": ("pushed", 1.0, {"rtol": -1e-6}, cd.ModelError, "rtol=-1e-06"),
    "a tolerance that is NaN": ("pushed", 1.0, {"atol": np.nan}, cd.SolveError, "atol is nan"),
    "no tolerance": ("pushed", 1.0, {"rtol": 0, "atol": 0}, cd.ModelError, "one may be 0"),
    "a tolerance below all errors": (
        *("pushed", 1.0, {"rtol": 0, "atol": 1e-300}, cd.ModelError),
        "no error is as small as that",
    ),
    "no step": ("pushed", 1.0, {"method": "RK4", "step": 0.0}, cd.ModelError, "step=0"),
    "no method": ("pushed", 1.0, {"method": "Euler"}, cd.ModelError, "'Euler' does not exist"),
    "no such input": ("pushed", 1.0, {"inputs": {"psh": 1}}, cd.ModelError, "Did you mean 'push'"),
    "an input that ends early": (
        *("pushed", 1.0, {"inputs": {"push": ([0, 0.5], [1, 1])}}, cd.ModelError),
        "values from 0 s to 0.5 s, the run goes from 0 s to 1 s. Add values",
    ),
    "an input that is NaN": (
        *("pushed", 1.0, {"inputs": {"push": np.nan}}, cd.SolveError),
        "'push' is nan",
    ),
    "an input that gives nothing": (
        *("pushed", 1.0, {"inputs": {"push": lambda t, x: None}}, ValueError),
        "the function of 'push' gave None, which is not a number",
    ),
    "a motion without its rate": (
        *("moved", 1.0, {"inputs": {"angle": lambda t, x: t}}, cd.ModelError),
        "needs rate and acceleration",
    ),
    "an event that is nothing": (
        *("pushed", 1.0, {"events": {"end": 3}}, ValueError),
        "'end' is 3; give f",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refused(case: str, models: dict[str, cd.CompiledModel]) -> None:
    name, t, options, error, words = REFUSED[case]
    with pytest.raises(error, match=words) as caught:
        models[name].simulate(t, **options)
    assert isinstance(caught.value, cd.CardanError)


# what ends on the way: model, end, options, status, message, and until when it is right
BAD = {"push": lambda t, x: np.nan if t > 0.5 else 1.0}
ENDED: dict[str, tuple[str, float, dict[str, Any], str, str, float]] = {
    "infinite in finite time": (
        *("burst", 10.0, {"u": {"x": 1.0}}, "step_too_small"),
        *(r"t = 0\.5 s of 10 s: no step.*error of 'x.u'.*singular there", 0.5),
    ),
    "infinite, with a fixed step": (
        *("burst", 10.0, {"u": {"x": 1.0}, "method": "RK4", "step": 1e-3}, "not_finite"),
        *("derivative of 'x' is not finite.*or step= is too long", 0.5),
    ),
    "infinite, implicitly": (
        *("burst", 10.0, {"u": {"x": 1.0}, "method": "Radau"}, "step_too_small"),
        *("no step is small enough", 0.5),
    ),
    "exploding": (
        *("runaway", 10.0, {"q": {"x": 1.0}}, "not_finite"),
        *(r"grows beyond all bounds, 'x.u' is [0-9.]+e\+\d+.*motion\.balance", 0.6),
    ),
    "out of a domain": (
        *("rooted", 10.0, {"q": {"x": 1.0}}, "not_finite"),
        *("derivative of 'x.u' is not finite. A force or a rotation leaves its domain", 1.4),
    ),
    "an input that becomes NaN": (
        *("pushed", 1.0, {"inputs": BAD}, "not_finite"),
        *("input 'push' is nan there: its function must give finite numbers", 0.49),
    ),
    "an input that is infinite": (
        *("pushed", 1.0, {"inputs": {"push": lambda t, x: np.inf}}, "not_finite"),
        *("t = 0 s of 1 s: input 'push' is inf", 0.0),
    ),
    "bounces without end": (
        *("bounce", 10.0, {"q": {"x": 1.0}}, "chatter"),
        *("'wall.lower' of 'wall' happens ever again.*Let it stick below a speed", 1.35),
    ),
}


@pytest.mark.parametrize("case", ENDED)
def test_ended(case: str, models: dict[str, cd.CompiledModel]) -> None:
    name, t, options, status, words, least = ENDED[case]
    with pytest.warns(cd.SolveWarning, match=words):
        motion = models[name].simulate(t, **options)
    assert motion.status == status
    assert not motion.success
    # what was good is kept, and can be looked at
    assert least - 0.01 <= motion.t[-1] < t
    assert np.isfinite(motion.x).all()
    assert motion.message in repr(motion)
    with pytest.raises(cd.SolveError, match=words):
        models[name].simulate(t, check=True, **options)


@pytest.mark.parametrize("exclusive", [False, True])
def test_a_latch_that_closes_while_it_is_released(exclusive: bool) -> None:
    """What the message says of latches ends the chatter."""
    scene = cd.Scene("latch", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("car", mass=1.0))
    scene.force("spring", cd.JointSpring("x", stiffness=200.0, rest=0.5))
    release, when = 0.5 - cd.t, 0.05 - scene.q("x")
    when = sp.Max(when, -release) if exclusive else when
    scene.force("latch", cd.Lock("x", when=when, release=release))
    model = cd.compile(scene)
    if exclusive:
        motion = model.simulate(0.6)
        assert motion.success
        assert [event.name for event in motion.events] == ["latch.lock", "latch.release"]
        return
    with pytest.warns(cd.SolveWarning, match="'latch.*when= of a latch be positive while release="):
        assert model.simulate(0.6).status == "chatter"
