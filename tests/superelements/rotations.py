"""Rotations by quaternions (w, x, y, z) and rotation vectors; all accept complex steps."""

from __future__ import annotations

from typing import Any

import numpy as np

Array = Any
# columns: xx, xy, ..., zz of the matrix of a cross product
SKEW = np.zeros((3, 9))
SKEW[(0, 0, 1, 1, 2, 2), (7, 5, 2, 6, 3, 1)] = (1, -1, 1, -1, 1, -1)
SMALL = 1e-2  # squared angle up to which series are exact to the last digit
# of asin(s) / s and of the coefficient of the inverse tangent, by powers of the square
ARCSINE = (1, 1 / 6, 3 / 40, 15 / 336, 105 / 3456, 945 / 42240, 10395 / 599040)
TANGENT = (1 / 12, 1 / 720, 1 / 30240, 1 / 1209600, 1 / 47900160)


def skew(v: Array) -> Array:
    """(..., 3, 3): what turns a vector into the cross product with it."""
    v = np.asarray(v)
    return (v @ SKEW).reshape(*v.shape[:-1], 3, 3)


def cross(a: Array, b: Array) -> Array:
    """Cross product along the last axis."""
    return (skew(a) @ b[..., None])[..., 0]


def rotation(p: Array) -> Array:
    """Rotation matrix of a unit quaternion."""
    w, V = p[..., :1, None], skew(p[..., 1:])
    return np.eye(3) + 2 * (w * V + V @ V)


def product(a: Array, b: Array) -> Array:
    """Of two quaternions."""
    w = a[..., :1] * b[..., :1] - (a[..., 1:] * b[..., 1:]).sum(-1, keepdims=True)
    v = a[..., :1] * b[..., 1:] + b[..., :1] * a[..., 1:] + cross(a[..., 1:], b[..., 1:])
    return np.concatenate([w, v], -1)


def conjugate(p: Array) -> Array:
    return p * np.array([1.0, -1.0, -1.0, -1.0])


def exponential(th: Array) -> Array:
    """Quaternion of a rotation vector."""
    square = (th * th).sum(-1, keepdims=True) / 4
    small = np.abs(square) < 1e-16
    half = np.sqrt(np.where(small, 1.0, square))
    ratio = np.where(small, 1 - square / 6, np.sin(half) / half)
    cosine = np.where(small, 1 - square / 2, np.cos(half))
    return np.concatenate([cosine, 0.5 * ratio * th], -1)


def logarithm(p: Array) -> Array:
    """Rotation vector of a unit quaternion, of less than pi."""
    p = p * np.where(p[..., :1].real < 0, -1.0, 1.0)
    w, v = p[..., :1], p[..., 1:]
    square = (v * v).sum(-1, keepdims=True)
    small = np.abs(square) < SMALL / 4
    s = np.sqrt(np.where(small, 1.0, square))
    return 2 * v * np.where(small, power_series(ARCSINE, square), np.arctan(s / w) / s)


def left_inverse(th: Array) -> Array:
    """d log(exp(e) exp(th)) / de: change of a rotation vector by one from the left (..., 3, 3)."""
    square = (th * th).sum(-1)[..., None, None]
    small = np.abs(square) < SMALL
    angle = np.sqrt(np.where(small, 1.0, square))
    large = (1 - angle / 2 / np.tan(angle / 2)) / angle**2
    V = skew(th)
    return np.eye(3) - V / 2 + np.where(small, power_series(TANGENT, square), large) * (V @ V)


def power_series(coefficients: tuple[float, ...], x: Array) -> Array:
    total = 0.0
    for one in reversed(coefficients):
        total = total * x + one
    return total
