"""Mechanisms with loops, each with a motion that it allows.

Joints that close loops are not marked: any joint may be cut. Coordinates and speeds are given
for every joint; those of cut joints are left out when a state is asked for.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Mapping
from dataclasses import dataclass

import numpy as np

import cardan as cd

from . import closed_planar as planar
from . import closed_spatial as spatial
from .closed_planar import andrews, four_bar, parallelogram, slider_crank
from .closed_spatial import bricard, delta, stewart
from .mechanism import State

__all__ = [
    "CLOSED",
    "Closed",
    "andrews",
    "bricard",
    "delta",
    "four_bar",
    "parallelogram",
    "slider_crank",
    "stewart",
]

# weights of the central difference of sixth order
DIFFERENCE = {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
STEP = 5e-3


@dataclass(frozen=True)
class Closed:
    """A mechanism with loops.

    Attributes:
        name: Name in test output.
        build: Makes the scene afresh.
        configuration: Coordinates of every joint along a motion that the loops allow.
        freedoms: Degrees of freedom along that motion.
        loops: Independent loops.
        redundant: Rank missing from its rows where every loop of joints is taken in space.
    """

    name: str
    build: Callable[[], cd.Scene]
    configuration: Callable[[float], Mapping[str, float | tuple[float, ...]]]
    freedoms: int
    circuits: int
    redundant: int

    def __repr__(self) -> str:
        return self.name

    def state(self, s: float, rate: float = 1.0, joints: Container[str] | None = None) -> State:
        """Coordinates at s and speeds at the given rate of s.

        Args:
            s: Where along the motion, about -0.8 to 0.8 everywhere.
            rate: ds/dt [1/s]; the speeds are differences along the motion, right to about 1e-12.
            joints: Those wanted, such as the joints with slots; all by default.
        """
        here = self.configuration(s)
        q, u = {}, {}
        for name, value in here.items():
            if joints is not None and name not in joints:
                continue
            slope = sum(
                weight * (self._at(s + k * STEP, name) - self._at(s - k * STEP, name))
                for k, weight in DIFFERENCE.items()
            )
            speeds = np.asarray(slope) / STEP * rate
            if speeds.size >= 4:
                turning = _body_rate(np.atleast_1d(value)[:4], speeds[:4])
                speeds = np.concatenate([turning, speeds[4:]])
            q[name] = value
            u[name] = float(speeds) if speeds.ndim == 0 else tuple(speeds.tolist())
        return State(q, u)

    def _at(self, s: float, joint: str) -> np.ndarray:
        return np.asarray(self.configuration(s)[joint])


def _body_rate(q: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """Angular velocity in child axes of a quaternion and its derivative."""
    w, v = q[0], q[1:]
    return 2 * (w * rate[1:] - rate[0] * v - np.cross(v, rate[1:]))


CLOSED: dict[str, Closed] = {
    member.name: member
    for member in (
        Closed("four_bar", four_bar, lambda s: planar.four_bar_angles(1 + s), 1, 1, 3),
        Closed(
            "slider_crank", slider_crank, lambda s: planar.slider_crank_coordinates(1 + s), 1, 1, 3
        ),
        Closed(
            "parallelogram",
            parallelogram,
            lambda s: planar.parallelogram_angles(math.pi / 2 + s),
            1,
            2,
            6,
        ),
        Closed("andrews", andrews, lambda s: planar.andrews_angles(s), 1, 3, 9),
        Closed("bricard", bricard, lambda s: spatial.bricard_angles(0.2 + 0.4 * s), 1, 1, 1),
        Closed("stewart", stewart, spatial.stewart_coordinates, 6, 5, 0),
        Closed("delta", delta, spatial.delta_coordinates, 3, 2, 0),
    )
}
