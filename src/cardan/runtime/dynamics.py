"""Dynamics of a compiled model: accelerations, forces, powers, reactions."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import wrenches as outside
from .calling import Array
from .evaluation import State, Values, into
from .kinematics import Kinematics


class Dynamics(Kinematics, ABC):
    """Functions of M udot + h = f + tau; ``...`` are leading axes that broadcast."""

    def rhs(
        self,
        t: ArrayLike,
        x: ArrayLike,
        r: State | None = None,
        *,
        s: State | None = None,
        tau: State | None = None,
        wrenches: Values | None = None,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Time derivative (..., nx) of the state x = [q, u, z], as SciPy's solvers want it."""
        if tau is None and wrenches is None:
            return self._evaluate(("rhs", None), (t, x, r, s), parameters, out)
        # the C of rhs knows no outer forces: udot again, with them
        q, u, z = self.parts_of(x)
        rest: dict[str, Any] = {"r": r, "z": z, "s": s, "t": t, "parameters": parameters}
        udot = self.forward_dynamics(q, u, tau=tau, wrenches=wrenches, **rest)
        rates = self._evaluate(("rhs", None), (t, x, r, s), parameters, None)
        lead = np.broadcast_shapes(rates.shape[:-1], udot.shape[:-1])
        result: Array = np.array(np.broadcast_to(rates, (*lead, rates.shape[-1])))
        result[..., q.shape[-1] : q.shape[-1] + udot.shape[-1]] = udot
        return into(result, out)

    def events(
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
        """A number for every event (..., ne): it happens where that falls through zero."""
        return self._evaluate(("events", None), (t, q, u, r, z, s), parameters, out)

    def transition(
        self,
        q: State,
        u: State,
        events: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Speeds, internal states and modes behind events, [u, z, s] (..., nu + nz + ns).

        Args:
            events: 1 for every event that happens, else 0 (..., ne), or such numbers by name.
        """
        values = (t, q, u, r, z, s, events)
        return self._evaluate(("transition", None), values, parameters, out)

    def momenta(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Momenta p = dT/du (..., nu), canonical where speeds are rates of coordinates."""
        return self._evaluate(("momenta", None), (t, q, u, r), parameters, out)

    def momentum_rates(
        self,
        q: State,
        u: State,
        *,
        tau: State | None = None,
        r: State | None = None,
        z: ArrayLike | None = None,
        s: ArrayLike | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Rates of :meth:`momenta` (..., nu) under tau, the model's forces and constraints."""
        values = (t, q, u, r, tau, z, s)
        return self._evaluate(("momentum_rates", None), values, parameters, out)

    def hamiltonian(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """H = p . u - T + V (...) [J], which is the energy where no motion is prescribed."""
        return self._evaluate(("hamiltonian", None), (t, q, u, r), parameters, out)

    def rhs_jacobian(
        self,
        t: ArrayLike,
        x: ArrayLike,
        r: State | None = None,
        *,
        s: State | None = None,
        parameters: Values | None = None,
    ) -> tuple[Array, Array, Array]:
        """Partial derivatives of :meth:`rhs` by the state x as it is stored, by t and by inputs.

        A unit quaternion counts by its direction alone: along itself nothing changes. Derivatives
        along the speeds instead: ``derivative("rhs", wrt="q")``.

        Returns:
            d rhs / d x (..., nx, nx), d rhs / d t (..., nx), d rhs / d r (..., nx, nr).
        """
        flat = self._evaluate(("rhs_jacobian", None), (t, x, r, s), parameters, None)
        lead, n = flat.shape[:-1], np.shape(x)[-1]
        by_x, by_t, by_r = np.split(flat, [n * n, n * n + n], axis=-1)
        return by_x.reshape(*lead, n, n), by_t, by_r.reshape(*lead, n, by_r.shape[-1] // max(n, 1))

    def forward_dynamics(
        self,
        q: State,
        u: State,
        *,
        tau: State | None = None,
        wrenches: Values | None = None,
        r: State | None = None,
        z: ArrayLike | None = None,
        s: ArrayLike | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """udot (..., nu) with M udot + h = f + tau.

        Args:
            q: Coordinates (..., nq); quaternions (w, x, y, z) of length 1.
            u: Speeds (..., nu): v of robotics.
            tau: Generalized applied forces (..., nu) besides those of the model.
            wrenches: Frame -> (..., 6), moment then force at the frame origin, ground axes.
        """
        if parameters is None and wrenches is None:
            result: Array = self._calls["forward_dynamics", None](out, t, q, u, z, s, r, tau)
            return result
        if wrenches is not None:
            more = outside.generalized(self, wrenches, q, r=r, t=t, parameters=parameters)
            tau = more if tau is None else self._vector("tau", tau) + more
        key = ("forward_dynamics", None)
        return self._evaluate(key, (t, q, u, z, s, r, tau), parameters, out)

    def inverse_dynamics(
        self,
        q: State,
        u: State,
        udot: State,
        *,
        wrenches: Values | None = None,
        r: State | None = None,
        z: ArrayLike | None = None,
        s: ArrayLike | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """tau (..., nu) with M udot + h = f + tau, f being the forces of the model.

        Args:
            q: Coordinates (..., nq). u: Speeds (..., nu). udot: Their derivatives (..., nu).
            wrenches: Frame -> (..., 6), moment then force at the frame origin, ground axes; they
                act too, so that tau is what is left to do.
        """
        if parameters is None and wrenches is None:
            result: Array = self._calls["inverse_dynamics", None](out, t, q, u, udot, z, s, r)
            return result
        key = ("inverse_dynamics", None)
        tau = self._evaluate(key, (t, q, u, udot, z, s, r), parameters, None)
        if wrenches is not None:
            rest: dict[str, Any] = {"r": r, "t": t, "parameters": parameters}
            tau = tau - outside.generalized(self, wrenches, q, **rest)
        return into(tau, out)

    def mass_matrix(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """M (..., nu, nu): the kinetic energy is 1/2 uᵀ M u where nothing is prescribed."""
        return self._evaluate(("mass_matrix", None), (t, q, r), parameters, out)

    def bias(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """h (..., nu): velocity products and gravity, as in Pinocchio and MuJoCo."""
        return self._evaluate(("bias", None), (t, q, u, r), parameters, out)

    def gravity(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """The part of h that is left at rest, (..., nu)."""
        return self._evaluate(("gravity", None), (t, q, r), parameters, out)

    def coriolis(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """The vector h - gravity, (..., nu)."""
        return self._evaluate(("coriolis", None), (t, q, u, r), parameters, out)

    def applied(
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
        """f (..., nu): generalized forces of the model's force elements."""
        return self._evaluate(("applied", None), (t, q, u, r, z, s), parameters, out)

    def power(
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
        """Power [W] of everything that has no potential, one number per source."""
        return self._evaluate(("power", None), (t, q, u, r, z, s), parameters, out)

    def reaction(
        self,
        joint: str,
        q: State,
        u: State,
        *,
        tau: State | None = None,
        wrenches: Values | None = None,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Wrench of parent on child (..., 6), moment before force, at the child joint frame.

        [Mx, My, Mz, Fx, Fy, Fz] in its axes [N m], [N].

        Args:
            joint: A joint with motion or a fixed one.
            tau, wrenches: As for :meth:`forward_dynamics`: the system accelerates under them.

        Where redundant constraints leave it undetermined one of the possible wrenches comes out,
        and a SolveWarning says so once for each joint; see ``model.redundancy(q)``.
        """
        block = None
        if wrenches is not None:
            outside.refuse_ground(self, wrenches, joint)
            block = outside.by_part(self, wrenches, q, r=r, t=t, parameters=parameters)
        found = self._evaluate(("reaction", joint), (t, q, u, r, tau, block, z, s), parameters, out)
        self._doubt(joint, q, t, r)
        return found

    @abstractmethod
    def _doubt(self, joint: str, q: State, t: ArrayLike, r: State | None) -> None:
        """Warn once where the reaction of a joint is not determined at states."""

    def outputs(
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
        """The declared outputs, then the forces of prescribed motions (..., ny)."""
        return self._evaluate(("outputs", None), (t, q, u, r, z, s), parameters, out)

    # linear in the inertial parameters

    def regressor(
        self,
        q: State,
        u: State,
        udot: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Y (..., nu, n): ``inverse_dynamics`` is Y phi and what does not depend on phi.

        The n numbers phi are named by ``inertial_parameters``: ten of every body, then coefficients
        of force elements. Nothing else is left over in a robot whose forces are gravity, damping
        and friction.

        Args:
            q: Coordinates (..., nq). u: Speeds (..., nu). udot: Their derivatives (..., nu).

        Source: Atkeson, An and Hollerbach, Int. J. Robotics Research 5 (1986).
        """
        return self._evaluate(("regressor", None), (t, q, u, udot, z, s, r), parameters, out)

    def energy_regressor(
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
        """Rows (..., 3, n): times phi kinetic energy [J], potential energy [J], power [W].

        The power is that of coefficients without a potential, such as damping, negative where they
        take energy. What the energies gain is what tau and powers give: no accelerations are
        needed. Not for systems that time or inputs move.

        Source: Gautier and Khalil, IEEE Conf. Decision and Control (1988).
        """
        return self._evaluate(("energy_regressor", None), (t, q, u, r, z, s), parameters, out)

    def inertial_parameters(self, parameters: Values | None = None) -> dict[str, Any]:
        """phi by name: the numbers that forces and energies are linear in, (...) each.

        ``<body>.mass``, ``.moment_x`` ..., ``.xx`` ... ``.yz``: mass [kg], first moments [kg m] and
        inertia [kg m^2] about the frame of the body, in its axes, of the body with everything fixed
        to it; then ``<element>.damping`` and the like.
        """
        phi = self._evaluate(("inertial_parameters", None), (), parameters, None)
        names = self._function("inertial_parameters").outputs[0].get("entries") or []
        return {name: phi[..., k][()] for k, name in enumerate(names)}
