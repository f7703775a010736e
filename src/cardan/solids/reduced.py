"""From a mesh to a superelement in one call."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import checked
from ..arrays import Array, Integers
from ..errors import ModelError, brief
from ..superelements.coarsening import coarsened
from ..superelements.factor import Factor
from ..superelements.interfaces import check_stiffening, origin_of
from ..superelements.record import SuperelementRecord
from ..superelements.reduction import reduce
from ..superelements.stress_recovery import nodal_names
from ..superelements.surface import MOST_TRIANGLES, joined
from .files import read
from .loads import centrifugal_products, thermal
from .record import Mesh, Place
from .solid import AnyMaterial, Solid
from .stress import stress_operator, thermal_stresses

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

NONE: Integers = np.zeros(0, np.intp)
UNFIXED = "the nodes that are fixed do not hold it: give three or more that do not lie on a line"


@checked
def from_mesh(
    mesh: Mesh | str | Path,
    material: AnyMaterial | Mapping[str, AnyMaterial],
    interfaces: Mapping[str, Place],
    *,
    method: str = "craig_bampton",
    modes: int | None = None,
    rigid: str | Mapping[str, str] = "rbe2",
    at: Mapping[str, object] | None = None,
    damping: object = None,
    rayleigh: tuple[float, float] | None = None,
    static_shapes: Sequence[str] = (),
    stress: Place | None = None,
    stiffening: str | None = None,
    scale: float | None = None,
) -> SuperelementRecord:
    """A solid of finite elements, reduced to motions of its interfaces and some modes.

    Args:
        mesh: A mesh, or a file that :func:`read` reads.
        material: A material of ``cd.material`` or :func:`orthotropic`; or materials by region.
            Its ``damping`` becomes part of C.
        interfaces: Names of surfaces and sets of the mesh, or node numbers, by the name that the
            interface gets: ``{"hinge": "hole"}``.
        method, modes, rigid, at, damping, rayleigh, static_shapes: As for
            ``cd.superelement.reduce``.
        stress: Nodes whose stresses are recovered: a surface, a set or numbers; none by default.
        stiffening: Name of the interface that holds the body while it spins about an axis through
            the origin of its frame: the record gets the geometric stiffness of
            :func:`spin_stiffness` with it; none by default.
        scale: Length of a unit of the file [m]: 1e-3 for millimeters.

    Returns:
        A record to print, save, draw and use in scenes. Its loads have ``"temperature"``, the load
        by a uniform rise of 1 K, where the material expands.

    Raises:
        ModelError: the mesh, the material or an interface is at fault; it names which.
    """
    if not isinstance(mesh, Mesh):
        mesh = read(mesh, scale=scale)
    elif scale is not None:
        raise ModelError(f"scale={scale:g}: the mesh is one already; give scale where it is made")
    if not isinstance(interfaces, Mapping) or not interfaces:
        raise ModelError(
            f"interfaces={brief(interfaces)}: give surfaces, sets or nodes by name, such as "
            "{'hinge': 'hole'}"
        )
    body = _with_density(mesh, material)
    nodes = {name: mesh.nodes(place) for name, place in interfaces.items()}
    loads: dict[str, Array] = {}
    if any(group.material.expansion.any() for group in body.groups):
        loads["temperature"] = thermal(body, 1.0)
    recovered = [] if stress is None else mesh.nodes(stress).tolist()
    record = reduce(
        body.mass(),
        body.stiffness(),
        mesh.points,
        nodes,
        method=method,
        modes=modes,
        rigid=rigid,
        at=at,
        C=body.damping() if any(group.material.damping for group in body.groups) else None,
        damping=damping,
        rayleigh=rayleigh,
        loads=loads,
        static_shapes=static_shapes,
        geometric=_by_spin(body, nodes, stiffening, at),
        stress=stress_operator(body, recovered) if recovered else None,
        stress_names=nodal_names(recovered) or None,
        load_stresses={
            name: thermal_stresses(body, np.ones(len(mesh.points)), recovered)
            for name in (loads if recovered else ())
        },
    )
    triangles = coarsened(mesh.points, mesh.triangles, MOST_TRIANGLES)
    return replace(record, surface=joined(NONE, triangles, np.zeros((0, 2), np.intp)))


def _with_density(mesh: Mesh, material: AnyMaterial | Mapping[str, AnyMaterial]) -> Solid:
    """The solid of a mesh.

    Raises:
        ModelError: no material has a density.
    """
    body = Solid(mesh, material)
    if not any(group.material.density for group in body.groups):
        raise ModelError(
            f"{mesh.source}: no material has a density: give rho= [kg/m^3], "
            "cd.material(E=210e9, nu=0.3, rho=7850)"
        )
    return body


def _by_spin(
    body: Solid, nodes: Mapping[str, Integers], stiffening: str | None, at: object
) -> dict[str, csr_matrix]:
    """Geometric stiffness about the origin of an interface; none without one.

    Raises:
        ModelError: there is no interface of that name, or it does not support the body.
    """
    if stiffening is None:
        return {}
    check_stiffening(stiffening, nodes)
    selection = at.get(stiffening) if isinstance(at, Mapping) else None
    fixed = nodes[stiffening]
    return spin_stiffness(body, fixed, origin_of(stiffening, body.mesh.points[fixed], selection))


@checked
def spin_stiffness(
    body: Solid, fixed: Place, center: ArrayLike | None = None
) -> dict[str, csr_matrix]:
    """Geometric stiffness of unit products of angular velocities, some nodes being fixed.

    Args:
        body: The body.
        fixed: The nodes that are fixed: a name of the mesh or numbers.
        center: A point of the axis of rotation (3,) [m]; the mean of those nodes by default.

    Returns:
        K_G (dofs, dofs) [N s^2/(m rad^2)] by ``"xx"``, ``"yy"``, ``"zz"``, ``"yz"``, ``"zx"``,
        ``"xy"``: that of w is the sum of w_i w_j times K_G of ij. The tangent is K + K_G; the mass
        in rotating axes is not part of it.

    Raises:
        ModelError: the nodes do not hold the body.

    Source: K.-J. Bathe, Finite Element Procedures, 2nd ed., section 6.3; M. Geradin, A. Cardona,
    Flexible Multibody Dynamics, section 8.8 (superelements with geometric stiffness).
    """
    mesh = body.mesh
    nodes = mesh.nodes(fixed)
    free = np.ones((len(mesh.points), 3), bool)
    free[nodes] = False
    rows = np.flatnonzero(free.ravel())
    places = np.repeat(mesh.points, 3, axis=0)[rows]

    def label(row: int) -> str:
        return f"node {rows[row] // 3} {'xyz'[rows[row] % 3]}"

    K = body.stiffness()[rows][:, rows].tocsc()
    factor = Factor(K, places, label, f"{mesh.source}: the body that spins", UNFIXED)
    about = mesh.points[nodes].mean(axis=0) if center is None else center
    result = {}
    for name, load in centrifugal_products(body, about).items():
        displacement = np.zeros(mesh.dofs)
        displacement[rows] = factor.solve(load[rows])
        result[name] = body.geometric_stiffness(displacement)
    return result
