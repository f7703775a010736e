"""What the page of starts says of imports, and of figures that were missed."""

from __future__ import annotations

import re
from pathlib import Path

from benchmarks.starts import Start, Times, cause, figures, notes


def test_every_import_is_accounted_for_with_its_package(tmp_path: Path) -> None:
    start = Start("one", ("-c", "import numpy\nsum(k * k for k in range(3_000_000))"))
    said = cause(start, tmp_path, "none")
    seconds = {name: float(part) for name, part in re.findall(r"(\S+) (\d\.\d\d) s", said)}
    assert seconds["numpy"] > 0.01
    assert seconds["import"] > 0.05, "what is no import"


def test_a_module_that_runs_is_accounted_for_too(tmp_path: Path) -> None:
    said = cause(Start("module", ("-m", "cardan", "--version")), tmp_path, "none")
    assert "importing cardan" in said


def test_missed_figures_are_told_with_their_cause() -> None:
    rows = [Start("quick", (), 0.25), Start("slow", (), 0.25), Start("import numpy", ())]
    times = [Times(1.0, 0.2, 0.3), Times(1.0, 0.26, 0.3), Times(float("nan"), 0.1, 0.1)]
    (said,) = notes(rows, times, {"slow": "importing sympy 0.2 s"})
    assert said.startswith("- Missed: slow, 0.26 s where 0.25 s were to reach")
    assert "importing sympy" in said
    assert [row[-1] for row in figures(rows, times)] == ["yes", "no"]
    assert notes(rows[:1], times[:1], {}) == ["Every figure to reach is reached."]
