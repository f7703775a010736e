"""The benchmark of sparse matrices runs, and what it measures is right."""

from __future__ import annotations

import pytest

from benchmarks import sparse


@pytest.mark.parametrize("name", sparse.STRUCTURES)
def test_rows_are_measured(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sparse, "SECONDS", 1e-3)
    rows = list(sparse.measured([name], 100))
    assert [row.nodes for row in rows] == [n for n in sparse.STRUCTURES[name][1] if n <= 100]
    for row in rows:
        assert row.error < 1e-11
        assert row.superlu_error < 1e-11
        assert min(row.factor, row.solve, row.superlu_factor, row.superlu_solve) > 0
    assert sparse.table(rows).row_count == len(rows)
