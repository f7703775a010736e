"""Reference solutions for the errors of integrators:

two runs by other, far more accurate methods.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from ....arrays import Array
from ....errors import CodegenError, DerivationError, ModelError, SolveError
from ....records import dataclass
from ....runtime.trajectory.trajectory import TrajectoryRecord

Run = Callable[..., TrajectoryRecord]

FIRST, SECOND = 1e-13, 1e-12  # tolerances of methods of high order
# methods of order 2 for stiff scenes, whose error in fixed steps h is c h^2 + O(h^3)
EXTRAPOLATED = ("GeneralizedAlpha", "HHT")
FEWEST, DOUBLINGS = 10, 12  # steps between two output times at first; times they are doubled
DIGITS = 1e-11  # of the largest coordinate: finer than this, rounding of many steps takes over


class OutOfTime(Exception):
    """A run takes longer than somebody wants to wait."""


@dataclass(frozen=True)
class Reference:
    """Coordinates at the output times, as good as they are known.

    Attributes:
        q: They (n, nq).
        doubt: By how much two of them differ: smaller errors mean nothing.
        description: Where they come from.
    """

    q: Array
    doubt: float
    description: str


@dataclass(frozen=True)
class Candidate:
    """One way to a reference: a method and how it was run."""

    name: str
    how: str
    q: Array
    doubt: float = 0.0


def reference(
    run: Run, times: Array, distance: Callable[[Array, Array], float], derived: bool, allowed: float
) -> Reference:
    """Two references by different methods: explicit, implicit, or extrapolated where those crawl.

    Args:
        run: Simulates at the output times with ``method=`` and its settings; raises
            :class:`OutOfTime` where it would take more than what is allowed.
        times: Output times [s], equally spaced.
        distance: Largest difference of two tables of coordinates.
        derived: Whether the model has the Jacobian that Radau needs.
        allowed: Time for a run [s].

    Raises:
        SolveError: no method reaches the end.
    """
    accepted: list[Candidate] = []
    troubles: list[str] = []
    for one in _candidates(run, times, distance, derived, allowed, troubles):
        accepted.append(one)
        if len(accepted) == 2:
            break
    if not accepted:
        raise SolveError(f"no reference: {troubles[-1]}. Take a shorter time, or more patience")
    first = accepted[0]
    # what ruled the usual methods out says why these were taken
    why = f"; {troubles[-1]}" if troubles else ""
    if len(accepted) == 1:
        accuracy = f", known to {first.doubt:.0e}" if first.doubt else ""
        description = f"{first.name} {first.how}{accuracy}, which no second method confirms{why}"
        return Reference(first.q, first.doubt, description)
    second = accepted[1]
    doubt = max(distance(first.q, second.q), first.doubt, second.doubt)
    before = first.name if first.how == second.how else f"{first.name} {first.how}"
    description = f"{before} and {second.name} {second.how}, which differ by {doubt:.0e}{why}"
    return Reference(first.q, doubt, description)


def _candidates(
    run: Run,
    times: Array,
    distance: Callable[[Array, Array], float],
    derived: bool,
    allowed: float,
    troubles: list[str],
) -> Iterator[Candidate]:
    """References from the most to the least exact; what hinders others is added to troubles."""
    slow = False
    for name in ("DOP853", *(["Radau"] if derived else []), "RK45"):
        # stability limits all explicit methods alike
        if slow and name == "RK45":
            continue
        for rtol in (FIRST, SECOND):
            setting = f"{name} at rtol {rtol:.0e}"
            try:
                motion = run(method=name, rtol=rtol)
            except OutOfTime:
                troubles.append(f"{setting} would take more than {allowed:g} s")
                slow = slow or name == "DOP853"
                break
            if motion.success:
                yield Candidate(name, f"at rtol {rtol:.0e}", motion.q)
                break
            troubles.append(f"{setting}: {motion.message}")
    for name in EXTRAPOLATED:
        try:
            yield _extrapolated(name, run, times, distance)
        except OutOfTime:
            troubles.append(f"{name} in fixed steps would take more than {allowed:g} s")
        except (ModelError, DerivationError, CodegenError, SolveError) as refused:
            troubles.append(str(refused))


def _extrapolated(
    name: str, run: Run, times: Array, distance: Callable[[Array, Array], float]
) -> Candidate:
    """A run in steps h and h / 2, extrapolated to steps of 0, for ever smaller h.

    Raises:
        OutOfTime: not three runs are done in time. SolveError: one does not reach its end.

    Source: L. F. Richardson, Phil. Trans. R. Soc. A 210 (1911), 307-357.
    """
    gap = float(times[1] - times[0])
    best: Candidate | None = None
    coarse: Array | None = None
    before: Array | None = None
    worse, spent = 0, 0.0
    for k in range(DOUBLINGS):
        h = gap / (FEWEST * 2**k)
        try:
            motion = run(method=name, step=h, spent=spent)
        except OutOfTime:
            break
        spent += motion.statistics["milliseconds"] / 1000
        if not motion.success:
            if before is None:
                # coarse steps may fail where fine ones do not
                continue
            break
        # Richardson extrapolation of a method of order 2
        value = None if coarse is None else (4 * motion.q - coarse) / 3
        if value is not None and before is not None:
            doubt = distance(value, before)
            how = f"in steps of {h:.2g} s extrapolated to 0"
            # rounding grows again once the steps are too fine
            worse = worse + 1 if best is not None and doubt > best.doubt else 0
            if best is None or doubt < best.doubt:
                best = Candidate(name, how, value, doubt)
            if best.doubt <= DIGITS * max(1.0, float(np.abs(value).max(initial=0.0))) or worse > 1:
                break
        coarse, before = motion.q, value
    if best is None:
        raise OutOfTime
    return best
