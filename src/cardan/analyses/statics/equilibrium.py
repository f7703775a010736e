"""Equilibria: where a system rests under its forces, or moves steadily."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import LockedValues, checked
from ...arrays import Array
from ...errors import ModelError, SolveError, SolveWarning, brief, counted, near, warn
from ...records import dataclass
from ...runtime.calls.calling import numbers
from ...runtime.models.finite_elements.beam_sections import sections
from ...runtime.models.wrenches import force_names, force_part, reaction_part
from ...schema.functions import FUNCTIONS
from ...schema.rows import column
from ..simulation.linear_limits import warn_of_state
from ..systems import dynamic_system_of
from ..systems.dynamic_system import DynamicSystem, NamedState
from .force_balance import WORTH_A_WARNING, balance
from .newton import Search, equilibrium_search
from .settling import settled
from .stability_at_equilibrium import Stability, largest_motions, lockable, stand
from .static_problem import Load, Point, Problem, scaled

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

WAYS = ("full", "ramp", "damped", "creep")
DIRECT = WAYS[:1]
TRIES = 6  # starts beside an unstable position
ASIDE = 0.1
MAX_PRINTED = 24
STICKING, SLIDING = "sticking", "sliding"  # labels of modes
STEADY = 1e-8  # accelerations below this are none
CLOSED = 1e-9  # gaps of loops that stay closed as parts run on
# forces that are left in a steady motion: of momenta times speeds, of stiffnesses
ALONG, ROUNDED = 1e-6, 1e-13


@dataclass(frozen=True, repr=False, eq=False)
class EquilibriumRecord(NamedState):
    """A position at which a system rests, or moves steadily.

    ``found["elbow"]`` is a coordinate, ``found["elbow.u"]`` a speed, ``found["loop.px"]`` a
    multiplier. A run starts there: ``model.simulate(10, x0=found)``.

    Attributes:
        model: The model, with the parameters of this load.
        x: State [q, u, z] (nx,).
        lam: Multipliers (m,).
        holding_forces: Force of everything that is held, by coordinate [N, N m].
        inputs: By name.
        t: Time [s].
        stable: Whether small disturbances stay small; None where that could not be told. Of a path
            with prescribed displacements: under the forces that this takes, as dead loads.
        stable_held: The same with the displacements prescribed.
        n_negative: Negative eigenvalues of the stiffness on what constraints allow, under dead
            loads: independent directions in which the position is unstable.
        n_negative_held: The same with the displacements prescribed.
        free_motions: Motions that nothing resists, in words.
        modes: What stops, latches and dry friction do there, by name, in words.
        least: Lowest eigenvalue of the stiffness on what constraints allow [J].
        rounding: What rounding may leave of the forces that meet in a row, 50 units of it, over the
            largest load that acts; above 1e-4 the message tells it.
        iterations: Linear systems solved.
        converged: Whether it rests there.
        message: The same as a sentence.
        point, load: For analyses that go on from here.
    """

    model: LoadedModel
    x: Array
    lam: Array
    holding_forces: Mapping[str, float]
    inputs: Mapping[str, float]
    t: float
    stable: bool | None
    stable_held: bool | None
    n_negative: int
    n_negative_held: int
    free_motions: tuple[str, ...]
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

    def __getitem__(self, name: str) -> Any:
        """A coordinate, speed, internal state, multiplier or output by name.

        ``<joint>.force`` [N] and ``<joint>.moment`` [N m] (3,) are the reaction of a joint,
        ``<element>.force`` and ``<element>.moment`` what a force element exerts, as in a motion.

        Raises:
            ModelError: no such value.
        """
        named, model = self.named, self.model
        if name in named:
            return named[name]
        outputs = column(model.manifest.outputs, "name")
        if name in outputs:
            return float(self._called("outputs")[outputs.index(name)])
        if part := reaction_part(name, model.joints):
            return self.reaction(part[0])[part[1]]
        rows = model.manifest.element_forces
        if (entries := force_part(name, rows)) is not None:
            value = self._called("element_forces")[entries]
            return float(value) if isinstance(entries, int) else value
        names = [*named, *outputs, *force_names(rows)]
        raise ModelError(f"equilibrium['{name}']: there is no such value.{near(name, names)}")

    @checked
    def reaction(self, joint: str) -> Array:
        """Wrench (6,) of parent on child at the child joint frame, in its axes; moment first.

        Along the freedoms of the joint it holds what a JointSpring or JointForce exerts on it.
        """
        return self._called("reaction", joint)

    def _called(self, function: str, *of: str) -> Array:
        """The value of a function of the model there, under the forces that hold coordinates."""
        locked, tau = Problem(dynamic_system_of(self.model)).locked_forces(self.point, self.load)
        at = self.point.at
        arguments = {"r": self.load.r, "z": at.z, "s": at.s, "tau": tau if locked else ()}
        reads = FUNCTIONS[function].arguments
        some = {name: value for name, value in arguments.items() if len(value) and name in reads}
        value: Array = getattr(self.model, function)(*of, self.q, self.u, t=self.t, **some)
        return value

    @checked
    def pose(self, frame: str) -> Array:
        """Transform (4, 4) from frame axes to ground axes."""
        transform: Array = self.model.pose(frame, self.q, r=self.load.r, t=self.t)
        return transform

    @checked
    def sections(self, beam: str) -> Array:
        """Poses (nodes, 4, 4) of the sections of a beam, as :meth:`.Trajectory.sections`."""
        return sections(self.model.manifest.beams, beam, self.q, self.pose)

    def __repr__(self) -> str:
        lines = [f"'{self.model.name}': {self.message}"]
        stop = self.model.nq
        values = list(self.named.items())[:stop]
        lines += [f"  {name} = {value:.10g}" for name, value in values[:MAX_PRINTED]]
        lines += [f"  ... {stop - MAX_PRINTED} more"] if stop > MAX_PRINTED else []
        lines += [f"  '{n}' is held by {force:.6g}" for n, force in self.holding_forces.items()]
        return "\n".join(lines)


@checked
def equilibrium(
    model: LoadedModel,
    *,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    u: Mapping[str, ArrayLike] | None = None,
    locked: LockedValues | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    stable: bool = False,
    check: bool = False,
) -> EquilibriumRecord:
    """Equilibrium of a model under its forces, next to a start.

    Args:
        model: The compiled model.
        q: Coordinates to start from, by name or (nq,); the initial position if left out.
        u: Speeds by name of a steady motion: a rotor that spins, a regulator that turns. Those of
            other joints are 0, or follow from the constraints, and stay as they are; beams go
            along with what carries them. An empty one where prescribed motions turn all of it.
        locked: Coordinate -> value it keeps; the result tells the forces that takes.
        inputs, parameters: Values by name, else those of the model.
        t: Time [s], where something is prescribed.
        stable: Look for a stable one: downhill from the start.
        check: Raise where none is found, instead of warning.

    Returns:
        The equilibrium; where none was found the position that the search reached, ``converged``
        False.

    Raises:
        ModelError: unknown names, loops that cannot be assembled.
        SolveError: with ``check``, no equilibrium was found.
    """
    system = dynamic_system_of(model)
    load = read(system, locked, inputs, parameters, t, u)
    problem = Problem(system)
    point = problem.begin(load, q)
    search = settled(problem, point, load, ("creep",) if stable else WAYS)
    if stable and search.converged:
        search = downhill(problem, search, load)
    result = record(model, problem, search, load)
    if not result.converged:
        if check:
            raise SolveError(result.message)
        warn(result.message, SolveWarning)
    else:
        warn_of_state(model, result.x, result.t, load.r)
    return result


def read(
    system: DynamicSystem,
    locked: Mapping[str, object] | None,
    inputs: object,
    parameters: Mapping[str, float] | None,
    t: float,
    u: Mapping[str, object] | None = None,
) -> Load:
    """The load that a user described, checked."""
    if not isinstance(locked, Mapping | None):
        raise ModelError(f"locked={brief(locked)}: give coordinates with the values they keep")
    for name, value in (locked or {}).items():
        system.place(name)
        number = numbers(f"locked: '{name}'", value)
        if number.ndim or not np.isfinite(number):
            raise SolveError(f"locked: '{name}' is {brief(value)}; it must be one finite number")
    if not np.isfinite(t):
        raise SolveError(f"t={brief(t)}: it must be finite")
    p = system.changed(dict(parameters or {}))
    values = {n: float(numbers(f"locked: '{n}'", value)) for n, value in (locked or {}).items()}
    speeds = None if u is None else dict(u)
    return Load(float(t), system.input_vector(inputs), p, values, speeds)


def downhill(problem: Problem, search: Search, load: Load) -> Search:
    """A stable position next to one that may be unstable."""
    spent = search.iterations
    for _ in range(TRIES):
        stability = stand(problem, search.point, load)
        if not stability.negative:
            break
        away = np.zeros(len(search.motion))
        away[: len(stability.direction)] = stability.direction
        away *= ASIDE / np.abs(away).max()
        still = np.zeros(len(search.point.reaction_forces) + len(search.point.at.lam))
        neighbor = problem.moved(search.point, away, still, load)
        search = equilibrium_search(problem, neighbor, load, ("creep",))
        spent += search.iterations
        if not search.converged:
            break
    return replace(search, iterations=spent)


def record(
    model: LoadedModel,
    problem: Problem,
    search: Search,
    load: Load,
    computed: Stability | None = None,
) -> EquilibriumRecord:
    """The result as users see it; ``computed``: its stability, if that is known."""
    point, system = search.point, problem.system
    # without an equilibrium there is nothing to classify
    nothing = Stability(None, 0, np.nan, np.zeros(0), ())
    message = unsteady(problem, point, load) if search.converged else missed(system, search, load)
    search = replace(search, converged=not message)
    stability = (computed or stand(problem, point, load)) if search.converged else nothing
    # runs that start from the result must see the parameters of the load
    changed = model.with_parameters(dict(load.parameters)) if load.parameters else model
    tau = problem.locked_forces(point, load)[1]
    rounding = balance(problem, point, load).share if search.converged else np.nan
    return EquilibriumRecord(
        model=changed,
        x=np.concatenate([point.at.q, point.at.u, point.at.z]),
        lam=point.at.lam,
        holding_forces={name: float(tau[system.place(name)[1]]) for name in load.locked},
        inputs=dict(zip(system.inputs, load.r.tolist(), strict=True)),
        t=load.t,
        stable=stability.under_dead_load.stable,
        stable_held=stability.stable,
        n_negative=stability.under_dead_load.negative,
        n_negative_held=stability.negative,
        free_motions=stability.free_motions,
        modes=system.labels(point.at.s),
        least=stability.least,
        rounding=rounding,
        iterations=search.iterations,
        converged=search.converged,
        message=message
        or stability_message(stability, search, load.u is not None)
        + one_of_many(system.labels(point.at.s))
        + rounded(rounding),
        point=point,
        load=load,
    )


def one_of_many(modes: Mapping[str, str]) -> str:
    """Remark about a position that dry friction holds; "" for others."""
    sticking = [f"'{name}'" for name, label in modes.items() if label == STICKING]
    sliding = [f"'{name}'" for name, label in modes.items() if label.startswith(SLIDING)]
    if sticking:
        return f"; one of a set: {' and '.join(sticking)} would stick at positions next to it too"
    if sliding:
        return f"; one of a set: {' and '.join(sliding)} would stick at positions on one side too"
    return ""


def rounded(share: float) -> str:
    """Remark about the rounding of forces, relative to the loads; "" where it does not matter."""
    if share <= WORTH_A_WARNING:
        return ""
    return (
        f"; rounding of stiff parts may leave up to {share:.1g} of the loads unbalanced (distances "
        "from the origin times stiffnesses over lengths of elements)"
    )


def stability_message(stability: Stability, search: Search, moving: bool) -> str:
    """Stability as a sentence."""
    many = f"in {stability.negative} direction{'s' if stability.negative != 1 else ''}"
    kind = {True: "stable ", False: "unstable ", None: ""}[stability.stable]
    kind += "steady motion" if moving else "equilibrium"
    if stability.negative and stability.stable is True:
        kind += f", though forces push away {many}"
    elif stability.negative:
        kind += f", pushed away {many}"
    free_motions = (
        "; nothing holds " + " and ".join(stability.free_motions) if stability.free_motions else ""
    )
    return f"{kind}, after {counted(search.iterations, 'iteration')}{free_motions}"


def unsteady(problem: Problem, point: Point, load: Load) -> str:
    """Why given speeds are not steady motion; "" where they are, and at rest."""
    if load.u is None:
        return ""
    system, (locked, tau) = problem.system, problem.locked_forces(point, load)
    unit = max(1.0, float(np.abs(point.at.u / system.columns).max(initial=0.0)))
    try:
        moving = system.accelerations(point.at, tau).udot
    except SolveError:
        # parts without mass: forces balance, which is all that is known of them
        moving = point.at.udot
    left = moving - point.at.udot
    left[locked] = 0.0
    # as forces balance, only constraints may make other accelerations
    gap = np.abs(system.tangents(point.at).G @ left / system.rows)
    if gap.max(initial=0.0) > STEADY * unit**2:
        worst = int(np.abs(left / system.columns).argmax())
        return (
            f"no steady motion with these speeds: the constraints make '{system.speeds[worst]}' "
            f"change at {moving[worst]:.3g}. Give other speeds (u=), or take the motion at an "
            "instant: model.linearize(q=, u=)"
        )
    # a steady motion must also balance a little later, with everything turned along
    later = system.advance_steady(point.at) if load.u else None
    if later is None:
        return ""
    there = problem.supported(replace(point, at=later), replace(load, t=later.t))
    forces, gaps = problem.residual(there, load)
    if np.abs(gaps[: len(system.rows)]).max(initial=0.0) > CLOSED:
        return ""
    off = np.abs(forces[: len(left)])
    off[locked] = 0.0
    tangents, worst = system.tangents(later), int(off.argmax())
    momentum = (abs(tangents.M) @ np.abs(later.u)) * system.columns
    rounding = ROUNDED * float(abs(scaled(tangents.K, system.columns, system.columns)).max())
    if off[worst] > ALONG * unit * float(momentum.max(initial=0.0)) + rounding:
        return (
            "no steady motion: forces do not turn along (weight across the axis, a spring to the "
            f"ground?); a radian further those on '{system.owners[worst]}' do not balance. "
            "Simulate it"
        )
    return ""


def missed(system: DynamicSystem, search: Search, load: Load) -> str:
    """Why there is none, and what to do."""
    moving = largest_motions(system, search.motion)
    if search.pushed and moving:
        name = lockable(system, search.motion, load.locked)
        cure = f", or lock it: locked={{'{name}': 0}}" if name else ""
        return (
            f"no equilibrium: nothing holds {moving} against the load (a rigid-body mode). Add a "
            f"spring or a support{cure}"
        )
    where = f", moving {moving} most," if moving else ""
    return (
        f"no equilibrium: the search left{where} after {counted(search.iterations, 'iteration')}. "
        "Start nearer (q=), apply the load in steps (model.statics), or check signs and sizes of "
        "the forces"
    )
