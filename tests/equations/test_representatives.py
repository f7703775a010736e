"""Large trees derived from one body of every kind give what the derivation of all bodies gives."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.equations.recursion.representatives import representatives
from cardan.ir.interpreter import evaluate
from elements.force_bench import INSTANCES as FORCES
from laws.test_cut_joints import INSTANCES as JOINTS
from mechanisms.random_trees import large_tree
from table import each


def rope(
    n: int, axes: str = "y", odd: int = -1, force: int = -1, branches: bool = False
) -> cd.Scene:
    """Links of different masses; one of another make, one with a force, every one with a tooth."""
    scene = cd.Scene("rope", gravity=(0, 0, -9.81))
    inner = scene.ground
    for i in range(n):
        inertia = (0.2, 0.21, 0.01) if i != odd else {"xx": 0.2, "yy": 0.2, "zz": 0.1, "xy": 0.03}
        com = (0, 0, -0.5 - 0.001 * i)
        link = scene.body(f"link{i}", mass=1 + 0.01 * i, com=com, inertia=inertia)
        scene.joint(f"joint{i}", cd.Revolute(axes[i % len(axes)]), inner, link)
        scene.force(f"damper{i}", cd.JointSpring(f"joint{i}", stiffness=2.0, damping=0.1))
        if i == force:
            scene.force("push", cd.Force(link.at(0, 0, -1), (1.0, 2.0, 0.5)))
        if branches:
            tooth = scene.body(f"tooth{i}", mass=0.1, com=(0.1, 0, 0), inertia=(1e-3, 1e-3, 1e-3))
            scene.joint(f"root{i}", cd.Prismatic("x"), link, tooth)
        inner = link.at(0, 0, -1)
    return scene


def comb() -> cd.Scene:
    """Pendulums side by side on one beam."""
    scene = cd.Scene("comb", gravity=(0, 0, -9.81))
    beam = scene.body("beam", mass=3.0, inertia=(1, 1, 1))
    scene.joint("base", cd.Free(), scene.ground, beam)
    for i in range(60):
        bob = scene.body(f"bob{i}", mass=1 + 0.1 * i, com=(0, 0, -1))
        scene.joint(f"hinge{i}", cd.Revolute("y"), beam.at(0.1 * i, 0, 0), bob)
    return scene


def teeth_last() -> cd.Scene:
    """A rope whose teeth are declared after all its links."""
    scene = rope(50, "yz")
    for i in range(50):
        tooth = scene.body(f"tooth{i}", mass=0.1 + 0.01 * i, com=(0.1, 0, 0), inertia=(1e-3,) * 3)
        scene.joint(f"root{i}", cd.Revolute("x"), scene.bodies[f"link{i}"].at(0.1, 0, 0), tooth)
    return scene


def motors() -> cd.Scene:
    """A rope with a lagging actuator at every joint, each with a command and a state of its own."""
    scene = rope(45, "xy")
    for i in range(45):
        command = scene.input(f"command{i}")
        scene.force(f"motor{i}", cd.Actuator(f"joint{i}", command=command, lag=0.1 + 0.01 * i))
    return scene


def shared_lengths() -> cd.Scene:
    """A rope of two lengths, which neighbors share, under a gravity that is a parameter."""
    scene = cd.Scene("shared", gravity=(0, 0, 1))
    g = scene.parameter("g", 9.81)
    scene.gravity = (0, 0, -g)
    lengths = [scene.parameter(f"length{k}", 0.3 + 0.2 * k) for k in range(2)]
    inner = scene.ground
    for i in range(60):
        length = lengths[i // 2 % 2]
        link = scene.body(f"link{i}", mass=1 + 0.01 * i, com=(0, 0, -length), inertia=(0.1,) * 3)
        scene.joint(f"joint{i}", cd.Revolute("xy"[i % 2]), inner, link)
        inner = link.at(0, 0, -2 * length)
    return scene


def pendulums() -> cd.Scene:
    """Double pendulums next to each other, half of them on slides."""
    scene = cd.Scene("pendulums", gravity=(0, 0, -9.81))
    for i in range(25):
        upper = scene.body(f"upper{i}", mass=1 + 0.1 * i, com=(0, 0, -0.5), inertia=(0.1, 0.2, 0.1))
        lower = scene.body(f"lower{i}", mass=2 - 0.01 * i, com=(0, 0.1, -0.5))
        kind = (cd.Revolute("y"), cd.Prismatic("x"))[i % 2]
        scene.joint(f"pivot{i}", kind, scene.ground.at(i, 0, 0), upper)
        scene.joint(f"elbow{i}", cd.Revolute("x"), upper.at(0, 0, -1), lower)
    return scene


def many_joints(seed: int) -> cd.Scene:
    """A tree of bodies on a few kinds of joints, among them such with quaternions, in no order."""
    rng, scene = np.random.default_rng(seed), cd.Scene("forest", gravity=(1.0, 2.0, -9.81))
    kinds = (cd.Revolute("x"), cd.Prismatic("y"), cd.Spherical(), cd.Universal(), cd.Free())
    bodies: list[Any] = []
    for i in range(90):
        body = scene.body(f"b{i}", mass=1 + 0.01 * i, com=(0.1, 0.2, 0.3), inertia=(0.2, 0.3, 0.4))
        parent = bodies[int(rng.integers(max(0, i - 9), i))] if i > 3 else scene.ground
        scene.joint(f"j{i}", kinds[int(rng.integers(len(kinds)))], parent.at(*rng.random(3)), body)
        bodies.append(body)
    return scene


def pushed_everywhere() -> cd.Scene:
    """A rope with a force at a place of each of its links."""
    scene = rope(45)
    for i in range(45):
        scene.force(f"push{i}", cd.Force(scene.bodies[f"link{i}"].at(0, 0, -1), (1.0, 2.0, i)))
    return scene


def singles(base: cd.Joint | None = None) -> cd.Scene:
    """Bodies that carry no other, side by side on the ground or on one body that does not move."""
    scene = cd.Scene("singles", gravity=(0.3, 1.0, -9.81))
    stand: Any = scene.ground
    if base is not None:
        stand = scene.body("stand", mass=1.0, com=(0.1, 0.2, 0.3), inertia=(0.2, 0.3, 0.4))
        scene.joint("base", base, scene.ground, stand)
    for i in range(60):
        bob = scene.body(f"bob{i}", mass=1 + 0.1 * i, com=(0.1, 0.2, -1), inertia=(0.2, 0.3, 0.4))
        scene.joint(f"hinge{i}", cd.Revolute("xy"[i % 2]), stand.at(0.1 * i, 0, 0), bob)
    return scene


def massless_links() -> cd.Scene:
    """Links on pairs of hinges, between which there is a body without mass."""
    scene = cd.Scene("massless", gravity=(0.3, 1.0, -9.81))
    inner: Any = scene.ground
    for i in range(30):
        cross = scene.body(f"cross{i}")
        link = scene.body(f"link{i}", mass=1 + 0.1 * i, com=(0, 0, -0.5), inertia=(0.2, 0.3, 0.1))
        scene.joint(f"first{i}", cd.Revolute("x"), inner, cross)
        scene.joint(f"second{i}", cd.Revolute("y"), cross, link)
        inner = link.at(0, 0, -1)
    return scene


ALIKE = {
    "plane": lambda: rope(60),
    "space": lambda: rope(80, "xyz"),
    "branched": lambda: rope(60, "xy", branches=True),
    "pushed at the tip": lambda: rope(60, force=59),
    "odd near the ground": lambda: rope(60, odd=3),
    "comb": comb,
    "odd in the middle": lambda: rope(45, odd=22),
    "pushed in the middle": lambda: rope(45, force=22),
    "teeth after the rope": teeth_last,
    "axes of a long period": lambda: rope(45, "xyzx"),
    "motors": motors,
    "shared lengths": shared_lengths,
    "pendulums": pendulums,
    "random tree": lambda: large_tree(120),
    "singles": singles,
    "on a body that is fixed": lambda: singles(cd.Fixed()),
    "on a slide": lambda: singles(cd.Translation()),
    "massless links": massless_links,
    "many joints": lambda: many_joints(1),
    "many joints in another order": lambda: many_joints(2),
}
IRREGULAR = ("random tree", "many joints", "many joints in another order")
DIFFERENT = {"short": lambda: rope(30), "pushed everywhere": pushed_everywhere}


@each("which", [*ALIKE, *DIFFERENT])
def test_forward_dynamics_of_representatives(which: str) -> None:
    check(which, "forward_dynamics")


@pytest.mark.slow
@each("name", ["inverse_dynamics", "rhs", "energy", "com", "momentum"])
@each("which", [*ALIKE, *DIFFERENT])
def test_recursions_of_representatives(which: str, name: str) -> None:
    check(which, name)


def check(which: str, name: str) -> None:
    """A function by its loops and straight-line."""
    scene = (ALIKE | DIFFERENT)[which]()
    equations = cd.derive(scene, method="articulated", rewrites=())
    assert (representatives(equations.system) is not None) == (which in ALIKE)
    function, recursion = equations.function(name), equations.recursion(name)
    # regular trees have tables that do not grow with them
    if which not in IRREGULAR:
        assert sum(len(sweep.parts) for sweep in recursion.sweeps) < 120
    rng = np.random.default_rng(3)
    blocks = {b.name: rng.uniform(-1, 1, len(b)) for b in function.inputs}
    blocks["p"] = np.array([p.value for p in equations.system.parameters])
    for joint in equations.system.joints:
        if joint.element.kind in ("spherical", "free"):
            at = slice(joint.q + (3 if joint.element.kind == "free" else 0), None)
            blocks["q"][at][:4] /= np.linalg.norm(blocks["q"][at][:4])
    exact, found = evaluate(function, blocks), evaluate(recursion.straight(), blocks)
    for key, expected in exact.items():
        np.testing.assert_allclose(found[key], expected, rtol=1e-9, atol=1e-9)


def mixed(kind: Callable[[int], cd.Joint]) -> cd.Scene:
    """A tree of 45 bodies on joints of some kinds, in no order."""
    rng, scene = np.random.default_rng(5), cd.Scene("mixed", gravity=(0.3, 1.0, -9.81))
    bodies: list[Any] = []
    for i in range(45):
        body = scene.body(f"b{i}", mass=1 + 0.01 * i, com=(0.1, 0.2, 0.3), inertia=(0.2, 0.3, 0.4))
        parent = bodies[int(rng.integers(max(0, i - 5), i))] if bodies else scene.ground
        scene.joint(f"j{i}", kind(i), parent.at(*rng.random(3)), body)
        bodies.append(body)
    return scene


def same(scene: cd.Scene, name: str) -> None:
    """A function by its loops and straight-line, where it has loops."""
    equations = cd.derive(scene, method="articulated", rewrites=())
    if not equations.loops(name):
        return
    function, recursion = equations.function(name), equations.recursion(name)
    rng = np.random.default_rng(3)
    blocks = {b.name: rng.uniform(-1, 1, len(b)) for b in function.inputs}
    blocks["p"] = np.array([p.value for p in equations.system.parameters])
    exact, found = evaluate(function, blocks), evaluate(recursion.straight(), blocks)
    for key, expected in exact.items():
        np.testing.assert_allclose(found[key], expected, rtol=1e-9, atol=1e-9)


@pytest.mark.slow
# a gear has a leader
@each("name", [name for name in JOINTS if name != "gear"])
def test_joints_of_any_kind(name: str) -> None:
    same(mixed(lambda i: JOINTS[name] if i % 2 else cd.Revolute("x")), "rhs")


@each("name", [name for name, x in FORCES.items() if getattr(x, "joint", "") == "one"])
def test_forces_of_any_kind_along_joints(name: str) -> None:
    """With states, events and parameters that do not come in the order of the bodies."""
    scene, force = mixed(lambda i: cd.Revolute("xy"[i % 2])), FORCES[name]
    if isinstance(force, cd.Drive) and force.gyroscopic:
        # couples joints
        return
    for k, i in enumerate(np.random.default_rng(1).permutation(45)):
        scene.force(f"force{k}", replace(force, joint=f"j{i}"))
    same(scene, "rhs")


@each("name", ["spherical", "translation", "planar", "universal"])
def test_reversed_joints_of_two_kinds(name: str) -> None:
    """Every body carries the one inboard of it, at its origin: no data tell the kinds apart."""
    scene = cd.Scene("reversed", gravity=(0.3, 1.0, -9.81))
    inner: Any = scene.ground
    for i in range(45):
        link = scene.body(f"b{i}", mass=1 + 0.01 * i, com=(0.1, 0.2, 0.3), inertia=(0.2, 0.3, 0.4))
        scene.joint(f"j{i}", JOINTS[name] if i % 2 else cd.Spherical(), link, inner)
        inner = link.at(0.1, 0.2, -1)
    same(scene, "rhs")


def test_a_body_of_every_kind_is_derived() -> None:
    """Hinges about three axes inside the tree and at its tips, and some with zeros in places."""
    few = representatives(cd.derive(large_tree(400), method="articulated").system)
    assert few is not None
    assert len(few.numbers) == 12
    assert sorted(np.concatenate(few.members)) == list(range(400))
    recursion = cd.derive(large_tree(400), method="articulated").recursion("forward_dynamics")
    assert [len(sweep) for sweep in recursion.sweeps[1:]] == [400, 400, 400]
    # all bodies derived: 108
    assert len(recursion.steps) == 35


def test_time_and_places_do_not_depend_on_the_length() -> None:
    short, long = (
        cd.derive(rope(n, "xy"), method="articulated").recursion("forward_dynamics")
        # full visits of angles
        for n in (320, 640)
    )
    assert short.steps == long.steps or len(short.steps) == len(long.steps)
    assert [len(s.parts) for s in short.sweeps] == [len(s.parts) for s in long.sweeps]
    assert [2 * len(s) for s in short.sweeps] == [len(s) for s in long.sweeps]
    assert 2 * short.size == long.size


def test_turns_are_saved() -> None:
    from cardan.ir.serialize import from_dict, to_dict

    recursion = cd.derive(rope(60), method="articulated").recursion("bias")
    again = from_dict(to_dict(recursion))
    rng = np.random.default_rng(1)
    blocks = {b.name: rng.uniform(0.5, 1, len(b)) for b in recursion.inputs}
    exact, found = evaluate(recursion.straight(), blocks), evaluate(again, blocks)
    np.testing.assert_array_equal(found["h"], exact["h"])
