"""Sparse systems with constraints factored block by block: solutions, modes, what is loose."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import eigh, null_space
from scipy.sparse import block_array, csr_array, diags_array

from cardan.analyses.systems import sparse_saddle_point
from cardan.analyses.systems.saddle_point import Dense, Singular, Sparse, near, near_quadratic
from cardan.analyses.systems.sparse_saddle_point import SparseSaddle
from cardan.errors import CardanError
from cardan.runtime.sparse.block_solver import BlockSolver, solver
from cardan.runtime.sparse.plan import Plan
from equations.finite_elements.test_circuits import circuit
from runtime.absolute.structures import STRUCTURES, Structure, bars, line
from table import each

Array = NDArray[np.float64]


def parts(structure: Structure, mixed: bool = False) -> tuple[SparseSaddle, Array, Array]:
    """The solver, K and G; rows of different elements mixed, where wanted."""
    made = structure.plan()
    a = structure.matrix(made)
    matrix = made.pattern
    speeds = np.repeat(~matrix.multiplier, matrix.sizes)
    held = np.flatnonzero(matrix.multiplier)
    elements = np.repeat(held, matrix.sizes[held])
    order = (
        np.random.default_rng(1).permutation(len(elements)) if mixed else np.arange(len(elements))
    )
    places = matrix.first[: np.count_nonzero(~matrix.multiplier) + 1]
    by = SparseSaddle(places, matrix.massless[: len(places) - 1], elements[order])
    return by, a[np.ix_(speeds, speeds)], a[np.ix_(~speeds, speeds)][order]


@each("name", STRUCTURES)
def test_solutions_are_those_of_dense_systems(name: str) -> None:
    by, K, G = parts(STRUCTURES[name], mixed=True)
    rng = np.random.default_rng(2)
    a, b = rng.standard_normal(len(K)), rng.standard_normal(len(G))
    whole, right = np.block([[K, G.T], [G, np.zeros((len(G),) * 2)]]), np.concatenate([a, b])
    exact, found = np.linalg.solve(whole, right), by(csr_array(K), csr_array(G))(right)
    assert np.abs(found - exact).max() <= 1e-12 * np.linalg.cond(whole) * np.abs(exact).max()


def test_plans_are_kept_and_made_anew() -> None:
    by, K, G = parts(STRUCTURES["frame with joints"])
    right = np.cos(np.arange(float(len(K) + len(G))))
    first = by(csr_array(K), csr_array(G))(right)
    kept = dict(by._planned)
    by(csr_array(2 * K), csr_array(G))
    assert by._planned == kept
    # one row more, that holds a speed, and an internal state
    more = np.zeros(len(K) + 1)
    more[3] = 1.0
    wider = block_array([[csr_array(K), None], [None, csr_array([[2.0]])]])
    rows = csr_array(np.concatenate([np.pad(G, ((0, 0), (0, 1))), more[None]]))
    side = np.concatenate([right[: len(K)], [1.0], right[len(K) :], [0.0]])
    found = by(wider, rows)(side)
    assert by._planned.keys() != kept.keys()
    assert found[3] == pytest.approx(0.0, abs=1e-12 * np.abs(found).max())
    assert found[len(K)] == 0.5
    again = by(csr_array(K), csr_array(G))(np.stack([right, 2 * right], 1))
    assert np.abs(again - np.stack([first, 2 * first], 1)).max() <= 1e-12 * np.abs(first).max()


def test_redundant_rows_are_no_matter() -> None:
    by, K, G = parts(Structure(12, [], bars(12), again=4))
    wanted = np.random.default_rng(3).standard_normal(len(K))
    right = np.concatenate([K @ wanted, G @ wanted])
    x, y = np.split(by(csr_array(K), csr_array(G))(right), [len(K)])
    assert np.abs(x - wanted).max() <= 1e-10 * np.abs(wanted).max()
    assert np.abs(y).max() <= 1e-5
    free = Dense().solve(K, G, K @ wanted, G @ wanted)[0]
    assert np.abs(x - free).max() <= 1e-10 * np.abs(wanted).max()


def test_what_nothing_holds_is_told() -> None:
    """A row of bodies on joints without springs: it falls along what G allows."""
    by, K, G = parts(Structure(4, [], bars(4), mass=0))
    a, b = np.random.default_rng(4).standard_normal(len(K)), np.zeros(len(G))
    solve = by(csr_array(K), csr_array(G))
    with pytest.raises(Singular) as told:
        solve(np.concatenate([a, b]))
    assert told.value.motion is not None
    assert np.abs(G @ told.value.motion).max() <= 1e-6
    assert np.linalg.norm(told.value.motion) == pytest.approx(1.0)


def test_contradictions_move_nothing() -> None:
    by, K, G = parts(Structure(3, [], bars(3), again=1))
    right = np.zeros(len(K) + len(G))
    right[-6:] = 1.0
    solve = by(csr_array(K), csr_array(G))
    with pytest.raises(Singular) as told:
        solve(right)
    assert told.value.motion is None


def test_an_unknown_in_no_equation_is_refused() -> None:
    by = SparseSaddle(np.array([0, 6, 12]), np.zeros(2, bool), np.zeros(0, int))
    K = csr_array(diags_array(np.r_[np.ones(6), np.zeros(6)]))
    with pytest.raises(Singular):
        by(K, csr_array((0, 12)))


def problem() -> tuple[SparseSaddle, Array, Array, Array, Array]:
    """A frame with joints: K, M, G, and its eigenvalues among the motions that G allows."""
    by, K, G = parts(Structure(12, line(12), [(0, -1, 1), (4, 9, 2)], mass=0))
    rng = np.random.default_rng(5)
    M = np.diag(rng.uniform(1, 2, len(K)))
    free = null_space(G)
    return by, K, M, G, eigh(free.T @ K @ free, free.T @ M @ free, eigvals_only=True)


def test_modes() -> None:
    by, K, M, G, wanted = problem()
    for shift in (-0.1, 1.5):
        values, shapes = near(csr_array(K), csr_array(M), csr_array(G), shift, 6, by)
        nearest = wanted[np.argsort(np.abs(wanted - shift))][:6]
        assert np.sort(values) == pytest.approx(np.sort(nearest), rel=1e-9)
        assert np.abs(G @ shapes).max() <= 1e-8


def test_damped_modes_without_damping() -> None:
    by, K, M, G, wanted = problem()
    none = csr_array(np.zeros_like(K))
    values, _ = near_quadratic(csr_array(K), none, csr_array(M), csr_array(G), -0.05, 6, by)
    lowest = np.unique(np.round(np.abs(values.imag), 6))[:2]
    assert lowest == pytest.approx(np.sqrt(wanted[:2]), rel=1e-4)


def test_lowest_directions_are_those_of_dense_systems() -> None:
    by, K, _, G, _ = problem()
    found = Sparse(by).lowest(csr_array(K), csr_array(G))
    wanted = Dense().lowest(K, G)
    assert found.values[:4] == pytest.approx(wanted.values[:4], rel=1e-7)
    assert found.negative == wanted.negative == 0


REDUNDANT = {"four_bar": 3, "bricard": 1, "stewart": 0, "geared": 3}


@pytest.mark.parametrize("name", REDUNDANT)
def test_mechanisms(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Accelerations of closed mechanisms of bodies as nodes; so many rows are redundant."""
    used: list[BlockSolver] = []

    def seen(made: Plan) -> BlockSolver:
        used.append(solver(made))
        return used[-1]

    monkeypatch.setattr(sparse_saddle_point, "solver", seen)
    reference = circuit(name).reference
    M, bias, G, gamma = reference.assembled()
    elements, count = np.zeros(len(G), int), 0
    for group in reference.scene.groups:
        for rows in reference.rows(group):
            elements[rows] = count
            count += 1
    starts = np.asarray(reference.scene.places.u)
    by = SparseSaddle(starts, np.diff(starts) != 6, elements)
    found = by(csr_array(M), csr_array(G))(np.concatenate([-bias, gamma]))
    udot, lam, condition = reference.solved()
    assert np.abs(found[: len(M)] - udot).max() <= 1e2 * condition * np.abs(udot).max()
    assert np.abs(found[len(M) :]).max() <= 2 * np.abs(lam).max()
    assert bool(len(used[0].weak)) == bool(REDUNDANT[name])
    by.counted(csr_array(M), csr_array(G), symmetric=True)
    assert used[-1].inertia()[2] == REDUNDANT[name]


def test_what_has_no_solution_is_an_error_of_the_program() -> None:
    assert issubclass(Singular, CardanError)
