"""Measure every function of a model, and every integrator on a motion of it."""

from __future__ import annotations

import importlib.util
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from ....arguments import Inputs, checked
from ....errors import CompilerMissing, counted
from ....records import dataclass
from ....runtime.build import cache
from ....runtime.calls import abi, function_costs, webassembly
from ....runtime.calls.measuring import Row
from ....runtime.models.finite_elements import element_costs
from ....runtime.models.loaded_model import LoadedModel
from .runs import Show, precision
from .work_precision import PrecisionRecord

if TYPE_CHECKING:
    from rich.table import Table

SEED = 1  # of the states at which functions are measured


@dataclass(frozen=True)
class Report:
    """Cost and exactness of the functions of a model on this machine.

    Attributes:
        model: Its name.
        rows: One per function.
        compiler: What compiled them.
        way: How Python calls them: cython or ctypes.
        note: What rows mean; what could not be measured, and how to change that.
        methods: Speed against error of the integrators, where an end time was given.
    """

    model: str
    rows: tuple[Row, ...]
    compiler: str
    way: str
    note: str = ""
    methods: PrecisionRecord | None = None

    def __repr__(self) -> str:
        methods = f", {counted(len(self.methods.points), 'run')}" if self.methods else ""
        return f"Report('{self.model}': {counted(len(self.rows), 'function')}{methods})"

    def table(self) -> Table:
        """The report as a table for the terminal."""
        from rich.table import Table

        title = f"{self.model}: {self.compiler}, called through {self.way}"
        table = Table(title=title, caption=self.note or None)
        table.add_column("function", no_wrap=True, max_width=34)
        for name in ("ops", "from Python", "in C", "in a batch", "lanes", "error"):
            table.add_column(name, justify="right", no_wrap=True)
        for row in self.rows:
            times = map(_time_text, (row.python_ns, row.call_ns, row.state_ns))
            error = "-" if row.error is None else f"{row.error:.1e}"
            table.add_row(row.function, str(row.operations), *times, str(row.lanes), error)
        return table


def _time_text(ns: float) -> str:
    return "-" if math.isnan(ns) else f"{ns:.0f} ns"


@checked
def report(
    model: LoadedModel,
    t: float | ArrayLike | None = None,
    *,
    methods: Sequence[str] | None = None,
    patience: float = 5.0,
    show: Show | None = None,
    x0: ArrayLike | None = None,
    q: Any = None,
    u: Any = None,
    z: Any = None,
    inputs: Inputs | None = None,
    events: Mapping[str, object] | None = None,
) -> Report:
    """Measure every function: operations, time, error against 40 digits; prints a table.

    Args:
        model: The compiled model.
        t: With an end, or ``(start, end)`` [s], speed against error of every integrator too:
            ``report(10, q={"elbow": 1.0}).methods``.
        methods: Names of integrators; all by default.
        patience: Longest time for one run [s]; a method stops where it would take more.
        show: Called with what is being run and the fraction done.
        x0, q, u, z, inputs, events: Of the motion, as ``simulate`` takes them.

    Raises:
        ModelError: an unknown method or name. SolveError: no reference can be computed.
    """
    from rich.console import Console

    with_errors = importlib.util.find_spec("mpmath") is not None
    notes = [] if with_errors else ["errors need mpmath: pip install mpmath"]
    if model.manifest.absolute:
        notes.append("of elements, <kind>__<function>: one element")
    costs = element_costs.rows if model.manifest.absolute else function_costs.functions
    rows = costs(model, SEED, with_errors)
    functions = Report(model.name, tuple(rows), _compiler(), abi.NAME, "; ".join(notes))
    Console().print(functions.table())
    if t is None:
        return functions
    runs = precision(
        model, t, methods, patience, show, x0=x0, q=q, u=u, z=z, inputs=inputs, events=events
    )
    out = Console(markup=False)
    out.print(runs.table())
    out.print(runs.recommendation, soft_wrap=True)
    return replace(functions, methods=runs)


def _compiler() -> str:
    try:
        return cache.compiler().identity.splitlines()[0]
    except CompilerMissing:
        return webassembly.version() if webassembly.available() else "no C compiler, Python"
