"""From a mesh to a superelement in one call."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from pathlib import Path

from ...arrays import Array
from ...errors import ModelError, brief
from ..record import Superelement
from ..reduction import reduce
from .files import read
from .loads import thermal
from .record import Mesh, Place
from .solid import AnyMaterial, Solid
from .stress import stress_operator

STRESSES = ("xx", "yy", "zz", "yz", "zx", "xy")


def from_mesh(
    mesh: Mesh | str | Path,
    material: AnyMaterial | Mapping[str, AnyMaterial],
    interfaces: Mapping[str, Place],
    *,
    library: ctypes.CDLL,
    method: str = "craig_bampton",
    modes: int | None = None,
    rigid: str | Mapping[str, str] = "rbe2",
    at: Mapping[str, object] | None = None,
    damping: object = None,
    rayleigh: tuple[float, float] | None = None,
    stress: Place | None = None,
    scale: float | None = None,
) -> Superelement:
    """A solid of finite elements, reduced to motions of its interfaces and some modes.

    Args:
        mesh: A mesh, or a file that :func:`read` reads.
        material: A material of ``cd.material`` or :func:`orthotropic`; or materials by region.
        interfaces: Names of surfaces and sets of the mesh, or node numbers, by the name that the
            interface gets: ``{"hinge": "hole"}``.
        library: The compiled kernels.
        method, modes, rigid, at, damping, rayleigh: As for ``cd.superelement.reduce``.
        stress: Nodes whose stresses are recovered: a surface, a set or numbers; none by default.
        scale: Length of a unit of the file [m]: 1e-3 for millimeters.

    Returns:
        A record to print, save and use in scenes. Its loads have ``"temperature"``, the load by a
        uniform rise of 1 K, where the material expands.

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
    body = Solid(mesh, material, library)
    nodes = {name: mesh.nodes(place) for name, place in interfaces.items()}
    loads: dict[str, Array] = {}
    if any(group.material.expansion.any() for group in body.groups):
        loads["temperature"] = thermal(body, 1.0)
    recovered = [] if stress is None else mesh.nodes(stress).tolist()
    return reduce(
        body.mass(),
        body.stiffness(),
        mesh.points,
        nodes,
        method=method,
        modes=modes,
        rigid=rigid,
        at=at,
        damping=damping,
        rayleigh=rayleigh,
        loads=loads,
        stress=stress_operator(body, recovered) if recovered else None,
        stress_names=[f"{node} {one}" for node in recovered for one in STRESSES] or None,
    )
