"""Checks of single statements of a model, made where they are written."""

from __future__ import annotations

import math
from collections.abc import Container, Sequence
from numbers import Real
from typing import Any

from ..arguments import UNIT
from ..elements.quantity import Value
from ..errors import ImpossibleWarning, ModelError, brief, looks, near, points, warn

LONGEST_NAME = 200
ROUNDED = 1e-6  # of the largest moment: what a file loses by rounding


def name(what: str, text: object) -> str:
    """A usable name.

    Raises:
        ModelError: not text, empty, too long or with characters that cannot be printed.
    """
    if not isinstance(text, str) or not text.strip():
        raise ModelError(f"{what}: a name must be text that is not empty, not {brief(text)}")
    if len(text) > LONGEST_NAME or not text.isprintable():
        raise ModelError(
            f"{what} {text[:40]!r}: a name has at most {LONGEST_NAME} printable characters"
        )
    return text


def new(what: str, text: str, taken: Container[str]) -> None:
    """A usable name that is not taken.

    Raises:
        ModelError: it is taken or not usable.
    """
    name(what, text)
    if text in taken:
        raise ModelError(f"{what} '{text}': the name is taken; names of this sort must differ")


def check_distinguishable(model: Any) -> None:
    """Refuse names that only a program can tell from each other.

    Raises:
        ModelError: two names of a scene look the same.
    """
    first_of_look: dict[str, tuple[str, str]] = {}
    named = {"body": model.bodies, "frame": model.frames, "node": model.nodes}
    named |= {
        "beam": model.beams,
        "cable": model.cables,
        "superelement": model.superelements,
        "joint": model.joints,
        "force": model.forces,
    }
    named |= {"parameter": model.parameters, "input": model.inputs, "output": model.outputs}
    for kind, text in ((kind, text) for kind, names in named.items() for text in names):
        kind_of_other, other = first_of_look.setdefault(
            text if text.isascii() else looks(text), (kind, text)
        )
        if other != text:
            raise ModelError(
                f"{kind} '{text}' looks like another name: {points(text)} is not the "
                f"{kind_of_other} "
                f"{points(other)}, and the eye cannot tell them apart; rename one of them"
            )


def number(who: str, value: Value) -> float:
    """A finite number.

    Raises:
        ModelError: it is not.
    """
    try:
        result = float(value)
    except (TypeError, ValueError, RecursionError) as problem:
        raise ModelError(f"{who}: a number is wanted, not {brief(value)}") from problem
    except OverflowError as problem:
        raise ModelError(
            f"{who}: the number {brief(value)} is too large for the machine"
        ) from problem
    if not math.isfinite(result):
        raise ModelError(f"{who}: a number must be finite, not {result} ({brief(value)})")
    return result


def is_number(value: object) -> bool:
    """True for real numbers of Python, NumPy and SymPy, fractions too; arrays are none."""
    # most are floats; asking abstract classes takes three times as long
    if type(value) is float or isinstance(value, Real):
        return True
    return type(value).__module__ == "numpy" and getattr(value, "ndim", 1) == 0


def is_real(value: Value) -> bool:
    """True for numbers that a float can be, infinite ones too, and not NaN."""
    try:
        return is_number(value) and not math.isnan(float(value))
    except (TypeError, ValueError, OverflowError):
        return False


def quantity(who: str, value: object) -> Value:
    """A number or an expression, as written.

    Raises:
        ModelError: text, None or another thing that has no value.
    """
    if is_number(value) or hasattr(type(value), "free_symbols"):
        return value
    text = "the text " if isinstance(value, str) else ""
    raise ModelError(
        f"{who}: a number or an expression is wanted, not {text}{brief(value)}; expressions are "
        "SymPy's, of symbols such as scene.q('elbow') or scene.parameter('m', 1.0)"
    )


def initial(
    who: str,
    what: str,
    value: float | Sequence[float] | None,
    count: int,
    quaternion: int | None = None,
) -> tuple[float, ...] | None:
    """Initial values of a joint, one per component.

    Args:
        who, what: For messages.
        value: Of the user.
        count: How many there are.
        quaternion: Which of them is the scalar part of a unit quaternion, if any.

    Raises:
        ModelError: a wrong number of them, or a quaternion whose length is not 1.
    """
    if value is None:
        return None
    one = is_number(value) or isinstance(value, str) or not hasattr(value, "__len__")
    entries: tuple[Value, ...] = (value,) if one else tuple(value)  # type: ignore[arg-type]
    if len(entries) != count:
        raise ModelError(f"{who}: {what} has {len(entries)} entries, but {count} are wanted")
    numbers = tuple(number(f"{who}: {what}", entry) for entry in entries)
    if quaternion is not None:
        length = math.hypot(*numbers[quaternion : quaternion + 4])
        if abs(length - 1) > UNIT:
            raise ModelError(
                f"{who}: the quaternion in {what} has length {length:.9g}: a rotation has length "
                "1. Divide its four components by that"
            )
    return numbers


