"""A spring and damper along a joint."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines
from ..quantity import JointName, Units, Value
from .force import Action, ForceElement, JointLoad, Places, constant, one_coordinate, potential


@dataclass(frozen=True)
class JointSpring(ForceElement):
    """A spring with a damper in parallel along the coordinate of a joint.

    The generalized ``force = -stiffness (q - rest) - damping u``.

    Args:
        joint: Name of a joint with one coordinate, turning or sliding.
        stiffness: [N m/rad] or [N/m].
        damping: [N m s/rad] or [N s/m].
        rest: Coordinate without load [rad] or [m].

    Raises:
        ModelError: a value that is not a finite number or expression.

    Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, section 12.1.
    """

    kind: ClassVar[str] = "joint_spring"
    _one_coordinate: ClassVar[bool] = True
    units: ClassVar[Units] = {
        **{"stiffness": "N*m/rad|N/m", "damping": "N*m*s/rad|N*s/m", "rest": "rad|m"}
    }
    joint: JointName
    stiffness: Value = 0.0
    damping: Value = 0.0
    rest: Value = 0.0

    def linear(self) -> tuple[str, ...]:
        return ("stiffness", "damping")

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, data, joints = at.motion, at.data, at.joints
        joint = joints["joint"]
        q, u = one_coordinate(motion, joint, f"joint_spring on joint '{self.joint}'")
        stiffness, damping, rest = (data[n][0] for n in ("stiffness", "damping", "rest"))
        actions = []
        if not data["stiffness"].is_zero:
            turn = q - rest
            stored = potential(stiffness * turn**2 * 0.5, data["stiffness"], data["rest"])
            back = Matrix.vector(motion.graph, [-(stiffness * turn)])
            actions.append(Action((), (JointLoad(joint, back),), *stored))
        if not data["damping"].is_zero:
            drag = Matrix.vector(motion.graph, [-(damping * u)])
            actions.append(Action(joint_loads=(JointLoad(joint, drag),)))
        return tuple(actions)

    def formulas(self, at: Places) -> Lines:
        spring, damper = (not at.data[name].is_zero for name in ("stiffness", "damping"))
        turn = "q" if at.data["rest"].is_zero else "(q - q_0)"
        terms = [f"k * {turn}"] * spring + ["c * u"] * damper
        if not terms:
            return ()
        about = "force along the joint, k the stiffness" if spring else "force along the joint"
        about += ", c the damping" * damper + ", q_0 its place without load" * (turn != "q")
        fixed = constant(at.data["stiffness"], at.data["rest"])
        energy: Lines = (("potential energy", f"V = k * {turn} ** 2 / 2"),)
        return ((about, f"tau = -({' + '.join(terms)})"), *energy * (spring and fixed))
