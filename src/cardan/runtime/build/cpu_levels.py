"""Levels of instruction sets: what compiled code may use of a processor.

Code of one level has the same bits on every processor that has it.
"""

from __future__ import annotations

import platform

from ...records import dataclass

# what each level of x86-64 adds to the one before, in the words of gcc and clang of any age
_V2 = ("-mcx16", "-mpopcnt", "-msahf", "-msse3", "-mssse3", "-msse4.1", "-msse4.2")
_V3 = ("-mavx", "-mavx2", "-mbmi", "-mbmi2", "-mf16c", "-mfma", "-mlzcnt", "-mmovbe")
_V4 = ("-mavx512f", "-mavx512bw", "-mavx512cd", "-mavx512dq", "-mavx512vl")


@dataclass(frozen=True)
class Level:
    """A set of instructions.

    Attributes:
        name: As users and compilers know it.
        number: What ``cardan_level`` of ``kernels/level.c`` calls it.
        lanes: Numbers that its vectors hold.
        flags: What gcc and clang are told.
        zig: What ``zig cc`` is told, whose default is the processor that it runs on.
    """

    name: str
    number: int
    lanes: int
    flags: tuple[str, ...] = ()
    zig: tuple[str, ...] = ()

    def plainest(self) -> Level:
        """The level that all machines of the family have."""
        return next(levels[0] for levels in (X86, ARM, (OTHER,)) if self in levels)


X86 = (
    Level("x86-64", 1, 2, (), ("-march=x86_64",)),
    Level("x86-64-v2", 2, 2, _V2, ("-march=x86_64_v2",)),
    Level("x86-64-v3", 3, 4, _V2 + _V3, ("-march=x86_64_v3",)),
    Level("x86-64-v4", 4, 8, _V2 + _V3 + _V4, ("-march=x86_64_v4",)),
)
ARM = (Level("armv8", 8, 2, ("-march=armv8-a",), ("-mcpu=generic",)),)
# a processor of which nothing is known: what its compilers take it for
OTHER = Level("generic", 0, 1)
# machines by what Python calls them
FAMILIES = {"x86_64": X86, "amd64": X86, "aarch64": ARM, "arm64": ARM}
LEVELS = {level.number: level for level in (OTHER, *X86, *ARM)}


def family() -> tuple[Level, ...]:
    """The levels of machines like this one, the least demanding first."""
    return FAMILIES.get(platform.machine().lower(), (OTHER,))


def of_wheels() -> tuple[Level, ...]:
    """The levels that a wheel for machines like this one holds: what is older compiles its own."""
    return X86[1:] if family() is X86 else family()
