"""What recursions look like: sweeps, steps, and what of a scene they keep."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.errors import DerivationError
from cardan.ir.interpreter import evaluate
from cardan.ir.recursion import Recursion


def chain(n: int, axes: str = "yx", branches: int = 1) -> cd.Scene:
    scene = cd.Scene("chain", gravity=(0, 0, -9.81))
    for k in range(branches):
        inner = scene.ground
        for i in range(n):
            link = scene.body(
                f"link{k}_{i}",
                mass=1.0,
                com=(0, 0, -0.5),
                inertia=cd.inertia.rod(1.0, 1.0, axis="z"),
            )
            scene.joint(f"joint{k}_{i}", cd.Revolute(axes[i % len(axes)]), inner, link)
            inner = link.at(0, 0, -1)
    return scene


def same(equations: cd.Equations, name: str) -> Recursion:
    """The recursion of a function, after its splice was found equal to the straight form."""
    function, recursion = equations.function(name), equations.recursion(name)
    rng = np.random.default_rng(3)
    blocks = {b.name: rng.uniform(-1, 1, len(b)) for b in function.inputs}
    blocks["p"] = np.array([p.value for p in equations.system.parameters])
    exact, found = evaluate(function, blocks), evaluate(recursion.straight(), blocks)
    for key, expected in exact.items():
        np.testing.assert_allclose(found[key], expected, rtol=1e-11)
    return recursion


@pytest.mark.parametrize(("name", "sweeps"), [("forward_dynamics", 3), ("inverse_dynamics", 2)])
def test_steps_do_not_grow_with_the_chain(name: str, sweeps: int) -> None:
    short, long = (same(cd.derive(chain(n), method="articulated"), name) for n in (12, 24))
    assert [s.name for s in long.sweeps[1:]] == ["outward", "inward", "outward"][:sweeps]
    assert len(short.steps) == len(long.steps) < 25
    assert long.size == 2 * short.size


def test_a_planar_chain_stays_planar_in_its_loops() -> None:
    planar = same(cd.derive(chain(20, "y"), method="articulated"), "forward_dynamics")
    spatial = same(cd.derive(chain(20), method="articulated"), "forward_dynamics")
    assert 2.5 * sum(planar.operations().values()) < sum(spatial.operations().values())
    # nothing is stored of what a plane does not have
    assert 2 * planar.size < spatial.size


def test_branches_share_steps() -> None:
    one = same(cd.derive(chain(10), method="articulated"), "forward_dynamics")
    three = same(cd.derive(chain(10, branches=3), method="articulated"), "forward_dynamics")
    assert len(three.steps) == len(one.steps)
    assert [len(s) for s in three.sweeps[1:]] == [3 * len(s) for s in one.sweeps[1:]]


def test_forces_between_distant_bodies() -> None:
    scene = chain(9)
    first, last = scene.bodies["link0_1"], scene.bodies["link0_8"].at(0, 0, -1)
    scene.force("cable", cd.SpringDamper(first, last, stiffness=50, damping=2, rest_length=1))
    equations = cd.derive(scene, method="articulated")
    for name in ("forward_dynamics", "inverse_dynamics", "energy", "power"):
        same(equations, name)
    # poses outward, the cable, forces inward, accelerations outward
    sweeps = equations.recursion("forward_dynamics").sweeps
    assert [s.name for s in sweeps] == ["angles", "outward", "inward", "inward", "outward"]


def test_angles_come_first() -> None:
    scene = cd.Scene("mixed", gravity=(0, 0, -9.81))
    inner = scene.ground
    for i in range(40):
        joint = (cd.Universal("x", "y"), cd.Prismatic("z"), cd.Revolute("x"))[i % 3]
        body = scene.body(f"body{i}", mass=1, inertia=(0.1, 0.2, 0.3), com=(0, 0, -0.5))
        scene.joint(f"joint{i}", joint, inner, body)
        inner = body.at(0, 0, -1)
    recursion = same(cd.derive(scene, method="articulated"), "inverse_dynamics")
    first, *others = recursion.sweeps
    # 14 universal joints have two angles each, 13 hinges one, slides none
    assert first.name == "angles"
    assert sum(len(v.reads["q"]) for v in first.visits()) == 2 * 14 + 13
    steps = [recursion.steps[visit.step] for sweep in others for visit in sweep.visits()]
    assert not any({"sin", "cos"} & set(step.operations()) for step in steps)


def test_what_is_no_recursion_says_so() -> None:
    equations = cd.derive(chain(3), method="composite")
    with pytest.raises(DerivationError, match=r"by method 'composite' is not a recursion.*bias"):
        equations.recursion("forward_dynamics")
    with pytest.raises(DerivationError, match="Those that are: none"):
        cd.derive(chain(3), method="kane").recursion("bias")
    with pytest.raises(DerivationError, match="Did you mean 'bias'"):
        equations.recursion("bia")


def test_loops_are_chosen_where_bodies_are_many_and_alike() -> None:
    many = cd.derive(chain(70, "y"))
    assert isinstance(many.form("forward_dynamics"), Recursion)
    assert not isinstance(many.form("forward_dynamics", loops=False), Recursion)
    assert not isinstance(many.form("pose", "link0_3"), Recursion)
    few = cd.derive(chain(5), method="articulated")
    assert not isinstance(few.form("forward_dynamics"), Recursion)
    assert isinstance(few.form("forward_dynamics", loops=True), Recursion)

    # axes in general position: every body is another one
    rng, scene = np.random.default_rng(0), cd.Scene("bush", gravity=(0, 0, -9.81))
    inner = scene.ground
    for i in range(65):
        link = scene.body(f"link{i}", mass=1.0, com=tuple(rng.uniform(-1, 1, 3)))
        kind = (cd.Revolute, cd.Prismatic)[int(rng.integers(2))]
        axis = (*np.where(rng.random(2) < 0.4, 0.0, rng.uniform(0.5, 1, 2)), 1.0)
        scene.joint(f"joint{i}", kind(axis), inner, link)
        inner = link.at(*np.where(rng.random(3) < 0.4, 0.0, rng.uniform(0.5, 1, 3)))
    assert not isinstance(cd.derive(scene).form("forward_dynamics"), Recursion)


def test_values_of_one_name_do_not_share_a_place() -> None:
    scene = chain(6)
    tip = scene.bodies["link0_5"].at(0, 0, -1)
    hand = scene.body("hand", mass=0.3, com=(0.1, 0, 0))
    scene.joint("wrist", cd.Revolute("z"), tip, hand, prescribed=cd.t**2)
    # accelerations of the forward dynamics, and those of the driving force and the output
    scene.output("jerky", hand.acceleration()[0] * 2)
    equations = cd.derive(scene, method="articulated")
    for name in ("outputs", "power", "rhs"):
        same(equations, name)
