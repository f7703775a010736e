"""Residuals and tangents of implicit methods against the functions they are made of."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from mechanisms import ZOO
from mechanisms.closed import CLOSED
from mechanisms.rolling import ROLLING

SEED = 5
STEP = 1e-6
Array = np.ndarray
NAMES = ("spherical_quaternion", "free_XYZ", "branched", "prescribed")


def chosen() -> dict[str, Any]:
    """Closed, rolling, and some of the trees."""
    trees = {name: ZOO[name].build for name in NAMES if name in ZOO}
    trees |= {name: ZOO[name].build for name in list(ZOO)[::9]}
    closed = {name: CLOSED[name].build for name in ("four_bar", "bricard")}
    return trees | closed | dict(list(ROLLING.items())[:1])


class Case:
    """A model at a state that constraints need not allow."""

    def __init__(self, scene: cd.Scene) -> None:
        self.model = cd.compile(scene)
        rng = np.random.default_rng(SEED)
        self.q, self.u = self.model.split(self.model.random_state(rng))
        self.udot, self.lam = rng.normal(size=self.model.nu), rng.normal(size=self.model.nlam)

    def balance(self, q: Array, u: Array, udot: Array) -> Array:
        values = (0.3, q, u, udot, self.lam, None, None, None)
        return self.model._evaluate(("balance", None), values, None, None)

    def tangent(self) -> list[Array]:
        """K, C, M, R and G."""
        nu, m = self.model.nu, self.model.nlam
        values = (0.3, self.q, self.u, self.udot, self.lam, None, None, None)
        flat = self.model._evaluate(("balance_tangent", None), values, None, None).ravel()
        ends = np.cumsum([nu, nu, nu, m])[: 4 if m else 2] * nu
        parts = np.split(flat, ends)
        return [part.reshape(-1, nu) for part in parts]

    def differences(self, along: str) -> Array:
        """Columns of the balance along q (moved by speeds), u or udot, second order."""
        columns = []
        for e in np.eye(self.model.nu) * STEP:
            sides = []
            for sign in (1, -1):
                q = self.model.integrate(self.q, sign * e) if along == "q" else self.q
                u = self.u + sign * e if along == "u" else self.u
                udot = self.udot + sign * e if along == "udot" else self.udot
                sides.append(self.balance(q, u, udot))
            columns.append((sides[0] - sides[1]) / (2 * STEP))
        return np.stack(columns, axis=-1)


@pytest.fixture(scope="module", params=chosen().items(), ids=lambda item: item[0])
def case(request: pytest.FixtureRequest) -> Case:
    return Case(request.param[1]())


def test_balance_is_what_the_functions_say(case: Case) -> None:
    model, rest = case.model, {"t": 0.3}
    expected = [model.inverse_dynamics(case.q, case.u, case.udot, **rest)]
    if model.nlam:
        expected[0] = expected[0] - model.constraint_jacobian(case.q, **rest).T @ case.lam
        if any(row["level"] == "position" for row in model.manifest["multipliers"]):
            expected.append(model.constraints(case.q, **rest))
        expected.append(model.constraint_rates(case.q, case.u, **rest))
    found, wanted = case.balance(case.q, case.u, case.udot), np.concatenate(expected)
    # both sides round, on other ways
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-12 * (1 + np.abs(wanted).max()))


def test_tangent_is_the_derivative(case: Case) -> None:
    nu, m = case.model.nu, case.model.nlam
    by_q, by_u, by_udot = (case.differences(along) for along in ("q", "u", "udot"))
    K, C, M, *bound = case.tangent()
    scale = 1 + max(np.abs(x).max() for x in (by_q, by_u, by_udot))
    # of differences of second order: eps / STEP and STEP^2
    tolerance = 1e-8 * scale
    for found, wanted in ((K, by_q[:nu]), (C, by_u[:nu]), (M, by_udot[:nu])):
        np.testing.assert_allclose(found, wanted, rtol=0, atol=tolerance)
    if m:
        R, G = bound
        np.testing.assert_allclose(R, by_q[-m:], rtol=0, atol=tolerance)
        np.testing.assert_allclose(G, by_u[-m:], rtol=0, atol=tolerance)
        positions = len(by_q) - nu - m
        np.testing.assert_allclose(G[:positions], by_q[nu : nu + positions], rtol=0, atol=tolerance)


def test_move_and_its_tangent(case: Case) -> None:
    model, nu = case.model, case.model.nu
    step = np.random.default_rng(SEED).normal(size=nu)
    moved = model._evaluate(("move", None), (case.q, step), None, None)
    q, tangent = moved[: model.nq], moved[model.nq :].reshape(nu, nu)
    np.testing.assert_array_equal(q, model.integrate(case.q, step))
    for k, e in enumerate(np.eye(nu) * STEP):
        ends = [model.difference(q, model.integrate(case.q, step + s * e)) for s in (1, -1)]
        column = (ends[0] - ends[1]) / (2 * STEP)
        np.testing.assert_allclose(tangent[:, k], column, rtol=0, atol=1e-8)
