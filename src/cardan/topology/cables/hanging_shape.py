"""The shape in which a cable of straight elements hangs between two points."""

from __future__ import annotations

import numpy as np

from ...arrays import Array

MAX_ITERATIONS, TOLERANCE = 200, 1e-13
# weight against stiffness that gives a slack cable without gravity a shape
FAINT = 1e-9


def hanging(
    start: Array, end: Array, length: float, stiffness: float, weight: Array, elements: int
) -> Array:
    """Nodes (elements + 1, 3) of a cable in equilibrium, weight in its nodes.

    The force in its first part makes the complementary energy least, ``sum (L/n)(|F_k| + F_k² / 2
    EA) - F (end - start)``, which is convex: Newton's method with halved steps finds it.

    Args:
        start, end: Where it is held (3) [m].
        length: Without load [m].
        stiffness: EA [N].
        weight: Of the cable (3) [N].
        elements: Their number.

    Source: Irvine, Cable Structures (1981), chapter 1; the discrete form is our own.
    """
    span = end - start
    distance = float(np.linalg.norm(span))
    if elements == 1 or (length <= distance and not weight.any()):
        straight: Array = start + np.linspace(0, 1, elements + 1)[:, None] * span
        return straight
    if not weight.any():
        # it sags to a side that is none other than another
        across = np.cross(span, np.eye(3)[np.argmin(np.abs(span))])
        size = float(np.linalg.norm(across))
        down = across / size if size > 0 else np.array([0.0, 0.0, -1.0])
        weight = FAINT * stiffness * down
    force = _first_force(span, length / elements, stiffness, weight / elements, elements)
    steps = _steps(force, length / elements, stiffness, weight / elements, elements)
    nodes = np.vstack([np.zeros(3), np.cumsum(steps, axis=0)])
    # a part without load at the bottom of a loop straight down is what is missing
    ends_at: Array = start + nodes + np.linspace(0, 1, elements + 1)[:, None] * (span - nodes[-1])
    return ends_at


def _forces(force: Array, weight: Array, elements: int) -> Array:
    """Pulls of the elements (elements, 3): each carries what hangs behind it."""
    return force - np.arange(elements)[:, None] * weight


def _steps(force: Array, part: float, stiffness: float, weight: Array, elements: int) -> Array:
    """From node to node."""
    forces = _forces(force, weight, elements)
    sizes = np.linalg.norm(forces, axis=1, keepdims=True)
    steps: Array = part * forces * (1 / np.maximum(sizes, 1e-300) + 1 / stiffness)
    return steps


def _first_force(span: Array, part: float, stiffness: float, weight: Array, elements: int) -> Array:
    """Pull of the first part (3) that leads from start to end."""
    load = float(np.linalg.norm(weight))
    # half of the weight hangs on each end
    force = (
        weight * (elements - 1) / 2 + span / np.linalg.norm(span) * load
        if span.any()
        else (weight * (elements - 1) / 2 + load * np.eye(3)[np.argmin(np.abs(weight))])
    )
    smooth = 1e-9 * load

    def energy(f: Array) -> float:
        sizes = np.sqrt((_forces(f, weight, elements) ** 2).sum(axis=1) + smooth**2)
        return float(part * (sizes + sizes**2 / (2 * stiffness)).sum() - f @ span)

    scale = part * elements
    for _ in range(MAX_ITERATIONS):
        forces = _forces(force, weight, elements)
        sizes = np.sqrt((forces**2).sum(axis=1) + smooth**2)
        slope = part * (forces * (1 / sizes + 1 / stiffness)[:, None]).sum(axis=0) - span
        if np.abs(slope).max() <= TOLERANCE * scale:
            break
        directions = forces / sizes[:, None]
        bend = part * (
            np.eye(3) * (1 / sizes + 1 / stiffness).sum()
            - np.einsum("ki,kj,k->ij", directions, directions, 1 / sizes)
        )
        step, share, before = -np.linalg.solve(bend, slope), 1.0, energy(force)
        while energy(force + share * step) > before + 1e-4 * share * float(slope @ step):
            share /= 2
            if share < 1e-12:
                return force
        force = force + share * step
    return force
