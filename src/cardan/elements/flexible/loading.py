"""Forces along a beam as forces and moments on its ends, shared by dead and follower loads."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence

from ...ir.function import Function
from ...ir.matrix import Matrix
from .element import FlexibleElement, balance, energy, tangents
from .ends import Ends, Pose

# force per length at the first and at the last point of the element [N/m]
DENSITIES = ("start_f1", "start_f2", "start_f3", "end_f1", "end_f2", "end_f3")


class LoadElement(FlexibleElement):
    """A force per length that varies linearly along the element.

    It works on the cubic through both ends along their tangents, which makes displacements of the
    ends exact where they are small.
    """

    @abstractmethod
    def densities(self, ends: Ends, poses: Sequence[Pose]) -> tuple[Matrix, Matrix]:
        """Force per length at both ends in ground axes (3, 1) [N/m]."""

    @abstractmethod
    def potential(self, ends: Ends, poses: Sequence[Pose]) -> Matrix | None:
        """Potential energy (1, 1) of a load that has one."""

    def functions(self, ends: Ends) -> dict[str, Function]:
        poses = [ends.pose(k) for k in range(2)]
        found: list[Matrix] = []
        for pose, (along, force) in zip(
            poses, shares(ends, self.densities(ends, poses)), strict=True
        ):
            axis = Matrix.vector(ends.graph, [1.0, 0.0, 0.0])
            found += [-axis.cross(pose.rotation.T @ along), -force]
        loads = ends.told(found)
        functions = {
            "balance": self.function(ends, "balance", ends.blocks("q", "p"), balance(ends, loads)),
            "balance_tangent": self.function(
                ends, "balance_tangent", ends.blocks("q", "p"), *tangents(ends, loads, "q")
            ),
        }
        potential = self.potential(ends, poses)
        if potential is not None:
            functions["energy"] = self.function(
                ends, "energy", ends.blocks("q", "p"), energy(None, potential)
            )
        return functions


def shares(ends: Ends, densities: tuple[Matrix, Matrix]) -> list[tuple[Matrix, Matrix]]:
    """What works on the tangent and on the position of each end (3, 1) [N m, N]."""
    length = ends.number("length")
    found: list[tuple[Matrix, Matrix]] = []
    for near, far, sign in ((*densities, 1.0), (*densities[::-1], -1.0)):
        force = near * (length * 0.35) + far * (length * 0.15)
        square = length * length * sign
        found.append((near * (square / 20.0) + far * (square / 30.0), force))
    return found
