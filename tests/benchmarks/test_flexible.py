"""The benchmark of flexible elements runs; operations of the default element do not grow."""

from __future__ import annotations

import pytest

from benchmarks import flexible, flexible_precision

# of a call, all of it: what a change must not make worse unnoticed
MOST = {"balance": 760, "balance_tangent": 2550, "mixed": 2800, "mixed_step": 1010}


def test_rows() -> None:
    rows = list(flexible.measured(["hellinger_reissner"], count=16, rounds=1))
    assert {row.function: row.operations <= MOST[row.function] for row in rows} == dict.fromkeys(
        MOST, True
    )
    assert flexible.table(rows).row_count == 4


@pytest.mark.parametrize("name", ["linked_inertia", "lumped_inertia"])
def test_inertia_is_cheap(name: str) -> None:
    rows = flexible.measured([name], count=16, rounds=1)
    assert all(row.operations < 1000 for row in rows)


def test_radau_pays_at_tight_tolerances() -> None:
    """For less error than generalized-alpha has at any tolerance, fewer steps."""
    case = next(iter(flexible_precision.CASES.items()))
    rows = list(flexible_precision.measured(dict([case])))
    alpha = min((r for r in rows if r.method == "GeneralizedAlpha"), key=lambda r: r.error)
    better = [r for r in rows if r.method == "Radau" and r.error < alpha.error]
    assert min(r.steps for r in better) < alpha.steps / 4
    assert flexible_precision.table(rows).row_count == len(rows)
