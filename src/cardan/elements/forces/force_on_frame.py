"""A force on a frame."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines
from ..quantity import Place, Units, Vector
from .force import Action, ForceElement, Load, Places


@dataclass(frozen=True)
class Force(ForceElement):
    """A force at the origin of a frame, ``force = R (its components) at the origin``.

    Args:
        frame: Body or frame it acts on; ``body.at(x, y, z)`` for a point.
        force: Three components [N]: numbers, parameters or expressions in coordinates, speeds,
            inputs, frames and t.
        in_: Frame in whose axes the components are given; the ground by default.

    Raises:
        ModelError: not three finite components.

    Source: Kane and Levinson, Dynamics: Theory and Applications, section 4.4.
    """

    kind: ClassVar[str] = "force"
    units: ClassVar[Units] = {"force": "N"}
    frame: Place
    force: Vector
    in_: Place = None

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, data, frames = at.motion, at.data, at.frames
        force = data["force"]
        if "in_" in frames:
            force = motion.rotation(frames["in_"]) @ force
        return (Action((Load(frames["frame"], Matrix.zeros(motion.graph, 3), force),)),)

    def formulas(self, at: Places) -> Lines:
        rotates = "in_" in at.frames
        about = "force f in the axes whose rotation is R" if rotates else "force f in ground axes"
        return ((about, "F = R_in @ f" if rotates else "F = f"),)
