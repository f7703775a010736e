"""The kernels as they were compiled when cardan was installed: which there are, of which sources.

They lie beside their sources, in ``kernels/built``: objects named after the hash of all that they
were made of, and ``index.json``, which says which of them is which.
"""

from __future__ import annotations

import hashlib
import json
import platform
import sys
from collections.abc import Iterator, Sequence
from functools import lru_cache
from pathlib import Path

from ...records import dataclass
from ...schema import kernel_files
from .cpu_levels import Level

LEVEL = "level.c"  # chooses among the others, so that it is built for any processor
INDEX = "index.json"
# what works on lanes: shared parameters, or each lane its own
LANE_SOURCES = (("batch.c", "simd_steps.c", "lane_*.c", "layouts.c"), ("batch.c",))
WIDTHS = (2, 4, 8)


@dataclass(frozen=True)
class Variant:
    """One of the libraries that the kernels are compiled into.

    Attributes:
        reproducible: No contraction: every compiler of IEEE arithmetic gives equal bits.
        lanes: States side by side; 1: everything but what works on lanes.
        lane_parameters: Every state has parameters of its own.
    """

    reproducible: bool = False
    lanes: int = 1
    lane_parameters: bool = False

    @property
    def name(self) -> str:
        """Name in ``index.json``: ``"scalar"``, ``"lanes8-own-exact"``."""
        lanes = f"lanes{self.lanes}" if self.lanes > 1 else "scalar"
        return lanes + "-own" * self.lane_parameters + "-exact" * self.reproducible

    @property
    def macros(self) -> tuple[str, ...]:
        """Macros for the compiler."""
        return macros(self.lanes, self.lane_parameters) if self.lanes > 1 else ()

    def sources(self) -> list[Path]:
        """C files."""
        patterns = ("*.c",) if self.lanes == 1 else LANE_SOURCES[self.lane_parameters]
        paths = {path for pattern in patterns for path in kernel_files.files(pattern)}
        return sorted(paths - {kernel_files.file(LEVEL)})


def macros(lanes: int, lane_parameters: bool) -> tuple[str, ...]:
    """Compiler macros for the lanes, and for parameters that each of them has for itself."""
    parameters = ("-DCARDAN_LANE_PARAMETERS",) if lane_parameters else ()
    return (f"-DCARDAN_LANES={lanes}", *parameters)


def variants(widths: Sequence[int] = WIDTHS) -> Iterator[Variant]:
    """All libraries of a level, for some numbers of lanes."""
    for reproducible in (False, True):
        yield Variant(reproducible)
        for lanes in widths:
            yield Variant(reproducible, lanes, False)
            yield Variant(reproducible, lanes, True)


def digest(pattern: str = "*.[ch]") -> str:
    """Hash of kernel sources; of all by default."""
    total = hashlib.sha256()
    for path in kernel_files.files(pattern):
        content = path.read_bytes()
        total.update(f"\0{path.name}\0{len(content)}\0".encode())
        total.update(content)
    return total.hexdigest()


def machine() -> str:
    """System and kind of processor."""
    return f"{sys.platform} {platform.machine()}"


@dataclass(frozen=True)
class Index:
    """Index of the libraries compiled when cardan was installed.

    Attributes:
        sources: Hash of the sources.
        machine: Where they were compiled: system and kind of processor.
        compiler: What their compiler said about itself.
        level: The object that tells the level of a processor.
        level_source: Hash of its source.
        objects: File of a library by level and name.
    """

    sources: str
    machine: str
    compiler: str
    level: str
    level_source: str
    objects: dict[str, dict[str, str]]

    @classmethod
    def of(cls, compiler: str, level: str, objects: dict[str, dict[str, str]]) -> Index:
        """Index of libraries compiled here from the sources as they are."""
        return cls(digest(), machine(), compiler, level, digest(LEVEL), objects)

    def text(self) -> bytes:
        """Content of ``index.json``."""
        return (json.dumps(vars(self), indent=1) + "\n").encode()


def folder() -> Path:
    """Folder of the objects."""
    return kernel_files.KERNELS / "built"


def _index() -> Index | None:
    """Index of libraries for machines like this one, from whatever sources."""
    try:
        index = Index(**json.loads((folder() / INDEX).read_text("utf-8")))
    except (OSError, ValueError, TypeError):
        return None
    # a folder may have come from another machine
    return index if index.machine == machine() else None


@lru_cache(maxsize=1)
def current() -> Index | None:
    """Index of libraries from these very sources; None without any."""
    index = _index()
    return index if index and index.sources == digest() else None


def reread() -> None:
    """Look again at what is installed."""
    current.cache_clear()
    level_object.cache_clear()


def library(level: Level, variant: Variant) -> Path | None:
    """The object of a variant, if it was compiled for this level."""
    index = current()
    return _there(index.objects.get(level.name, {}).get(variant.name)) if index else None


@lru_cache(maxsize=1)
def level_object() -> Path | None:
    """The object that tells the level of this processor, if it was compiled of this source.

    Every run asks for it, also in processes that use no other kernel: these are not read.
    """
    index = _index()
    return _there(index.level) if index and index.level_source == digest(LEVEL) else None


def _there(name: str | None) -> Path | None:
    """An object of the index; None if it is gone, as copies of a folder may lack it."""
    return folder() / name if name and (folder() / name).is_file() else None
