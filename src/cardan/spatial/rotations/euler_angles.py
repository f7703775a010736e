"""Three angles about coordinate axes: the 12 sequences, body-fixed and space-fixed."""

from __future__ import annotations

import math
from itertools import product

from ...ir.arithmetic import Scalar, atan2, cos, sin, sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from ..axis import elementary
from .rotation import Rotation


@dataclass(frozen=True)
class EulerAngles(Rotation):
    """Rotations by three angles about coordinate axes, one after the other.

    Capital letters, as in "ZYX", are axes of the body as it turns (R = R_z R_y R_x); small ones, as
    in "xyz", axes that stand still (R = R_z R_y R_x too, angles in the order of the name). With
    three different axes (Tait-Bryan) the middle angle must stay off +-pi/2, with equal outer axes
    (Euler) off 0 and pi: there the outer axes coincide and the rates grow without bound.

    Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 2.3.
    """

    name: str
    components: tuple[str, ...] = ("angle1", "angle2", "angle3")
    units: tuple[str, ...] = ("rad", "rad", "rad")
    defaults: tuple[float, ...] = (0.0, 0.0, 0.0)

    @property
    def axes(self) -> tuple[int, int, int]:
        """Axes in the order of a body-fixed sequence."""
        letters = self.name.lower() if self.name.isupper() else self.name[::-1]
        first, middle, last = ("xyz".index(letter) for letter in letters)
        return first, middle, last

    @property
    def proper(self) -> bool:
        """True where the outer axes are the same."""
        return self.name[0] == self.name[2]

    @property
    def parity(self) -> int:
        """1 where the second axis follows the first in x, y, z, x, ...; else -1."""
        first, middle, _ = self.axes
        return 1 if middle == (first + 1) % 3 else -1

    @property
    def domain(self) -> str:  # type: ignore[override]
        """Region in which the rates are finite."""
        return (
            "second angle between 0 and pi" if self.proper else "second angle within +-pi/2"
        ) + ", ends excluded"

    def _ordered(self, q: Matrix) -> tuple[Scalar, Scalar, Scalar]:
        """The angles in the order of the body-fixed sequence."""
        a, b, c = q
        return (a, b, c) if self.name.isupper() else (c, b, a)

    def _written(self, a: Scalar, b: Scalar, c: Scalar) -> Matrix:
        """The reverse: angles of the body-fixed sequence in the order of the name."""
        return Matrix.vector(a.graph, [a, b, c] if self.name.isupper() else [c, b, a])

    def matrix(self, q: Matrix) -> Matrix:
        r1, r2, r3 = (
            elementary(axis, cos(angle), sin(angle))
            for axis, angle in zip(self.axes, self._ordered(q), strict=True)
        )
        return r1 @ r2 @ r3

    def _outer(self, b: Scalar) -> tuple[Scalar, Scalar]:
        """The first axis turned back by the middle angle: its parts along the last axis, across.

        Across is the first axis itself for Tait-Bryan angles, the third direction for Euler's.
        """
        if self.proper:
            return cos(b), sin(b) * self.parity
        return sin(b) * self.parity, cos(b)

    def _across(self) -> int:
        first, middle, _ = self.axes
        return 3 - first - middle if self.proper else first

    def rates(self, q: Matrix, omega: Matrix) -> Matrix:
        _, b, c = self._ordered(q)
        _, middle, last = self.axes
        rotated = elementary(last, cos(c), sin(c)) @ omega
        along, across = self._outer(b)
        first_rate = rotated[self._across()] / across
        return self._written(first_rate, rotated[middle], rotated[last] - along * first_rate)

    def omega(self, q: Matrix, qdot: Matrix) -> Matrix:
        _, b, c = self._ordered(q)
        da, db, dc = self._ordered(qdot)
        _, middle, last = self.axes
        along, across = self._outer(b)
        entries: dict[int, Scalar] = {
            self._across(): across * da,
            middle: db,
            last: along * da + dc,
        }
        rotated = Matrix.vector(q.graph, [entries[k] for k in range(3)])
        return elementary(last, cos(c), sin(c)).T @ rotated

    def from_matrix(self, R: Matrix) -> Matrix:
        i, j, k = self.axes
        m = 3 - i - j
        p = float(self.parity)
        if self.proper:
            first = atan2(R[j, i], R[m, i] * -p)
            middle = atan2(sqrt(R[i, j] ** 2 + R[i, m] ** 2), R[i, i])
        else:
            first = atan2(R[j, k] * -p, R[k, k])
            middle = atan2(R[i, k] * p, sqrt(R[i, i] ** 2 + R[i, j] ** 2))
        # the last angle from R turned back by the first: where only their sum is determined,
        # the three still make R
        row = elementary(i, cos(first), sin(first)).T @ R
        last = atan2(row[j, m] * -p, row[j, j]) if self.proper else atan2(row[j, i] * p, row[j, j])
        return self._written(first, middle, last)

    def integrate(self, q: Matrix, du: Matrix) -> Matrix:
        """Angles within half a turn of the former ones: a motion goes on through pi."""
        angles = super().integrate(q, du)
        rows = []
        for before, after in zip(q, angles, strict=True):
            turns = ((before - after) * (0.5 / math.pi) + 0.5).apply("floor")
            rows.append(after + turns * (2 * math.pi))
        return Matrix.vector(q.graph, rows)

    def margin(self, q: Matrix) -> Scalar:
        return (sin(q[1]) if self.proper else cos(q[1])).apply("abs")


# every sequence whose neighbors differ
SEQUENCES = tuple(
    "".join(letters)
    for alphabet in ("XYZ", "xyz")
    for letters in product(alphabet, repeat=3)
    if letters[0] != letters[1] != letters[2]
)
