"""What elements refuse, and why: the message names culprit and cure."""

from __future__ import annotations

import math

import pytest
import sympy

import cardan as cd


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"inertia": -1.0}, "inertia is -1; give 0 or more"),
        ({"inertia": 1.0, "ratio": 0}, "ratio is 0"),
        ({"inertia": 1.0, "damping": 5.0}, "damping belongs to an elastic shaft"),
        ({"inertia": math.nan}, "inertia is nan"),
    ],
)
def test_impossible_drives(given: dict[str, float], message: str) -> None:
    with pytest.raises(cd.ModelError, match=message):
        cd.Drive("joint", **given)


def test_parallel_axes_of_a_universal_joint() -> None:
    with pytest.raises(cd.ModelError, match="are parallel"):
        cd.Universal((1, 2, 0), (-2, -4, 0))


@pytest.mark.parametrize("length", [1e-200, 1e200])
def test_an_axis_of_any_length_is_a_direction(length: float) -> None:
    scene = cd.Scene("pendulum")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(1, 1, 0.1))
    scene.joint("pivot", cd.Revolute((length, length, 0)), scene.ground, rod)
    model = cd.compile(scene, functions=["forward_dynamics"])
    assert math.isfinite(model.forward_dynamics([0.3], [0.1])[0])


@pytest.mark.parametrize("symbols", [5, None, [1.0]])
def test_custom_joints_need_symbols(symbols: object) -> None:
    with pytest.raises(cd.ModelError, match="give one to six different symbols"):
        cd.Custom(symbols)


def test_a_custom_pose_must_coincide_at_zero() -> None:
    x = sympy.Symbol("x")
    for joint in (
        cd.Custom([x], position=(x, 1, 0)),
        cd.Custom([x], rotation=[[1, 0, 0], [0, 2, 0], [0, 0, 1]]),
    ):
        scene = cd.Scene("slide")
        body = scene.body("body", mass=1)
        scene.joint("slide", joint, scene.ground, body)
        with pytest.raises(cd.ModelError, match=r"joint .slide.*do not coincide"):
            cd.derive(scene)


def test_a_shaft_that_time_changes_stores_nothing() -> None:
    """The energy ledger of an elastic drive closes with a stiffness that depends on time."""
    scene = cd.Scene("drive", gravity=(0, 0, 0))
    arm = scene.body("arm", mass=1, inertia=(1, 1, 1))
    scene.joint("joint", cd.Revolute("z"), scene.ground, arm)
    stiffness = 40 + 20 * sympy.sin(3 * cd.t)
    scene.force("drive", cd.Drive("joint", inertia=0.1, ratio=2.0, stiffness=stiffness))
    motion = cd.compile(scene).simulate(3.0, q={"joint": 0.5}, rtol=1e-11, atol=1e-12)
    scale = abs(motion.energy.kinetic).max()
    assert abs(motion.energy_residual).max() <= 1e-9 * scale
