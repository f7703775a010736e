"""Beams of flexible elements, and their equilibrium by full steps of Newton's method."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import spsolve
from scipy.spatial.transform import Rotation

from cardan.elements.flexible import FlexibleElement
from cardan.ir.function import Function
from elements.flexible.compiled import compiled
from elements.flexible.states import quaternion, rotation

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Part:
    """Elements of one kind along a beam.

    Attributes:
        element: Which.
        data: Their p (n, number of data).
        functions: Theirs.
    """

    element: FlexibleElement
    data: Array
    functions: dict[str, Function] = field(repr=False)

    def value(self, name: str, **blocks: Array) -> dict[str, Any]:
        """Results for all elements."""
        return compiled(self.functions[name])(self.data, **blocks)


@dataclass(frozen=True)
class Beam:
    """A chain of nodes.

    Attributes:
        stations: Arc lengths of the nodes (n + 1,).
        q: Unit quaternion and position of every node (n + 1, 7).
        parts: What connects neighbors.
    """

    stations: Array
    q: Array
    parts: tuple[Part, ...] = ()

    @property
    def pairs(self) -> Array:
        """q of the two ends of every element (n, 14)."""
        return np.hstack([self.q[:-1], self.q[1:]])

    def of(self, element: FlexibleElement, **numbers: float) -> Beam:
        """With one more kind of elements, in the present shape without stress."""
        own = element.rows(self.stations, self.pairs)
        common = np.tile([numbers.get(name, 0.0) for name in element.common], (len(own), 1))
        part = Part(element, np.hstack([common, own]), _functions(element))
        return replace(self, parts=(*self.parts, part))

    def moved(self, du: Array) -> Beam:
        """Every node moved by its increment (n + 1, 6)."""
        turned = rotation(self.q[:, :4]) * Rotation.from_rotvec(du[:, :3])
        return replace(self, q=np.hstack([quaternion(turned), self.q[:, 4:] + du[:, 3:]]))

    def balance(self) -> Array:
        """What every node must be held with at rest (n + 1, 6)."""
        rest = np.zeros((len(self.pairs), 12))
        total = np.zeros((len(self.q), 6))
        for part in self.parts:
            _add(total, part.value("balance", q=self.pairs, u=rest, udot=rest)["balance"])
        return total

    def tangent(self, name: str = "K", u: Array | None = None) -> Array:
        """A tangent of all nodes, dense."""
        rest = np.zeros((len(self.pairs), 12))
        n = len(self.q)
        total = np.zeros((6 * n, 6 * n))
        for part in self.parts:
            found = part.value("balance_tangent", q=self.pairs, u=rest, udot=rest)
            if name in found:
                _assemble(total, found[name])
        return total


@lru_cache(maxsize=32)
def _functions(element: FlexibleElement) -> dict[str, Function]:
    return dict(element.derived())


def _add(total: Array, of_elements: Array) -> None:
    total[:-1] += of_elements[:, :6]
    total[1:] += of_elements[:, 6:]


def _assemble(total: Array, of_elements: Array) -> None:
    for e, block in enumerate(of_elements):
        total[6 * e : 6 * e + 12, 6 * e : 6 * e + 12] += block


def straight(n: int, length: float = 1.0) -> Beam:
    """Along x from the origin."""
    stations = np.linspace(0, length, n + 1)
    q = np.zeros((n + 1, 7))
    q[:, 0], q[:, 4] = 1, stations
    return Beam(stations, q)


def arc(n: int, radius: float, angle: float) -> Beam:
    """From the origin along y, curving to x."""
    s = np.linspace(0, angle, n + 1)
    position = radius * np.stack([1 - np.cos(s), np.sin(s), 0 * s], axis=1)
    along, up = np.stack([np.sin(s), np.cos(s), 0 * s], axis=1), np.tile([0, 0, 1.0], (n + 1, 1))
    axes = Rotation.from_matrix(np.stack([along, np.cross(up, along), up], axis=2))
    return Beam(radius * s, np.hstack([quaternion(axes), position]))


@dataclass(frozen=True)
class Equilibrium:
    """Where Newton's method ended.

    Attributes:
        beam: In equilibrium.
        steps: Largest increments of the steps.
    """

    beam: Beam
    steps: tuple[float, ...]

    @property
    def tip(self) -> Array:
        """Position of the last node."""
        found: Array = self.beam.q[-1, 4:]
        return found


def equilibrium(
    beam: Beam, load: Array, held: Sequence[int] = range(6), mixed: bool = True, most: int = 40
) -> Equilibrium:
    """Full steps until the increments vanish.

    Args:
        beam: Where to start from.
        load: Moments (axes of the node) and forces on the nodes (n + 1, 6).
        held: Numbers of the speeds that do not move, of all nodes one after the other.
        mixed: Whether stress is an unknown where the element has it so.
        most: Steps before it counts as divergence.
    """
    n = len(beam.q)
    free = np.setdiff1d(np.arange(6 * n), held)
    stress = [_stress(part, beam) for part in beam.parts]
    steps: list[float] = []
    small = 1e-9 * beam.stations[-1]
    while not steps or steps[-1] > small:
        if len(steps) == most:
            raise ArithmeticError(f"no equilibrium: increments {steps}")
        total, matrix = np.zeros((n, 6)), np.zeros((6 * n, 6 * n))
        for part, z in zip(beam.parts, stress, strict=True):
            b, K = _response(part, beam, z, mixed)
            _add(total, b)
            _assemble(matrix, K)
        du = np.zeros(6 * n)
        right = (load - total).ravel()
        du[free] = spsolve(csc_matrix(matrix[np.ix_(free, free)]), right[free])
        nodes = du.reshape(n, 6)
        for k, (part, z) in enumerate(zip(beam.parts, stress, strict=True)):
            if mixed and "mixed_step" in part.functions:
                pairs = np.hstack([nodes[:-1], nodes[1:]])
                stress[k] = part.value("mixed_step", q=beam.pairs, z=z, du=pairs)["z"]
        beam = beam.moved(nodes)
        steps.append(float(np.abs(du).max()))
    return Equilibrium(beam, tuple(steps))


def _stress(part: Part, beam: Beam) -> Array:
    """Of the middle of every element."""
    none = np.zeros((len(beam.pairs), 12))
    if "mixed" not in part.functions:
        return none[:, :6]
    found: Array = part.value("mixed_step", q=beam.pairs, z=none[:, :6], du=none)["z"]
    return found


def _response(part: Part, beam: Beam, z: Array, mixed: bool) -> tuple[Array, Array]:
    """Balance and stiffness of the elements of a part."""
    if mixed and "mixed" in part.functions:
        found = part.value("mixed", q=beam.pairs, z=z)
        return found["balance"], found["K"]
    rest = np.zeros((len(beam.pairs), 12))
    found = part.value("balance_tangent", q=beam.pairs, u=rest, udot=rest)
    b = part.value("balance", q=beam.pairs, u=rest, udot=rest)["balance"]
    return b, found.get("K", np.zeros((len(b), 12, 12)))


def order(errors: Sequence[float]) -> Array:
    """Observed orders at bisected meshes."""
    return np.log2(np.divide(errors[:-1], errors[1:]))
