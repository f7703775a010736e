"""The import table, no cycles, SymPy only where it is asked for."""

from __future__ import annotations

from functools import cache
from graphlib import TopologicalSorter

from architecture.sources import Import, imports, modules, reached, room
from architecture.table import DOWNWARD, ORDER, RUNNING, RUNNING_MAY_IMPORT, SYMPY_AT_IMPORT
from table import each


@cache
def ours() -> list[Import]:
    """Imports of the package's own modules."""
    return [x for x in imports() if room(x.target) and x.target.startswith("cardan")]


def is_downward(found: Import) -> bool:
    """True where a room reaches a room that stands after it in the table."""
    source, target = room(found.source), room(found.target)
    if source in RUNNING and target not in RUNNING_MAY_IMPORT:
        return True
    return ORDER.index(target) > ORDER.index(source)


def test_every_room_is_in_the_table() -> None:
    assert {room(name) for name in modules()} <= set(ORDER)


def test_imports_point_upwards() -> None:
    wrong = [str(found) for found in ours() if not found.function and is_downward(found)]
    assert not wrong, "\n".join(wrong)


def test_downward_imports_inside_functions_are_the_listed_ones() -> None:
    present: dict[tuple[str, str], set[str]] = {}
    for found in ours():
        free = room(found.source) in ("__init__", "pipeline", "cli")
        if found.function and is_downward(found) and not free:
            present.setdefault((found.source, found.function), set()).add(found.target)
    assert present == {key: set(targets) for key, targets in DOWNWARD.items()}


@each("target", sorted({t for targets in DOWNWARD.values() for t in targets}))
def test_downward_imports_load_no_sympy(target: str) -> None:
    assert "sympy" not in {name.split(".")[0] for name in reached(target)}


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
