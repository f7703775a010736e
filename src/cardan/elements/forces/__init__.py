"""The force elements, by kind."""

from .actuator import Actuator
from .bushing import Bushing
from .cable import Cable
from .contact import Contact
from .controller import Controller
from .drive import Drive
from .event import Event
from .flexible_hinge import FlexibleHinge
from .force import ForceElement
from .force_on_frame import Force
from .friction import Friction
from .gravity import FIELDS
from .joint_damper import JointDamper
from .joint_force import JointForce
from .joint_spring import JointSpring
from .line_load import LineLoad
from .lock import Lock
from .maxwell import Maxwell
from .rotor import Rotor
from .spring_damper import SpringDamper
from .stop import Stop
from .torque import Torque

_ELEMENTS: tuple[type[ForceElement], ...] = (
    Force,
    Torque,
    LineLoad,
    SpringDamper,
    Maxwell,
    Bushing,
    FlexibleHinge,
    Cable,
    JointSpring,
    JointForce,
    JointDamper,
    Drive,
    Rotor,
    Actuator,
    Controller,
    Friction,
    Stop,
    Lock,
    Contact,
    *FIELDS,
    Event,
)
FORCES: dict[str, type[ForceElement]] = {element.kind: element for element in _ELEMENTS}
