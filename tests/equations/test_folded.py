"""Trees that repeat are derived from a few of their bodies and give what all of them give."""

from __future__ import annotations

import numpy as np

import cardan as cd
from cardan.equations.recursion.folded import fold
from cardan.ir.interpreter import evaluate
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


FOLDED = {
    "plane": lambda: rope(60),
    "space": lambda: rope(80, "xyz"),
    "branched": lambda: rope(60, "xy", branches=True),
    "pushed at the tip": lambda: rope(60, force=59),
    "odd near the ground": lambda: rope(60, odd=3),
    "comb": comb,
    "odd in the middle": lambda: rope(45, odd=22),
    "pushed in the middle": lambda: rope(45, force=22),
}
WHOLE = {
    "teeth after the rope": teeth_last,
    "short": lambda: rope(30),
    "axes of a long period": lambda: rope(45, "xyzx"),
}


@each("name", ["forward_dynamics", "inverse_dynamics", "energy", "com", "momentum"])
@each("which", [*FOLDED, *WHOLE])
def test_recursions_of_folded_trees(which: str, name: str) -> None:
    scene = (FOLDED | WHOLE)[which]()
    equations = cd.derive(scene, method="articulated", rewrites=())
    assert (fold(equations.system) is not None) == (which in FOLDED)
    function, recursion = equations.function(name), equations.recursion(name)
    assert sum(len(sweep.parts) for sweep in recursion.sweeps) < 120
    rng = np.random.default_rng(3)
    blocks = {b.name: rng.uniform(-1, 1, len(b)) for b in function.inputs}
    blocks["p"] = np.array([p.value for p in equations.system.parameters])
    if which == "comb":
        blocks["q"][:4] /= np.linalg.norm(blocks["q"][:4])
    exact, found = evaluate(function, blocks), evaluate(recursion.straight(), blocks)
    for key, expected in exact.items():
        np.testing.assert_allclose(found[key], expected, rtol=1e-9, atol=1e-9)


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
