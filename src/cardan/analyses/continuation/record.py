"""Paths of equilibria with their special points, as records."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import overload

import numpy as np

from ...arguments import checked
from ...arrays import Array, Integers
from ...errors import ModelError, counted, near
from ...runtime.models.loaded_model import LoadedModel
from ..statics.equilibrium import EquilibriumRecord
from ..statics.equilibrium import record as equilibrium_record
from ..statics.newton import Search
from ..statics.stability_at_equilibrium import largest_motions
from .curve import BRANCH, EVENT, FOLD, HOPF, Curve, Special
from .equilibria import EquilibriumFamily, Loaded
from .quantities import quantity
from .stability_cache import StabilityCache

MAX_PRINTED = 24


@dataclass(frozen=True, repr=False, eq=False)
class SpecialPointRecord:
    """A special point of a path.

    Attributes:
        name: ``"fold 1"``, ``"branch point 2"``, ``"Hopf point 1"``, or the event.
        kind: ``"fold"``, ``"branch point"``, ``"Hopf point"`` or ``"event"``.
        values: What is swept, by name.
        kernel: Increments (nu + nz, k + 1) without units that leave a branch point in equilibrium
            to first order; the direction (nu + nz, 1) of the path elsewhere.
        tangents: Directions of the branches that leave it (branches, nu + nz + 1): increments
            without units, then that of the load as a part of its range.
        symmetric: Names of pairs of branches that are mirror images.
        branches: Names of the branches that leave it.
        frequency: Of the oscillation that begins at a Hopf point [rad/s].
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
    def equilibrium(self) -> EquilibriumRecord:
        """The equilibrium there."""
        return self.branch.equilibrium_at(self.special.place.point)

    def __getitem__(self, name: str) -> float:
        """A coordinate, output, swept value or holding force there."""
        branch = self.branch
        return quantity(branch.model, branch.family, name)(self.special.place.point)

    def __repr__(self) -> str:
        same = self.name == self.description
        return self.name if same else f"{self.name}: {self.description}"


