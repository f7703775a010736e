"""The generalized-alpha family: its coefficients and the methods of named authors.

Source: J. Chung, G. M. Hulbert, J. Appl. Mech. 60 (1993), 371-375; H. M. Hilber, T. J. R. Hughes,
R. L. Taylor, Earthquake Eng. Struct. Dyn. 5 (1977), 283-292; N. M. Newmark, J. Eng. Mech. Div. 85
(1959); M. Arnold, O. Brüls, Multibody Syst. Dyn. 18 (2007), 185-202 (with constraints).
"""

from __future__ import annotations

import math
from dataclasses import replace

from ...arguments import check_fields
from ...errors import ModelError, brief
from ...records import dataclass
from ...schema.integrators import INTEGRATORS, Integrator
from ...schema.integrators.alpha_family import FAMILY

RHO, HHT, INDEX = 0.8, -0.1, 2
MODIFIED = "modified"
NEWTON = (MODIFIED, "full")


@dataclass(frozen=True)
class Alpha:
    """Coefficients of the generalized-alpha method.

    (1 - am) a' + am a = (1 - af) udot' + af udot, with increments
    h u + h^2 ((1/2 - beta) a + beta a') of positions and h ((1 - gamma) a + gamma a') of speeds.

    Attributes:
        am, af: Where accelerations and forces are taken within a step.
        beta, gamma: Newmark's coefficients.

    Raises:
        ModelError: numbers with which a step has no meaning.
    """

    am: float
    af: float
    beta: float
    gamma: float

    def __post_init__(self) -> None:
        check_fields(self)
        numbers = (self.am, self.af, self.beta, self.gamma)
        if not all(map(math.isfinite, numbers)) or not (self.beta > 0 and self.gamma > 0):
            raise ModelError(f"{self}: numbers are wanted, beta and gamma positive")
        if not (self.am < 1 and self.af < 1):
            raise ModelError(f"{self}: am and af lie below 1")

    @classmethod
    def newmark(cls, beta: float = 0.25, gamma: float = 0.5) -> Alpha:
        """Newmark's method: the average acceleration unless said otherwise.

        Args:
            beta, gamma: Order 2 asks for gamma = 1/2; more damps, at order 1.
        """
        return cls(0.0, 0.0, beta, gamma)

    @classmethod
    def hht(cls, alpha: float = HHT) -> Alpha:
        """The method of Hilber, Hughes and Taylor.

        Args:
            alpha: -1/3 (most damping) to 0 (none).

        Raises:
            ModelError: outside of that.
        """
        if not -1 / 3 <= alpha <= 0:
            raise ModelError(f"HHT: alpha={alpha:g} lies outside -1/3 ... 0")
        return cls(0.0, -alpha, (1 - alpha) ** 2 / 4, 0.5 - alpha)

    @classmethod
    def chung_hulbert(cls, rho_inf: float = RHO) -> Alpha:
        """The least damping of what a step resolves for a given damping of what it does not.

        Args:
            rho_inf: Factor per step of infinitely fast oscillations, 0 (gone at once) to 1 (kept).

        Raises:
            ModelError: outside of that.
        """
        if not 0 <= rho_inf <= 1:
            raise ModelError(f"generalized-alpha: rho_inf={rho_inf:g} lies outside 0 ... 1")
        am, af = (2 * rho_inf - 1) / (rho_inf + 1), rho_inf / (rho_inf + 1)
        return cls(am, af, (1 - am + af) ** 2 / 4, 0.5 - am + af)

    @property
    def shift(self) -> float:
        """am - af: in steps, the time after t for which the accelerations a of the method stand."""
        return self.am - self.af

    @property
    def order(self) -> int:
        """Order of the global error: 2 where gamma = 1/2 - am + af."""
        return 2 if math.isclose(self.gamma, 0.5 - self.shift, abs_tol=1e-12) else 1

    @property
    def rho_inf(self) -> float:
        """Factor per step of infinitely fast oscillations; with constraints, of their errors."""
        # a and u that give no displacement, and what is left of udot
        h_u, h_a = 1 - self.gamma / self.beta, 1 - self.gamma / (2 * self.beta)
        a_u, a_a = -1 / self.beta, 1 - 1 / (2 * self.beta)
        half, product = (h_u + a_a) / 2, h_u * a_a - h_a * a_u
        root = half * half - product
        # the named methods have a double one
        root = 0.0 if abs(root) < 1e-12 else root
        pair = abs(half) + math.sqrt(root) if root >= 0 else math.sqrt(product)
        return max(pair, abs(self.af / (1 - self.af)))


@dataclass(frozen=True)
class GeneralizedAlpha:
    """``method=`` of a run: the generalized-alpha method with a damping of choice.

    Attributes:
        rho_inf: Factor per step of what is too fast for the step, 0 to 1; with constraints at
            most 0.95.
        index: How constraints of positions are kept: 2, positions and velocities (stabilized);
            3, positions alone.
        coefficients: Others than those of Chung and Hulbert: ``cd.stability.Alpha.hht(-0.05)``.
        newton: When the tangent is taken and factored anew: ``"modified"``, once corrections no
            longer shrink well with it or the step has changed by a quarter, over as many steps as
            that takes; ``"full"``, at every correction.

    Raises:
        ModelError: a number outside its range.
    """

    rho_inf: float = RHO
    index: int = INDEX
    coefficients: Alpha | None = None
    newton: str = MODIFIED

    def __post_init__(self) -> None:
        check_fields(self)
        Alpha.chung_hulbert(self.rho_inf)
        if self.index not in (2, 3):
            raise ModelError(
                f"GeneralizedAlpha: index={brief(self.index)} is 2 (positions and velocities) or 3 "
                "(positions alone)"
            )
        if self.newton not in NEWTON:
            raise ModelError(
                f"GeneralizedAlpha: newton={brief(self.newton)} is 'modified' (one "
                "tangent for as many "
                "corrections and steps as it serves) or 'full' (a new one at every correction)"
            )

    @property
    def alpha(self) -> Alpha:
        """The coefficients."""
        return self.coefficients or Alpha.chung_hulbert(self.rho_inf)


def method_of(method: GeneralizedAlpha) -> Integrator:
    """The integrator of what a user chose."""
    alpha, usual = method.alpha, INTEGRATORS["GeneralizedAlpha"]
    renewed = float(NEWTON.index(method.newton))
    return replace(
        usual,
        order=alpha.order,
        options=(alpha.am, alpha.af, alpha.beta, alpha.gamma, float(method.index), renewed),
        # coefficients of the user are his own: they are refused, not capped
        conditions=usual.conditions if method.coefficients is None else FAMILY.conditions,
    )
