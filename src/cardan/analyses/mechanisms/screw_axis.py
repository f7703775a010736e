"""Instantaneous screw axis of a body: in a state, and along a motion."""

from __future__ import annotations

from typing import final

import numpy as np

from ...arguments import Times, checked
from ...arrays import Array
from ...records import dataclass
from ...runtime.calls.evaluation import State
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord

# angular velocity [rad/s] against the velocity [m/s]: an axis farther away than 1e12 m is rounding
PARALLEL = 1e-12


@final
@dataclass(frozen=True, repr=False, eq=False)
class ScrewAxis:
    """The line about which a body turns and along which it slides at an instant.

    Attributes:
        frame: Name of the frame that moves.
        point: Of the axis that is nearest to the origin of the frame (..., 3) [m], in ground axes;
            NaN where the body does not turn.
        direction: Unit vector along the angular velocity (..., 3), along the velocity where the
            body does not turn, 0 at rest.
        rate: Angular velocity about the axis (...) [rad/s].
        slide: Velocity along it (...) [m/s].
    """

    frame: str
    point: Array
    direction: Array
    rate: Array
    slide: Array

    @property
    def pitch(self) -> Array:
        """Slide per angle (...) [m/rad]; infinite where the body does not turn, NaN at rest."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(self.slide / self.rate)

    def __repr__(self) -> str:
        return f"ScrewAxis of '{self.frame}', {self.rate.size} instants"


def _axis(frame: str, origin: Array, twist: Array) -> ScrewAxis:
    """``point = p + omega x v / omega², slide = omega·v / |omega|`` of a twist (..., 6) at p."""
    omega, v = twist[..., :3], twist[..., 3:]
    rate, speed = np.linalg.norm(omega, axis=-1), np.linalg.norm(v, axis=-1)
    turns = rate > PARALLEL * speed
    safe = np.where(turns, rate, 1.0)
    along = np.where(turns[..., None], omega, v)
    size = np.where(turns, safe, np.where(speed > 0, speed, 1.0))
    direction = along / size[..., None]
    point = origin + np.cross(omega, v) / safe[..., None] ** 2
    return ScrewAxis(
        frame=frame,
        point=np.where(turns[..., None], point, np.nan),
        direction=direction,
        rate=np.where(turns, rate, 0.0),
        slide=np.sum(direction * v, axis=-1),
    )


@checked
def screw_axis(
    model: LoadedModel, frame: str, q: State, u: State, *, t: Times = 0.0, r: State | None = None
) -> ScrewAxis:
    """Instantaneous screw axis of a body or frame against the ground.

    Args:
        model: The model.
        frame: Name of the frame or body.
        q, u: Coordinates (..., nq) and speeds (..., nu).
        t, r: Time [s] and inputs (..., nr), where something is prescribed.

    Returns:
        The axis at every state.

    Raises:
        ModelError: there is no such frame. ArgumentError: q or u has another shape.

    Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, chapter 4.
    """
    origin = np.asarray(model.pose(frame, q, t=t, r=r))[..., :3, 3]
    return _axis(frame, origin, np.asarray(model.velocity(frame, q, u, t=t, r=r)))


@checked
def screw_axis_of_run(motion: TrajectoryRecord, frame: str) -> ScrewAxis:
    """Instantaneous screw axis of a body or frame at all times.

    Args:
        motion: The motion.
        frame: Name of the frame or body.

    Returns:
        The axis at every time (nt).

    Raises:
        ModelError: there is no such frame, or the motion was read from a file without its model.
    """
    model = motion._model(f"the screw axis of '{frame}'")
    return screw_axis(model, frame, motion.q, motion.u, t=motion.t, r=motion._r)
