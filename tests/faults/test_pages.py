"""Faults of pages: of long chains, of far, small, short and late things, of arguments."""

from __future__ import annotations

import math

import pytest

import cardan as cd


def chain(count: int, length: float = 1.0) -> cd.Scene:
    """Rods that hang on each other."""
    scene = cd.Scene("chain", gravity=(0, 0, -9.81))
    rod, parent = cd.inertia.rod(1.0, length, axis="z"), scene.ground
    for k in range(count):
        body = scene.body(f"rod{k}", mass=1, com=(0, 0, -length / 2), inertia=rod)
        scene.joint(f"pin{k}", cd.Revolute("y"), parent, body)
        parent = body.at(0, 0, -length)
    return scene


def test_the_energy_of_a_long_chain_is_compiled() -> None:
    """A step with more than 128 parameters as they are looped over tables that nothing wrote."""
    motion = cd.compile(chain(140)).simulate(1e-3, q={"pin0": 1.0}, rtol=1e-3)
    assert motion.energy.potential[0] == pytest.approx(-9.81 * math.cos(1.0) * 140**2 / 2)
