"""Materials of beams."""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import ModelError
from .quantity import Quantity, Value
from .validation import is_expression, number, positive

UNITS = {"E": "Pa", "nu": "", "G": "Pa", "rho": "kg/m^3", "damping": "s", "expansion": "1/K"}


@dataclass(frozen=True)
class Material:
    """A linear elastic material; made by :func:`material`."""

    E: Value | None = None
    nu: Value | None = None
    G: Value | None = None
    rho: Value = 0
    damping: Value = 0
    expansion: Value = 0

    def __post_init__(self) -> None:
        for name in ("E", "G"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, positive("material", name, getattr(self, name)))
        for name in ("nu", "rho", "damping", "expansion"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, number("material", name, getattr(self, name)))
        if self.nu is not None and self.G is not None:
            raise ModelError("material: nu and G say the same with E; leave out one of them")
        numbers = {name: getattr(self, name) for name in UNITS}
        problem = complaint({n: x for n, x in numbers.items() if not is_expression(x)})
        if problem:
            raise ModelError(f"material: {problem}")

    def quantities(self) -> dict[str, Quantity]:
        """The user's values by name."""
        values = {name: getattr(self, name) for name in UNITS}
        return {name: Quantity(x, UNITS[name]) for name, x in values.items() if x is not None}

    @property
    def elastic(self) -> bool:
        """True when it says how stiff it is."""
        return self.E is not None and not (self.nu is None and self.G is None)


def material(
    E: Value | None = None,
    nu: Value | None = None,
    G: Value | None = None,
    rho: Value = 0,
    damping: Value = 0,
    expansion: Value = 0,
) -> Material:
    """A linear elastic material; numbers, parameters or expressions of them.

    Args:
        E: Young's modulus [Pa].
        nu: Poisson's ratio, above -1 and at most 1/2.
        G: Shear modulus [Pa], instead of ``nu``.
        rho: Mass density [kg/m^3].
        damping: Time [s] by which a strain rate counts like a strain (Kelvin and Voigt): stress =
            stiffness (strain + damping * strain rate).
        expansion: Strain per rise of temperature [1/K].

    Returns:
        The material, for any number of beams.

    Raises:
        ModelError: a modulus that is not positive, a ratio that no material has, a negative
            density or damping, or ``nu`` and ``G`` at once.
    """
    return Material(E, nu, G, rho, damping, expansion)


def complaint(values: dict[str, Value]) -> str:
    """Why no material has these numbers; "" where one may. None is not judged."""
    for name in ("E", "G"):
        if values.get(name) is not None and values[name] <= 0:
            return f"{name} is {values[name]:g} Pa; it must be above 0"
    nu = values.get("nu")
    if nu is not None and not -1 < nu <= 0.5:
        return f"nu is {nu:g}; Poisson's ratio is above -1 and at most 0.5"
    for name in ("rho", "damping"):
        if values.get(name) is not None and values[name] < 0:
            return f"{name} is {values[name]:g} {UNITS[name]}; it must not be negative"
    return ""
