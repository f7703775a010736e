"""A model at states where actuators make a motion, and why they cannot."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from ...arrays import Array
from ...records import dataclass
from ...runtime.calls.evaluation import State
from ...runtime.models.loaded_model import LoadedModel
from ..statics.force_balance import elastic
from ..statics.static_problem import scaled
from ..systems import dynamic_system_of
from ..systems.dynamic_system import Moment
from .branches import lost_conditions
from .self_stress import null_space
from .undetermined_reactions import States

SHARE = 0.1  # entries below this part of the largest are not told


@dataclass(frozen=True)
class Place:
    """A model at states, (..., n).

    Attributes:
        arguments: Time, inputs and parameters, by argument.
    """

    model: LoadedModel
    q: Array
    u: Array
    arguments: Mapping[str, Any]

    @cached_property
    def jacobian(self) -> Array:
        """G (..., m, nu)."""
        if not self.model.nlam:
            return np.zeros((0, self.model.nu))
        return self.model.constraint_jacobian(self.q, **self.arguments)

    @property
    def inertia(self) -> Array:
        """M (..., nu, nu)."""
        every = {name: value for name, value in self.arguments.items() if name != "s"}
        return self.model.mass_matrix(self.q, **every)

    def force(self, udot: Array) -> Array:
        """M udot + h - f (..., nu)."""
        return self.model.inverse_dynamics(self.q, self.u, udot, **self.arguments)

    def lost(self, k: int, lead: tuple[int, ...]) -> tuple[str, int, int] | None:
        """Where branches meet at state k of (...): a joint or constraint there, how many of the
        independent constraints hold, and how many there are; None where none is lost.
        """
        arguments = (self.arguments[name] for name in ("t", "r", "parameters", "s"))
        states = States(self.model, lead, self.q, *arguments)
        m, q = states.mechanism(k), states.q[k]
        along = lost_conditions(m, q)
        if not along.size:
            return None
        rank = int(m.nu - len(null_space(m.jacobian(q).T)))
        owner = m.closing.rows[int(np.abs(along).max(axis=1).argmax())].joint
        return str(owner), rank, rank + along.shape[1]


def place_of(model: LoadedModel, q: State, u: State, arguments: dict[str, Any]) -> Place:
    """A model at states as users give them."""
    if arguments["s"] is not None:
        arguments["s"] = model._vector("s", arguments["s"])
    return Place(model, model._vector("q", q), model._vector("u", u), arguments)


def rounded(place: Place, udot: Array, left: Array) -> bool:
    """True when what is left is rounding of elastic forces, which are large where they rest too."""
    model, arguments = place.model, place.arguments
    system = dynamic_system_of(model.with_parameters(arguments["parameters"] or {}))
    lead, nu = left.shape[:-1], model.nu
    count = int(np.prod(lead))
    r = system.input_vector(None) if arguments["r"] is None else model._vector("r", arguments["r"])
    s = system.modes if arguments["s"] is None else arguments["s"]
    wide = ((place.q, model.nq), (place.u, nu), (udot, nu), (r, model.nr), (s, len(system.modes)))
    blocks = [np.broadcast_to(x, (*lead, n)).reshape(count, n) for x, n in wide]
    instants = np.broadcast_to(np.asarray(arguments["t"], dtype=float), lead).ravel()
    most = []
    for t, *(q, u, rate, inputs, modes) in zip(instants, *blocks, strict=True):
        lam, z = np.zeros(len(system.multipliers)), np.zeros(len(system.internals))
        at = Moment(float(t), q, u, rate, lam, inputs, z, modes)
        K = scaled(system.tangents(at).K, system.columns, system.columns)
        most.append(float((elastic(system, at, K) / system.columns).max(initial=0.0)))
    return bool((np.abs(left).reshape(count, nu).max(axis=1) <= np.array(most)).all())


def too_few(place: Place, left: Array, chosen: list[int]) -> str:
    """Message about motions that the actuators cannot influence."""
    model, rows = place.model, left.reshape(-1, place.model.nu)
    k = int(np.argmax(np.abs(rows).max(axis=1)))
    size = np.abs(rows[k]).max()
    large = np.abs(rows[k]) > SHARE * size
    names = listed([n for n, is_large in zip(model.speeds, large, strict=True) if is_large])
    have = listed([model.speeds[i] for i in chosen]) if chosen else "an empty set of actuators"
    where = f" at state {k}" if len(rows) > 1 else ""
    if singular := place.lost(k, left.shape[:-1]):
        owner, rank, count = singular
        return (
            f"model '{model.name}': the position{where} is singular, a change point: {rank} of "
            f"{count} independent constraints hold there, branches of the motion meet at "
            f"'{owner}', and no force of {have} acts along the motion of {names} that "
            f"is free there alone ({size:.3g} is missing). Ask for the position beside it, "
            "or name another actuator among these speeds; model.singular_positions(...) finds "
            "positions like it"
        )
    return (
        f"model '{model.name}': {have} cannot make this motion{where}: no force of theirs acts "
        f"along a motion of {names} together, where {size:.3g} is missing; name an actuator among "
        "these speeds, or let their accelerations follow by hybrid_dynamics"
    )


def listed(names: Sequence[str]) -> str:
    return ", ".join(f"'{name}'" for name in names[:8])
