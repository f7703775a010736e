"""Cables and trusses: slack, catenary, mass."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.elements.flexible import Cable, CableInertia
from cardan.ir.interpreter import evaluate
from elements.flexible.states import state


def test_slack_cables_do_not_push() -> None:
    loose = {"length": 2.0, "strain_4": 0.0}
    cable, bar = state(Cable(), **loose), state(Cable(compression=True), **loose)
    assert not cable.value("balance", "balance").any()
    assert not cable.value("balance_tangent", "K").any()
    apart = cable.poses[1][1] - cable.poses[0][1]
    ell = np.linalg.norm(apart)
    force = bar.numbers["EA"] * (ell / 2 - 1) * apart / ell
    assert bar.value("balance", "balance")[9:] == pytest.approx(force)


def test_catenary() -> None:
    """Sag of a hanging cable of points, second order in its pieces."""
    H, span, w = 1.0, 2.0, 1.0
    half = H / w * np.sinh(w * span / 2 / H)
    sag = H / w * (np.cosh(w * span / 2 / H) - 1)
    errors = [abs(_sag(n, 2 * half, span) - sag) for n in (8, 16)]
    assert errors[0] < 1e-2
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.1)


def _sag(n: int, length: float, span: float) -> float:
    """Of n pieces between two points, hanging by its own weight."""
    kinds = ("point", "point")
    parts = [(element, element.derived(kinds)) for element in (Cable(), CableInertia())]
    numbers = {"EA": 1e6, "strain_4": 0.0, "rhoA": 1.0, "gravity_2": -1.0, "length": length / n}
    s = np.linspace(-1, 1, n + 1)
    q = np.stack([span / 2 * s, 0.8 * (s**2 - 1), 0 * s], axis=1)
    free = np.arange(3, 3 * n)
    for _ in range(60):
        pairs = np.hstack([q[:-1], q[1:]])
        b, K = np.zeros(3 * n + 3), np.zeros((3 * n + 3, 3 * n + 3))
        for element, functions in parts:
            p = [numbers.get(name, 0.0) for name in element.data(kinds)]
            at = {"q": pairs, "u": 0 * pairs, "udot": 0 * pairs, "p": np.tile(p, (n, 1))}
            loads = evaluate(functions["balance"], at, "numpy")["balance"]
            slopes = evaluate(functions["balance_tangent"], at, "numpy").get("K")
            for e in range(n):
                b[3 * e : 3 * e + 6] += loads[e]
                if slopes is not None:
                    K[3 * e : 3 * e + 6, 3 * e : 3 * e + 6] += slopes[e]
        # a little stiffness out of the way of what still is loose
        K += 1e-9 * np.eye(len(K)) * abs(K).max()
        step = np.zeros(len(b))
        step[free] = np.linalg.solve(K[np.ix_(free, free)], -b[free])
        size = np.abs(step).max()
        q += step.reshape(-1, 3) * min(1.0, 0.05 / size)
        if size < 1e-10:
            return float(-q[n // 2, 1])
    raise ArithmeticError(f"no equilibrium, last step {size}")
