"""Redundant constraints, mechanisms and empty equations: what remains is solved, the rest named."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from cardan.errors import SolveError
from cardan.runtime.sparse.block_solver import BlockSolver, solution, solver
from cardan.runtime.sparse.plan import Plan, plan
from runtime.absolute.structures import GROUND, Structure, bars, definite, line, values

REDUNDANT = {
    "one joint twice": Structure(1, [], [(0, GROUND, 1)], again=1),
    "joints of a row twice": Structure(20, [], bars(20), again=3),
    "all joints twice": Structure(10, [], bars(10, 2), again=10),
    "a ring with a joint twice": Structure(8, [], [*bars(8), (7, GROUND, 1)], again=4),
}


@pytest.mark.parametrize("name", REDUNDANT)
def test_redundant_constraints_leave_bounded_multipliers(name: str) -> None:
    structure = REDUNDANT[name]
    drawn = structure.plan()
    a = structure.matrix(drawn)
    wanted = np.random.default_rng(4).standard_normal(len(a))
    by = solver(drawn)
    by.factor(values(drawn, a))
    x = solution(by, a @ wanted)
    # speeds are unique, multipliers are not; together they are not larger than need be
    speeds = np.repeat(~drawn.pattern.multiplier, drawn.pattern.sizes)
    singular = np.linalg.svd(a, compute_uv=False)
    condition = singular[0] / singular[singular > 1e-10 * singular[0]].min()
    assert np.abs((x - wanted)[speeds]).max() <= 1e-12 * condition
    assert np.abs(x).max() <= 1e2 * np.abs(wanted).max()
    assert np.abs(a @ (x - wanted)).max() <= 1e-12
    assert len(by.weak)
    assert drawn.pattern.multiplier[drawn.pattern.block_of(by.weak[0])]


def test_signs_without_redundant_rows() -> None:
    structure = REDUNDANT["joints of a row twice"]
    drawn = structure.plan()
    a = structure.matrix(drawn)
    by = solver(drawn)
    by.factor(values(drawn, a), symmetric=True)
    eigenvalues = np.linalg.eigvalsh(a)
    wanted = ((eigenvalues > 1e-9).sum(), (eigenvalues < -1e-9).sum(), 6 * structure.again)
    assert by.inertia() == wanted


def test_contradicting_constraints_are_named() -> None:
    structure = REDUNDANT["joints of a row twice"]
    drawn = structure.plan()
    a = structure.matrix(drawn)
    by = solver(drawn)
    by.factor(values(drawn, a))
    b = np.zeros(len(a))
    b[drawn.pattern.first[-2] :] = 1.0
    with pytest.raises(SolveError, match=r"nothing but rounding holds multiplier \d of block"):
        solution(by, b)


def solved(
    by: BlockSolver, numbers: NDArray[np.float64], b: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Factor and solve."""
    by.factor(numbers)
    return solution(by, b)


ROWS = ((1.0, 0.0, 0.0), (1.0, 1e-5, 0.0)), ((0.0, 1.0, 0.0), (0.3, 0.4, 0.0))


def beside(rows: NDArray[np.float64]) -> tuple[Plan, NDArray[np.float64]]:
    """A node with rows on it, the first two of which stand at an angle of 1e-5."""
    drawn = plan([3, 2, len(rows) - 2], [[[0, 1]], [[0, 2]]], multiplier=[False, True, True])
    a = np.zeros((3 + len(rows),) * 2)
    a[:3, :3] = np.diag([1.0, 2.0, 3.0])
    a[:3, 3:], a[3:, :3] = rows.T, rows
    return drawn, a


def test_multipliers_do_not_grow_by_the_angle_between_redundant_rows() -> None:
    """Rows at an angle of 1e-5, of which rounding is not to choose: all of them give way."""
    drawn, a = beside(np.concatenate(ROWS))
    wanted = np.array([0.5, -0.3, 0.2, 1.0, 0.0, -0.7, 0.4])
    by = solver(drawn)
    by.factor(values(drawn, a))
    x = solution(by, a @ wanted)
    assert len(by.weak) == 4
    assert np.abs(x[:3] - wanted[:3]).max() < 1e-13
    assert np.abs(x).max() < 10
    assert np.abs(a @ (x - wanted)).max() < 1e-13


