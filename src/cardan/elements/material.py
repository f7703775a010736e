"""Materials of beams."""

from __future__ import annotations

from ..errors import ModelError
from ..records import dataclass
from .limits import Limit, judge, not_negative, positive
from .quantity import Quantity, Value
from .validation import number

UNITS = {"E": "Pa", "nu": "", "G": "Pa", "rho": "kg/m^3", "damping": "s", "expansion": "1/K"}
LIMITS = (
    *positive("E", "G", requirement="more than 0 [Pa]"),
    Limit(
        "nu", "nu is {value}; give Poisson's ratio, above -1 and at most 0.5", -1.0, 0.5, open=True
    ),
    *not_negative("rho", requirement="0 or more [kg/m^3]"),
    *not_negative("damping", requirement="0 or more [s]"),
)


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
        for name in UNITS:
            if getattr(self, name) is not None:
                object.__setattr__(self, name, number("material", name, getattr(self, name)))
        if self.nu is not None and self.G is not None:
            raise ModelError("material: nu and G say the same with E; leave out one of them")
        judge("material", LIMITS, vars(self))

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
