"""The force elements, by kind."""

from .damping import Damping
from .drive import Drive
from .force import ForceElement
from .force_on_frame import Force
from .friction import Friction
from .joint_force import JointForce
from .spring_damper import SpringDamper
from .torque import Torque
from .torsion_spring import TorsionSpring

FORCES: dict[str, type[ForceElement]] = {
    element.kind: element
    for element in (
        Force,
        Torque,
        SpringDamper,
        TorsionSpring,
        JointForce,
        Damping,
        Drive,
        Friction,
    )
}
