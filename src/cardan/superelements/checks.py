"""Mass, rigid motions and units of a component, held against its nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from ..errors import ModelError
from ..records import dataclass
from .node_dofs import COMPONENTS, NodeDofs

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

RIGID = 1e-5  # of the sum of magnitudes in a row: what rounded texts leave of K R = 0
ROUNDING = 1e-9  # of the largest force of a node: the least with which its other forces compare
UNEQUAL = 1e-6  # masses along the axes that differ by more are not those of a body
SPEEDS = (20.0, 2e4)  # of sound in solids, from soft rubber to more than diamond [m/s]
SOFT_BUT_HEAVY = (500.0, 1500.0)  # below this speed [m/s], solids have less than this [kg/m^3]
DENSEST = 2.3e4  # osmium [kg/m^3]
STIFFENED = 1.6  # h sqrt(k/m) of a node in a mesh over the speed of sound in it, about
AXES = "xyz"


@dataclass(frozen=True)
class MassProperties:
    """Mass, center and inertia of a component by its mass matrix and rigid motions.

    Attributes:
        masses: Along the axes (3,) [kg]; equal for a body in space, 0 where nothing moves.
        center: Of mass (3,) [m].
        inertia: About the center, along the axes of the component (3, 3) [kg m^2].
    """

    masses: tuple[float, float, float]
    center: tuple[float, float, float]
    inertia: tuple[tuple[float, float, float], ...]

    @property
    def mass(self) -> float:
        """Mass [kg]: the largest of those along the axes."""
        return max(self.masses)


@dataclass(frozen=True)
class RigidCheck:
    """Forces by rigid motions, which there are none of in a component that is free.

    Attributes:
        residual: For each of ``COMPONENTS``, the largest force of a row over the sum of the
            magnitudes that cancel in it (6,).
        self_stress: The largest force by 1 m, or by 1 rad about the center of the nodes (6,)
            [N, N m].
        row: Where the residual is largest, such as ``node 17 rz``.
    """

    residual: tuple[float, ...]
    self_stress: tuple[float, ...]
    row: str


def mass_properties(M: Sparse, dofs: NodeDofs) -> MassProperties:
    """Mass, center and inertia of a body that moves as its nodes do.

    Raises:
        ModelError: no mass along any axis, or a negative one.
    """
    about = dofs.positions.mean(axis=0)
    motions = dofs.rigid(about)
    rigid = motions.T @ (M @ motions)
    masses = rigid.diagonal()[:3]
    if masses.max() <= 0 or masses.min() < -1e-12 * masses.max():
        axis = AXES[int(np.argmin(masses))]
        raise ModelError(
            f"M: the mass along {axis} is {masses.min():.6g} kg; a component has a positive one. "
            "Check M, and that node_dofs= or dofs= name its rows in their order"
        )
    # a translation along j meets the rotation about k by the arm along the third axis
    arm = np.zeros(3)
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        weight = masses[j] + masses[k]
        arm[i] = (rigid[j, 3 + k] - rigid[k, 3 + j]) / weight if weight > 0 else 0.0
    center = about + arm
    motions = dofs.rigid(center)[:, 3:]
    inertia = motions.T @ (M @ motions)
    inertia = (inertia + inertia.T) / 2
    if np.linalg.eigvalsh(inertia).min() < -1e-9 * abs(inertia).max():
        raise ModelError(
            "M: its inertia about the center of mass is negative about an axis; check that "
            "node_dofs= or dofs= name its rows in their order"
        )
    rows = tuple((float(a), float(b), float(c)) for a, b, c in inertia)
    x, y, z = (float(one) for one in masses)
    return MassProperties((x, y, z), (float(center[0]), float(center[1]), float(center[2])), rows)


def rigid_check(K: Sparse, dofs: NodeDofs) -> RigidCheck:
    """Forces by rigid motions."""
    center = dofs.positions.mean(axis=0)
    motions = dofs.rigid(center)
    force = abs(K @ motions)
    size = abs(K) @ abs(motions)
    # where a motion has no force at all, rounding compares with the other forces of the node
    length = float(np.linalg.norm(dofs.positions - center, axis=1).max()) or 1.0
    motion = np.array([length] * 3 + [1.0] * 3)
    units = np.where(dofs.component > 2, 1 / length, 1.0)[:, None] * motion
    largest = np.zeros(len(dofs.positions))
    np.maximum.at(largest, dofs.node, (units * size).max(axis=1))
    size = np.maximum(size, ROUNDING * largest[dofs.node][:, None] / units)
    residual = np.divide(force, size, out=np.zeros_like(force), where=size > 0)
    row = int(np.argmax(residual.max(axis=1)))
    worst, largest = residual.max(axis=0), force.max(axis=0)
    return RigidCheck(
        tuple(float(x) for x in worst), tuple(float(x) for x in largest), dofs.label(row)
    )


def check_free(check: RigidCheck) -> None:
    """Refuse a component that resists rigid motions.

    Raises:
        ModelError: it names the motion and the row.
    """
    worst = int(np.argmax(check.residual))
    if check.residual[worst] <= RIGID:
        return
    kind = "translation along" if worst < 3 else "rotation about"
    raise ModelError(
        f"K resists a rigid {kind} {AXES[worst % 3]} ({check.residual[worst]:.2g} of the forces "
        f"stay, most at {check.row}). Either its rows are others than said: check node_dofs=, "
        "order=, and nodes in the unit of K (m). Or it includes supports: leave them out, or say "
        "supported=True"
    )


def node_notes(properties: MassProperties, dofs: NodeDofs) -> list[str]:
    """Notes where mass and nodes do not fit."""
    notes = []
    low, high = dofs.positions.min(axis=0), dofs.positions.max(axis=0)
    margin = 0.1 * np.linalg.norm(high - low)
    center = np.array(properties.center)
    if (center < low - margin).any() or (center > high + margin).any():
        notes.append(
            f"the center of mass {np.round(center, 6).tolist()} m lies outside the nodes, which "
            f"reach from {low.tolist()} to {high.tolist()}: check order= and node_dofs="
        )
    moving = [m for m in properties.masses if m > 0]
    if len(moving) == 3 and max(moving) - min(moving) > UNEQUAL * max(moving):
        notes.append(
            "the masses along x, y, z differ: {:.6g}, {:.6g}, {:.6g} kg; those of a body are "
            "equal: check node_dofs=, and that no node that moves was left out".format(*moving)
        )
    radius = float(np.linalg.norm(dofs.positions - center, axis=1).max())
    gyration = float(np.sqrt(np.linalg.eigvalsh(properties.inertia)[-1] / properties.mass))
    if gyration > 3 * max(radius, 1e-300):
        notes.append(
            f"the radius of gyration {gyration:.4g} m is far beyond the nodes, which lie within "
            f"{radius:.4g} m of the center: check that nodes and M have one unit of length (m)"
        )
    return notes


def unit_notes(M: Sparse, K: Sparse, dofs: NodeDofs, mass: float) -> tuple[float, float, list[str]]:
    """Speed of sound [m/s] and density [kg/m^3] of a mesh, roughly, and notes on its units.

    Nodes at a distance h with mass m and stiffness k have h sqrt(k/m) near the speed of sound.
    """
    from scipy.spatial import cKDTree

    extent = np.ptp(dofs.positions, axis=0)
    # nodes on a line or in a plane say nothing of a volume
    solid = extent.min() > 1e-3 * extent.max()
    density = mass / float(np.prod(extent)) if solid else float("nan")
    if len(dofs.positions) < 2:
        return float("nan"), density, []
    distance, neighbor = cKDTree(dofs.positions).query(dofs.positions, k=2)
    # along the line to the nearest node: bending of thin parts has no part in it
    along = dofs.positions[neighbor[:, 1]] - dofs.positions
    stiffness, mass_there = (_quadratic(A, along, dofs) for A in (K, M))
    able = (stiffness > 0) & (mass_there > 0)
    speeds = np.zeros(len(able))
    speeds[able] = distance[able, 1] * np.sqrt(stiffness[able] / mass_there[able]) / STIFFENED
    nodes = np.flatnonzero(speeds)
    if not len(nodes):
        return float("nan"), density, []
    typical = nodes[np.argsort(speeds[nodes])[len(nodes) // 2]]
    speed = float(speeds[typical])
    cause = ""
    if speed > SPEEDS[1]:
        cause = "nodes in mm (give them times 0.001) or M in t (times 1000)"
    elif speed < SPEEDS[0] or (speed < SOFT_BUT_HEAVY[0] and density > SOFT_BUT_HEAVY[1]):
        cause = "K in N/mm (give it times 1000) or M in g (times 0.001)"
    elif density > DENSEST:
        cause = "M in g (give it times 0.001)"
    if not cause:
        return speed, density, []
    material = "" if np.isnan(density) else f" in a material of {density:.3g} kg/m^3 or more"
    note = (
        f"near node {dofs.ids[typical]} sound would travel at {speed:.3g} m/s{material}, which no "
        f"solid has: units are m, kg, N; likely {cause}"
    )
    return speed, density, [note]


def _quadratic(A: Sparse, directions: Array, dofs: NodeDofs) -> Array:
    """Forms d^T A d of each node by its displacement along a direction (nodes,)."""
    row = np.full((len(dofs.positions), 6), -1)
    row[dofs.node, dofs.component] = np.arange(len(dofs))
    result = np.zeros(len(dofs.positions))
    for a in range(3):
        for b in range(3):
            both = np.flatnonzero((row[:, a] >= 0) & (row[:, b] >= 0))
            if len(both):
                entries = np.asarray(A[row[both, a], row[both, b]]).reshape(-1)
                result[both] += entries * directions[both, a] * directions[both, b]
    return result


def rigid_text(check: RigidCheck) -> str:
    """The residual of each rigid motion, for people."""
    return "  ".join(
        f"{name} {value:.1e}" for name, value in zip(COMPONENTS, check.residual, strict=True)
    )
