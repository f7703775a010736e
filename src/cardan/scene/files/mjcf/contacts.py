"""Warning about contacts that MuJoCo would simulate: geoms support nothing here."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from ..document import Element

MAX_PRINTED = 4


class Geom(NamedTuple):
    """A geom that MuJoCo lets collide.

    Attributes:
        body, parent: Numbers of its body and of the parent of that; the parent of the world is -1.
        kind: Such as ``plane``.
        name: Its own, "" without one.
    """

    body: int
    parent: int
    kind: str
    name: str


def collides(geom: Element) -> bool:
    """True when a geom may touch others."""
    return bool(geom.number("contype", "1") or geom.number("conaffinity", "1"))


def notes(geoms: Sequence[Geom]) -> list[str]:
    """Floors and contacts that are not acted on, where there are any."""
    fixed = [one for one in geoms if one.parent < 0]
    moving = [one for one in geoms if one.parent >= 0]
    said = []
    if fixed and moving:
        names = [f"'{one.name}'" if one.name else one.kind for one in fixed[:MAX_PRINTED]]
        more = ", ..." if len(fixed) > MAX_PRINTED else ""
        said.append(f"floors and walls of the world ({', '.join(names)}{more}) hold nothing up")
    bodies = {one.body: one.parent for one in moving}
    # a body and its parent do not touch in MuJoCo either
    if any(a != b and bodies[a] != b and bodies[b] != a for a in bodies for b in bodies):
        said.append("bodies pass through each other")
    if not said:
        return []
    return [f"no contacts are read: {' and '.join(said)}; add cd.Contact where something touches"]
