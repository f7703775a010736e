"""Lists of values that are made when they are first asked for, in whatever order."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Generic, TypeVar

T = TypeVar("T")


class Memo(Generic[T]):
    """A list of fixed length whose entries are computed once, on demand.

    Args:
        count: Its length.
        make: Entry by its index; it may ask for other entries.
    """

    def __init__(self, count: int, make: Callable[[int], T]) -> None:
        self._count = count
        self._make = make
        self._values: dict[int, T] = {}

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, i: int) -> T:
        if i not in self._values:
            self._values[i] = self._make(i)
        return self._values[i]

    def __iter__(self) -> Iterator[T]:
        return (self[i] for i in range(self._count))
