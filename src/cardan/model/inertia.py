"""Moments of inertia of simple solids about their centers of mass.

Every function returns the principal moments (xx, yy, zz) [kg m^2]; mass and lengths are numbers or
expressions.

Source: any table of moments of inertia, such as Roberson and Schwertassek, Dynamics of Multibody
Systems, appendix; the formulas are volume integrals of constant density.
"""

from __future__ import annotations

from typing import Any

from ..errors import ModelError

Moments = tuple[Any, Any, Any]


def rod(mass: Any, length: Any, axis: str = "z") -> Moments:
    """A thin rod: m l^2 / 12 across, 0 along.

    Args:
        mass: [kg].
        length: [m].
        axis: Along which it lies: x, y or z.
    """
    return _around(axis, 0, mass * length**2 / 12)


def cylinder(mass: Any, radius: Any, length: Any, axis: str = "z") -> Moments:
    """A solid cylinder: m r^2 / 2 along, m (3 r^2 + l^2) / 12 across."""
    return _around(axis, mass * radius**2 / 2, mass * (3 * radius**2 + length**2) / 12)


def tube(mass: Any, outer: Any, inner: Any, length: Any, axis: str = "z") -> Moments:
    """A hollow cylinder with outer and inner radius."""
    squares = outer**2 + inner**2
    return _around(axis, mass * squares / 2, mass * (3 * squares + length**2) / 12)


def sphere(mass: Any, radius: Any) -> Moments:
    """A solid sphere: 2/5 m r^2."""
    moment = 2 * mass * radius**2 / 5
    return moment, moment, moment


def box(mass: Any, x: Any, y: Any, z: Any) -> Moments:
    """A solid box with edges x, y, z [m] along the axes."""
    return mass * (y**2 + z**2) / 12, mass * (x**2 + z**2) / 12, mass * (x**2 + y**2) / 12


def _around(axis: str, along: Any, across: Any) -> Moments:
    if axis not in ("x", "y", "z"):
        raise ModelError(f"axis of an inertia must be 'x', 'y' or 'z', not {axis!r}")
    x, y, z = (along if axis == name else across for name in "xyz")
    return x, y, z
