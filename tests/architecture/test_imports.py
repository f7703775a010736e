"""Rooms in their order, no cycles, SymPy only where it is asked for."""

from __future__ import annotations

from functools import cache
from graphlib import TopologicalSorter

from architecture.counts import upward
from architecture.sources import Import, imports, modules, room
from architecture.table import ORDER, PEERS_MAY_IMPORT, RUNNING, RUNNING_MAY_IMPORT, SYMPY_AT_IMPORT


@cache
def ours() -> list[Import]:
    """Imports of the package's own modules."""
    return [x for x in imports() if room(x.target) and x.target.startswith("cardan")]


def test_every_room_is_in_the_table() -> None:
    assert {room(name) for name in modules()} <= set(ORDER)


def test_no_import_points_upward() -> None:
    assert not upward()


def test_what_runs_a_shipped_model_knows_no_compiler() -> None:
    wrong = [
        str(found)
        for found in ours()
        if room(found.source) in RUNNING and room(found.target) not in RUNNING_MAY_IMPORT
    ]
    assert not wrong, "\n".join(wrong)


def test_other_programs_are_measured_through_the_api() -> None:
    wrong = [
        str(found)
        for found in ours()
        if room(found.source) == "peers" and room(found.target) not in PEERS_MAY_IMPORT
    ]
    assert not wrong, "\n".join(wrong)


def test_no_cycles() -> None:
    graph: dict[str, set[str]] = {name: set() for name in modules()}
    for found in ours():
        if not found.function and found.target != found.source:
            graph[found.source].add(found.target)
    # a cycle raises, naming its members
    order = list(TopologicalSorter(graph).static_order())
    assert set(order) == set(modules())


def test_sympy_is_loaded_by_the_listed_files_only() -> None:
    loading = {
        found.source
        for found in imports()
        if not found.function and found.target.split(".")[0] == "sympy"
    }
    assert loading == set(SYMPY_AT_IMPORT)


def test_nothing_imports_a_sympy_file_on_its_own_import() -> None:
    eager = [
        str(found)
        for found in ours()
        if not found.function
        and found.target in SYMPY_AT_IMPORT
        and found.source not in SYMPY_AT_IMPORT
    ]
    assert not eager, "\n".join(eager)
