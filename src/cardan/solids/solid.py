"""Matrices of a solid: the C of ``kernels/solids/solids.h`` for Python."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arguments import checked
from ..arrays import Array, Integers
from ..elements.material import Material
from ..errors import ModelError, brief, near
from ..records import dataclass
from ..runtime.build import kernels
from ..schema.records import SolidRecord
from ..superelements.values import numbers
from .cells import SOLIDS, Cell, Rule
from .materials import SolidMaterial, isotropic
from .record import Mesh
from .units import judge_material

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

FOLDED = 1  # CARDAN_SOLID_FOLDED
MOST_BLOCKS = (1 << 31) // 18  # entries of rows of nodes: the largest matrix has 18 numbers each
AnyMaterial = Material | SolidMaterial


@dataclass(frozen=True, eq=False)
class Group:
    """Cells of one kind and material.

    Attributes:
        cell: The kind.
        rows: Their numbers within the kind (cells,).
        nodes: Their nodes (cells, nodes of a cell), as C reads them.
        material: The material.
    """

    cell: Cell
    rows: Integers
    nodes: NDArray[np.int32]
    material: SolidMaterial


@dataclass(frozen=True, eq=False)
class Pattern:
    """Pairs of nodes that share a cell, in compressed rows.

    Attributes:
        first: Where the list of a row begins (rows + 1,).
        column: Nodes, ascending within a row.
    """

    first: NDArray[np.int32]
    column: NDArray[np.int32]


class Solid:
    """A mesh with its material: matrices of linear elasticity, small displacements.

    Degrees of freedom are the displacements of the nodes: those of node k are 3 k, 3 k + 1 and
    3 k + 2. Stresses have the order xx, yy, zz, yz, zx, xy.

    Attributes:
        mesh: The mesh.
        groups: Its cells by kind and material.
        pattern: Which nodes share a cell.

    Source: T. J. R. Hughes, The Finite Element Method, chapters 2, 3 and 7; K.-J. Bathe, Finite
    Element Procedures, 2nd ed., sections 4.2, 5.3 and 6.2.
    """

    def __init__(self, mesh: Mesh, material: AnyMaterial | Mapping[str, AnyMaterial]) -> None:
        """Groups the cells; nothing is computed yet.

        Args:
            mesh: The mesh.
            material: The material; or materials by region, which together are the entire mesh.

        Raises:
            ModelError: a material without elastic constants, an unknown region, cells without a
                material or with two.
        """
        if not isinstance(mesh, Mesh):
            raise ModelError(f"mesh={brief(mesh)}: give a mesh, of read() or from_arrays()")
        self.mesh = mesh
        self.groups = _groups(mesh, material)
        self.pattern = _pattern(mesh)

    def __repr__(self) -> str:
        kinds = ", ".join(f"{len(group.nodes)} {group.cell.kind}" for group in self.groups)
        return f"Solid({self.mesh.dofs} degrees of freedom, {kinds})"

    def stiffness(self) -> csr_matrix:
        """The stiffness matrix K (dofs, dofs) [N/m], a ``scipy.sparse.csr_matrix``."""
        return self._by_elasticity([group.material.elasticity for group in self.groups])

    def damping(self) -> csr_matrix:
        """The damping matrix C (dofs, dofs) [N s/m], a ``scipy.sparse.csr_matrix``.

        It is the stiffness of every material times its ``damping`` (Kelvin and Voigt).
        """
        materials = [group.material for group in self.groups]
        return self._by_elasticity([one.damping * one.elasticity for one in materials])

    def _by_elasticity(self, elasticity: Sequence[Array]) -> csr_matrix:
        """The integral of strains, times (6, 6) of each group, times strains (dofs, dofs)."""
        values = np.zeros((len(self.pattern.column), 3, 3))
        for group, stress_by_strain in zip(self.groups, elasticity, strict=True):
            material = replace(group.material, elasticity=stress_by_strain)
            part = replace(group, material=material)
            self.call("stiffness", part, group.cell.stiffness, values)
        return self._blocks(values)

    @checked
    def mass(self, lumped: bool = False, rule: Literal["mass", "stiffness"] = "mass") -> csr_matrix:
        """The mass matrix M (dofs, dofs) [kg], a ``scipy.sparse.csr_matrix``.

        Args:
            lumped: Diagonal, by scaling the diagonal of the consistent matrix to the mass of each
                cell (Hinton, Rock and Zienkiewicz).
            rule: Points of quadrature. ``"mass"`` is exact with straight edges; ``"stiffness"``
                has as few as the stiffness, which is what CalculiX does (tetrahedra differ).
        """
        return self._directions(self.nodal_mass(lumped, rule), lumped)

    def nodal_mass(
        self, lumped: bool = False, rule: Literal["mass", "stiffness"] = "mass"
    ) -> csr_matrix:
        """The mass matrix of one direction (nodes, nodes) [kg]; it is the same in all three."""
        values = np.zeros(len(self.pattern.column))
        for group in self.groups:
            points = group.cell.mass if rule == "mass" else group.cell.stiffness
            self.call("mass", group, points, values, lumped)
        return self._rows(values)

    def geometric_stiffness(
        self, displacement: Array, temperature: Array | None = None
    ) -> csr_matrix:
        """The geometric stiffness K_G (dofs, dofs) [N/m] of the stresses of a displacement.

        It is linear in the displacement: scale it with the load. The tangent is K + K_G.

        Args:
            displacement: Displacements (dofs,) or (nodes, 3) [m].
            temperature: Rise of temperature at the nodes (nodes,) [K]; none by default.

        Returns:
            A symmetric ``scipy.sparse.csr_matrix``.

        Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, 5th ed., vol. 2,
        chapter 10; K.-J. Bathe, Finite Element Procedures, 2nd ed., section 6.3.
        """
        values = np.zeros(len(self.pattern.column))
        for group in self.groups:
            stress = self.stresses(group, group.cell.stiffness, displacement, temperature)
            self.call("geometric", group, group.cell.stiffness, stress, values)
        return self._directions(self._rows(values))

    def stresses(
        self, group: Group, rule: Rule, displacement: Array | None, temperature: Array | None = None
    ) -> Array:
        """Stresses (cells, points, 6) [Pa] of a group at the points of a rule.

        Args:
            group: The cells.
            rule: The rule.
            displacement: Displacements (dofs,) or (nodes, 3) [m]; none: zero.
            temperature: Rise of temperature at the nodes (nodes,) [K]; none: zero.
        """
        stress = np.zeros((len(group.nodes), len(rule.weights), 6))
        if displacement is not None:
            field = self.field("displacement", displacement, 3)
            self.call("stress", group, rule, field, stress)
        if temperature is not None:
            rise = self.field("temperature", temperature, 1)[group.nodes, 0]
            at_points = rise @ group.cell.shape(rule.points).T
            thermal = group.material.elasticity @ group.material.expansion
            stress -= at_points[:, :, None] * thermal
        return stress

    def field(self, name: str, values: ArrayLike, width: int) -> Array:
        """Values at the nodes as an array (nodes, width).

        Raises:
            ModelError: another number of values, or numbers that are not finite.
        """
        array = np.ascontiguousarray(numbers(f"{self.mesh.source}: {name}", values))
        size = len(self.mesh.points) * width
        if array.size != size:
            raise ModelError(
                f"{self.mesh.source}: {name} has the shape {array.shape}, expected {size} values: "
                f"{width} for each of {len(self.mesh.points)} nodes"
            )
        array = array.reshape(-1, width)
        bad = np.flatnonzero(~np.isfinite(array).all(axis=1))
        if len(bad):
            raise ModelError(f"{self.mesh.source}: {name} of node {bad[0]} is not finite")
        return array

    def call(
        self,
        name: str,
        group: Group,
        rule: Rule,
        *arguments: Array | NDArray[np.int32] | bool,
        pattern: Pattern | None = None,
    ) -> None:
        """Call a function of the kernels for a group of cells.

        Args:
            name: Its name, without ``cardan_solid_``.
            group: The cells.
            rule: The rule of quadrature.
            arguments: What it takes besides the record.
            pattern: Rows to add to; those of all nodes by default.
        """
        rows = self.pattern if pattern is None else pattern
        cell, count = group.cell, len(group.cell.nodes)
        # C sees addresses: the arrays live here until it returns
        arrays: dict[str, NDArray[np.generic]] = {
            "cell": group.nodes,
            "position": self.mesh.points,
            "weight": rule.weights,
            "shape": cell.shape(rule.points),
            "slope": cell.slope(rule.points),
            "elasticity": group.material.elasticity,
            "first": rows.first,
            "column": rows.column,
            "gradient": np.empty(3 * count),
            "product": np.empty(18 * count),
            "block": np.empty(9 * count**2),
        }
        arrays = {key: np.ascontiguousarray(array) for key, array in arrays.items()}
        record = SolidRecord(
            cells=len(group.nodes),
            nodes=count,
            points=len(rule.weights),
            density=group.material.density,
            culprit=-1,
            **{key: array.ctypes.data for key, array in arrays.items()},
        )
        function = getattr(kernels.library(), f"cardan_solid_{name}")
        function.restype = ctypes.c_int
        status = function(
            ctypes.byref(record),
            *(
                ctypes.c_int(value) if isinstance(value, bool) else _address(value)
                for value in arguments
            ),
        )
        if status:
            number = group.rows[record.culprit]
            reason = "folds over" if status == FOLDED else "has nodes outside of the pattern"
            raise ModelError(f"{self.mesh.source}: cell {number} of {cell.kind} {reason}")

    def _rows(self, values: Array) -> csr_matrix:
        from scipy.sparse import csr_matrix

        size = len(self.mesh.points)
        return csr_matrix((values, self.pattern.column, self.pattern.first), (size, size))

    def _blocks(self, values: Array) -> csr_matrix:
        from scipy.sparse import bsr_matrix

        size = self.mesh.dofs
        pattern = self.pattern
        return bsr_matrix((values, pattern.column, pattern.first), (size, size)).tocsr()

    def _directions(self, matrix: csr_matrix, diagonal: bool = False) -> csr_matrix:
        """The same matrix for the three directions of a node."""
        from scipy.sparse import diags, identity, kron

        if diagonal:
            return diags(np.repeat(matrix.diagonal(), 3), format="csr")
        return kron(matrix, identity(3), format="csr")


@checked
def solid(mesh: Mesh, material: AnyMaterial | Mapping[str, AnyMaterial]) -> Solid:
    """A mesh with its material, ready for matrices, loads and stresses.

    Args:
        mesh: The mesh.
        material: A material of ``cd.material`` or :func:`orthotropic`; or materials by region.

    Raises:
        ModelError: as :class:`Solid`.
    """
    return Solid(mesh, material)


@checked
def assembled(
    mesh: Mesh, material: AnyMaterial | Mapping[str, AnyMaterial]
) -> tuple[csr_matrix, csr_matrix]:
    """Mass and stiffness of a mesh, sparse (dofs, dofs) [kg, N/m].

    Args:
        mesh: The mesh.
        material: A material of ``cd.material`` or :func:`orthotropic`; or materials by region.

    Returns:
        M (consistent) and K, as ``scipy.sparse.csr_matrix``.

    Raises:
        ModelError: as :class:`Solid`.
    """
    body = Solid(mesh, material)
    return body.mass(), body.stiffness()


def _address(array: Array | NDArray[np.int32] | bool) -> ctypes.c_void_p:
    assert isinstance(array, np.ndarray)
    assert array.flags.c_contiguous
    return ctypes.c_void_p(array.ctypes.data)


def _groups(mesh: Mesh, material: AnyMaterial | Mapping[str, AnyMaterial]) -> list[Group]:
    """Cells by kind and material; every cell has one."""
    if not isinstance(material, Mapping):
        every = _numbers(mesh, material)
        return [
            Group(SOLIDS[kind], np.arange(len(cells)), cells.astype(np.int32), every)
            for kind, cells in mesh.cells.items()
        ]
    groups: list[Group] = []
    count = {kind: np.zeros(len(cells), int) for kind, cells in mesh.cells.items()}
    for name, one in material.items():
        if name not in mesh.regions:
            raise ModelError(
                f"{mesh.source}: there is no region {name!r}.{near(name, mesh.regions)}"
            )
        numbers = _numbers(mesh, one)
        for kind, rows in mesh.regions[name].items():
            if len(rows):
                nodes = mesh.cells[kind][rows].astype(np.int32)
                groups.append(Group(SOLIDS[kind], rows, nodes, numbers))
                count[kind][rows] += 1
    for kind, times in count.items():
        for wrong, what in ((times == 0, "no material"), (times > 1, "two materials")):
            if wrong.any():
                raise ModelError(
                    f"{mesh.source}: cell {np.flatnonzero(wrong)[0]} of {kind} has {what}: give "
                    "every cell one, by regions that do not overlap"
                )
    return groups


def _numbers(mesh: Mesh, material: AnyMaterial) -> SolidMaterial:
    if not isinstance(material, Material | SolidMaterial):
        raise ModelError(
            f"{mesh.source}: material={material!r}: give one of cd.material or orthotropic"
        )
    numbers = isotropic(mesh.source, material) if isinstance(material, Material) else material
    judge_material(mesh.source, numbers.stiffest, numbers.density)
    return numbers


def _pattern(mesh: Mesh) -> Pattern:
    """Pairs of nodes that share a cell: the product of the incidence matrix with itself."""
    from scipy.sparse import csr_matrix

    lists, lengths = [], []
    for cells in mesh.cells.values():
        lists.append(cells.ravel())
        lengths.append(np.full(len(cells), cells.shape[1]))
    start = np.concatenate([[0], np.cumsum(np.concatenate(lengths))])
    column = np.concatenate(lists)
    shape = (len(start) - 1, len(mesh.points))
    incidence = csr_matrix((np.ones(len(column), np.int8), column, start), shape)
    adjacency = (incidence.T @ incidence).tocsr()
    adjacency.sort_indices()
    if adjacency.nnz > MOST_BLOCKS:
        raise ModelError(
            f"{mesh.source}: {adjacency.nnz} pairs of coupled nodes, at most {MOST_BLOCKS} are "
            "treated: use a coarser mesh"
        )
    return Pattern(adjacency.indptr.astype(np.int32), adjacency.indices.astype(np.int32))
