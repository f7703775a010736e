"""The flexible elements, by kind."""

from .bushing import Bushing
from .cable import Cable
from .cable_inertia import CableInertia
from .classical import Classical
from .damping import Damping
from .dead_load import DeadLoad
from .element import FlexibleElement
from .follower_load import FollowerLoad
from .helicoidal import Helicoidal
from .hellinger_reissner import HellingerReissner
from .hinge import FlexibleHinge
from .linked_inertia import LinkedInertia
from .lumped_inertia import LumpedInertia

FLEXIBLE: dict[str, type[FlexibleElement]] = {
    element.kind: element
    for element in (
        HellingerReissner,
        Helicoidal,
        Classical,
        Bushing,
        FlexibleHinge,
        Cable,
        LinkedInertia,
        LumpedInertia,
        CableInertia,
        Damping,
        DeadLoad,
        FollowerLoad,
    )
}

__all__ = [
    "FLEXIBLE",
    "FlexibleElement",
    *(element.__name__ for element in FLEXIBLE.values()),
]
