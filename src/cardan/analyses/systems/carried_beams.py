"""What carries beams: clusters of nodes that move as one body, and bodies of rigid trees."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from ...arrays import Array
from ...records import dataclass
from ...runtime.models.finite_elements.tables import Integers, Tables
from ...runtime.verification.rotations import cross_matrix
from ...schema.finite_elements import GROUND

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel


@dataclass(frozen=True, eq=False)
class TreeEnds:
    """Motion of the bodies of rigid trees that beams end at, as twists of what is at the origin.

    Attributes:
        model: The model.
        frames: A frame on each of the bodies.
    """

    model: LoadedModel
    frames: Sequence[str]

    @classmethod
    def of(cls, model: LoadedModel, tables: Tables) -> TreeEnds:
        """Those of a model, in the order of their places downward."""
        frames: dict[int, str] = {}
        for line, row in zip(tables.beams, model.manifest.beams, strict=True):
            for place, frame in ((int(line[0]), row.start), (int(line[-1]), row.end)):
                if place < GROUND:
                    frames.setdefault(place, frame)
        return cls(model, [frames[place] for place in sorted(frames, reverse=True)])

    def jacobians(self, q: Array) -> Array:
        """Derivatives of the twists by u (n, 6, nu)."""
        J = np.zeros((len(self.frames), 6, self.model.nu))
        for k, frame in enumerate(self.frames):
            J[k] = self.model.frame_jacobian(frame, q)
            J[k, 3:] += cross_matrix(self.model.pose(frame, q)[:3, 3]) @ J[k, :3]
        return J

    def rates(self, q: Array, u: Array) -> Array:
        """Rates of the twists (n, 6) while the speeds of joints stay."""
        rates, still = np.zeros((len(self.frames), 6)), np.zeros(self.model.nu)
        for k, frame in enumerate(self.frames):
            p = self.model.pose(frame, q)[:3, 3]
            omega, v = np.split(self.model.velocity(frame, q, u), 2)
            alpha, a = np.split(self.model.acceleration(frame, q, u, still), 2)
            rates[k] = np.concatenate([alpha, a - np.cross(alpha, p) - np.cross(omega, v)])
        return rates


def clusters(
    tables: Tables, beams: Sequence[str]
) -> tuple[Integers, list[str], NDArray[np.bool_], list[int]]:
    """Places that beams hold together as one body.

    Args:
        tables: Elements of the model.
        beams: Name of the beam of every line of the tables.

    Returns:
        Cluster of every place, -1 for none; a beam of each cluster; whether the ground belongs to
        it; the cluster of every body of a rigid tree that beams end at.
    """
    count = len(tables.kind)
    lines = [np.zeros(0, dtype=np.intp), *tables.beams]
    first = [np.full(len(line), line[:1].sum()) for line in lines]
    # the ground is one place more, bodies of rigid trees that beams end at come behind
    ends = tuple(np.where(x < 0, count - 1 - x, x) for x in map(np.concatenate, (first, lines)))
    size = 1 + max(count, *(int(x.max(initial=0)) for x in ends))
    graph = coo_array((np.ones(len(ends[0])), ends), (size, size))
    label = connected_components(graph, directed=False)[1]
    cluster, names = np.full(count, -1, dtype=np.intp), list[str]()
    numbers: dict[int, int] = {}
    for line, name in zip(tables.beams, beams, strict=True):
        component = int(label[count - 1 - line[0] if line[0] < 0 else line[0]])
        if component not in numbers:
            numbers[component] = len(names)
            names.append(name)
            cluster[label[:count] == component] = numbers[component]
    immobile = np.array([component == label[count] for component in numbers], dtype=bool)
    bodies = [numbers[int(label[k])] for k in range(count + 1, size)]
    return cluster, names, immobile, bodies
