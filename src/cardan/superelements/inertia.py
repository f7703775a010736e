"""Constant inertia of a component in a frame that moves far, by projection of its mass matrix.

A node moves by its frame and by U = Psi z: its velocity is v + w x (X + U) + Psi z', and its rate
of rotation w + that of Psi z'. With c = (v, w, w_x z, w_y z, w_z z, z') and the constant
B = [E, S X + e, S_x Psi, S_y Psi, S_z Psi, Psi], the kinetic energy is c^T (B^T M B) c / 2. This is
exact where M is that of a solid or lumped; consistent masses of beams couple slopes with
displacements, and then the slopes of w x U are missing.

Source: A. Zwoelfer, J. Gerstmayr, The nodal-based floating frame of reference formulation with
modal reduction, Acta Mechanica 232 (2021).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array, Integers
from ..records import dataclass
from .node_dofs import NodeDofs

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse


@dataclass(frozen=True, eq=False)
class ProjectedInertia:
    """Blocks of B^T M B for a component with n coordinates; k and l are axes of its frame.

    Attributes:
        mass: E^T M E (3, 3) [kg].
        first: E^T M (S X + e) (3, 3): moments of first order [kg m].
        second: (S X + e)^T M (S X + e) (3, 3): inertia about the origin [kg m^2].
        momentum: E^T M Psi (3, n).
        angular: (S X + e)^T M Psi (3, n).
        spin_momentum: E^T M S_k Psi, by k (3, 3, n).
        spin_angular: (S X + e)^T M S_k Psi, by k (3, 3, n).
        spin_modal: (S_k Psi)^T M Psi, by k (3, n, n).
        spin_spin: (S_k Psi)^T M S_l Psi, by k and l (3, 3, n, n).
        modal: Psi^T M Psi (n, n).
    """

    mass: Array
    first: Array
    second: Array
    momentum: Array
    angular: Array
    spin_momentum: Array
    spin_angular: Array
    spin_modal: Array
    spin_spin: Array
    modal: Array

    @property
    def n(self) -> int:
        """Coordinates of the component."""
        return len(self.modal)

    @property
    def drift(self) -> Array:
        """E (3, 3, n) by rows of v, then by axes k of w: the kinetic energy has v.(w_k E_k z).

        That is 0 where M does not depend on directions, as of solids. Where it is not, the inertia
        depends on the velocity of the frame, which that of a body does not.
        """
        cross = np.zeros((3, 3, self.n))
        for k in range(3):
            cross[:, k] = self.spin_momentum[k] - np.cross(np.eye(3)[k], self.momentum, axisb=0).T
        return cross

    def matrix(self) -> Array:
        """B^T M B (6 + 4 n, 6 + 4 n) in the order v, w, w_x z, w_y z, w_z z, z'."""
        n = self.n
        spin = self.spin_spin.transpose(0, 2, 1, 3).reshape(3 * n, 3 * n)
        turns = np.hstack([*self.spin_momentum]), np.hstack([*self.spin_angular])
        half = self.spin_modal.reshape(3 * n, n)
        return np.block(
            [
                [self.mass, self.first, turns[0], self.momentum],
                [self.first.T, self.second, turns[1], self.angular],
                [turns[0].T, turns[1].T, spin, half],
                [self.momentum.T, self.angular.T, half.T, self.modal],
            ]
        )


def project(M: Sparse, shapes: Array, dofs: NodeDofs) -> ProjectedInertia:
    """Constant inertia of a component.

    Args:
        M: Mass in the rows of the nodes (rows, rows).
        shapes: Displacements of these rows by the coordinates, Psi (rows, n).
        dofs: Of the rows; positions are from the origin of the frame.
    """
    motions = dofs.rigid(np.zeros(3))
    shift, turn = motions[:, :3], motions[:, 3:]
    spun = [_crossed(axis, shapes, dofs) for axis in range(3)]
    heavy_shapes, heavy_shift, heavy_turn = M @ shapes, M @ shift, M @ turn
    heavy_spun = [M @ one for one in spun]
    return ProjectedInertia(
        mass=shift.T @ heavy_shift,
        first=shift.T @ heavy_turn,
        second=turn.T @ heavy_turn,
        momentum=shift.T @ heavy_shapes,
        angular=turn.T @ heavy_shapes,
        spin_momentum=np.stack([heavy_shift.T @ one for one in spun]),
        spin_angular=np.stack([heavy_turn.T @ one for one in spun]),
        spin_modal=np.stack([one.T @ heavy_shapes for one in spun]),
        spin_spin=np.stack([[one.T @ heavy for heavy in heavy_spun] for one in spun]),
        modal=shapes.T @ heavy_shapes,
    )