def test_columns_change_places_both_ways() -> None:
    """What is solved, turned and counted with columns exchanged is what the matrix is."""
    drawn, a = beside(np.concatenate([ROWS[0], [[0.2, 0.4, 1.0]]]))
    by, b = solver(drawn), np.arange(1.0, 7.0)
    by.factor(values(drawn, a))
    assert not len(by.weak)
    np.testing.assert_allclose(by.solve(b), np.linalg.solve(a, b), rtol=1e-5)
    np.testing.assert_allclose(by.solve(b, transposed=True), np.linalg.solve(a.T, b), rtol=1e-5)
    sign, size = np.linalg.slogdet(a)
    np.testing.assert_allclose(by.determinant(), (sign, size), rtol=1e-5)


def test_a_mechanism_without_mass_is_named() -> None:
    structure = Structure(5, [], bars(5), mass=0)
    drawn = structure.plan()
    a = structure.matrix(drawn)
    b = np.random.default_rng(5).standard_normal(len(a))
    with pytest.raises(SolveError, match=r"the matrix is singular"):
        solved(solver(drawn), values(drawn, a), b)


def free_beam() -> tuple[Plan, NDArray[np.float64]]:
    """Six nodes in a row; what moves the two ends of an element alike costs nothing."""
    drawn = plan([6] * 6, [np.array(line(6))])
    rng, a = np.random.default_rng(6), np.zeros((36, 36))
    apart = np.concatenate([np.eye(6), -np.eye(6)], axis=1)
    for i, j in line(6):
        at = np.r_[6 * i : 6 * i + 6, 6 * j : 6 * j + 6]
        a[np.ix_(at, at)] += apart.T @ definite(rng, 6) @ apart
    return drawn, a


def test_a_free_beam_is_named() -> None:
    drawn, a = free_beam()
    with pytest.raises(SolveError, match=r"singular"):
        solved(solver(drawn), values(drawn, a), np.arange(36.0))


def test_loads_in_balance_are_carried_by_a_free_beam() -> None:
    drawn, a = free_beam()
    by, b = solver(drawn), a @ np.random.default_rng(7).standard_normal(36)
    x = solved(by, values(drawn, a), b)
    assert len(by.weak) == 6
    assert np.abs(a @ x - b).max() <= 1e-12 * np.abs(b).max()


def test_an_empty_equation_is_named() -> None:
    drawn = plan([6, 6, 2], [[[0, 1]]])
    a = np.zeros((14, 14))
    a[:12, :12] = 3 * np.eye(12)
    with pytest.raises(SolveError, match="speed 0 of block 2: no equation holds this unknown"):
        solver(drawn).factor(values(drawn, a))


def test_a_multiplier_of_nothing_is_zero() -> None:
    """A constraint that no speed changes is one that always holds."""
    drawn = plan([6, 1], [[[0]], [[1]]], multiplier=[False, True])
    by = solver(drawn)
    by.factor(np.eye(6).reshape(-1))
    b = np.r_[np.arange(1.0, 7.0), 0.0]
    assert solution(by, b) == pytest.approx(b, rel=1e-14)


def test_zeros_on_diagonals_are_pivoted_or_refined() -> None:
    """Nodes of speeds that hold each other only through constraints: nothing on any diagonal."""
    drawn = plan([3, 3, 3], [[[0, 1, 2]]])
    a = np.zeros((9, 9))
    a[0:3, 3:6] = a[3:6, 6:9] = a[6:9, 0:3] = np.eye(3)
    a = a + a.T
    by = solver(drawn)
    by.factor(values(drawn, a))
    b = np.arange(1.0, 10.0)
    assert solution(by, b) == pytest.approx(np.linalg.solve(a, b), rel=1e-12)


def test_nodes_eliminated_before_anything_holds_them() -> None:
    """A chain of nodes whose blocks meet beside the diagonal only: pivots come by refinement."""
    n = 10
    drawn = plan([2] * n, [np.stack([np.arange(n - 1), np.arange(1, n)], 1)])
    a = np.kron(np.eye(n, k=1) + np.eye(n, k=-1), np.array([[2.0, 1.0], [1.0, 3.0]]))
    by = solver(drawn)
    by.factor(values(drawn, a))
    b = np.cos(np.arange(2.0 * n))
    assert len(by.weak)
    assert solution(by, b) == pytest.approx(np.linalg.solve(a, b), rel=1e-9)
