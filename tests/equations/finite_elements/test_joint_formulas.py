"""Rows of joints that readers see are what the functions of their elements compute."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.elements.formulas import MULTIPLIERS
from cardan.elements.joints import Joint
from cardan.equations.finite_elements.record import FiniteElementRecord, Kind
from cardan.ir.interpreter import evaluate
from cardan.schema.finite_elements import GROUND
from elements.formula_values import column, computed, poses, skew
from elements.joint_bench import INSTANCES

# numbers in formulas have twelve digits
ROUNDING = 1e-10
OFFSET, ARM = (0.3, -0.2, 0.5), (-0.1, 0.4, 0.2)
LETTERS = "R p omega v n m l a b"


def _scene(joint: Joint, cut: bool) -> cd.Scene:
    scene = cd.Scene("pair")
    base = scene.body("base", mass=1, inertia=(0.1, 0.2, 0.25))
    link = scene.body("link", mass=1, inertia=(0.1, 0.2, 0.25))
    scene.joint("leader", cd.Revolute("y"), scene.ground, base)
    if cut:
        scene.joint("link", cd.Free(), scene.ground, link)
    scene.joint("pair", joint, base.at(*OFFSET), link.at(*ARM), cut=cut)
    return scene


def _unread(name: str, cut: bool) -> bool:
    """Splines have no formula, and where a joint keeps its coordinates in a loop they count."""
    if "curve" in name:
        return True
    return "rotation_vector" in name and not cut


@pytest.mark.parametrize("cut", [False, True], ids=["tree", "loop"])
@pytest.mark.parametrize("name", INSTANCES)
def test_rows(name: str, cut: bool) -> None:
    """Poses by NumPy alone: rows that vanish, velocities that vanish, and the balance."""
    joint = INSTANCES[name]
    if (cut and (name.startswith("free") or "gear" in name)) or (not cut and name == "fixed"):
        pytest.skip("has no rows")
    equations = cd.derive(_scene(joint, cut), coordinates="absolute")
    group, member = equations.joints["pair"]
    kind, places = equations.groups[group].kind, equations.groups[group].places[member]
    if _unread(name, cut):
        assert kind.formulas == MULTIPLIERS
        return
    for seed in range(3):
        inputs = _inputs(kind, np.random.default_rng(seed))
        given = _frames(equations, kind, places, inputs, cut) | _names(kind, inputs)
        result = evaluate(kind.functions["balance"], inputs, "numpy")
        tangent = evaluate(kind.functions["balance_tangent"], inputs, "numpy")
        given |= {"G": np.reshape(tangent["G"], (kind.m, -1)), "lam": column(inputs["lam"])}
        shown = computed(kind.formulas, given, LETTERS)
        rates = np.ravel(result["rates"])
        assert np.allclose(np.ravel(shown["g"]), result["g"], rtol=0, atol=ROUNDING)
        assert np.allclose(np.ravel(shown["b"]), result["balance"], rtol=0, atol=10 * ROUNDING)
        assert np.allclose(np.ravel(shown.get("s", [])), rates[kind.mp :], rtol=0, atol=ROUNDING)


def _inputs(kind: Kind, rng: np.random.Generator) -> dict[str, Any]:
    blocks = []
    for block in kind.blocks:
        q = rng.uniform(-0.6, 0.6, block.nq)
        if block.quaternion is not None:
            at = slice(block.quaternion, block.quaternion + 4)
            q[at] /= np.linalg.norm(q[at])
        blocks.append(q)
    return {
        "q": np.concatenate(blocks),
        "u": rng.normal(size=kind.nu),
        "udot": np.zeros(kind.nu),
        "lam": rng.normal(size=kind.m),
        "p": _data(kind, rng),
        "t": [0.3],
    }


def _data(kind: Kind, rng: np.random.Generator) -> Any:
    """Numbers; the frame of the joint on the base is where the scene has it."""
    fixed = {}
    # a joint that keeps its coordinates in a loop has the frame on the base as its place
    first = ARM if "place_position.1" in kind.data else OFFSET
    for head, vector in (("place", OFFSET), ("frame1", first), ("frame2", ARM)):
        fixed |= {f"{head}_position.{i + 1}": x for i, x in enumerate(vector)}
    return np.array([fixed.get(name, rng.uniform(0.3, 0.9)) for name in kind.data])


def _names(kind: Kind, inputs: dict[str, Any]) -> dict[str, Any]:
    """Data, coordinates and speeds of the joint."""
    given = {k.replace(".", "_"): v for k, v in zip(kind.data, inputs["p"], strict=True)}
    q, u, owners = inputs["q"], inputs["u"], list[str]()
    nq = nu = 0
    for block in kind.blocks:
        if block.name != "node":
            head = "_leader" if "coupling.1" in kind.data else ""
            owners.append(head)
            for letter, values in (("q", q[nq : nq + block.nq]), ("u", u[nu : nu + block.nu])):
                single = {f"{letter}{head}": values[0]} if len(values) == 1 else {}
                given |= single | {f"{letter}{head}_{i + 1}": x for i, x in enumerate(values)}
        nq, nu = nq + block.nq, nu + block.nu
    assert len(owners) <= 1
    return given


def _frames(
    equations: FiniteElementRecord, kind: Kind, places: Any, inputs: dict[str, Any], cut: bool
) -> dict[str, Any]:
    """Poses and velocities of P and C from those of the nodes, by hand."""
    names = [equations.places.names[place] for place in places if place != GROUND]
    nodes = {}
    nq = nu = 0
    for name, block in zip(names, kind.blocks, strict=True):
        if block.name == "node":
            pose = poses(inputs["q"][nq : nq + 7])
            u = inputs["u"][nu : nu + 6]
            nodes[name] = pose["R_1"], pose["p_1"], column(u[:3]), column(u[3:])
        nq, nu = nq + block.nq, nu + block.nu
    given = {}
    # the node of a body on a joint of the tree is where the joint has its frame
    arm = ARM if cut else (0, 0, 0)
    for letter, body, place in (("P", "base", OFFSET), ("C", "link", arm)):
        R, p, omega, v = nodes[body]
        s = column(place)
        given |= {f"R_{letter}": R, f"p_{letter}": p + R @ s, f"omega_{letter}": omega,
                  f"v_{letter}": v + R @ skew(omega) @ s}  # fmt: skip
    return given


def test_rates_are_those_of_the_rows() -> None:
    """G u + g_t of the element is the rate of the rows that are shown, by a central difference."""
    equations = cd.derive(_scene(cd.Universal(), True), coordinates="absolute")
    group, member = equations.joints["pair"]
    kind, places = equations.groups[group].kind, equations.groups[group].places[member]
    inputs, h = _inputs(kind, np.random.default_rng(5)), 1e-5
    rates = np.ravel(evaluate(kind.functions["balance"], inputs, "numpy")["rates"])
    ends = [np.ravel(computed(kind.formulas[:-1], _moved(equations, kind, places, inputs, t),
                              LETTERS)["g"]) for t in (-h, h)]  # fmt: skip
    # second order in h
    assert np.allclose((ends[1] - ends[0]) / (2 * h), rates, rtol=0, atol=1e-8)


def _moved(
    equations: FiniteElementRecord, kind: Kind, places: Any, inputs: dict[str, Any], t: float
) -> dict[str, Any]:
    """Frames after a time at constant velocities of the nodes."""
    given = _frames(equations, kind, places, inputs, True) | _names(kind, inputs)
    from scipy.spatial.transform import Rotation

    for letter, place in (("P", OFFSET), ("C", ARM)):
        R, omega = given[f"R_{letter}"], given[f"omega_{letter}"]
        s = column(place)
        turned = R @ Rotation.from_rotvec(np.ravel(omega) * t).as_matrix()
        origin = given[f"p_{letter}"] - R @ s
        speed = given[f"v_{letter}"] - R @ skew(omega) @ s
        given[f"R_{letter}"], given[f"p_{letter}"] = turned, origin + speed * t + turned @ s
    return given
