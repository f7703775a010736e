"""Interface of the cross-sections of beams; each is one file.

The axes of a section: e1 along the beam, e2 to the side, e3 up; all quantities refer to the
centroid, which is also taken for the shear center.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar

from ...ir.arithmetic import Scalar
from ...literature import HasSource
from ...records import dataclass
from ..limits import Limit, judge, not_negative, positive
from ..quantity import Pair, Quantity, Units, annotated, quantities_of
from ..validation import number, vector

Data = Mapping[str, "Scalar"]
Numbers = Mapping[str, float]
# what may be 0: beams without mass are allowed
INERTIAS = ("rhoA", "rhoI")


@dataclass(frozen=True)
class SectionProperties:
    """Stiffness and mass of a section: expressions of the parameters.

    Attributes:
        EA, GA2, GA3: Against stretch and shear along e2, e3, shear-corrected [N].
        GJ, EI2, EI3: Against twist and bending about e2, e3 [N m^2].
        rhoA, rhoI2, rhoI3: Mass and moments of inertia about e2, e3 per length [kg/m, kg m].
    """

    EA: Scalar
    GA2: Scalar
    GA3: Scalar
    GJ: Scalar
    EI2: Scalar
    EI3: Scalar
    rhoA: Scalar
    rhoI2: Scalar
    rhoI3: Scalar


@dataclass(frozen=True)
class Outline:
    """Outline to draw: half widths along e2 and e3 [m], an ellipse where ``round``.

    ``contour``: corners (e2, e3) [m] in their order, of another shape.
    """

    e2: float
    e3: float
    round: bool = False
    contour: tuple[tuple[float, float], ...] = ()


class Section(HasSource, ABC):
    """A cross-section; numbers, parameters or expressions of them."""

    kind: ClassVar[str]
    # of all fields, in their order
    units: ClassVar[Units]
    # whether the material gives the stiffness
    shaped: ClassVar[bool] = True

    def __post_init__(self) -> None:
        pairs = annotated(self, "Pair")
        for name in self.units:
            check = pair if name in pairs else number
            object.__setattr__(self, name, check(self.kind, name, getattr(self, name)))
        judge(self.kind, self.limits(), vars(self))

    def limits(self) -> tuple[Limit, ...]:
        """Limits of its numbers."""
        inertias = [name for name in self.units if name in INERTIAS]
        sizes = [name for name in self.units if name not in INERTIAS]
        return (*positive(*sizes), *not_negative(*inertias), *self.relations())

    def quantities(self) -> dict[str, Quantity]:
        """The user's values by name; become ``data``."""
        return {
            name: replace(one, labels=("e2", "e3")) if isinstance(one.value, tuple) else one
            for name, one in quantities_of(self, self.units).items()
        }

    @abstractmethod
    def stiffness(self, data: Data, material: Data) -> SectionProperties:
        """Stiffness and inertia.

        Args:
            data: Its quantities; those of two entries as ``name.e2`` and ``name.e3``.
            material: ``E G nu rho``; nothing is read where the section is not :attr:`shaped`.
        """

    def properties(self, data: Data, material: Data) -> SectionProperties:
        """Stiffness and inertia, with the rotary inertia that the user gave, if any."""
        properties = self.stiffness(data, material)
        if "rhoI.e2" not in data:
            return properties
        return replace(properties, rhoI2=data["rhoI.e2"], rhoI3=data["rhoI.e3"])

    @abstractmethod
    def relations(self) -> tuple[Limit, ...]:
        """Limits of its numbers against each other."""

    @abstractmethod
    def outline(self, values: Numbers) -> Outline:
        """Outline to draw."""


def made_of(
    area: Scalar,
    second: tuple[Scalar, Scalar],
    torsion: Scalar,
    shear: tuple[Scalar, Scalar],
    material: Data,
) -> SectionProperties:
    """A shape of one material.

    Args:
        area: [m^2].
        second: Second moments of area about e2 and e3 [m^4].
        torsion: Torsion constant [m^4].
        shear: Correction factors for shear along e2 and e3.
        material: ``E G rho``.
    """
    e, g, rho = material["E"], material["G"], material["rho"]
    return SectionProperties(
        EA=e * area,
        GA2=g * area * shear[0],
        GA3=g * area * shear[1],
        GJ=g * torsion,
        EI2=e * second[0],
        EI3=e * second[1],
        rhoA=rho * area,
        rhoI2=rho * second[0],
        rhoI3=rho * second[1],
    )


def corrections(data: Data, e2: Scalar, e3: Scalar) -> tuple[Scalar, Scalar]:
    """The shear correction factors that the user gave, else those of the shape."""
    return data.get("shear.e2", e2), data.get("shear.e3", e3)


def pair(owner: str, name: str, value: object) -> Pair:
    """One number for both directions, or two; None stays.

    Raises:
        ModelError: neither.
    """
    if value is None:
        return None
    listed = hasattr(value, "tolist") or isinstance(value, (list, tuple))
    return vector(owner, name, value, 2) if listed else number(owner, name, value)


def rectangle_shear(nu: Scalar) -> Scalar:
    """Correction factor of a rectangle.

    Source: G. R. Cowper, The shear coefficient in Timoshenko's beam theory, 1966.
    """
    return 10 * (1 + nu) / (12 + 11 * nu)
