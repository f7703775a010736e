"""The parametrizations of rotations, by the name a user writes."""

from ...errors import ModelError, near
from .quaternion import Quaternion
from .rotation import Rotation

ROTATIONS: dict[str, Rotation] = {r.name: r for r in (Quaternion(),)}


def parametrization(name: str, owner: str = "rotation") -> Rotation:
    """The parametrization of that name.

    Raises:
        ModelError: there is none.
    """
    found = ROTATIONS.get(name) if isinstance(name, str) else None
    if found is None:
        raise ModelError(
            f"{owner}: parametrization {name!r} does not exist; use one of these."
            + near(str(name), ROTATIONS)
        )
    return found
