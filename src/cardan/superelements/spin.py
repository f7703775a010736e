"""With which frequency the spin of a component compares: the lowest with an interface fixed."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..errors import SolveError
from .record import SuperelementRecord


@dataclass(frozen=True, eq=False)
class SpinScale:
    """What centrifugal forces of a spin w compare with.

    They are those of w^T J w and stiffen a component across the axis; about the axis of a shaft
    they are small.

    Attributes:
        interface: That is fixed.
        frequency: The lowest one then [rad/s]; 0 where nothing deforms.
        inertia: About the interface, over its largest principal moment, J (3, 3).
    """

    interface: str
    frequency: float
    inertia: Array


def spin_scale(record: SuperelementRecord, interfaces: Collection[str]) -> SpinScale:
    """The scale of a component that one of some interfaces holds, the one which does least.

    Args:
        record: The component.
        interfaces: Their names.
    """
    lowest = {name: _first_frequency(record, name) for name in interfaces}
    # one that leaves nothing to deform is slower than none
    name = min(interfaces, key=lambda one: lowest[one] or np.inf)
    properties = record.properties
    arm = np.array(properties.center) - record.interface(name).position
    steiner = properties.mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    inertia = np.array(properties.inertia) + steiner
    largest = float(np.linalg.eigvalsh(inertia)[-1])
    return SpinScale(name, lowest[name], inertia / largest if largest > 0 else 0 * inertia)


def _first_frequency(record: SuperelementRecord, interface: str) -> float:
    """The lowest frequency with an interface fixed [rad/s], 0 where there is none."""
    try:
        omega = record.modes([interface]).frequencies
    except SolveError:
        # the stiffness of a component on supports may be that of one that buckles
        return 0.0
    return float(omega[0]) if len(omega) else 0.0
