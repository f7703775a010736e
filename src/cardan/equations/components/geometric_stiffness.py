"""Geometric stiffness of beams that spin, by the slope of their stiffness along a displacement."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...superelements.factor import Factor
from ..finite_elements.record import FiniteElementRecord
from .element_matrices import ElementMatrices, Q, U, element_matrices

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix as Sparse

# of the size of the component: how far it is displaced for the slope
REACH = 1e-4
AXES = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "yz": (1, 2), "zx": (2, 0), "xy": (0, 1)}


def spin_stiffness(
    record: FiniteElementRecord,
    matrices: ElementMatrices,
    q: Array,
    rotations: Array,
    positions: Array,
    fixed: int,
    center: Array,
) -> dict[str, Sparse]:
    """Geometric stiffness of unit products of angular velocities, one node being fixed.

    Args:
        record: The elements.
        matrices: Theirs at q.
        q: Coordinates (7 n,).
        rotations, positions: Of the nodes at q (n, 3, 3), (n, 3) [m].
        fixed: Number of the node that holds the component.
        center: A point of the axis of rotation (3,) [m].

    Returns:
        K_G (6 n, 6 n) [N s^2/m] by ``"xx"``, ``"yy"``, ``"zz"``, ``"yz"``, ``"zx"``, ``"xy"``: that
        of w is the sum of w_i w_j times K_G of ij. A rotation that loads nothing has none.

    Raises:
        ModelError: the node does not hold the component.

    Source: Géradin and Rixen, Mechanical Vibrations, 3rd ed., section 2.9 (prestress).
    """
    arms = positions - center
    size = float(np.abs(arms).max())
    rows = np.delete(np.arange(U * len(positions)), U * fixed + np.arange(U))

    def label(row: int) -> str:
        return f"node {rows[row] // U}, motion {['x', 'y', 'z', 'rx', 'ry', 'rz'][rows[row] % U]}"

    K = matrices.K[rows][:, rows].tocsc()
    places = np.repeat(positions, U, axis=0)[rows]
    factor = Factor(K, places, label, "the component that spins", "fix another interface")
    result = {}
    for name, (k, m) in AXES.items():
        # of -w x (w x arm) the part with w_k w_m
        field = np.zeros((len(positions), U))
        if k == m:
            field[:, :3] = arms
            field[:, k] = 0.0
        else:
            field[:, k], field[:, m] = -arms[:, m], -arms[:, k]
        displacement = np.zeros(U * len(positions))
        displacement[rows] = factor.solve((matrices.M @ field.ravel())[rows])
        most = np.abs(displacement).max()
        if most == 0.0:
            continue
        unit = REACH * size / most
        ahead, behind = (
            _stiffness(record, q, rotations, sign * unit * displacement) for sign in (1, -1)
        )
        slope = (ahead - behind) * (0.5 / unit)
        # what is left of loads that are not in equilibrium is skew
        result[name] = ((slope + slope.T) * 0.5).tocsr()
    return result


def _stiffness(
    record: FiniteElementRecord, q: Array, rotations: Array, displacement: Array
) -> Sparse:
    """K at nodes that are displaced and turned by vectors in ground axes (6 n,)."""
    from scipy.spatial.transform import Rotation

    moves = displacement.reshape(-1, U)
    attitude = Rotation.from_rotvec(moves[:, 3:]) * Rotation.from_matrix(rotations)
    moved = q.reshape(-1, Q).copy()
    moved[:, :4] = np.roll(attitude.as_quat(), 1, axis=1)
    moved[:, 4:] += moves[:, :3]
    return element_matrices(record, moved.ravel(), attitude.as_matrix()).K
