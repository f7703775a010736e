"""Files of motions: one format is one file here, or, of arrays alone, in ``runtime/formats``."""

from __future__ import annotations

from pathlib import Path

from ...arguments import checked
from ...atomic_file import replaced
from ...runtime import formats
from ...runtime.formats.contents import Ending
from ...runtime.trajectory import storage
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...version import RUN
from .glb import GLB
from .mcap_log import MCAP
from .motion_format import MotionFormat

FORMATS: tuple[Ending, ...] = (*formats.FORMATS, GLB, MCAP)


@checked
def save(motion: TrajectoryRecord, path: str | Path) -> Path:
    """Write the motion; the ending of the name says the format.

    ``.nc`` (netCDF) and ``.npz`` (NumPy archive) hold everything but the model, and are read by
    :func:`cardan.load_motion`. For other programs: ``.csv`` (a table of what changes over time,
    with units), ``.mat`` (MATLAB, Octave), ``.json``, ``.nc4`` (netCDF-4), ``.glb`` (animated
    glTF) and ``.mcap`` (Foxglove, PlotJuggler); ``docs/exchange.md`` says what is in each. The file
    appears complete or not at all.

    Args:
        motion: The motion.
        path: The file.

    Returns:
        Its path.

    Raises:
        ModelError: the ending of another format, a variable too large for the format, places that
            are not finite, or a file that cannot be written.
        ModuleNotFoundError: a package that the format needs is not installed; the message names the
            extra.
    """
    path = Path(path)
    chosen = formats.by_ending(path, FORMATS, "runs")
    if isinstance(chosen, MotionFormat):
        with replaced(path) as new:
            chosen.write(motion, Path(new))
        return path
    return formats.save(path, RUN, storage.contents(motion), storage.FEWER)
