"""Derivatives of dynamics of real robots against Pinocchio's analytical ones.

Ours move along our speeds, Pinocchio's along its own, X(q) u. With a free base X turns with it, and
the rule of products brings the terms that are written out here.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pinocchio as pin
import pytest

import cardan as cd
from external.test_pinocchio import EPS, STATES, Case

ARMS = ("panda_description/urdf/panda.urdf", "ur_description/urdf/ur5_robot.urdf")
FLOATING = (
    "anymal_b_simple_description/robots/anymal.urdf",
    "talos_data/robots/talos_reduced.urdf",
)
CASES = [*((name, "fixed") for name in ARMS), (FLOATING[0], "free")]
CASES = [pytest.param(*case) for case in CASES]
CASES += [pytest.param(FLOATING[1], "free", marks=pytest.mark.external)]


def turning(case: Case, q: np.ndarray, x: np.ndarray) -> np.ndarray:
    """X' x along every speed (nv, nu): velocities of a free base are held in the ground's axes."""
    result = np.zeros((case.system.nu, case.system.nu))
    for slot in case.slots:
        if slot.free:
            start = case.peer.model.idx_vs[case.peer._index(slot)]
            # columns are turns about the body's axes: R' v = -turn x R v
            held = (case.peer.speeds(q) @ x)[start : start + 3]
            result[start : start + 3, slot.u : slot.u + 3] = pin.skew(held)
    return result


def theirs(case: Case, q: np.ndarray, u: np.ndarray, udot: np.ndarray) -> tuple[np.ndarray, ...]:
    """d tau / dq, du, d udot by Pinocchio, along our speeds."""
    peer, x = case.peer, case.peer.speeds(q)
    rate = peer.speeds_rate(q, u)
    v, a = x @ u, x @ udot + rate
    pin.computeRNEADerivatives(peer.model, peer.data, peer.q(q), v, a)
    dq, dv, m = (np.array(getattr(peer.data, n)) for n in ("dtau_dq", "dtau_dv", "M"))
    m = np.triu(m) + np.triu(m, 1).T
    tau = np.array(pin.rnea(peer.model, peer.data, peer.q(q), v, a))
    by_u_rate, by_q_rate = (np.zeros_like(dq) for _ in range(2))
    for slot in case.slots:
        if slot.free:
            # the rate of a free base's velocity is -omega x v, v in the axes of the body
            start, turn = peer.model.idx_vs[peer._index(slot)], u[slot.u : slot.u + 3]
            held, rows = v[start : start + 3], slice(start, start + 3)
            by_u_rate[rows, slot.u : slot.u + 3] = pin.skew(held)
            by_u_rate[rows] -= pin.skew(turn) @ x[rows]
            by_q_rate[rows] = -pin.skew(turn) @ turning(case, q, u)[rows]
    by_q = dq @ x + dv @ turning(case, q, u) + m @ (turning(case, q, udot) + by_q_rate)
    by_u = dv @ x + m @ by_u_rate
    # Xᵀ tau changes with X: its force turns with the base
    result = x.T @ by_q
    for slot in case.slots:
        if slot.free:
            start = peer.model.idx_vs[peer._index(slot)]
            back, force = x[start : start + 3, slot.u + 3 : slot.u + 6].T, tau[start : start + 3]
            result[slot.u + 3 : slot.u + 6, slot.u : slot.u + 3] -= back @ pin.skew(force)
    return result, x.T @ by_u, x.T @ m @ x


@pytest.mark.parametrize(("name", "base"), CASES)
def test_derivatives(name: str, base: str) -> None:
    case = Case(name, base, "free")
    model: Any = cd.compile(case.equations, functions=("derivative", "forward_dynamics"))
    model = model.with_parameters(case.undamped) if case.undamped else model
    triples = zip(case.q, case.u, case.udot, strict=True)
    expected = [theirs(case, *state) for state in triples]
    inverse = model.derivative("inverse_dynamics", wrt=("q", "u"))(case.q, case.u, case.udot)
    condition = np.linalg.cond(case.mass)
    for k, what in enumerate(("q", "u")):
        for n in range(STATES):
            size = np.abs(expected[n][0]).max() + np.abs(expected[n][1]).max()
            error = np.abs(inverse[k][n] - expected[n][k]).max()
            # rounding of either side along chains of some ten joints
            assert error <= 1000 * EPS * size, f"d inverse / d{what}, state {n}: {error / size:.1e}"
    # Pinocchio at the udot of the solution, solved with its M
    by_q, by_u, by_tau = model.derivative("forward_dynamics", wrt=("q", "u", "tau"))(
        case.q, case.u, tau=case.tau
    )
    udot = model.forward_dynamics(case.q, case.u, tau=case.tau)
    for n in range(STATES):
        dq, du, mass = theirs(case, case.q[n], case.u[n], udot[n])
        for ours, right in ((by_q[n], -dq), (by_u[n], -du), (by_tau[n], np.eye(model.nu))):
            solved = np.linalg.solve(mass, right)
            error = np.abs(ours - solved).max() / np.abs(solved).max()
            assert error <= min(100 * EPS * condition[n], 1e-9), f"state {n}: {error:.1e}"
