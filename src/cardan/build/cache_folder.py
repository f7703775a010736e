"""The folder of the compile cache: this user's alone, or a temporary one.

What lies in it runs as this user, so nobody else may put anything there. A folder that is not ours,
not private, not a folder or not writable is left alone, and so is one that others could replace by
way of a folder above it: objects go to a temporary one then, which lives as long as the process.
"""

from __future__ import annotations

import atexit
import errno
import os
import re
import shutil
import stat
import tempfile
from contextlib import suppress
from functools import lru_cache
from pathlib import Path

from ..errors import BuildError, BuildWarning, warn
from .file_trust import GROUP_OR_WORLD, OWNERS, exposed

# others may not even list it: it shows what somebody works on
PRIVATE = 0o700
OURS = re.compile(r"[0-9a-f]{64}\.so\Z|models\Z|zig\Z|compilers\.json\Z|\.new-")


def configured() -> Path:
    """Configured folder of the cache: ``$CARDAN_CACHE`` or the usual place."""
    named = os.environ.get("CARDAN_CACHE")
    usual = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(named or os.path.join(usual, "cardan")).absolute()


def directory() -> Path:
    """The cache of this user, mode 0700; a temporary one, said once, where that cannot be used.

    One that was removed meanwhile is made again. Who may change it is looked at in every call:
    what lies in it is about to be loaded.
    """
    path = configured()
    folder = _usable(path)
    try:
        reason = exposed(folder)
    except OSError:
        _usable.cache_clear()
        folder = _usable(path)
        reason = exposed(folder)
    return instead(path, f"{reason}. {_ELSEWHERE}") if reason else folder


@lru_cache(maxsize=8)
def _usable(path: Path) -> Path:
    reason = refusal(path)
    return instead(path, reason) if reason else path


def refusal(path: Path) -> str:
    """Why a folder cannot hold the cache, with the cure; "" if it can. Makes it if need be."""
    try:
        path.mkdir(mode=PRIVATE, parents=True, exist_ok=True)
        status = path.stat()
    except FileExistsError:
        return f"it is a file. Remove it: rm {path}"
    except OSError as error:
        return f"it cannot be made ({error.strerror}). {_ELSEWHERE}"
    if OWNERS and status.st_uid != os.geteuid():
        return f"it belongs to another user. {_ELSEWHERE}"
    foreign = _foreign(path)
    if foreign:
        return f"it holds other things ({foreign}). {_ELSEWHERE}"
    # what others may have written cannot be trusted any more; what they may read is closed
    if OWNERS and status.st_mode & GROUP_OR_WORLD:
        return f"it is not private: others may write to it. Run: rm -r {path}"
    try:
        if stat.S_IMODE(status.st_mode) != PRIVATE:
            path.chmod(PRIVATE)
        way = exposed(path)
    except OSError as error:
        return f"it cannot be made private ({error.strerror}). {_ELSEWHERE}"
    return f"{way}, on the way to it. {_ELSEWHERE}" if way else ""


def _foreign(path: Path) -> str:
    """The first thing in a folder that no cache holds: it is not ours to change or to sweep."""
    try:
        with os.scandir(path) as entries:
            return next((e.name for e in entries if not OURS.match(e.name)), "")
    except OSError:
        return ""


_ELSEWHERE = "Set CARDAN_CACHE to a folder of your own"
_ROOM = "Make room with: cardan doctor --prune, or set CARDAN_CACHE to another folder"
# by what the system says; of everything else the place is at fault
_CURES = {
    errno.ENOENT: "It was removed while this process ran: do the same again, it is made anew",
    errno.EISDIR: "A folder stands where a file belongs: run cardan doctor --prune --all",
    errno.ENOSPC: _ROOM,
    errno.EDQUOT: _ROOM,
}


def cure(error: OSError) -> str:
    """Remedy where the cache cannot be written to."""
    return _CURES.get(error.errno or 0, "Set CARDAN_CACHE to another folder")


def used(path: Path) -> None:
    """Note the time of the last use of something in the cache, for those who prune."""
    # where nothing may be written, nothing is pruned
    with suppress(OSError):
        os.utime(path)


def instead(path: Path, reason: str) -> Path:
    """A temporary folder in place of one that cannot be used or written to; said once.

    Raises:
        BuildError: there is no room for a temporary one either.
    """
    return _temporary(path, reason, os.getpid())


@lru_cache(maxsize=8)
def _temporary(path: Path, reason: str, process: int) -> Path:
    folder = scratch(process)
    warn(
        f"the compile cache {path} cannot be used: {reason}. What is compiled now is lost when "
        "this process ends",
        BuildWarning,
    )
    return folder


_SCRATCH: dict[int, Path] = {}


def temporary() -> tuple[Path, ...]:
    """The temporary folder of this process, if it has one."""
    return tuple(path for process, path in _SCRATCH.items() if process == os.getpid())


def scratch(process: int) -> Path:
    """The temporary folder of a process, this one, private too; removed when it ends.

    Raises:
        BuildError: it cannot be made.
    """
    if process in _SCRATCH:
        return _SCRATCH[process]
    try:
        path = Path(tempfile.mkdtemp(prefix="cardan-"))
    except OSError as error:
        raise BuildError(
            f"no folder for compiled code: {tempfile.gettempdir()} cannot be written to "
            f"({error.strerror}). Make room, or set CARDAN_CACHE to a folder of your own"
        ) from error
    _SCRATCH[process] = path
    atexit.register(_remove, path, process)
    return path


def _remove(path: Path, process: int) -> None:
    # a forked child must not take it away from its parent
    if process == os.getpid():
        shutil.rmtree(path, ignore_errors=True)
