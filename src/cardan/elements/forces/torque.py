"""A torque on a frame."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines
from ..quantity import Place, Units, Vector
from .force import Action, ForceElement, Load, Places


@dataclass(frozen=True)
class Torque(ForceElement):
    """A torque on the body of a frame.

    Args:
        frame: Body or frame it acts on.
        torque: Three components [N m]: numbers, parameters or expressions.
        in_: Frame in whose axes the components are given; the ground by default.

    Raises:
        ModelError: not three finite components.

    Source: Kane and Levinson, Dynamics: Theory and Applications, section 4.4.
    """

    kind: ClassVar[str] = "torque"
    units: ClassVar[Units] = {"torque": "N*m"}
    frame: Place
    torque: Vector
    in_: Place = None

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, data, frames = at.motion, at.data, at.frames
        torque = data["torque"]
        if "in_" in frames:
            torque = motion.rotation(frames["in_"]) @ torque
        return (Action((Load(frames["frame"], torque, Matrix.zeros(motion.graph, 3)),)),)

    def formulas(self, at: Places) -> Lines:
        rotates = "in_" in at.frames
        about = "torque m in the axes whose rotation is R" if rotates else "torque m in ground axes"
        return ((about, "M = R_in @ m" if rotates else "M = m"),)
