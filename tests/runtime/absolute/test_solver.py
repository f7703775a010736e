"""Solutions of sparse systems of blocks against dense NumPy."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from cardan.errors import ArgumentError, SolveError
from cardan.runtime.sparse.block_solver import ENOUGH, solution, solver
from cardan.runtime.sparse.plan import Plan, plan
from cardan.runtime.sparse.systems import assembled, balanced
from runtime.absolute.structures import STRUCTURES, Structure, bars, line, values
from table import each

EPS = float(np.finfo(float).eps)
Case = tuple[Plan, NDArray[np.float64], NDArray[np.float64]]


def made(structure: Structure, seed: int = 0) -> Case:
    """The plan, the dense matrix and its values."""
    drawn = structure.plan()
    a = structure.matrix(drawn, seed)
    return drawn, a, values(drawn, a)


@pytest.mark.parametrize("skew", [0.0, 0.2])
@pytest.mark.parametrize("name", STRUCTURES)
def test_solutions(name: str, skew: float) -> None:
    structure = STRUCTURES[name]
    if skew and not structure.mass and not structure.beams:
        pytest.skip("skew numbers would be all there is")
    drawn, a, numbers = made(replace(structure, skew=skew))
    by = solver(drawn)
    by.factor(numbers)
    b = np.random.default_rng(1).standard_normal((drawn.pattern.n, 3))
    condition = np.linalg.cond(a)
    for transposed, matrix in ((False, a), (True, a.T)):
        exact = np.linalg.solve(matrix, b)
        x = by.solve(b, transposed)
        # pivots within blocks only: growth of some hundreds at most here
        assert np.abs(x - exact).max() <= 1e3 * EPS * condition * np.abs(exact).max()
        assert (by.solve(b[:, 1], transposed) == x[:, 1]).all()
    better, error = by.refine(b[:, 0], by.solve(b[:, 0]))
    assert error <= ENOUGH
    assert np.abs(a @ better - b[:, 0]).max() <= 1e2 * EPS * np.abs(a).sum(1).max() * max(
        np.abs(better).max(), 1
    )
    assert not len(by.weak)
    assert by.perturbation(b[:, 0], better) == (0.0, -1)


@pytest.mark.parametrize("place", [0, -1])
def test_what_is_no_number_is_no_solution(place: int) -> None:
    drawn, _, numbers = made(next(iter(STRUCTURES.values())))
    by = solver(drawn)
    by.factor(numbers)
    b = np.ones(drawn.pattern.n)
    x = by.solve(b)
    x[place] = np.nan
    assert by.refine(b, x)[1] == np.inf
    b[place] = np.inf
    assert by.refine(b, np.zeros(len(b)))[1] == np.inf


@each("name", STRUCTURES)
def test_determinant_signs_and_smallest(name: str) -> None:
    drawn, a, numbers = made(STRUCTURES[name])
    by = solver(drawn)
    by.factor(numbers, symmetric=True)
    sign, size = np.linalg.slogdet(a)
    found = by.determinant()
    assert found[0] == sign
    assert found[1] == pytest.approx(size, abs=1e-9 * len(a))
    eigenvalues = np.linalg.eigvalsh(a)
    assert by.inertia() == ((eigenvalues > 0).sum(), (eigenvalues < 0).sum(), 0)
    # inverse iteration comes from above; close singular values slow it down
    least = np.abs(eigenvalues).min()
    estimate, x = by.smallest(8)
    assert least * (1 - 1e-6) <= estimate <= 1.2 * least
    assert np.linalg.norm(a @ x) <= 1.5 * least * np.linalg.norm(x)


def test_signs_follow_a_tangent_through_its_singular_points() -> None:
    """As many eigenvalues change sign as the shift passes."""
    drawn, a, _ = made(Structure(8, line(8), [(0, -1, 1)], mass=0))
    speeds = np.repeat(~drawn.pattern.multiplier, drawn.pattern.sizes)
    by = solver(drawn)
    for shift in (0.01, 0.3, 2.0, 10.0, 40.0):
        moved = a - shift * np.diag(speeds.astype(float))
        # joints have no diagonal of their own here
        by.factor(values(drawn, moved), symmetric=True)
        eigenvalues = np.linalg.eigvalsh(moved)
        assert by.inertia() == ((eigenvalues > 0).sum(), (eigenvalues < 0).sum(), 0)


@pytest.mark.parametrize("name", ["beam", "bodies in a row", "frame with joints", "ring of beams"])
def test_units(name: str) -> None:
    """Equations in newtons and unknowns in gigameters: as good as in units of their own."""
    drawn, a, plain = made(STRUCTURES[name])
    rng = np.random.default_rng(2)
    rows, columns = 10 ** rng.uniform(-6, 9, (2, len(a)))
    b = rng.standard_normal(len(a))
    by = solver(drawn)
    by.factor(values(drawn, a / rows[:, None] / columns), rows, columns)
    x, error = by.refine(b / rows, by.solve(b / rows))
    exact = np.linalg.solve(a, b)
    assert error <= ENOUGH
    assert np.abs(x / columns - exact).max() <= 1e3 * EPS * np.linalg.cond(a) * np.abs(exact).max()
    turned = by.solve(b / columns, transposed=True)
    exact = np.linalg.solve(a.T, b)
    assert np.abs(turned / rows - exact).max() <= 1e-9 * np.abs(exact).max()
    units = np.log(rows).sum() + np.log(columns).sum()
    sign, size = np.linalg.slogdet(a)
    assert by.determinant() == (sign, pytest.approx(size - units, abs=1e-9 * len(a)))
    by.factor(plain)
    estimate = by.smallest(8)[0]
    by.factor(values(drawn, a / rows[:, None] / columns), rows, columns)
    least, x = by.smallest(8)
    assert least == pytest.approx(estimate, rel=1e-6)
    assert np.linalg.norm((a / rows[:, None] / columns @ x) * rows) == pytest.approx(least, rel=0.2)


def test_balanced_units_do_as_well() -> None:
    drawn, a, _ = made(STRUCTURES["frame with joints"])
    scale = 10 ** np.random.default_rng(3).uniform(-6, 9, len(a))
    bad = values(drawn, a * scale[:, None] * scale)
    rows, columns = balanced(drawn, bad)
    assert rows == pytest.approx(columns, rel=1e-12)
    near = abs(assembled(drawn, bad)).toarray() * rows[:, None] * columns
    assert 0.1 < near.max(axis=0).min() <= near.max() < 10
    by = solver(drawn)
    by.factor(bad, rows, columns)
    b = np.ones(len(a))
    x = by.solve(b * scale)
    exact = np.linalg.solve(a, b)
    assert np.abs(x * scale - exact).max() <= 1e3 * EPS * np.linalg.cond(a) * np.abs(exact).max()


def test_nothing_to_solve() -> None:
    by = solver(plan([], []))
    by.factor([], symmetric=True)
    assert by.solve([]).shape == (0,)
    assert by.solve(np.zeros((0, 2))).shape == (0, 2)
    assert by.inertia() == (0, 0, 0)
    assert by.determinant() == (1.0, 0.0)
    assert by.refine([], [])[1] == 0
    assert by.smallest()[0] == 0


@pytest.mark.parametrize("size", [1, 2, 5, 13, 60])
def test_one_block(size: int) -> None:
    drawn = plan([size], [])
    a = np.random.default_rng(size).standard_normal((size, size))
    by = solver(drawn)
    by.factor(a.reshape(-1))
    b = np.arange(1.0, size + 1)
    assert by.solve(b) == pytest.approx(np.linalg.solve(a, b), rel=1e-10)


def test_what_does_not_fit_is_refused() -> None:
    by = solver(plan([2, 1], [[[0, 1]]]))
    for call in (by.inertia, by.determinant, by.smallest, lambda: by.solve([1, 2, 3])):
        with pytest.raises(SolveError, match="call factor first"):
            call()
    with pytest.raises(ArgumentError, match=r"values: shape \(3,\) instead of \(9,\)"):
        by.factor([1, 2, 3])
    with pytest.raises(ArgumentError, match="rows: units are positive"):
        by.factor(np.eye(3).reshape(-1), rows=[1, 0, 1])
    by.factor(np.eye(3).reshape(-1))
    with pytest.raises(ArgumentError, match=r"b: shape \(2,\) for 3 unknowns"):
        by.solve([1, 2])
    with pytest.raises(ArgumentError, match="symmetric=True"):
        by.inertia()


def test_numbers_that_are_none_are_named() -> None:
    drawn, _, numbers = made(Structure(6, [], bars(6)))
    starts = drawn.pattern.csr[1]
    for bad in (np.nan, np.inf):
        numbers[starts[6 * 4 + 2]] = bad
        by = solver(drawn)
        with pytest.raises(SolveError, match=rf"speed 2 of block 4 holds {bad}"):
            by.factor(numbers)
        with pytest.raises(SolveError, match="call factor first"):
            by.solve(np.ones(drawn.pattern.n))


def test_solution_is_the_solve_where_nothing_is_lost() -> None:
    drawn, a, numbers = made(STRUCTURES["beam"])
    by = solver(drawn)
    by.factor(numbers)
    b = np.ones(len(a))
    assert (solution(by, b) == by.solve(b)).all()
