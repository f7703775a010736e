"""Paths of solutions with their special points, as records."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from typing import overload

import numpy as np

from ...arguments import checked
from ...arrays import Array, Integers
from ...errors import ModelError, counted, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from .curve import Curve
from .postbuckling import Postbuckling, postbuckling
from .solutions import Solution, Solutions
from .special_points import BRANCH, EVENT, Special

MAX_PRINTED = 24
LEVEL = 1e-7  # a slope of the load that is none; beams have it to 1e-8


@dataclass(frozen=True, repr=False, eq=False)
class SpecialPointRecord:
    """A special point of a path.

    Attributes:
        name: ``"fold 1"``, ``"branch point 2"``, ``"Hopf point 1"``, or the event.
        kind: ``"fold"``, ``"branch point"``, ``"Hopf point"``, ``"period doubling"``, ``"torus
            point"``, ``"state of rest"`` or ``"event"``.
        values: What is swept, by name.
        kernel: Increments (nu + nz, k + 1) without units that leave a branch point in equilibrium
            to first order; the direction (nu + nz, 1) of the path elsewhere.
        tangents: Directions of the branches that leave it (branches, nu + nz + 1): increments
            without units, then that of the load as a part of its range.
        symmetric: Names of pairs of branches that are mirror images; one name twice where one
            branch leaves and comes back.
        branches: Names of the branches that leave it; one that passes it is named twice.
        frequency: Of the oscillation that begins at a Hopf point [rad/s]; the angle from lap to
            lap at a torus point [rad].
        accurate: False where it is only known to lie in a short step, which the description says.
        description: What it is, in a sentence.
    """

    name: str
    kind: str
    values: Mapping[str, float]
    kernel: Array
    tangents: Array
    branches: tuple[str, ...]
    symmetric: tuple[tuple[str, str], ...]
    frequency: float
    accurate: bool
    description: str
    special: Special = field(repr=False)
    branch: BranchRecord = field(repr=False)

    @property
    def solution(self) -> Solution:
        """The equilibrium, position or cycle there, as ``path[k]`` is one."""
        return self.branch.solutions.record(self.special.place.point)

    @checked
    def postbuckling(self, name: str, load: str | None = None) -> Mapping[str, Postbuckling]:
        """Koiter's a and b of every branch that leaves: P = P_c (1 + a x + b x^2).

        Args:
            name: Name of x, such as a coordinate that is 0 before.
            load: Name of P; what is swept by default.

        Raises:
            ModelError: unknown names, or P_c is 0.
        """
        of = load or next(iter(self.values))
        coefficients = postbuckling(self.branch.solutions, self.special, of, name)
        return dict(zip(self.branches, coefficients, strict=True))

    def __getitem__(self, name: str) -> float:
        """A coordinate, output, swept value or holding force there."""
        return self.branch.solutions.quantity(name)(self.special.place.point)

    def __repr__(self) -> str:
        same = self.name == self.description
        return self.name if same else f"{self.name}: {self.description}"


@dataclass(frozen=True, repr=False, eq=False)
class BranchRecord:
    """A path of equilibria or positions; ``branch["elbow"]`` is a history (n,) by name.

    ``branch[k]`` is that of row k; ``model.simulate(10, x0=branch[-1])`` starts there.

    Attributes:
        name: ``"main"``, or that of the branch: ``"2a"`` leaves branch point 2 of the main one.
        status: ``"finished"``, ``"closed"`` of a path that leads back to its start, ``"joined"`` of
            one that leads to the end of another, ``"budget"``, ``"singular"`` or ``"interrupted"``.
        message: The same as a sentence.
        iterations, refused: Linear systems solved, steps that were halved.
        curve, solutions: For analyses that go on from here.
    """

    name: str
    status: str
    message: str
    iterations: int
    refused: int
    curve: Curve = field(repr=False)
    solutions: Solutions = field(repr=False)

    @classmethod
    def of(cls, name: str, curve: Curve, solutions: Solutions) -> BranchRecord:
        """The record of a curve."""
        message = f"branch '{name}' of '{solutions.model.name}' {curve.ended or 'is not finished'}"
        return cls(name, curve.status, message, curve.corrections, curve.refused, curve, solutions)

    @property
    def model(self) -> LoadedModel:
        """The model."""
        return self.solutions.model

    def __len__(self) -> int:
        return len(self.curve.places)

    @property
    def values(self) -> Mapping[str, Array]:
        """Swept quantities by name (n,)."""
        rows = [self.solutions.values(place.point) for place in self.curve.places]
        return {name: np.array([row[name] for row in rows]) for name in rows[0]}

    @property
    def q(self) -> Array:
        """Coordinates (n, nq)."""
        return np.array([self.solutions.coordinates(place.point) for place in self.curve.places])

    @property
    def lam(self) -> Array:
        """Multipliers (n, m)."""
        return np.array([self.solutions.multipliers(place.point) for place in self.curve.places])

    @cached_property
    def n_negative(self) -> Integers:
        """Unstable directions with what is prescribed held (n,); -1 where it is not known."""
        counts = (self.solutions.count(place) for place in self.curve.places)
        return np.array([-1 if n is None else n for n in counts], dtype=np.intp)

    @property
    def stable_held(self) -> list[bool | None]:
        """Stability of every row with displacements prescribed; None where it is not known."""
        return [self.solutions.stable(place.point, True) for place in self.curve.places]

    @property
    def stable(self) -> list[bool | None]:
        """The same under dead loads in place of what prescribes displacements."""
        return [self.solutions.stable(place.point, False) for place in self.curve.places]

    @overload
    def __getitem__(self, name: str) -> Array: ...
    @overload
    def __getitem__(self, name: int) -> Solution: ...
    def __getitem__(self, name: str | int) -> Solution:
        """The equilibrium of a row, or a history (n,).

        Raises:
            ModelError: no such history.
        """
        if isinstance(name, int | np.integer):
            return self.solutions.record(self.curve.places[name].point)
        of = self.solutions.quantity(name)
        return np.array([of(place.point) for place in self.curve.places])

    @cached_property
    def points(self) -> tuple[SpecialPointRecord, ...]:
        """Special points, in the order of the path."""
        numbers = dict[str, int]()
        records = list[SpecialPointRecord]()
        for special in self.curve.special:
            numbers[special.kind] = numbers.get(special.kind, 0) + 1
            records.append(self._point(special, numbers[special.kind]))
        return tuple(records)

    def _point(self, special: Special, number: int) -> SpecialPointRecord:
        of, singular = self.solutions, special.singular
        kernel = of.motion(special.place.tangent[:, None] if singular is None else singular.V)
        tangents = np.array(
            [np.append(of.motion(half.tangent), half.tangent[-1]) for half in special.halves]
        )
        prefix = f"{number}" if self.name == "main" else f"{self.name}.{number}"
        names = tuple(
            special.followed.get(k, f"{prefix}{chr(ord('a') + k)}") for k in range(len(tangents))
        )
        values = of.values(special.place.point)
        name = special.label if special.kind == EVENT else f"{special.kind} {number}"
        pairs = tuple((names[i], names[j]) for i, j in mirrored(of, special))
        return SpecialPointRecord(
            name, special.kind, values, kernel,
            tangents.reshape(len(names), len(kernel) + 1), names, pairs,
            special.frequency, special.accurate,
            self._description(special, values, names, pairs), special, self,
        )  # fmt: skip

    def _description(
        self,
        special: Special,
        values: Mapping[str, float],
        names: Sequence[str],
        pairs: Sequence[tuple[str, str]],
    ) -> str:
        """What a special point is."""
        where = ", ".join(f"{name} = {value:.10g}" for name, value in values.items())
        near = "" if special.accurate else "near "
        if special.kind == EVENT:
            return f"{near}{where}"
        if special.kind != BRANCH:
            return f"{near}{where}, {self.solutions.description(special)}"
        if special.label:
            return f"{where}; it is {special.label}"
        if special.singular is None:
            return f"{near}{where}; what leaves it was not found. Take shorter steps: step="
        if not names:
            return f"{where}; no branch was told apart that leaves it"
        moving = " or ".join(
            dict.fromkeys(self.solutions.moving(half.tangent) for half in special.halves)
        )
        images = (f"both ends of {a}" if a == b else f"{a} and {b}" for a, b in pairs)
        mirror = "; mirror images: " + ", ".join(images) if pairs else ""
        listed = dict.fromkeys(names)
        many = counted(len(listed), "branch", "branches")
        return f"{where}; {many} ({', '.join(listed)}) along {moving}{mirror}"


def mirrored(solutions: Solutions, special: Special) -> Iterator[tuple[int, int]]:
    """Pairs of branches that leave a point in opposite directions under the same loads."""
    family, halves = solutions.family, special.halves
    for i, one in enumerate(halves):
        for j in range(i + 1, len(halves)):
            other = halves[j]
            opposite = float(one.tangent @ (family.weights * other.tangent)) < -1 + 1e-6
            difference = family.parameter(one.point) - family.parameter(other.point)
            same = abs(difference) <= 1e-9 and abs(one.tangent[-1]) <= LEVEL
            if opposite and same:
                yield i, j


@dataclass(frozen=True, repr=False, eq=False)
class ContinuationRecord:
    """Equilibria, positions or cycles along a path, and branches that leave it.

    ``path["elbow"]`` is a history (n,) of the main branch, ``path.branches["1a"]["elbow"]`` that of
    another one; ``path[k]`` is a solution of the main branch.

    Attributes:
        model: The model.
        branches: By name, ``"main"`` first.
    """

    model: LoadedModel
    branches: Mapping[str, BranchRecord]

    @property
    def main(self) -> BranchRecord:
        """The path that was asked for."""
        return next(iter(self.branches.values()))

    @property
    def points(self) -> tuple[SpecialPointRecord, ...]:
        """Special points of the main branch, in its order."""
        return self.main.points

    @property
    def success(self) -> bool:
        """True when the main branch reached an end that was asked for."""
        return self.main.status in ("finished", "closed")

    @property
    def message(self) -> str:
        """The end of the main branch, in words."""
        return self.main.message

    def __len__(self) -> int:
        return len(self.main)

    @overload
    def __getitem__(self, name: str) -> Array: ...
    @overload
    def __getitem__(self, name: int) -> Solution: ...
    def __getitem__(self, name: str | int) -> Solution:
        """The equilibrium of a row of the main branch, or a history (n,)."""
        return self.main[name]

    @checked
    def point(self, name: str) -> SpecialPointRecord:
        """A special point by its name, of the main branch.

        Raises:
            ModelError: there is none.
        """
        for point in self.points:
            if point.name == name:
                return point
        names = [point.name for point in self.points]
        raise ModelError(f"there is no '{name}' on the path.{near(name, names)}")

    def __repr__(self) -> str:
        ends = ", ".join(f"{n} = {v[0]:.6g} ... {v[-1]:.6g}" for n, v in self.main.values.items())
        lines = [f"continuation of '{self.model.name}', {ends}: {self.main.curve.ended}"]
        for branch in self.branches.values():
            lines.append(
                f"  '{branch.name}': {counted(len(branch), 'point')}, "
                f"{counted(branch.iterations, 'linear system')}, "
                f"{counted(branch.refused, 'step')} halved; {branch.status}"
            )
            points = branch.points
            lines += [f"    {point}" for point in points[:MAX_PRINTED]]
            more = len(points) - MAX_PRINTED
            lines += [f"    ... {more} more"] * (more > 0)
        return "\n".join(lines)
