"""Prints the seconds every test file took, all its processes together; ``--accept`` golden text."""

from __future__ import annotations

import signal
from collections import defaultdict

import pytest

SECONDS: dict[str, float] = defaultdict(float)

# a job in the background ignores Ctrl-C, and so would all programs that the tests interrupt
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--accept",
        action="store_true",
        help="write generated/ and counts.json anew instead of comparing with them",
    )


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    SECONDS[report.nodeid.split("::")[0]] += report.duration


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    terminalreporter.section("seconds per file")
    for name, seconds in sorted(SECONDS.items(), key=lambda item: -item[1]):
        if seconds >= 0.1:
            terminalreporter.write_line(f"{seconds:8.1f}  {name}")
    terminalreporter.write_line(f"{sum(SECONDS.values()):8.1f}  all {len(SECONDS)} files")
