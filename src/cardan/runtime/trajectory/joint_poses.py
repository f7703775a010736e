"""Poses of joints by their kind, in plain numbers: saved runs hold no expressions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...records import dataclass
from ...schema.manifest import Manifest
from ..verification.joint_motion import REVERSED, JointData, Pose, cross, joint_data, times
from ..verification.rotations import PARAMETERS, about, quaternion

Array = NDArray[Any]


@dataclass(frozen=True)
class KindNumbers:
    """Numbers of one joint.

    Attributes:
        rotation: Parametrization of its rotation, None without one.
        axis, axis2: Directions of the joint (3,); 0 where it has none.
        pitch: Displacement per angle.
        sizes: Lengths of the kind (2,): of a rod, or radius and crown of a wheel.
        curve: Of a point on a curve.
    """

    rotation: str | None
    axis: Array
    axis2: Array
    pitch: float = 0.0
    sizes: Array | tuple[float, float] = (0.0, 0.0)
    curve: Curve | None = None

    @property
    def along(self) -> Array:
        """The unit axis."""
        return normalized(self.axis)

    @property
    def across(self) -> tuple[Array, Array]:
        """The two directions across the axis."""
        first = normalized(self.axis2)
        return first, cross(self.along, first)


@dataclass(frozen=True)
class Curve:
    """A piecewise polynomial in space.

    Attributes:
        breaks: Ends of the pieces, (n + 1,).
        coefficients: Highest power of the distance from the left end first, by component and
            piece, (3, n, k).
        period: After which it comes round again, 0 where it does not.
    """

    breaks: Array
    coefficients: Array
    period: float = 0.0

    def at(self, s: Array) -> Array:
        """Its points, (..., 3)."""
        if self.period:
            s = s - self.period * np.floor(s.real / self.period)
        segment = np.clip(np.searchsorted(self.breaks, s.real) - 1, 0, len(self.breaks) - 2)
        step, total = s - self.breaks[segment], np.zeros((*s.shape, 3))
        for power in np.moveaxis(self.coefficients[:, segment], -1, 0):
            total = total * step[..., None] + np.moveaxis(power, 0, -1)
        return np.asarray(total)


KindPose = Callable[[KindNumbers, Array], tuple[Array, Array]]


def normalized(v: Array) -> Array:
    """v / |v|."""
    return np.asarray(v / np.linalg.norm(v))


def joints_of(manifest: Manifest, numbers: Mapping[str, Array]) -> list[JointData]:
    """The joints of a saved run: by the kinds in its manifest and the numbers of its scene."""
    scene, count = manifest.scene, len(manifest.joints)
    none, curves = np.zeros((count, 3)), scene.curves or [None] * count
    axis2, sizes = numbers.get("axis2", none), numbers.get("sizes", none[:, :2])
    joints = []
    for i, (kind, rotation, curve) in enumerate(
        zip(scene.kinds, scene.rotations, curves, strict=True)
    ):
        line = Curve(np.array(curve[0]), np.array(curve[1]), curve[2]) if curve else None
        pitch, axis = float(numbers["pitch"][i]), numbers["axis"][i]
        numbers_of_kind = KindNumbers(rotation, axis, axis2[i], pitch, sizes[i], line)
        joints.append(
            joint_data(pose_of(kind.removeprefix(REVERSED), numbers_of_kind), kind, rotation)
        )
    return joints


def pose_of(kind: str, numbers: KindNumbers) -> Pose:
    """The pose of a joint of a kind of :data:`POSES`."""
    return lambda q: POSES[kind](numbers, q)


def _still(q: Array) -> Array:
    return np.broadcast_to(np.eye(3), (len(q), 3, 3))


def _none(q: Array) -> Array:
    return np.zeros((len(q), 3))


def _revolute(j: KindNumbers, q: Array) -> tuple[Array, Array]:
    return about(j.along, q[:, 0]), _none(q)


def _cylindrical(j: KindNumbers, q: Array) -> tuple[Array, Array]:
    return about(j.along, q[:, 0]), q[:, 1:] * j.along


def _screw(j: KindNumbers, q: Array) -> tuple[Array, Array]:
    return about(j.along, q[:, 0]), q * (j.pitch * j.along)


def _universal(j: KindNumbers, q: Array) -> tuple[Array, Array]:
    """First about axis, fixed in the parent, then about axis2, fixed in the child."""
    return about(j.along, q[:, 0]) @ about(normalized(j.axis2), q[:, 1]), _none(q)


def _constant_velocity(j: KindNumbers, q: Array) -> tuple[Array, Array]:
    """The unit quaternion whose vector lies across the shaft."""
    first, second = j.across
    c, s = np.cos(q / 2), np.sin(q / 2)
    v = (s[:, 0] * c[:, 1])[:, None] * first + s[:, 1:] * second
    return quaternion(np.concatenate([(c[:, 0] * c[:, 1])[:, None], v], axis=-1)), _none(q)


def _planar(j: KindNumbers, q: Array) -> tuple[Array, Array]:
    """Two displacements in the plane, then a turn about its normal."""
    return about(j.along, q[:, 2]), q[:, :2] @ np.stack(j.across)


def _rolling(j: KindNumbers, q: Array) -> tuple[Array, Array]:
    """A torus on a plane: it yaws about the normal, leans about its heading, and spins."""
    n, (x, y), (radius, crown) = j.along, j.across, j.sizes
    tilted = about(n, q[:, 2]) @ about(x, q[:, 3])
    up = (radius - crown) * times(tilted, n)
    return tilted @ about(y, q[:, 4]), q[:, :2] @ np.stack([x, y]) + crown * n + up


def _guided(place: Callable[[KindNumbers, Array], Array]) -> KindPose:
    """A free rotation about a point that moves with the last coordinates."""

    def pose(j: KindNumbers, q: Array) -> tuple[Array, Array]:
        parameters = PARAMETERS[j.rotation or ""]
        n = parameters.size
        return parameters.matrix(q[:, :n]), place(j, q[:, n:])

    return pose


def _on_curve(j: KindNumbers, c: Array) -> Array:
    if j.curve is None:
        raise ValueError("a point on a curve needs the curve")
    return j.curve.at(c[:, 0])


def _rod(j: KindNumbers, c: Array) -> Array:
    """The rod turns about the second direction across its axis, then about the first."""
    first, second = j.across
    return times(about(first, c[:, 0]) @ about(second, c[:, 1]), j.sizes[0] * j.along)


POSES: Mapping[str, KindPose] = {
    "fixed": lambda j, q: (_still(q), _none(q)),
    "revolute": _revolute,
    "gear": _revolute,
    "prismatic": lambda j, q: (_still(q), q * j.along),
    "cylindrical": _cylindrical,
    "screw": _screw,
    "universal": _universal,
    "constant_velocity": _constant_velocity,
    "spherical": _guided(lambda j, c: _none(c)),
    "planar": _planar,
    "translation": lambda j, q: (_still(q), q),
    "free": _guided(lambda j, c: c),
    "point_on_plane": _guided(lambda j, c: c @ np.stack(j.across)),
    "point_on_curve": _guided(_on_curve),
    "distance": _guided(_rod),
    "wheel": _rolling,
    "rolling_disk": _rolling,
}
