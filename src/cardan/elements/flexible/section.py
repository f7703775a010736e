"""Data that beams share: stiffness of the section, thermal strain, reference shape.

Axes of the section: 1 along the beam, 2 and 3 principal. Stress is (m1 m2 m3, n1 n2 n3), torsion
and bending before tension and shear; strain (K1 K2 K3, E1 E2 E3) with E = (1, 0, 0) where a
straight beam is not strained.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.arithmetic import Scalar
from ...ir.graph import ZERO, Graph
from ...ir.matrix import Matrix
from ...records import dataclass
from .element_ends import OUTSIDE, Ends

# stiffness in the order of the stress [N m², N]; what there is without stress beyond the reference
# shape, such as by temperature [rad/m, -]
STIFFNESS = ("GJ", "EI2", "EI3", "EA", "GA2", "GA3")
FREE = tuple(f"strain_{k}" for k in range(1, 7))
SECTION = (*STIFFNESS, *FREE)
# length [m] and strain of the reference shape [rad/m, -]
SHAPE = ("length", "K1", "K2", "K3", "E1", "E2", "E3")
# forces per length: of loads in ground and in section axes [N/m], and what makes the weight
DEAD, FOLLOWER, GRAVITY = (
    tuple(f"{name}_{k}" for k in (1, 2, 3)) for name in ("dead_force", "follower_force", "gravity")
)
FORCES = (*DEAD, *FOLLOWER, "rhoA", *GRAVITY)
DEAD_LOADS = (*DEAD, *GRAVITY)


@dataclass(frozen=True)
class Section:
    """Section data of a beam element.

    Attributes:
        length: L [m].
        stiffness: Of the section, six numbers.
        free: Strain without stress times L: reference shape, temperature (6, 1).
    """

    length: Scalar
    stiffness: tuple[Scalar, ...]
    free: Matrix

    @staticmethod
    def of(ends: Ends) -> Section:
        """From the data of an element that has ``SECTION`` and ``SHAPE``."""
        length = ends.number("length")
        strain = flat(ends, ends.vector(*SHAPE[1:]) + ends.vector(*FREE))
        free = (strain * length).hint("", "free", SHAPE[1:])
        return Section(length, tuple(ends.vector(*STIFFNESS)), free)


def flat(ends: Ends, column: Matrix) -> Matrix:
    """Strain or stress (6, 1) without the entries that leave the plane, where there is one."""
    nodes = [ZERO if ends.planar and k in OUTSIDE else x for k, x in enumerate(column.nodes)]
    return Matrix(column.graph, 6, 1, nodes)


def weight(ends: Ends) -> tuple[Matrix, Matrix]:
    """Force per length in ground axes and in axes of the section (3, 1), from ``FORCES``."""
    fixed = ends.vector(*DEAD) + ends.vector(*GRAVITY) * ends.number("rhoA")
    return fixed, ends.vector(*FOLLOWER)


def without_locking(stiffness: Sequence[Scalar], length: Scalar) -> list[Scalar]:
    """Stiffness of a section with the residual bending flexibility of a straight element.

    The compliance in shear gains L²/(12 EI): so soft is an element that bends linearly.
    """
    corrected = list(stiffness)
    # shear along 2 goes with bending about 3
    for shear, bending in ((4, 2), (5, 1)):
        residual = length * length / (12.0 * corrected[bending])
        corrected[shear] = 1.0 / (1.0 / corrected[shear] + residual)
    return corrected


def diagonal(graph: Graph, entries: Sequence[Scalar]) -> Matrix:
    """A diagonal matrix."""
    n = len(entries)
    nodes = [entries[i].node if i == j else ZERO for i in range(n) for j in range(n)]
    return Matrix(graph, n, n, nodes)
