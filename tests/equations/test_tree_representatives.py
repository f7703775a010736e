"""Matrices of large trees: numbers from one body of every kind against derivations of all."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import sympy

import cardan as cd
from cardan.equations.recursion.representatives import only_slides, representatives
from cardan.ir.interpreter import evaluate
from cardan.ir.recursion import Recursion
from cardan.ir.trees.assembly import Assembly
from table import each

COUNT = 45


def tree(parent: Callable[[int], int], joint: Callable[[int], cd.Joint]) -> cd.Scene:
    """Bodies on others of lower numbers, -1 for the ground."""
    scene = cd.Scene("tree", gravity=(0.3, 1.0, -9.81))
    bodies: list[Any] = []
    for i in range(COUNT):
        body = scene.body(f"b{i}", mass=1 + 0.01 * i, com=(0.1, 0.2, 0.3), inertia=(0.2, 0.3, 0.4))
        inner = bodies[parent(i)] if parent(i) >= 0 else scene.ground
        scene.joint(f"j{i}", joint(i), inner.at(0.1 * i, 0.2, -1), body)
        bodies.append(body)
    return scene


def hinges() -> cd.Scene:
    return tree(lambda i: i - 1, lambda i: cd.Revolute("x"))


def crossed_inputs() -> cd.Scene:
    """Two inputs for every joint; the force reads them now in one order, now in the other."""
    scene = hinges()
    inputs = [scene.input(f"r{k}") for k in range(2 * COUNT)]
    for i in range(COUNT):
        a, b = inputs[2 * i : 2 * i + 2][:: 1 if i % 2 else -1]
        scene.force(f"force{i}", cd.JointForce(f"j{i}", 2 * sympy.sin(a) + sympy.exp(b)))
    return scene


def inputs_in_reverse() -> cd.Scene:
    """The first input drives the last joint."""
    scene = hinges()
    for i in range(COUNT):
        force = sympy.sin(scene.input(f"r{i}"))
        scene.force(f"force{i}", cd.JointForce(f"j{COUNT - 1 - i}", force))
    return scene


def shared_inputs() -> cd.Scene:
    """Three inputs for all joints, next to one of each joint alone."""
    scene = hinges()
    shared = [scene.input(f"shared{k}") for k in range(3)]
    for i in range(COUNT):
        force = sympy.sin(scene.input(f"r{i}")) * shared[i % 3]
        scene.force(f"force{i}", cd.JointForce(f"j{i}", force))
    return scene


def mixed_roots() -> cd.Scene:
    """Arms on a body that moves freely, on a slide, and in a plane, some of them with slides."""
    roots, kinds = (
        (cd.Free(), cd.Prismatic("x"), cd.Planar("x")),
        (cd.Prismatic("x"), cd.Revolute("x"), cd.Revolute("y")),
    )
    return tree(lambda i: i - 3 if i > 2 else -1, lambda i: (kinds if i > 2 else roots)[i % 3])


def gantries() -> cd.Scene:
    """Arms of hinges on two or three slides."""
    kinds = tuple(cd.Prismatic(axis) for axis in "xyz")
    return tree(
        lambda i: i - 4 if i > 3 else -1, lambda i: kinds[i % 3] if i < 9 else cd.Revolute("x")
    )


def several_speeds() -> cd.Scene:
    """Universal joints, hinges and quaternions in turn."""
    kinds = (cd.Universal("x", "y"), cd.Revolute("z"), cd.Spherical())
    return tree(lambda i: (i - 1) // 2, lambda i: kinds[i % 3])


SCENES = {
    "crossed inputs": crossed_inputs,
    "inputs in reverse": inputs_in_reverse,
    "shared inputs": shared_inputs,
    "mixed roots": mixed_roots,
    "gantries": gantries,
    "joints of several speeds": several_speeds,
}
# by other blocks the forces of these scenes do not change
FUNCTIONS = {"mass_matrix": None, "derivative": "inverse_dynamics: q u r"}


@each("function", FUNCTIONS)
@each("which", SCENES)
def test_matrices_of_representatives(which: str, function: str) -> None:
    equations, of = cd.derive(SCENES[which](), rewrites=()), FUNCTIONS[function]
    assert representatives(equations.system) is not None
    form = equations.form(function, of, loops=True)
    assert isinstance(form, Assembly)
    assert isinstance(form.parts, Recursion)
    straight = equations.function(function, of)
    rng = np.random.default_rng(3)
    blocks = {b.name: rng.uniform(-1, 1, len(b)) for b in form.inputs}
    blocks["p"] = np.array([p.value for p in equations.system.parameters])
    for joint, slides in zip(equations.system.joints, only_slides(equations.system), strict=True):
        # digits must not depend on how far what slides on the ground has gone
        if slides:
            blocks["q"][joint.q] *= 1e5
        if joint.element.quaternion is not None:
            at = joint.q + joint.element.quaternion
            blocks["q"][at : at + 4] /= np.linalg.norm(blocks["q"][at : at + 4])
    exact, assembled = evaluate(straight, blocks), evaluate(form.straight(), blocks)
    for key, expected in exact.items():
        scale = np.abs(np.asarray(expected)).max(initial=0.0)
        np.testing.assert_allclose(assembled[key], expected, rtol=1e-9, atol=1e-11 * scale)
