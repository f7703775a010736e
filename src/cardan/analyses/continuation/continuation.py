"""``model.continuation``: every equilibrium or position that a change leads to.

Where :func:`cardan.analyses.statics.statics.statics` ends at a limit load, this goes on: the load
is an unknown like the position, and turns back.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping

from numpy.typing import ArrayLike

from ...arguments import Count, LockedValues, checked
from ...errors import ArgumentError, ModelError, SolveError, SolveWarning, near, warn
from ...runtime.models.loaded_model import LoadedModel
from ..cycles import cycle_solutions
from ..simulation.progress import showing
from . import equilibrium_solutions, position_solutions
from .branches import MAIN, Tracer
from .follow import SHORTEST, Reach
from .record import ContinuationRecord
from .solutions import PathRequest, PathStart, Solutions
from .special_points import Test

POINTS = 300
BEYOND = 1e-6  # of bounds: a start on them
WITHIN = 1e-2  # of a range: a path that starts there ends at either end
# where paths of a kind of solutions start
STARTS: Mapping[str, Callable[[LoadedModel, PathRequest], PathStart]] = {
    "equilibria": equilibrium_solutions.start,
    "positions": position_solutions.start,
    "cycles": cycle_solutions.start,
}


@checked
def continuation(
    model: LoadedModel,
    swept: Mapping[str, object] | None = None,
    *,
    of: str = "equilibria",
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    locked: LockedValues | None = None,
    u: Mapping[str, object] | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    until: Mapping[str, float] | None = None,
    bounds: Mapping[str, tuple[float, float]] | None = None,
    events: Mapping[str, float] | None = None,
    branches: int | bool = 0,
    search: int = 0,
    points: Count = POINTS,
    step: float | None = None,
    check: bool = False,
    progress: bool | Callable[[float], None] | None = None,
    start: object = None,
    **named: object,
) -> ContinuationRecord:
    """All equilibria that a load leads to, through limit loads: ``model.continuation(P=(0, 10))``.

    Or all cycles: ``model.continuation(slope=(0.01, 0.02), of="cycles", start=gait)``.

    Args:
        model: The compiled model.
        swept, named: Parameter, input or ``t`` -> (start, end). The path ends at the end, and may
            turn back and leave the range before. Several go together.
        of: What the path consists of: ``"equilibria"``; ``"cycles"``, motions that repeat; or
            ``"positions"`` of a mechanism without forces, of which coordinates are swept too:
            ``crank=(0, 6.28)``. Then folds are dead points, branches meet where loops lose rank,
            and full turns are the same position.
        q: Coordinates to start from, by name or (nq,).
        locked: Coordinate -> value it keeps, or (start, end): displacements are prescribed.
        u: Speed of a steady motion -> value it keeps, or (start, end): equilibria relative to what
            turns, as ``model.equilibrium(u=)`` finds them.
        inputs, parameters: Values by name that stay, else those of the model.
        t: Time [s], where something is prescribed.
        until: Name -> value at which the path ends as well: of a coordinate, an output, what is
            swept, or ``<coordinate>.holding_force``.
        bounds: Name -> (low, high): the path ends where it leaves that range.
        events: Name -> value: where it is passed is noted.
        branches: How many generations of branches to follow from branch points, and of cycles from
            period doublings; True for all.
        search: At how many loads, evenly up to the end, to look for solutions that no branch
            leads to, as an imperfection makes them; their branches are called ``"other ..."``.
        points: Points of a branch at most.
        step: Longest step, as a part of the size of the system, of a radian and of the range.
        check: Raise where the path ends in between, instead of warning.
        progress: Show a bar, by default on terminals; or a function of the part that is done.
        start: Of cycles: the cycle to start from, see ``model.cycle``, whose parameters and inputs
            stay; or a Hopf point of equilibria or a period doubling of cycles, at which others
            begin.

    Returns:
        The path and its branches, with folds, branch points, Hopf points and events in ``points``;
        what was found before Ctrl-C too.

    Raises:
        ModelError: unknown names, nothing swept. ArgumentError: values of a wrong shape.
        SolveError: no equilibrium at the start; with ``check``, a path that ends in between.

    Source: H. B. Keller, Applications of Bifurcation Theory (1977), 359-384; M. Géradin, A.
    Cardona, Flexible Multibody Dynamics (2001), chapter 9.
    """
    _refuse_nonsense(branches, search, points, step, until, events)
    _refuse_unnamed(swept, locked)
    moved = {**(swept or {}), **named}
    request = PathRequest(moved, q, locked or {}, u, inputs, parameters, t, start)
    begin = _start(model, of, request)
    limits = _limits(begin, bounds)
    run = Tracer(
        lambda of: _tests(of, [*_ends(begin), *of.ends], until, limits, events),
        points, search, _reach(step),
    )  # fmt: skip
    with showing(progress, f"continuation of '{model.name}'") as show:
        return _checked(run.all_of(begin, 99 if branches is True else int(branches), show), check)


def _refuse_unnamed(*arguments: object) -> None:
    """Refuse values without names.

    Raises:
        ModelError: there are some.
    """
    if not all(isinstance(values, Mapping | None) for values in arguments):
        raise ModelError("continuation: locked= and what is swept go by name, such as P=(0, 10)")


def _start(model: LoadedModel, of: str, request: PathRequest) -> PathStart:
    """The start of a path of some kind.

    Raises:
        ModelError: the kind does not exist, or as its start says.
    """
    if of not in STARTS:
        raise ModelError(f"continuation: of='{of}' does not exist.{near(of, STARTS)}")
    return STARTS[of](model, request)


def _reach(step: float | None) -> Reach:
    """Controls of steps whose longest one may be given."""
    return Reach() if step is None else Reach(first=min(step, Reach().first), longest=step)


def _checked(path: ContinuationRecord, check: bool) -> ContinuationRecord:
    """The path, with a warning where it ends in between.

    Raises:
        SolveError: it does, with ``check``.
    """
    main = path.branches[MAIN]
    if main.status not in ("finished", "closed"):
        if check:
            raise SolveError(main.message)
        warn(main.message, SolveWarning)
    return path


def _refuse_nonsense(
    branches: int | bool,
    search: int,
    points: int,
    step: float | None,
    until: Mapping[str, float] | None,
    events: Mapping[str, float] | None,
) -> None:
    """Refuse numbers that mean nothing.

    Raises:
        ArgumentError: they do.
    """
    if branches < 0:
        raise ArgumentError(f"continuation: branches={branches}: give 0 or more, or True for all")
    if search < 0:
        raise ArgumentError(f"continuation: search={search}: give the number of loads, 0 or more")
    if points < 2:
        raise ArgumentError(f"continuation: points={points}: a path has 2 at least")
    if step is not None and not SHORTEST <= step < math.inf:
        raise ArgumentError(
            f"continuation: step={step}: give a length above 0, such as 0.1, from {SHORTEST:g} on"
        )
    for said, values in (("until", until), ("events", events)):
        for name, value in (values or {}).items():
            if not math.isfinite(value):
                raise ArgumentError(f"continuation: {said}={{'{name}': {value}}}: give a number")


def _limits(
    begin: PathStart, bounds: Mapping[str, tuple[float, float]] | None
) -> dict[str, tuple[float, float]]:
    """Bounds within which the start lies: those that it lies on are a little farther out.

    Raises:
        ArgumentError: bounds that nothing lies between. ModelError: the start does not.
    """
    limits = dict[str, tuple[float, float]]()
    for name, (low, high) in (bounds or {}).items():
        if not low < high:
            raise ArgumentError(
                f"continuation: bounds={{'{name}': ({low}, {high})}}: the first is the lower one"
            )
        value = begin.solutions.quantity(name)(begin.places[0].point)
        margin = BEYOND * (high - low)
        if not low - margin <= value <= high + margin:
            raise ModelError(
                f"continuation: the path starts at {name} = {value:.6g}, and bounds= end it "
                f"outside of {low:.6g} to {high:.6g}"
            )
        limits[name] = (
            low - 2 * margin * (value <= low + margin), high + 2 * margin * (value >= high - margin)
        )  # fmt: skip
    return limits


def _ends(begin: PathStart) -> Iterator[Test]:
    """Ends of the range; of one within which the path starts both."""
    yield begin.end
    family = begin.solutions.family
    if family.parameter(begin.places[0].point) > WITHIN:
        yield Test.at("the start", 0.0, family)


def _tests(
    solutions: Solutions,
    ends: list[Test],
    until: Mapping[str, float] | None,
    bounds: Mapping[str, tuple[float, float]],
    events: Mapping[str, float] | None,
) -> list[Test]:
    """Ends of a path and events on it."""

    def test(name: str, value: float, ends: bool) -> Test:
        of = solutions.quantity(name)
        return Test(f"{name} = {value:.10g}", lambda at: of(at.point) - value, ends)

    tests = [*ends, *(test(name, float(value), True) for name, value in (until or {}).items())]
    for name, limits in bounds.items():
        tests += [test(name, float(value), True) for value in limits]
    return tests + [test(name, float(value), False) for name, value in (events or {}).items()]
