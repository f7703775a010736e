"""Base parameters: what the motion depends on, and what it does not."""

from __future__ import annotations

import numpy as np
import sympy as sp

import cardan as cd
from cardan.ir.interpreter import evaluate


def arm() -> cd.Scene:
    """Two links in a vertical plane, with full inertias."""
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    inner = scene.ground
    for name in ("upper", "lower"):
        inertia = {"xx": 0.3, "yy": 0.2, "zz": 0.2, "xy": 0.02, "xz": 0.03, "yz": 0.01}
        link = scene.body(name, mass=2.0, com=(0.1, 0.2, -0.4), inertia=inertia)
        scene.joint(f"{name}_joint", cd.Revolute("y"), inner, link)
        inner = link.at(0, 0, -1.2)
    return scene


def test_planar_arm_has_the_combinations_of_the_textbook() -> None:
    base = cd.derive(arm()).base_parameters()
    m, x, z, yy = sp.symbols("lower.mass lower.com.x lower.com.z lower.inertia.yy")
    assert sp.expand(base.combinations["lower.base_moment_x"] - m * x) == 0
    assert sp.expand(base.combinations["lower.base_moment_z"] - m * z) == 0
    # about the joint; entries xx and zz of the second moment act by their sum alone
    about = base.combinations["lower.base_xx"]
    assert "lower.base_zz" not in base.combinations
    assert sp.expand(about - yy - m * (x**2 + z**2)) == 0
    assert "lower.base_mass" not in base.combinations
    assert len(base.combinations) == 6
    # out of the plane nothing matters
    assert {"upper.com.y", "lower.com.y", "lower.inertia.xy", "upper.inertia.yz"} <= set(
        base.without_effect
    )
    assert {"lower.mass", "lower.com.x", "upper.mass"} <= set(base.only_combined)
    assert "lower.base_xx = " in str(base)


def test_what_has_no_effect_is_not_said_to_act_with_others() -> None:
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    inertia = cd.inertia.rod(1.0, 1.0, axis="z")
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=inertia)
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    base = cd.derive(scene).base_parameters()
    assert base.without_effect == ("rod.inertia.xx",)
    assert set(base.only_combined) == {"rod.mass", "rod.com.z", "rod.inertia.yy"}


def test_what_is_without_effect_has_none() -> None:
    equations = cd.derive(arm())
    base = equations.base_parameters()
    function = equations.function("inverse_dynamics")
    rng = np.random.default_rng(4)
    blocks = {b.name: rng.uniform(-1, 1, len(b)) for b in function.inputs}
    values = {p.name: p.value for p in equations.system.parameters}
    blocks["p"] = np.array([values[name] for name in equations.parameters])
    before = np.array(
        evaluate(equations.without_rewrites.function("inverse_dynamics"), blocks)["tau"]
    )
    for k, name in enumerate(equations.parameters):
        changed = blocks | {"p": blocks["p"] + 0.37 * (np.arange(len(values)) == k)}
        after = evaluate(equations.without_rewrites.function("inverse_dynamics"), changed)["tau"]
        same = np.allclose(after, before, rtol=1e-12, atol=1e-12)
        assert same == (name in base.without_effect), name
