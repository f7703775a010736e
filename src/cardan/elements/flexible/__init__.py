"""The flexible elements, by kind."""

from .bushing import Bushing
from .classical import Classical
from .damping import Damping
from .dead_load import DeadLoad
from .element import FlexibleElement
from .follower_load import FollowerLoad
from .helicoidal import Helicoidal
from .hellinger_reissner import HellingerReissner
from .linked_inertia import LinkedInertia
from .lumped_inertia import LumpedInertia

FLEXIBLE: dict[str, type[FlexibleElement]] = {
    element.kind: element
    for element in (
        HellingerReissner,
        Helicoidal,
        Classical,
        Bushing,
        LinkedInertia,
        LumpedInertia,
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
