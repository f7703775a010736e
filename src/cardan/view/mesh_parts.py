"""Meshes of the solids of a picture: every file is read once, and reduced as far as is wanted."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

import numpy as np

from ..errors import ModelError, ModelWarning, counted, warn
from . import meshes
from .solids import Solid

# triangles of a picture unless a user asks for more or fewer
AUTO_TRIANGLES = 200_000
FEWEST = 12  # triangles that are left of a part


class MeshParts:
    """Triangles by file.

    Args:
        solids: What is drawn; some of it may be meshes.
        detail: ``"auto"`` reduces all to :data:`AUTO_TRIANGLES`, ``"full"`` keeps them, a number
            up to 1 that share of them; False reads none.
    """

    def __init__(self, solids: Sequence[Solid], detail: str | float) -> None:
        self._problems: dict[str, str] = {}
        files = dict.fromkeys(str(s["file"]) for s in solids if s["kind"] == "mesh")
        self._parts: dict[str, list[meshes.Part]] = {}
        for file in files if detail is not False else ():
            try:
                self._parts[file] = meshes.read(Path(file))
            except ModelError as problem:
                self._problems[file] = str(problem)
        total = sum(len(part.triangles) for each in self._parts.values() for part in each)
        share = 1.0 if detail == "full" else AUTO_TRIANGLES / max(total, 1)
        self._share = min(1.0, float(detail) if isinstance(detail, float) else share)
        self.of = cache(self._of)

    def _of(self, file: str) -> tuple[meshes.Part, ...]:
        """The parts of a file, a color each; none where it cannot be read."""
        return tuple(
            part if self._share >= 1 else meshes.reduced(part, self._most(len(part.triangles)))
            for part in self._parts.get(file, ())
        )

    def _most(self, triangles: int) -> int:
        return max(FEWEST, int(np.ceil(self._share * triangles)))

    def complain(self) -> None:
        """Warn of meshes that are not shown."""
        if self._problems:
            first = next(iter(self._problems.values()))
            n = len(self._problems)
            warn(f"{counted(n, 'mesh', 'meshes')} cannot be drawn: {first}", ModelWarning)
