"""The sweep of ``kernels/sensitivity/adjoint.c`` over the steps of a run."""

from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, final

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...errors import SolveError
from ...runtime.calls.loaded_function import LoadedFunction
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.input_history import PiecewiseInput
from ...schema.blocks import COORDINATES
from ...schema.records import Adjoint
from ...schema.request import Request
from ..simulation.run import Runner
from .cost import Cost

MOST_STAGES = 16
# what products are along, as far as a model has any of it
BLOCKS = (COORDINATES, "u", "z", "s", "r")
CLOSING = ("close_position", "close_velocity")


def request_of(
    model: LoadedModel, function: str, of: str | None, parameters: bool, time: bool = False
) -> str:
    """Product with the derivative of a function along state, inputs and, if so, parameters.

    Args:
        model: Whose function.
        function, of: Which.
        parameters: Whether along parameters too.
        time: Whether along the time too, before all others.
    """
    sizes = dict(zip(BLOCKS, (model.nq, model.nu, model.nz, model.ns, model.nr), strict=True))
    blocks = ["t"] * time + [block for block in BLOCKS if sizes[block]]
    if parameters and len(model.parameters):
        blocks.append("p")
    return str(Request(function, of, tuple(blocks)))


class Slopes(NamedTuple):
    """Weights times the derivative of a function, by the time, x, s, r and p."""

    by_t: float
    by_x: Array
    by_s: Array
    by_r: Array
    by_p: Array

    @classmethod
    def of(cls, model: LoadedModel, flat: Array) -> Slopes:
        """Parts of a product along the time and everything else."""
        ends = np.cumsum([1, model.nx, model.ns, model.nr])
        by_t, *parts = np.split(flat, ends)
        return cls(float(by_t[0]), *parts)


