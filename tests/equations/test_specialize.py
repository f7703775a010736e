"""Parameters built into the equations: the same values, fewer operations, nothing to set."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.errors import CardanError, ModelError


def arm() -> cd.Scene:
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    m = scene.parameter("m", 2.0, unit="kg")
    upper = scene.body("upper", mass=m, com=(0.1, 0, -0.4), inertia=(0.2, 0.2, 0.01))
    lower = scene.body("lower", mass=1.5, com=(0, 0.02, -0.3), inertia=(0.1, 0.1, 0.02))
    scene.joint("shoulder", cd.Universal("x", "y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    return scene


STATES = np.random.default_rng(1).uniform(-1, 1, (2, 5, 3))


@pytest.mark.parametrize("asked", [True, ["m", "lower.mass"], "upper.com.x", {"lower.mass": 1.5}])
def test_values_stay(asked: object) -> None:
    plain, special = cd.compile(arm()), cd.compile(arm(), specialize=asked)
    for name in ("forward_dynamics", "bias"):
        found, expected = (getattr(model, name)(*STATES) for model in (special, plain))
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)


def test_the_gain_is_told() -> None:
    equations = cd.derive(arm(), specialize=True)
    assert equations.parameters == ()
    assert all(counts.prepared == 0 for counts in equations.operations.values())
    assert all(now <= before for now, before in equations.gain.values())
    # moments of inertia that are equal numbers: the body does not feel its turning
    now, before = equations.gain["forward_dynamics"]
    assert f"forward_dynamics: {before - now} operations less" in str(equations)
    assert before - now > 5
    assert cd.derive(arm()).gain == {}


def test_other_values_and_what_is_built_in() -> None:
    model = cd.compile(arm(), specialize={"m": 3.0})
    free = cd.compile(arm()).with_parameters(m=3.0)
    np.testing.assert_allclose(model.bias(*STATES), free.bias(*STATES), rtol=1e-12, atol=1e-12)
    with pytest.raises(ModelError, match="'m' is structural"):
        model.with_parameters(m=2.0)
    assert model.with_parameters({"lower.mass": 2.0}).parameters["lower.mass"] == 2.0
    with pytest.raises(
        ModelError, match=r"specialize: no parameter is called 'lower.mas'.*lower.mass"
    ):
        cd.derive(arm(), specialize="lower.mas")


def spring() -> cd.Scene:
    scene = cd.Scene("spring", gravity=(0, 0, -9.81))
    k = scene.parameter("k", 2.0)
    bob = scene.body("bob", mass=1.0)
    scene.joint("slide", cd.Prismatic("z"), scene.ground, bob)
    scene.force("push", cd.JointForce("slide", 1 / k))
    return scene


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ({"m": float("nan")}, "'m' must be a finite number"),
        ({"m": "abc"}, "specialize=.*'abc'.*give .*numbers by name"),
        ({"m": None}, "specialize=.*None.*give .*numbers by name"),
        (3.5, "specialize=.*give True or False or a list of names"),
        ([1], "specialize=.*give True or False or a list of names"),
    ],
)
def test_what_cannot_be_built_in(asked: object, words: str) -> None:
    with pytest.raises(CardanError, match=words):
        cd.derive(arm(), specialize=asked)


def test_zeros_are_built_in() -> None:
    equations = cd.derive(arm(), specialize={"lower.mass": 0.0, "lower.com.x": 0.0})
    assert "lower.mass" not in equations.parameters
    with pytest.raises(ModelError, match=r"divides by a structural zero.*specialize"):
        cd.derive(spring(), specialize={"k": 0})
