"""Formalisms agree on systems with constraints, however these are treated."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.equations.formalisms import FORMALISMS
from laws.cases import SEED, call, deviation, slots
from mechanisms.closed import CLOSED
from mechanisms.rolling import ROLLING
from spread import some

BINDING = [name for name, formalism in FORMALISMS.items() if formalism.binds and name != "kane"]
PLACES = (0.3, -0.4)
# loops that formulas solve; the others are closed by constraints
SOLVED = ("four_bar", "slider_crank", "andrews", "stewart")
CASES = [
    *((name, "multipliers") for name in (*CLOSED, *ROLLING)),
    *((name, way) for name in ("four_bar", "coin") for way in ("elimination", "null_space")),
    *((name, "closed_form") for name in SOLVED),
]


@cache
def derived(name: str, way: str, method: str) -> Any:
    build = CLOSED[name].build if name in CLOSED else ROLLING[name]
    return cd.derive(build(), constraints=way, method=method)


@cache
def states(name: str, way: str) -> tuple[np.ndarray, np.ndarray]:
    """States on the constraints of loops; constraints of speeds alone hold anywhere."""
    system = derived(name, way, "newton_euler").system
    if name in ROLLING:
        rng = np.random.default_rng(SEED)
        return rng.uniform(0.2, 0.6, (2, system.nq)), rng.uniform(-1, 1, (2, system.nu))
    joints = {joint.name for joint in system.joints if joint.q >= 0}
    at = [slots(system, CLOSED[name].state(s, 1.0, joints)) for s in PLACES]
    return np.array([q for q, _ in at]), np.array([u for _, u in at])


def condition(e: Any, mass: np.ndarray, q: np.ndarray) -> np.ndarray:
    """What solving with M and the independent rows of G may amplify, per state."""
    if not e.constraint_rows:
        return np.asarray(np.linalg.cond(mass))
    G = call(e, "constraint_jacobian", q=q)["G"]
    values = np.linalg.svd(G, compute_uv=False)
    least = np.where(values > 1e-9 * values[:, :1], values, np.inf).min(axis=-1)
    # massless bodies leave zeros in M that only constraints make up for
    inertia = np.linalg.svd(mass, compute_uv=False)
    smallest = np.where(inertia > 1e-9 * inertia[:, :1], inertia, np.inf).min(axis=-1)
    return inertia[:, 0] / smallest * (values[:, 0] / least) ** 2


@pytest.mark.parametrize(
    ("name", "way", "method"), some([(*case, m) for case in CASES for m in BINDING], 12)
)
def test_agreement(name: str, way: str, method: str) -> None:
    q, u = states(name, way)
    first, other = derived(name, way, "kane").without_rewrites, derived(name, way, method)
    mass = call(first, "mass_matrix", q=q)["M"]
    eps = np.finfo(float).eps
    allowed = np.minimum(1000 * eps * condition(first, mass, q), 1e-9)
    tau = np.random.default_rng(SEED).uniform(-1, 1, u.shape)
    functions = {"bias": ("h", {}), "forward_dynamics": ("udot", {"tau": tau})}
    assert np.all(deviation(call(other, "mass_matrix", q=q)["M"], mass) <= allowed)
    for function, (output, more) in functions.items():
        found, wanted = (call(e, function, q=q, u=u, **more)[output] for e in (other, first))
        assert np.all(deviation(found, wanted) <= allowed), function


def test_articulated_bodies_name_whom_to_ask() -> None:
    with pytest.raises(cd.DerivationError, match=r"takes no constraints.*method='composite'"):
        derived("four_bar", "multipliers", "articulated").function("forward_dynamics")


@cache
def geared(method: str) -> Any:
    """A four-bar in closed form with a geared rotor on a joint that the loop determines."""
    scene = CLOSED["four_bar"].build()
    scene.force("motor", cd.Drive("B", inertia=0.02, ratio=3.0, torque=0.4))
    return cd.derive(scene, constraints="closed_form", method=method)


@pytest.mark.parametrize("method", BINDING)
def test_rotors_on_determined_joints(method: str) -> None:
    first, other = geared("kane"), geared(method)
    state = CLOSED["four_bar"].state(0.3, 2.0, {"A"})
    q, u = slots(first.system, state)
    for function, output in (("mass_matrix", "M"), ("bias", "h"), ("forward_dynamics", "udot")):
        found, wanted = (call(e, function, q=q, u=u)[output] for e in (other, first))
        np.testing.assert_allclose(found, wanted, rtol=1e-12, err_msg=function)
