"""Keys of an animation: as many as cubic splines through them need, with edges at events."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import ModelWarning, warn
from ...records import dataclass
from ...runtime.trajectory.frame_history import can_resample
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..drawing import FAST
from ..packing import turns
from ..page import rows_of
from ..solids import poses_of_bodies

EXACT = 1e-6  # error between keys, of the size of what moves
MOST = 20_000  # keys
SMOOTHER = 16  # how much smaller the error gets with twice as many keys


@dataclass(frozen=True)
class Keys:
    """Times of an animation.

    Attributes:
        t: From 0 on, increasing (n,) [s].
        edges: First and last key, and those between at which velocities may jump.
    """

    t: Array
    edges: tuple[int, ...]

    def spline(self, values: Array) -> Array:
        """Slope before every key, value, slope behind it (n, 3, k), of values (n, k) there."""
        from scipy.interpolate import CubicSpline

        keys = np.stack([np.zeros_like(values), values, np.zeros_like(values)], axis=1)
        for first, last in zip(self.edges[:-1], self.edges[1:], strict=True):
            part = slice(first, last + 1)
            slopes = CubicSpline(self.t[part], values[part])(self.t[part], 1)
            keys[first + 1 : last + 1, 0], keys[first:last, 2] = slopes[1:], slopes[:-1]
        return keys

    def midway(self, keys: Array) -> Array:
        """A spline (n, 3, k) halfway between its keys (n - 1, k), as viewers have it."""
        span = np.diff(self.t)[:, None]
        middle: Array = (keys[1:, 1] + keys[:-1, 1]) / 2 + span * (keys[:-1, 2] - keys[1:, 0]) / 8
        return middle


def keys_of(motion: TrajectoryRecord) -> tuple[TrajectoryRecord, Keys]:
    """The motion at the keys of its animation.

    Its own rows where it does not know what is between them; else as many as splines need to
    follow its bodies, at least one for every picture of a screen.
    """
    if len(motion) == 1 or not np.ptp(motion.t) > 0:
        return rows_of(motion, np.zeros(1, np.intp)), Keys(np.zeros(1), (0,))
    if not can_resample(motion):
        return _of_rows(motion)
    return _refined(motion)


def _of_rows(motion: TrajectoryRecord) -> tuple[TrajectoryRecord, Keys]:
    """Keys at the rows of a motion; of those at one time the last."""
    order = np.argsort(motion.t, kind="stable")
    times = motion.t[order]
    distinct = np.flatnonzero(np.append(_distinct(times), True))
    rows = order[distinct]
    return rows_of(motion, rows), _keys(motion, motion.t[rows])


def _distinct(times: Array) -> Array:
    """True where a time and the next differ, in single precision from the first on."""
    return np.asarray(np.diff((times - times[0]).astype(np.float32)) > 0)


def _keys(motion: TrajectoryRecord, times: Array) -> Keys:
    event_times = [event.t for event in motion.events]
    inner = np.unique(np.searchsorted(times, event_times)) if event_times else np.zeros(0, np.intp)
    inner = inner[(inner > 0) & (inner < len(times) - 1)]
    edges = (0, *inner.tolist(), len(times) - 1)
    return Keys(times - times[0], edges if len(times) > 1 else (0,))


def _refined(motion: TrajectoryRecord) -> tuple[TrajectoryRecord, Keys]:
    """Keys at equal times and at events, twice as many until splines follow the motion."""
    low, high = sorted((float(motion.t[0]), float(motion.t[-1])))
    count = int(np.clip((high - low) * FAST, 8, MOST)) + 1
    times = np.union1d(np.linspace(low, high, count), [event.t for event in motion.events])
    times = times[np.append(_distinct(times), True)]
    while True:
        keys = _keys(motion, times)
        middle = (times[1:] + times[:-1]) / 2
        at_keys, at_middle = (_tracks(motion.resample(t)) for t in (times, middle))
        places = at_keys[:, :, :3]
        # there may be nothing that moves
        size = float(np.ptp(places, axis=(0, 1)).max()) if places.size else 0.0
        splines = keys.midway(keys.spline(at_keys.reshape(len(times), -1)))
        error = _distance(splines.reshape(at_middle.shape), at_middle, size or 1.0)
        if not error > EXACT:
            return motion.resample(times), keys
        if 2 * len(times) > MOST:
            warn(
                f"'{motion.manifest.name}' moves so fast that {len(times)} keys miss it by "
                f"{error:.1g} of its size between them; save a shorter part of it",
                ModelWarning,
            )
            return motion.resample(times), keys
        times = np.union1d(times, middle)
        times = times[np.append(_distinct(times), True)]
        if error < EXACT * SMOOTHER / 2:
            return motion.resample(times), _keys(motion, times)


def _distance(splines: Array, exact: Array, size: float) -> float:
    """Largest distance of places (n, bodies, 7): of positions against a size, of quaternions."""
    # q and -q are one rotation
    signs = np.sign(np.sum(splines[..., 3:] * exact[..., 3:], axis=-1, keepdims=True))
    aside = np.abs(splines[..., :3] - exact[..., :3]).max(initial=0.0)
    angle = np.abs(splines[..., 3:] - signs * exact[..., 3:]).max(initial=0.0)
    return float(max(aside / size, angle))


def _tracks(motion: TrajectoryRecord) -> Array:
    """Positions and quaternions (nt, n, 7) of all bodies."""
    manifest = motion.manifest
    if manifest.absolute:
        # the first frame of each
        frames = {row.body: row.name for row in reversed(manifest.frames) if row.body != "ground"}
        poses = [motion.pose(frame) for frame in frames.values()]
    else:
        poses = [*poses_of_bodies(motion).values()]
    if not poses:
        return np.zeros((len(motion), 0, 7))
    table = np.stack(poses, axis=1)
    return np.concatenate([table[..., :3, 3], turns(table[..., :3, :3])], axis=-1)
