"""The section of docs/hard_cases.md on paths, measured."""

from __future__ import annotations

from collections.abc import Iterator

from hard.gradient_page import TITLE as FOLLOWING
from hard.page_section import with_section
from hard.paths import CASES, PathCase, measure

PATHS = "paths"
TITLE = "Paths of equilibria and cycles"
HEAD = """
`model.continuation` follows each of them, where beams stand with meshes as they are given. Points
and linear systems are those of all branches; the time includes derivation and compilation where
they are needed.

| case | what is hard | measured by | expected | found | points | linear systems | s |
|---|---|---|---|---|---:|---:|---:|"""


def row(case: PathCase) -> str:
    """The row of a case up to what is expected."""
    return f"| {case.name} | {case.hard} | {case.oracle} | ≤ {case.bound:.0e} |"


def rows() -> Iterator[str]:
    """Rows of all cases, measured now."""
    for case in CASES.values():
        found = measure(case)
        missed = "" if found.error <= case.bound else " ✗"
        yield (
            f"{row(case)} {found.error:.1e}{missed} "
            f"| {found.points} | {found.systems} | {found.seconds:.2g} |"
        )


def with_paths(page: str) -> str:
    """The page with the section on paths anew, behind the one on structures that buckle."""
    return with_section(page, TITLE, "\n".join([HEAD, *rows()]), FOLLOWING)
