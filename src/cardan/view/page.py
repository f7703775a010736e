"""One self-contained page that plays a motion: no network, no library, nothing to install."""

from __future__ import annotations

import html
import json
import os
import re
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

from ..errors import ModelError
from ..runtime.trajectory import Trajectory
from . import meshed, scene

PICTURES = 1500  # a longer motion gets fewer pictures per second
TEMPLATE = Path(__file__).with_name("page.html")
SCRIPT = Path(__file__).with_name("page.js")
MARK = re.compile("__(TITLE|SCRIPT|DATA)__")


def write_page(
    motion: Trajectory, path: Path, *, fps: float = 60.0, title: str | None = None
) -> Path:
    """Write the page; see :meth:`cardan.runtime.trajectory.Trajectory.animate`.

    The file appears complete or not at all.
    """
    absent = motion.manifest.get("absent", {})
    if "pose" in absent:
        raise ModelError(f"a page shows bodies: {absent['pose']}; plot() draws coordinates")
    shown = _resampled(motion, fps)
    drawn = (meshed if shown.manifest["method"] == "absolute" else scene).drawing(shown)
    data = {"t": np.round(shown.t, 6).tolist(), **drawn}
    # names are the user's: nothing in them may end the script or open a tag
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    for character in "<>&\u2028\u2029":
        text = text.replace(character, f"\\u{ord(character):04x}")
    headline = html.escape(str(title if title is not None else motion.manifest["name"]))
    parts = {"TITLE": headline, "SCRIPT": SCRIPT.read_text(encoding="utf-8"), "DATA": text}
    # in one sweep: what is filled in is never searched for marks
    page = MARK.sub(lambda mark: parts[mark[1]], TEMPLATE.read_text(encoding="utf-8"))
    return publish(path, page)


def _resampled(motion: Trajectory, fps: float) -> Trajectory:
    """The motion at equal times, where it knows what lies between its rows."""
    span = float(motion.t[-1] - motion.t[0])
    count = int(min(PICTURES, max(2, round(abs(span) * fps) + 1)))
    if motion.dense is None:
        step = max(1, len(motion.t) // PICTURES)
        return motion if step == 1 or motion.model is None else _every(motion, step)
    return motion.resample(np.linspace(motion.t[0], motion.t[-1], count))


def _every(motion: Trajectory, step: int) -> Trajectory:
    rows = slice(None, None, step)
    return replace(
        motion,
        t=motion.t[rows],
        x=motion.x[rows],
        r=motion.r[rows],
        given=motion.given[rows],
        stored={},
    )


def publish(path: Path, page: str) -> Path:
    """Write a page: it appears complete or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=".cardan-", suffix=".html")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(page)
        os.chmod(name, 0o644)
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
    return path