@final
class Sweep:
    """A sweep backward: the gradient by the last state becomes that by the first one.

    Attributes:
        lam: Gradient by the state (nx,), coordinates as they are stored.
        by_s: By the modes (ns,) since the last event, which hold numbers of sampled controllers.
        by_p: By the parameters (np,).
        by_r: By the inputs (nr,), as if they were constant.
        by_pieces: Of every input by pieces: by its coefficients (pieces, 4).
        cost: Integral of the running cost.
    """

    def __init__(self, runner: Runner, cost: Cost, parameters: bool) -> None:
        """Args:
        runner: What took the steps.
        cost: Whose gradient.
        parameters: Whether derivatives by parameters are wanted.
        """
        self.runner, self.model = runner, runner.model
        model = runner.model
        self._references: list[Any] = []
        self.lam, self.by_s, self.by_r = np.zeros(model.nx), np.zeros(model.ns), np.zeros(model.nr)
        self.by_p = np.zeros(len(model.parameters) if parameters else 0)
        pieces = [len(one.coefficients) for one in runner.signals.tabulated]
        self._pieces = np.zeros((sum(pieces), 4))
        self.by_pieces = np.split(self._pieces, np.cumsum(pieces)[:-1]) if pieces else []
        self._cost = np.zeros(1)
        record = self.record = Adjoint()
        record.run = ctypes.addressof(runner.record)
        names: dict[str, tuple[str, str | None]] = {"rates": ("rhs", None)}
        names |= {name: (name, None) for name in runner.closing.functions if name in CLOSING}
        if cost.running is not None:
            names["running"] = ("expression", cost.running)
        keys = {name: ("vjp", request_of(model, *key, parameters)) for name, key in names.items()}
        if cost.running is not None:
            keys["running_cost"] = ("expression", cost.running)
        functions = dict(zip(keys, model._load(list(keys.values())), strict=True))
        for name, function in functions.items():
            setattr(record, name, function.address)
            setattr(record, f"{name}_w", self._pointer(function.w))
        self._take_tableau()
        record.np = len(self.by_p)
        for name, array in (
            ("lam", self.lam), ("by_p", self.by_p), ("by_r", self.by_r), ("by_s", self.by_s),
            ("by_pieces", self._pieces), ("cost", self._cost),
        ):  # fmt: skip
            setattr(record, name, self._pointer(array))
        called: list[LoadedFunction] = [*functions.values(), runner.functions[0]]
        record.work = max(function.work_size for function in called)
        length = runner.library.cardan_adjoint_length(record, record.work)
        record.memory = self._pointer(np.zeros(length))

    @property
    def cost(self) -> float:
        """Integral of the running cost over the steps so far."""
        return float(self._cost[0])

    def begin(self, formula: str, t: float, x: Array, s: Array) -> tuple[float, float]:
        """Begin with a cost at the end of a motion: its gradient by state and parameters.

        Returns:
            The cost, and its derivative by the time.
        """
        model, parameters = self.model, bool(len(self.by_p))
        q, u, z = model.parts_of(x)
        inputs = self.inputs_at(t)[0]
        request = request_of(model, "expression", formula, parameters, time=True)
        cost, product = model._load([("expression", formula), ("vjp", request)])
        states = (t, q, u, inputs, z, s)
        flat = product.caller(None, *states, np.ones(1))
        slopes = Slopes.of(model, flat)
        self.lam[:], self.by_s[:] = slopes.by_x, slopes.by_s
        self.add_inputs(t, slopes.by_r)
        self.by_p += slopes.by_p
        return float(cost.caller(None, *states)), slopes.by_t

    def inputs_at(self, t: float) -> tuple[Array, Array]:
        """Inputs and their rates (nr,) at a time, as they are before it."""
        constants, rates = self.runner.signals.constants.copy(), np.zeros(self.model.nr)
        for one in self.runner.signals.tabulated:
            piece, d = _piece(one, t)
            c0, c1, c2, c3 = one.coefficients[piece]
            constants[one.input] = ((c3 * d + c2) * d + c1) * d + c0
            rates[one.input] = (3 * c3 * d + 2 * c2) * d + c1
        return constants, rates

    def add_inputs(self, t: float, by_r: Array) -> None:
        """Add a gradient by the inputs (nr,) at a time."""
        self.by_r += by_r
        for one, by_piece in zip(self.runner.signals.tabulated, self.by_pieces, strict=True):
            piece, d = _piece(one, t)
            by_piece[piece] += by_r[one.input] * d ** np.arange(4)

    def over(self, rows: Array) -> None:
        """Sweep over the steps between rows (count, width) as the run wrote them.

        Raises:
            SolveError: a function has no value at a stage of a step.
        """
        table = np.ascontiguousarray(rows)
        self.record.rows, self.record.count = table.ctypes.data, len(table)
        status = self.runner.library.cardan_adjoint_sweep(self.record)
        if status:
            at = float(table[self.record.failed, 0])
            raise SolveError(
                f"gradient: a derivative has no finite value within the step from t = {at:.6g} s"
            )

    def _take_tableau(self) -> None:
        kernel = self.runner.settings.method.kernel
        tableau = getattr(self.runner.library, f"cardan_{kernel}_tableau")
        tableau.restype = ctypes.c_ssize_t
        parts = [np.zeros(size) for size in (MOST_STAGES, MOST_STAGES, MOST_STAGES**2)]
        self.record.stages = tableau(*(ctypes.c_void_p(part.ctypes.data) for part in parts))
        for name, part in zip(("nodes", "weights", "matrix"), parts, strict=True):
            setattr(self.record, name, self._pointer(part))

    def _pointer(self, array: NDArray[Any]) -> int:
        """Address of an array that must live as long as this."""
        self._references.append(array)
        return array.ctypes.data


def _piece(signal: PiecewiseInput, t: float) -> tuple[int, float]:
    """Piece of an input before a time, and the time since it began."""
    piece = int(np.searchsorted(signal.breaks, t, side="left")) - 1
    piece = min(max(piece, 0), len(signal.coefficients) - 1)
    return piece, t - float(signal.breaks[piece])
