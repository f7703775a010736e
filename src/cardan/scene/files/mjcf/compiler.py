"""Settings of <compiler>: conventions of angles and orientations, source of masses."""

from __future__ import annotations

import math

from ....errors import ModelError
from ....records import dataclass
from ....spatial.numbers import UPRIGHT, Rows, about, of_quaternion, product, unit, upright_to
from ..document import Element
from ..pose import Pose

ORIENTATIONS = ("quat", "axisangle", "xyaxes", "zaxis", "euler")


@dataclass(frozen=True)
class Compiler:
    """The settings of a file.

    Attributes:
        degree: Radians per unit of angles.
        sequence: Axes of Euler angles; small letters turn with the body, capital ones do not.
        limited: A joint with a range is limited.
        masses: ``auto``: from geoms where a body has no <inertial>; ``true``: always; ``false``:
            never.
        groups: First and last group of geoms that have mass.
        total: Mass that all bodies together are scaled to [kg], negative for none.
    """

    degree: float = math.pi / 180
    sequence: str = "xyz"
    limited: bool = True
    masses: str = "auto"
    groups: tuple[float, float] = (0, 5)
    total: float = -1.0

    @staticmethod
    def read(element: Element) -> Compiler:
        """The settings of <compiler>.

        Raises:
            ModelError: an unknown word, or global coordinates.
        """
        angle = chosen(element, "angle", ("degree", "radian"), "degree")
        if element.text("coordinate", "local") != "local":
            raise ModelError(
                f"{element.where}: coordinate='{element.text('coordinate')[:40]}' is not read; "
                "save the model again with a newer MuJoCo, which makes it local"
            )
        sequence = element.text("eulerseq", "xyz")
        if len(sequence) != 3 or sequence.lower().strip("xyz"):
            raise ModelError(
                f"{element.where}: eulerseq='{sequence[:40]}' is not three letters of xyzXYZ"
            )
        low, high = element.numbers("inertiagrouprange", 2, "0 5")
        return Compiler(
            math.pi / 180 if angle == "degree" else 1.0,
            sequence,
            chosen(element, "autolimits", ("true", "false"), "true") == "true",
            chosen(element, "inertiafromgeom", ("auto", "true", "false"), "auto"),
            (low, high),
            element.number("settotalmass", "-1"),
        )

    def pose(self, element: Element) -> Pose:
        """Position and orientation of an element."""
        x, y, z = element.numbers("pos", 3, "0 0 0")
        return Pose(self.orientation(element), (x, y, z))

    def orientation(self, element: Element) -> Rows:
        """Its axes in those of its parent, however they are written.

        Raises:
            ModelError: written twice, or a direction of length 0.
        """
        attributes = [name for name in ORIENTATIONS if element.raw.get(name) is not None]
        if len(attributes) > 1:
            raise ModelError(
                f"{element.where}: its orientation is given by {' and '.join(attributes)}; keep one"
            )
        if not attributes:
            return UPRIGHT
        if attributes[0] == "quat":
            w, x, y, z = element.numbers("quat", 4)
            self._direction(element, "quat", (w, x, y, z))
            return of_quaternion(w, x, y, z)
        if attributes[0] == "axisangle":
            *axis, angle = element.numbers("axisangle", 4)
            self._direction(element, "axisangle", axis)
            return about(unit(axis), angle * self.degree)
        if attributes[0] == "zaxis":
            axis = element.numbers("zaxis", 3)
            self._direction(element, "zaxis", axis)
            return upright_to(axis)
        if attributes[0] == "xyaxes":
            return self._two_axes(element)
        rows = UPRIGHT
        for letter, angle in zip(self.sequence, element.numbers("euler", 3), strict=True):
            turn = about(UPRIGHT["xyz".index(letter.lower())], angle * self.degree)
            rows = product(rows, turn) if letter.islower() else product(turn, rows)
        return rows

    def _two_axes(self, element: Element) -> Rows:
        """x as given, y made perpendicular to it, z completes them."""
        entries = element.numbers("xyaxes", 6)
        self._direction(element, "xyaxes", entries[:3])
        x = unit(entries[:3])
        along = sum(a * b for a, b in zip(x, entries[3:], strict=True))
        across = [b - along * a for a, b in zip(x, entries[3:], strict=True)]
        self._direction(element, "xyaxes", across)
        y = unit(across)
        z = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
        return [[x[i], y[i], z[i]] for i in range(3)]

    def _direction(
        self, element: Element, name: str, numbers: list[float] | tuple[float, ...]
    ) -> None:
        # the square of a smaller number is 0, or loses its digits
        if not math.hypot(*numbers) > 1e-14:
            raise ModelError(f"{element.where}: {name} has no direction: its length is 0")


def chosen(element: Element, name: str, choices: tuple[str, ...], default: str) -> str:
    """An attribute that is one of a few words.

    Raises:
        ModelError: another one.
    """
    word = element.text(name, default)
    if word not in choices:
        raise ModelError(
            f"{element.where}: {name}='{word[:40]}' of <{element.raw.tag}> is none of "
            f"{', '.join(choices)}"
        )
    return word
