"""Modes of constrained sparse systems against dense eigenvalues."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eig, null_space

from cardan.errors import ArgumentError, SolveError
from cardan.runtime.absolute.solver import Solver, solver
from cardan.runtime.absolute.spectrum import modes
from cardan.runtime.absolute.superlu import SuperluSolver
from runtime.absolute.structures import Structure, line, values

FRAME = Structure(12, line(12), [(0, -1, 1), (4, 9, 2)], mass=0)


def problem(skew: float = 0.0) -> tuple[Solver, np.ndarray, np.ndarray]:
    """A frame with joints, and the mass of its nodes."""
    made = FRAME.plan()
    stiffness = Structure(12, FRAME.beams, FRAME.joints, mass=0, skew=skew).matrix(made)
    mass = np.zeros_like(stiffness)
    rng = np.random.default_rng(8)
    for node in range(12):
        half = rng.standard_normal((6, 6))
        at = slice(6 * node, 6 * node + 6)
        mass[at, at] = half @ half.T + np.eye(6)
    return solver(made), stiffness, mass


def reduced(by: Solver, stiffness: np.ndarray, mass: np.ndarray) -> np.ndarray:
    """Eigenvalues among the motions that the constraints allow."""
    speeds = np.repeat(~by.plan.pattern.multiplier, by.plan.pattern.sizes)
    free = null_space(stiffness[np.ix_(~speeds, speeds)])
    k, m = (free.T @ x[np.ix_(speeds, speeds)] @ free for x in (stiffness, mass))
    found = eig(k, m)[0]
    return found[np.isfinite(found)]


@pytest.mark.parametrize("shift", [0.0, 1.5])
@pytest.mark.parametrize("way", [solver, SuperluSolver])
def test_modes_of_symmetric_systems(shift: float, way: type[Solver]) -> None:
    by, stiffness, mass = problem()
    by = way(by.plan)
    k, m = (values(by.plan, x) for x in (stiffness, mass))
    found, vectors = modes(by, k, m, 6, shift)
    wanted = reduced(by, stiffness, mass).real
    wanted = wanted[np.argsort(np.abs(wanted - shift))][:6]
    assert found == pytest.approx(wanted, rel=1e-9)
    residual = stiffness @ vectors - mass @ vectors * found
    assert np.abs(residual).max() <= 1e-8 * np.abs(stiffness).max()


def test_modes_of_systems_that_are_not_symmetric() -> None:
    by, stiffness, mass = problem(skew=0.5)
    k, m = (values(by.plan, x) for x in (stiffness, mass))
    found, vectors = modes(by, k, m, 4, symmetric=False)
    residual = stiffness @ vectors - mass @ vectors * found
    assert np.abs(residual).max() <= 1e-8 * np.abs(stiffness).max()
    assert (np.diff(np.abs(found)) >= -1e-9).all()


def test_modes_that_cannot_be_found_are_refused() -> None:
    by, stiffness, mass = problem()
    k, m = (values(by.plan, x) for x in (stiffness, mass))
    for count in (0, by.plan.pattern.n - 1):
        with pytest.raises(ArgumentError, match=f"{count} modes of"):
            modes(by, k, m, count)
    with pytest.raises(SolveError, match="no equation holds"):
        modes(by, 0 * k, m, 2)