def anisotropy(M: Sparse, dofs: NodeDofs, length: float) -> float:
    """Largest entry of a mass matrix that depends on directions, over its largest one.

    0 where displacements along all axes have the same masses and none with rotations: then turned
    displacements have the same energy, and the inertia of a turning frame is exact.

    Args:
        M: Mass in the rows of the nodes.
        dofs: Of the rows.
        length: By which rotations compare with displacements [m].
    """
    from scipy.sparse import csr_matrix

    rows, shape = np.arange(len(dofs)), (len(dofs.positions), len(dofs))
    present = np.unique(dofs.component)
    # the rows of each motion, by nodes
    pick = {
        int(a): csr_matrix(
            (np.ones(int(chosen.sum())), (dofs.node[chosen], rows[chosen])), shape=shape
        )
        for a, chosen in ((a, dofs.component == a) for a in present)
    }
    blocks = {(a, b): pick[a] @ M @ pick[b].T for a in pick for b in pick if a < 3 and a <= b}
    straight = [block for (a, b), block in blocks.items() if a == b]
    largest = max((abs(one).max() for one in straight), default=0.0)
    unequal = [abs(one - straight[0]).max() for one in straight[1:]]
    coupled = [
        abs(block).max() / (1.0 if b < 3 else length) for (a, b), block in blocks.items() if a != b
    ]
    return float(max([*unequal, *coupled], default=0.0) / largest) if largest else 0.0


def _crossed(axis: int, shapes: Array, dofs: NodeDofs) -> Array:
    """S_k Psi: a unit vector times the displacements of the nodes, rotations left out."""
    first, second = (axis + 1) % 3, (axis + 2) % 3
    row = np.full((len(dofs.positions), 6), -1)
    row[dofs.node, dofs.component] = np.arange(len(dofs))
    result = np.zeros_like(shapes)
    for target, source, sign in ((first, second, -1.0), (second, first, 1.0)):
        both = np.flatnonzero((row[:, target] >= 0) & (row[:, source] >= 0))
        result[row[both, target]] = sign * shapes[row[both, source]]
    return result


def of_interfaces(M: Array, rigid: Array, translations: Integers) -> ProjectedInertia:
    """Blocks of the simpler form, with the velocities of interfaces and modal rates alone.

    Interfaces move as they do in a frame that moves far, w x (X + u) + u'; what is between them
    follows these velocities as it follows displacements, and modal coordinates only their rates.

    Args:
        M: Mass of the coordinates (n, n).
        rigid: Coordinates of unit translations and rotations about the origin (n, 6).
        translations: Rows of the displacements of interfaces along x, y, z (interfaces, 3), -1
            where there is no such motion.

    Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), section 8.7.
    """
    n = len(M)
    spins = np.zeros((3, n, n))
    for rows in translations:
        for k, axis in enumerate(np.eye(3)):
            for column, e in zip(rows, np.eye(3), strict=True):
                for row, entry in zip(rows, np.cross(axis, e), strict=True):
                    if column >= 0 and row >= 0:
                        spins[k, row, column] = entry
    t, r = rigid[:, :3], rigid[:, 3:]
    return ProjectedInertia(
        mass=t.T @ M @ t,
        first=t.T @ M @ r,
        second=r.T @ M @ r,
        momentum=t.T @ M,
        angular=r.T @ M,
        spin_momentum=np.array([t.T @ M @ S for S in spins]),
        spin_angular=np.array([r.T @ M @ S for S in spins]),
        spin_modal=np.array([S.T @ M for S in spins]),
        spin_spin=np.array([[S.T @ M @ P for P in spins] for S in spins]),
        modal=M,
    )
