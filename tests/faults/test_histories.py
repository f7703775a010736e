"""Histories by the names that one tries: energies, parts of reactions, forces of free joints."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd


@pytest.fixture(scope="module")
def motion() -> cd.Trajectory:
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pin", cd.Revolute("y"), scene.ground, rod)
    return cd.compile(scene).simulate(1.0, q={"pin": 1.0})


def test_energies_are_histories(motion: cd.Trajectory) -> None:
    np.testing.assert_array_equal(motion["energy"], motion.energy.total)
    np.testing.assert_array_equal(motion["kinetic energy"], motion.energy.kinetic)
    np.testing.assert_array_equal(motion["potential energy"], motion.energy.potential)


def test_parts_of_reactions_are_histories(motion: cd.Trajectory) -> None:
    for part in ("force", "moment"):
        for k, axis in enumerate("xyz"):
            np.testing.assert_array_equal(motion[f"pin.{part}.{axis}"], motion[f"pin.{part}"][:, k])


def test_a_force_that_is_not_there_says_why(motion: cd.Trajectory) -> None:
    with pytest.raises(cd.ModelError, match=r"'pin' moves freely or .*; only .* prescribed="):
        motion["pin.driving_force"]
    with pytest.raises(cd.ModelError, match=r"pin\.force"):
        motion["pin.reaction"]


def test_python_control_takes_no_system_with_one_output_and_no_input() -> None:
    pytest.importorskip("control")
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pin", cd.Revolute("y"), scene.ground, rod)
    scene.output("angle", scene.q("pin"))
    linear = cd.compile(scene).linearize()
    assert len(linear.outputs) == 1
    assert not linear.inputs
    with pytest.raises(cd.ModelError, match="Add an input"):
        linear.to_control()
