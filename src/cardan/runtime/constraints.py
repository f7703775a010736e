"""Constraints of a compiled model: residuals, Jacobian, multipliers, and the way back onto them."""

from __future__ import annotations

from abc import ABC

from numpy.typing import ArrayLike

from .calling import Array
from .dynamics import Dynamics
from .evaluation import State, Values


class Constraints(Dynamics, ABC):
    """Functions of M udot + h = f + tau + Gᵀ lam, G udot = gamma; trees have none of them.

    The rows, those of position level first, are named in ``model.multipliers_of``.
    """

    def dependents(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Coordinates, then speeds (..., n), of joints that circuits in closed form determine."""
        return self._evaluate(("dependents", None), (t, q, u, r), parameters, out)

    def constraints(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """g (..., mp): what vanishes at position level; lengths [m], angles [rad]."""
        return self._evaluate(("constraints", None), (t, q, r), parameters, out)

    def constraint_rates(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """G u + g_t (..., m): what vanishes at velocity level, the derivative of g first."""
        return self._evaluate(("constraint_rates", None), (t, q, u, r, z, s), parameters, out)

    def constraint_jacobian(
        self,
        q: State,
        *,
        r: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """G (..., m, nu)."""
        return self._evaluate(("constraint_jacobian", None), (t, q, r, s), parameters, out)

    def closure(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """All closing conditions of all cut joints (..., n), also those that follow from others."""
        return self._evaluate(("closure", None), (t, q, r), parameters, out)

    def facing(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Cosines (..., n) that are positive where every cut joint is as it is built.

        Closing conditions vanish too where an axis is turned round; then one of these does not
        exceed 0. They are named in the manifest after their joints.
        """
        return self._evaluate(("facing", None), (t, q, r), parameters, out)

    def multipliers(
        self,
        q: State,
        u: State,
        *,
        tau: State | None = None,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """lam (..., m): the forces of constraint are Gᵀ lam; 0 for rows that follow from others.

        Args:
            q, u: As :meth:`forward_dynamics` takes them, on the constraints.
            tau: Generalized applied forces (..., nu).
        """
        return self._evaluate(("multipliers", None), (t, q, u, r, tau, z, s), parameters, out)

    def close_position(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """[q moved onto the constraints by one step, g before it] (..., nq + mp).

        The step is the shortest in the metric of M; repeated, it converges quadratically.
        """
        return self._evaluate(("close_position", None), (t, q, r), parameters, out)

    def close_velocity(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """[u moved onto the constraints, their rates before] (..., nu + m); M is the metric."""
        return self._evaluate(("close_velocity", None), (t, q, u, r, z, s), parameters, out)
