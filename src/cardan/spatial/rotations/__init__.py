"""The parametrizations of rotations, by the name a user writes."""

from ...errors import ModelError, brief, near
from .direction_cosines import DirectionCosines
from .euler_angles import SEQUENCES, EulerAngles
from .euler_rodrigues import EulerRodrigues
from .linear import Linear
from .modified_rodrigues import ModifiedRodrigues
from .quaternion import Quaternion
from .rodrigues import Rodrigues
from .rotation import Rotation
from .rotation_vector import RotationVector

ROTATIONS: dict[str, Rotation] = {
    rotation.name: rotation
    for rotation in (
        Quaternion(),
        *(EulerAngles(name) for name in SEQUENCES),
        Rodrigues(),
        ModifiedRodrigues("mrp", 1.0),
        ModifiedRodrigues("conformal", 4.0),
        EulerRodrigues(),
        RotationVector(),
        Linear(),
        DirectionCosines(),
    )
}


def parametrization(name: str, owner: str = "rotation") -> Rotation:
    """The parametrization of that name.

    Raises:
        ModelError: there is none.
    """
    rotation = ROTATIONS.get(name) if isinstance(name, str) else None
    if rotation is None:
        raise ModelError(
            f"{owner}: parametrization {brief(name)} does not exist; use one of these."
            + near(name, ROTATIONS)
        )
    return rotation


__all__ = ["ROTATIONS", "SEQUENCES", "Rotation", "parametrization"]
