"""What integrators say of themselves stands in the docs as it is."""

from __future__ import annotations

from pathlib import Path

from cardan.schema.integrators import INTEGRATORS, Integrator
from table import each

PAGE = Path(__file__).parents[2] / "docs" / "integrators.md"


def table() -> str:
    """All records, for people."""
    lines = ["| method | order | inside | step | it is the one for |", "|---|---|---|---|---|"]
    for name, m in INTEGRATORS.items():
        step = "adaptive" if m.adaptive else "fixed"
        lines.append(f'| `"{name}"` | {m.order} | {m.dense_order} | {step} | {m.applies} |')
    return "\n".join(lines)


def test_the_page_has_the_table() -> None:
    assert table() in PAGE.read_text("utf-8"), f"docs/integrators.md needs\n{table()}"


@each("method", INTEGRATORS.values())
def test_a_record_is_told_in_a_line(method: Integrator) -> None:
    assert INTEGRATORS[method.name] is method
    assert 10 < len(method.applies) <= 90
    assert "|" not in method.applies
    assert any(c.isdigit() for c in method.source)
