"""The equilibria of a load path, as a record."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from ..errors import ModelError, near
from ..runtime.conduct import FINISHED
from .equilibrium import DIRECT, Equilibrium
from .following import Crossing
from .loading import Loading
from .newton import rest
from .standing import stand
from .static_problem import Problem

Array = NDArray[np.float64]
CLOSE = 1e-14  # of the path: two places that are one
SHOWN = 12


@final
@dataclass(frozen=True, repr=False, eq=False)
class StaticPath:
    """Equilibria under loads that change; ``path["elbow"]`` is a history (n,) by name.

    ``path[k]`` is the equilibrium of row k; ``model.simulate(10, x0=path[-1])`` starts there.

    Attributes:
        loading: What was swept.
        s: Place of every row on the path, 0 to 1 (n,).
        rows: The equilibria (n,).
        status: ``"finished"``, or ``"singular"`` where the end was not reached.
        message: The same as a sentence.
        crossings: Where stability changed, in their order.
        values: What was swept, by name (n,).
    """

    loading: Loading
    s: Array
    rows: Sequence[Equilibrium]
    status: str
    message: str
    crossings: Sequence[Crossing] = ()
    values: Mapping[str, Array] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        way: Loading,
        rows: list[tuple[float, Equilibrium]],
        crossed: Sequence[Crossing],
        failure: str,
    ) -> StaticPath:
        """The record of a path that was followed."""
        s = np.array([place for place, _ in rows])
        values = {name: np.array([way.values(place)[name] for place in s]) for name in way.swept}
        status = "singular" if failure else FINISHED
        message = failure or "reached the end"
        return cls(way, s, tuple(e for _, e in rows), status, message, tuple(crossed), values)

    @property
    def success(self) -> bool:
        """Whether the end was reached."""
        return self.status == FINISHED

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def model(self) -> Any:
        """The model with the parameters of the last row."""
        return self.rows[-1].model

    @property
    def x(self) -> Array:
        """States (n, nx)."""
        return np.array([row.x for row in self.rows])

    @property
    def q(self) -> Array:
        """Coordinates (n, nq)."""
        return np.array([row.q for row in self.rows])

    @property
    def lam(self) -> Array:
        """Multipliers (n, m)."""
        return np.array([row.lam for row in self.rows])

    @property
    def iterations(self) -> NDArray[np.intp]:
        """Linear systems solved for every row (n,)."""
        return np.array([row.iterations for row in self.rows], dtype=np.intp)

    @property
    def negative(self) -> NDArray[np.intp]:
        """Directions in which every row is unstable (n,)."""
        return np.array([row.negative for row in self.rows], dtype=np.intp)

    @property
    def stable(self) -> list[bool | None]:
        """Whether every row is stable; None where that could not be told."""
        return [row.stable for row in self.rows]

    def __getitem__(self, name: str | int) -> Any:
        """The equilibrium of a row; or a history: swept, coordinate, multiplier, holding force.

        Raises:
            ModelError: no such history.
        """
        if isinstance(name, int | np.integer):
            return self.rows[name]
        if name in self.values and self.loading.kinds[name] != "hold":
            return self.values[name]
        first = self.rows[0]
        if name in first.named:
            return np.array([row.named[name] for row in self.rows])
        held = {f"{n}.holding": n for n in first.holding}
        if name in held:
            return np.array([row.holding[held[name]] for row in self.rows])
        known = [*self.values, *first.named, *held]
        raise ModelError(f"path['{name}']: there is no such history.{near(name, known)}")

    def reaction(self, joint: str) -> Array:
        """Wrench (n, 6) of parent on child at the child joint frame, in its axes."""
        return np.array([row.reaction(joint) for row in self.rows])

    def pose(self, frame: str) -> Array:
        """Transforms (n, 4, 4) from frame axes to ground axes."""
        return np.array([row.pose(frame) for row in self.rows])

    def critical(self) -> list[dict[str, float]]:
        """Swept values at which stability changes, by bisection."""
        return [self.loading.values(self._between(crossing)) for crossing in self.crossings]

    def _between(self, crossing: Crossing) -> float:
        """Where exactly stability changes."""
        problem, point = Problem(self.loading.system), crossing.before.point
        low, high = crossing.before.s, crossing.after.s
        while high - low > CLOSE:
            middle = 0.5 * (low + high)
            load = self.loading.at(middle)
            search = rest(problem, problem.under(point, load), load, DIRECT)
            if not search.converged:
                high = middle
                continue
            if stand(problem, search.point, load).side == crossing.before.side:
                low, point = middle, search.point
            else:
                high = middle
        return 0.5 * (low + high)

    def __repr__(self) -> str:
        first = self.rows[0]
        ends = ", ".join(f"{n} = {v[0]:.6g} ... {v[-1]:.6g}" for n, v in self.values.items())
        lines = [
            f"statics of '{first.model.name}', {ends}: {self.message}",
            f"  {len(self)} equilibria, {int(self.iterations.sum())} iterations",
        ]
        last = self.rows[-1]
        names = list(last.named)[: min(last.model.nq, SHOWN)]
        lines += [f"  {n} = {first.named[n]:.6g} ... {last.named[n]:.6g}" for n in names]
        for crossing in self.crossings:
            low, high = (self.loading.values(p.s) for p in (crossing.before, crossing.after))
            span = ", ".join(f"{n} = {low[n]:.6g} ... {high[n]:.6g}" for n in self.values)
            lines.append(f"  stability changes between {span}")
        return "\n".join(lines)

    def plot(self, path: Any = None, names: Sequence[str] | None = None) -> Any:
        """Histories over the first swept value as a Matplotlib figure, written to ``path``.

        Raises:
            ModelError: unknown names, or a path that is no picture file.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """
        from ..view.plot import asked, plot_over

        chosen = asked(names) if names is not None else [*self.rows[0].model.coordinates]
        label = next(iter(self.values))
        curves = {name: self[name] for name in chosen}
        return plot_over(self.rows[0].model.name, label, self.values[label], curves, path)
