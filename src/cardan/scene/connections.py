"""Joints and forces as the user describes them."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import TypeVar

from ..arguments import kinds_of, read
from ..elements.forces.force import ForceElement
from ..elements.joints.joint import Joint as JointElement
from ..elements.joints.joint import Reversed
from ..elements.quantity import Value
from ..errors import ModelError, ModelWarning, brief, near, outside, warn
from ..records import dataclass
from . import checks
from .beam import Beam
from .body import Body
from .frame import Place

Limits = tuple[float | None, float | None, float | None, float | None]


@dataclass(frozen=True)
class Couple:
    """q = ratio q_leader + offset."""

    leader: str
    ratio: Value
    offset: Value


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint between two frames; made by :meth:`Model.joint`.

    Attributes:
        name: Its name.
        kind: The joint element.
        parent, child: The frames (or bodies) it joins.
        prescribed: Its coordinate as an expression in t or an input, or None.
        q0, u0: Initial values, None where not named.
        limits: Lower, upper, speed, effort, as far as given.
        at: Its place in ground axes at the reference configuration, or None.
        couple: What it follows, or None.
        base: Body in whose axes ``at`` is given, None for the ground.
        friction: Dry friction of a file [N m or N]; it does not act.
        cut: Asked to close a loop.
    """

    name: str
    kind: JointElement
    parent: Place
    child: Place
    prescribed: Value | None = None
    q0: tuple[float, ...] | None = None
    u0: tuple[float, ...] | None = None
    limits: Limits = (None, None, None, None)
    at: tuple[Value, Value, Value] | None = None
    couple: Couple | None = None
    base: Body | None = None
    friction: float = 0.0
    cut: bool = False

    def __repr__(self) -> str:
        ends = f"{self.parent.name!r} -> {self.child.name!r}"
        return f"Joint({self.name!r}, {self.kind.kind}, {ends})"


@dataclass(frozen=True, eq=False)
class Force:
    """A named force element; made by :meth:`Model.force`."""

    name: str
    element: ForceElement


def element_of(name: str, kind: JointElement | type[JointElement], axis: object) -> JointElement:
    """The joint element, its axis replaced where one is given."""
    if isinstance(kind, type) and issubclass(kind, JointElement):
        kind = _plain(name, kind)
    if not isinstance(kind, JointElement):
        raise ModelError(f"joint '{name}': {brief(kind)} is not a joint kind such as Revolute('y')")
    if isinstance(kind, Reversed):
        raise ModelError(
            f"joint '{name}' ({kind.kind}): give the kind itself, and exchange parent and child"
        )
    kind = by_names(kind)
    if axis is None:
        return kind
    if "axis" not in kind.quantities():
        raise ModelError(f"joint '{name}' ({kind.kind}): this kind takes no axis=")
    element: JointElement = dataclasses.replace(kind, axis=axis)  # type: ignore[type-var]
    return element


def _plain(name: str, kind: type[JointElement]) -> JointElement:
    """A kind without arguments.

    Raises:
        ModelError: it needs some.
    """
    fields = dataclasses.fields(kind)  # type: ignore[arg-type]
    needed = [f.name for f in fields if f.default is dataclasses.MISSING]
    if needed:
        raise ModelError(
            f"joint '{name}' ({kind.kind}): this kind needs {', '.join(needed)}; give "
            f"{kind.__name__}({', '.join(f'{n}=' for n in needed)}...)"
        )
    return kind()


Element = TypeVar("Element", JointElement, ForceElement)


def by_names(element: Element) -> Element:
    """An element that keeps the names of the joints and beams it was given."""
    values = {f.name: getattr(element, f.name) for f in dataclasses.fields(element)}  # type: ignore[arg-type]
    names = {key: value.name for key, value in values.items() if isinstance(value, Joint | Beam)}
    for field in dataclasses.fields(element):  # type: ignore[arg-type]
        value = names.get(field.name, values[field.name])
        if field.type == "JointName" and not isinstance(value, str):
            raise ModelError(
                f"{element.kind}: {field.name} is {brief(value)}; give a joint or its name"
            )
        if field.type == "bool":
            read(element.kind, field.name, value, kinds_of(field.type))
    return dataclasses.replace(element, **names) if names else element  # type: ignore[type-var]


def limits_of(who: str, limits: Mapping[str, float] | Sequence[float] | None) -> Limits:
    """Lower, upper, speed and effort as far as given.

    Raises:
        ModelError: an unknown entry, one that is not a number, or lower above upper.
    """
    if limits is None:
        return (None, None, None, None)
    names = ("lower", "upper", "speed", "effort")
    if not isinstance(limits, Mapping):
        rows = isinstance(limits, list | tuple) or getattr(limits, "ndim", 0) == 1
        if not rows or not 2 <= len(limits) <= 4:
            raise ModelError(f"{who}: limits are (lower, upper) or a mapping, not {brief(limits)}")
        limits = dict(zip(names, limits, strict=False))
    for key in limits:
        if key not in names:
            raise ModelError(f"{who}: limits have no entry '{key}'." + near(key, names))
    values = [limits.get(key) for key in names]
    for key, value in zip(names, values, strict=True):
        if value is not None and (not checks.is_real(value)):
            raise ModelError(f"{who}: limits: limit '{key}' is not a number but {brief(value)}")
    lower, upper, speed, effort = (None if v is None else float(v) for v in values)
    if lower is not None and upper is not None and lower > upper:
        raise ModelError(f"{who}: the lower limit {lower} is above the upper limit {upper}")
    return lower, upper, speed, effort


def check_start(joint: Joint) -> None:
    """Warn of a start outside the limits, where a joint has one coordinate."""
    if joint.q0 is not None and len(joint.q0) == 1:
        problem = outside(joint.q0[0], *joint.limits[:2], joint.kind.coordinates[0].unit)
        if problem:
            warn(f"joint '{joint.name}': q0: {problem}", ModelWarning)


def check_cut(who: str, cut: object, moved: bool) -> None:
    """Check that a joint may be cut as requested.

    Raises:
        ModelError: neither True nor False, or a joint that something moves.
    """
    if not isinstance(cut, bool):
        raise ModelError(f"{who}: cut is True or False, not {brief(cut)}")
    if cut and moved:
        raise ModelError(
            f"{who}: a cut joint has no coordinate that prescribed= or couple= could move; cut "
            "another joint of the loop"
        )


def couple_of(who: str, kind: JointElement, couple: tuple[object, ...] | None) -> Couple | None:
    """The joint that a joint follows by its kind or by ``couple``, checked.

    Raises:
        ModelError: not a leader (a joint or its name) with a ratio, or two of them.
    """
    if couple is not None and kind.follows is not None:
        raise ModelError(f"{who}: it follows '{kind.follows[0]}' already; leave out couple=")
    couple = kind.follows if couple is None else couple
    if couple is None:
        return None
    leader = couple[0] if isinstance(couple, tuple) and len(couple) in (2, 3) else None
    if not isinstance(leader, str | Joint):
        raise ModelError(f"{who}: couple is (leader, ratio) or (leader, ratio, offset)")
    leader = leader if isinstance(leader, str) else leader.name
    return Couple(leader, couple[1], couple[2] if len(couple) == 3 else 0)
