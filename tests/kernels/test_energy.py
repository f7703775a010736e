"""The method that keeps the energy balance: at any step, with order 2, there and back."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cardan.errors import SolveWarning
from kernels.problem import TOP_START, TOP_THERE, Problem, top
from kernels.test_order import slope

METHOD: dict[str, Any] = {"method": "EnergyMidpoint"}
# an anharmonic oscillator
QUARTIC = "out[0] = u[0]; out[1] = -q[0] * q[0] * q[0];"
QUARTIC_ENERGY = """
    out[0] = 0.5 * u[0] * u[0]; out[1] = 0.25 * q[0] * q[0] * q[0] * q[0]; out[2] = out[0] + out[1];
"""
TOP_ENERGY = """
    out[0] = 0.5 * (15.234375 * (u[0] * u[0] + u[2] * u[2]) + 0.46875 * u[1] * u[1]);
    out[1] = 15 * 9.81 * 2 * (q[2] * q[3] + q[0] * q[1]); out[2] = out[0] + out[1];
"""


def total(motion: Any) -> np.ndarray:
    """Energies of the top along a motion."""
    (w, x, y, z), (a, b, c) = motion.q.T, motion.u.T
    kinetic = 0.5 * (15.234375 * (a * a + c * c) + 0.46875 * b * b)
    return np.asarray(kinetic + 15 * 9.81 * 2 * (y * z + w * x))


def quartic(folder: Path, **changed: Any) -> Problem:
    return Problem(folder, **({"rhs": QUARTIC, "energy_of": QUARTIC_ENERGY} | changed))


def test_order_of_the_steps(tmp_path: Path) -> None:
    problem, there = top(tmp_path, energy_of=TOP_ENERGY), np.array(TOP_THERE)
    steps, errors = 0.1 / np.array((400, 500, 640, 800, 1000)), []
    for h in steps:
        end = problem.run((0, 0.1), TOP_START, step=h, **METHOD).x[-1]
        end[:4] *= np.sign(end[:4] @ there[:4])
        missed = np.abs(end - there)
        errors.append((missed[:4].max(), missed[4:].max()))
    for block in np.transpose(errors):
        assert slope(steps, block) == pytest.approx(2, abs=0.15)


def test_order_between_the_steps(tmp_path: Path) -> None:
    problem, steps, errors = quartic(tmp_path), np.array((0.2, 0.15, 0.1, 0.07, 0.05)), []
    known = problem.run(1.0, [0.7, 0.4], rtol=1e-13, atol=1e-15)
    for h in steps:
        motion, inside = problem.run(h, [0.7, 0.4], step=h, **METHOD), h * np.linspace(0.1, 0.9, 9)
        errors.append(np.abs(motion.at(inside) - known.at(inside)).max())
    assert slope(steps, errors) == pytest.approx(3, abs=0.15)


@pytest.mark.parametrize("step", [1e-3, 4e-3, 1e-2])
def test_energy_over_many_steps(step: float, tmp_path: Path) -> None:
    problem, times = top(tmp_path, energy_of=TOP_ENERGY), np.linspace(0, 1e5 * step, 1001)
    motion = problem.run(times, TOP_START, step=step, **METHOD)
    assert motion.status == "finished"
    energy = total(motion)
    assert np.abs(energy / energy[0] - 1).max() <= 1e-11
    np.testing.assert_allclose(np.linalg.norm(motion.q, axis=1), 1, rtol=0, atol=4e-16)
    # the spin is not kept by itself: what balances the energy is taken from it, and given back
    assert np.abs(motion.u[:, 1] - 150).max() <= 0.1


def test_a_system_of_one_coordinate_keeps_its_amplitude(tmp_path: Path) -> None:
    # 16 steps in a period of 7.4 s; the classical method loses a third of its energy
    motion = quartic(tmp_path).run(1000.0, [1.0, 0.0], step=0.5, **METHOD)
    energy = 0.5 * motion.u[:, 0] ** 2 + 0.25 * motion.q[:, 0] ** 4
    np.testing.assert_allclose(energy, 0.25, rtol=1e-12)
    other = quartic(tmp_path).run(1000.0, [1.0, 0.0], step=0.5, method="RK4")
    lost = 0.5 * other.u[-1, 0] ** 2 + 0.25 * other.q[-1, 0] ** 4
    assert lost < 0.17


def test_there_and_back(tmp_path: Path) -> None:
    problem = quartic(tmp_path)
    there = problem.run((0, 20.0), [1.0, 0.3], step=0.25, **METHOD)
    back = problem.run((20.0, 0), there.x[-1], step=0.25, **METHOD)
    # symmetric: errors of the way there are taken back
    np.testing.assert_allclose(back.x[::-1], there.x, rtol=0, atol=1e-10)


@pytest.mark.parametrize("step", [0.05, 0.5])
def test_the_balance_holds_with_losses(step: float, tmp_path: Path) -> None:
    damped = quartic(
        tmp_path,
        rhs=QUARTIC + "out[1] += -0.1 * u[0] + sin(t);",
        power="out[0] = (-0.1 * u[0] + sin(t)) * u[0];",
    )
    motion = damped.run(100.0, [1.0, 0.0], step=step, **METHOD)
    energy = 0.5 * motion.u[:, 0] ** 2 + 0.25 * motion.q[:, 0] ** 4
    np.testing.assert_allclose(energy - 0.25, motion.work["source"], rtol=0, atol=1e-12)
    assert np.abs(motion.work["source"]).max() > 0.2


@pytest.mark.parametrize("start", [[1.0, 0.0], [0.0, 1e-6], [0.0, 0.0]])
def test_from_rest(start: list[float], tmp_path: Path) -> None:
    motion = quartic(tmp_path).run(5.0, start, step=0.1, **METHOD)
    assert motion.status == "finished"
    known = quartic(tmp_path).run(5.0, start, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(motion.x[-1], known.x[-1], rtol=0, atol=5e-3 * max(start))


@pytest.mark.parametrize("step", [1e-3, 1e-5, 1e-7])
@pytest.mark.parametrize("start", [[1.0, 0.0], [1.0, 1e-6], [3.0, 0.0]])
def test_short_steps_from_rest(start: list[float], step: float, tmp_path: Path) -> None:
    # what a step changes at first is far below what the energy rounds by
    motion = quartic(tmp_path).run(500 * step, start, step=step, **METHOD)
    assert motion.status == "finished"
    assert len(motion) == 501
    known = quartic(tmp_path).run(500 * step, start, rtol=1e-13, atol=1e-15)
    # of order 2, and roundings in every step
    allowed = 2 * step**2 * np.abs(known.x).max() + 2e-13
    assert np.abs(motion.x[-1] - known.x[-1]).max() <= allowed


def test_no_solution_is_said(tmp_path: Path) -> None:
    # nothing can have this energy but the start
    other = quartic(tmp_path, energy_of="out[0] = 0; out[1] = out[2] = t > 0.35;")
    with pytest.warns(SolveWarning, match=r"t = 0.35?.* not solved.*step= or max_step= shorter"):
        motion = other.run(1.0, [1.0, 0.0], step=0.1, **METHOD)
    assert motion.status == "not_solved"
    assert len(motion) > 3
