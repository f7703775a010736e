"""A wheel that a body carries: a gyrostat."""

from __future__ import annotations

from typing import ClassVar

from ...errors import ModelError
from ...ir.arithmetic import norm
from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines
from ..limits import Limit, not_negative
from ..quantity import RATIO, Direction, Place, Quantity, Units, Value, quantities_of
from .force import FRAME, JOINT, Action, ForceElement, JointLoad, Load, Places, RotorBody, constant


@dataclass(frozen=True)
class Rotor(ForceElement):
    """A wheel inside a body, symmetric about its axis: with its carrier a gyrostat.

    The carrier's mass and inertia are those of both, less ``inertia``, which turns with the wheel.
    What moves it is one of three:

    - ``momentum``: the wheel has this much angular momentum about its axis, beyond what the inertia
      of the carrier says, and keeps it: only its gyroscopic torque acts (Kelvin's gyrostat; then no
      inertia is given). :meth:`CompiledModel.momentum` does not contain it.
    - ``speed``: it turns at this rate against its carrier, whatever torque that needs.
    - else ``torque`` of a motor between carrier and wheel, 0 for one that turns freely. It has a
      coordinate ``<name>.rotor``, its angle against the carrier.

    Args:
        frame: Frame or body it is carried by.
        axis: Of the wheel, in axes of ``frame``.
        inertia: About that axis [kg m^2].
        momentum: [N m s], constant.
        speed: [rad/s], constant.
        torque: On the wheel, its opposite on the carrier [N m]: number, input or expression, also
            in ``scene.u("<name>.rotor")``.
        friction: Viscous, against the carrier [N m s/rad].

    Raises:
        ModelError: momentum or speed besides another of the three, no inertia where it is needed,
            negative inertia, or an axis that is not a direction.

    Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, section 12.3.
    """

    kind: ClassVar[str] = "rotor"
    units: ClassVar[Units] = {
        **{"axis": RATIO, "inertia": "kg*m^2", "momentum": "N*m*s", "speed": "rad/s"},
        **{"torque": "N*m", "friction": "N*m*s/rad"},
    }
    frame: Place
    axis: Direction = "z"
    inertia: Value | None = None
    momentum: Value | None = None
    speed: Value | None = None
    torque: Value = 0.0
    friction: Value = 0.0

    def __post_init__(self) -> None:
        super().__post_init__()
        driven = self.torque != 0 or self.friction != 0
        if (self.momentum is not None) + (self.speed is not None) + driven > 1:
            raise ModelError(
                "rotor: momentum, speed and torque (with friction) exclude each other; give one"
            )
        if (self.inertia is None) == (self.momentum is None):
            raise ModelError(
                "rotor: give inertia about the axis, or momentum alone where that is constant"
            )

    def limits(self) -> tuple[Limit, ...]:
        return not_negative("inertia", requirement="0 or more [kg m^2]") + not_negative("friction")

    def rotor(self) -> RotorBody | None:
        if self.inertia is None:
            return None
        return RotorBody(self.inertia, frame=self.frame, axis=self.axis, speed=self.speed)

    def quantities(self) -> dict[str, Quantity]:
        # a given speed is one of the joint of its body
        acting = ("torque", "friction") if self.speed is None else ()
        acting = acting if self.momentum is None else ("axis", "momentum")
        return quantities_of(self, {name: self.units[name] for name in acting})

    def linear(self) -> tuple[str, ...]:
        return ("momentum", "friction")

    def paired(self) -> bool:
        return self.momentum is None

    def acts_on(self) -> tuple[str, str]:
        if self.speed is not None:
            return "", ""
        return (JOINT, "rotor") if self.momentum is None else (FRAME, "frame")

    def act(self, at: Places) -> tuple[Action, ...]:
        if self.speed is not None:
            return ()
        return self._gyroscopic(at) if self.momentum is not None else self._driven(at)

    def _gyroscopic(self, at: Places) -> tuple[Action, ...]:
        """The torque that turns its momentum; it is across the angular velocity: no power."""
        if not constant(at.data["momentum"], at.data["axis"]):
            raise ModelError(
                "rotor: momentum and axis are constant; give the inertia, and speed or torque, "
                "for a wheel that changes its momentum"
            )
        frame, axis = at.frames["frame"], at.data["axis"]
        momentum = axis * (at.data["momentum"][0] / norm(*axis))
        torque = momentum.cross(at.motion.spin(frame))
        load = Load(frame, torque, Matrix.zeros(at.motion.graph, 3), axes=frame)
        return (Action((load,)),)

    def _driven(self, at: Places) -> tuple[Action, ...]:
        rotor = at.joints["rotor"]
        torque = at.data["torque"] - at.motion.u(rotor) * at.data["friction"][0]
        return (Action(joint_loads=(JointLoad(rotor, torque),)),)

    def formulas(self, at: Places) -> Lines:
        if self.speed is not None:
            return ()
        if self.momentum is None:
            return (("torque on the wheel, c the friction", "tau = m - c * u"),)
        return (
            ("angular momentum along the axis a", "h = H / sqrt(dot(a, a)) * a"),
            ("gyroscopic torque", "M = R @ skew(h) @ omega"),
        )
