"""A motor with gear on a joint."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from ...errors import ModelError, brief
from ...ir.arithmetic import Scalar
from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines
from ..limits import Limit, not_negative
from ..quantity import RATIO, JointName, Quantity, Units, Value, quantities_of
from .force import (
    Action,
    ForceElement,
    JointLoad,
    Motion,
    Places,
    RotorBody,
    constant,
    one_coordinate,
    potential,
)


@dataclass(frozen=True)
class Drive(ForceElement):
    """A motor whose rotor turns ``ratio`` times as fast as the joint it drives.

    Rigid and not gyroscopic, the rotor adds ratio^2 inertia to the joint and no more. With
    ``gyroscopic`` it is a body that turns in the joint's parent and feels the parent's motion.
    With ``stiffness`` gear and shaft are elastic: the rotor is a body with a coordinate
    ``<drive>.rotor`` (gyroscopic coupling included) and
    ``torque = stiffness (rotor / ratio - q) + damping (its rate)`` acts on the joint.

    Args:
        joint: Name of a joint with one coordinate.
        inertia: Of the rotor about its axis [kg m^2].
        ratio: Turns of the rotor per turn of the joint.
        torque: Of the motor on the rotor [N m]: number, parameter, input or expression.
        friction: Viscous, on the rotor [N m s/rad].
        gyroscopic: Couple the rotor to the motion of the parent.
        stiffness: Of the shaft at the joint side [N m/rad]; None: rigid.
        damping: Of the shaft at the joint side [N m s/rad].

    Raises:
        ModelError: a value that is not a finite number or expression, negative inertia, ratio 0, or
            damping without stiffness.

    Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, section 12.3.
    """

    kind: ClassVar[str] = "drive"
    _one_coordinate: ClassVar[bool] = True
    units: ClassVar[Units] = {
        **{"inertia": "kg*m^2", "stiffness": "N*m/rad", "damping": "N*m*s/rad"},
        **{"ratio": RATIO, "torque": "N*m", "friction": "N*m*s/rad"},
    }
    joint: JointName
    inertia: Value
    ratio: Value = 1.0
    torque: Value = 0.0
    friction: Value = 0.0
    gyroscopic: bool = False
    stiffness: Value | None = None
    damping: Value = 0.0

    def __post_init__(self) -> None:
        super().__post_init__()
        self._check()

    def _check(self) -> None:
        """Refuse what no drive can be.

        Raises:
            ModelError: damping of a shaft that is rigid.
        """
        who = f"drive on joint {brief(self.joint)}"
        if self.stiffness is None and self.damping != 0:
            raise ModelError(
                f"{who}: damping belongs to an elastic shaft; give its stiffness too, or use "
                "friction for the rotor"
            )

    def limits(self) -> tuple[Limit, ...]:
        ratio = "ratio is {value}; give the turns of the rotor per turn of the joint, not 0"
        return (
            *not_negative("inertia", requirement="0 or more [kg m^2]"),
            Limit("ratio", ratio, nonzero=True),
        )

    def rotor(self) -> RotorBody | None:
        if self.stiffness is None and not self.gyroscopic:
            # its inertia is added to the joint's
            return None
        ratio = self.ratio if self.stiffness is None else None
        return RotorBody(self.inertia, self.joint, ratio)

    def quantities(self) -> dict[str, Quantity]:
        left_out = {"inertia"} if self.rotor() else set()
        left_out |= {"damping"} if self.stiffness is None else set()
        return quantities_of(self, {k: v for k, v in self.units.items() if k not in left_out})

    def linear(self) -> tuple[str, ...]:
        return ("inertia", "friction", "stiffness", "damping")

    def rotor_inertia(self, data: Mapping[str, Matrix]) -> dict[str, Matrix]:
        if self.rotor() is not None:
            return {}
        ratio = data["ratio"][0]
        return {"joint": data["inertia"] * (ratio * ratio)}

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, data, joints = at.motion, at.data, at.joints
        joint, ratio = joints["joint"], data["ratio"][0]
        q, u = one_coordinate(motion, joint, f"drive on joint '{self.joint}'")
        torque, friction = data["torque"][0], data["friction"][0]
        if self.stiffness is None:
            motor = (torque - friction * (u * ratio)) * ratio
            return (Action(joint_loads=(_load(motion, joint, motor),)),)
        # an elastic shaft: the rotor moves by itself and pulls the joint along
        rotor = joints["rotor"]
        angle, speed = motion.q(rotor)[0], motion.u(rotor)[0]
        twist, rate = angle / ratio - q, speed / ratio - u
        spring, damper = data["stiffness"][0] * twist, data["damping"][0] * rate

        def pair(shaft: Scalar) -> tuple[JointLoad, JointLoad]:
            return _load(motion, joint, shaft), _load(motion, rotor, -(shaft / ratio))

        # a shaft that time or the motion changes works on the system and stores nothing
        stored = potential(spring * twist * 0.5, data["stiffness"], data["ratio"])
        return (
            Action((), pair(spring), *stored),
            Action(joint_loads=pair(damper)),
            Action(joint_loads=(_load(motion, rotor, torque - friction * speed),)),
        )

    def formulas(self, at: Places) -> Lines:
        rotor: Lines = ()
        if self.rotor() is None:
            about = "kinetic energy of the rotor, J its inertia, n its turns per turn of the joint"
            rotor = ((about, "T = J * n ** 2 * u ** 2 / 2"),)
        if self.stiffness is None:
            about = "force along the joint: torque m of the motor, c the friction"
            return (*rotor, (about, "tau = n * (m - c * n * u)"))
        fixed = constant(at.data["stiffness"], at.data["ratio"])
        return (
            ("twist of the shaft, n turns of the rotor per turn", "phi = q_rotor / n - q"),
            ("torque of the shaft", "f = k * phi + d * (u_rotor / n - u)"),
            ("force along the joint", "tau = f"),
            ("on the rotor, m of the motor, c the friction", "tau_rotor = m - c * u_rotor - f / n"),
            *((("potential energy", "V = k * phi ** 2 / 2"),) * fixed),
        )


def _load(motion: Motion, joint: int, force: Scalar) -> JointLoad:
    return JointLoad(joint, Matrix.vector(motion.graph, [force]))
