"""Random graphs of blocks of any size, with rows on any of them: as good as dense elimination."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cardan.runtime.sparse.block_solver import solution, solver
from cardan.runtime.sparse.plan import Plan, plan
from runtime.absolute.structures import values
from table import each

EPS = float(np.finfo(float).eps)


def drawn(seed: int) -> tuple[Plan, NDArray[np.float64]]:
    """A plan and a symmetric matrix, indefinite among its speeds."""
    rng = np.random.default_rng(seed)
    nb = int(rng.integers(1, 30))
    sizes = rng.integers(0, 8, nb).tolist()
    cliques = []
    for _ in range(rng.integers(0, 4)):
        k, count = int(rng.integers(1, min(4, nb) + 1)), int(rng.integers(1, nb + 1))
        cliques.append(np.array([rng.choice(nb, k, replace=False) for _ in range(count)]))
    massless = rng.random(nb) < 0.3
    for _ in range(int(rng.integers(0, nb))):
        held = rng.choice(nb, int(rng.integers(1, min(3, nb) + 1)), replace=False)
        room = sum(sizes[block] for block in held) // 2
        if room:
            cliques.append(np.array([[*held, len(sizes)]]))
            sizes.append(int(rng.integers(1, min(6, room) + 1)))
    multiplier = np.arange(len(sizes)) >= nb
    made = plan(sizes, cliques, multiplier, np.append(massless, multiplier[nb:] & False))
    columns, starts = made.pattern.csr
    rows = np.repeat(np.arange(made.pattern.n), np.diff(starts))
    a = np.zeros((made.pattern.n,) * 2)
    a[rows, columns] = rng.standard_normal(len(columns))
    speeds = np.repeat(~multiplier, sizes)
    return made, (a + a.T) / 2 + 3 * np.diag(speeds.astype(float))


@each("start", range(0, 200, 20))
def test_random_systems(start: int) -> None:
    """Replaced pivots are rare, and refinement makes up for them."""
    rare = 0
    for seed in range(start, start + 20):
        made, a = drawn(seed)
        condition = np.linalg.cond(a) if len(a) else 1.0
        if condition > 1e7:
            continue
        by = solver(made)
        by.factor(values(made, a), symmetric=True)
        b = np.cos(np.arange(float(len(a))))
        x, exact = by.refine(b, solution(by, b))[0], np.linalg.solve(a, b)
        assert np.abs(x - exact).max(initial=0) <= 1e2 * EPS * condition * np.abs(exact).max(
            initial=1
        )
        if len(by.weak):
            rare += 1
            continue
        assert by.determinant()[0] == (np.linalg.slogdet(a)[0] if len(a) else 1)
        eigenvalues = np.linalg.eigvalsh(a)
        assert by.inertia() == ((eigenvalues > 0).sum(), (eigenvalues < 0).sum(), 0)
    assert rare <= 2
