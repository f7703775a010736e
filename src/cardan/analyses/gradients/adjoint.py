"""The sweep of ``kernels/sensitivity/adjoint.c`` backward over the steps of a run."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, final

import numpy as np

from ...arrays import Array
from ...runtime.models.loaded_model import LoadedModel
from ...schema.cost import Cost
from ...schema.records import Adjoint
from ...schema.request import Request
from ..simulation.run import Runner
from .steps import CLOSING, MOST_STAGES, StepsAgain, powers_at, segment_at


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
        s = 1 + model.nx
        r = s + model.ns
        p = r + model.nr
        return cls(float(flat[0]), flat[1:s], flat[s:r], flat[r:p], flat[p:])


@final
class Sweep(StepsAgain):
    """A sweep backward: the gradient by the last state becomes that by the first one.

    Attributes:
        lam: Gradient by the state (nx,), coordinates as they are stored.
        by_s: By the modes (ns,) since the last event, which hold numbers of sampled controllers.
        by_p: By the parameters (np,).
        by_r: By the inputs (nr,), as if they were constant.
        by_coefficients: Of every tabulated input: by its coefficients (segments, 4).
    """

    def __init__(self, runner: Runner, cost: Cost, parameters: bool) -> None:
        """Args:
        runner: What took the steps.
        cost: Whose gradient.
        parameters: Whether derivatives by parameters are asked for.
        """
        super().__init__(runner)
        model, record = runner.model, Adjoint()
        self.purpose = cost.running, parameters
        self.record, self.parameters = record, parameters and len(model.parameters) > 0
        self.lam, self.by_s, self.by_r = np.zeros(model.nx), np.zeros(model.ns), np.zeros(model.nr)
        self.by_p = np.zeros(len(model.parameters) if self.parameters else 0)
        coefficients = np.zeros((sum(self.segment_counts), 4))
        ends = np.cumsum(self.segment_counts)[:-1]
        self.by_coefficients = np.split(coefficients, ends) if len(coefficients) else []
        self._cost = np.zeros(1)
        # formula -> the cost at the end and its product, of the last one
        self._finals: dict[str, list[Callable[..., Array]]] = {}
        # what is added up
        self.totals = (self.lam, self.by_s, self.by_r, self.by_p, coefficients, self._cost)
        # gradients where growth is counted from and to, with their times
        self._since: tuple[float, Array] | None = None
        self._until = 0.0, self.lam
        # products backward, so that parameters cost nothing more
        closing = runner.closing
        keys: dict[str, tuple[str, str | None]] = {"rates": ("vjp", self.request("rhs"))}
        for name in closing.functions:
            if name in CLOSING:
                keys[name] = ("vjp", self.request(name))
        if cost.running is not None:
            keys["integrand"] = ("vjp", self.request("expression", cost.running))
            keys["integrand_value"] = ("expression", cost.running)
        self.call(record, dict(zip(keys, model._load(list(keys.values())), strict=True)))
        record.np = len(self.by_p)
        longest = model.nx + model.ns + model.nr + len(self.by_p)
        rooms = {
            "lam": self.lam, "by_p": self.by_p, "by_r": self.by_r, "by_s": self.by_s,
            "by_coefficients": coefficients, "cost": self._cost,
            "pulled": np.zeros(MOST_STAGES * model.nx), "out": np.zeros(longest),
            "weights": np.zeros(MOST_STAGES * model.nx),
            "v": np.zeros(model.nx + closing.positions + closing.rates + 1),
        }  # fmt: skip
        for name, room in rooms.items():
            setattr(record, name, self.pointer(room))

    @classmethod
    def of(cls, runner: Runner, cost: Cost, parameters: bool) -> Sweep:
        """A sweep as good as new: that which an earlier gradient has made with the same runner, if
        it is for the same.

        Args: as the sweep itself takes them.
        """
        last = runner.sweep
        if not isinstance(last, cls) or last.purpose != (cost.running, parameters):
            runner.sweep = sweep = cls(runner, cost, parameters)
            return sweep
        for total in last.totals:
            total.fill(0.0)
        last._since, last.largest = None, 0.0
        return last

    def request(self, function: str, of: str | None = None, time: bool = False) -> str:
        """Product with the derivative of a function along state, modes, inputs and parameters.

        Args:
            function, of: Which.
            time: Whether along the time too, before all others.
        """
        blocks = [*["t"] * time, *self.sizes(), *["p"] * self.parameters]
        return str(Request(function, of, tuple(blocks)))

    @property
    def cost(self) -> float:
        """Integral of the running cost over the steps so far."""
        return float(self._cost[0])

    def begin(self, formula: str, t: float, x: Array, s: Array) -> tuple[float, float]:
        """Begin with a cost at the end of a motion: its gradient by state and parameters.

        Returns:
            The cost, and its derivative by the time.
        """
        model = self.model
        q, u, z = model.parts_of(x)
        states = (t, q, u, self.inputs_at(t)[0], z, s)
        if formula not in self._finals:
            request = self.request("expression", formula, time=True)
            listed = model._load([("expression", formula), ("vjp", request)])
            self._finals = {formula: [function.fast for function in listed]}
        cost, product = self._finals[formula]
        slopes = Slopes.of(model, product(None, *states, np.ones(1)))
        self.lam[:], self.by_s[:] = slopes.by_x, slopes.by_s
        self.add_inputs(t, slopes.by_r)
        self.by_p += slopes.by_p
        return float(cost(None, *states)), slopes.by_t

    def add_inputs(self, t: float, by_r: Array) -> None:
        """Add a gradient by the inputs (nr,) at a time."""
        self.by_r += by_r
        for one, by_block in zip(self.runner.signals.tabulated, self.by_coefficients, strict=True):
            by_block[segment_at(one, t)[0]] += by_r[one.input] * powers_at(one, t)[0]

    def over(self, rows: Array) -> None:
        """Sweep over the steps between rows (count, width) as the run wrote them.

        Raises:
            SolveError: a function has no value at a stage of a step.
        """
        # growth counts from the last event on, over how many sweeps it may be
        if self._since is None:
            self._since = float(rows[-1, 0]), self.lam.copy()
        self.swept(rows, self.runner.library.cardan_adjoint_sweep, self.record)
        self._until = float(rows[0, 0]), self.lam.copy()

    def arrived(self) -> None:
        """An event or the start of the motion is reached: behind it growth counts anew.

        Raises:
            SolveError: derivatives have grown beyond all use.
        """
        if self._since is None:
            return
        (begin, before), (end, after) = self._since, self._until
        self._since = None
        self.check_growth(before, after, np.array([begin, end]))
