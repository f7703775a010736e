"""Equilibria: where a system rests under its forces, or moves steadily."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Hold, checked
from ...arrays import Array
from ...errors import ModelError, SolveError, SolveWarning, counted, shown, warn
from ...runtime.calls.calling import numbers
from ..systems import contract_of
from ..systems.dynamic_system import Contract, NamedState
from .force_balance import TOLD, balance
from .newton import Search, rest
from .rest_stability import Standing, holdable, stand, words
from .settling import settled
from .static_problem import Load, Point, Problem, scaled

WAYS = ("full", "ramp", "damped", "creep")
DIRECT = WAYS[:1]
TRIES = 6  # starts beside an unstable position
ASIDE = 0.1
SHOWN = 24
STICKING, SLIDING = "sticking", "sliding"  # labels of modes
STEADY = 1e-8  # accelerations below this are none
CLOSED = 1e-9  # gaps of circuits that stay closed as parts run on
# forces that are left in a steady motion: of momenta times speeds, of stiffnesses
ALONG, ROUNDED = 1e-6, 1e-13


@final
@dataclass(frozen=True, repr=False, eq=False)
class Equilibrium(NamedState):
    """A position at which a system rests, or moves steadily.

    ``found["elbow"]`` is a coordinate, ``found["elbow.u"]`` a speed, ``found["loop.px"]`` a
    multiplier. A run starts there: ``model.simulate(10, x0=found)``.

    Attributes:
        model: The model, with the parameters of this load.
        x: State [q, u, z] (nx,).
        lam: Multipliers (m,).
        holding: Force of everything that is held, by coordinate [N, N m].
        inputs: By name.
        t: Time [s].
        stable: Whether small disturbances stay small; None where that could not be told. Of a path
            with prescribed displacements: under the forces that this takes, as dead loads.
        stable_held: The same with the displacements prescribed.
        n_negative: Negative eigenvalues of the stiffness on what constraints allow, under dead
            loads: independent directions in which the position is unstable.
        n_negative_held: The same with the displacements prescribed.
        loose: What moves freely there, in words.
        modes: What stops, latches and dry friction do there, by name, in words.
        least: Lowest eigenvalue of the stiffness on what constraints allow [J].
        rounding: What rounding may leave of the forces that meet in a row, 50 units of it, over the
            largest load that acts; above 1e-4 the message tells it.
        iterations: Linear systems solved.
        converged: Whether it rests there.
        message: The same as a sentence.
        point, load: For analyses that go on from here.
    """

    model: Any
    x: Array
    lam: Array
    holding: Mapping[str, float]
    inputs: Mapping[str, float]
    t: float
    stable: bool | None
    stable_held: bool | None
    n_negative: int
    n_negative_held: int
    loose: tuple[str, ...]
    modes: Mapping[str, str]
    least: float
    rounding: float
    iterations: int
    converged: bool
    message: str
    point: Point = field(repr=False)
    load: Load = field(repr=False)

    @property
    def named(self) -> dict[str, float]:
        """All coordinates, speeds, internal states and multipliers by name."""
        model = self.model
        names = (*model.coordinates, *model.speeds, *model.internals, *model.multipliers_of)
        return dict(zip(names, [*self.x.tolist(), *self.lam.tolist()], strict=True))

    @checked
    def reaction(self, joint: str) -> Array:
        """Wrench (6,) of parent on child at the child joint frame, in its axes."""
        held, tau = Problem(contract_of(self.model)).held(self.point, self.load)
        given: dict[str, Any] = {"r": self.load.r, "z": self.point.at.z, "tau": tau if held else ()}
        some = {name: value for name, value in given.items() if len(value)}
        found: Array = self.model.reaction(joint, self.q, self.u, t=self.t, **some)
        return found

    @checked
    def pose(self, frame: str) -> Array:
        """Transform (4, 4) from frame axes to ground axes."""
        found: Array = self.model.pose(frame, self.q, r=self.load.r, t=self.t)
        return found

    def __repr__(self) -> str:
        lines = [f"'{self.model.name}': {self.message}"]
        stop = self.model.nq
        values = list(self.named.items())[:stop]
        lines += [f"  {name} = {value:.10g}" for name, value in values[:SHOWN]]
        lines += [f"  ... {stop - SHOWN} more"] if stop > SHOWN else []
        lines += [f"  '{n}' is held by {force:.6g}" for n, force in self.holding.items()]
        return "\n".join(lines)


@checked
def equilibrium(
    model: Any,
    *,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    u: Mapping[str, ArrayLike] | None = None,
    hold: Hold | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    stable: bool = False,
    check: bool = False,
) -> Equilibrium:
    """Where a model rests under its forces, next to a start.

    Args:
        model: The compiled model.
        q: Coordinates to start from, by name or (nq,); the initial position if left out.
        u: Speeds by name of a steady motion: a rotor that spins, a regulator that turns. Those of
            other joints are 0, or follow from the constraints, and stay as they are; beams go
            along with what carries them. An empty one where prescribed motions turn all of it.
        hold: Coordinate -> value it keeps; the result tells the forces that takes.
        inputs, parameters: Values by name, else those of the model.
        t: Time [s], where something is prescribed.
        stable: Look for a stable one: downhill from the start.
        check: Raise where none is found, instead of warning.

    Returns:
        The equilibrium; where none was found the position that the search reached, ``converged``
        False.

    Raises:
        ModelError: unknown names, circuits that cannot be assembled.
        SolveError: with ``check``, no equilibrium was found.
    """
    system = contract_of(model)
    load = read(system, hold, inputs, parameters, t, u)
    problem = Problem(system)
    point = problem.begin(load, q)
    found = settled(problem, point, load, ("creep",) if stable else WAYS)
    if stable and found.converged:
        found = _downhill(problem, found, load)
    result = record(model, problem, found, load)
    if not result.converged:
        if check:
            raise SolveError(result.message)
        warn(result.message, SolveWarning)
    return result


def read(
    system: Contract,
    hold: Mapping[str, float] | None,
    inputs: Mapping[str, float] | None,
    parameters: Mapping[str, float] | None,
    t: float,
    u: Mapping[str, Any] | None = None,
) -> Load:
    """The load that a user described, checked."""
    if not isinstance(hold, Mapping | None):
        raise ModelError(f"hold={shown(hold)}: give coordinates with the values they keep")
    for name, value in (hold or {}).items():
        system.place(name)
        number = numbers(f"hold: '{name}'", value)
        if number.ndim or not np.isfinite(number):
            raise SolveError(f"hold: '{name}' is {shown(value)}; it must be one finite number")
    if not np.isfinite(t):
        raise SolveError(f"t={shown(t)}: it must be finite")
    p = system.changed(dict(parameters or {}))
    held = {name: float(value) for name, value in (hold or {}).items()}
    speeds = None if u is None else dict(u)
    return Load(float(t), system.given_inputs(inputs), p, held, speeds)


def _downhill(problem: Problem, found: Search, load: Load) -> Search:
    """A stable position next to one that may be unstable."""
    spent = found.iterations
    for _ in range(TRIES):
        standing = stand(problem, found.point, load)
        if not standing.negative:
            break
        away = np.zeros(len(found.motion))
        away[: len(standing.direction)] = standing.direction
        away *= ASIDE / np.abs(away).max()
        still = np.zeros(len(found.point.held) + len(found.point.at.lam))
        beside = problem.moved(found.point, away, still, load)
        found = rest(problem, beside, load, ("creep",))
        spent += found.iterations
        if not found.converged:
            break
    return replace(found, iterations=spent)


def record(
    model: Any, problem: Problem, found: Search, load: Load, known: Standing | None = None
) -> Equilibrium:
    """What was found, as users see it; ``known``: how it stands, if that was looked at."""
    point, system = found.point, problem.system
    nothing = Standing(None, 0, np.nan, np.zeros(0), ())
    message = unsteady(problem, point, load) if found.converged else missed(system, found, load)
    found = replace(found, converged=not message)
    standing = (known or stand(problem, point, load)) if found.converged else nothing
    changed = model.with_parameters(dict(load.parameters)) if load.parameters else model
    tau = problem.held(point, load)[1]
    rounding = balance(problem, point, load).share if found.converged else np.nan
    return Equilibrium(
        model=changed,
        x=np.concatenate([point.at.q, point.at.u, point.at.z]),
        lam=point.at.lam,
        holding={name: float(tau[system.place(name)[1]]) for name in load.hold},
        inputs=dict(zip(system.inputs, load.r.tolist(), strict=True)),
        t=load.t,
        stable=standing.under_dead_load.stable,
        stable_held=standing.stable,
        n_negative=standing.under_dead_load.negative,
        n_negative_held=standing.negative,
        loose=standing.loose,
        modes=system.labels(point.at.s),
        least=standing.least,
        rounding=rounding,
        iterations=found.iterations,
        converged=found.converged,
        message=message
        or told(standing, found, load.u is not None)
        + one_of_many(system.labels(point.at.s))
        + rounded(rounding),
        point=point,
        load=load,
    )


def one_of_many(modes: Mapping[str, str]) -> str:
    """What to say of a position that dry friction holds; "" of others."""
    sticking = [f"'{name}'" for name, label in modes.items() if label == STICKING]
    sliding = [f"'{name}'" for name, label in modes.items() if label.startswith(SLIDING)]
    if sticking:
        return f"; one of a set: {' and '.join(sticking)} would stick at positions next to it too"
    if sliding:
        return f"; one of a set: {' and '.join(sliding)} would stick at positions on one side too"
    return ""


def rounded(share: float) -> str:
    """What to say of the rounding of forces, over the loads; "" where it does not matter."""
    if share <= TOLD:
        return ""
    return (
        f"; rounding of stiff parts may leave up to {share:.1g} of the loads unbalanced (distances "
        "from the origin times stiffnesses over lengths of elements)"
    )


def told(standing: Standing, found: Search, moving: bool) -> str:
    """How it stands, as a sentence."""
    many = f"in {standing.negative} direction{'s' if standing.negative != 1 else ''}"
    kind = {True: "stable ", False: "unstable ", None: ""}[standing.stable]
    kind += "steady motion" if moving else "equilibrium"
    if standing.negative and standing.stable is True:
        kind += f", though forces push away {many}"
    elif standing.negative:
        kind += f", pushed away {many}"
    loose = "; nothing holds " + " and ".join(standing.loose) if standing.loose else ""
    return f"{kind}, after {counted(found.iterations, 'iteration')}{loose}"


def unsteady(problem: Problem, point: Point, load: Load) -> str:
    """Why given speeds are no steady motion; "" where they are, and at rest."""
    if load.u is None:
        return ""
    system, (held, tau) = problem.system, problem.held(point, load)
    unit = max(1.0, float(np.abs(point.at.u / system.columns).max(initial=0.0)))
    try:
        moving = system.accelerations(point.at, tau).udot
    except SolveError:
        # parts without mass: forces balance, which is all that is known of them
        moving = point.at.udot
    left = moving - point.at.udot
    left[held] = 0.0
    # as forces balance, only constraints may make other accelerations
    gap = np.abs(system.tangents(point.at).G @ left / system.rows)
    if gap.max(initial=0.0) > STEADY * unit**2:
        worst = int(np.abs(left / system.columns).argmax())
        return (
            f"no steady motion with these speeds: the constraints make '{system.speeds[worst]}' "
            f"change at {moving[worst]:.3g}. Give other speeds (u=), or take the motion at an "
            "instant: model.linearize(q=, u=)"
        )
    later = system.turned(point.at) if load.u else None
    if later is None:
        return ""
    there = problem.supported(replace(point, at=later), replace(load, t=later.t))
    forces, gaps = problem.residual(there, load)
    if np.abs(gaps[: len(system.rows)]).max(initial=0.0) > CLOSED:
        return ""
    off = np.abs(forces[: len(left)])
    off[held] = 0.0
    found, worst = system.tangents(later), int(off.argmax())
    momentum = (abs(found.M) @ np.abs(later.u)) * system.columns
    rounding = ROUNDED * float(abs(scaled(found.K, system.columns, system.columns)).max())
    if off[worst] > ALONG * unit * float(momentum.max(initial=0.0)) + rounding:
        return (
            "no steady motion: forces do not turn along (weight across the axis, a spring to the "
            f"ground?); a radian further those on '{system.owners[worst]}' do not balance. "
            "Simulate it"
        )
    return ""


def missed(system: Contract, found: Search, load: Load) -> str:
    """Why there is none, and what to do."""
    moving = words(system, found.motion)
    if found.pushed and moving:
        name = holdable(system, found.motion, load.hold)
        cure = f", or hold it: hold={{'{name}': 0}}" if name else ""
        return (
            f"no equilibrium: nothing holds {moving} against the load (a rigid-body mode). Add a "
            f"spring or a support{cure}"
        )
    where = f", moving {moving} most," if moving else ""
    return (
        f"no equilibrium: the search left{where} after {counted(found.iterations, 'iteration')}. "
        "Start nearer (q=), apply the load in steps (model.statics), or check signs and sizes of "
        "the forces"
    )
