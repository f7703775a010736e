"""One test for a whole table: quicker than a test per row, and all rows that fail are named."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Sequence
from functools import wraps
from typing import Any

import pytest

Test = Callable[..., None]


def each(
    names: str | Sequence[str], rows: Iterable[Any], make: Callable[[Any], Any] | None = None
) -> Callable[[Test], Test]:
    """Run a test for every row, as ``pytest.mark.parametrize`` would, but as a single test.

    For tests without fixtures that a row must have for itself, such as ``tmp_path``.

    Args:
        names: Of arguments, in a tuple or between commas.
        rows: One value each, or as many as there are names.
        make: Turns the value of a row into the argument; made when its turn comes.
    """
    split = [x.strip() for x in names.split(",")] if isinstance(names, str) else list(names)
    table = list(rows)
    if any(hasattr(row, "marks") for row in table):
        raise TypeError("rows with marks of their own need pytest.mark.parametrize")

    def decorate(test: Test) -> Test:
        signature = inspect.signature(test)

        @wraps(test)
        def every(**fixtures: Any) -> None:
            failures: list[BaseException] = []
            skipped = 0
            for row in table:
                values = row if len(split) > 1 else (make(row) if make else row,)
                try:
                    test(**fixtures, **dict(zip(split, values, strict=True)))
                except pytest.skip.Exception:
                    skipped += 1
                except (Exception, pytest.fail.Exception, BaseExceptionGroup) as failure:
                    failure.add_note(f"row: {', '.join(split)} = {row!r}")
                    failures.append(failure)
            if failures:
                raise BaseExceptionGroup(f"{len(failures)} of {len(table)} rows", failures)
            if skipped == len(table):
                pytest.skip(f"all {skipped} rows are skipped")

        left = [p for name, p in signature.parameters.items() if name not in split]
        every.__signature__ = signature.replace(parameters=left)  # type: ignore[attr-defined]
        return every

    return decorate
