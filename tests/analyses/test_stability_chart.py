"""Stability over two parameters, against closed forms."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ModelError


def column() -> cd.CompiledModel:
    """H. Ziegler's column (1952): two links, masses 2 and 1, springs of 1, P along the second."""
    scene = cd.Scene("column", gravity=(0, 0, 0))
    load, damping = scene.parameter("P", 0.0), scene.parameter("b", 0.1)
    lower = scene.body("lower", mass=2.0, com=(0, 0, 1), inertia=(0, 0, 0))
    upper = scene.body("upper", mass=1.0, com=(0, 0, 1), inertia=(0, 0, 0))
    scene.joint("one", cd.Revolute("y"), scene.ground, lower)
    scene.joint("two", cd.Revolute("y"), lower.at(0, 0, 1), upper)
    for name in ("one", "two"):
        scene.force(f"spring_{name}", cd.JointSpring(name, stiffness=1.0))
        scene.force(f"damper_{name}", cd.JointDamper(name, damping=damping))
    scene.force("load", cd.Force(upper.at(0, 0, 1), (0, 0, -1 * load), in_=upper))
    return cd.compile(scene)


def test_flutter_over_damping(tmp_path: Path) -> None:
    """G. Herrmann, I.-C. Jong (1965): P = 41 / 28 + b^2 / 2."""
    damping = np.array([0.05, 0.1, 0.2, 0.4])
    chart = column().stability_chart({"P": (0, 3)}, {"b": damping})
    across, along = chart.line("Hopf point")
    np.testing.assert_array_equal(across, damping)
    np.testing.assert_allclose(along, 41 / 28 + damping**2 / 2, rtol=1e-10)
    assert {point.kind for point in chart.points} == {"Hopf point"}
    assert "4 Hopf points" in str(chart)
    (axis,) = chart.plot(tmp_path / "chart.svg").axes
    assert (axis.get_xlabel(), axis.get_ylabel()) == ("b", "P")


def test_speeds_of_a_governor_over_gravity() -> None:
    scene = cd.Scene("governor", gravity=(0, 0, -9.81))
    post = scene.body("post", mass=1.0, inertia=(1.0,) * 3)
    rod = scene.body("rod", mass=2.0, com=(0, 0, -0.5), inertia=(0.0,) * 3)
    scene.joint("turn", cd.Revolute("z"), scene.ground, post)
    scene.joint("tilt", cd.Revolute("y"), post, rod)
    gravity = np.array([-9.81, -3.71, -1.62])
    chart = cd.compile(scene).stability_chart({"turn": (0, 10)}, {"gravity.z": gravity})
    _, speeds = chart.line("branch point")
    np.testing.assert_allclose(speeds, np.sqrt(-gravity / 0.5), rtol=1e-10)


def test_nonsense_is_refused() -> None:
    model = column()
    with pytest.raises(ModelError, match="one name along, one across"):
        model.stability_chart({"P": (0, 1)}, {})
    with pytest.raises(ModelError, match="Did you mean 'b'"):
        model.stability_chart({"P": (0, 1)}, {"bb": [0.1]})
    for nothing in ([], [[0.1, 0.2]]):
        with pytest.raises(ModelError, match="b: give values"):
            model.stability_chart({"P": (0, 1)}, {"b": nothing})
