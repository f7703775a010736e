"""The residual and the energy of a compiled scene are those of the formulas that readers see.

Poses, data and the sum over the elements are NumPy; nothing but the formulas is cardan's.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.elements.flexible import BEAMS, INERTIAS
from elements.formula_values import column, computed, data_of, motions, poses, skew

STEEL = {"E": 2.1e5, "nu": 0.3, "rho": 78.0}
G, K, C, FREE = (0.3, -0.2, -9.81), 40.0, 3.0, 0.2
ARM, SPOT = (0.2, -0.1, 0.3), (-0.4, 0.5, 0.1)
END = (1.5, 0.2, 0.0)
MASS, COM, INERTIA = 2.0, (0.1, 0.02, -0.03), (0.1, 0.2, 0.25)
# solves of six equations, and sums over twenty elements
ROUNDING = 1e-10


def _scene(element: str, inertia: str) -> cd.Scene:
    scene = cd.Scene("pair", gravity=G)
    hub = scene.body("hub", mass=MASS, com=COM, inertia=INERTIA)
    tip = scene.body("tip", mass=MASS, com=COM, inertia=INERTIA)
    scene.joint("hub", cd.Free(), scene.ground, hub)
    scene.joint("tip", cd.Free(), scene.ground, tip)
    scene.joint("socket", cd.Spherical(), hub.at(*ARM), tip.at(*SPOT), cut=True)
    scene.force("spring", cd.SpringDamper(hub, tip, stiffness=K, damping=C, rest_length=FREE))
    section = cd.section.tube(0.2, 0.02)
    scene.beam("rod", hub, tip.at(*END), section, cd.material(**STEEL), elements=2, element=element,
               inertia=inertia)  # fmt: skip
    return scene


@pytest.mark.parametrize("inertia", ["linked", "lumped"])
@pytest.mark.parametrize("element", ["helicoidal", "hellinger_reissner", "classical"])
def test_residual_and_energy(element: str, inertia: str) -> None:
    rng = np.random.default_rng(11)
    equations = cd.derive(_scene(element, inertia), coordinates="absolute")
    model = cd.compile(_scene(element, inertia), coordinates="absolute")
    for _ in range(3):
        q, lam = _coordinates(rng, model.nq), rng.normal(size=model.nlam)
        u, udot = rng.normal(size=(2, model.nu))
        b, g, energy = _assembled(equations, q, u, udot, lam)
        residual = model.residual(0.0, q, u, udot, lam)[model.nq :]
        assert np.abs(residual[: model.nu] - b).max() < ROUNDING * np.abs(b).max()
        assert np.abs(residual[model.nu :] - g).max() < ROUNDING * np.abs(g).max()
        assert np.allclose(model.energy(q, u).total, energy, rtol=ROUNDING, atol=0)


def _coordinates(rng: np.random.Generator, nq: int) -> Any:
    q = rng.normal(size=(nq // 7, 7))
    # rotations within a turn of each other
    q[:, :4] = [1.0, 0, 0, 0] + 0.3 * rng.normal(size=(nq // 7, 4))
    q[:, :4] /= np.linalg.norm(q[:, :4], axis=1)[:, None]
    return q.ravel()


def _assembled(equations: Any, q: Any, u: Any, udot: Any, lam: Any) -> tuple[Any, Any, float]:
    """Balance, rows and energy of the scene from the formulas of all members of all groups."""
    p = [parameter.value for parameter in equations.system.parameters]
    b, g, energy = np.zeros_like(u), np.zeros_like(lam), 0.0
    for group in equations.groups:
        for member in range(len(group)):
            places = group.places[member]
            at = np.concatenate([np.arange(6 * k, 6 * k + 6) for k in places])
            local = {
                "q": np.concatenate([q[7 * k : 7 * k + 7] for k in places]),
                "u": u[at],
                "udot": udot[at],
                "p": _data(group, member, p),
            }
            shown, part = _shown(group, local, lam)
            b[at] += part
            energy += sum(float(np.squeeze(shown.get(x, 0.0))) for x in "TV")
            if group.kind.m:
                g[:] = np.ravel(shown["g"])
    return b, g, energy


def _data(group: Any, member: int, p: Any) -> Any:
    from cardan.ir.interpreter import evaluate

    parts = []
    if group.common is not None:
        values = np.asarray(evaluate(group.common, {"p": p}, "numpy")["data"])
        parts.append(values[member] if values.ndim == 2 else values)
    if group.attributes is not None:
        parts.append(group.attributes[member])
    return np.concatenate(parts) if parts else np.zeros(0)


def _shown(group: Any, local: dict[str, Any], lam: Any) -> tuple[dict[str, Any], Any]:
    """Values of the formulas of one member, and what it adds to the balance."""
    kind, name = group.kind, group.kind.name
    given = poses(local["q"]) | motions(local["u"], local["udot"])
    plain = name.removesuffix("_node_offset").removesuffix("_offset_node")
    elements = BEAMS | {f"{key}_inertia": one for key, one in INERTIAS.items()}
    if plain in elements:
        return _flexible(elements[plain], name.removeprefix(plain), local)
    if name.startswith("body"):
        return _body(kind, given)
    if name == "spring_damper":
        names = {"a": "1", "b": "2"}
        given |= {f"{x}_{role}": given[f"{x}_{k}"] for role, k in names.items() for x in "pv"}
        shown = computed(kind.formulas, given | {"k": K, "c": C, "ell_0": FREE})
        zero = np.zeros((3, 1))
        return shown, -np.ravel(np.vstack([zero, shown["F_a"], zero, shown["F_b"]]))
    assert name == "spherical_held"
    return _socket(kind, given, lam)


def _flexible(element: Any, ends_at: str, local: dict[str, Any]) -> tuple[dict[str, Any], Any]:
    """An element of the beam; forces on an end off its node are carried to the node."""
    own = len(element.data())
    given = data_of(element, local | {"p": local["p"][:own]})
    k = {"": 0, "_offset_node": 1, "_node_offset": 2}[ends_at]
    R, s, node = np.eye(3), np.zeros((3, 1)), np.eye(3)
    if k:
        R, s = local["p"][own : own + 9].reshape(3, 3), column(local["p"][own + 9 :])
        p, node, omega, v, omegadot, vdot = (
            given[f"{x}_{k}"] for x in ("p", "R", "omega", "v", "omegadot", "vdot")
        )
        given |= {
            f"p_{k}": p + node @ s,
            f"R_{k}": node @ R,
            f"v_{k}": v + node @ skew(omega) @ s,
            f"vdot_{k}": vdot + node @ (skew(omegadot) + skew(omega) @ skew(omega)) @ s,
            f"omega_{k}": R.T @ omega,
            f"omegadot_{k}": R.T @ omegadot,
        }
    if element.kind == "lumped_inertia":
        names = ("p", "v", "vdot", "omega", "omegadot")
        ends = [
            computed(element.formula_lines, given | {x: given[f"{x}_{k}"] for x in names})
            for k in (1, 2)
        ]
        shown = {x: sum(end[x] for end in ends) for x in "TV"}
        b = np.vstack([end[x] for end in ends for x in ("b_m", "b_f")])
    else:
        shown = computed(element.formula_lines, given)
        b = shown["b"].copy()
    if k:
        m, f = slice(6 * k - 6, 6 * k - 3), slice(6 * k - 3, 6 * k)
        b[m] = R @ b[m] + skew(s) @ node.T @ b[f]
    return shown, np.ravel(b)


def _body(kind: Any, given: dict[str, Any]) -> tuple[dict[str, Any], Any]:
    c = column(COM)
    # the scene has the inertia about the center of mass
    J = np.diag(INERTIA) - MASS * skew(c) @ skew(c)
    own = {x: given[f"{x}_1"] for x in ("R", "p", "v", "vdot", "omega", "omegadot")}
    shown = computed(kind.formulas, own | {"m": MASS, "c": MASS * c, "J": J, "g": column(G)})
    return shown, np.ravel(shown["b"])


def _socket(kind: Any, given: dict[str, Any], lam: Any) -> tuple[dict[str, Any], Any]:
    """The socket, with G of its rows by hand: R_Pᵀ (v_C - v_P) - omega_P x p."""
    R_1, R_2, s, r = given["R_1"], given["R_2"], column(ARM), column(SPOT)
    own = {"R_P": R_1, "p_P": given["p_1"] + R_1 @ s, "R_C": R_2, "p_C": given["p_2"] + R_2 @ r}
    p = R_1.T @ (own["p_C"] - own["p_P"])
    G_rows = np.hstack(
        [skew(s) + skew(p), -R_1.T, -(R_1.T @ R_2 @ skew(r)), R_1.T]
    )  # fmt: skip
    shown = computed(kind.formulas, own | {"G": G_rows, "lam": column(lam)}, "R p")
    return shown, np.ravel(shown["b"])
