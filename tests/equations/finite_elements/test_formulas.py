"""Formulas that readers see of bodies and joints are what their functions compute."""

from __future__ import annotations

from typing import Any

import numpy as np

import cardan as cd
from cardan.equations.finite_elements.record import Kind
from cardan.ir.interpreter import evaluate
from elements.formula_values import column, computed, motions, poses

# sums of a few products
ROUNDING = 1e-12


def _kinds() -> tuple[Kind, ...]:
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    hub = scene.body("hub", mass=2, com=(0.1, 0.02, -0.03), inertia=(0.1, 0.2, 0.25))
    ball = scene.body("ball", mass=1, inertia=(0.1, 0.1, 0.1))
    tip = scene.body("tip", mass=1)
    scene.joint("pin", cd.Revolute("y"), scene.ground, hub)
    scene.joint("socket", cd.Spherical(), hub.at(1, 0, 0), ball)
    scene.joint("slide", cd.Prismatic("x"), ball.at(0, 1, 0), tip)
    return cd.derive(scene, coordinates="absolute").kinds


def test_rigid_bodies() -> None:
    rng = np.random.default_rng(3)
    bodies = [kind for kind in _kinds() if kind.name.startswith("body")]
    assert bodies
    for kind in bodies:
        q = rng.normal(size=7)
        q[:4] /= np.linalg.norm(q[:4])
        p = rng.uniform(0.5, 1.5, len(kind.data))
        inputs = {"q": q, "u": rng.normal(size=6), "udot": rng.normal(size=6), "p": p}
        given = {k.removesuffix("_1"): v for k, v in
                 (poses(q) | motions(inputs["u"], inputs["udot"])).items()}  # fmt: skip
        values = computed(kind.formulas, given | _inertia(dict(zip(kind.data, p, strict=True))))
        b = np.ravel(evaluate(kind.functions["balance"], inputs, "numpy")["balance"])
        assert np.abs(np.ravel(values["b"]) - b).max() < ROUNDING * np.abs(b).max()
        energy = evaluate(kind.functions["energy"], inputs, "numpy")
        for letter, name in (("T", "kinetic"), ("V", "potential")):
            assert np.isclose(np.squeeze(values[letter]), energy[name], rtol=ROUNDING, atol=0)


def _inertia(data: dict[str, float]) -> dict[str, Any]:
    """m, c, J and g; what a kind has no data of is zero."""
    moment = [data.get(f"first_moment.{k}", 0.0) for k in (1, 2, 3)]
    entries = [data[name] for name in data if name.startswith("inertia")]
    J = np.diag(entries) if len(entries) == 3 else np.zeros((3, 3))
    if len(entries) == 6:
        # data of products of inertia have the sign of the integrals
        J[np.triu_indices(3)] = entries
        J = 2 * np.diag(np.diag(J)) - J - np.triu(J, 1).T
    gravity = column([0.0, 0.0, data["gravity.1"]])
    return {"m": data["mass"], "c": column(moment), "J": J, "g": gravity}


def test_joints_pull_along_their_rows() -> None:
    rng = np.random.default_rng(4)
    joints = [kind for kind in _kinds() if kind.m]
    assert len(joints) == 3
    for kind in joints:
        functions = kind.functions
        q = np.concatenate([_state(rng, block) for block in kind.blocks])
        inputs = {"q": q, "u": rng.normal(size=kind.nu), "udot": rng.normal(size=kind.nu),
                  "lam": rng.normal(size=kind.m), "p": rng.normal(size=len(kind.data))}  # fmt: skip
        b = np.ravel(evaluate(functions["balance"], inputs, "numpy")["balance"])
        G = np.reshape(evaluate(functions["balance_tangent"], inputs, "numpy")["G"], (kind.m, -1))
        shown = computed(kind.formulas[-1:], {"G": G, "lam": column(inputs["lam"])})["b"]
        assert np.abs(np.ravel(shown) - b).max() < ROUNDING * np.abs(b).max()


def _state(rng: np.random.Generator, block: Any) -> Any:
    q = rng.normal(size=block.nq)
    if block.quaternion is not None:
        at = slice(block.quaternion, block.quaternion + 4)
        q[at] /= np.linalg.norm(q[at])
    return q
