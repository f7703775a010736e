"""Interface of the formats that hold a motion itself, not its arrays alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ...runtime.formats.contents import Ending
from ...runtime.trajectory.trajectory import TrajectoryRecord


@dataclass(frozen=True)
class MotionFormat(Ending):
    """One way to write a motion to a file.

    Attributes:
        write: To a path.
    """

    write: Callable[[TrajectoryRecord, Path], None]
