"""Options and limits of reading files."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from ...errors import ModelError
from ...records import dataclass

if TYPE_CHECKING:
    from ...superelements.record import SuperelementRecord
    from ..scene import SceneRecord

MOST_FILES = 1000


@dataclass
class Budget:
    """Limits on one :func:`cardan.load`, all included files together."""

    files: int = 0

    def take(self) -> None:
        """Count one more file.

        Raises:
            ModelError: there are too many.
        """
        self.files += 1
        if self.files > MOST_FILES:
            raise ModelError(f"more than {MOST_FILES} files are included; make the scene smaller")


@dataclass(frozen=True)
class Options:
    """Options for reading a file; see :func:`cardan.load`.

    Attributes:
        parents: The scenes that include the present file, the outermost first.
        budget: What may still be read.
        load: Reads an included file; None where none can be included.
        mesh_reduction: Gives the function that reduces meshes of solids, which is of a room above;
            None where they cannot be reduced.
    """

    base: str = "fixed"
    mimic: str = "couple"
    snap: bool = True
    packages: tuple[Path, ...] = ()
    parents: tuple[Path, ...] = ()
    budget: Budget = field(default_factory=Budget)
    load: Callable[[Path, Options], SceneRecord] | None = None
    mesh_reduction: Callable[[], Callable[..., SuperelementRecord]] | None = None

    def __post_init__(self) -> None:
        if self.base not in ("fixed", "free"):
            raise ModelError(f"base must be 'fixed' or 'free', not {self.base!r}")
        if self.mimic not in ("couple", "free"):
            raise ModelError(f"mimic must be 'couple' or 'free', not {self.mimic!r}")
