"""Models that the tests of ensembles share."""

from __future__ import annotations

import pytest
import sympy as sp

import cardan as cd
from analyses.conftest import ball, double

__all__ = ["ball", "double", "edge", "folded"]


@pytest.fixture(scope="module")
def edge() -> cd.CompiledModel:
    """A slider that a force without value beyond x = 1 drives there, after a while."""
    scene = cd.Scene("edge", gravity=(0, 0, 0))
    push = scene.parameter("push", 1.0)
    cart = scene.body("cart", mass=1.0, com=(0, 0, 0), inertia=(1, 1, 1))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, cart)
    force = push + sp.sqrt(1 - scene.q("slide"))
    scene.force("drive", cd.JointForce("slide", force))
    return cd.compile(scene)


@pytest.fixture(scope="module")
def folded() -> cd.CompiledModel:
    """Two links whose only mass is a point at the tip: stretched they have no acceleration."""
    scene = cd.Scene("folded", gravity=(0, 0, 0))
    m = scene.parameter("m", 1.0)
    upper = scene.body("upper", mass=0, com=(0, 0, 0), inertia=(0, 0, 0))
    lower = scene.body("lower", mass=m, com=(0, 0, -1))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    return cd.compile(scene)
