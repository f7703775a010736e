"""Equations explained: one document of sections, formulas, tables, figures, written in three ways.

A page says of what bodies and joints a system is made, what its coordinates and parameters are, how
its equations read and where every term comes from, what stays constant, and what functions cost.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from ..arguments import checked
from ..equations.reading.book_symbols import DEFAULT, book_notation
from ..errors import DerivationError
from ..view.page import publish
from .content import Document
from .facts import facts

if TYPE_CHECKING:
    from ..equations.finite_elements.record import FiniteElementRecord
    from ..equations.reading.explained import Explained

__all__ = ["Document", "document", "explain", "facts"]


@checked
def explain(
    equations: Explained | FiniteElementRecord,
    path: str | Path,
    progress: Callable[[str], object] | None = None,
    notation: str = DEFAULT,
) -> Path:
    """Write equations as a page.

    Args:
        equations: In whatever coordinates, by whatever method.
        path: Its ending says how: ``.html``, ``.tex`` or ``.md``.
        progress: Told what is under way.
        notation: Whose symbols the page uses: ``"cardan"``, ``"rs"`` (Roberson and Schwertassek),
            ``"gc"`` (Géradin and Cardona) or ``"kane"`` (Kane and Levinson).

    Returns:
        The file.

    Raises:
        DerivationError: another ending, an unknown notation.
    """
    path = Path(path)
    ending_of(path)
    return published(document(equations, progress, notation), path)


def published(page: Document, path: Path) -> Path:
    """The file of a page, written.

    Raises:
        DerivationError: there is no writer for its ending.
    """
    ending = ending_of(path)
    from .writers import WRITERS

    for suffix, text in WRITERS[ending].write(page, path).items():
        publish(path if suffix == ending else path.with_suffix(suffix), text)
    return path


def ending_of(path: Path) -> str:
    """The ending of a page.

    Raises:
        DerivationError: there is no writer for it.
    """
    from .writers import WRITERS

    ending = path.suffix.lower()
    if ending not in WRITERS:
        raise DerivationError(f"'{path.name}': pages end in {', '.join(WRITERS)}")
    return ending


def document(
    equations: Explained | FiniteElementRecord,
    progress: Callable[[str], object] | None = None,
    notation: str = DEFAULT,
) -> Document:
    """Contents of a page, before it is written."""
    from . import sheets

    return sheets.document(equations, progress or (lambda _: None), book_notation(notation))
