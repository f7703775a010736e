"""Rows of the manifest: joints, loops, bodies, frames, beams, shapes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from .fields import (
    NOTHING,
    Misfit,
    Record,
    count,
    field,
    flag,
    is_number,
    kind,
    listed,
    number,
    one_of,
    pair,
    table,
    text,
    triple,
)
from .finite_elements import Plane

VECTOR = listed(number, 3)
GROUND = "ground"
LIMITS = ("lower", "upper", "speed", "effort")
MEASURES = {
    "box": ("x", "y", "z"),
    "sphere": ("radius",),
    **dict.fromkeys(("cylinder", "capsule"), ("radius", "length")),
}


class WeldRow(Record):
    """A fixed joint that a kinematic loop passes."""

    joint: str = field(text)
    frame: str = field(text)
    side: int = field(
        one_of(-1, 1), "1 where what the joint carries is nearer to the child of the cut"
    )


class ConditionRow(Record):
    """A condition that always holds where a kinematic loop moves, and is not a constraint."""

    name: str = field(text)
    unit: str = field(text, "of its force")


class CutRow(Record):
    """A joint that closes a kinematic loop."""

    name: str = field(text)
    kind: str = field(text, run="")
    parent_frame: str = field(text, run=GROUND)
    child_frame: str = field(text, run=GROUND)
    loop: Sequence[str] = field(
        listed(text),
        "tree joints; with the name of the joint itself where it keeps its coordinates",
        run=(),
    )
    reason: str = field(text, default="")
    fixed: Sequence[WeldRow] = field(
        listed(WeldRow), "fixed joints that the loop passes, with their child frames", default=()
    )
    left_out: Sequence[ConditionRow] = field(
        listed(ConditionRow),
        "conditions that hold all over the group in which the loop moves, and are not constraints "
        "of the model",
        default=(),
    )


class Coupling(Record):
    """Coupling of a joint to another."""

    leader: str = field(text)


class LoopSolution(Record):
    """The loop in closed form that determines a joint."""

    loop: str = field(text, "by the joint that closes it", run="")
    q: Sequence[str] = field(listed(text), "names of its coordinates")
    u: Sequence[str] = field(listed(text), "names of its speeds")

    def names(self, letter: str) -> Sequence[str]:
        """Names of its coordinates or speeds."""
        return self.q if letter == "q" else self.u


class JointRow(Record):
    """A joint of the tree: one per moving body, in the order of the bodies."""

    name: str = field(text)
    kind: str = field(text)
    parent: str = field(text, "body", run="")
    child: str = field(text, "body", run="")
    parent_frame: str = field(text, run="")
    child_frame: str = field(text, run="")
    q: tuple[int, int] | None = field(
        pair(),
        "first entry in q and number of entries; absent without own coordinates",
        default=None,
    )
    u: tuple[int, int] | None = field(pair(), "the same in u", default=None)
    q0: Sequence[float] | None = field(listed(number), default=None)
    u0: Sequence[float] | None = field(listed(number), default=None)
    limits: Mapping[str, float] = field(table(number, one_of(*LIMITS)), run=NOTHING)
    quaternion: int | None = field(
        count, "entry of q that is the scalar part of a unit quaternion", default=None
    )
    rotation: str | None = field(text, "parametrization of the rotation", default=None)
    domain: str = field(text, "where the coordinates are regular", default="")
    coupled: Coupling | None = field(Coupling, default=None)
    solved: LoopSolution | None = field(
        LoopSolution, "the loop in closed form that determines it", default=None
    )
    prescribed: bool = field(flag, default=False)

    def slot(self, letter: str) -> tuple[int, int]:
        """First entry in q or u and number of entries; (0, 0) without own ones, in z as well."""
        return {"q": self.q, "u": self.u}.get(letter) or (0, 0)

    def fit(self, run: bool) -> None:
        """A start has one number for each coordinate, also where the loop of a joint solves it."""
        for block, slot, start in (("q", self.q, self.q0), ("u", self.u, self.u0)):
            size = slot[1] if slot else len(self.solved.names(block)) if self.solved else None
            if start is not None and size not in (None, len(start)):
                raise Misfit(f"has {len(start)} numbers, not {size}").within(f".{block}0")


class BodyRow(Record):
    """A body that moves: every parent before its children."""

    name: str = field(text)
    parent: str = field(text, "body or ground")
    parts: Sequence[str] = field(
        listed(text),
        "bodies of the user fixed to each other; none where the body has no mass and stands for "
        "the far side of a joint that closes a loop with coordinates of its own",
    )


class FrameRow(Record):
    """A frame that functions know by its name."""

    name: str = field(text)
    body: str = field(text)
    part: str | None = field(text, default=None)
    node: tuple[int, int] | None = field(
        pair(),
        "of a model in absolute coordinates: first coordinate and speed of its node, absent on "
        "the ground",
        default=None,
    )
    tree: tuple[int, int, int] | None = field(
        triple(),
        "of a body of a rigid tree: group and member of the tree, and number of the body in it",
        default=None,
    )
    plane: Plane | None = field(Plane, default=None)


class BeamRow(Record):
    """A piece of a beam between named nodes."""

    name: str = field(text)
    start: str = field(text, "frame")
    end: str = field(text, "frame")
    q: tuple[int, int] = field(pair(), "first entry in q and number of the nodes between")
    outline: tuple[float, float, bool] = field(
        kind(
            "an outline",
            lambda value: (
                isinstance(value, list)
                and len(value) == 3
                and all(map(is_number, value[:2]))
                and isinstance(value[2], bool | int)
            ),
            type="array",
            minItems=3,
            maxItems=3,
        ),
        "half widths along e2 and e3 and whether they are round",
    )
    contour: Sequence[tuple[float, float]] = field(
        listed(listed(number, 2)), "corners (e2, e3) of a section of another shape", default=()
    )
    length: float = field(number, "along the axis [m]", run=0.0)
    plane: Plane | None = field(Plane, "of the nodes between", default=None)


class SuperelementRow(Record):
    """A flexible body that was reduced; what is drawn of it stands in ``surfaces.npz``."""

    name: str = field(text)
    frame: str = field(text, "its axes, in which points move by its coordinates")
    q: Sequence[int] = field(listed(count), "entries of q that are its coordinates")
    bodies: Sequence[str] = field(
        listed(text), "bodies without mass that stand for its interfaces, frame and modes"
    )
    undeformed: Sequence[str] = field(
        listed(text), "frames that stand where it is without deformation"
    )
    loads: Sequence[str] = field(
        listed(text),
        "loads of its record that act; <name>.<load> is the output of a factor",
        default=(),
    )
    beams: Sequence[str] = field(listed(text), "beams of a scene that it was made of", default=())
    frame_choice: str = field(
        text, "interface that its frame is fixed to, or the mean or chord of all", default=""
    )
    stiffening: bool = field(flag, "whether its rotation stiffens it", default=False)
    fixed: str = field(text, "interface that is fixed for its first frequency", default="")
    first_frequency: float = field(number, "lowest then [rad/s]; 0 if nothing deforms", default=0.0)
    relative_inertia: Sequence[float] = field(
        listed(number, 9),
        "inertia about that interface over its largest moment, row by row",
        default=(0.0,) * 9,
    )

    @property
    def amplitudes(self) -> int:
        """Number of its coordinates and loads."""
        return len(self.q) + len(self.loads)

    @property
    def outputs(self) -> list[str]:
        """Outputs that are the factors of its loads."""
        return [f"{self.name}.{load}" for load in self.loads]


class ForceElementRow(Record):
    """A force element, for pictures."""

    name: str = field(text)
    kind: str = field(text)
    frames: Mapping[str, str] = field(table(text), "that it acts on, by role", default=NOTHING)


class ShapeRow(Record):
    """A shape for pictures, in the axes of its frame."""

    frame: str = field(text)
    kind: str = field(text)
    position: Sequence[float] = field(VECTOR)
    rotation: Sequence[Sequence[float]] | None = field(listed(VECTOR, 3), default=None)
    color: Sequence[float] | None = field(listed(number), default=None)
    axis: str | None = field(one_of("x", "y", "z"), default=None)
    radius: float | None = field(number, default=None)
    length: float | None = field(number, default=None)
    x: float | None = field(number, default=None)
    y: float | None = field(number, default=None)
    z: float | None = field(number, default=None)
    file: str | None = field(text, "of a mesh", default=None)
    scale: Sequence[float] | None = field(listed(number), "of a mesh", default=None)

    def fit(self, run: bool) -> None:
        """A shape has the measures of its kind."""
        for name in MEASURES.get(self.kind, ()):
            if getattr(self, name) is None:
                raise Misfit("is missing").within(f".{name}")
