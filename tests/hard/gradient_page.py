"""The section of docs/hard_cases.md on gradients, measured."""

from __future__ import annotations

from collections.abc import Iterator

from hard.gradients import CASES, GradientCase, measure
from hard.page_section import with_section

GRADIENTS = "gradients"
TITLE = "Gradients of motions"
HEAD = """
`model.gradient` with DOP853 at rtol 1e-13. The time includes the motion, and no compilation.

| case | what is hard | measured by | expected | found | steps | events | ms |
|---|---|---|---|---|---:|---:|---:|"""


def row(case: GradientCase) -> str:
    """The row of a case up to what is expected."""
    return f"| {case.name} | {case.hard} | {case.oracle} | ≤ {case.bound:.0e} |"


def rows() -> Iterator[str]:
    """Rows of all cases, measured now."""
    for case in CASES.values():
        found = measure(case)
        missed = "" if found.error <= case.bound else " ✗"
        yield (
            f"{row(case)} {found.error:.1e}{missed} "
            f"| {found.steps} | {found.events} | {found.milliseconds:.2g} |"
        )


def with_gradients(page: str) -> str:
    """The page with the section on gradients anew, behind the one on paths."""
    text = "\n".join([HEAD, *rows()])
    return with_section(page, TITLE, text, "When to use another approach")
