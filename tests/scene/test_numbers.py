"""A number that a user writes is a parameter, whatever its type."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.topology import build

THIRDS = (1 / 3, Fraction(1, 3), sympy.Rational(1, 3), np.float64(1 / 3))
WHOLE = (2, np.int64(2), sympy.Integer(2), Fraction(2), sympy.Float(2.0), np.array(2.0))


def pendulum(mass: object) -> cd.Scene:
    scene = cd.Scene("pendulum")
    bob = scene.body("bob", mass=mass, com=(0, 0, 1))
    scene.joint("pin", cd.Revolute("x"), scene.ground, bob)
    return scene


@pytest.mark.parametrize("mass", THIRDS + WHOLE, ids=lambda mass: type(mass).__name__)
def test_types_of_numbers(mass: object, tmp_path: Path) -> None:
    scene = pendulum(mass)
    found = {entry.name: entry.value for entry in build(scene).parameters}
    assert found["bob.mass"] == float(mass)
    # what is saved is read back as the same number
    scene.save(tmp_path / "a.yaml")
    again = build(cd.load(tmp_path / "a.yaml"))
    assert {entry.name: entry.value for entry in again.parameters} == found


STRANGERS = (1j, Decimal(1), "1", sympy.I, sympy.nan, sympy.oo, 10**400)


@pytest.mark.parametrize("mass", STRANGERS, ids=lambda mass: type(mass).__name__)
def test_what_is_no_number_is_refused(mass: object) -> None:
    with pytest.raises(cd.ModelError, match="mass"):
        build(pendulum(mass))
