"""Linear models: small motions about an equilibrium, a steady motion or any state.

About a state that accelerates the matrices are those of the motion through it at that instant:
x is then the distance from that motion, not from the state. (``equations.linearize`` takes
accelerations of 0 unless ``udot="free"`` is given.)

Source: R. E. Roberson, R. Schwertassek, Dynamics of Multibody Systems (1988), chapter 13.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import checked
from ...arrays import Array
from ...errors import ModelError, listed, near
from ...runtime.calls.evaluation import State
from ..statics.equilibrium import EquilibriumRecord, equilibrium
from ..statics.static_problem import Problem
from ..systems import dynamic_system_of
from ..systems.dynamic_system import DynamicSystem, Moment, dense
from . import signal_units
from .first_order import Choice, FirstOrder, first_order, unit_force_accelerations
from .linear_model import LinearModelRecord
from .steady_motion import SteadyMotionRecord

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel


@checked
def linearize(
    model: LoadedModel,
    x: ArrayLike | EquilibriumRecord | None = None,
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

    About a state that is neither an equilibrium nor in steady motion the matrices are those of the
    motion that starts there by itself, as of ``equations.linearize(..., udot="free")``.

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
        ModelError: unknown names, loops that cannot be assembled.
        SolveError: accelerations are not determined there.
    """
    about = stance(model, x, q, u, z, r, t, parameters)
    at, locked = about.at, about.locked
    # one interface to relative and finite-element coordinates from here on
    system = dynamic_system_of(about.model)
    first = first_order(system, at, locked, about.tau, choice or about.choice)
    B, driven = _inputs(system, at, first, inputs)
    C, D, output_names = _outputs(system, at, first, outputs)
    D = D if inputs is None else _columns(system, D, driven)
    nz = len(system.internals)
    increments = tuple(system.increments[k] for k in first.e)
    states = (*increments, *(system.speeds[k] for k in first.v), *system.internals)
    return LinearModelRecord(
        name=system.name,
        A=first.A,
        B=B,
        C=C,
        D=D,
        states=states,
        inputs=driven,
        outputs=output_names,
        n=len(first.e),
        z=len(system.internals),
        mass=_mass(system, at, first),
        x=np.concatenate([at.q, at.u, at.z]),
        xdot=_rates(system, at, first),
        acceleration=_left(system, at, locked, about.choice),
        choice=(first.e, first.v),
        units=np.concatenate([system.columns[first.e], system.columns[first.v], np.ones(nz)]),
        along=system.increments,
        increments=first.increments,
        speeds=first.speeds,
        state_units=signal_units.of_states(about.model.manifest, states),
        input_units=signal_units.of_inputs(about.model.manifest, driven),
        output_units=signal_units.of_outputs(about.model.manifest, output_names),
    )


class Stance(NamedTuple):
    """A state that is meant.

    Attributes:
        model: With the parameters that hold there.
        at: The state with its accelerations.
        locked, tau: Speeds (places) that are held, forces along all of them (nu,).
        choice: Independent increments and speeds in which it is steady, None for any.
    """

    model: LoadedModel
    at: Moment
    locked: list[int]
    tau: Array
    choice: Choice | None


def stance(
    model: LoadedModel,
    x: object,
    q: object,
    u: object,
    z: object,
    r: object,
    t: float,
    parameters: Any,
) -> Stance:
    """The state that is meant, what is held there by which forces, and the model.

    An equilibrium has its multipliers already.
    """
    if x is None and q is None and u is None and z is None:
        inputs = dynamic_system_of(model).input_vector(r)
        values = dict(zip(model.inputs, inputs.tolist(), strict=True))
        x = equilibrium(model, inputs=values, parameters=parameters, t=t, check=True)
    if isinstance(x, EquilibriumRecord):
        locked, tau = Problem(dynamic_system_of(x.model)).locked_forces(x.point, x.load)
        return Stance(x.model, x.point.at, locked, tau, None)
    if isinstance(x, SteadyMotionRecord):
        return Stance(x.model, x.at, [], x.tau, x.choice)
    if parameters:
        model = model.with_parameters(dict(parameters))
    system = dynamic_system_of(model)
    at = system.state(x, q, u, z, float(t), system.input_vector(r), None)
    still = np.zeros(len(system.columns))
    return Stance(model, system.accelerations(at, still), [], still, None)


