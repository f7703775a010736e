"""Speeds that the user chose: every formalism gives the equations that follow by congruence."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.equations.formalisms import FORMALISMS
from laws.cases import SEED, bound, call, derived, deviation, states, values
from mechanisms import ZOO
from spread import some

CHOOSING = tuple(name for name, formalism in FORMALISMS.items() if formalism.chooses)
t = sympy.Symbol("t")


def weights(nu: int) -> np.ndarray:
    """A regular matrix (nu, nu) of one decimal."""
    rng = np.random.default_rng(SEED + nu)
    return np.asarray(np.round(3 * np.eye(nu) + rng.uniform(-0.6, 0.6, (nu, nu)), 1))


@cache
def chosen(name: str, method: str) -> Any:
    """w = A u + sin(q) u_0 B + C t, with the first coordinate q."""
    scene, plain = ZOO[name].build(), derived(name, "newton_euler")
    rates = [
        scene.u(f"{joint.name}.{c.name}" if c.name else joint.name)
        for joint in plain.system.joints
        for c in (joint.element.speeds if joint.u >= 0 else ())
    ]
    first = scene.q(plain.coordinates[0])
    A = weights(len(rates))
    speeds = {
        f"w{k}": sum(a * rate for a, rate in zip(row, rates, strict=True))
        + sympy.sin(first) * rates[0] * 0.2 * (k + 1)
        + 0.3 * k * t
        for k, row in enumerate(A)
    }
    return cd.derive(scene, speeds=speeds, method=method)


def transformation(name: str, q: np.ndarray, t: float) -> tuple[np.ndarray, np.ndarray]:
    """Y (k, nu, nu) and Z (nu,) of w = Y u + Z."""
    nu = len(derived(name, "newton_euler").speeds)
    Y = np.repeat(weights(nu)[None], len(q), axis=0)
    Y[:, :, 0] += np.sin(q[:, :1]) * 0.2 * (np.arange(nu) + 1)
    return Y, 0.3 * np.arange(nu) * t


# what drives bring along has no name in the scene
NAMES = [name for name in ZOO if name != "drives"]
PAIRS = [(name, method) for name in NAMES for method in CHOOSING]


@pytest.mark.parametrize(("name", "method"), some(PAIRS, 71))
def test_equations_follow_by_congruence(name: str, method: str) -> None:
    (q, u), plain, own = states(name), derived(name, "newton_euler"), chosen(name, method)
    at = float(values(plain)["t"][0])
    Y, Z = transformation(name, q, at)
    w = np.einsum("kij,kj->ki", Y, u) + Z
    W = np.linalg.inv(Y)
    mass = call(plain, "mass_matrix", q=q)["M"]
    congruent = np.swapaxes(W, -1, -2) @ mass @ W
    allowed = np.minimum(bound(mass) * np.linalg.cond(Y) ** 2, 1e-9)
    assert np.all(deviation(call(own, "mass_matrix", q=q)["M"], congruent) <= allowed)
    # wdot = Y udot + Ydot u + Zdot, the rate of the first coordinate being that of q
    udot = call(plain, "forward_dynamics", q=q, u=u)["udot"]
    rate = call(plain, "qdot", q=q, u=u)["qdot"][:, :1]
    steps = np.arange(Y.shape[-1])
    turned = np.cos(q[:, :1]) * rate * u[:, :1] * 0.2 * (steps + 1) + 0.3 * steps
    wanted = np.einsum("kij,kj->ki", Y, udot) + turned
    found = call(own, "forward_dynamics", q=q, u=w)["udot"]
    assert np.all(deviation(found, wanted) <= allowed)
    tau = call(own, "inverse_dynamics", q=q, u=w, udot=found)["tau"]
    bias, force = (call(own, f, q=q, u=w)[o] for f, o in (("bias", "h"), ("applied_forces", "f")))
    # tau = 0 as a difference of the size of its terms
    size = np.abs(np.einsum("kij,kj->ki", congruent, found)).max(axis=1, initial=0)
    size = size + np.abs(bias).max(axis=1, initial=0) + np.abs(force).max(axis=1, initial=0)
    assert np.all(np.abs(tau).max(axis=1, initial=0) <= allowed * size)


def test_joint_by_joint_takes_none() -> None:
    scene = ZOO["double_pendulum"].build()
    speeds = {"a": scene.u("shoulder"), "b": scene.u("elbow")}
    with pytest.raises(cd.DerivationError, match=r"goes with method='kane', .*, not 'articulated'"):
        cd.derive(scene, speeds=speeds, method="articulated")
    with pytest.raises(cd.DerivationError, match="'appell' is called 'gibbs_appell' here"):
        cd.derive(scene, speeds=speeds, method="appell")
