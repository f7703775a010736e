"""Facts about a tree of bodies that several peers need."""

from __future__ import annotations

import numpy as np

from ..api.comparison import Scene
from ..arrays import Array


def depth_first(scene: Scene) -> list[int]:
    """Bodies so that every subtree stands together."""
    children: dict[int, list[int]] = {}
    for body, parent in enumerate(scene.parents):
        children.setdefault(parent, []).append(body)
    order: list[int] = []
    waiting = children.get(-1, [])[::-1]
    while waiting:
        body = waiting.pop()
        order.append(body)
        waiting += children.get(body, [])[::-1]
    return order


def central(scene: Scene) -> tuple[Array, Array]:
    """Centers of mass (nb, 3) and inertias about them (nb, 3, 3)."""
    mass, first = scene.numbers["mass"], scene.numbers["first_moment"]
    com = np.divide(first, mass[:, None], out=np.zeros_like(first), where=mass[:, None] != 0)
    square = np.einsum("i,ij,ij->i", mass, com, com)[:, None, None] * np.eye(3)
    shift = square - np.einsum("i,ij,ik->ijk", mass, com, com)
    return com, scene.numbers["inertia"] - shift


def directions(scene: Scene, which: str = "axis") -> Array:
    """Unit vectors of the axes of joints (nb, 3), 0 where there is none.

    Args:
        which: ``axis2`` for the second ones.
    """
    axis = scene.numbers[which]
    length = np.linalg.norm(axis, axis=1, keepdims=True)
    return np.asarray(axis / np.where(length > 0, length, 1.0))
