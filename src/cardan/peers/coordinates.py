"""Trees whose coordinates other programs know, and the map to theirs."""

from __future__ import annotations

from collections.abc import Container, Sequence

import numpy as np

from ..api.comparison import SIZES, Convention, Coordinates, Pair, Scene, Sizes, paired

# joints that every program knows
COMMON = frozenset({"revolute", "prismatic", "spherical", "free"})


def refusal(scene: Scene, joints: Sequence[str], kinds: Container[str] = COMMON) -> str:
    """Why a tree cannot be handed to other programs, "" if it can.

    Args:
        joints: Their names, by body.
        kinds: Those that the program knows, of ``SIZES``.
    """
    for i, (name, kind) in enumerate(zip(joints, scene.kinds, strict=True)):
        if kind not in kinds:
            return f"joint '{name}' is {kind}"
        if kind in ("spherical", "free") and scene.rotations[i] != "quaternion":
            return f"joint '{name}' turns without a quaternion"
        if scene.leaders[i] >= 0:
            return f"joint '{name}' is coupled"
        if scene.prescribed[i]:
            return f"joint '{name}' is prescribed"
    if np.any(scene.numbers.get("rotor", np.zeros(1))):
        return "motors add inertia"
    return ""


def after_each_other(scene: Scene, order: Sequence[int]) -> list[tuple[int, int]]:
    """First entry of every body's joint in q and u of a program that numbers bodies so."""
    places, q, u = [(0, 0)] * len(order), 0, 0
    for body in order:
        places[body] = (q, u)
        nq, nu = SIZES[scene.kinds[body]]
        q, u = q + nq, u + nu
    return places


def coordinates(scene: Scene, how: Convention, places: Sequence[tuple[int, int]]) -> Coordinates:
    """The map for a program that has the same number of entries.

    Args:
        places: First entry of every body's joint in their q and u.
    """
    rows = zip(scene.kinds, scene.q, scene.u, places, strict=True)
    pairs = [Pair(kind, q[0], u[0], *place) for kind, q, u, place in rows]
    nq, nu = sum(q[1] for q in scene.q), sum(u[1] for u in scene.u)
    return paired(pairs, how, Sizes(nq, nu, nq, nu))
