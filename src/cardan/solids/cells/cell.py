"""What a kind of cells says, and the tables of shape functions that follow from it."""

from __future__ import annotations

from functools import cached_property
from itertools import product

import numpy as np

from ...arrays import Array
from ...records import dataclass

# coefficients of shape functions are multiples of 1/64 where they differ by rounding alone
DYADIC, ROUNDING = 64, 1e-12


@dataclass(frozen=True)
class Rule:
    """A rule of quadrature in the reference cell.

    Attributes:
        points: Coordinates (points, dimension).
        weights: Weights (points,); their sum is the size of the reference cell.
    """

    points: Array
    weights: Array


@dataclass(frozen=True, eq=False)
class Cell:
    """A kind of cells.

    Attributes:
        kind: Name, such as ``"tet10"``.
        meshio: Name in meshio; nodes have the order of meshio, which is that of VTK.
        abaqus: Names in Abaqus and CalculiX; variants with fewer points are integrated fully here.
        nodes: Reference coordinates of the nodes, corners first.
        powers: Exponents of the monomials that the shape functions are made of, one per node.
        linear: Exponents of those that interpolate between corners; stresses are extrapolated to
            the nodes by them.
        edges: Corners at the ends of the edge of each node between corners, in the order of nodes.
        faces: Nodes of each face, ordered as the cell of the face orders them, positive outside;
            in the order of their numbers in Abaqus.
        stiffness, mass, stress: Rules for stiffness, for mass, and for points of good stresses.
        triangles: Of a face: flat triangles between its nodes, for pictures.
    """

    kind: str
    meshio: str
    abaqus: tuple[str, ...]
    nodes: tuple[tuple[float, ...], ...]
    powers: tuple[tuple[int, ...], ...]
    linear: tuple[tuple[int, ...], ...]
    edges: tuple[tuple[int, int], ...]
    faces: tuple[tuple[int, ...], ...]
    stiffness: Rule
    mass: Rule
    stress: Rule
    triangles: tuple[tuple[int, int, int], ...] = ()

    @property
    def dimension(self) -> int:
        """3 for solids, 2 for faces."""
        return len(self.nodes[0])

    @property
    def corners(self) -> int:
        """The number of nodes that are corners."""
        return len(self.nodes) - len(self.edges)

    @cached_property
    def _coefficients(self) -> Array:
        """Column a: coefficients of shape function a by monomial."""
        values = monomials(np.array(self.nodes, float), self.powers)
        inverse = np.linalg.inv(values)
        exact = np.round(inverse * DYADIC) / DYADIC
        result: Array = np.where(np.abs(inverse - exact) < ROUNDING, exact, inverse)
        return result

    def shape(self, points: Array) -> Array:
        """Shape functions (points, nodes) at points of the reference cell."""
        values: Array = monomials(points, self.powers) @ self._coefficients
        return values

    def slope(self, points: Array) -> Array:
        """Their derivatives (points, nodes, dimension) by the reference coordinates."""
        columns = []
        for axis in range(self.dimension):
            factors = np.array([power[axis] for power in self.powers], float)
            lower = tuple(
                tuple(max(0, p - (k == axis)) for k, p in enumerate(power)) for power in self.powers
            )
            columns.append((monomials(points, lower) * factors) @ self._coefficients)
        return np.stack(columns, axis=-1)

    @cached_property
    def extrapolation(self) -> Array:
        """Values at the nodes (nodes, points) by values at the points of the rule for stresses.

        Least squares by the functions between corners: constants stay exact, and so does what is
        linear in the reference coordinates if the rule has enough points.
        """
        count = len(self.stress.weights)
        powers = self.linear if count >= len(self.linear) else self.linear[:1]
        at_points, at_nodes = (
            monomials(points, powers) for points in (self.stress.points, np.array(self.nodes))
        )
        result: Array = at_nodes @ np.linalg.pinv(at_points)
        return result


def monomials(points: Array, powers: tuple[tuple[int, ...], ...]) -> Array:
    """Values (points, monomials) of products of powers of the coordinates."""
    values: Array = np.prod(points[:, None, :] ** np.array(powers, float)[None], axis=2)
    return values


def complete(dimension: int, degree: int) -> tuple[tuple[int, ...], ...]:
    """Exponents of all monomials up to a total degree, the constant first."""
    every = product(range(degree + 1), repeat=dimension)
    return tuple(sorted((p for p in every if sum(p) <= degree), key=sum))


def serendipity(dimension: int) -> tuple[tuple[int, ...], ...]:
    """Exponents of the quadratic serendipity cells: at most one square, superlinear degree 2.

    Source: D. N. Arnold, G. Awanou, Found. Comput. Math. 11 (2011), 337-344.
    """
    every = product(range(3), repeat=dimension)
    return tuple(sorted((p for p in every if p.count(2) <= 1), key=sum))


def products(dimension: int) -> tuple[tuple[int, ...], ...]:
    """Exponents of products of linear functions, the constant first."""
    return tuple(sorted(product(range(2), repeat=dimension), key=sum))


def gauss(count: int, dimension: int) -> Rule:
    """Products of the Gauss rule with so many points on [-1, 1]."""
    x, w = np.polynomial.legendre.leggauss(count)
    places = np.array(list(product(x, repeat=dimension)))
    return Rule(places, np.array([np.prod(one) for one in product(w, repeat=dimension)]))


def simplex(*orbits: tuple[float, tuple[float, ...]]) -> Rule:
    """A symmetric rule on a triangle or a tetrahedron.

    Args:
        orbits: Weights, and barycentric coordinates whose permutations are the points. The sum of
            all weights is the size of the reference cell.
    """
    points: list[tuple[float, ...]] = []
    weights: list[float] = []
    for weight, place in orbits:
        for one in permuted(place):
            points.append(one[1:])
            weights.append(weight)
    return Rule(np.array(points), np.array(weights))


def permuted(place: tuple[float, ...]) -> list[tuple[float, ...]]:
    """The different permutations, in a fixed order."""
    if len(place) <= 1:
        return [place]
    result: list[tuple[float, ...]] = []
    for first in dict.fromkeys(place):
        left = list(place)
        left.remove(first)
        result += [(first, *tail) for tail in permuted(tuple(left))]
    return result
