"""A component in the unknowns that its interfaces leave, with what all reductions need of it."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array, Integers
from ..errors import ModelError, counted
from ..records import dataclass
from .eigenproblem import DENSE, dense_modes, sparse_modes
from .factor import Factor
from .interfaces import Connection
from .node_dofs import NodeDofs

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

EXTRA = 4  # frequencies that are computed beyond those requested: the first ones left out
UNSUPPORTED = (
    "this part of the component is not held by the interfaces. Connect it, or take its rows out "
    "of M and K"
)


@dataclass(frozen=True)
class Component:
    """Matrices of a component; rows and columns of interfaces come first.

    Attributes:
        M, K: Sparse, symmetric (n_b + n_i).
        connection: Motions of the rows of the nodes by these unknowns.
        dofs: Rows of the nodes.
        center: Mean position of the nodes (3,) [m].
        length: Of the component [m]: that by which rotations compare with displacements.
        rigid: Rigid motions about the center without strain (n_b + n_i, r).
    """

    M: Sparse
    K: Sparse
    connection: Connection
    dofs: NodeDofs
    center: Array
    length: float
    rigid: Array

    @property
    def n_boundary(self) -> int:
        """Motions of all interfaces, n_b."""
        return self.connection.n_boundary

    @property
    def n_interior(self) -> int:
        """Motions behind the interfaces, n_i."""
        return len(self.connection.interior)

    @property
    def boundary_labels(self) -> tuple[str, ...]:
        """Motions of the interfaces by name."""
        return tuple(label for frame in self.connection.frames for label in frame.labels)

    @property
    def boundary_scale(self) -> Array:
        """Lengths by which motions of the interfaces compare (n_b,)."""
        return np.array([self.length if ".r" in one else 1.0 for one in self.boundary_labels])

    @property
    def places(self) -> Array:
        """Positions of the unknowns (n_b + n_i, 3) [m]."""
        frames = [[frame.position] * len(frame.components) for frame in self.connection.frames]
        rows = self.dofs.positions[self.dofs.node[self.connection.interior]]
        return np.vstack([*frames, rows])

    def label(self, row: int) -> str:
        """An unknown in messages."""
        if row < self.n_boundary:
            return f"'{self.boundary_labels[row]}'"
        return self.dofs.label(int(self.connection.interior[row - self.n_boundary]))

    def inner_label(self, row: int) -> str:
        """An unknown behind the interfaces in messages."""
        return self.label(row + self.n_boundary)

    @cached_property
    def inner_factor(self) -> Factor:
        """Of the stiffness with all interfaces fixed."""
        n = self.n_boundary
        where = "K with all interfaces fixed"
        inner = self.K[n:, n:].tocsc()
        return Factor(inner, self.places[n:], self.inner_label, where, UNSUPPORTED)

    @cached_property
    def constraint_modes(self) -> Array:
        """Static shapes (n_b + n_i, n_b) by unit motions of the interfaces."""
        n = self.n_boundary
        shapes = -self.inner_factor.solve(self.K[n:, :n].toarray())
        return np.vstack([np.eye(n), shapes])

    def fixed_modes(self, count: int) -> tuple[Array, Array, Array]:
        """Modes with all interfaces fixed.

        Args:
            count: How many.

        Returns:
            Their frequencies [rad/s], shapes (n_b + n_i, count) of unit modal mass, and the next
            frequencies.
        """
        n, size = self.n_boundary, self.n_interior
        # first of all, it says where the stiffness is singular
        factor, M = self.inner_factor, self.M[n:, n:].tocsc()
        if size <= DENSE or 3 * (count + EXTRA) > size:
            omega, inner = dense_modes(self.K[n:, n:].toarray(), M.toarray())
        else:
            K = self.K[n:, n:].tocsc()
            omega, inner = sparse_modes(factor.solve, K, M, count + EXTRA)
        self._enough(count, len(omega), "with all interfaces fixed")
        shapes = np.vstack([np.zeros((n, count)), inner[:, :count]])
        return omega[:count], shapes, omega[count : count + EXTRA]

    @cached_property
    def _support(self) -> tuple[Integers, Factor, Array]:
        """Rows that are not supported, the factor there, and rigid motions of unit mass."""
        from scipy.linalg import qr, solve_triangular

        size, r = self.K.shape[0], self.rigid.shape[1]
        mass = self.rigid.T @ (self.M @ self.rigid)
        normed = (
            solve_triangular(np.linalg.cholesky(mass), self.rigid.T, lower=True).T
            if r
            else self.rigid
        )
        # the rows that resist rigid motions best, rotations in lengths
        scale = np.ones(size)
        scale[: self.n_boundary] = self.boundary_scale
        inner = self.dofs.component[self.connection.interior] > 2
        scale[self.n_boundary :][inner] = self.length
        _, _, pivots = qr((scale[:, None] * normed).T, mode="economic", pivoting=True)
        free = np.setdiff1d(np.arange(size), pivots[:r])
        K = self.K[free][:, free].tocsc()
        where = "K on a statically determinate support" if r else "K"

        def label(row: int) -> str:
            return self.label(int(free[row]))

        return free, Factor(K, self.places[free], label, where, UNSUPPORTED), normed

    def free_memory(self) -> None:
        """Drop the factor of the free component, as large as that behind the interfaces."""
        self.__dict__.pop("_support", None)

    @property
    def rigid_of_unit_mass(self) -> Array:
        """Rigid motions with R^T M R = 1 (n_b + n_i, r)."""
        return self._support[2]

    def flexible(self, force: Array) -> Array:
        """Displacements by forces, which inertia balances, without rigid motion.

        Source: M. Geradin, D. Rixen, Mechanical Vibrations, 3rd ed., 3.1 (free-floating bodies).
        """
        free, factor, rigid = self._support
        balanced = force - self.M @ (rigid @ (rigid.T @ force))
        moved: Array = np.zeros_like(balanced)
        moved[free] = factor.solve(balanced[free])
        moved -= rigid @ (rigid.T @ (self.M @ moved))
        return moved

    def free_modes(self, count: int) -> tuple[Array, Array, Array]:
        """Modes with all interfaces free, rigid motions left out; as :meth:`fixed_modes`."""
        size, rigid = self.K.shape[0], self.rigid_of_unit_mass
        if size <= DENSE or 3 * (count + EXTRA) > size:
            from scipy.linalg import null_space

            # shapes that balance the rigid motions
            Z = null_space((self.M @ rigid).T) if rigid.shape[1] else np.eye(size)
            stiff, mass = Z.T @ (self.K @ Z), Z.T @ (self.M @ Z)
            omega, inner = dense_modes((stiff + stiff.T) / 2, (mass + mass.T) / 2)
            shapes = Z @ inner
        else:
            omega, shapes = sparse_modes(self.flexible, self.K, self.M, count + EXTRA)
        self._enough(count, len(omega), "with all interfaces free")
        return omega[:count], shapes[:, :count], omega[count : count + EXTRA]

    def _enough(self, count: int, available: int, how: str) -> None:
        if count > available:
            raise ModelError(
                f"modes={count}: the component has {counted(available, 'mode')} of finite "
                f"frequency {how}; ask for at most {available}"
            )
