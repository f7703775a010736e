"""Loads on the nodes of a solid (dofs,) [N]: gravity, spin, temperature, pressure."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import checked
from ..arrays import Array
from ..errors import ModelError, brief
from ..superelements.values import numbers
from .cells import FACES
from .record import Place
from .solid import Solid


@checked
def gravity(solid: Solid, acceleration: ArrayLike) -> Array:
    """The load of a uniform field of gravity, consistent with the mass matrix.

    Args:
        solid: The body.
        acceleration: Of free fall (3,) [m/s^2].

    Returns:
        Forces (dofs,) [N].
    """
    field = np.tile(_vector("acceleration", acceleration), (len(solid.mesh.points), 1))
    forces: Array = (solid.nodal_mass() @ field).ravel()
    return forces


@checked
def centrifugal(solid: Solid, speed: ArrayLike, center: ArrayLike = (0.0, 0.0, 0.0)) -> Array:
    """The load of a steady rotation, consistent with the mass matrix.

    It is quadratic in the speed. Constraints are the caller's: with u = K^-1 times this load,
    :meth:`Solid.geometric_stiffness` of u is K_G of the rotation.

    Args:
        solid: The body.
        speed: Angular velocity (3,) [rad/s].
        center: A point of the axis (3,) [m].

    Returns:
        Forces (dofs,) [N]: the integral of density times -w x (w x (x - center)).

    Source: M. Géradin, D. J. Rixen, Mechanical Vibrations, 3rd ed., section 2.9 (prestress).
    """
    omega = _vector("speed", speed)
    arm = solid.mesh.points - _vector("center", center)
    outward = -np.cross(omega, np.cross(omega, arm))
    forces: Array = (solid.nodal_mass() @ outward).ravel()
    return forces


@checked
def centrifugal_products(solid: Solid, center: ArrayLike = (0.0, 0.0, 0.0)) -> dict[str, Array]:
    """The loads of unit products of angular velocities, by which any rotation is described.

    Args:
        solid: The body.
        center: A point of the axis (3,) [m].

    Returns:
        Forces (dofs,) [N s^2/rad^2] by ``"xx"``, ``"yy"``, ``"zz"``, ``"yz"``, ``"zx"``, ``"xy"``:
        the load of w is the sum of w_i w_j times load ij.
    """
    unit = np.eye(3)
    square = [centrifugal(solid, axis, center) for axis in unit]
    loads = {2 * letter: load for letter, load in zip("xyz", square, strict=True)}
    for i, j in ((1, 2), (2, 0), (0, 1)):
        both = centrifugal(solid, unit[i] + unit[j], center)
        loads["xyz"[i] + "xyz"[j]] = both - square[i] - square[j]
    return loads


@checked
def thermal(solid: Solid, temperature: ArrayLike) -> Array:
    """The load that would give the thermal strains if nothing resisted.

    The displacements are K^-1 times it; stresses of them need the temperature as well.

    Args:
        solid: The body.
        temperature: Rise of temperature at the nodes (nodes,) [K]; one number for all.

    Returns:
        Forces (dofs,) [N], in balance with each other.

    Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, 5th ed., vol. 1, section
    2.2 (initial strains).
    """
    rise = solid.field("temperature", _nodal(solid, temperature), 1)
    forces = np.zeros((len(solid.mesh.points), 3))
    for group in solid.groups:
        rule = group.cell.stiffness
        stress = -solid.stresses(group, rule, None, rise)
        solid.call("force", group, rule, stress, forces)
    return forces.ravel()


@checked
def pressure(solid: Solid, place: Place, value: float) -> Array:
    """The load of a pressure on an outer surface, positive into the body.

    Args:
        solid: The body.
        place: Name of a surface or node set, or node numbers of the surface.
        value: Pressure [Pa].

    Returns:
        Forces (dofs,) [N]: minus the pressure times the integral of the outer normal.

    Raises:
        ModelError: no outer face has all its nodes there.
    """
    forces = np.zeros((len(solid.mesh.points), 3))
    for kind, rows in solid.mesh.faces(place).items():
        face = FACES[kind]
        rule = face.mass
        slope, shape = face.slope(rule.points), face.shape(rule.points)
        tangents = np.einsum("fai,pak->fpik", solid.mesh.points[rows], slope, optimize=True)
        normal = np.cross(tangents[..., 0], tangents[..., 1])
        nodal = np.einsum("p,pa,fpi->fai", rule.weights, shape, normal, optimize=True)
        np.add.at(forces, rows, -float(value) * nodal)
    return forces.ravel()


def _vector(name: str, values: ArrayLike) -> Array:
    vector = numbers(name, values)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ModelError(f"{name}={brief(values)}: give three finite numbers")
    return vector


def _nodal(solid: Solid, values: ArrayLike) -> Array:
    array = numbers(f"{solid.mesh.source}: temperature", values)
    return np.full(len(solid.mesh.points), float(array)) if array.ndim == 0 else array
