"""Platforms of the binaries in an FMU."""

from __future__ import annotations

import platform
import sys
from typing import NamedTuple


class Platform(NamedTuple):
    """A platform.

    Attributes:
        name: As users say it.
        target: As ``zig cc -target`` has it.
        suffix: Of shared objects.
        system, machines: As Python names them there.
    """

    name: str
    target: str
    suffix: str
    system: str
    machines: tuple[str, ...]


PLATFORMS = {
    one.name: one
    for one in (
        Platform("linux", "x86_64-linux-gnu.2.17", ".so", "linux", ("x86_64", "amd64")),
        Platform("linux-aarch64", "aarch64-linux-gnu.2.17", ".so", "linux", ("aarch64", "arm64")),
        Platform("windows", "x86_64-windows-gnu", ".dll", "win32", ("x86_64", "amd64")),
        Platform("macos", "aarch64-macos", ".dylib", "darwin", ("arm64", "aarch64")),
        Platform("macos-x86_64", "x86_64-macos", ".dylib", "darwin", ("x86_64", "amd64")),
    )
}


def here() -> Platform | None:
    """The platform of this machine; None where it is none of these."""
    machine = platform.machine().lower()
    for one in PLATFORMS.values():
        if one.system == sys.platform and machine in one.machines:
            return one
    return None
