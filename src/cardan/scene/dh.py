"""Denavit-Hartenberg tables: one row per joint, in either convention.

Standard: from link i-1 to link i, R_z(theta) T_z(d) T_x(a) R_x(alpha); the joint turns about the
z axis of the link before it. Modified: R_x(alpha) T_x(a) R_z(theta) T_z(d); the joint turns about
the z axis of its own link. The coordinate is added to theta of a revolute row, to d of a prismatic.

Source: J. Denavit, R. S. Hartenberg, A Kinematic Notation for Lower-Pair Mechanisms Based on
Matrices, J. Appl. Mech. 22 (1955); J. J. Craig, Introduction to Robotics, chapter 3 (modified).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from math import isfinite
from typing import Any

from ..arguments import checked
from ..elements.forces.drive import Drive
from ..elements.forces.joint_damper import JointDamper
from ..elements.joints.fixed import Fixed
from ..elements.joints.prismatic import Prismatic
from ..elements.joints.revolute import Revolute
from ..elements.quantity import Value
from ..elements.validation import is_expression
from ..errors import ModelError, brief, near
from ..records import dataclass
from ..spatial.numbers import cosine_sine
from .checks import is_number
from .files.angles import snap as quarter
from .frame import Frame, Place
from .scene import SceneRecord

CONVENTIONS = ("standard", "modified")
KINDS = {"revolute": Revolute, "prismatic": Prismatic}
GEOMETRY = ("a", "alpha", "d", "theta")


@dataclass(frozen=True)
class Row:
    """A joint and the link it moves.

    Attributes:
        a, alpha, d, theta: Denavit-Hartenberg parameters [m, rad], numbers or expressions.
        type: ``"revolute"`` or ``"prismatic"``.
        name, link: Of joint and body; by default ``joint1``, ``link1`` and so on.
        mass, com, inertia: Of the link in its own axes, the inertia about its center of mass.
        rotor_inertia, gear_ratio: Of its motor: adds gear_ratio^2 rotor_inertia to the joint.
        friction: Viscous friction of the motor [N m s/rad at the rotor].
        damping: Viscous damping at the joint.
        q0, limits: As :meth:`Model.joint` takes them.
    """

    a: Value = 0.0
    alpha: Value = 0.0
    d: Value = 0.0
    theta: Value = 0.0
    type: str = "revolute"
    name: str = ""
    link: str = ""
    mass: Value | None = None
    com: Sequence[Value] = (0, 0, 0)
    inertia: Value | None = None
    rotor_inertia: Value | None = None
    gear_ratio: Value = 1.0
    friction: Value = 0.0
    damping: Value | None = None
    q0: Value | None = None
    limits: Any = None


@checked
def from_dh(
    rows: Iterable[Mapping[str, Value] | Sequence[Value]],
    convention: str = "standard",
    name: str = "robot",
    gravity: Sequence[Value] = (0, 0, -9.81),
) -> SceneRecord:
    """A serial robot from its Denavit-Hartenberg table.

    Args:
        rows: One per joint, from the ground outward: the four numbers (a, alpha, d, theta) of a
            revolute joint, or a mapping with some of ``a, alpha, d, theta`` [m, rad], ``type``
            (``"revolute"``, ``"prismatic"``), ``name`` and ``link`` (of joint and body), ``mass``
            [kg], ``com`` [m] and ``inertia`` (about it) of the link in its own axes,
            ``rotor_inertia``, ``gear_ratio`` and ``friction`` of the motor, ``damping``, ``q0``,
            ``limits`` of the joint.
        convention: ``"standard"`` (frames at the far end of a link) or ``"modified"`` (at its
            joint).
        name: Of the model.
        gravity: In ground axes [m/s^2].

    Returns:
        The model. The frame of link i is that of the convention; angles that are printed roundings
        of quarter turns become exact and are listed in ``Model.snaps``.

    Raises:
        ModelError: an unknown key, convention or type, or a value that cannot be what it says.
    """
    scene = SceneRecord(name, gravity=gravity)
    add_dh(scene, rows, convention)
    return scene


def add_dh(
    scene: SceneRecord,
    rows: Iterable[Mapping[str, Value] | Sequence[Value]],
    convention: str = "standard",
    parent: Place | str | None = None,
    prefix: str = "",
    snap: bool = True,
) -> None:
    """Add the links and joints of a table to a scene; see :func:`from_dh`.

    Args:
        parent: Body that carries the first joint, or a frame, on which a body ``base`` is mounted;
            the ground by default.
        prefix: Before the names of all joints and links.
        snap: Whether printed roundings of quarter turns become exact.
    """
    if convention not in CONVENTIONS:
        raise ModelError(
            f"dh: convention '{convention}' does not exist.{near(convention, CONVENTIONS)}"
        )
    # an array of no dimension has the method, but no entries
    if isinstance(rows, str | bytes | Mapping) or not hasattr(rows, "__iter__") or _single(rows):
        raise ModelError(f"dh: rows={brief(rows)} is not a table; give a list of rows")
    table = [_row(k, row) for k, row in enumerate(rows, 1)]
    inner = scene.ground if parent is None else parent
    if isinstance(inner, Frame):
        base = scene.body(f"{prefix}base")
        scene.joint(f"{prefix}mount", Fixed(), inner, base)
        inner = base
    for k, row in enumerate(table, 1):
        joint, link = prefix + (row.name or f"joint{k}"), prefix + (row.link or f"link{k}")
        if snap:
            row = _snapped(scene, joint, row)
        inner = _add(scene, joint, link, row, convention, inner)


def _single(rows: object) -> bool:
    return getattr(rows, "shape", None) == ()


def _row(k: int, entries: Mapping[str, Any] | Sequence[Any]) -> Row:
    """A checked row."""
    who = f"dh: row {k}"
    if not isinstance(entries, Mapping):
        if not isinstance(entries, Sequence) or isinstance(entries, str | bytes):
            raise ModelError(f"{who}: {brief(entries)}; give (a, alpha, d, theta) or a mapping")
        values = list(entries)
        if len(values) != len(GEOMETRY):
            raise ModelError(f"{who}: {len(values)} values; give (a, alpha, d, theta) or a mapping")
        entries = dict(zip(GEOMETRY, values, strict=True))
    for key in entries:
        if key not in Row.__dataclass_fields__:
            raise ModelError(f"{who}: '{key}' does not exist.{near(key, Row.__dataclass_fields__)}")
    row = Row(**entries)
    for key in ("type", "name", "link"):
        if not isinstance(getattr(row, key), str):
            raise ModelError(f"{who}: {key} is {getattr(row, key)!r}; give a text")
    for key in GEOMETRY:
        value = getattr(row, key)
        if isinstance(value, bool) or not (is_number(value) or is_expression(value)):
            raise ModelError(f"{who}: {key} is {brief(value)}; give a number or an expression")
        if is_number(value) and not isfinite(value):
            raise ModelError(f"{who}: {key} is {value}; give a finite number or an expression")
    if row.type not in KINDS:
        raise ModelError(f"{who}: type '{row.type}' does not exist.{near(str(row.type), KINDS)}")
    return row


def _snapped(scene: SceneRecord, joint: str, row: Row) -> Row:
    """The row with quarter turns in place of their roundings, which are listed."""
    exact: dict[str, Any] = {}
    for key in ("alpha", "theta"):
        value = getattr(row, key)
        if is_number(value):
            word, who = repr(float(value)), f"joint '{joint}' {key}"
            exact[key] = quarter(word, float(value), who, scene.snaps)
    return replace(row, **exact)


def _add(scene: SceneRecord, joint: str, link: str, row: Row, convention: str, inner: Any) -> Any:
    """One joint and its link; returns the link."""
    body = scene.body(link, mass=row.mass, com=row.com, inertia=row.inertia)
    kind, (c, s) = KINDS[row.type]("z"), _cosine_sine(row.alpha)
    if convention == "standard":
        # the joint stands where the row begins, the link where it ends
        before, after = (row.d, 0) if row.type == "prismatic" else (0, row.d)
        on_parent = inner.at(0, 0, before, rotation=("xyz", 0, 0, row.theta))
        on_child = body.at(-row.a, -s * after, -c * after, rotation=("xyz", -row.alpha, 0, 0))
    else:
        on_parent = inner.at(
            row.a, -s * row.d, c * row.d, rotation=("XYZ", row.alpha, 0, row.theta)
        )
        on_child = body.at(0, 0, 0)
    scene.joint(joint, kind, on_parent, on_child, q0=row.q0, limits=row.limits)
    if row.rotor_inertia is not None:
        drive = Drive(joint, row.rotor_inertia, ratio=row.gear_ratio, friction=row.friction)
        scene.force(f"{joint}.drive", drive)
    if row.damping is not None:
        scene.force(f"{joint}.damping", JointDamper(joint, row.damping))
    return body


def _cosine_sine(angle: Value) -> tuple[Value, Value]:
    if is_number(angle):
        return cosine_sine(float(angle))
    import sympy

    return sympy.cos(angle), sympy.sin(angle)
