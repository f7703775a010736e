"""Forces and moments in the sections of beams, as rows of their displacements."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...superelements.section_forces import COMPONENTS, BeamSections
from ..finite_elements.record import FiniteElementRecord
from .beam_system import BeamSystem
from .element_matrices import Q, U, element_tangents

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix as Sparse

FORM = "stress"  # the function that only elements of beams have


def section_operator(
    component: BeamSystem, record: FiniteElementRecord, q: Array, rotations: Array
) -> tuple[Sparse, BeamSections]:
    """Rows of section forces by displacements along ground axes and rotations about them.

    Those at an end of an element are the forces that it needs there: what lies ahead exerts them
    on what lies behind, in axes of the section.

    Args:
        component: The beams.
        record: Their elements.
        q: Coordinates (7 n,).
        rotations: Of the nodes at q (n, 3, 3).

    Returns:
        The operator (6 sections, 6 n), in the order N, Qy, Qz, Mx, My, Mz, and where the sections
        are: at the start and at the end of each element.
    """
    from scipy.sparse import csr_matrix

    stiffness = _stiffness(record, q)
    blocks, columns, names, stations = [], [], list[str](), list[float]()
    count: dict[str, int] = {}
    for segment, nodes in zip(component.system.segments, record.lines, strict=True):
        line = segment.line
        for k in range(len(line.stations) - 1):
            # elements of a beam are numbered from 1, over all of its segments
            number = count[segment.name] = count.get(segment.name, 0) + 1
            ends = np.asarray(nodes[k : k + 2])
            by_ground = _by_ground(rotations[ends])
            K = by_ground.T @ stiffness[segment.name, number] @ by_ground
            for end, sign in ((0, -1.0), (1, 1.0)):
                origin = q[Q * ends[end] + 4 : Q * ends[end] + 7]
                rows = K[U * end : U * end + U]
                force, moment = rows[:3], rows[3:]
                # from the origin of the node to the section, which may lie beside it
                moment = moment - np.cross(line.positions[k + end] - origin, force, axisb=0).T
                axes = sign * line.rotations[k + end].T
                blocks.append(np.vstack([axes @ force, axes @ moment]))
                columns.append((U * ends[:, None] + np.arange(U)).ravel())
                names.append(segment.name)
                stations.append(float(line.stations[k + end]))
    n_rows = U * len(blocks)
    # the rows of a section have the columns of both nodes of its element
    places = np.repeat(columns, U, axis=0).ravel()
    starts = 2 * U * np.arange(n_rows + 1)
    operator = csr_matrix((np.ravel(blocks), places, starts), (n_rows, U * len(rotations)))
    return operator, BeamSections(tuple(names), np.array(stations))


def row_names(sections: BeamSections) -> list[str]:
    """Names of the rows, such as ``"boom 3 Mz"``: of the third section of a beam."""
    names, number = list[str](), dict[str, int]()
    for beam in sections.beams:
        number[beam] = number.get(beam, 0) + 1
        names += [f"{beam} {number[beam]} {one}" for one in COMPONENTS]
    return names


def _stiffness(record: FiniteElementRecord, q: Array) -> dict[tuple[str, int], Array]:
    """Stiffness (12, 12) of every element by its beam and number."""
    p = np.array([parameter.value for parameter in record.system.parameters])
    result = {}
    for group in record.groups:
        if FORM not in group.kind.functions:
            continue
        for member, K in zip(group.members, element_tangents(group, q, p)["K"], strict=True):
            beam, _, number = member.rpartition(".")
            result[beam, int(number)] = K
    return result


def _by_ground(rotations: Array) -> Array:
    """Speeds of two nodes by displacements along ground axes and rotations about them (12, 12)."""
    by_ground = np.zeros((2 * U, 2 * U))
    for k, R in enumerate(rotations):
        at = U * k
        by_ground[at : at + 3, at + 3 : at + 6] = R.T
        by_ground[at + 3 : at + 6, at : at + 3] = np.eye(3)
    return by_ground
