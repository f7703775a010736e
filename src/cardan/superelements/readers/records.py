"""Lines of text files with numbers, and tables of them, limited in size."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array, Integers
from ...errors import ModelError, brief
from .matrix_files import MOST_ENTRIES, MOST_ROWS

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

UTF_8 = b"\xef\xbb\xbf"  # that some editors put first


def text_lines(content: bytes, file: str) -> list[str]:
    """Lines of a text; comments may have letters of any alphabet.

    Raises:
        ModelError: it is not one.
    """
    place = content.find(0)
    if place >= 0:
        raise ModelError(f"{file}: byte {place} is 0: it is not a text. Write the matrices as text")
    return content.removeprefix(UTF_8).decode("latin-1").splitlines()


def number(text: str, file: str, line: int) -> float:
    """A finite number, also as Fortran writes it (``1.0D+05``).

    Raises:
        ModelError: it is none.
    """
    word = text.strip().replace("D", "E").replace("d", "e")
    try:
        value = float(word) if "_" not in word else np.nan
    except ValueError:
        # an exponent without its letter: 1.0+5
        value = _short_exponent(word)
    if not np.isfinite(value):
        raise ModelError(f"{file}:{line}: {brief(text.strip())} is not a finite number")
    return value


def _short_exponent(word: str) -> float:
    place = max(word.rfind("+"), word.rfind("-"))
    try:
        return float(f"{word[:place]}E{word[place:]}") if place > 0 else np.nan
    except ValueError:
        return np.nan


def integer(text: str, file: str, line: int) -> int:
    """A whole number that is not negative and fits into memory.

    Raises:
        ModelError: it is none.
    """
    word = text.strip()
    if not (word.isascii() and word.isdecimal() and len(word) < 16):
        raise ModelError(f"{file}:{line}: {brief(word)} is not a whole number from 0")
    return int(word)


def table(lines: Sequence[str], first: int, columns: int, file: str, comma: bool = False) -> Array:
    """Numbers in rows of equal length (rows, columns).

    Args:
        lines: Of the text; empty ones are left out.
        first: Number of the first of them in the file, from 1.
        columns: Numbers in each.
        file: Its name.
        comma: True where commas stand between the numbers.

    Raises:
        ModelError: a line of another kind, too many lines.
    """
    rows = [(k, line) for k, line in enumerate(lines, first) if line.strip()]
    if len(rows) > MOST_ENTRIES:
        raise ModelError(f"{file}: more than {MOST_ENTRIES} entries; split the component")
    if not rows:
        return np.zeros((0, columns))
    try:
        texts, delimiter = [line for _, line in rows], "," if comma else None
        values = np.loadtxt(texts, comments=None, delimiter=delimiter, ndmin=2)
        if values.shape == (len(rows), columns) and np.isfinite(values).all():
            return values
    except ValueError:
        pass
    # slowly, to say which line it is
    result = np.empty((len(rows), columns))
    for k, (line_number, line) in enumerate(rows):
        parts = line.split(",") if comma else line.split()
        if len(parts) != columns:
            raise ModelError(
                f"{file}:{line_number}: {len(parts)} numbers, expected {columns}: "
                f"{brief(line.strip())}"
            )
        result[k] = [number(part, file, line_number) for part in parts]
    return result


def integers(column: Array, file: str, what: str, least: int = 1) -> Integers:
    """A column of numbers as whole ones.

    Raises:
        ModelError: one that is not whole, or not within limits.
    """
    bad = np.flatnonzero((column != np.floor(column)) | (column < least) | (column > 2**53))
    if len(bad):
        raise ModelError(f"{file}: {what} {column[bad[0]]:g} in entry {bad[0] + 1}")
    return column.astype(np.intp)


def assembled(
    rows: Integers,
    columns: Integers,
    values: Array,
    size: int,
    file: str,
    triangle: bool | None = None,
) -> Sparse:
    """A sparse matrix (size, size) of entries whose places count from 0.

    Args:
        rows, columns, values: Of the entries.
        size: Rows of the matrix.
        file: Its name.
        triangle: True where entries off the diagonal stand for two; by default where none of them
            has one on the other side.

    Raises:
        ModelError: a place outside, an entry that is there twice, too many rows.
    """
    from scipy.sparse import coo_matrix

    if not 0 < size <= MOST_ROWS:
        raise ModelError(f"{file}: {size} rows, expected 1 to {MOST_ROWS}")
    if not len(values):
        raise ModelError(f"{file}: it has no entries")
    if rows.min() < 0 or columns.min() < 0 or max(rows.max(), columns.max()) >= size:
        worst = int(max(rows.max(), columns.max())) + 1
        raise ModelError(f"{file}: an entry in row or column {worst}, the matrix has {size}")
    off = rows != columns
    if triangle is None:
        mirrored = columns[off].astype(np.int64) * size + rows[off]
        triangle = not np.isin(rows[off].astype(np.int64) * size + columns[off], mirrored).any()
    if triangle:
        rows, columns, values = (
            np.concatenate([rows, columns[off]]),
            np.concatenate([columns, rows[off]]),
            np.concatenate([values, values[off]]),
        )
    places = np.sort(rows.astype(np.int64) * size + columns)
    twice = np.flatnonzero(np.diff(places) == 0)
    if len(twice):
        row, column = divmod(int(places[twice[0]]), size)
        raise ModelError(
            f"{file}: the entry of row {row + 1} and column {column + 1} is there twice"
            + ("; only one triangle may be there" if triangle else "")
        )
    matrix = coo_matrix((values, (rows, columns)), shape=(size, size)).tocsc()
    matrix.eliminate_zeros()
    return matrix


def numbered_lines(lines: Sequence[str]) -> Iterator[tuple[int, str]]:
    """Lines with their numbers from 1, without empty ones."""
    return ((k, line) for k, line in enumerate(lines, 1) if line.strip())
