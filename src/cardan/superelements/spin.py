"""The frequency with which a spin is compared: the first with an interface fixed."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from ..arrays import Array
from ..errors import SolveError
from ..records import dataclass
from .record import SuperelementRecord

EQUAL = 1 + 1e-6  # frequencies up to this ratio are the same, of symmetric components


@dataclass(frozen=True, eq=False)
class SpinScale:
    """Frequency and inertia that say whether a spin w stiffens a component.

    Centrifugal forces are of the size of w^T J w: large where a slender body spins across its axis,
    small where a shaft turns about it.

    Attributes:
        interface: Name of the one that is fixed.
        frequency: The lowest with it fixed [rad/s]; 0 where nothing deforms.
        inertia: J (3, 3) about the interface, over its largest principal moment.
    """

    interface: str
    frequency: float
    inertia: Array


def spin_scale(record: SuperelementRecord, interfaces: Collection[str]) -> SpinScale:
    """The scale with one of some interfaces fixed: the one that gives the lowest frequency.

    Args:
        record: The component.
        interfaces: Their names.
    """
    lowest = {name: _first_frequency(record, name) for name in interfaces}
    # 0 says that nothing deforms: it is not the softest; of equal ones take the first
    softest = min(filter(None, lowest.values()), default=0.0)
    name = next(one for one in interfaces if softest <= lowest[one] <= EQUAL * softest)
    properties = record.properties
    arm = np.array(properties.center) - record.interface(name).position
    steiner = properties.mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    inertia = np.array(properties.inertia) + steiner
    largest = float(np.linalg.eigvalsh(inertia)[-1])
    return SpinScale(name, softest, inertia / largest if largest > 0 else 0 * inertia)


def _first_frequency(record: SuperelementRecord, interface: str) -> float:
    """The lowest frequency with an interface fixed [rad/s], 0 where there is none."""
    try:
        omega = record.modes([interface]).frequencies
    except SolveError:
        # the stiffness of a component on supports may be that of one that buckles
        return 0.0
    return float(omega[0]) if len(omega) else 0.0
