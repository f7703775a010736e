"""The drawing of a motion: bodies, beams, springs, arrows, floor, and the view of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace

import numpy as np

from ..arrays import Array
from ..errors import ArgumentError, ModelError, near
from ..records import dataclass
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..schema.manifest import Manifest
from .beams import STRAIN, DrawnBeam, beams
from .beams import bodies as on_nodes
from .cables import cable_nodes, cables
from .curves import Histories
from .solids import DrawnBody, Solid, numbers_of
from .solids import bodies as in_joint_coordinates
from .supports import Support
from .surfaces import DISPLACEMENT, VON_MISES, DrawnSurface, surfaces

# layers of arrows, and what else a page may show from the start
ARROWS = ("reactions", "forces", "contacts")
LAYERS = (*ARROWS, "frames", "springs", "stress", "strain", "displacement", "floor")
# on unless a user names others
USUAL = ("contacts", "forces", "springs", "stress", "strain", "displacement", "floor")
# kinds of force elements that are drawn as arrows: layer, and the frame they begin at
ACTING = {"contact": ("contacts", "sphere"), "force": ("forces", "frame")}
# kinds of force elements that are drawn between their frames a and b
SPRINGS = ("spring_damper", "maxwell", "bushing", "flexible_hinge")
MOST_EVENTS = 400
# pictures per second of a screen, and swings per second that one can follow
FAST, FOLLOWED = 60.0, 1.5
RATES = np.array([*(float(f"{k}e{n}") for n in range(-9, 0) for k in (1, 2, 5)), 1.0])
# of the largest speed: what one sees; turns and moves that are none
VISIBLE, FLAT = 0.25, 1e-6


@dataclass(frozen=True)
class Abscissa:
    """Time, or the load that a page runs over.

    Attributes:
        name, unit: Of it.
        values: Its value at every row (nt,).
    """

    values: Array
    name: str = "t"
    unit: str = "s"


@dataclass(frozen=True)
class DrawnSpring:
    """A spring or damper between two points (nt, 3) each."""

    name: str
    coil: bool
    damper: bool
    ends: tuple[Array, Array]


@dataclass(frozen=True)
class DrawnArrow:
    """A force (nt, 3) in ground axes at a point (nt, 3)."""

    name: str
    layer: str
    at: Array
    vector: Array


@dataclass(frozen=True)
class Drawing:
    """The contents of a page.

    Attributes:
        name: Headline.
        abscissa: What it runs over.
        bodies, ground, beams, surfaces, supports, springs, arrows: What is drawn.
        traces: Paths (nt, 3) of frames, by name.
        histories: Curves, by unit.
        events: When what happened.
        up: Upward, against gravity.
        normal: Of the plane that everything moves in, toward the reader; None in space.
        floor: Height of the ground along ``up``; ``"below"`` everything, ``"ground"`` below what
            is fixed to the ground, None without weight.
        rate: Speed of the play: 1 is real time.
        follow: Number of the body that the camera goes with.
        layers: What shows from the start.
    """

    name: str
    abscissa: Abscissa
    bodies: list[DrawnBody]
    ground: list[Solid]
    beams: list[DrawnBeam]
    surfaces: list[DrawnSurface] = field(default_factory=list)
    supports: list[Support] = field(default_factory=list)
    springs: list[DrawnSpring] = field(default_factory=list)
    arrows: list[DrawnArrow] = field(default_factory=list)
    traces: dict[str, Array] = field(default_factory=dict)
    histories: list[Histories] = field(default_factory=list)
    events: list[tuple[float, str]] = field(default_factory=list)
    up: Array = field(default_factory=lambda: np.array([0.0, 0.0, 1.0]))
    normal: Array | None = None
    floor: float | str | None = None
    rate: float = 1.0
    follow: int | None = None
    layers: Sequence[str] = USUAL


def solids_of(
    motion: TrajectoryRecord, colored_by: str | None = None
) -> tuple[list[DrawnBody], list[Solid], list[DrawnBeam], list[DrawnSurface]]:
    """Bodies, solids of the ground, beams, and surfaces of superelements of a motion.

    Args:
        motion: The motion.
        colored_by: ``"stress"`` colors beams and superelements, ``"strain"`` beams,
            ``"displacement"`` superelements; None for what there is.

    Raises:
        ModelError: there is no such color.
    """
    hidden = cable_nodes(motion.manifest)
    if motion.manifest.absolute:
        drawn_beams = beams(motion, colored_by)
        bodies, ground = on_nodes(motion, drawn_beams)
    else:
        drawn_beams = []
        bodies, ground = in_joint_coordinates(motion)
    visible = [body for body in bodies if body.name not in hidden]
    kind = colored_by or _kind_of_color(drawn_beams)
    drawn_surfaces = surfaces(motion, kind)
    if (
        not colored_by
        and kind == VON_MISES
        and not any(
            [
                *(one.kind for one in drawn_surfaces),
                *(beam.values is not None for beam in drawn_beams),
            ]
        )
    ):
        drawn_surfaces = surfaces(motion, DISPLACEMENT)
    colored = [one for one in drawn_surfaces if one.kind]
    if colored_by and not colored and (colored_by == DISPLACEMENT or not motion.manifest.beams):
        what = {
            VON_MISES: "beams and no superelements with stress",
            DISPLACEMENT: "superelements",
        }.get(colored_by, "beams")
        raise ModelError(f"show='{colored_by}': '{motion.manifest.name}' has no {what} to color")
    return visible, ground, drawn_beams + cables(motion), drawn_surfaces


def _kind_of_color(drawn_beams: Sequence[DrawnBeam]) -> str:
    """What colors everything, where a user names nothing: what colors the beams."""
    strained = any(b.values is not None and b.colored_by == STRAIN for b in drawn_beams)
    return "strain" if strained else VON_MISES


def springs(motion: TrajectoryRecord) -> list[DrawnSpring]:
    """Springs and dampers between two frames."""
    numbers = numbers_of(motion)
    return [
        DrawnSpring(
            row.name,
            # a formula is drawn as what it may be
            coil=numbers.get(f"{row.name}.stiffness", 1.0) != 0,
            damper=numbers.get(f"{row.name}.damping", 1.0) != 0,
            ends=(_place(motion, row.frames["a"]), _place(motion, row.frames["b"])),
        )
        for row in motion.manifest.forces
        if row.kind in SPRINGS
    ]


def _place(motion: TrajectoryRecord, frame: str) -> Array:
    return motion.pose(frame)[:, :3, 3]


def reaction_frames(manifest: Manifest) -> Mapping[str, str]:
    """Joint -> child frame, where its reaction acts; none of finite elements in files of runs."""
    if manifest.absolute:
        elements = manifest.finite_elements
        return {} if elements is None else elements.reaction_frames
    frames = {row.name: row.child_frame for row in manifest.joints}
    return frames | {row.name: row.child_frame for row in manifest.cuts}


def reactions(motion: TrajectoryRecord) -> list[DrawnArrow]:
    """Reaction forces of joints at their child frames."""
    drawn = []
    motion._model("the reactions of joints")
    for joint, frame in reaction_frames(motion.manifest).items():
        pose = motion.pose(frame)
        force = (pose[:, :3, :3] @ motion.reaction(joint)[:, 3:, None])[:, :, 0]
        drawn.append(DrawnArrow(f"{joint}.force", "reactions", pose[:, :3, 3], force))
    return drawn


def acting(motion: TrajectoryRecord) -> list[DrawnArrow]:
    """Loads and contact forces where they act, of motions whose model is known."""
    if motion.model is None or "element_forces" not in motion.manifest.available:
        return []
    named = {row.element for row in motion.manifest.element_forces}
    return [
        DrawnArrow(
            f"{row.name}.force",
            ACTING[row.kind][0],
            _place(motion, row.frames[ACTING[row.kind][1]]),
            motion[f"{row.name}.force"],
        )
        for row in motion.manifest.forces
        if row.kind in ACTING and row.name in named
    ]


def upward(motion: TrajectoryRecord) -> tuple[Array, bool]:
    """Direction against gravity, and whether there is gravity."""
    numbers = numbers_of(motion)
    gravity = np.array([numbers.get(f"gravity.{axis}", 0.0) for axis in "xyz"])
    if "gravity" in motion.scene:
        gravity = np.asarray(motion.scene["gravity"], dtype=np.float64)
    size = float(np.linalg.norm(gravity))
    if not size > 0:
        return np.array([0.0, 0.0, 1.0]), False
    return -gravity / size, True


def plane_of(
    bodies: Sequence[DrawnBody],
    drawn_beams: Sequence[DrawnBeam],
    drawn_surfaces: Sequence[DrawnSurface] = (),
) -> Array | None:
    """Normal of the plane that everything moves in, toward the reader; None in space."""
    turns: list[Array] = []
    moves: list[Array] = []
    tracks = [body.poses[:, None] for body in bodies] + [beam.sections for beam in drawn_beams]
    tracks += [one.poses[:, None] for one in drawn_surfaces if one.poses is not None]
    for poses in tracks:
        relative = poses[:, :, :3, :3] @ np.swapaxes(poses[:1, :, :3, :3], -1, -2)
        antisymmetric = relative - np.swapaxes(relative, -1, -2)
        turns.append(antisymmetric[..., [2, 0, 1], [1, 2, 0]].reshape(-1, 3))
        moves.append((poses[:, :, :3, 3] - poses[:1, :, :3, 3]).reshape(-1, 3))
    for beam in drawn_beams:
        # where a beam stands counts as well as how it moves
        moves.append((beam.sections[0, :, :3, 3] - beam.sections[0, :1, :3, 3]).reshape(-1, 3))
    if not tracks:
        return None
    axes, steps = np.concatenate(turns), np.concatenate(moves)
    most_angle, most_travel = float(np.abs(axes).max()), float(np.abs(steps).max())
    if most_angle > FLAT:
        normal = np.linalg.svd(axes, full_matrices=False)[2][0]
        if np.abs(axes - np.outer(axes @ normal, normal)).max() > 1e-6 * most_angle:
            return None
    elif most_travel > FLAT:
        _, sizes, directions = np.linalg.svd(steps, full_matrices=True)
        if sizes[1] <= 1e-9 * sizes[0]:
            return None  # along a line: any plane would do
        normal = directions[2]
    else:
        return None
    if np.abs(steps @ normal).max() > 1e-6 * max(most_travel, FLAT):
        return None
    largest = int(np.argmax(np.abs(normal)))
    # looked at from -y, x, z: the other axes point to the right and upward
    toward = -1.0 if largest == 1 else 1.0
    return np.asarray(normal * np.sign(normal[largest]) * toward)


def slowed(motion: TrajectoryRecord) -> float:
    """Speed of play at which the fastest swings of a motion can be followed."""
    span = abs(float(motion.t[-1] - motion.t[0]))
    if not span > 0:
        return 1.0
    most: dict[str, float] = {}
    largest = np.abs(motion.u).max(axis=0, initial=0.0)
    # what superelements tremble by inside is seen at their interfaces
    modal = [joint.slot("u") for joint in motion.manifest.joints if joint.kind == "modal"]
    for start, count in modal if motion.manifest.superelements else ():
        largest[start : start + count] = 0.0
    for row, size in zip(motion.manifest.speeds, largest, strict=True):
        most[row.unit] = max(most.get(row.unit, 0.0), float(size))
    swings = 0.0
    for row, speed, size in zip(motion.manifest.speeds, motion.u.T, largest, strict=True):
        # what trembles beside large motions does not count
        if size > VISIBLE * most[row.unit] > 0:
            strong = np.sign(speed[np.abs(speed) > VISIBLE * size])
            swings = max(swings, np.count_nonzero(np.diff(strong)) / 2 / span)
    return rate_below(min(FOLLOWED / swings if swings > 0 else np.inf, span / 3.0))


def rate_below(rate: float) -> float:
    """The next round speed of play, real time at most."""
    return float(RATES[max(0, int(np.searchsorted(RATES, rate * 1.001, side="right")) - 1)])


def body_followed(name: str | None, drawing: Drawing, manifest: Manifest) -> int | None:
    """Number of the body or superelement that is named itself or by a frame of it.

    Surfaces are counted behind bodies.

    Raises:
        ArgumentError: there is none.
    """
    if name is None:
        return None
    names = [one.name for one in drawing.bodies] + [one.name for one in drawing.surfaces]
    owners = {body: row.name for row in manifest.superelements for body in row.bodies}
    frames = {row.name: owners.get(row.body, row.body) for row in manifest.frames}
    body = name if name in names else frames.get(name, "")
    if body not in names:
        hint = near(name, dict.fromkeys([*names, *(f for f in frames if frames[f] in names)]))
        raise ArgumentError(f"follow='{name}': there is no such body.{hint}")
    return names.index(body)


def joined(rows: Sequence[Drawing]) -> Drawing:
    """One drawing of many with the same things in them, one behind the other."""

    def all_of(arrays: Iterable[Array]) -> Array:
        return np.concatenate(list(arrays))

    first, n = rows[0], len(rows)
    if n == 1:
        return first
    return replace(
        first,
        bodies=[
            replace(body, poses=all_of(row.bodies[k].poses for row in rows))
            for k, body in enumerate(first.bodies)
        ],
        beams=[
            replace(
                beam,
                sections=all_of(row.beams[k].sections for row in rows),
                values=None
                if beam.values is None
                else all_of(np.asarray(row.beams[k].values) for row in rows),
            )
            for k, beam in enumerate(first.beams)
        ],
        surfaces=[
            replace(
                one,
                amplitudes=all_of(row.surfaces[k].amplitudes for row in rows),
                poses=None
                if one.poses is None
                else all_of(np.asarray(row.surfaces[k].poses) for row in rows),
            )
            for k, one in enumerate(first.surfaces)
        ],
        supports=[
            replace(one, travel=_widest([row.supports[k].travel for row in rows]))
            for k, one in enumerate(first.supports)
        ],
        springs=[
            replace(
                spring,
                ends=(
                    all_of(row.springs[k].ends[0] for row in rows),
                    all_of(row.springs[k].ends[1] for row in rows),
                ),
            )
            for k, spring in enumerate(first.springs)
        ],
        arrows=[
            replace(
                arrow,
                at=all_of(row.arrows[k].at for row in rows),
                vector=all_of(row.arrows[k].vector for row in rows),
            )
            for k, arrow in enumerate(first.arrows)
        ],
        traces={name: all_of(row.traces[name] for row in rows) for name in first.traces},
    )


def _widest(travels: Sequence[tuple[float, float]]) -> tuple[float, float]:
    return min(low for low, _ in travels), max(high for _, high in travels)


def floor_of(motion: TrajectoryRecord, up: Array, heavy: bool) -> float | str | None:
    """Height of the ground: of what touches it, else below the base, else below everything."""
    frames = {row.name: row.body for row in motion.manifest.frames}
    for row in motion.manifest.forces:
        other = row.frames.get("other", "")
        if frames.get(other) == "ground":
            return float(motion.pose(other)[0, :3, 3] @ up)
    if heavy and any(frames.get(shape.frame) == "ground" for shape in motion.manifest.shapes):
        return "ground"
    return "below" if heavy else None
