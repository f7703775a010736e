"""Peak speed of the processor, so that figures can be given as a share of it."""

from __future__ import annotations

import ctypes
from pathlib import Path
from typing import Any

from ..records import dataclass
from .ours import library

ROUNDS = 400_000
TRIES = 9
CPUINFO = Path("/proc/cpuinfo")


@dataclass(frozen=True)
class Peak:
    """Multiply-adds of one core, two operations each.

    Attributes:
        scalar, vector: 1e9 operations per second.
        lanes: Numbers in a vector.
    """

    scalar: float
    vector: float
    lanes: int


def peak() -> Peak:
    """Measured now, by chains of multiply-adds in registers."""
    probe = library()

    def rate(call: Any) -> float:
        call.restype, call.argtypes = ctypes.c_double, [ctypes.c_int]
        return max(float(call(ROUNDS)) for _ in range(TRIES))

    return Peak(rate(probe.peak_scalar), rate(probe.peak_vector), int(probe.peak_lanes()))


def name() -> str:
    """Model name of the processor."""
    try:
        lines = CPUINFO.read_text("utf-8", errors="replace").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else "unknown processor"
