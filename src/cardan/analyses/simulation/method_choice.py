"""Choose the method of ``method="auto"``: a table of reasons, the first that holds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from ...errors import SolveError
from ...records import dataclass
from .precision.stiffness import stiffness
from .times import Span

JACOBIAN = "rhs_jacobian"
FINE = 1e-7  # below this rtol Radau needs fewer steps than Rosenbrock
OFTEN = 500  # stops in a run, from which on they set the length of steps
MANY = 1000  # steps after which rates are compared
LOOKED = 12  # looks at what limits the steps, before one judges
MOST = 0.75  # of them that found stability


@dataclass(frozen=True)
class Case:
    """The facts that the choice is made from.

    Attributes:
        rtol: Tolerance.
        period: Shortest time between two samples or ticks (None: there are none) [s].
        length: Of the run (None: not known) [s].
        derived: Whether the model has the Jacobian of its right-hand side.
        input_functions: Whether inputs are functions of the user, of which no derivative is known.
        stiff: Whether stability has limited the steps of an explicit method.
        elements: Whether the model is one of elements in absolute coordinates.
        flexible: Whether some of them are beams or superelements, whose vibrations are stiff.
    """

    rtol: float
    period: float | None = None
    length: float | None = None
    derived: bool = True
    input_functions: bool = False
    stiff: bool = False
    elements: bool = False
    flexible: bool = False

    @property
    def hurried(self) -> bool:
        """True when samples or ticks cut the run into many short segments."""
        if self.period is None:
            return False
        return self.length is None or self.length > OFTEN * self.period


class Limited(Exception):
    """Stability limits the steps of an explicit method, not accuracy.

    Attributes:
        case: What the next choice is made from.
    """

    def __init__(self, case: Case) -> None:
        super().__init__(case)
        self.case = replace(case, stiff=True)


@dataclass(frozen=True)
class Rule:
    """A method, where it is the one to take, and why in words."""

    method: str
    holds: Callable[[Case], bool]
    why: str


# what masses that constraints hold, and constraints that explicit steps leave, may end in
BROKEN = ("model_failed", "not_closed", "step_too_small", "not_finite")
STIFF = "stability limited the steps of DOP853, not accuracy"
RULES: tuple[Rule, ...] = (
    Rule(
        "Radau",
        lambda case: case.elements and (case.flexible or case.stiff),
        "elements in absolute coordinates: stiff, with constraints, of order 5, solved with sparse "
        "matrices",
    ),
    Rule(
        "DOP853",
        lambda case: case.stiff and not case.derived,
        f"{STIFF}; Rosenbrock and Radau need '{JACOBIAN}': cd.compile(..., functions=[..., "
        f"'{JACOBIAN}'])",
    ),
    Rule(
        "Radau",
        lambda case: case.stiff and (case.input_functions or case.rtol < FINE),
        f"{STIFF}; Radau reaches many digits and rarely asks for slopes of f(t, x)",
    ),
    Rule(
        "Rosenbrock",
        lambda case: case.stiff,
        f"{STIFF}; Rosenbrock needs the least per step at this tolerance",
    ),
    Rule(
        "RK45",
        lambda case: case.hurried and case.rtol > FINE,
        "samples or ticks end its steps: short ones cost half of those of DOP853",
    ),
    Rule(
        "DOP853",
        lambda case: True,
        "the motion is not stiff so far; DOP853 then takes the fewest evaluations at any rtol",
    ),
)


def choose(case: Case) -> Rule:
    """The first rule that holds."""
    return next(rule for rule in RULES if rule.holds(case))


def abandoned(case: Case | None, method: str, status: str) -> bool:
    """True when a run of elements by an explicit method ended where an implicit one may go on."""
    explicit = case is not None and case.elements and method == "DOP853"
    return explicit and status in BROKEN


def limited(run: Any) -> bool:
    """True when stability limits the steps of a run.

    Args:
        run: Its record.
    """
    return bool(run.looked >= LOOKED and run.limited >= MOST * run.looked)


def reconsider(case: Case, runner: Any, over: Span, begin: Any) -> None:
    """Look whether stability limits the steps of a run that is under way.

    Args:
        case: What its method was chosen from.
        runner, over: The run and its span.
        begin: Its start (nx,).

    Raises:
        Limited: it does, and there is a method that need not mind.
    """
    if case.stiff or not (case.derived or case.elements):
        return
    # nothing tells the rates of elements but the steps themselves
    if limited(runner.record) or (case.derived and _outpaced(runner, over, begin)):
        raise Limited(case)


def _outpaced(runner: Any, over: Span, begin: Any) -> bool:
    """True when an implicit method would need far fewer steps than a run has taken.

    Vibrations at rest do not show in the steps themselves, which are as long as these allow, and
    explicit steps keep them at the tolerance: what the start says of the motion counts too.
    """
    run, model, r = runner.record, runner.model, runner.views["r"]
    done = abs(run.t - over.start) / over.length
    if run.steps < MANY or not done:
        return False
    try:
        here = stiffness(model, runner.views["y"][: model.nx], run.t, r, runner.views["s"])
        there = stiffness(model, begin, over.start, r, model._layout.start("s"))
    except SolveError:
        # beside one of the states there are no accelerations, and no rates to compare
        return False
    calm = replace(here, present=min(here.present, there.present))
    pays = calm.implicit_pays(over.length, runner.settings.rtol, run.steps / done)
    return pays and abs(run.h) * here.fastest > 1


def remark(method: str, run: Any, derived: bool) -> str:
    """Remark about a run whose steps were limited by stability, "" for others."""
    if not limited(run):
        return ""
    share = f"stability limited {100 * run.limited / run.looked:.0f} % of the steps of {method}, "
    cure = "method='Rosenbrock' or 'Radau' takes longer ones"
    if not derived:
        cure += f", with functions=[..., '{JACOBIAN}'] at compile"
    return f"{share}not accuracy: {cure}"
