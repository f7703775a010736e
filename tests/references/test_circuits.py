"""Closed mechanisms against published and independently computed motions."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from mechanisms.closed import CLOSED

HERE = Path(__file__).parent
EXACT = ("multipliers", "elimination", "null_space")


def reference(name: str) -> dict[str, Any]:
    return json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))


@cache
def compiled(name: str, treatment: str) -> cd.CompiledModel:
    return cd.compile(cd.derive(CLOSED[name].build(), constraints=treatment))


# the order of the problem's coordinates
ANDREWS = ("beta", "theta", "gamma", "phi", "delta", "omega", "epsilon")


@pytest.mark.parametrize("treatment", EXACT)
def test_andrews(treatment: str) -> None:
    known = reference("andrews")
    exact = np.array(known["reference"]["own_high_precision_q_qdot"], dtype=float)
    model = compiled("andrews", treatment)
    start = dict(zip(ANDREWS, known["initial_state"]["q"], strict=True))
    motion = model.simulate([0, 0.03], q=start, rtol=1e-12, atol=1e-14)
    angles = np.array([motion[name][-1] for name in ANDREWS])
    rates = np.array([motion[f"{name}.u"][-1] for name in ANDREWS])
    np.testing.assert_allclose(angles, exact[:7], rtol=0, atol=1e-9)
    np.testing.assert_allclose(rates, exact[7:], rtol=1e-9)


@pytest.mark.parametrize("treatment", EXACT)
def test_accelerations_of_andrews_at_the_start(treatment: str) -> None:
    known = reference("andrews")["initial_state"]
    model = compiled("andrews", treatment)
    q, u = model.split(model.initial(q=dict(zip(ANDREWS, known["q"], strict=True))))
    udot = dict(zip(model.speeds, model.forward_dynamics(q, u), strict=True))
    computed = [udot[f"{name}.u"] for name in ANDREWS]
    np.testing.assert_allclose(computed, known["qddot0"], rtol=1e-12, atol=1e-8)


@pytest.mark.parametrize("treatment", EXACT)
def test_bricard(treatment: str) -> None:
    known = reference("iftomm_A04_bricard")["reference"]["P3"]
    model = compiled("bricard", treatment)
    # five hinges in space leave one of the five closing conditions to the others
    q = model.initial()[: model.nq]
    G = model.constraint_jacobian(q)
    assert G.shape == (5, 5)
    assert np.linalg.matrix_rank(G, tol=1e-9) == known["rank"] - (30 - 5)
    motion = model.simulate([0.0, *known["t"]], rtol=1e-11, atol=1e-12)
    corner = model.pose("rod3", motion.q)[1:, :3, 3]
    np.testing.assert_allclose(corner, known["P3"], rtol=0, atol=1e-7)
    total = motion.energy.total
    assert np.abs(total - total[0]).max() < 1e-8
