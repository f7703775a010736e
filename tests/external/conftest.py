"""Prints how many numbers were compared with other programs."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

FOUND: dict[str, int] = {}
COUNTS = Path(__file__).parent / "comparisons.json"


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    properties = dict(report.user_properties)
    if report.when == "call" and "comparisons" in properties:
        FOUND[str(properties["case"])] = int(str(properties["comparisons"]))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    if FOUND:
        committed = sum(json.loads(COUNTS.read_text(encoding="utf-8")).values())
        terminalreporter.write_line(
            f"{sum(FOUND.values())} comparisons with Pinocchio in {len(FOUND)} cases; "
            f"{committed} when all are run (marker external)"
        )
