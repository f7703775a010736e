"""Elastic materials of solids as numbers: isotropic and orthotropic."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Array
from ..elements.material import Material
from ..errors import ModelError, ModelWarning, brief, warn
from ..records import dataclass

# order of stresses and strains: xx, yy, zz, yz, zx, xy
LOCKING = 0.495  # Poisson's ratio beyond which cells of displacements are far too stiff
PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1))


@dataclass(frozen=True, eq=False)
class SolidMaterial:
    """A linear elastic material in the axes of the mesh.

    Stresses and strains have the order xx, yy, zz, yz, zx, xy, with engineering shear strains.

    Attributes:
        elasticity: Stress by strain (6, 6) [Pa].
        density: Mass density [kg/m^3].
        expansion: Strain per rise of temperature (6,) [1/K].
        stiffest: Largest Young's modulus [Pa].
        damping: Time by which a strain rate counts like a strain [s].
    """

    elasticity: Array
    density: float
    expansion: Array
    stiffest: float
    damping: float = 0.0


def orthotropic(
    E: ArrayLike,
    nu: ArrayLike,
    G: ArrayLike,
    rho: float = 0.0,
    expansion: ArrayLike = (0.0, 0.0, 0.0),
    axes: ArrayLike | None = None,
    damping: float = 0.0,
) -> SolidMaterial:
    """A material with three planes of symmetry, such as wood or a laminate.

    Args:
        E: Young's moduli E1, E2, E3 [Pa].
        nu: Poisson's ratios nu12, nu13, nu23; nu12 is the contraction along 2 by the extension
            along 1 when it is stretched along 1.
        G: Shear moduli G12, G13, G23 [Pa].
        rho: Mass density [kg/m^3].
        expansion: Strain per rise of temperature along 1, 2, 3 [1/K].
        axes: Directions 1, 2, 3 as columns (3, 3) in the axes of the mesh; these axes by default.
        damping: Time by which a strain rate counts like a strain [s], as of ``cd.material``.

    Returns:
        The material, for :func:`solid`.

    Raises:
        ModelError: moduli that are not positive, ratios with which strain energy would be
            negative, or axes that are not orthonormal.

    Source: R. M. Jones, Mechanics of Composite Materials, 2nd ed., sections 2.2 to 2.4.
    """
    who = "orthotropic"
    (e1, e2, e3), (n12, n13, n23), (g12, g13, g23), swelling = (
        _triple(who, name, value)
        for name, value in (("E", E), ("nu", nu), ("G", G), ("expansion", expansion))
    )
    for name, value in zip(
        ("E1", "E2", "E3", "G12", "G13", "G23"), (e1, e2, e3, g12, g13, g23), strict=True
    ):
        if not value > 0:
            raise ModelError(f"{who}: {name} is {value:g}; give a modulus above 0 [Pa]")
    density, loss = (
        _not_negative(who, name, value, unit)
        for name, value, unit in (("rho", rho, "kg/m^3"), ("damping", damping, "s"))
    )
    compliance = np.diag([1 / e1, 1 / e2, 1 / e3, 1 / g23, 1 / g13, 1 / g12])
    compliance[0, 1] = compliance[1, 0] = -n12 / e1
    compliance[0, 2] = compliance[2, 0] = -n13 / e1
    compliance[1, 2] = compliance[2, 1] = -n23 / e2
    if not np.linalg.eigvalsh(compliance)[0] > 0:
        raise ModelError(
            f"{who}: with nu = ({n12:g}, {n13:g}, {n23:g}) a strain would set energy free. Each "
            "nu_ij has to be below (E_i / E_j)^(1/2), and all three together smaller still: check "
            "which axis of the pair is stretched (nu12 / E1 = nu21 / E2)"
        )
    elasticity = np.linalg.inv(compliance)
    strains = np.array([*swelling, 0.0, 0.0, 0.0])
    if axes is not None:
        rotation = _rotation(who, axes)
        elasticity = _rotated_elasticity(elasticity, rotation)
        strains = _rotated_strain(strains, rotation)
    elasticity = (elasticity + elasticity.T) / 2
    return SolidMaterial(elasticity, density, strains, max(e1, e2, e3), loss)


def isotropic(source: str, material: Material) -> SolidMaterial:
    """The numbers of a material.

    Raises:
        ModelError: it has no elastic constants, they depend on parameters, or it is incompressible.
    """
    if not material.elastic:
        raise ModelError(
            f"{source}: the material has no E with nu or G: cd.material(E=210e9, nu=0.3, rho=7850)"
        )
    who = f"{source}: material"
    E, density, swelling, loss = (
        _number(who, name, getattr(material, name)) for name in ("E", "rho", "expansion", "damping")
    )
    if material.nu is not None:
        ratio = _number(who, "nu", material.nu)
    else:
        ratio = E / (2 * _number(who, "G", material.G)) - 1
    if not -1 < ratio <= 0.5:
        raise ModelError(
            f"{who}: E and G give nu = {ratio:g}, which is not between -1 and 1/2: check them, "
            "E = 2 G (1 + nu)"
        )
    if ratio == 0.5:
        raise ModelError(
            f"{who}: nu is {ratio:g}: with 1/2 the volume cannot change, and stresses do not "
            "follow from displacements alone; give less, such as 0.49"
        )
    if ratio > LOCKING:
        warn(
            f"{who}: nu is {ratio:.9g}: cells lock where the volume hardly changes, and are too "
            f"stiff. Give at most {LOCKING:g}, or expect that",
            ModelWarning,
        )
    shear = E / (2 * (1 + ratio))
    first = E * ratio / ((1 + ratio) * (1 - 2 * ratio))
    elasticity = np.diag([2 * shear] * 3 + [shear] * 3)
    elasticity[:3, :3] += first
    strains = np.array([swelling] * 3 + [0.0] * 3)
    return SolidMaterial(elasticity, density, strains, E, loss)


def _number(who: str, name: str, value: object) -> float:
    try:
        result = float(np.asarray(value, dtype=float))
    except (TypeError, ValueError):
        raise ModelError(
            f"{who}: {name}={brief(value)}: matrices of a mesh are numbers; give {name} as a number"
        ) from None
    if not np.isfinite(result):
        raise ModelError(f"{who}: {name} is {result}; give a finite number")
    return result


def _not_negative(who: str, name: str, value: object, unit: str) -> float:
    result = _number(who, name, value)
    if result < 0:
        raise ModelError(f"{who}: {name} is {result:g}; give 0 or more [{unit}]")
    return result


def _triple(who: str, name: str, values: ArrayLike) -> list[float]:
    entries = list(values) if np.iterable(values) else [values]
    if len(entries) != 3:
        raise ModelError(f"{who}: {name}={brief(values)}: give 3 numbers")
    return [_number(who, f"{name}[{k}]", value) for k, value in enumerate(entries)]


def _rotation(who: str, axes: ArrayLike) -> Array:
    matrix = np.array(axes, float)
    if matrix.shape != (3, 3) or not np.allclose(matrix.T @ matrix, np.eye(3), atol=1e-9):
        raise ModelError(
            f"{who}: axes={brief(axes)}: give three orthonormal directions as the columns of (3, 3)"
        )
    return matrix


def _rotated_elasticity(elasticity: Array, rotation: Array) -> Array:
    """A stiffness in rotated axes, by the tensor of rank four."""
    tensor = np.zeros((3, 3, 3, 3))
    for a, (i, j) in enumerate(PAIRS):
        for b, (k, l) in enumerate(PAIRS):
            for p, q in {(i, j), (j, i)}:
                for r, s in {(k, l), (l, k)}:
                    tensor[p, q, r, s] = elasticity[a, b]
    rotated = np.einsum("ai,bj,ck,dl,ijkl->abcd", *[rotation] * 4, tensor, optimize=True)
    return np.array([[rotated[(*p, *q)] for q in PAIRS] for p in PAIRS])


def _rotated_strain(strain: Array, rotation: Array) -> Array:
    """A strain in rotated axes; shear strains are twice the entries of the tensor."""
    tensor = np.zeros((3, 3))
    for value, (i, j) in zip(strain, PAIRS, strict=True):
        tensor[i, j] = tensor[j, i] = value if i == j else value / 2
    rotated = rotation @ tensor @ rotation.T
    return np.array([rotated[i, j] * (1 if i == j else 2) for i, j in PAIRS])
