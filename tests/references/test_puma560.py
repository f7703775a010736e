"""PUMA 560 through its table, against published parameters and independently computed dynamics.

Source of parameters: B. Armstrong, O. Khatib, J. Burdick, The Explicit Dynamic Model and Inertial
Parameters of the PUMA 560 Arm, ICRA 1986; P. Corke, B. Armstrong-Helouvry, A Search for Consensus
Among Model Parameters Reported for the PUMA 560 Robot, ICRA 1994. Forces and matrices: a recursive
Newton-Euler written for the purpose, checked there against a Lagrangian derivation; M and the
gravity load at qn agree with the numbers Corke prints.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import cardan as cd

DATA = json.loads((Path(__file__).parent / "puma560.json").read_text("utf-8"))
TOLERANCE = 1e-10


# the published inertias of links 1 and 3 are those of no rigid body
@pytest.mark.filterwarnings("ignore:.*triangle inequality")
@cache
def arm(motors: bool) -> cd.CompiledModel:
    rows = [
        {
            **{key: row[key] for key in ("a", "alpha", "d", "mass", "com", "inertia")},
            **({k: row[k] for k in ("rotor_inertia", "gear_ratio")} if motors else {}),
        }
        for row in DATA["rows"]
    ]
    return cd.compile(cd.from_dh(rows, name="puma560"))


@pytest.mark.filterwarnings("ignore:.*triangle inequality")
@pytest.mark.parametrize("motors", [False, True])
def test_torques_and_mass_matrix(motors: bool) -> None:
    model, state, key = arm(motors), DATA["state"], "motor" if motors else "nomotor"
    tau = model.inverse_dynamics(state["q"], state["u"], state["udot"])
    np.testing.assert_allclose(tau, DATA[f"tau_{key}"], rtol=0, atol=TOLERANCE)
    mass = model.mass_matrix(DATA["qn"])
    np.testing.assert_allclose(mass, DATA[f"M_qn_{key}"], rtol=0, atol=TOLERANCE)
    load = model.gravity(DATA["qn"])
    np.testing.assert_allclose(load, DATA["gravity_qn"], rtol=0, atol=TOLERANCE)


@pytest.mark.filterwarnings("ignore:.*triangle inequality")
def test_pose_and_mass_matrix_at_a_general_state() -> None:
    model, q = arm(False), DATA["state"]["q"]
    np.testing.assert_allclose(model.pose("link6", q), DATA["T6_q"], rtol=0, atol=TOLERANCE)
    np.testing.assert_allclose(model.mass_matrix(q), DATA["M_q"], rtol=0, atol=TOLERANCE)


@pytest.mark.filterwarnings("ignore:.*triangle inequality")
def test_parameters_are_those_of_the_table() -> None:
    found = arm(False).parameters
    for k, row in enumerate(DATA["rows"], 1):
        if row["mass"]:
            assert found[f"link{k}.mass"] == row["mass"]
        for axis, value in zip("xyz", row["com"], strict=True):
            if value:
                assert found[f"link{k}.com.{axis}"] == value
