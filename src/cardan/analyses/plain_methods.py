"""The methods of runs without a compiler: SciPy's, and the classical one of fixed step."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import record as abi

if TYPE_CHECKING:
    from .plain import PlainRunner

Array = NDArray[np.float64]
LEAST = 2.3e-14  # SciPy takes no smaller rtol
FAR = 1e150
BENT = 0.3  # as in derivative.c


class Broken(Exception):
    """The run cannot go on.

    Attributes:
        answer: What the kernels would say.
    """

    def __init__(self, answer: int) -> None:
        super().__init__(answer)
        self.answer = answer


@dataclass(frozen=True)
class Step:
    """A step that succeeded.

    Attributes:
        t, y: Where it ends.
        spread: Its dense output (dense_rows, n), computed when asked for.
    """

    t: float
    y: Array
    spread: Callable[[], Array]


def rk4(runner: PlainRunner, stop: float) -> Iterator[Step]:
    """Steps of the classical Runge-Kutta method on a grid from here to a stop.

    Source: as of the record ``RK4``.
    """
    run, f = runner.record, runner.derivative
    begin, t, y, k = run.t, run.t, runner.views["y"].copy(), 0
    h = math.copysign(runner.settings.step, stop - begin)
    first = f(t, y)
    while t != stop:
        k += 1
        end = begin + k * h
        if (stop - end) / h < 1e-9:
            end = stop
        d = end - t
        second = f(t + d / 2, y + d / 2 * first)
        third = f(t + d / 2, y + d / 2 * second)
        fourth = f(end, y + d * third)
        new = y + d / 6 * (first + 2 * (second + third) + fourth)
        runner.closer.close(end, new, noted=True)
        if run.correction > runner.passer.hold.bearable():
            raise Broken(abi.OPEN)
        last = f(end, new)
        _check_rotations(runner, new - y - d / 2 * (first + last))

        def spread(
            y: Array = y, new: Array = new, a: Array = d * first, b: Array = d * last
        ) -> Array:
            rise = new - y
            return np.stack([rise, a - rise, 2 * rise - a - b])

        yield Step(end, new, spread)
        t, y, first = end, new, last


def _check_rotations(runner: PlainRunner, bent: Array) -> None:
    """Whether a step follows coordinates of rotations: what ``cardan_follows`` does.

    Raises:
        Broken: it does not.
    """
    for k in runner.bounded:
        if not abs(bent[k]) <= BENT:
            runner.record.culprit = k
            raise Broken(abi.WHIRLED)


def dop853(runner: PlainRunner, stop: float) -> Iterator[Step]:
    """Steps of SciPy's DOP853."""
    from scipy.integrate import DOP853

    return adaptive(DOP853, runner, stop, lambda solver: np.array(solver.dense_output().F))


def rk45(runner: PlainRunner, stop: float) -> Iterator[Step]:
    """Steps of SciPy's RK45."""
    from scipy.integrate import RK45

    return adaptive(RK45, runner, stop, _quartic)


def radau(runner: PlainRunner, stop: float) -> Iterator[Step]:
    """Steps of SciPy's Radau, with the Jacobian of the model."""
    from scipy.integrate import Radau

    run, tried = runner.record, _tried(runner)

    def right(t: float, y: Array) -> Array:
        # as the Jacobian takes quaternions
        own = y.copy()
        runner.normalize(own)
        # a step to where there is no derivative is one that goes much too far
        return np.nan_to_num(tried(t, own), nan=FAR, posinf=FAR, neginf=-FAR)

    def jacobian(t: float, y: Array, *_: Any) -> Array:
        run.jacobians += 1
        nx, function = runner.nx, runner.model._function("rhs_jacobian")
        numbers = np.empty(nx * (nx + 1 + run.nr))
        runner.at(t, y)
        runner.call(function, t, y, numbers)
        if not np.isfinite(numbers).all():
            raise Broken(abi.NOT_FINITE)
        # nothing depends on energies
        found = np.zeros((runner.n, runner.n))
        found[:nx, :nx] = numbers[: nx * nx].reshape(nx, nx)
        return found

    def spread(solver: Any) -> Array:
        first, second, third = solver.dense_output().Q.T
        return np.stack([first + second + third, -second - third, -third])

    # SciPy takes differences itself
    derived = "rhs_jacobian" in runner.settings.method.needs
    return adaptive(Radau, runner, stop, spread, right, jac=jacobian if derived else None)


