"""What a hard case states about itself, and how it is measured."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import cardan as cd
from cardan.schema.integrators import INTEGRATORS

FINISHED = "finished"


@dataclass(frozen=True)
class Cell:
    """What one method must do with a case.

    Attributes:
        bound: Of the error, in the measure of the case.
        how: Tolerances or step, where others than those of the case.
        status: How the run ends.
    """

    bound: float
    how: Mapping[str, Any] = field(default_factory=dict)
    status: str = FINISHED


@dataclass(frozen=True)
class Never:
    """A method that is not applicable, and why in words."""

    reason: str


UNDAMPED = Never("it has no numerical damping, which constraints require")
Table = Mapping[str, Cell | Never]


@dataclass(frozen=True)
class Case:
    """A scene that is hard for some reason, with an oracle.

    Attributes:
        name: In test output and in the page.
        hard: What is hard, in a sentence.
        oracle: What the error is measured by, and its unit.
        advice: What to do about such a model.
        build: Makes the scene.
        t: As ``simulate`` takes it.
        start: Initial values, as ``simulate`` takes them.
        error: Of a motion.
        expected: Method -> what it must do: all integrators.
        fine: Tolerances of methods of order 4 and more.
        coarse: Of those of order 2.
        step: Of those with a fixed step [s].
        options: For compile.
        quick: Whether some of its cells are in every run of the tests.
        slow: Methods that take long: measured where the page is made, and by tests with
            CARDAN_HARD=1.
    """

    name: str
    hard: str
    oracle: str
    advice: str
    build: Callable[[], cd.Scene]
    t: Any
    start: Mapping[str, Any]
    error: Callable[[cd.CompiledModel, cd.Trajectory], float]
    expected: Table
    fine: Mapping[str, Any] = field(default_factory=lambda: {"rtol": 1e-9, "atol": 1e-11})
    coarse: Mapping[str, Any] = field(default_factory=lambda: {"rtol": 1e-6, "atol": 1e-8})
    step: float = 1e-3
    options: Mapping[str, Any] = field(default_factory=dict)
    quick: bool = True
    slow: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return self.name

    @property
    def title(self) -> str:
        """The name as a headline."""
        return self.name[0].upper() + self.name[1:]

    def how(self, method: str) -> dict[str, Any]:
        """Tolerances or step of a method."""
        own = self.expected[method]
        if isinstance(own, Cell) and own.how:
            return dict(own.how)
        if not INTEGRATORS[method].adaptive:
            return {"step": self.step}
        return dict(self.coarse if kind(method) == "damped" else self.fine)


@dataclass(frozen=True)
class Outcome:
    """What was measured: status, message, error, steps and time [ms]."""

    status: str
    message: str
    error: float
    steps: int
    milliseconds: float

    def meets(self, cell: Cell) -> bool:
        """Whether it is as it must be."""
        return self.status == cell.status and self.error <= cell.bound


@cache
def compiled(build: Callable[[], cd.Scene], options: tuple[tuple[str, Any], ...]) -> Any:
    """The model of a scene, compiled once."""
    return cd.compile(build(), **dict(options))


def measure(case: Case, method: str) -> Outcome:
    """Run a method on a case."""
    model = compiled(case.build, tuple(case.options.items()))
    with warnings.catch_warnings():
        # how a run ends is what is asked here
        warnings.simplefilter("ignore", cd.SolveWarning)
        motion = model.simulate(case.t, method=method, **case.start, **case.how(method))
    error = float(case.error(model, motion))
    found = motion.statistics
    return Outcome(
        motion.status,
        motion.message,
        error if math.isfinite(error) else math.inf,
        int(found["steps"]),
        found["milliseconds"],
    )


# those that take any scene
METHODS = [name for name, method in INTEGRATORS.items() if not method.elements]


def table(bounds: Mapping[str, float | Cell | Never]) -> Table:
    """A table of bounds as cells; every integrator must be in it."""
    missing = set(METHODS) ^ set(bounds)
    if missing:
        raise ValueError(f"say what is expected of {', '.join(sorted(missing))}")
    return {k: Cell(v) if isinstance(v, int | float) else v for k, v in bounds.items()}


def alike(
    explicit: float, lower: float, implicit: float, damped: float, fixed: float, energy: float,
    **others: Cell | Never | float,
) -> Table:  # fmt: skip
    """Bounds by kind of method.

    Args:
        explicit: DOP853, RKMK853. lower: RK45, RKMK45. implicit: Radau, Rosenbrock.
        damped: GeneralizedAlpha, HHT, Newmark. fixed: RK4, RKMK4. energy: EnergyMidpoint.
        others: Methods with a cell of their own.
    """
    bounds = {
        "explicit": explicit, "lower": lower, "implicit": implicit, "damped": damped,
        "fixed": fixed, "energy": energy,
    }  # fmt: skip
    return table({name: bounds[kind(name)] for name in METHODS} | others)


def kind(name: str) -> str:
    """Which bound of :func:`alike` is for a method, by its record."""
    method = INTEGRATORS[name]
    if method.multipliers:
        return "damped"
    if "energy" in method.needs:
        return "energy"
    if "rhs_jacobian" in method.needs:
        return "implicit"
    if not method.adaptive:
        return "fixed"
    return "explicit" if method.order > 5 else "lower"


DAMPED = tuple(name for name in METHODS if kind(name) == "damped")
