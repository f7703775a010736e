"""Who judges what: every function of a model, and the route to its numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from ..objects import Key
from . import bodies, forces, increments, linear, motions, slopes
from .asked import Asked
from .differences import BLURRED
from .written import written

# of a function and its frame or joint: the error, or why this route does not lead to it
Judge = Callable[[Asked, str], float | str]
JUDGES: dict[str, Judge] = {
    name: judge
    for module in (bodies, motions, increments, forces, slopes, linear)
    for name, judge in module.JUDGES.items()
}


FRAMES = ("pose", "velocity", "acceleration", "frame_jacobian")


def _placed(asked: Asked, frame: str | None) -> bool:
    """Whether the flat scene has a frame."""
    frames = [row["name"] for row in asked.model.manifest["frames"]]
    return frame in frames and "frame_rotation" in asked.scene.numbers


def judged(asked: Asked, keys: Iterable[Key], thoroughly: bool) -> dict[Key, tuple[float, str]]:
    """Error of every function, and why only its own expressions speak for it, "" where more does.

    Args:
        asked: The model at some states.
        keys: Functions.
        thoroughly: Whether C is compared with its expressions where something else judges too.
    """
    found: dict[Key, tuple[float, str]] = {}
    for name, of in keys:
        error: float | str = "no other route to it"
        if name in FRAMES and not _placed(asked, of):
            error = "the scene does not say where the frame is"
        elif name in JUDGES:
            error = JUDGES[name](asked, of or "")
        if not isinstance(error, str) and np.isnan(error):
            error = BLURRED
        if isinstance(error, str):
            text = written(asked, name, of)
            none = (float("nan"), f"{error}; {text}")
            found[name, of] = none if isinstance(text, str) else (text, error)
            continue
        text = written(asked, name, of) if thoroughly else 0.0
        found[name, of] = (error if isinstance(text, str) else max(error, text), "")
    return found