def mass(body: str, value: object, inertia: Sequence[object], robot: bool = False) -> None:
    """Mass and inertia given as numbers can be those of a body.

    Args:
        body, value, inertia: Its name, mass and tensor xx xy xz yy yz zz.
        robot: Of a file that others wrote, whose negative moments are no more than told: published
            robot files contain some.

    Raises:
        ModelError: negative or NaN mass, NaN inertia, a negative principal moment.
    """
    if value is not None and is_number(value) and number(f"body '{body}': mass", value) < 0:
        raise ModelError(f"body '{body}': mass is {value} kg; it must not be negative")
    if all(is_number(entry) for entry in inertia):
        numbers = [number(f"body '{body}': inertia", entry) for entry in inertia]
        if any(numbers):
            least = smallest_moment(numbers)
            said = (
                f"its inertia has the negative principal moment {least:.6g} kg m^2, which no body "
                "has; check the entries and their signs"
            )
            if least < 0 and not robot:
                raise ModelError(f"body '{body}': {said}")
            problem = said if least < 0 else unphysical(numbers)
            # one moment alone: whether a motion feels the others shows when joints are known
            if problem and (least < 0 or lone_moment(numbers) is None):
                warn(f"body '{body}': {problem}", ImpossibleWarning)


def lone_moment(inertia: Sequence[float]) -> int | None:
    """The axis 0, 1, 2 about which xx xy xz yy yz zz has its only entry; None where it has others.

    Of a body that turns about that axis alone the others are left out, as nothing feels them.
    """
    entries = [k for k, entry in enumerate(inertia) if entry]
    return {0: 0, 3: 1, 5: 2}.get(entries[0]) if len(entries) == 1 else None


def smallest_moment(inertia: Sequence[float]) -> float:
    """The least principal moment of xx xy xz yy yz zz; 0 where rounding made it negative."""
    xx, xy, xz, yy, yz, zz = inertia
    moments = [xx, yy, zz]
    if xy or xz or yz:
        import numpy as np

        moments = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).tolist()
    least = min(moments)
    # files are rounded: so much that it could be 0 is not a sign
    return 0.0 if abs(least) <= ROUNDED * max(map(abs, moments)) else least


def unphysical(inertia: Sequence[float]) -> str:
    """Why a tensor xx xy xz yy yz zz is that of no mass distribution; "" where it may be one.

    The principal moments a <= b <= c of a body satisfy 0 <= a and c <= a + b. With the trace s,
    both hold exactly when s/2 - I is positive semidefinite.

    Source: Wensing, Kim and Slotine, Linear matrix inequalities for physically consistent inertial
    parameter identification, 2018.
    """
    scale = max(abs(entry) for entry in inertia)
    if scale == 0:
        return ""
    xx, xy, xz, yy, yz, zz = (entry / scale for entry in inertia)
    half = (xx + yy + zz) / 2
    # s/2 - I; all its principal minors must not be negative, apart from rounding in files
    a, b, c, d, e, f = half - xx, -xy, -xz, half - yy, -yz, half - zz
    minors = [a, d, f, a * d - b * b, a * f - c * c, d * f - e * e]
    minors.append(a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d))
    if min(minors) >= -1e-6:
        return ""
    return (
        "its inertia violates the triangle inequality (no body has principal moments of which one "
        "exceeds the sum of the others); check the entries and their unit"
    )


def triple(value: Any, what: str) -> tuple[Value, Value, Value]:
    """Three entries of a vector as written.

    Raises:
        ModelError: there are not three.
    """
    try:
        entries = tuple(value)
    except TypeError:
        entries = ()
    if len(entries) != 3:
        raise ModelError(f"{what}: three entries are wanted, not {brief(value)}")
    x, y, z = (quantity(what, entry) for entry in entries)
    return x, y, z


def no_place(who: str, role: str, place: object, names: Sequence[str]) -> ModelError:
    """The error for something that is neither a frame nor a body, nor the name of one.

    Args:
        who: What looks for it.
        role: What it is there.
        place: What was given.
        names: Names that exist.
    """
    interfaces = [one.name for one in getattr(getattr(place, "record", None), "interfaces", ())]
    if interfaces:
        cures = " or ".join(f"at({name!r})" for name in interfaces)
        return ModelError(
            f"{who}: {role} {brief(place)} is not a frame: take its interface {cures}"
        )
    listed = near(place, names).replace(" Known:", " Bodies:")
    text = f"'{place}'" if isinstance(place, str) else brief(place)
    return ModelError(f"{who}: {role} {text} does not exist.{listed}")
