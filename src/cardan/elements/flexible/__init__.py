"""The flexible elements, by kind."""

from .classical import Classical
from .damping import Damping
from .dead_load import DeadLoad
from .element import FlexibleElement
from .follower_load import FollowerLoad
from .gravity_field import GravityField
from .helicoidal import Helicoidal
from .hellinger_reissner import HellingerReissner
from .linked_inertia import LinkedInertia
from .loading import LoadElement
from .lumped_inertia import LumpedInertia

FLEXIBLE: dict[str, type[FlexibleElement]] = {
    element.kind: element
    for element in (
        HellingerReissner,
        Helicoidal,
        Classical,
        LinkedInertia,
        LumpedInertia,
        Damping,
        DeadLoad,
        FollowerLoad,
        GravityField,
    )
}

# what a beam may be made of, as scenes call it: elements with their options, and inertias
BEAMS: dict[str, FlexibleElement] = {
    element.name(): element
    for element in (
        HellingerReissner(),
        HellingerReissner(loaded=True),
        Helicoidal(),
        Classical(),
        Classical(residual_flexibility=False),
    )
}
LOADS: tuple[type[LoadElement], ...] = (DeadLoad, FollowerLoad)
INERTIAS: dict[str, FlexibleElement] = {"linked": LinkedInertia(), "lumped": LumpedInertia()}

__all__ = [
    "BEAMS",
    "FLEXIBLE",
    "INERTIAS",
    "LOADS",
    "FlexibleElement",
    *(element.__name__ for element in FLEXIBLE.values()),
]
