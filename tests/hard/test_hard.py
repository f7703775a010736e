"""Every method on every hard case: the status and the error that its table allows.

By default every method and every case some times; ``make slow`` runs the other cells.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from typing import Any

import pytest

from hard import CASES
from hard.case import METHODS, Case, Cell, Never, measure
from hard.gradient_page import row as gradient_row
from hard.gradients import CASES as GRADIENTS
from hard.gradients import measure as measure_gradient
from hard.page import PAGE, expectation
from hard.path_page import row
from hard.paths import CASES as PATHS
from hard.paths import measure as measure_path
from spread import some

ASKED = pytest.mark.skipif("CARDAN_HARD" not in os.environ, reason="asked for by CARDAN_HARD=1")


def cells(slow: bool) -> Iterator[Any]:
    """Cells that are measured; the slow ones of a case only where they are asked for."""
    for case in CASES.values():
        for method, cell in case.expected.items():
            if isinstance(cell, Cell) and slow == (method in case.slow):
                marks = [pytest.mark.slow, ASKED] if slow else []
                yield pytest.param(case, method, marks=marks, id=f"{case.name}-{method}")


def spread() -> Iterator[Any]:
    """One cell in five of quick cases, and the first one of those that none of these is of."""
    usual = list(cells(slow=False))
    every = some((cell for cell in usual if cell.values[0].quick), 5, 1)
    there = {cell.values[0].name for cell in every if not cell.marks}
    for cell in every:
        name = cell.values[0].name
        yield cell if name in there else pytest.param(*cell.values, id=cell.id)
        there.add(name)
    for cell in usual:
        if not cell.values[0].quick:
            yield pytest.param(*cell.values, marks=pytest.mark.slow, id=cell.id)


QUICK = list(spread())


def test_a_spread_has_every_method_and_every_case() -> None:
    by_default = [cell.values for cell in QUICK if not cell.marks]
    assert {method for _, method in by_default} == {cell.values[1] for cell in QUICK}
    quick = {case.name for case, _ in (cell.values for cell in QUICK) if case.quick}
    assert {case.name for case, _ in by_default} == quick


@pytest.mark.parametrize(("case", "method"), [*QUICK, *cells(slow=True)])
def test_cell(case: Case, method: str) -> None:
    cell = case.expected[method]
    assert isinstance(cell, Cell)
    found = measure(case, method)
    print(f"{found.status}, error {found.error:.1e}, allowed {cell.bound:.0e}: {found.message}")
    assert found.status == cell.status
    assert found.error <= cell.bound


@pytest.mark.parametrize(
    ("name", "method"),
    some(product(["proper", "other"], ["DOP853", "RK4", "EnergyMidpoint", "HHT"]), 3),
)
def test_a_run_in_gimbal_lock_names_the_cure(name: str, method: str) -> None:
    said = measure(CASES[f"gimbal lock, started in it, {name} sequences"], method).message
    assert "ends excluded); rotation='quaternion' has no such limits" in said


GIVEN = ["RK4", "RKMK4", "EnergyMidpoint", "GeneralizedAlpha"]


@pytest.mark.parametrize(("step", "method"), some(product([1e-1, 1e-2, 1e-3], GIVEN), 5))
def test_given_steps_past_a_lock_are_right_or_end(step: float, method: str) -> None:
    given(step, method)


@pytest.mark.slow
@pytest.mark.parametrize("method", GIVEN)
def test_small_steps_past_a_lock_are_right_or_end(method: str) -> None:
    given(1e-4, method)


def given(step: float, method: str) -> None:
    """A run with the step past a lock is right, or says that it ended."""
    case = CASES["gimbal lock, 12 sequences"]
    how = {method: Cell(1e-3, {"step": step})}
    found = measure(replace(case, expected=case.expected | how), method)
    print(f"{found.status}, error {found.error:.1e}: {found.message}")
    assert found.status in ("finished", "singular_rotation")
    # rows up to the end are right either way
    assert found.error <= 1e-3


@pytest.mark.parametrize("case", CASES.values(), ids=str)
def test_every_method_has_a_cell(case: Case) -> None:
    assert set(case.expected) == set(METHODS)
    assert all(cell.reason for cell in case.expected.values() if isinstance(cell, Never))


@pytest.mark.parametrize("case", CASES.values(), ids=str)
def test_the_page_says_the_same(case: Case) -> None:
    section = PAGE.read_text("utf-8").split(f"\n## {case.title}\n")[1].split("\n## ")[0]
    rows = [line for line in section.splitlines() if line.startswith("| ")][1:]
    said = {cells[1].strip(): cells for cells in (row.split("|") for row in rows)}
    assert set(said) == set(METHODS)
    for method, cell in case.expected.items():
        assert said[method][3].strip() == expectation(cell)


@pytest.mark.parametrize("name", some(PATHS, 2))
def test_paths_are_as_exact_as_expected(name: str) -> None:
    case = PATHS[name]
    found = measure_path(case)
    print(f"error {found.error:.1e}, allowed {case.bound:.0e}")
    assert found.error <= case.bound


def test_the_page_lists_every_path() -> None:
    page = PAGE.read_text("utf-8")
    assert all(row(case) in page for case in PATHS.values())


@pytest.mark.parametrize("name", some(GRADIENTS, 2))
def test_gradients_are_as_exact_as_expected(name: str) -> None:
    case = GRADIENTS[name]
    found = measure_gradient(case)
    print(f"error {found.error:.1e}, allowed {case.bound:.0e}")
    assert found.error <= case.bound


def test_the_page_lists_every_gradient() -> None:
    page = PAGE.read_text("utf-8")
    assert all(gradient_row(case) in page for case in GRADIENTS.values())
