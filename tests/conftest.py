"""Prints processor seconds per test file, children among them; ``--accept`` golden text."""

from __future__ import annotations

import gc
import os
import signal
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

SECONDS: dict[str, float] = defaultdict(float)
# of this process and those that ended, when the last report was made
SPENT = [0.0]

# clang takes five seconds to make its libraries; caches of single tests would make them again
os.environ.setdefault("ZIG_GLOBAL_CACHE_DIR", str(Path.home() / ".cache" / "zig"))

# a job in the background ignores Ctrl-C, and so would all programs that the tests interrupt
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--accept",
        action="store_true",
        help="write generated/ and counts.json anew instead of comparing with them",
    )


@pytest.fixture(scope="module", autouse=True)
def optimized(request: pytest.FixtureRequest) -> Iterator[None]:
    """Models are compiled as users have them in modules with this marker."""
    with pytest.MonkeyPatch.context() as patch:
        if request.node.get_closest_marker("optimized"):
            patch.delenv("CARDAN_OPTIMIZATION", raising=False)
        yield


def pytest_collection_finish() -> None:
    # thousands of tests, expressions and syntax trees live long: Python need not look at them
    # again and again in search of garbage
    gc.freeze()
    gc.set_threshold(10_000, 20, 20)


def pytest_runtest_logstart() -> None:
    SPENT[0] = sum(os.times()[:4])


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport() -> Iterator[None]:
    outcome = yield
    before, SPENT[0] = SPENT[0], sum(os.times()[:4])
    outcome.get_result().user_properties.append(("seconds", SPENT[0] - before))


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    SECONDS[report.nodeid.split("::")[0]] += dict(report.user_properties).get("seconds", 0.0)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    terminalreporter.section("processor seconds per file")
    for name, seconds in sorted(SECONDS.items(), key=lambda item: -item[1]):
        if seconds >= 0.1:
            terminalreporter.write_line(f"{seconds:8.1f}  {name}")
    terminalreporter.write_line(f"{sum(SECONDS.values()):8.1f}  all {len(SECONDS)} files")
