"""The order of elimination: a permutation, less fill than minimum degree, the same solution."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import linear_sum_assignment
from scipy.sparse import csr_matrix, diags
from scipy.sparse.linalg import splu

import cardan as cd
from cardan import solids as fem
from cardan.superelements.elimination_order import _cover, nested_dissection
from solids.meshes import block

OPTIONS = {"diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}


def test_a_block_has_less_fill_and_the_same_solution() -> None:
    mesh = block("hex20", (7, 6, 6))
    K = fem.solid(mesh, cd.material(E=1e9, nu=0.3)).stiffness()
    free = np.flatnonzero(np.repeat(mesh.points[:, 0] > 1e-9, 3))
    K, places = K[free][:, free].tocsc(), np.repeat(mesh.points, 3, axis=0)[free]
    order = nested_dissection(K, places)
    assert np.sort(order).tolist() == list(range(len(free)))
    ours = splu(K[order][:, order].tocsc(), permc_spec="NATURAL", **OPTIONS)
    usual = splu(K, permc_spec="MMD_AT_PLUS_A", **OPTIONS)
    assert ours.nnz < 0.9 * usual.nnz
    # it does not depend on how the body is turned
    rotation = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    again = nested_dissection(K, places @ rotation.T)
    assert splu(K[again][:, again].tocsc(), permc_spec="NATURAL", **OPTIONS).nnz < 0.95 * usual.nnz
    f = np.ones(len(free))
    x = np.empty(len(free))
    x[order] = ours.solve(f[order])
    assert x == pytest.approx(usual.solve(f), rel=1e-9)


def test_separators_are_smallest() -> None:
    """As many rows and columns as a largest matching has pairs, and all entries among them."""
    rng = np.random.default_rng(3)
    for _ in range(50):
        shape = rng.integers(1, 9, 2)
        entries = (rng.random(shape) < 0.3).astype(np.int32)
        rows, columns = _cover(csr_matrix(entries))
        assert not entries[~rows][:, ~columns].any()
        pairs = linear_sum_assignment(-entries)
        assert rows.sum() + columns.sum() == entries[pairs].sum()


def test_the_last_rows_part_the_others() -> None:
    """A chain of 1000 on a line: halves are coupled by what is eliminated last alone."""
    n = 1000
    chain = diags([np.ones(n - 1), np.full(n, 2.0), np.ones(n - 1)], [-1, 0, 1]).tocsr()
    places = np.zeros((n, 3))
    places[:, 1] = np.arange(n)
    order = nested_dissection(chain, places)
    last = order[-1]
    assert abs(last - n / 2) <= 1
    factor = splu(chain[order][:, order].tocsc(), permc_spec="NATURAL", **OPTIONS)
    assert factor.nnz < 8 * n


def test_all_rows_in_one_place_and_none_coupled() -> None:
    assert sorted(nested_dissection(csr_matrix(np.ones((50, 50))), np.zeros((50, 3)))) == [
        *range(50)
    ]
    lonely = nested_dissection(
        csr_matrix(np.eye(90)), np.random.default_rng(2).normal(size=(90, 3))
    )
    assert sorted(lonely) == [*range(90)]
