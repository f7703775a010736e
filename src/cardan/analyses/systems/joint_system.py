"""The contract of a model in relative coordinates: small, dense, by its compiled functions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ModelError
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.verification.rotations import unit
from ...schema.blocks import Blocks, of_rate
from ..mechanisms.assemble import assemble_by_constraints
from ..mechanisms.consistent_rates import speeds
from ..mechanisms.mechanism import Mechanism
from ..simulation.settings import blocks, start
from ..simulation.starts.start import closed_start
from .compiled_system import CompiledSystem
from .dynamic_system import Internal, Moment, OutputJacobians, Parameters, Rates, Tangents
from .saddle_point import Dense, Matrix, Saddle

BALANCED = "balance", "balance_tangent"
STRAINED = "strain_balance", "strain_energy"
REACH = 1.0  # radians, or sizes of the mechanism


@final
class JointSystem(CompiledSystem):
    """A :class:`CompiledModel` as :class:`cardan.analyses.systems.dynamic_system.DynamicSystem`.

    Attributes:
        model: The model.

    The rest is described in :class:`.dynamic_system.DynamicSystem`.
    """

    def __init__(self, model: LoadedModel, strain: bool = False) -> None:
        """Args:
            model: Compiled, with ``balance`` among its functions.
            strain: Forces of strains and constraints alone, by ``strain_balance``.

        Raises:
            ModelError: these cannot be had.
        """
        needed = STRAINED if strain else BALANCED
        if not set(needed) <= set(model.manifest.available):
            raise ModelError(
                f"model '{model.name}' was compiled without '{needed[0]}' and '{needed[1]}': "
                "compile(..., functions=[...]) with them, or without functions="
            )
        if not model.manifest.projected:
            treatment = model.manifest.treatment
            raise ModelError(
                f"model '{model.name}' has constraints='{treatment}': equilibria and linear models "
                "keep constraints exactly. Compile with constraints='multipliers'"
            )
        m = Mechanism(model)
        super().__init__(model, m.closing.positions, m.size, strain)
        self.reach = REACH
        self.saddle: Saddle = Dense()
        self.leading = np.ones(model.nu, dtype=bool)

    @cached_property
    def _mechanism(self) -> Mechanism:
        return Mechanism(self.model)

    # where to begin

    def start(self, t: float, q: Any, r: Array, locked: Mapping[str, Any], p: Parameters) -> Moment:
        """Same as :meth:`DynamicSystem.start`."""
        model, x = self.start_state(q, locked, p)
        place, internal = x[: model.nq], x[model.nq + model.nu :]
        if len(self.positions):
            place = assemble_by_constraints(model, locked, start=place, t=t, r=r).q
        still, lam = np.zeros(model.nu), np.zeros(len(self.multipliers))
        internal = internal[: len(self.internals)]
        return Moment(t, place, still, still, lam, r, internal, self.modes, p)

    def state(self, x0: Any, q: Any, u: Any, z: Any, t: float, r: Array, p: Parameters) -> Moment:
        """Same as :meth:`DynamicSystem.state`."""
        model = self.model.with_parameters(dict(p)) if p else self.model
        begin = closed_start(model, start(model, x0, q, u, z), *blocks(x0, q, u), t, r)
        place, speed, internal = model.parts_of(begin.x)
        lam = np.zeros(len(self.multipliers))
        return Moment(t, place, speed, 0 * speed, lam, r, internal, self.modes, p)

    def steady_state(self, at: Moment, named: Mapping[str, Any]) -> Moment:
        """Same as :meth:`DynamicSystem.steady_state`: all speeds are those of joints."""
        u = speeds(self._at(at), at.q, named, np.zeros(self.model.nu))
        return replace(at, u=u, udot=np.zeros(self.model.nu))

    def steady_state_tangent(self, at: Moment, named: Mapping[str, Any]) -> tuple[Array, Array]:
        """Same as :meth:`DynamicSystem.steady_state_tangent`."""
        nu, tangents = self.model.nu, self.tangents(at)
        still = np.zeros((nu, nu))
        if not len(self.rows):
            return still, still
        rows = [self.speeds.index(name) for name in named if name in self.speeds]
        constrained = np.concatenate([tangents.G, np.eye(nu)[rows]])
        convective = np.concatenate([tangents.R, np.zeros((len(rows), nu))])
        return -np.linalg.pinv(constrained) @ convective, still

    def steady(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.steady`."""
        return np.zeros(self.model.nu)

    def advance_steady(self, at: Moment) -> Moment | None:
        """Same as :meth:`DynamicSystem.advance_steady`:

        where speeds are derivatives of coordinates.
        """
        largest = float(np.abs(at.u / self.columns).max(initial=0.0))
        if largest == 0 or not self._plain:
            return None
        after = 1.0 / largest
        return replace(at, t=at.t + after, q=self.integrate(at.q, after * at.u))

    def uniform(self, at: Moment) -> bool:
        """Same as :meth:`DynamicSystem.uniform`."""
        return True

    # equations

    def balance(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.balance`."""
        if not self.strain:
            return self._evaluate("balance", at)
        force_and_gaps = self._call("strain_balance", at, at.t, at.q, at.lam, at.r, at.s)
        return np.concatenate([force_and_gaps, np.zeros(len(self.multipliers))])

    def tangents(self, at: Moment) -> Tangents:
        """Same as :meth:`DynamicSystem.tangents`."""
        if self.strain:
            return self._strain_tangents(at)
        flat = np.ravel(self._evaluate("balance_tangent", at))
        nu, m = self.model.nu, len(self.multipliers)
        ends = np.cumsum([nu, nu, nu, m, m]) * nu
        K, C, M, R, G = (part.reshape(-1, nu) for part in np.split(flat, ends[:4]))
        return Tangents(K, C, M, R, G)

    def stiffness(self, at: Moment) -> tuple[Matrix, Matrix]:
        """Same as :meth:`DynamicSystem.stiffness`."""
        tangents = self.tangents(at)
        return tangents.K, tangents.G

    def _strain_tangents(self, at: Moment) -> Tangents:
        """Those of strains and constraints, which have neither damping nor mass."""
        nu, m = self.model.nu, len(self.multipliers)
        (slopes,) = self.model.derivative("strain_balance", Blocks("q"))(
            t=at.t, q=at.q, lam=at.lam, r=at.r, s=at.s, parameters=at.parameters
        )
        K = slopes[:nu]
        none, G = np.zeros((nu, nu)), np.zeros((m, nu))
        if m:
            G = self._call("constraint_jacobian", at, at.t, at.q, at.r, at.s)
        return Tangents(K, none, none, np.zeros((m, nu)), G)

    def strain_energy(self, at: Moment) -> float:
        """Same as :meth:`DynamicSystem.strain_energy`."""
        return float(self._call("strain_energy", at, at.t, at.q, at.r))

    def loads(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.loads`: weights, and what inputs exert.

        A weight is bounded, |sum of m g v| <= g (sum of m * sum of m v^2)^(1/2): parts that
        balance each other count too.
        """
        if self.strain:
            return np.zeros(self.model.nu)
        model = self.model.with_parameters(dict(at.parameters)) if at.parameters else self.model
        parameters = {**model.manifest.structural, **model.parameters}
        gravity = np.array([parameters.get(f"gravity.{axis}", 0.0) for axis in "xyz"])
        mass = sum(abs(parameters.get(f"{body.name}.mass", 0.0)) for body in model.manifest.bodies)
        moving = np.abs(np.diag(self.tangents(at).M)) * self.columns**2
        loads: Array = float(np.linalg.norm(gravity)) * np.sqrt(mass * moving)
        if np.any(at.r):
            nu, without = self.model.nu, replace(at, r=0 * at.r)
            exerted = self.balance(at)[:nu] - self.balance(without)[:nu]
            loads = loads + np.abs(exerted) * self.columns
        return loads

    def sizes(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.sizes`: at least that of the mechanism, or a radian."""
        sizes = np.ones(self.model.nu)
        for place, speed in self.places.values():
            sizes[speed] = max(1.0, abs(float(at.q[place])) / self.columns[speed])
        return sizes

    def internal_rates(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.internal_rates`."""
        if not self.model.nz:
            return np.zeros(0)
        x = np.concatenate([at.q, at.u, at.z])
        rates = self.model.rhs(at.t, x, at.r, s=at.s, parameters=at.parameters)
        return rates[-self.model.nz :]

    def internal(self, at: Moment) -> Internal:
        """Same as :meth:`DynamicSystem.internal`."""
        nu, nz = self.model.nu, self.model.nz
        if not nz:
            none = np.zeros((0, nu))
            return Internal(none.T, none, none, np.zeros((0, 0)))
        forces = self.model.derivative("inverse_dynamics", Blocks("z"))
        rates = self.rates(at)
        (by_z,) = forces(at.q, at.u, at.udot, **self._forcing(at))
        return Internal(by_z, rates.along[nu:], rates.by_u[nu:], rates.by_z[nu:])

    def rates(self, at: Moment, tau: Array | None = None) -> Rates:
        """Same as :meth:`DynamicSystem.rates`."""
        model = self.model
        wrt = Blocks(b for b, n in (("q", 1), ("u", 1), ("z", model.nz), ("r", model.nr)) if n)
        forward = model.derivative("forward_dynamics", wrt)
        slopes = forward(at.q, at.u, tau=tau, **self._forcing(at))
        if model.nz:
            x = np.concatenate([at.q, at.u, at.z])
            arguments: dict[str, Any] = {"s": at.s, "parameters": at.parameters}
            of_states = model.derivative("rhs", wrt)(at.t, x, at.r, **arguments)
            pairs = zip(slopes, of_states, strict=True)
            slopes = tuple(np.concatenate([a, b[-model.nz :]]) for a, b in pairs)
        slopes_by_block, empty = (
            dict(zip(wrt, slopes, strict=True)),
            np.zeros((model.nu + model.nz, 0)),
        )
        return Rates(
            slopes_by_block["q"],
            slopes_by_block["u"],
            slopes_by_block.get("z", empty),
            slopes_by_block.get("r", empty),
        )

    def accelerations(self, at: Moment, tau: Array | None = None) -> Moment:
        """Same as :meth:`DynamicSystem.accelerations`."""
        arguments = {"tau": tau, **self._forcing(at)}
        udot = self.model.forward_dynamics(at.q, at.u, **arguments)
        if not self.multipliers:
            return replace(at, udot=udot)
        return replace(at, udot=udot, lam=self.model.multipliers(at.q, at.u, **arguments))

    def output_jacobians(self, at: Moment) -> OutputJacobians:
        """Same as :meth:`DynamicSystem.output_jacobians`."""
        model, count = self.model, len(self.outputs)
        sizes = {"q": model.nu, "u": model.nu, "z": model.nz, "r": model.nr}
        jacobians = {b: np.zeros((count, n)) for b, n in sizes.items()}
        if count:
            wrt = Blocks(b for b, n in sizes.items() if n)
            rows = model.derivative("outputs", wrt)(at.q, at.u, **self._forcing(at))
            jacobians |= {b: matrix[:count] for b, matrix in zip(wrt, rows, strict=True)}
        return OutputJacobians(jacobians["q"], jacobians["u"], jacobians["z"], jacobians["r"])

    # coordinates

    def kinematic_matrix(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.kinematic_matrix`."""
        arguments: dict[str, Any] = {"t": at.t, "r": at.r, "parameters": at.parameters}
        basis = np.concatenate([np.zeros((1, self.model.nu)), np.eye(self.model.nu)])
        rates = self.model.qdot(at.q, basis, **arguments)
        return np.asarray(rates[1:] - rates[0]).T

    @cached_property
    def increments(self) -> tuple[str, ...]:
        """See :class:`DynamicSystem`."""
        model, names = self.model, list[str]()
        q, u = model.split(model.random_state(0))
        N = self.kinematic_matrix(Moment(0.0, q, u, u, r=self.input_vector(None)))
        for k, name in enumerate(self.speeds):
            coordinate = model.manifest.speeds[k].of or of_rate(name)
            place = self.coordinates.index(coordinate) if coordinate in self.coordinates else -1
            same = place >= 0 and N[place, k] == 1 and np.count_nonzero(N[place]) == 1
            names.append(coordinate if same else f"along {name}")
        return tuple(names)

    def observer(self, at: Moment) -> tuple[Array, Array]:
        """Same as :meth:`DynamicSystem.observer`:

        coordinates and speeds are told in their own axes.
        """
        return self._kinematics(at), np.zeros((self.model.nu, self.model.nu))

    def _kinematics(self, at: Moment) -> Array:
        """N E = d(N u + n) - dN/dt, along increments."""
        nu = self.model.nu
        if self._plain:
            return np.zeros((nu, nu))
        arguments: dict[str, Any] = {"t": at.t, "r": at.r, "parameters": at.parameters}
        slope = self.model.derivative("qdot", Blocks(("q", "u", "t")))
        basis = np.concatenate([np.zeros((1, nu)), np.eye(nu)])
        here, N, _ = slope(at.q, at.u, **arguments)
        along, _, by_t = slope(at.q, basis, **arguments)
        # the part of qdot that no speed makes moves along the coordinates too
        moving = at.u + self.drift(at)
        slope_of_N = ((along[1:] - along[0]) @ moving + by_t[1:] - by_t[0]).T
        rates: Array = np.linalg.lstsq(N, here - slope_of_N)[0]
        return rates

    @cached_property
    def _plain(self) -> bool:
        """True when speeds are derivatives of coordinates, one by one."""
        model = self.model
        if model.nq != model.nu or self._mechanism.chosen:
            return False
        rng = np.random.default_rng(0)
        places = model.split(model.random_state(rng, (2,)))[0]
        u = rng.normal(size=model.nu)
        return bool((model.qdot(places, u) == u).all())

    def with_internal_unknowns(self, at: Moment) -> Moment:
        """Same as :meth:`DynamicSystem.with_internal_unknowns`: there is nothing of the kind."""
        return at

    def retract(self, at: Moment, du: Array) -> Moment:
        """Same as :meth:`DynamicSystem.retract`."""
        return replace(at, q=self.integrate(at.q, du)) if np.any(du) else at

    def integrate(self, q: Array, du: Array) -> Array:
        """Same as :meth:`DynamicSystem.integrate`."""
        if self._mechanism.chosen:
            return self._mechanism.advance(q, du / self.columns)
        moved: Array = unit(self.model.integrate(q, du), self.model.manifest.quaternions)
        return moved

    def difference(self, q0: Array, q: Array) -> Array:
        """Same as :meth:`DynamicSystem.difference`."""
        difference: Array = self._mechanism.difference(q0, q) * self.columns
        return difference

    def _at(self, at: Moment) -> Mechanism:
        model = self.model.with_parameters(dict(at.parameters)) if at.parameters else self.model
        return Mechanism(model, at.t, at.r)

    def _evaluate(self, name: str, at: Moment) -> Array:
        return self._call(name, at, at.t, at.q, at.u, at.udot, at.lam, at.r, at.z, at.s)

    def _call(self, name: str, at: Moment, *values: ArrayLike) -> Array:
        return self.model._evaluate((name, None), values, at.parameters, None)

    def _forcing(self, at: Moment) -> dict[str, Any]:
        return {"t": at.t, "r": at.r, "z": at.z, "s": at.s, "parameters": at.parameters}
