"""Members of the zoo as systems with states: what every law starts from."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

import cardan as cd
from cardan.ir.interpreter import evaluate
from cardan.topology.system import System
from mechanisms import ZOO, Mechanism, State

SEED = 7
RANDOM_STATES = 4
EPS = float(np.finfo(float).eps)


@cache
def derived(name: str, method: str = "auto") -> Any:
    return cd.derive(ZOO[name].build(), method=method)


@cache
def compiled(name: str) -> Any:
    return cd.compile(derived(name))


def slots(system: System, state: State) -> tuple[np.ndarray, np.ndarray]:
    """q and u of named initial values."""
    q, u = np.zeros(system.nq), np.zeros(system.nu)
    known = {joint.name: joint for joint in system.joints}
    assert {*state.q, *state.u} <= set(known)
    for joint in system.joints:
        if joint.q >= 0:
            defaults = [c.default for c in joint.element.coordinates]
            q[joint.q : joint.q + len(defaults)] = state.q.get(joint.name, defaults)
        if joint.u >= 0:
            n = len(joint.element.speeds)
            u[joint.u : joint.u + n] = state.u.get(joint.name, [0.0] * n)
    return q, u


def values(equations: Any, **given: Any) -> dict[str, Any]:
    """Input blocks with the model's parameters; inputs and tau default to their zero."""
    system: System = equations.system
    blocks: dict[str, Any] = {
        "t": [0.3],
        "p": [parameter.value for parameter in system.parameters],
        "r": [entry.default for entry in system.inputs],
        "tau": np.zeros(system.nu),
    }
    return blocks | given


def call(equations: Any, function: str, of: str | None = None, **given: Any) -> dict[str, Any]:
    """A function of the equations in NumPy; results have the leading axes of q."""
    blocks = values(equations, **given)
    wanted = equations.function(function, of)
    found = evaluate(wanted, blocks, arithmetic="numpy")
    # what does not depend on the state comes without them
    lead = np.shape(given["q"])[:-1]
    return {o.name: np.broadcast_to(found[o.name], lead + o.shape) for o in wanted.outputs}


@cache
def states(name: str) -> tuple[np.ndarray, np.ndarray]:
    """Listed states and random ones around them: (k, nq), (k, nu)."""
    member: Mechanism = ZOO[name]
    # any formalism has the kinematics; this one takes every system
    equations = derived(name, "newton_euler")
    listed = [slots(equations.system, state) for state in member.states]
    q = np.array([state[0] for state in listed])
    u = np.array([state[1] for state in listed])
    rng = np.random.default_rng(SEED)
    pick = rng.integers(len(listed), size=RANDOM_STATES)
    # moves along the speeds keep every state on its manifold and in its domain
    steps = rng.uniform(-0.12, 0.12, (RANDOM_STATES, u.shape[1]))
    moved = call(equations, "integrate", q=q[pick], du=steps)["q"]
    speeds = rng.uniform(-2, 2, steps.shape)
    return np.concatenate([q, moved]), np.concatenate([u, speeds])


def bound(mass: np.ndarray) -> np.ndarray:
    """min(100 eps cond(M), 1e-9) per state: what solving with M may lose, at most 1e-9."""
    if mass.shape[-1] == 0:
        return np.full(mass.shape[:-2], 100 * EPS)
    return np.minimum(100 * EPS * np.linalg.cond(mass), 1e-9)


def deviation(computed: np.ndarray, exact: np.ndarray) -> np.ndarray:
    """Largest error over largest value, per state."""
    k = len(exact)
    error = np.abs(np.asarray(computed) - exact).reshape(k, -1).max(axis=1, initial=0)
    size = np.abs(np.asarray(exact)).reshape(k, -1).max(axis=1, initial=0)
    # where everything is 0 the comparison is absolute
    return error / np.where(size > 0, size, 1)


def blocks_of(system: System) -> Mapping[str, slice]:
    """Slots of u by joint name."""
    return {
        joint.name: slice(joint.u, joint.u + len(joint.element.speeds))
        for joint in system.joints
        if joint.u >= 0
    }
