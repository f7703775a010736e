"""Bodies as solids: the user's shapes, else links between the joints and a ball where mass is."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..records import dataclass
from ..runtime.trajectory.frame_history import bodies_in_place, inverse, is_recorded
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..schema.manifest import Manifest
from ..schema.mechanism import BodyRow, ShapeRow
from .packing import JsonObject, below_one

# as a page has it
Solid = JsonObject
Links = dict[str, list[tuple[Array, Array]]]
THICK = 0.055  # radius of a drawn link, relative to the mean length of the links
TAPER = 0.8
POINT = 0.045  # of a ball that stands for a body without length, relative to how far it goes
# half lengths of the end of a link and of its pin, in radii of the link
EYE_AND_PIN = (1.05, 1.45)
# no link leads to joints that hold nothing together
UNLINKED = ("free", "planar", "translation")
REVOLUTE = ("revolute", "cylindrical", "screw")
RAIL = ("prismatic",)
# half length and half width of what slides, in radii of the link
SLEEVE = (1.9, 1.35)
# links that a body without joints may have
MOST_ARMS = 12
DARK = {"color": [0.25, 0.28, 0.33, 1.0]}


@dataclass(frozen=True)
class DrawnBody:
    """A body of a picture.

    Attributes:
        name: Of the body.
        solids: What it looks like, in its own axes.
        fallback: Links and balls, where no mesh can be read.
        poses: Its transforms to ground axes (nt, 4, 4).
    """

    name: str
    solids: list[Solid]
    fallback: list[Solid]
    poses: Array


def bodies(motion: TrajectoryRecord) -> tuple[list[DrawnBody], list[Solid]]:
    """Bodies of a scene in joint coordinates, and the solids of the ground."""
    manifest = motion.manifest
    links = _links(motion)
    radius = _radius(motion, links)
    drawn, places = [], poses_of_bodies(motion)
    for k, body in _bodies(manifest):
        name = str(body.name)
        solids = _shapes(motion, name)
        inboard = _inboard(motion, k, radius)
        fallback = [link(a, b, radius, joint=not inboard) for a, b in links[name]]
        fallback += inboard + _cuts(motion, name, radius) + _center(motion, k, links[name], radius)
        fallback += _touching(motion, name)
        drawn.append(DrawnBody(name, solids or fallback, fallback, places[name]))
    # thinner than what turns about it, which then covers its end
    ground = _shapes(motion, "ground") or [link(a, b, 0.8 * radius) for a, b in links["ground"]]
    return drawn, ground


def poses_of_bodies(motion: TrajectoryRecord) -> dict[str, Array]:
    """Transforms (nt, 4, 4) to ground axes of all bodies of a scene in joint coordinates."""
    # without the C of every single pose, as far as that goes
    places = bodies_in_place(motion) if is_recorded(motion) else {}
    names = [str(body.name) for _, body in _bodies(motion.manifest)]
    return {name: places[name] if name in places else _poses(motion, name) for name in names}


def numbers_of(motion: TrajectoryRecord) -> dict[str, float]:
    """Parameters and structural numbers by name."""
    manifest = motion.manifest
    values = motion.parameters
    parameters = {
        row.name: row.default if values is None else float(values[k])
        for k, row in enumerate(manifest.parameters)
    }
    return {**manifest.structural, **parameters}


def link_radius(motion: TrajectoryRecord) -> float:
    """Radius of the links of a scene in joint coordinates [m]."""
    return _radius(motion, _links(motion))


def _radius(motion: TrajectoryRecord, links: Links) -> float:
    lengths = [float(np.linalg.norm(b - a)) for rows in links.values() for a, b in rows]
    lengths = [length for length in lengths if length > 0]
    if lengths:
        return THICK * float(np.mean(lengths))
    # bodies without any length are as large as one sees on their way
    paths = [_poses(motion, str(body.name))[:, :3, 3] for _, body in _bodies(motion.manifest)]
    extents = [float(np.ptp(path, axis=0).max(initial=0.0)) for path in paths]
    return POINT * max(extents, default=0.0) or 0.02


def _poses(motion: TrajectoryRecord, body: str) -> Array:
    """Transforms (nt, 4, 4) of a body to ground axes."""
    frame = next(row.name for row in motion.manifest.frames if row.body == body)
    return np.asarray(motion.pose(frame) @ inverse(motion.frame_on_body(frame)))


def _eye(at: Array, axis: Array, radius: float) -> list[Solid]:
    """The end of a link that turns about a pin along an axis."""
    along = radius * axis / float(np.linalg.norm(axis))
    eye, pin = (
        {"kind": "cylinder", "a": short(at - part * along), "b": short(at + part * along)}
        for part in EYE_AND_PIN
    )
    return [{**eye, "r": 1.4 * radius, "color": None}, {**pin, "r": 0.7 * radius, **DARK}]


def _inboard(motion: TrajectoryRecord, k: int, radius: float) -> list[Solid]:
    """Where a body turns about its parent or slides on it; nothing at joints without an axis."""
    kind, axis = motion.manifest.joints[k].kind, np.reshape(motion.scene["axis"], (-1, 3))[k]
    if kind in RAIL:
        return [_sleeve(axis, radius, motion.manifest.joints[k].parent == "ground")]
    return _eye(np.zeros(3), axis, radius) if kind in REVOLUTE else []


def _sleeve(axis: Array, radius: float, on_ground: bool) -> Solid:
    """What slides along an axis: a carriage on the ground, else a tube."""
    long, wide = radius * np.array(SLEEVE)
    if not on_ground:
        along = long * axis / float(np.linalg.norm(axis))
        return {"kind": "cylinder", "a": short(-along), "b": short(along), "r": wide, "color": None}
    # a rotation whose first column is the axis, the others near to axes of the body
    order = np.argsort(-np.abs(axis), kind="stable")
    columns = np.linalg.qr(np.column_stack([axis, np.eye(3)[order[1:]].T]))[0]
    turn = columns * np.array([1.0, 1.0, np.linalg.det(columns)])
    place = {"R": short(turn.ravel()), "a": [0.0, 0.0, 0.0]}
    return {"kind": "box", "size": [2 * long, 2 * wide, 2 * wide], **place, "color": None}


def _cuts(motion: TrajectoryRecord, body: str, radius: float) -> list[Solid]:
    """Where joints that close loops sit on a body: a ball for those without an axis."""
    owners = {row.name: row.body for row in motion.manifest.frames}
    solids = list[Solid]()
    for k, row in enumerate(motion.manifest.cuts):
        if owners.get(row.child_frame) != body:
            continue
        frame = motion.frame_on_body(row.child_frame)
        if row.kind in REVOLUTE:
            axis = np.reshape(motion.scene["cut_axis"], (-1, 3))[k]
            solids += _eye(frame[:3, 3], frame[:3, :3] @ axis, radius)
        else:
            solids.append({"kind": "sphere", "a": short(frame[:3, 3]), "r": 1.3 * radius, **DARK})
    return solids


def _touching(motion: TrajectoryRecord, body: str) -> list[Solid]:
    """The spheres of a body that contacts act on."""
    owners, numbers = {row.name: row.body for row in motion.manifest.frames}, numbers_of(motion)
    places = {
        (row.frames["sphere"], numbers.get(f"{row.name}.radius", 0.0))
        for row in motion.manifest.forces
        if row.kind == "contact" and owners.get(row.frames["sphere"]) == body
    }
    return [
        {"kind": "sphere", "a": short(motion.frame_on_body(f)[:3, 3]), "r": r, "color": None}
        for f, r in sorted(places)
        if r > 0
    ]


def _bodies(manifest: Manifest) -> list[tuple[int, BodyRow]]:
    """Number and row of every body; those without parts only stand for joints."""
    return [(k, body) for k, body in enumerate(manifest.bodies) if body.parts]


def _links(motion: TrajectoryRecord) -> Links:
    """Straight links in body axes: from the inboard joint to every outboard one, or to the tip."""
    manifest = motion.manifest
    bodies = _bodies(manifest)
    links: Links = {str(body.name): [] for _, body in bodies}
    links["ground"] = []
    frames: dict[str, list[str]] = {}
    for row in manifest.frames:
        frames.setdefault(row.body, []).append(row.name)
    position = np.reshape(motion.scene["position"], (-1, 3))
    for k, body in bodies:
        if manifest.joints[k].kind not in UNLINKED and body.parent in links:
            links[str(body.parent)].append((np.zeros(3), position[k]))
    # the ground has no joint of its own to begin at
    anchors = [end for _, end in links["ground"]]
    links["ground"] = [(anchors[0], end) for end in anchors[1:] or anchors] if anchors else []
    for k, body in bodies:
        rows = links[str(body.name)]
        if not rows or all(np.linalg.norm(b) == 0 for _, b in rows):
            # nothing hangs on it: its farthest frame, or the way to its center of mass, twice
            tips = [motion.frame_on_body(name)[:3, 3] for name in frames.get(str(body.name), ())]
            if not rows and manifest.joints[k].kind in UNLINKED:
                # what flies, such as a frame with rotors, has all its arms
                arms = np.unique(np.round(tips, 9), axis=0)
                arms = arms[np.linalg.norm(arms, axis=1) > 0]
                rows += [(np.zeros(3), arm) for arm in arms[:MOST_ARMS]]
                if rows:
                    continue
            tips.append(_reach(motion, k) * _com(motion, k))
            rows.append((np.zeros(3), max(tips, key=lambda tip: float(np.linalg.norm(tip)))))
    return links


def _reach(motion: TrajectoryRecord, k: int) -> float:
    """Multiple of the way to the center of mass at which a body ends: 1 for a mass at a point."""
    mass, com = float(np.ravel(motion.scene["mass"])[k]), _com(motion, k)
    about_origin = np.reshape(motion.scene["inertia"], (-1, 3, 3))[k]
    steiner = mass * (float(com @ com) * np.eye(3) - np.outer(com, com))
    extended = np.abs(about_origin - steiner).max() > 1e-9 * mass * float(com @ com)
    return 2.0 if extended else 1.0


def _com(motion: TrajectoryRecord, k: int) -> Array:
    mass = float(np.ravel(motion.scene["mass"])[k])
    moment = np.reshape(motion.scene["first_moment"], (-1, 3))[k]
    return np.asarray(moment / mass if mass else np.zeros(3))


def link(a: Array, b: Array, radius: float, joint: bool = True) -> Solid:
    """A rod that gets thinner from the inboard joint on, perhaps with a ball at the joint."""
    ends = {"a": short(a), "b": short(b), "r": radius, "end": TAPER * radius}
    return {"kind": "link", **ends, "joint": joint, "color": None}


def _center(
    motion: TrajectoryRecord, k: int, links: list[tuple[Array, Array]], radius: float
) -> list[Solid]:
    """A ball where the mass is, on a thin rod if that is beside the links."""
    com = _com(motion, k)
    foot = min(
        (_nearest(com, a, b) for a, b in links), key=lambda p: float(np.linalg.norm(com - p))
    )
    ball = {"kind": "sphere", "a": short(com), "r": 1.15 * radius, "color": None}
    if np.linalg.norm(com - foot) < 2 * radius:
        # amid a rod one expects it, at its end or where there is no rod it is what one sees
        ends = [end for pair in links for end in pair]
        near = min(float(np.linalg.norm(com - end)) for end in ends)
        return [ball] if near < 3 * radius else []
    rib = {"kind": "link", "a": short(foot), "b": short(com), "r": 0.35 * radius, "color": None}
    return [rib, ball]


def _nearest(point: Array, a: Array, b: Array) -> Array:
    """The point of the segment from a to b that is nearest to a point."""
    along = b - a
    length = float(along @ along)
    k = float(np.clip((point - a) @ along / length, 0, 1)) if length > 0 else 0.0
    return np.asarray(a + k * along)


def short(x: Array) -> list[float]:
    """Numbers as they stand in the page: to a millionth, of the largest where all are small."""
    values: list[float] = np.round(x, 6 + below_one(float(np.abs(x).max(initial=0.0)))).tolist()
    return values


def _shapes(motion: TrajectoryRecord, body: str) -> list[Solid]:
    """The user's shapes on a body, in its axes."""
    bodies = {row.name: row.body for row in motion.manifest.frames}
    solids = []
    for row in motion.manifest.shapes:
        if bodies.get(row.frame) == body:
            solids.append(solid(row, motion.frame_on_body(row.frame)))
    return solids


def solid(row: ShapeRow, place: Array) -> Solid:
    """A shape of the user; ``place`` (4, 4) is that of its frame in the body."""
    local = np.eye(4)
    local[:3, 3] = row.position
    if row.rotation is not None:
        local[:3, :3] = row.rotation
    at = place @ local
    color = None if row.color is None else [float(c) for c in row.color]
    if row.kind == "sphere":
        return {"kind": "sphere", "a": short(at[:3, 3]), "r": row.radius, "color": color}
    place_of = {"R": short(at[:3, :3].ravel()), "a": short(at[:3, 3])}
    if row.kind == "mesh":
        scale = list(row.scale or (1.0, 1.0, 1.0))
        return {"kind": "mesh", "file": row.file, "scale": scale, "color": color, **place_of}
    if row.kind == "box":
        return {"kind": "box", "size": [row.x, row.y, row.z], "color": color, **place_of}
    axis = at[:3, "xyz".index(row.axis or "z")] * ((row.length or 0.0) / 2)
    ends = {"a": short(at[:3, 3] - axis), "b": short(at[:3, 3] + axis)}
    kind = "cylinder" if row.kind == "cylinder" else "link"
    return {"kind": kind, **ends, "r": row.radius, "color": color}
