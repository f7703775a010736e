"""How every kind of joint moves, in NumPy, for the judge of every build.

The motion of each kind is written down once more, where it can by another route than in the
catalogue; nothing of spatial, elements or equations is used.

Source: Roberson, Schwertassek, Dynamics of Multibody Systems, chapters 4 and 8.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .circle_means import ROUND, Pose, means_of, settled
from .joint_curve import Curve
from .rotations import PARAMETERS, about, quaternion

Array = NDArray[Any]
# before the kind of a joint whose child carries its parent
REVERSED = "reversed "
CUSTOM = "custom"


@dataclass(frozen=True)
class Told:
    """What is known about one joint.

    Attributes:
        kind: Its kind, after ``REVERSED`` where the declared child carries the parent.
        rotation: Parametrization of its rotation, None without one.
        axis, axis2: Directions of the joint (3,); 0 where it has none.
        pitch: Displacement per angle.
        sizes: Lengths of the kind (2,): of a rod, or radius and crown of a wheel.
        curve: Of a point on a curve.
        pose: Of a joint of the user's own.
    """

    kind: str
    rotation: str | None
    axis: Array
    axis2: Array
    pitch: float
    sizes: Array
    curve: Curve | None = None
    pose: Pose | None = None


@dataclass(frozen=True)
class JointMotion:
    """Motion of a joint frame C against its parent-side frame J, for states (...).

    Attributes:
        rotation: (..., 3, 3), axes C to axes J.
        position: (..., 3), in J.
        turn: Angular velocity per speed, columns in axes C, (..., 3, n).
        shift: Velocity per speed, columns in axes J, (..., 3, n).
        turn_rate: What the derivative of ``turn`` adds to the angular acceleration, (..., 3).
        shift_rate: What the derivative of ``shift`` adds to the acceleration, (..., 3).
    """

    rotation: Array
    position: Array
    turn: Array
    shift: Array
    turn_rate: Array
    shift_rate: Array


def cross(a: Array, b: Array) -> Array:
    """a x b over leading axes."""
    return np.asarray(a[..., [1, 2, 0]] * b[..., [2, 0, 1]] - a[..., [2, 0, 1]] * b[..., [1, 2, 0]])


def normalized(v: Array) -> Array:
    """v / |v|."""
    return np.asarray(v / np.linalg.norm(v))


def times(matrix: Array, vector: Array) -> Array:
    """Matrix times vector over leading axes."""
    return np.asarray((matrix @ vector[..., None])[..., 0])


def joint_motion(told: Told, q: Array, u: Array) -> JointMotion:
    """How a joint moves; the coordinates may be complex.

    Args:
        told: The joint.
        q, u: Its own coordinates and speeds, (..., n).
    """
    if told.kind.startswith(REVERSED):
        declared = Told(told.kind.removeprefix(REVERSED), *list(vars(told).values())[1:])
        return _backwards(joint_motion(declared, q, u), u)
    return MOTIONS[told.kind](told, q, u)


def _motion(
    q: Array,
    turn: Array,
    shift: Array,
    rotation: Array | None = None,
    position: Array | None = None,
    turn_rate: Array | None = None,
    shift_rate: Array | None = None,
) -> JointMotion:
    """What is left out is no motion."""
    none = np.zeros((*q.shape[:-1], 3))
    still = np.broadcast_to(np.eye(3), (*q.shape[:-1], 3, 3))
    return JointMotion(
        still if rotation is None else rotation,
        none if position is None else position,
        turn,
        shift,
        none if turn_rate is None else turn_rate,
        none if shift_rate is None else shift_rate,
    )


def _backwards(forth: JointMotion, u: Array) -> JointMotion:
    """The motion of the declared parent against the child: J seen from C."""
    back = np.swapaxes(forth.rotation, -1, -2)
    turned, p = forth.rotation @ forth.turn, forth.position
    # rates in J of the place and of the turning, then as an observer in C sees them
    w, v = times(turned, u), times(forth.shift, u)
    w_rate = times(forth.rotation, forth.turn_rate)
    seen = forth.shift_rate - cross(w_rate, p) - 2 * cross(w, v) + cross(w, cross(w, p))
    columns = np.swapaxes(cross(np.swapaxes(turned, -1, -2), p[..., None, :]), -1, -2)
    return JointMotion(
        rotation=back,
        position=-times(back, p),
        turn=-turned,
        shift=-(back @ (forth.shift - columns)),
        turn_rate=-w_rate,
        shift_rate=-times(back, seen),
    )


def _column(v: Array) -> Array:
    return normalized(v)[:, None]


ZERO = np.zeros((3, 1))


def _revolute(told: Told, q: Array, u: Array) -> JointMotion:
    return _motion(q, _column(told.axis), ZERO, about(normalized(told.axis), q[..., 0]))


def _prismatic(told: Told, q: Array, u: Array) -> JointMotion:
    return _motion(q, ZERO, _column(told.axis), position=q[..., :1] * normalized(told.axis))


def _cylindrical(told: Told, q: Array, u: Array) -> JointMotion:
    a, column = normalized(told.axis), _column(told.axis)
    turn, shift = np.hstack([column, ZERO]), np.hstack([ZERO, column])
    return _motion(q, turn, shift, about(a, q[..., 0]), q[..., 1:2] * a)


def _screw(told: Told, q: Array, u: Array) -> JointMotion:
    a = normalized(told.axis)
    lift = told.pitch * a
    return _motion(q, a[:, None], lift[:, None], about(a, q[..., 0]), q[..., :1] * lift)


def _universal(told: Told, q: Array, u: Array) -> JointMotion:
    """First about axis, fixed in the parent, then about axis2, fixed in the child."""
    a, b = normalized(told.axis), normalized(told.axis2)
    second = about(b, q[..., 1])
    first = np.swapaxes(second, -1, -2) @ a
    turn = np.stack([first, np.broadcast_to(b, first.shape)], axis=-1)
    # the first axis is seen to turn backwards from the child
    rate = -cross(b * u[..., 1:2], first) * u[..., :1]
    return _motion(q, turn, np.zeros((3, 2)), about(a, q[..., 0]) @ second, turn_rate=rate)


def _constant_velocity(told: Told, q: Array, u: Array) -> JointMotion:
    """The unit quaternion (w, v) whose vector lies across the shaft, and its derivatives."""
    first, second = _across(told)
    c, s = np.cos(q / 2), np.sin(q / 2)
    w = c[..., 0] * c[..., 1]
    v = (s[..., 0] * c[..., 1])[..., None] * first + s[..., 1:] * second
    slopes = [
        (-s[..., 0] * c[..., 1] / 2, (c[..., 0] * c[..., 1])[..., None] / 2 * first),
        (
            -c[..., 0] * s[..., 1] / 2,
            (-s[..., 0] * s[..., 1])[..., None] / 2 * first + c[..., 1:] / 2 * second,
        ),
    ]

    def spin(dw: Array, dv: Array) -> Array:
        return np.asarray(2 * (w[..., None] * dv - dw[..., None] * v - cross(v, dv)))

    turn = np.stack([spin(dw, dv) for dw, dv in slopes], axis=-1)
    # second derivatives along the speeds: both coordinates enter as cosines and sines of halves
    a, b = u[..., 0], u[..., 1]
    both, mixed = -(a * a + b * b) / 4, a * b / 2
    ddw = both * w + mixed * s[..., 0] * s[..., 1]
    along = both * s[..., 0] * c[..., 1] - mixed * c[..., 0] * s[..., 1]
    ddv = along[..., None] * first - (b * b / 4 * s[..., 1])[..., None] * second
    whole = np.concatenate([w[..., None], v], axis=-1)
    shift = np.zeros((3, 2))
    return _motion(q, turn, shift, quaternion(whole), turn_rate=spin(ddw, ddv))


def _across(told: Told) -> tuple[Array, Array]:
    """The two directions across the axis."""
    first = normalized(told.axis2)
    return first, cross(normalized(told.axis), first)


def _planar(told: Told, q: Array, u: Array) -> JointMotion:
    """Two displacements in the plane, then a turn about its normal."""
    plane = np.stack(_across(told), axis=-1)
    turn = np.hstack([np.zeros((3, 2)), _column(told.axis)])
    place = times(plane, q[..., :2])
    return _motion(
        q, turn, np.hstack([plane, ZERO]), about(normalized(told.axis), q[..., 2]), place
    )


def _spherical(told: Told, q: Array, u: Array) -> JointMotion:
    return _guided(told, q, np.zeros((*q.shape[:-1], 3)), np.zeros((3, 0)))


def _free(told: Told, q: Array, u: Array) -> JointMotion:
    return _guided(told, q, q[..., -3:], np.eye(3))


def _point_on_plane(told: Told, q: Array, u: Array) -> JointMotion:
    plane = np.stack(_across(told), axis=-1)
    return _guided(told, q, times(plane, q[..., -2:]), plane)


def _point_on_curve(told: Told, q: Array, u: Array) -> JointMotion:
    curve, s, rate = told.curve, q[..., -1], u[..., -1:]
    if curve is None:
        raise ValueError("a point on a curve needs the curve")
    slope = curve.at(s, 1)[..., None]
    return _guided(told, q, curve.at(s, 0), slope, curve.at(s, 2) * rate * rate)


def _distance(told: Told, q: Array, u: Array) -> JointMotion:
    """The rod turns about the second direction across its axis, then about the first."""
    first, second = _across(told)
    outer = about(first, q[..., -2])
    hinge = times(outer, second)
    rod = times(outer, times(about(second, q[..., -1]), told.sizes[0] * normalized(told.axis)))
    slopes = np.stack([cross(np.broadcast_to(first, rod.shape), rod), cross(hinge, rod)], axis=-1)
    # a point that turns with w, which itself turns
    outer_spin, inner_spin = u[..., -2:-1] * first, u[..., -1:] * hinge
    w = outer_spin + inner_spin
    bend = cross(w, cross(w, rod)) + cross(cross(outer_spin, inner_spin), rod)
    return _guided(told, q, rod, slopes, bend)


def _guided(
    told: Told, q: Array, place: Array, slope: Array, bend: Array | None = None
) -> JointMotion:
    """A free rotation about a point that moves with the last coordinates."""
    parameters, k = PARAMETERS[told.rotation or ""], slope.shape[-1]
    rotation = parameters.matrix(q[..., : parameters.size])
    turn = np.hstack([np.eye(3), np.zeros((3, k))])
    shift = np.concatenate([np.zeros((*slope.shape[:-1], 3)), slope], axis=-1)
    return _motion(q, turn, shift, rotation, place, shift_rate=bend)


def _rolling(told: Told, q: Array, u: Array) -> JointMotion:
    """A torus on a plane: it yaws about the normal, leans about its heading, and spins."""
    n, (x, y) = normalized(told.axis), _across(told)
    yaw = about(n, q[..., 2])
    tilted = yaw @ about(x, q[..., 3])
    rotation = tilted @ about(y, q[..., 4])
    heading, axle = times(yaw, x), times(tilted, y)
    normal = np.broadcast_to(n, heading.shape)
    up = (told.sizes[0] - told.sizes[1]) * times(tilted, n)
    place = q[..., :1] * x + q[..., 1:2] * y + told.sizes[1] * n + up
    back, none = np.swapaxes(rotation, -1, -2), np.zeros_like(heading)
    turn = back @ np.stack([none, none, normal, heading, axle], axis=-1)
    flat = [np.broadcast_to(v, heading.shape) for v in (x, y)]
    shift = np.stack([*flat, cross(normal, up), cross(heading, up), none], axis=-1)
    # rates of the directions that turn
    yawing, leaning = u[..., 2:3] * n, u[..., 3:4] * heading
    w, w_rate = yawing + leaning, cross(yawing, leaning)
    turn_rate = times(back, w_rate + cross(w, u[..., 4:] * axle))
    bend = cross(w, cross(w, up)) + cross(w_rate, up)
    return _motion(q, turn, shift, rotation, place, turn_rate, bend)


def _fixed(told: Told, q: Array, u: Array) -> JointMotion:
    return _motion(q, np.zeros((3, 0)), np.zeros((3, 0)))


# imaginary parts below are a complex step
ASIDE = 1e-9


def _custom(told: Told, q: Array, u: Array) -> JointMotion:
    """By the pose alone: derivatives are means over circles, as Cauchy has them."""
    pose = told.pose
    if pose is None:
        raise ValueError("a joint of the user's own needs its pose")
    if np.iscomplexobj(q) and (step := float(np.abs(q.imag).max(initial=0.0))) < ASIDE:
        return _stepped(told, q, u, step)
    lead, n = np.broadcast_shapes(q.shape[:-1], u.shape[:-1]), q.shape[-1]
    q, u = (np.broadcast_to(x, (*lead, n)) for x in (q, u))
    ways = np.concatenate([np.broadcast_to(np.eye(n), (*lead, n, n)), u[..., None, :]], axis=-2)
    turned, placed = pose(q.reshape(-1, n).astype(complex))
    R, p = turned.reshape(*lead, 3, 3), placed.reshape(*lead, 3)
    slopes = settled(lambda radius: means_of(pose, q, ways, radius), lead)
    first, second = np.moveaxis(slopes.reshape(*lead, 2, n + 1, 12), -3, 0)
    if not np.iscomplexobj(q):
        R, p, first, second = R.real, p.real, first.real, second.real
    back = np.swapaxes(R, -1, -2)
    turns = first[..., :n, :9].reshape(*lead, n, 3, 3)
    turn = np.moveaxis(_axial(back[..., None, :, :] @ turns), -2, -1)
    bend = _axial(back @ second[..., n, :9].reshape(*lead, 3, 3))
    shift = np.moveaxis(first[..., :n, 9:], -2, -1)
    return _motion(q, turn, shift, R, p, bend, second[..., n, 9:])


def _stepped(told: Told, q: Array, u: Array, step: float) -> JointMotion:
    """As :func:`_custom` a complex step aside, which the rounding of means would drown."""
    still = vars(_custom(told, q.real, u))
    if step == 0:
        return JointMotion(**still)
    # none of its points is a small step aside again
    circle = [c.real if abs(c.imag) < ASIDE else c for c in ROUND]

    def means(radius: float) -> tuple[Array, Array]:
        around = [vars(_custom(told, q.real + radius * c * (q.imag / step), u)) for c in circle]
        flat = [np.concatenate([found[name].ravel() for name in still]) for found in around]
        parts = np.real(np.array(flat) / ROUND[:, None])
        return parts.mean(axis=0) / radius, parts[::2].mean(axis=0) / radius

    slopes, ends = settled(means, ()), np.cumsum([x.size for x in still.values()])
    pairs = zip(still.items(), np.split(slopes, ends[:-1]), strict=True)
    return JointMotion(**{k: x + 1j * step * part.reshape(x.shape) for (k, x), part in pairs})


def _axial(m: Array) -> Array:
    """What a matrix turns with: of its skew part."""
    pairs = ((2, 1), (0, 2), (1, 0))
    return np.asarray(np.stack([m[..., i, j] - m[..., j, i] for i, j in pairs], axis=-1) / 2)


MOTIONS: Mapping[str, Callable[[Told, Array, Array], JointMotion]] = {
    "fixed": _fixed,
    "revolute": _revolute,
    "gear": _revolute,
    "prismatic": _prismatic,
    "cylindrical": _cylindrical,
    "screw": _screw,
    "universal": _universal,
    "constant_velocity": _constant_velocity,
    "spherical": _spherical,
    "planar": _planar,
    "free": _free,
    "point_on_plane": _point_on_plane,
    "point_on_curve": _point_on_curve,
    "distance": _distance,
    "wheel": _rolling,
    "rolling_disk": _rolling,
    CUSTOM: _custom,
}
KINDS: Sequence[str] = tuple(MOTIONS)
# kinds that turn freely about a guided point, described by any parametrization of rotations
GUIDED = ("spherical", "free", "point_on_plane", "point_on_curve", "distance")
SPEEDS: Mapping[str, int] = {
    "fixed": 0,
    **dict.fromkeys(("revolute", "gear", "prismatic", "screw"), 1),
    **dict.fromkeys(("cylindrical", "universal", "constant_velocity"), 2),
    **dict.fromkeys(("spherical", "planar"), 3),
    "point_on_curve": 4,
    **dict.fromkeys(("point_on_plane", "distance", "wheel", "rolling_disk"), 5),
    "free": 6,
}
