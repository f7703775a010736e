"""Every integrator has the order its record states, at the steps and between them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cardan.schema.integrators import Integrator
from kernels.problem import METHODS, SWING, Problem, swing

# by order: steps over half a second at which the error is far from rounding
STEPS = {
    2: (20, 40, 80, 160, 320),
    3: (10, 20, 40, 80, 160),
    4: (5, 7, 10, 15, 20, 30),
    5: (13, 17, 25, 35, 50),
    8: (3, 4, 5, 6, 7, 8, 10),
}
# where spans start: the error of one span may change its sign with the step
STARTS = np.linspace(-1.5, 1.5, 12)
LENGTH = 0.5


def fixed(method: Integrator, h: float) -> dict[str, Any]:
    """Options that make a method take steps of size h: an adaptive one never sees an error."""
    if not method.adaptive:
        return {"method": method.name, "step": h}
    return {"method": method.name, "step": h, "max_step": h, "rtol": 0, "atol": 1e9}


def slope(steps: Any, errors: Any) -> float:
    """Exponent p of error = C h^p exp(c h) that fits best: the next power of h is felt."""
    h = np.asarray(steps)
    columns = np.stack([np.log(h), np.ones_like(h), h], axis=-1)
    return float(np.linalg.lstsq(columns, np.log(errors), rcond=None)[0][0])


def mean(errors: list[Any]) -> float:
    """Root mean square."""
    return float(np.sqrt(np.mean(np.square(errors))))


@pytest.mark.parametrize("method", METHODS.values(), ids=METHODS)
@pytest.mark.parametrize("direction", [1, -1])
def test_order_of_the_steps(method: Integrator, direction: int, tmp_path: Path) -> None:
    problem = Problem(tmp_path, SWING)
    steps, errors = LENGTH / np.array(STEPS[method.order]), []
    for h in steps:
        missed = []
        for start in STARTS:
            span = (start, start + direction * LENGTH)
            motion = problem.run(span, swing(start), **fixed(method, h))
            assert np.allclose(np.abs(np.diff(motion.t)), h, rtol=1e-9)
            missed.append(motion.x[-1] - swing(span[1]))
        errors.append(mean(missed))
    assert slope(steps, errors) == pytest.approx(method.order, abs=0.15)


@pytest.mark.parametrize("method", METHODS.values(), ids=METHODS)
def test_order_between_the_steps(method: Integrator, tmp_path: Path) -> None:
    problem = Problem(tmp_path, SWING)
    steps, errors = LENGTH / np.array(STEPS[method.order]), []
    for h in steps:
        missed = []
        for start in STARTS:
            # a single step, so that only what is inside it counts
            motion = problem.run((start, start + h), swing(start), **fixed(method, h))
            assert len(motion) == 2
            inside = start + h * np.linspace(0.05, 0.95, 19)
            missed.append(motion.at(inside) - swing(inside))
        errors.append(mean(missed))
    assert slope(steps, errors) == pytest.approx(method.dense_order + 1, abs=0.15)


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
