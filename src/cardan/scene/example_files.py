"""Files of the example scenes that come with cardan."""

from __future__ import annotations

from functools import cache
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "scenes"


@cache
def example_files() -> dict[str, Path]:
    """Name -> file, in the order of the alphabet."""
    return {path.stem: path for path in sorted(FOLDER.iterdir()) if path.is_file()}
