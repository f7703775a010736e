"""Runs against the integrators of SciPy, which share no code with the kernels."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd

# two routes to one solution: each is right to some multiple of its tolerance
FINE = {"rtol": 1e-11, "atol": 1e-12}
THEIRS = {"rtol": 1e-11, "atol": 1e-12}
AGREE = {"rtol": 0, "atol": 1e-8}
Torque = Callable[[float, np.ndarray], float]


def feedback(t: float, x: np.ndarray) -> float:
    """A torque that follows time and state."""
    return float(np.sin(t) - x[0])


def ramp(t: float, x: np.ndarray) -> float:
    """A torque that grows."""
    return 1 + 2 * t


CASES: dict[str, tuple[str, dict[str, Any], Torque | None]] = {
    "tree": ("double", {"q": {"elbow": 0.4}}, None),
    "quaternion": ("ball", {"u": {"base": [1, 2, 3, 0, 1, 2]}}, None),
    "function": ("double", {"q": {"elbow": 0.4}, "inputs": {"torque": feedback}}, feedback),
    "table": ("double", {"inputs": {"torque": ([0, 0.3], [1, 1.6])}}, ramp),
}


@pytest.mark.parametrize("method", ["DOP853", "Radau"])
@pytest.mark.parametrize("case", CASES)
def test_same_motion(case: str, method: str, bare: Any, request: pytest.FixtureRequest) -> None:
    name, options, torque = CASES[case]
    model: cd.CompiledModel = request.getfixturevalue(name)
    end = 0.3

    def rhs(t: float, x: np.ndarray) -> np.ndarray:
        return np.asarray(model.rhs(t, x, r=None if torque is None else [torque(t, x)]))

    motion = model.simulate(end, method=method, **options, **FINE)
    theirs = solve_ivp(rhs, (0.0, end), motion.x[0], method, **THEIRS)
    assert theirs.success
    # quaternions keep their length to the tolerance there, being an integral of the equations
    np.testing.assert_allclose(motion.x[-1], theirs.y[:, -1], **AGREE)
    interpreted = bare(model).simulate(end, method=method, **options, **FINE)
    np.testing.assert_allclose(interpreted.x[-1], theirs.y[:, -1], **AGREE)
