"""No call can crash or leak an error from below: cardan's errors, or Python's for the signature."""

from __future__ import annotations

import pytest

from laws.absurd import Count, absurd, judged
from laws.subjects import GROUPS, calls

# one of so many calls of each group in the default run, and how many these are at least
EVERY = 197
SPREAD = {"functions": 50, "scene": 15, "elements": 30, "equations": 7}
WHOLE = {"functions": 11_000, "scene": 4_600, "elements": 7_800, "equations": 2_100, "arm": 28_000,
         "four_bar": 27_000, "cantilever": 25_000, "arm records": 4_300, "four_bar records": 4_000,
         "cantilever records": 3_800}  # fmt: skip


def _all(group: str, every: int) -> Count:
    total, leaks = Count(), []
    for k, (name, function, given) in enumerate(calls(group)):
        count, found = judged(name, function, given, every, 31 * k)
        leaks += found
        for key in ("answered", "refused", "late"):
            setattr(total, key, getattr(total, key) + getattr(count, key))
    print(f"{group}: {total.calls} calls, {total.refused} refused, {total.answered} answered, "
          f"{total.late} went on for long; {len(leaks)} leaks")  # fmt: skip
    assert not leaks, "\n".join(map(str, leaks))
    return total


@pytest.mark.parametrize("group", SPREAD)
def test_a_spread_of_absurd_calls(group: str) -> None:
    """One of 197 calls of every function, in workers with limits of time and memory."""
    assert _all(group, EVERY).calls >= SPREAD[group]


@pytest.mark.slow
@pytest.mark.parametrize("group", GROUPS)
def test_all_absurd_calls(group: str) -> None:
    """About 57 absurd arguments in the place of every argument of every public function."""
    assert len(absurd()) >= 50
    assert _all(group, 1).calls >= WHOLE[group]
