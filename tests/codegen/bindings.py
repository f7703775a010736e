"""Scenes and exports that CasADi and JAX call, for tests."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import sympy

import cardan as cd


def wrist() -> cd.Scene:
    """A quaternion, a hinge and a spring with damping, in two parameters of the user."""
    scene = cd.Scene("wrist", gravity=(0, 0, -9.81))
    m, k = scene.parameter("m", 1.0, unit="kg"), scene.parameter("k", 3.0, unit="N*m/rad")
    upper = scene.body("upper", mass=m, com=(0, 0.1, -0.5), inertia=(0.3, 0.4, 0.2))
    hand = scene.body("hand", mass=0.5, com=(0.1, 0, -0.2), inertia=(0.1, 0.2, 0.15))
    scene.joint("shoulder", cd.Spherical(), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1.0), hand)
    scene.force("spring", cd.JointSpring("elbow", stiffness=k, damping=0.2))
    return scene


def pushed() -> cd.Scene:
    """A cart that an input, the time and a controller with a state of its own push."""
    scene = cd.Scene("pushed")
    push, lag = scene.input("push", default=0.7), sympy.Symbol("lag")
    cart = scene.body("cart", mass=2.0, inertia=(1, 1, 1))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, cart)
    x = scene.q("slide")
    law = {"changes": [3 * (push - lag) - x**2], "force": lag + cd.t**2}
    scene.force("law", cd.Controller("slide", states=[lag], **law, start=[0.2]))
    return scene


def loaded(folder: Path, name: str) -> ModuleType:
    """The module of an export, which compiles its C."""
    spec = importlib.util.spec_from_file_location(f"{folder.name}_{name}", folder / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def unit(q: np.ndarray, quaternions: tuple[int, ...]) -> np.ndarray:
    """Coordinates whose quaternions have unit length."""
    q = np.array(q)
    for first in quaternions:
        q[first : first + 4] /= np.linalg.norm(q[first : first + 4])
    return q
