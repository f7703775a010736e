"""Warnings of runs and equilibria in which superelements leave their linear range."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from ...arrays import Array
from ...errors import SolveWarning, warn
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...schema.mechanism import SuperelementRow
from ...schema.rows import among

ANGLE = 0.1  # of an interface in the frame [rad]
# spin over the first frequency. The true first frequency of a blade is w1 sqrt(1 + 1.19 (w/w1)^2);
# at these limits it is off by 2 %: a frame on an interface has no stiffening, others most of it
SPIN, SPIN_OF_SEVERAL = 0.2, 0.5


def excesses(motion: TrajectoryRecord) -> Iterator[str]:
    """A sentence for every limit that a run exceeds.

    Args:
        motion: Any; nothing is checked without its model.
    """
    # those of superelements
    if motion.model is not None and motion.manifest.superelements and len(motion):
        yield from (text for limit in LIMITS if (text := limit(motion.model, motion)))


def warn_of_state(model: LoadedModel, x: Array, t: float, r: Array) -> None:
    """Warn of every limit that a state of rest or of steady motion exceeds.

    Args:
        model: Any.
        x: State (nx,).
        t, r: Time [s] and inputs (nr,).
    """
    state = TrajectoryRecord.of_states(model, np.array([t]), x[None], np.atleast_2d(r), "state")
    for text in excesses(state):
        warn(text, SolveWarning)


def rotated(model: LoadedModel, motion: TrajectoryRecord) -> str:
    """A sentence about the interface of a superelement that turns most in its frame.

    "" if none turns by more than :data:`ANGLE` radians.
    """
    worst, name = 0.0, ""
    for joint in among(model.manifest.joints, "kind", ("elastic",)):
        first, count = joint.slot("q")
        entries = range(first, first + count)
        turns = [k for k in entries if model.manifest.coordinates[k].unit == "rad"]
        angles = np.linalg.norm(motion.x[:, turns], axis=1)
        # runs report NaN elsewhere
        worst, name = max((worst, name), (float(np.nanmax(angles, initial=0.0)), joint.name))
    if worst <= ANGLE:
        return ""
    return (
        f"model '{model.name}': '{name}' turns by {worst:.2g} rad in the frame of its "
        f"superelement, which is linear and good up to about {ANGLE:g}: divide the body into "
        "several superelements, take beams, or another frame="
    )


def spun(model: LoadedModel, motion: TrajectoryRecord) -> str:
    """A sentence about the superelement that spins fastest for its stiffness, which is constant.

    "" if all spin slowly compared with their first frequency, or have stiffening.
    """
    worst, text, q, u = 1.0, "", np.ascontiguousarray(motion.q), np.ascontiguousarray(motion.u)
    for row in model.manifest.superelements:
        if row.stiffening or not row.first_frequency > 0:
            continue
        w = model.velocity(row.frame, q, u, in_="frame", t=motion.t, r=motion._r)[:, :3]
        spin, several = _spin(motion.t, w, row), row.frame_choice != row.fixed
        ratio = spin / row.first_frequency
        excess = ratio / (SPIN_OF_SEVERAL if several else SPIN)
        if excess > worst:
            worst = excess
            what = f"a part of their stiffening (frame '{row.frame_choice}')" if several else "none"
            text = (
                f"model '{model.name}': superelement '{row.name}' spins with w = {spin:.4g} rad/s, "
                f"{ratio:.2g} times its first frequency w1 = {row.first_frequency:.4g} rad/s with "
                f"'{row.fixed}' fixed, and centrifugal forces give it {what}: reduce it with "
                f"stiffening='{row.fixed}' and place it with frame='{row.fixed}', stiffening=True, "
                "or divide it into several superelements with frame='chord'"
            )
    return text


def _spin(t: Array, w: Array, row: SuperelementRow) -> float:
    """The largest spin in the mean over a period of the first vibration [rad/s].

    It is sqrt(w^T J w), with the inertia J over its largest moment: a spin about the axis of a
    slender body does not stretch it. A faster oscillation than its first one hardly bends it.
    """
    squares = np.einsum("ti,ij,tj->t", w, np.reshape(row.relative_inertia, (3, 3)), w)
    good = np.isfinite(squares)
    t, squares = t[good], squares[good]
    if len(t) < 2 or t[-1] <= t[0]:
        return float(np.sqrt(squares.max(initial=0.0)))
    return float(np.sqrt(_means(t, squares, 2 * np.pi / row.first_frequency).max()))


def _means(t: Array, values: Array, period: float) -> Array:
    """Means (n,) over the period that ends at each time, which is cut off at the start."""
    integral = np.concatenate([[0.0], np.cumsum(np.diff(t) * (values[1:] + values[:-1]) / 2)])
    width = min(period, t[-1] - t[0])
    # at early times the interval is shorter than the width, so that these means are too small
    return np.asarray((integral - np.interp(np.maximum(t - width, t[0]), t, integral)) / width)


LIMITS: tuple[Callable[[LoadedModel, TrajectoryRecord], str], ...] = (rotated, spun)
