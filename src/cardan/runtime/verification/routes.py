"""Who judges what: every function of a model, and the route to its numbers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...records import dataclass
from ..calls.objects import Key
from . import bodies, core, forces, increments, linear, motions, slopes
from .differences import BLURRED
from .evaluation import Trial
from .source_expressions import written


@dataclass(frozen=True)
class Check:
    """One function against the independent route.

    Attributes:
        function: Its name.
        error: Largest difference over the largest term of its equation; NaN if not checked.
        reason: Why it could not be checked, "" if it was.
        written: Largest difference from its own expressions, which the C was written from; NaN
            where they were not asked.
    """

    function: str
    error: float
    reason: str = ""
    written: float = float("nan")

    @property
    def worst(self) -> float:
        """The larger error; NaN if there is none."""
        return float(np.fmax(self.error, self.written))


# of a function and its frame or joint: the error, or why this route does not lead to it
Judge = Callable[[Trial, str], float | str]
JUDGES: dict[str, Judge] = {
    name: judge
    for module in (core, bodies, motions, increments, forces, slopes, linear)
    for name, judge in module.JUDGES.items()
}


FRAMES = ("pose", "velocity", "acceleration", "frame_jacobian")


def _has_pose(trial: Trial, frame: str | None) -> bool:
    """True when the flat scene has a frame."""
    frames = [row.name for row in trial.model.manifest.frames]
    return frame in frames and "frame_rotation" in trial.scene.numbers


def check(trial: Trial, key: Key, thoroughly: bool) -> Check:
    """Judge a function.

    Args:
        trial: The model at some states.
        key: The function.
        thoroughly: Whether C is compared with its expressions where something else judges too.
    """
    name, of = key
    error: float | str = "no other route to it"
    if name in FRAMES and not _has_pose(trial, of):
        error = "the scene does not say where the frame is"
    elif name in JUDGES:
        error = JUDGES[name](trial, of or "")
    if not isinstance(error, str) and np.isnan(error):
        error = BLURRED
    if isinstance(error, str):
        return by_text(trial, key, f"not checked: {error}", "" if name in core.JUDGES else "; ")
    text = written(trial, name, of) if thoroughly else ""
    return Check(label(key), error, "", np.nan if isinstance(text, str) else text)


def by_text(trial: Trial, key: Key, reason: str, further: str = "") -> Check:
    """A function that nothing speaks for but what it was written from.

    Args:
        trial: The model at some states.
        key: The function.
        reason: Why nothing else does.
        further: What stands before the reason why that does not either; "" for not to say it.
    """
    # where a solve has no unique result, neither has its expression
    text = "" if reason.endswith(core.SINGULAR) else written(trial, *key)
    if isinstance(text, str):
        return Check(label(key), np.nan, reason + further + text if text and further else reason)
    return Check(label(key), np.nan, reason, text)


def label(key: Key) -> str:
    """A function for the reader: ``pose('hand')``."""
    name, of = key
    return f"{name}({of!r})" if of else name
