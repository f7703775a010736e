"""Linear models: small motions about an equilibrium, a steady motion or any state.

About a state that accelerates the matrices are those of the motion through it at that instant:
x is then the distance from that motion, not from the state.

Source: R. E. Roberson, R. Schwertassek, Dynamics of Multibody Systems (1988), chapter 13.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import checked
from ...arrays import Array
from ...errors import ModelError, listed, near
from ...runtime.calls.evaluation import State
from ..statics.equilibrium import Equilibrium, equilibrium
from ..statics.static_problem import Problem
from ..systems import contract_of
from ..systems.dynamic_system import Contract, Moment, dense
from .first_order import Choice, FirstOrder, first_order, pushed
from .linear_model import LinearModelRecord
from .steady_motion import SteadyMotionRecord


@checked
def linearize(
    model: Any,
    x: ArrayLike | Equilibrium | None = None,
    *,
    q: State | None = None,
    u: State | None = None,
    z: State | None = None,
    inputs: Iterable[str] | None = None,
    outputs: Iterable[str] | None = None,
    r: State | None = None,
    t: float = 0.0,
    parameters: Mapping[str, float] | None = None,
    choice: Choice | None = None,
) -> LinearModelRecord:
    """x' = A x + B r, y = C x + D r about a state, constraints eliminated.

    Args:
        model: The compiled model.
        x: State (nx,), an equilibrium or a trimmed motion; or q, u, z: by name or as arrays,
            assembled as runs assemble them. If all are left out the equilibrium next to the initial
            position.
        inputs: Inputs, or speeds and joints along which a force acts; all inputs if left out.
        outputs: Outputs, coordinates and speeds; if left out the declared outputs, or all
            coordinates if there are none.
        r: Inputs by name or (nr,) [of the state]. t: Time [s].
        parameters: Values by name, else those of the model.
        choice: Independent increments and speeds, as ``choice`` of another linear model has them.

    Returns:
        Independent increments, speeds, then internal states; with names.

    Raises:
        ModelError: unknown names, circuits that cannot be assembled.
        SolveError: accelerations are not determined there.
    """
    about = stance(model, x, q, u, z, r, t, parameters)
    at, held = about.at, about.held
    system = contract_of(about.model)
    found = first_order(system, at, held, about.tau, choice or about.choice)
    B, driven = _inputs(system, at, found, inputs)
    C, D, told = _outputs(system, at, found, outputs)
    D = D if inputs is None else _columns(system, D, driven)
    nz = len(system.internals)
    increments = tuple(system.increments[k] for k in found.e)
    states = (*increments, *(system.speeds[k] for k in found.v), *system.internals)
    return LinearModelRecord(
        name=system.name,
        A=found.A,
        B=B,
        C=C,
        D=D,
        states=states,
        inputs=driven,
        outputs=told,
        n=len(found.e),
        z=len(system.internals),
        mass=_mass(system, at, found),
        x=np.concatenate([at.q, at.u, at.z]),
        acceleration=_left(system, at, held, about.choice),
        choice=(found.e, found.v),
        units=np.concatenate([system.columns[found.e], system.columns[found.v], np.ones(nz)]),
        along=system.increments,
        increments=found.increments,
        speeds=found.speeds,
    )


class Stance(NamedTuple):
    """A state that is meant.

    Attributes:
        model: With the parameters that hold there.
        at: The state with its accelerations.
        held, tau: Speeds (places) that are held, forces along all of them (nu,).
        choice: Independent increments and speeds in which it is steady, None for any.
    """

    model: Any
    at: Moment
    held: list[int]
    tau: Array
    choice: Choice | None


def stance(model: Any, x: Any, q: Any, u: Any, z: Any, r: Any, t: float, parameters: Any) -> Stance:
    """The state that is meant, what is held there by which forces, and the model.

    An equilibrium has its multipliers already.
    """
    if x is None and q is None and u is None and z is None:
        given = contract_of(model).given_inputs(r)
        values = dict(zip(model.inputs, given.tolist(), strict=True))
        x = equilibrium(model, inputs=values, parameters=parameters, t=t, check=True)
    if isinstance(x, Equilibrium):
        held, tau = Problem(contract_of(x.model)).held(x.point, x.load)
        return Stance(x.model, x.point.at, held, tau, None)
    if isinstance(x, SteadyMotionRecord):
        return Stance(x.model, x.at, [], x.tau, x.choice)
    if parameters:
        model = model.with_parameters(dict(parameters))
    system = contract_of(model)
    at = system.state(x, q, u, z, float(t), system.given_inputs(r), None)
    still = np.zeros(len(system.columns))
    return Stance(model, system.accelerations(at, still), [], still, None)


def _left(system: Contract, at: Moment, held: list[int], choice: Choice | None) -> float:
    """The largest acceleration, without units of length; of a steady motion along its speeds."""
    found = (at.udot - system.steady(at)) / system.columns
    left = np.delete(found, held) if choice is None else found[choice[1]]
    return float(np.abs(left).max(initial=0.0))


def _inputs(
    system: Contract, at: Moment, found: FirstOrder, names: Iterable[str] | None
) -> tuple[Array, tuple[str, ...]]:
    """B for chosen inputs: declared ones, or forces along speeds."""
    if names is None:
        return found.B, system.inputs
    columns, chosen = list[Array](), listed("inputs", names, "torque")
    for name in chosen:
        if name in system.inputs:
            columns.append(found.B[:, system.inputs.index(name)])
            continue
        speed = next((n for n in (name, f"{name}.u") if n in system.speeds), None)
        if speed is None:
            known = (*system.inputs, *system.speeds)
            raise ModelError(f"linearize: there is no input or speed '{name}'.{near(name, known)}")
        answer = pushed(system, at, [system.speeds.index(speed)])[:, 0]
        n, v = len(found.e), len(found.v)
        column = np.zeros(len(found.A))
        column[n : n + v] = answer[found.v]
        columns.append(column)
    B = np.stack(columns, axis=1) if columns else np.zeros((len(found.A), 0))
    return B, tuple(chosen)


def _columns(system: Contract, D: Array, driven: tuple[str, ...]) -> Array:
    """D for chosen inputs."""
    zero = np.zeros((len(D), 1))
    wide = np.concatenate([D, zero], axis=1)
    places = [system.inputs.index(n) if n in system.inputs else len(system.inputs) for n in driven]
    return wide[:, places]


def _outputs(
    system: Contract, at: Moment, found: FirstOrder, names: Iterable[str] | None
) -> tuple[Array, Array, tuple[str, ...]]:
    """C, D and names of outputs: declared ones, coordinates, speeds, internal states."""
    chosen = list(system.outputs or system.coordinates)
    if names is not None:
        chosen = listed("outputs", names, "height")
    count, nz = len(found.A), len(system.internals)
    inner = np.eye(nz, count, count - nz)
    places = np.zeros((0, count))
    C, D = np.zeros((len(chosen), count)), np.zeros((len(chosen), len(system.inputs)))
    seen = system.seen(at) if any(n in system.outputs for n in chosen) else None
    for k, name in enumerate(chosen):
        if seen is not None and name in system.outputs:
            i = system.outputs.index(name)
            C[k] = seen.along[i] @ found.increments + seen.by_u[i] @ found.speeds
            C[k] += seen.by_z[i] @ inner
            D[k] = seen.by_r[i]
        elif name in system.coordinates:
            places = places if len(places) else system.turning(at) @ found.increments
            C[k] = places[system.coordinates.index(name)]
        elif name in system.speeds:
            C[k] = found.speeds[system.speeds.index(name)]
        elif name in system.internals:
            C[k] = inner[system.internals.index(name)]
        else:
            known = (*system.outputs, *system.coordinates, *system.speeds, *system.internals)
            raise ModelError(
                f"linearize: there is no output, coordinate or speed '{name}'.{near(name, known)}"
            )
    return C, D, tuple(chosen)


def _mass(system: Contract, at: Moment, found: FirstOrder) -> Array:
    """M of the independent speeds (nv, nv)."""
    n = len(found.e)
    moving = found.speeds[:, n : n + len(found.v)]
    return np.asarray(moving.T @ dense(system.tangents(at).M @ moving))


def about(steady: SteadyMotionRecord) -> LinearModelRecord:
    """The linear model about it."""
    return linearize(steady.model, steady)
