"""Who may change what runs as this user: a file, the folders that lead to it, links on the way.

Others may not own or write to any of them. A folder that others may write to is harmless if it has
the sticky bit, as /tmp has: there nobody can replace what belongs to somebody else.
"""

from __future__ import annotations

import os
import stat
from contextlib import suppress
from functools import lru_cache
from pathlib import Path

MOST_LINKS = 40
GROUP_OR_WORLD = stat.S_IWGRP | stat.S_IWOTH
# Windows has lists of who may do what instead; owners and modes that Python tells there say nothing
OWNERS = hasattr(os, "geteuid")


def exposed(path: Path) -> str:
    """Folder on the way to a place that others may change; "" if there is none.

    Args:
        path: A folder that exists, as it is named: links on the way are followed and looked at.

    Raises:
        OSError: it does not exist, or links go in a circle.
    """
    for place, status in _way(os.path.abspath(path)) if OWNERS else ():
        if status.st_uid not in (0, os.geteuid()):
            return f"{place} belongs to another user"
        if stat.S_ISDIR(status.st_mode) and _open(status) and not status.st_mode & stat.S_ISVTX:
            return f"others may write to {place}"
    return ""


def is_mine(status: os.stat_result) -> bool:
    """True when a file that was opened belongs to this user and others may not write to it."""
    mine = not OWNERS or (status.st_uid in (0, os.geteuid()) and not _open(status))
    return mine and stat.S_ISREG(status.st_mode)


def _open(status: os.stat_result) -> bool:
    """True when others may write to something; a group of one's own is nobody else."""
    mode = status.st_mode & GROUP_OR_WORLD
    return bool(mode & stat.S_IWOTH or (mode and not _alone(status.st_gid, status.st_uid)))


@lru_cache(maxsize=64)
def _alone(group: int, user: int) -> bool:
    """True when a group is the private one of a user, with nobody else in it."""
    with suppress(ImportError, KeyError):
        import grp
        import pwd

        name, group_entry = pwd.getpwuid(user).pw_name, grp.getgrgid(group)
        return group_entry.gr_name == name and set(group_entry.gr_mem) <= {name}
    return False


def _way(path: str) -> list[tuple[str, os.stat_result]]:
    """Everything that is looked up on the way to a place, links and what they lead to."""
    here, left, links = os.sep, path.split(os.sep)[::-1], 0
    steps = [(here, os.lstat(here))]
    while left:
        name = left.pop()
        if name in ("", "."):
            continue
        if name == "..":
            here = os.path.dirname(here)
            continue
        place = os.path.join(here, name)
        status = os.lstat(place)
        steps.append((place, status))
        if not stat.S_ISLNK(status.st_mode):
            here = place
            continue
        links += 1
        if links > MOST_LINKS:
            raise OSError(f"the links of {path} go in a circle")
        target = os.readlink(place)
        left += target.split(os.sep)[::-1]
        here = os.sep if target.startswith(os.sep) else here
    return steps
