"""The falling beam by cardan and by Exudyn's 3-D cable: time of a run at equal error.

A cable has neither shear nor rotary inertia and converges to another motion: the error of each is
that against its own finest mesh, extrapolated, at the same steps. Times are those of the processor,
reported and never asserted.

usage: flexible_cable.py
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

# the benchmarks stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from numpy.typing import NDArray

import cardan as cd
from benchmarks import flexible_exudyn as exudyn
from benchmarks import flexible_problem as problem

Array = NDArray[np.float64]
STEPS = round(problem.END / problem.STEP)
SIZES, FINE, ROUNDS = (4, 8, 16, 32), (64, 128), 3
AIM = 8.0


@dataclass(frozen=True)
class Pair:
    """A run of the cable and what cardan takes for the same error.

    Attributes:
        elements: Of the cable.
        error: Of its tip against its own limit [m].
        theirs, ours: Times of a step [s].
    """

    elements: int
    error: float
    theirs: float
    ours: float

    @property
    def ratio(self) -> float:
        """How many times longer the cable takes."""
        return self.theirs / self.ours


def _error(tip: Array, exact: Array) -> float:
    return float(np.sqrt(((tip - exact) ** 2).sum(axis=1).mean()))


def _limit(fine: Array, coarse: Array, order: int) -> Array:
    """What meshes of half the length converge to."""
    return np.asarray(fine + (fine - coarse) / (2**order - 1))


def _curve(runs: dict[int, tuple[float, Array]], order: int) -> list[tuple[int, float, float]]:
    """Elements, error and time of a step of every mesh but the finest."""
    coarse, fine = (runs[n][1] for n in FINE)
    exact = _limit(fine, coarse, order)
    return [(n, _error(runs[n][1], exact), runs[n][0]) for n in SIZES]


def _ours(n: int) -> tuple[float, Array]:
    model = cd.compile(problem.scene(n))
    problem.run(model, STEPS)
    return min((problem.run(model, STEPS) for _ in range(ROUNDS)), key=lambda p: p[0])


def _theirs(n: int) -> tuple[float, Array]:
    rounds = (exudyn.run(exudyn.spatial_cable, n, STEPS) for _ in range(ROUNDS))
    return min(rounds, key=lambda pair: pair[0])


def pairs() -> Iterator[Pair]:
    """The meshes of the cable, and cardan's time between its own meshes for the same error."""
    ours = _curve({n: _ours(n) for n in (*SIZES, *FINE)}, 2)
    theirs = _curve({n: _theirs(n) for n in (*SIZES, *FINE)}, 4)
    errors = np.log([error for _, error, _ in ours])[::-1]
    times = np.log([seconds for _, _, seconds in ours])[::-1]
    for n, error, seconds in theirs:
        # beyond the coarsest and the finest mesh nothing is claimed
        if errors[0] <= np.log(error) <= errors[-1]:
            yield Pair(n, error, seconds, float(np.exp(np.interp(np.log(error), errors, times))))


def main() -> int:
    """Measure and print."""
    for pair in pairs():
        theirs, ours = 1e6 * pair.theirs, 1e6 * pair.ours
        print(f"cable of {pair.elements}: {1e3 * pair.error:.2g} mm, {theirs:.1f} us/step", end="")
        print(f"; cardan {ours:.1f} us/step for the same error: {pair.ratio:.1f} times less")
    return 0


if __name__ == "__main__":
    sys.exit(main())
