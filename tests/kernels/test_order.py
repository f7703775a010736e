"""Every integrator has the order its record states, at the steps and between them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cardan.analyses.integrators import INTEGRATORS, Integrator
from kernels.problem import SWING, Problem, swing

# steps at which the error is far from rounding and from the region where it is no power of h
STEPS = {4: (0.02, 0.01, 0.005), 5: (0.04, 0.02, 0.01), 8: (0.1, 0.08, 0.05, 0.04)}


def fixed(method: Integrator, h: float) -> dict[str, Any]:
    """Options that make a method take steps of size h: an adaptive one never sees an error."""
    if not method.adaptive:
        return {"method": method.name, "step": h}
    return {"method": method.name, "step": h, "max_step": h, "rtol": 0, "atol": 1e9}


def slope(steps: Any, errors: Any) -> float:
    """Exponent p of error = C h^p that fits best."""
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


@pytest.mark.parametrize("method", INTEGRATORS.values(), ids=INTEGRATORS)
@pytest.mark.parametrize("direction", [1, -1])
def test_order_of_the_steps(method: Integrator, direction: int, tmp_path: Path) -> None:
    problem = Problem(tmp_path, SWING)
    span = (0.0, 1.6) if direction > 0 else (1.6, 0.0)
    steps, errors = STEPS[method.order], []
    for h in steps:
        motion = problem.run(span, swing(span[0]), **fixed(method, h))
        assert np.allclose(np.abs(np.diff(motion.t))[:-1], h, rtol=1e-9)
        errors.append(np.abs(motion.x - swing(motion.t)).max())
    # the next powers of h are still felt: half a power of freedom
    assert slope(steps, errors) == pytest.approx(method.order, abs=0.5)


@pytest.mark.parametrize("method", INTEGRATORS.values(), ids=INTEGRATORS)
def test_order_between_the_steps(method: Integrator, tmp_path: Path) -> None:
    problem = Problem(tmp_path, SWING)
    steps, errors = STEPS[method.order], []
    for h in steps:
        # a single step, so that only what is inside it counts
        motion = problem.run((1.0, 1.0 + h), swing(1.0), **fixed(method, h))
        assert len(motion) == 2
        inside = 1.0 + h * np.linspace(0.05, 0.95, 19)
        errors.append(np.abs(motion.at(inside) - swing(inside)).max())
    assert slope(steps, errors) == pytest.approx(method.dense_order + 1, abs=0.5)


def test_adaptive_error_follows_the_tolerance(tmp_path: Path) -> None:
    problem = Problem(tmp_path, SWING)
    tolerances = 10.0 ** -np.arange(4, 13, 2)
    errors, steps = [], []
    for tolerance in tolerances:
        motion = problem.run((0.0, 3.0), swing(0.0), rtol=tolerance, atol=tolerance)
        errors.append(np.abs(motion.x - swing(motion.t)).max())
        steps.append(motion.statistics["steps"])
    # errors grow along this motion by two powers of ten; steps by tolerance^(1/8)
    assert (np.array(errors) < 300 * tolerances).all()
    growth = np.log(np.array(steps[1:]) / steps[:-1]) / np.log(100)
    assert growth == pytest.approx(1 / 8, abs=0.05)
