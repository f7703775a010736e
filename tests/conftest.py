"""Prints processor seconds per test file, children among them; ``--accept`` golden text.

``slow.txt`` lists tests that ``make test`` leaves to ``make slow``: of each file those that take
long, except the quickest of them. ``pytest -m 'not external' --measure`` writes it anew; what did
not run keeps its place in it.
"""

from __future__ import annotations

import gc
import os
import signal
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

SLOW = Path(__file__).with_name("slow.txt")
LONG, LONG_EXAMPLE = 0.5, 3.0  # processor seconds of a test that counts as slow
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
    parser.addoption("--measure", action="store_true", help="write slow.txt anew")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    listed = set(SLOW.read_text("utf-8").splitlines())
    for item in items:
        if item.nodeid in listed:
            item.add_marker(pytest.mark.slow)


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
    SECONDS[report.nodeid] += dict(report.user_properties).get("seconds", 0.0)


def slow(seconds: dict[str, float]) -> list[str]:
    """Tests that take long, without the quickest such of each file."""
    long: dict[str, list[tuple[float, str]]] = defaultdict(list)
    for test, spent in seconds.items():
        if spent > (LONG_EXAMPLE if test.startswith("tests/examples/") else LONG):
            long[test.split("::")[0]].append((spent, test))
    return sorted(test for tests in long.values() for _, test in sorted(tests)[1:])


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    files: dict[str, float] = defaultdict(float)
    for test, seconds in SECONDS.items():
        files[test.split("::")[0]] += seconds
    terminalreporter.section("processor seconds per file")
    for name, seconds in sorted(files.items(), key=lambda item: -item[1]):
        if seconds >= 0.1:
            terminalreporter.write_line(f"{seconds:8.1f}  {name}")
    terminalreporter.write_line(f"{sum(files.values()):8.1f}  all {len(files)} files")
    if terminalreporter.config.getoption("--measure"):
        others = {test for test in SLOW.read_text("utf-8").splitlines() if test not in SECONDS}
        SLOW.write_text("".join(f"{x}\n" for x in sorted({*slow(SECONDS), *others})), "utf-8")