@dataclass(frozen=True, repr=False, eq=False)
class BranchRecord:
    """A path of equilibria; ``branch["elbow"]`` is a history (n,) by name.

    ``branch[k]`` is the equilibrium of row k; ``model.simulate(10, x0=branch[-1])`` starts there.

    Attributes:
        name: ``"main"``, or that of the branch: ``"2a"`` leaves branch point 2 of the main one.
        model: The model.
        status: ``"finished"``, ``"closed"`` of a path that leads back to its start, ``"budget"``,
            ``"singular"`` or ``"interrupted"``.
        message: The same as a sentence.
        iterations, refused: Linear systems solved, steps that were halved.
        curve, stabilities: For analyses that go on from here.
    """

    name: str
    model: LoadedModel
    status: str
    message: str
    iterations: int
    refused: int
    curve: Curve = field(repr=False)
    stabilities: StabilityCache = field(repr=False)

    @classmethod
    def of(
        cls, name: str, model: LoadedModel, curve: Curve, stabilities: StabilityCache
    ) -> BranchRecord:
        """The record of a curve."""
        message = f"branch '{name}' of '{model.name}' {curve.ended or 'is not finished'}"
        return cls(
            name, model, curve.status, message, curve.corrections, curve.refused, curve, stabilities
        )

    @property
    def family(self) -> EquilibriumFamily:
        """What is solved."""
        family = self.curve.family
        assert isinstance(family, EquilibriumFamily)
        return family

    def __len__(self) -> int:
        return len(self.curve.places)

    @cached_property
    def s(self) -> Array:
        """Place of every row on the path of loads: 0 and 1 are its ends (n,)."""
        return np.array([place.point.s for place in self.curve.places])

    @property
    def values(self) -> Mapping[str, Array]:
        """What was swept, by name (n,)."""
        rows = [self.family.way.values(s) for s in self.s]
        return {name: np.array([row[name] for row in rows]) for name in self.family.way.swept}

    @property
    def q(self) -> Array:
        """Coordinates (n, nq)."""
        return np.array([place.point.point.at.q for place in self.curve.places])

    @property
    def lam(self) -> Array:
        """Multipliers (n, m)."""
        return np.array([place.point.point.at.lam for place in self.curve.places])

    @cached_property
    def n_negative(self) -> Integers:
        """Unstable directions with what is prescribed held (n,); -1 where it is not known."""
        counts = (self.stabilities.count(place) for place in self.curve.places)
        return np.array([-1 if n is None else n for n in counts], dtype=np.intp)

    @property
    def stable_held(self) -> list[bool | None]:
        """Stability of every row with displacements prescribed; None where it is not known."""
        return [self._stable(place.point, False) for place in self.curve.places]

    @property
    def stable(self) -> list[bool | None]:
        """The same under dead loads in place of what prescribes displacements."""
        return [self._stable(place.point, True) for place in self.curve.places]

    def _stable(self, at: Loaded, dead: bool) -> bool | None:
        stability = self.stabilities.stability(at)
        return (stability.under_dead_load if dead else stability).stable

    @overload
    def __getitem__(self, name: str) -> Array: ...
    @overload
    def __getitem__(self, name: int) -> EquilibriumRecord: ...
    def __getitem__(self, name: str | int) -> Array | EquilibriumRecord:
        """The equilibrium of a row, or a history (n,).

        Raises:
            ModelError: no such history.
        """
        if isinstance(name, int | np.integer):
            return self.equilibrium_at(self.curve.places[name].point)
        of = quantity(self.model, self.family, name)
        return np.array([of(place.point) for place in self.curve.places])

    def equilibrium_at(self, at: Loaded) -> EquilibriumRecord:
        """A place as an equilibrium."""
        search = Search(at.point, 0, True, np.zeros(0))
        stability = self.stabilities.stability(at)
        return equilibrium_record(self.model, self.family.problem, search, at.load, stability)

    @cached_property
    def points(self) -> tuple[SpecialPointRecord, ...]:
        """Special points, in the order of the path."""
        numbers = dict.fromkeys((FOLD, BRANCH, HOPF, EVENT), 0)
        records = list[SpecialPointRecord]()
        for special in self.curve.special:
            numbers[special.kind] += 1
            records.append(self._point(special, numbers[special.kind]))
        return tuple(records)

    def _point(self, special: Special, number: int) -> SpecialPointRecord:
        n = self.family.positions
        at = special.place.point
        singular = special.singular
        kernel = special.place.tangent[:n, None] if singular is None else singular.V[:n]
        tangents = [np.append(half.tangent[:n], half.tangent[-1]) for half in special.halves]
        prefix = f"{number}" if self.name == "main" else f"{self.name}.{number}"
        names = tuple(f"{prefix}{chr(ord('a') + k)}" for k in range(len(tangents)))
        values = self.family.way.values(at.s)
        name = special.label if special.kind == EVENT else f"{special.kind} {number}"
        pairs = tuple((names[i], names[j]) for i, j in mirrored(self.family, special))
        return SpecialPointRecord(
            name, special.kind, values, kernel,
            np.array(tangents).reshape(len(tangents), n + 1), names, pairs,
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
        system, n = self.family.problem.system, self.family.positions
        near = "" if special.accurate else "near "
        if special.kind == FOLD:
            moving = largest_motions(system, special.place.tangent[:n])
            return f"{near}{where}, where the load turns back as {moving} moves on"
        if special.kind == HOPF:
            return f"{near}{where}, where an oscillation of {special.frequency:.6g} rad/s begins"
        if special.kind == EVENT:
            return f"{near}{where}"
        if special.label:
            return f"{where}; it is {special.label}"
        if special.singular is None:
            return f"{near}{where}; what leaves it was not found. Take shorter steps: step="
        if not names:
            return f"{where}; no branch was told apart that leaves it"
        moving = " or ".join(
            dict.fromkeys(largest_motions(system, half.tangent[:n]) for half in special.halves)
        )
        mirror = "; mirror images: " + ", ".join(f"{a} and {b}" for a, b in pairs) if pairs else ""
        listed = ", ".join(names)
        many = counted(len(names), "branch", "branches")
        return f"{where}; {many} ({listed}) along {moving}{mirror}"


def mirrored(family: EquilibriumFamily, special: Special) -> Iterator[tuple[int, int]]:
    """Pairs of branches that leave a point in opposite directions under the same loads."""
    halves = special.halves
    for i, one in enumerate(halves):
        for j in range(i + 1, len(halves)):
            other = halves[j]
            opposite = float(one.tangent @ (family.weights * other.tangent)) < -1 + 1e-6
            same = abs(one.point.s - other.point.s) <= 1e-9 and abs(one.tangent[-1]) <= 1e-9
            if opposite and same:
                yield i, j


@dataclass(frozen=True, repr=False, eq=False)
class ContinuationRecord:
    """Equilibria along a path of loads, and branches that leave it.

    ``path["elbow"]`` is a history (n,) of the main branch, ``path.branches["1a"]["elbow"]`` that of
    another one; ``path[k]`` is an equilibrium of the main branch.

    Attributes:
        model: The model.
        family: What was solved.
        branches: By name, ``"main"`` first.
    """

    model: LoadedModel
    family: EquilibriumFamily = field(repr=False)
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
        """How the main branch ended."""
        return self.main.message

    def __len__(self) -> int:
        return len(self.main)

    @overload
    def __getitem__(self, name: str) -> Array: ...
    @overload
    def __getitem__(self, name: int) -> EquilibriumRecord: ...
    def __getitem__(self, name: str | int) -> Array | EquilibriumRecord:
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
            lines += (
                [f"    ... {len(points) - MAX_PRINTED} more"] if len(points) > MAX_PRINTED else []
            )
        return "\n".join(lines)
