"""The cost of a reduction: coordinates that are left, frequencies that are lost, and errors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ..errors import SolveError, counted
from ..records import dataclass

if TYPE_CHECKING:
    from .record import SuperelementRecord
    from .response import ReducedModes

MAX_PRINTED = 6


@dataclass(frozen=True, eq=False)
class ReductionCost:
    """The cost of a reduction.

    Attributes:
        method: Of the reduction.
        rows: Of the matrices before it.
        boundary, modal: Coordinates after it: motions of interfaces, modes.
        highest: Frequency of the highest mode that was chosen [rad/s]; NaN without modes.
        dropped: Frequency of the first mode that was left out [rad/s]; NaN where all are kept.
        modes: Frequencies with error bounds, all interfaces free (``""``) and with one of them
            fixed; up to ``highest``, or all without modes.
    """

    method: str
    rows: int
    boundary: int
    modal: int
    highest: float
    dropped: float
    modes: Mapping[str, ReducedModes]

    def __repr__(self) -> str:
        after = self.boundary + self.modal
        lines = [
            f"{self.method}: {counted(self.rows, 'coordinate')} before, {after} after "
            f"({self.boundary} of interfaces, {self.modal} modal)"
        ]
        if not np.isnan(self.highest):
            lines.append(f"  modes up to        {self.highest:.6g} rad/s are chosen")
        if not np.isnan(self.dropped):
            ratio = self.dropped / self.highest
            beyond = "" if np.isnan(ratio) else f", {ratio:.3g} times the highest that is chosen"
            lines.append(f"  first left out at  {self.dropped:.6g} rad/s{beyond}")
        for name, modes in self.modes.items():
            lines.append(f"  {f'{name} fixed' if name else 'free'}")
            lines.append("    frequency [rad/s]  relative error about        at most")
            lines += [
                f"    {modes.frequencies[k]:>17.9g} {modes.estimates[k]:>21.1e} "
                f"{modes.bounds[k]:>14.1e}"
                for k in range(min(len(modes.frequencies), MAX_PRINTED))
                if not modes.frequencies[k] > self.highest
            ]
        return "\n".join(lines)


def cost(record: SuperelementRecord) -> ReductionCost:
    """The cost of the reduction of a component."""
    highest = float(record.frequencies.max()) if len(record.frequencies) else np.nan
    modes = {}
    for name in ("", *(frame.name for frame in record.interfaces)):
        try:
            modes[name] = record.modes([name] if name else ())
        except SolveError:
            # as matrices from files may be: no frequencies where nothing is fixed
            continue
    return ReductionCost(
        method=record.method,
        rows=len(record.dofs),
        boundary=record.n_boundary,
        modal=record.n - record.n_boundary,
        highest=highest,
        dropped=float(record.dropped[0]) if len(record.dropped) else np.nan,
        modes=modes,
    )
