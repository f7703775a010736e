"""Steps of a run computed again, as sweeps over them need: ``kernels/sensitivity/steps.c``."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence

import numpy as np
from numpy.polynomial.legendre import leggauss, legint, legval, legvander

from ...arrays import Array
from ...errors import SolveError
from ...runtime.calls.loaded_function import LoadedFunction
from ...runtime.trajectory.input_history import PiecewiseInput
from ...schema.blocks import COORDINATES
from ...schema.records import Steps
from ..simulation import run_record as abi
from ..simulation.run import Runner

# what derivatives are along, as far as a model has any of it
BLOCKS = (COORDINATES, "u", "z", "s", "r")
CLOSING = ("close_position", "close_velocity")
MOST_STAGES = 16
# of derivatives within a motion: no digit of such a motion is known
LARGE = 1e40  # no derivative in any unit
GROWTH = 1e12
# kernels whose steps are a table of coefficients; between the rows of others steps of Radau lead
TABLES = ("rk4", "rk45", "dop853", "radau")


class StepsAgain:
    """Steps of a run that is over.

    Attributes:
        runner: What took them.
        model: Its model.
        steps: Their record.
        largest: Size of the largest derivatives so far.
    """

    def __init__(self, runner: Runner) -> None:
        self.runner, self.model = runner, runner.model
        self._references: list[Array] = []
        self.largest = 0.0
        steps = self.steps = Steps()
        steps.run = ctypes.addressof(runner.record)
        kernel = runner.settings.method.kernel
        kernel = kernel if kernel in TABLES else "radau"
        tableau = getattr(runner.library, f"cardan_{kernel}_tableau")
        tableau.restype = ctypes.c_ssize_t
        tables = [np.zeros(size) for size in (MOST_STAGES, MOST_STAGES, MOST_STAGES**2)]
        steps.stages = tableau(*(ctypes.c_void_p(table.ctypes.data) for table in tables))
        nx = self.model.nx
        rooms = dict(zip(("nodes", "weights", "matrix"), tables, strict=True))
        rooms |= {name: np.zeros(MOST_STAGES * nx) for name in ("states", "slopes", "open")}
        rooms |= {"end": np.zeros(nx), "place": np.zeros(nx)}
        square = tables[2][: steps.stages**2].reshape(steps.stages, steps.stages)
        steps.kind = int(np.triu(square).any())  # CARDAN_EXPLICIT or CARDAN_COUPLED
        if steps.kind:
            steps.coupled = abi.address(runner.library, "cardan_coupled_stages")
            length = runner.library.cardan_stages_length(runner.record, steps.stages)
            rooms["system"] = np.zeros(length)
            rooms["lengths"] = np.zeros(MOST_STAGES * len(self.model.manifest.quaternions) + 1)
        self.rooms = rooms
        for name, room in rooms.items():
            setattr(steps, name, self.pointer(room))

    def pointer(self, array: Array) -> int:
        """Address of an array that must live as long as this."""
        self._references.append(array)
        return array.ctypes.data

    def sizes(self) -> dict[str, int]:
        """Number of columns along every block that the model has."""
        model = self.model
        numbers = (model.nq, model.nu, model.nz, model.ns, model.nr)
        return {name: n for name, n in zip(BLOCKS, numbers, strict=True) if n}

    def call(self, record: ctypes.Structure, functions: dict[str, LoadedFunction]) -> None:
        """Let a record call functions, by the names of its fields."""
        listed = [(record, name, function) for name, function in functions.items()]
        if self.steps.kind and not self.model.manifest.absolute:
            listed.append((self.steps, "jacobian", self.model._function("rhs_jacobian")))
        for owner, name, function in listed:
            setattr(owner, name, function.address)
            setattr(owner, f"{name}_w", self.pointer(function.w))
        self._share_factors(functions)
        # one room serves all of them, one after the other
        called = [self.runner.functions[0], *(function for _, _, function in listed)]
        room = np.zeros(max(function.work_size for function in called) + 1)
        self.steps.work = self.pointer(room)

    def _share_factors(self, functions: dict[str, LoadedFunction]) -> None:
        """Let products at one state of elements share what is factored there."""
        library, products = self.runner.library, [*functions.values()]
        compiled = not any(function.interpreted for function in products)
        if not (self.model.manifest.absolute and compiled):
            return
        room_length = library.cardan_mesh_room_length
        room_length.restype = ctypes.c_ssize_t
        # values of a cost are no products
        closing = [functions[name] for name in ("rates", *CLOSING) if name in functions]
        length = max(room_length(ctypes.c_void_p(one.w.ctypes.data)) for one in closing)
        self.steps.repeated = abi.address(library, "cardan_mesh_repeated")
        self.steps.factored_length = length
        self.steps.factored = self.pointer(np.zeros(MOST_STAGES * length))

    def swept(self, rows: Array, sweep: Callable[..., int], record: ctypes.Structure) -> None:
        """Sweep over the steps between rows (count, width) as the run wrote them.

        Raises:
            SolveError: a function has no value at a stage of a step, or stages cannot be found.
        """
        table = np.ascontiguousarray(rows)
        self.steps.rows, self.steps.count = table.ctypes.data, len(table)
        record.steps = ctypes.addressof(self.steps)
        status = sweep(record)
        if status:
            at = f"the step from t = {float(table[self.steps.failed, 0]):.6g} s"
            why = f"a derivative has no finite value within {at}"
            if status == abi.CONSTRAINT_OPEN:
                why = (
                    f"{at} leads over a place where branches meet, and an event lies in it or "
                    "stages do not settle. Change the start or the parameters a little"
                )
            elif status == abi.UNSOLVED:
                why = f"stages of {at} do not settle. Take a smaller rtol"
            raise SolveError(f"gradient: {why}")

    def check_growth(self, before: Array, after: Array, span: Array) -> None:
        """Refuse derivatives that have grown beyond all use.

        Args:
            before, after: Derivatives where a sweep began and where it ended.
            span: Times of the steps between.

        Raises:
            SolveError: with the cure.
        """
        size, last = (float(np.abs(one).max(initial=0.0)) for one in (before, after))
        # what an event has left of larger ones may be rounding
        self.largest = max(self.largest, size)
        if size < self.largest / GROWTH:
            size = self.largest
        self.largest = max(self.largest, last)
        # what begins with nothing has no size yet, and a unit of its own
        growth = last / (size or LARGE)
        if not growth <= GROWTH:
            raise SolveError(
                f"gradient: derivatives grow by {growth:.0e} between t = {span.min():.6g} and "
                f"{span.max():.6g} s. The steps are too long for a stiff force, such as friction "
                "that is smoothed, or the motion is chaotic. Take method='Radau', or a shorter time"
            )

    def pass_at(self, t: float) -> tuple[float, float, int] | None:
        """Start, length and points of the step over a place where branches meet that holds t."""
        for start, length, points in self.runner.passes[: self.runner.record.pass_count]:
            if 0 < (t - start) / length < 1:
                return float(start), float(length), int(points)
        return None

    def state_within(self, at: tuple[float, float, int], t: float, start: Array) -> Array:
        """State (nx,) within such a step that was just swept over, from that at its start."""
        begin, length, points = at
        nodes = leggauss(points)[0]
        slopes = self.rooms["slopes"][: points * len(start)].reshape(points, len(start))
        rising = legint(np.linalg.solve(legvander(nodes, points - 1), slopes), lbnd=-1)
        result: Array = start + length / 2 * legval(2 * (t - begin) / length - 1, rising)
        return result

    def inputs_at(self, t: float) -> tuple[Array, Array]:
        """Inputs and their rates (nr,) at a time, as they are before it."""
        constants, rates = self.runner.signals.constants.copy(), np.zeros(self.model.nr)
        for one in self.runner.signals.tabulated:
            powers, slopes = powers_at(one, t)
            segment = segment_at(one, t)[0]
            constants[one.input] = float(one.coefficients[segment] @ powers)
            rates[one.input] = float(one.coefficients[segment] @ slopes)
        return constants, rates

    @property
    def segment_counts(self) -> Sequence[int]:
        """Numbers of pieces of the inputs that are tabulated."""
        return [len(one.coefficients) for one in self.runner.signals.tabulated]


def segment_at(signal: PiecewiseInput, t: float) -> tuple[int, float]:
    """Piece of an input before a time, and the time since it began."""
    segment = int(np.searchsorted(signal.breaks, t, side="left")) - 1
    segment = min(max(segment, 0), len(signal.coefficients) - 1)
    return segment, t - float(signal.breaks[segment])


def powers_at(signal: PiecewiseInput, t: float) -> tuple[Array, Array]:
    """Derivatives (4,) of an input and of its rate at a time by its coefficients there."""
    d = segment_at(signal, t)[1]
    return np.array([1.0, d, d * d, d * d * d]), np.array([0.0, 1.0, 2 * d, 3 * d * d])
