"""Moments of inertia of simple solids about their centers of mass.

Every function returns the principal moments (xx, yy, zz) [kg m^2]; mass and lengths are numbers or
expressions.

Source: any table of moments of inertia, such as Roberson and Schwertassek, Dynamics of Multibody
Systems, appendix; the formulas are volume integrals of constant density.
"""

from __future__ import annotations

from typing import Any

from ..arguments import checked
from ..elements.quantity import Value
from ..errors import ModelError, brief
from .checks import is_number, quantity

LARGEST = 1e100  # whose square is a number too
Moments = tuple[Any, Any, Any]


@checked
def rod(mass: Value, length: Value, axis: str = "z") -> Moments:
    """A thin rod: m l^2 / 12 across, 0 along.

    Args:
        mass: [kg].
        length: [m].
        axis: Along which it lies: x, y or z.
    """
    mass, length = _numbers("rod", mass=mass, length=length)
    return _around(axis, 0, mass * _square(length) / 12)


@checked
def cylinder(mass: Value, radius: Value, length: Value, axis: str = "z") -> Moments:
    """A solid cylinder: m r^2 / 2 along, m (3 r^2 + l^2) / 12 across."""
    mass, radius, length = _numbers("cylinder", mass=mass, radius=radius, length=length)
    return _around(
        axis, mass * _square(radius) / 2, mass * (3 * _square(radius) + _square(length)) / 12
    )


@checked
def tube(mass: Value, outer: Value, inner: Value, length: Value, axis: str = "z") -> Moments:
    """A hollow cylinder with outer and inner radius."""
    mass, outer, inner, length = _numbers(
        "tube", mass=mass, outer=outer, inner=inner, length=length
    )
    squares = _square(outer) + _square(inner)
    return _around(axis, mass * squares / 2, mass * (3 * squares + _square(length)) / 12)


@checked
def sphere(mass: Value, radius: Value) -> Moments:
    """A solid sphere: 2/5 m r^2."""
    mass, radius = _numbers("sphere", mass=mass, radius=radius)
    moment = 2 * mass * _square(radius) / 5
    return moment, moment, moment


@checked
def box(mass: Value, x: Value, y: Value, z: Value) -> Moments:
    """A solid box with edges x, y, z [m] along the axes."""
    mass, x, y, z = _numbers("box", mass=mass, x=x, y=y, z=z)
    xx, yy, zz = _square(x), _square(y), _square(z)
    return mass * (yy + zz) / 12, mass * (xx + zz) / 12, mass * (xx + yy) / 12


def _numbers(solid: str, **given: Value) -> list[Value]:
    """Numbers of sane size, or expressions, as given.

    Raises:
        ModelError: something else.
    """
    for name, value in given.items():
        quantity(f"inertia.{solid}: {name}", value)
        if is_number(value) and not abs(value) < LARGEST:
            raise ModelError(f"inertia.{solid}: {name} is {brief(value)}; give a smaller number")
    return list(given.values())


def _square(length: Value) -> Value:
    """Its square; of a whole number a measured one, lest 1 m vanish from m l^2 with its unit."""
    return (float(length) if isinstance(length, int) else length) ** 2


def _around(axis: str, along: Value, across: Value) -> Moments:
    if axis not in ("x", "y", "z"):
        raise ModelError(f"axis of an inertia must be 'x', 'y' or 'z', not {brief(axis)}")
    x, y, z = (along if axis == name else across for name in "xyz")
    return x, y, z
