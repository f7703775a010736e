"""Interface of the formats that hold a motion itself, not its arrays alone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ...records import dataclass
from ...runtime.formats.contents import Ending
from ...runtime.trajectory.trajectory import TrajectoryRecord


@dataclass(frozen=True)
class MotionFormat(Ending):
    """One way to write a motion to a file.

    Attributes:
        write: To a path.
    """

    write: Callable[[TrajectoryRecord, Path], None]
