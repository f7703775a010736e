"""Energy: constant where nothing is forced, balanced by the powers elsewhere."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cardan.ir.interpreter import evaluate
from laws.cases import call, compiled, derived, states, values
from mechanisms import ZOO
from spread import some

CONSERVATIVE = [name for name, member in ZOO.items() if member.conservative]
TIME = 10.0
# the acceleration bends at knots of a curve: a step across one may miss more than its estimate
BENT = {"point_on_curve": 0.1, "mounts": 0.01}


@pytest.mark.parametrize("name", some(CONSERVATIVE, 3))
def test_total_energy_stays(name: str) -> None:
    member, model = ZOO[name], compiled(name)
    first = member.states[0]
    sharper = BENT.get(name, 1.0)
    tolerances = {"rtol": 1e-10 * sharper, "atol": 1e-13 * sharper}
    motion = model.simulate(TIME, q=dict(first.q), u=dict(first.u), **tolerances)
    assert motion.success
    assert motion.t[-1] == TIME
    energy = motion.energy
    drift = np.abs(energy.total - energy.total[0]).max()
    # 1e-10 per step leaves two digits for the steps of ten seconds
    assert drift <= 1e-8 * energy.kinetic.max()
    if member.margin is not None:
        rotations = model.pose(member.frame, motion.q)[:, :3, :3]
        assert min(member.margin(r) for r in rotations) >= 0.2


def energy_rate(equations: Any, q: np.ndarray, u: np.ndarray) -> float:
    """d(total energy)/dt along the motion by a complex step, exact to rounding."""
    step = 1e-30
    blocks = values(equations, q=q, u=u)
    moving = evaluate(equations.function("rhs"), blocks, arithmetic="float")
    x = {
        "q": [a + 1j * step * b for a, b in zip(q, moving["qdot"], strict=True)],
        "u": [a + 1j * step * b for a, b in zip(u, moving["udot"], strict=True)],
        "t": [blocks["t"][0] + 1j * step],
    }
    total = evaluate(equations.function("energy"), blocks | x, arithmetic="complex")["total"]
    return float(np.imag(np.squeeze(total))) / step


@pytest.mark.parametrize("name", some(ZOO, 3))
def test_power_balance(name: str) -> None:
    equations = derived(name)
    q, u = states(name)
    powers = call(equations, "power", q=q, u=u)["power"]
    energy = call(equations, "energy", q=q, u=u)
    for k in range(len(q)):
        rate = energy_rate(equations, q[k], u[k])
        # energies of this size change at rates of this size times the rates of the coordinates
        size = 1 + np.abs(energy["kinetic"][k]) + np.abs(powers[k]).sum()
        growth = np.linalg.cond(call(equations, "mass_matrix", q=q[k])["M"])
        assert abs(rate - powers[k].sum()) <= 100 * np.finfo(float).eps * growth * 10 * size


@pytest.mark.parametrize("name", [n for n in ZOO if n not in CONSERVATIVE])
def test_ledger_closes(name: str) -> None:
    member, model = ZOO[name], compiled(name)
    first = member.states[0]
    motion = model.simulate(TIME, q=dict(first.q), u=dict(first.u), rtol=1e-10, atol=1e-13)
    assert motion.success
    assert np.abs(motion.energy_residual).max() <= 1e-7 * max(motion.energy.kinetic.max(), 1e-3)
