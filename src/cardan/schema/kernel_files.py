"""The C files of ``kernels/``: where each of them is, under its name alone.

Names are unique over all folders, so that an exported model has them side by side.
"""

from __future__ import annotations

from fnmatch import fnmatch
from functools import cache
from pathlib import Path

KERNELS = Path(__file__).resolve().parent.parent / "kernels"


@cache
def _paths(root: Path) -> dict[str, Path]:
    """The path of every C source and header by its name, in the order of the names."""
    paths = [path for ending in ("*.c", "*.h") for path in root.rglob(ending)]
    return {path.name: path for path in sorted(paths, key=lambda path: path.name)}


def files(pattern: str = "*") -> list[Path]:
    """Sources and headers whose name matches a pattern such as ``"alpha*.c"``, ordered by name."""
    return [path for name, path in _paths(KERNELS).items() if fnmatch(name, pattern)]


def file(name: str) -> Path:
    """The path of a source or header.

    Raises:
        KeyError: there is no file of that name.
    """
    return _paths(KERNELS)[name]


def text(name: str) -> str:
    """The content of a source or header. Raises KeyError as :func:`file` does."""
    return file(name).read_text("utf-8")


def includes() -> list[Path]:
    """The folders in which a compiler looks for the headers."""
    return sorted({path.parent for path in _paths(KERNELS).values()})