def _left(system: DynamicSystem, at: Moment, locked: list[int], choice: Choice | None) -> float:
    """The largest acceleration, without units of length; of a steady motion along its speeds."""
    imbalance = (at.udot - system.steady(at)) / system.columns
    left = np.delete(imbalance, locked) if choice is None else imbalance[choice[1]]
    return float(np.abs(left).max(initial=0.0))


def _rates(system: DynamicSystem, at: Moment, first: FirstOrder) -> Array:
    """Rates of the independent increments, speeds and of internal states (nx,)."""
    zdot = system.internal_rates(at) if system.internals else np.zeros(0)
    return np.concatenate([(at.u + system.drift(at))[first.e], at.udot[first.v], zdot])


def _inputs(
    system: DynamicSystem, at: Moment, first: FirstOrder, names: Iterable[str] | None
) -> tuple[Array, tuple[str, ...]]:
    """B for chosen inputs: declared ones, or forces along speeds."""
    if names is None:
        return first.B, system.inputs
    columns, chosen = list[Array](), listed("inputs", names, "torque")
    for name in chosen:
        if name in system.inputs:
            columns.append(first.B[:, system.inputs.index(name)])
            continue
        speed = next((n for n in (name, f"{name}.u") if n in system.speeds), None)
        if speed is None:
            declared = (*system.inputs, *system.speeds)
            raise ModelError(
                f"linearize: there is no input or speed '{name}'.{near(name, declared)}"
            )
        answer = unit_force_accelerations(system, at, [system.speeds.index(speed)])[:, 0]
        n, v = len(first.e), len(first.v)
        column = np.zeros(len(first.A))
        column[n : n + v] = answer[first.v]
        columns.append(column)
    B = np.stack(columns, axis=1) if columns else np.zeros((len(first.A), 0))
    return B, tuple(chosen)


def _columns(system: DynamicSystem, D: Array, driven: tuple[str, ...]) -> Array:
    """D for chosen inputs."""
    zero = np.zeros((len(D), 1))
    wide = np.concatenate([D, zero], axis=1)
    places = [system.inputs.index(n) if n in system.inputs else len(system.inputs) for n in driven]
    return wide[:, places]


def _outputs(
    system: DynamicSystem, at: Moment, first: FirstOrder, names: Iterable[str] | None
) -> tuple[Array, Array, tuple[str, ...]]:
    """C, D and names of outputs: declared ones, coordinates, speeds, internal states."""
    chosen = list(system.outputs or system.coordinates)
    if names is not None:
        chosen = listed("outputs", names, "height")
    count, nz = len(first.A), len(system.internals)
    inner = np.eye(nz, count, count - nz)
    places = np.zeros((0, count))
    C, D = np.zeros((len(chosen), count)), np.zeros((len(chosen), len(system.inputs)))
    jacobians = system.output_jacobians(at) if any(n in system.outputs for n in chosen) else None
    for k, name in enumerate(chosen):
        # declared outputs depend on positions, speeds, internal states and inputs
        if jacobians is not None and name in system.outputs:
            i = system.outputs.index(name)
            C[k] = jacobians.along[i] @ first.increments + jacobians.by_u[i] @ first.speeds
            C[k] += jacobians.by_z[i] @ inner
            D[k] = jacobians.by_r[i]
        elif name in system.coordinates:
            places = places if len(places) else system.kinematic_matrix(at) @ first.increments
            C[k] = places[system.coordinates.index(name)]
        elif name in system.speeds:
            C[k] = first.speeds[system.speeds.index(name)]
        elif name in system.internals:
            C[k] = inner[system.internals.index(name)]
        else:
            declared = (*system.outputs, *system.coordinates, *system.speeds, *system.internals)
            raise ModelError(
                f"linearize: there is no output, coordinate or speed '{name}'."
                f"{near(name, declared)}"
            )
    return C, D, tuple(chosen)


def _mass(system: DynamicSystem, at: Moment, first: FirstOrder) -> Array:
    """M of the independent speeds (nv, nv)."""
    n = len(first.e)
    moving = first.speeds[:, n : n + len(first.v)]
    return np.asarray(moving.T @ dense(system.tangents(at).M @ moving))


def about(steady: SteadyMotionRecord) -> LinearModelRecord:
    """The linear model about it."""
    return linearize(steady.model, steady)
