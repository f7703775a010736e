"""One self-contained page that plays a motion: no network, no library, nothing to install."""

from __future__ import annotations

import html
import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..arguments import checked
from ..atomic_file import folder, written
from ..errors import ModelError
from ..runtime.trajectory import frame_history
from ..runtime.trajectory.trajectory import TrajectoryRecord
from . import meshed, scene

PICTURES = 1500  # a longer motion gets fewer pictures per second
TEMPLATE = Path(__file__).with_name("page.html")
SCRIPT = Path(__file__).with_name("page.js")
MARK = re.compile("__(TITLE|SCRIPT|DATA)__")


@checked
def animate(
    motion: TrajectoryRecord, path: str | Path, *, fps: float = 60.0, title: str | None = None
) -> Path:
    """Write one self-contained page that plays the motion in any browser.

    Args:
        motion: The motion.
        path: HTML file. It appears complete or not at all.
        fps: Pictures per second of motion; long motions get fewer.
        title: Headline, the name of the model by default.

    Returns:
        The file.

    Raises:
        ModelError: a motion without poses, or the file cannot be written.
    """
    absent = motion.manifest.absent
    if "pose" in absent:
        raise ModelError(f"a page shows bodies: {absent['pose']}; plot() draws coordinates")
    resampled = _resampled(motion, fps)
    drawn = (meshed if resampled.manifest.method == "absolute" else scene).drawing(resampled)
    data = {"t": np.round(resampled.t, 6).tolist(), **drawn}
    # names are the user's: nothing in them may end the script or open a tag
    try:
        text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    except ValueError:
        raise ModelError(
            f"a page shows bodies at finite places; some of '{motion.manifest.name}' are not"
        ) from None
    for character in "<>&\u2028\u2029":
        text = text.replace(character, f"\\u{ord(character):04x}")
    headline = html.escape(str(title if title is not None else motion.manifest.name))
    parts = {"TITLE": headline, "SCRIPT": SCRIPT.read_text(encoding="utf-8"), "DATA": text}
    # in one sweep: what is filled in is never searched for marks
    page = MARK.sub(lambda mark: parts[mark[1]], TEMPLATE.read_text(encoding="utf-8"))
    return publish(Path(path), page)


def _resampled(motion: TrajectoryRecord, fps: float) -> TrajectoryRecord:
    """The motion at equal times, where it knows what lies between its rows."""
    last = len(motion) - 1
    span = float(motion.t[-1] - motion.t[0])
    count = int(min(PICTURES, max(2.0, abs(span) * fps + 1.5)))
    times = np.linspace(motion.t[0], motion.t[-1], count)
    if motion.dense is not None and (motion.model is not None or frame_history.is_recorded(motion)):
        return motion.resample(times)
    if motion.dense is None and len(motion) <= PICTURES:
        return motion
    # the rows that are there, of which many may be close to each other
    sign = 1.0 if span >= 0 else -1.0
    return _some(motion, np.unique(np.searchsorted(sign * motion.t, sign * times).clip(0, last)))


def _some(motion: TrajectoryRecord, rows: NDArray[np.intp]) -> TrajectoryRecord:
    """The motion at some of its rows, with what is stored of them."""
    poses = {k: v[rows] for k, v in motion.stored.items() if k.startswith("pose ")}
    parts = {name: getattr(motion, name)[rows] for name in ("t", "x", "r", "work_done")}
    return replace(motion, **parts, dense=None, stored=poses)


def publish(path: Path, page: str) -> Path:
    """Write a page, in a directory that is made if need be.

    Raises:
        ModelError: as :func:`cardan.atomic_file.replaced`.
    """
    folder(path)
    return written(path, page)