def _tried(runner: PlainRunner) -> Callable[[float, Array], Array]:
    """The derivative of the run, NaN where a function has no result: the step was too long."""

    def right(t: float, y: Array) -> Array:
        runner.record.model_status = 0
        try:
            return runner.derivative(t, y)
        except Broken as broken:
            if broken.answer != abi.MODEL:
                raise
            return np.full(runner.n, math.nan)

    return right


def _quartic(solver: Any) -> Array:
    """Rows of the dense output of RK45: values and slopes at both ends, then the fourth power."""
    dense = solver.dense_output()
    h, q = dense.h, dense.Q
    rise = solver.y - dense.y_old
    first, last = h * q[:, 0], h * (q @ np.arange(1.0, 5.0))
    return np.stack([rise, first - rise, 2 * rise - first - last, h * q[:, 3]])


def adaptive(
    kind: Any,
    runner: PlainRunner,
    stop: float,
    spread: Callable[[Any], Array],
    right: Callable[[float, Array], Array] | None = None,
    **more: Any,
) -> Iterator[Step]:
    """Steps of an adaptive method of SciPy from here to a stop.

    Args:
        kind: The method.
        runner, stop: As of every method.
        spread: Its dense output in the rows that are kept.
        right: Right-hand side in place of the derivative of the run.
        more: Other arguments of the method.

    The energies of the sources take no part in the error control: their tolerance is infinite,
    and the mean over all entries is made one over the state.
    """
    run, how = runner.record, runner.settings
    share = math.sqrt(max(runner.nx, 1) / runner.n) if runner.n else 1.0
    atol = np.full(runner.n, how.atol * share)
    atol[runner.nx :] = math.inf
    wanted = abs(run.h)
    length = abs(stop - run.t)
    solver = kind(
        right or _tried(runner),
        run.t,
        runner.views["y"].copy(),
        stop,
        max_step=how.max_step,
        rtol=max(how.rtol * share, LEAST) if how.rtol else LEAST,
        atol=atol,
        first_step=min(wanted, length) if wanted else None,
        **more,
    )
    closed = runner.quaternions or runner.closing.rows
    while solver.status == "running":
        spent, factored, before = solver.nfev, solver.nlu, (solver.t, solver.y, solver.f)
        solver.max_step = min(how.max_step, runner.passer.limit)
        solver.step()
        if solver.status == "failed":
            raise Broken(abi.MODEL if run.model_status else abi.TOO_SMALL)
        if hasattr(kind, "n_stages"):
            run.rejections += max(0, (solver.nfev - spent) // kind.n_stages - 1)
        # of two systems each time
        run.factorizations += (solver.nlu - factored) // 2
        if closed and not _closed(runner, solver):
            # again from before, shorter
            solver.LU_real = solver.LU_complex = None
            solver.h_abs = 0.25 * abs(solver.t - before[0])
            (solver.t, solver.y, solver.f), solver.status = before, "running"
            run.rejections += 1
            if solver.h_abs < 16 * np.spacing(max(abs(solver.t), abs(stop))):
                raise Broken(abi.OPEN)
            continue
        # a step cut at the stop does not shrink the next one
        wanted = max(wanted, solver.h_abs) if solver.t == stop else solver.h_abs
        run.h = math.copysign(wanted, solver.direction)
        if closed:
            solver.f = runner.derivative(solver.t, solver.y)
        yield Step(solver.t, solver.y.copy(), lambda: spread(solver))


def _closed(runner: PlainRunner, solver: Any) -> bool:
    """Whether the end of a step can be projected by less than the tolerance; it is then."""
    try:
        runner.closer.close(solver.t, solver.y, noted=True)
    except Broken as broken:
        if broken.answer != abi.OPEN:
            raise
        return False
    return runner.record.correction <= runner.passer.hold.bearable()


METHODS: dict[str, Callable[[PlainRunner, float], Iterator[Step]]] = {
    "DOP853": dop853,
    "RK45": rk45,
    "RK4": rk4,
    "Radau": radau,
}
