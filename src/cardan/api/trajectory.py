"""A motion as users hold it."""

from __future__ import annotations

from typing import Any, final

from ..runtime.trajectory.pickled import reduced, unpickled
from ..runtime.trajectory.trajectory import TrajectoryRecord
from .faces import face, verb


@final
class Trajectory(TrajectoryRecord):
    """Motion of a model over time, as :meth:`CompiledModel.simulate` returns it.

    ``motion["elbow"]`` is the history of a coordinate, ``motion["elbow.u"]`` of a speed,
    ``motion["base"]`` of all coordinates of a joint; outputs and inputs by their names.
    """

    beam = verb("cardan.runtime.models.finite_elements.beams:beam_of_run")
    superelement = verb("cardan.runtime.models.finite_elements.superelements:superelement_of_run")
    cable = verb("cardan.runtime.trajectory.cables:cable_of_run")
    screw_axis = verb("cardan.analyses.mechanisms.screw_axis:screw_axis_of_run")
    torques = verb("cardan.analyses.identification.torques:torques_of_run")
    to_xarray = verb("cardan.runtime.trajectory.dataset:to_xarray")
    to_pandas = verb("cardan.runtime.trajectory.dataset:to_pandas")
    save = verb("cardan.view.motion_files:save")
    plot = verb("cardan.view.plot:plot")
    animate = verb("cardan.view.page:animate")

    def __reduce__(self) -> tuple[object, ...]:
        _, parts = reduced(self)
        return _unpickled_motion, parts


def _unpickled_motion(version: int, writer: str, values: dict[str, Any], stated: str) -> Trajectory:
    """The motion of a pickle, which names this function as one of ``cardan`` itself.

    Raises:
        ModelError: it is of another version, was damaged or changed.
    """
    motion: Trajectory = face(unpickled(version, writer, values, stated))
    return motion


# pickles find it wherever it stands
_unpickled_motion.__module__ = "cardan"
