"""Parts that readers of robots share: mimicking joints, missing masses, frames."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import field

from ...errors import ModelWarning, warn
from ...records import dataclass
from ..body import Body
from ..frame import Place
from ..scene import SceneRecord
from .document import Element
from .pose import Pose, written

MAX_NAMED = 6  # links or joints in one note


class Remarks:
    """Sentences on links and joints; those that share one stand in one note."""

    def __init__(self) -> None:
        self._names: dict[tuple[str, str], list[str]] = {}

    def add(self, kind: str, name: str, what: str) -> None:
        """Say something of a ``"link"`` or ``"joint"``."""
        self._names.setdefault((kind, what), []).append(name)

    def notes(self) -> list[str]:
        """All of it, in the order in which it was said."""
        notes = []
        for (kind, what), names in self._names.items():
            listed = ", ".join(f"'{name}'" for name in names[:MAX_NAMED])
            more = f" and {len(names) - MAX_NAMED} more" if len(names) > MAX_NAMED else ""
            notes.append(f"{kind}{'s' if len(names) > 1 else ''} {listed}{more}: {what}")
        return notes


@dataclass
class Mimics:
    """Joints that follow others.

    Attributes:
        followed: False where all of them shall move freely.
        freed: Those.
        orphans: Followers of what is not a moving joint.
    """

    followed: bool
    freed: list[str] = field(default_factory=list)
    orphans: list[str] = field(default_factory=list)

    def couple(
        self, name: str, mimic: Element | None, leader: str, moving: Collection[str]
    ) -> tuple[str, float, float] | None:
        """Leader, ratio and offset for a joint, None where it moves freely.

        Args:
            name: The joint.
            mimic: Its <mimic>.
            leader: The joint that it follows.
            moving: Joints with a coordinate.
        """
        if mimic is None:
            return None
        if not self.followed:
            self.freed.append(name)
            return None
        if leader not in moving:
            self.orphans.append(f"{name} ({leader})")
            return None
        ratio, offset = mimic.number("multiplier", "1"), mimic.number("offset", "0")
        return leader, ratio, offset - ratio * mimic.number("reference", "0")

    def announce(self, notes: list[str], file: str) -> None:
        """Say which joints do not follow."""
        if self.orphans:
            lost = f"joints {', '.join(self.orphans)} mimic what is not a moving joint of the file"
            notes.append(f"{lost}; they move freely")
            warn(f"file '{file}': {notes[-1]}", ModelWarning)
        if self.freed:
            what = "mimic is not followed (mimic='free'); the joint moves freely"
            notes.append(f"joints {', '.join(self.freed)}: {what}")


def announce(scene: SceneRecord, names: Collection[str]) -> None:
    """Notes on names, angles and masses; a warning where a joint moves no mass.

    Args:
        names: Of the links.
    """
    if "ground_link" in scene.bodies and "ground" in names:
        scene.notes.append("link 'ground' is body 'ground_link': 'ground' is what does not move")
    if scene.snaps:
        scene.notes.append(f"{len(scene.snaps)} rounded angles were made exact; see Model.snaps")
    tips = _massless_tips(scene)
    if tips:
        text = f"bodies {', '.join(tips)}: nothing outboard of their joints has a mass"
        warn(f"{text}; forward dynamics divides by it", ModelWarning)


def _massless_tips(scene: SceneRecord) -> list[str]:
    """Links moved by a joint without any mass from there outward."""
    joints = [joint for joint in scene.joints.values() if not joint.cut]
    # the first joint of a body; further ones close loops
    order = {joint.child.body: joint for joint in reversed(joints)}
    heavy = {body for body in order if body.mass or any(body.inertia)}
    for body in list(heavy):
        inner = order[body].parent.body
        while inner in order and inner not in heavy:
            heavy.add(inner)
            inner = order[inner].parent.body
    return [
        joint.child.body.name
        for joint in joints
        if joint.kind.coordinates and joint.couple is None and joint.child.body not in heavy
    ]


def frame_at(body: Body, pose: Pose) -> Place:
    """A frame on a body; the body itself where it is its own."""
    turn = written(pose.rotation)
    if turn is None and not any(pose.position):
        return body
    return body.at(*pose.position, rotation=turn)


def body_name(link: str) -> str:
    """Name of the body of a link: its own, save for that of the ground."""
    return "ground_link" if link == "ground" else link
