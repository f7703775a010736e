"""Stiffness and inertia as numbers."""

from __future__ import annotations

import math
from typing import ClassVar

from ...records import dataclass
from ..limits import Limit
from ..quantity import Pair, Units, Value
from .section import Data, Numbers, Outline, Section, SectionProperties


@dataclass(frozen=True)
class General(Section):
    """Stiffness and inertia as numbers, without a shape; no material gives them.

    ``GA``, ``EI`` and ``rhoI`` are one number for both directions or two: shear along e2 and e3,
    bending and inertia about e2 and e3. Inertia about e1 is the sum of the two.

    Args:
        EA: Against stretch [N].
        GA: Against shear, corrected [N].
        GJ: Against twist [N m^2].
        EI: Against bending [N m^2].
        rhoA: Mass per length [kg/m].
        rhoI: Moments of inertia per length [kg m].

    Raises:
        ModelError: a stiffness that is not positive, a negative inertia.

    Source: J. C. Simo, A finite strain beam formulation I, 1985.
    """

    kind: ClassVar[str] = "general"
    units: ClassVar[Units] = {
        **{"EA": "N", "GA": "N", "GJ": "N*m^2", "EI": "N*m^2", "rhoA": "kg/m", "rhoI": "kg*m"}
    }
    shaped: ClassVar[bool] = False
    EA: Value
    GA: Pair
    GJ: Value
    EI: Pair
    rhoA: Value = 0
    rhoI: Pair = 0

    def stiffness(self, data: Data, material: Data) -> SectionProperties:
        return SectionProperties(
            EA=data["EA"],
            GA2=data["GA.e2"],
            GA3=data["GA.e3"],
            GJ=data["GJ"],
            EI2=data["EI.e2"],
            EI3=data["EI.e3"],
            rhoA=data["rhoA"],
            rhoI2=data["rhoI.e2"],
            rhoI3=data["rhoI.e3"],
        )

    def relations(self) -> tuple[Limit, ...]:
        return ()

    def outline(self, values: Numbers) -> Outline:
        # that of a full round bar of this stiffness
        e2, e3 = (2 * math.sqrt(values[f"EI.{k}"] / values["EA"]) for k in ("e3", "e2"))
        return Outline(e2, e3, round=True)
