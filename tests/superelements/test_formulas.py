"""Formulas of superelements that readers see, against the compiled element and all nodes."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import sympy

import cardan as cd
from cardan.equations.finite_elements.superelements import PAIR_NAMES, PAIRS
from cardan.equations.reading.energy_expressions import _symbols_of
from cardan.runtime.models.finite_elements.elements import State
from cardan.scene.superelement import INERTIAS
from elements.formula_values import column, computed, motions, poses, skew
from superelements.components import brick, brick_matrices, faces
from table import each

GRAVITY = (0.3, -0.2, -9.81)
# products of up to three matrices of 15 rows
ROUNDING = 1e-11


@cache
def record() -> cd.superelement.Superelement:
    """A soft brick with damping; fifteen coordinates."""
    M, K, nodes = brick_matrices()
    return cd.superelement.reduce(M, 1e-4 * K, nodes, faces(), modes=3, damping=0.1)


def scene(on_ground: bool, inertia: str = "nodal") -> cd.Scene:
    one = cd.Scene("one", gravity=GRAVITY)
    if on_ground:
        one.superelement("body", record(), {"root": one.ground.at(*ROOT)}, frame="root")
    else:
        body = one.superelement("body", record(), frame="root", inertia=inertia)
        one.joint("free", cd.Free(), one.ground, body.at("root"))
    return one


ROOT = (0.0, 0.15, 0.05)


def constants(rows: slice, form: str = "nodal") -> dict[str, Any]:
    """Numbers that formulas read, out of the record, for the coordinates that move."""
    r = record()
    inertia, size = INERTIAS[form](r), len(r.M)
    at = np.arange(size)[rows]
    both = np.ix_(at, at)
    first, second = inertia.first, inertia.second
    s_0 = [first[1, 2] - first[2, 1], first[2, 0] - first[0, 2], first[0, 1] - first[1, 0]]
    values = {
        "m": inertia.mass[0, 0],
        "g": column(GRAVITY),
        "s_0": column(s_0) / 2,
        "P": inertia.momentum[:, at],
        "M": r.M[both],
        "K": r.K[both],
        "D": r.C[both],
    }
    for k, m in np.ndindex(3, 3):
        values[f"E_{k + 1}{m + 1}"] = inertia.drift[k, m, at][:, None]
    for k in range(3):
        values[f"h_{k + 1}"] = inertia.angular[k, at][:, None]
        values[f"A_{k + 1}"] = inertia.spin_modal[k][both]
    for name, (k, m) in zip(PAIR_NAMES, PAIRS, strict=True):
        values[f"I_{name}"] = second[k, m]
        bent = inertia.spin_angular[k, m] + inertia.spin_angular[m, k]
        values[f"j_{name}"] = bent[at][:, None] / 2
        S = inertia.spin_spin[k, m][both]
        values[f"S_{name}"] = (S + S.T) / 2
    return values


def frame_of(q: Any, u: Any, udot: Any) -> dict[str, Any]:
    """Pose and motion of the frame: the node is at ROOT in its axes."""
    node = {k.removesuffix("_1"): v for k, v in (poses(q) | motions(u, udot)).items()}
    return of_node(node)


def of_node(node: dict[str, Any]) -> dict[str, Any]:
    """Those of the frame by those of the node, complex ones too."""
    R, arm, omega, omegadot = node["R"], -column(ROOT), node["omega"], node["omegadot"]
    return node | {
        "p": node["p"] + R @ arm,
        "v": node["v"] + R @ skew(omega) @ arm,
        "vdot": node["vdot"] + R @ (skew(omegadot) + skew(omega) @ skew(omega)) @ arm,
    }


def shown_by(kind: Any, given: dict[str, Any], frame: dict[str, Any], moving: Any) -> Any:
    """Everything that the formulas define, and the balance about the node."""
    spin = {f"omega_{k + 1}": x for k, x in enumerate(frame["omega"].ravel())}
    shown = computed(kind.formulas, given | frame | moving | spin, "nu")
    b = shown["b"].ravel().copy()
    b[:3] -= np.cross(ROOT, shown["f"].ravel())
    return shown, b


def kinetic_energy_of_all_nodes(z: Any, rate: Any, frame: dict[str, Any]) -> float:
    """Of the mesh, by the velocity of each node: no constants of the record but its shapes."""
    M, _, nodes = brick_matrices()
    basis, fixed = record().basis, np.zeros(6)
    moved = nodes + (basis @ np.concatenate([fixed, z])).reshape(-1, 3)
    deforming = (basis @ np.concatenate([fixed, rate])).reshape(-1, 3)
    local = np.cross(frame["omega"].ravel(), moved) + deforming
    velocity = (frame["v"].ravel() + local @ frame["R"].T).ravel()
    return float(velocity @ (M @ velocity)) / 2


@each("on_ground, inertia", [(True, "nodal"), (False, "nodal"), (False, "corotated")])
def test_balance_and_energy_are_those_of_the_compiled_element(
    on_ground: bool, inertia: str
) -> None:
    model = cd.compile(scene(on_ground, inertia), functions=("residual", "energy"))
    kind = cd.derive(scene(on_ground, inertia)).kinds["superelement"].kinds[0]
    assert ("G = " in str(kind.formulas)) == (inertia == "corotated")
    rng, own = np.random.default_rng(4), slice(6, 15)
    given = constants(own, inertia)
    nodes = 0 if on_ground else 1
    for _ in range(3):
        z, (rate, second) = 0.05 * rng.normal(size=9), rng.normal(size=(2, 9))
        pose = np.concatenate([rng.normal(size=4), rng.normal(size=3)])
        pose[:4] /= np.linalg.norm(pose[:4])
        fast = rng.normal(size=(2, 6))
        q = np.concatenate([pose, z] if nodes else [z])
        u, udot = (
            np.concatenate([x, y] if nodes else [y])
            for x, y in zip(fast, (rate, second), strict=True)
        )
        resting = np.zeros(6)
        frame = frame_of(pose, *fast) if nodes else frame_of([1, 0, 0, 0, *ROOT], resting, resting)
        moving = {"z": column(z), "zdot": column(rate), "zddot": column(second)}
        shown, b = shown_by(kind, given, frame, moving)
        expected = model.residual(0.0, q, u, udot)[model.nq :]
        b = b if nodes else b[6:]
        np.testing.assert_allclose(expected, b, atol=ROUNDING * np.abs(b).max())
        energy = model.energy(q, u)
        np.testing.assert_allclose(energy.kinetic, shown["T"], rtol=ROUNDING)
        if inertia != "nodal":
            continue
        by_nodes = kinetic_energy_of_all_nodes(z, rate, frame)
        np.testing.assert_allclose(shown["T"], by_nodes, rtol=ROUNDING)
        np.testing.assert_allclose(energy.potential, shown["V"], rtol=ROUNDING)


@each("inertia", ("nodal", "corotated"))
def test_tangents_are_those_of_the_formulas_by_complex_steps(inertia: str) -> None:
    """K, C and M in C against the formulas, which complex steps differentiate to rounding."""
    model = cd.compile(scene(False, inertia), functions=("residual", "energy"))
    kind = cd.derive(scene(False, inertia)).kinds["superelement"].kinds[0]
    rng, given, h = np.random.default_rng(6), constants(slice(6, 15), inertia), 1e-40
    q, (u, udot) = rng.normal(size=16), rng.normal(size=(2, 15))
    q[:4] /= np.linalg.norm(q[:4])
    q[7:] *= 0.05
    node = {k.removesuffix("_1"): v for k, v in (poses(q[:7]) | motions(u[:6], udot[:6])).items()}
    names = {"K": ("", "p", "z"), "C": ("omega", "v", "zdot"), "M": ("omegadot", "vdot", "zddot")}
    local = {"z": column(q[7:]), "zdot": column(u[6:]), "zddot": column(udot[6:])}
    mesh = model._source.results(model).mesh
    tangent = mesh.tangent(State(q=q, u=u, udot=udot))
    for part, (turned, moved, deformed) in names.items():
        slopes = np.zeros((15, 15))
        for k, step in enumerate(1j * h * np.eye(15)[:, :, None]):
            change = node | {moved: node[moved] + step[3:6]}
            if turned:
                change[turned] = node[turned] + step[:3]
            else:
                change["R"] = node["R"] @ (np.eye(3) + skew(step[:3]))
            moving = local | {deformed: local[deformed] + step[6:]}
            slopes[:, k] = shown_by(kind, given, of_node(change), moving)[1].imag / h
        compiled = tangent[part].toarray()
        np.testing.assert_allclose(compiled, slopes, atol=1e-10 * np.abs(slopes).max())


def test_energies_in_sympy_are_the_same() -> None:
    """Every entry has its symbol, in definitions that need those before them alone."""
    energy = cd.derive(scene(on_ground=False)).kinds["superelement"].energy
    kind = cd.derive(scene(on_ground=False)).kinds["superelement"].kinds[0]
    rng = np.random.default_rng(8)
    q, u = rng.normal(size=7), rng.normal(size=6)
    q[:4] /= np.linalg.norm(q[:4])
    moving = {name: column(rng.normal(size=9)) for name in ("z", "zdot", "zddot")}
    given = constants(slice(6, 15)) | frame_of(q, u, np.zeros(6)) | moving
    values: dict[sympy.Symbol, float] = {}
    for name, value in given.items():
        shape = np.shape(value)
        symmetric = name in ("M", "K") or name.startswith("S_")
        symbols = _symbols_of(name, ("symmetric", shape[0]) if symmetric else shape)
        entries = list(symbols) if shape else [symbols]
        values |= dict(zip(entries, map(float, np.ravel(value)), strict=True))
    for definition in energy.definitions:
        assert definition.lhs not in values
        values[definition.lhs] = float(definition.rhs.xreplace(values))
    spin = {f"omega_{k + 1}": float(x) for k, x in enumerate(given["omega"].ravel())}
    shown = computed(kind.formulas, given | spin)
    for expression, letter in ((energy.kinetic, "T"), (energy.potential, "V")):
        value = float(expression.xreplace(values))
        np.testing.assert_allclose(value, float(np.squeeze(shown[letter])), rtol=ROUNDING)


def test_energies_of_superelements_of_two_sizes() -> None:
    two = scene(on_ground=False)
    two.superelement("small", brick(modes=0), {"root": two.ground.at(*ROOT)}, frame="root")
    kinds = cd.derive(two).kinds
    for name, count in (("superelement", 9), ("superelement_2", 6)):
        symbols = kinds[name].energy.potential.free_symbols
        assert {str(x) for x in symbols if str(x).startswith("z_")} == {
            f"z_{k + 1}" for k in range(count)
        }


def test_entries_of_large_matrices_have_names_of_their_own() -> None:
    """K_1_11 and K_11_1 were both K_111."""
    assert len({*_symbols_of("A", (12, 12))}) == 144
    assert str(_symbols_of("A", (12, 12))[0, 10]) == "A_1_11"
    assert str(_symbols_of("A", (9, 9))[0, 8]) == "A_19"


def test_pages_say_the_formulas_and_who_computes_them(tmp_path: Path) -> None:
    equations = cd.derive(scene(on_ground=False))
    assert re.search(r"superelement +1 +15 +0 +2754 +5670", str(equations))
    for ending in ("html", "tex", "md"):
        text = equations.explain(tmp_path / f"page.{ending}").read_text("utf-8")
        assert "Routines of the kernels compute it" in text
    assert r"$+ M \, \ddot{z}$ $+ D \, \dot{z}$ $+ K \, z$" in text
    assert r"cardan\_superelement\_balance" in text
