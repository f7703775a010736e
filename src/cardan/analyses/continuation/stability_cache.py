"""How equilibria of a path stand: looked at once for each place, as cheaply as it can be told."""

from __future__ import annotations

from dataclasses import field
from typing import final

import numpy as np

from ...errors import SolveError
from ...records import dataclass
from ..linear.first_order import eigenvalues
from ..statics.stability_at_equilibrium import MANY, Stability, stand
from ..statics.static_problem import Problem
from ..systems.saddle_point import Singular
from .equilibria import Loaded
from .follow import Place


@final
@dataclass(eq=False)
class StabilityCache:
    """Stability of equilibria, kept.

    Attributes:
        problem: Of what.
    """

    problem: Problem
    _computed: dict[int, tuple[Loaded, Stability]] = field(default_factory=dict)
    _counts: dict[int, tuple[Loaded, int | None]] = field(default_factory=dict)

    def stability(self, at: Loaded) -> Stability:
        """The stability of an equilibrium."""
        key = id(at)
        if key not in self._computed:
            self._computed[key] = at, stand(self.problem, at.point, at.load)
        return self._computed[key][1]

    def count(self, place: Place) -> int | None:
        """Unstable directions with the load kept; None where they are not known."""
        at: Loaded = place.point
        if id(at) not in self._counts:
            many = len(self.problem.system.columns) > MANY
            count = place.below if many else None
            self._counts[id(at)] = at, self.stability(at).signed if count is None else count
        return self._counts[id(at)][1]

    def growth(self, place: Place) -> tuple[float, float]:
        """Real part and frequency [rad/s] of the oscillation that grows or decays least.

        Raises:
            SolveError: eigenvalues are not to be had.
        """
        at: Loaded = place.point
        system = self.problem.system
        if len(system.columns) > MANY:
            raise SolveError("too many speeds for all eigenvalues")
        locked = [system.place(name)[1] for name in at.load.locked]
        tau = self.problem.locked_forces(at.point, at.load)[1]
        try:
            values = eigenvalues(system, at.point.at, locked, tau)
        except Singular:
            values = None
        if values is None:
            raise SolveError("there are no eigenvalues")
        pairs = values[values.imag > 1e-6 * np.abs(values).max(initial=0.0)]
        if not len(pairs):
            raise SolveError("nothing oscillates")
        nearest = pairs[np.abs(pairs.real).argmin()]
        return float(nearest.real), float(nearest.imag)
