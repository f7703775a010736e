"""Contents of the compile cache, and their removal."""

from __future__ import annotations

import os
import re
import shutil
import stat
import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path

from ...records import dataclass
from . import cache
from .object_file import NEW, intact

DAY = 86400.0
OBJECT = re.compile(r"[0-9a-f]{64}\.so\Z")
MODEL = re.compile(r"[0-9a-f]{32,64}\Z")
OTHER_CONTENT = ("zig", "compilers.json")


@dataclass(frozen=True)
class Content:
    """Things in the cache: how many of each kind, and the bytes of all."""

    objects: int
    models: int
    leftovers: int
    size: int


def content(place: Path) -> Content:
    """Contents of a cache."""
    paths = list(_things(place))
    left = list(place.glob(f"{NEW}*")) if place.is_dir() else []
    return Content(
        objects=sum(path.suffix == ".so" for path in paths),
        models=sum(path.parent != place for path in paths),
        leftovers=len(left),
        size=_size([*paths, *left]),
    )


def prune(place: Path, days: float) -> Content:
    """Remove what dead processes left, damaged objects, and what was not used for some days.

    Args:
        place: The cache.
        days: 0 removes everything.

    Returns:
        What was removed.
    """
    before, limit = content(place), time.time() - days * DAY
    cache.sweep(place)
    for path in _things(place):
        old = days <= 0 or _used(path) < limit
        if old or (path.suffix == ".so" and not intact(path)):
            # what somebody else removes, or holds, is not our business
            with suppress(OSError):
                shutil.rmtree(path) if path.is_dir() else path.unlink()
    after = content(place)
    return Content(
        before.objects - after.objects,
        before.models - after.models,
        before.leftovers - after.leftovers,
        before.size - after.size,
    )


def _things(place: Path) -> Iterator[Path]:
    """Objects, models and what compilers keep; nothing else is ever touched."""
    if not place.is_dir():
        return
    for path in sorted(place.iterdir()):
        if OBJECT.match(path.name) or path.name in OTHER_CONTENT:
            yield path
    models = place / "models"
    if models.is_dir():
        yield from (path for path in sorted(models.iterdir()) if MODEL.match(path.name))


def _used(path: Path) -> float:
    """When something was used last [s]."""
    try:
        return path.stat().st_mtime
    except OSError:
        return time.time()


def _size(paths: Iterable[Path]) -> int:
    """Bytes of files, and of all files below folders."""
    files = list[str]()
    for path in paths:
        files.append(str(path))
        for folder, _, names in os.walk(path):
            files += [os.path.join(folder, name) for name in names]
    sizes = {}
    for file in files:
        with suppress(OSError):
            status = os.lstat(file)
            if stat.S_ISREG(status.st_mode):
                # objects that were compiled together are one file under several names
                sizes[status.st_dev, status.st_ino] = status.st_size
    return sum(sizes.values())
