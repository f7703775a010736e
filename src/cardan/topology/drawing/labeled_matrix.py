"""Small integer matrices with names on rows and columns."""

from __future__ import annotations

from typing import Any

from ...notebooks import html
from ...records import dataclass


@dataclass(frozen=True)
class Labelled:
    """A matrix whose rows and columns have names.

    Attributes:
        rows, columns: Their names.
        entries: The numbers, row by row, (rows, columns).
        about: What it is.
    """

    rows: tuple[str, ...]
    columns: tuple[str, ...]
    entries: tuple[tuple[int, ...], ...]
    about: str = ""

    @property
    def shape(self) -> tuple[int, int]:
        return len(self.rows), len(self.columns)

    def __getitem__(self, key: tuple[str, str]) -> int:
        """The entry of a named row and column."""
        row, column = key
        return self.entries[self.rows.index(row)][self.columns.index(column)]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        import numpy as np

        return np.array(self.entries, dtype=dtype or int).reshape(self.shape)

    _repr_html_ = html

    def __str__(self) -> str:
        head = max((len(name) for name in self.rows), default=0)
        widths = [max(len(name), 2) for name in self.columns]
        lines = [self.about] if self.about else []
        titles = zip(self.columns, widths, strict=True)
        lines.append(" " * head + "".join("  " + name.rjust(w) for name, w in titles))
        for name, row in zip(self.rows, self.entries, strict=True):
            cells = ("." if x == 0 else f"{x:+d}" for x in row)
            lines.append(
                name.ljust(head)
                + "".join("  " + cell.rjust(w) for cell, w in zip(cells, widths, strict=True))
            )
        return "\n".join(lines)
