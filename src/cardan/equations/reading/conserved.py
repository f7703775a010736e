"""Conserved quantities of a system: momenta and energy.

Candidates are the linear momentum, the angular momentum about the origin and about the center of
mass, and the momentum of every speed, dT/du. Their rates are expressions of the state and of the
accelerations; where a rate, or a combination of rates with constant numbers, vanishes at states
drawn by chance, it vanishes wherever the same expressions hold: they are analytic. (A force that
acts in a part of the states only may be missed.) The same is asked with other parameters and other
values of the inputs, which tells what belongs to the form of the equations from what belongs to
these numbers. Constraints and rolling are obeyed by the states that are drawn.

Source: E. Noether, Invariante Variationsprobleme, Nachr. Ges. Wiss. Goettingen (1918); for rolling:
Bloch, Krishnaprasad, Marsden and Murray, Nonholonomic mechanical systems with symmetry, Arch.
Rational Mech. Anal. 136 (1996).
"""

from __future__ import annotations

from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import DerivationError, near
from ...ir.arithmetic import Scalar
from ...ir.function import Function
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...processes import collector_paused
from ...records import dataclass
from ..functions import blocks
from ..functions.context import Context
from ..functions.functions import power
from ..functions.random_states import States, context_of, divisors, function_of
from ..kinematics.momenta import (
    ANGULAR,
    AXES,
    MOMENTUM,
    ZERO_RATE,
    Candidate,
    Observation,
    candidates,
    drawn_at,
    observed,
    watched,
)

if TYPE_CHECKING:
    import sympy

    from ..record import EquationRecord

# rounding of combinations, relative to their terms
DEPENDENT = 1e-7
INPUTS_STILL, AT_PARAMETERS = "while the inputs rest", "at these parameters"


@dataclass(frozen=True)
class Quantity:
    """A number that stays constant.

    Attributes:
        name: Such as ``"linear momentum along x"``, ``"momentum of psi"``, ``"energy"``.
        also: Other names of the same number.
        unit: Its unit.
        function: Its value over the blocks of the equations, one output ``value``.
        condition: "" where it holds whatever the parameters and inputs are.
    """

    name: str
    also: tuple[str, ...]
    unit: str
    function: Function
    condition: str = ""

    @cached_property
    def expression(self) -> sympy.Expr:
        """Its value as a SymPy expression.

        Raises:
            DerivationError: it is too long to write out.
        """
        from ...ir.forms.readable import TooLong, readable

        try:
            return readable(self.function)[0]
        except TooLong as problem:
            raise DerivationError(f"{self.name} is too long to write out") from problem

    def __str__(self) -> str:
        same = f" (= {', '.join(self.also)})" if self.also else ""
        return f"{self.name}{same} [{self.unit}]" + (
            f", {self.condition}" if self.condition else ""
        )


@dataclass(frozen=True)
class Conserved:
    """Conserved quantities, and the reasons why energy is not.

    Attributes:
        quantities: The conserved quantities; none is a linear combination of others.
        cyclic: Coordinates on which nothing depends: neither M, h, f nor the constraints.
        powers: Element -> ``"takes"``, ``"gives"`` or ``"takes and gives"`` energy, where
            anything does.
        count: States that were looked at; 0 where none could be found.
        residual: Largest rate that was taken for zero, relative to its terms.
        events: Whether events, such as impacts, interrupt the motion.
    """

    quantities: tuple[Quantity, ...]
    cyclic: tuple[str, ...] = ()
    powers: dict[str, str] = field(default_factory=dict)
    count: int = 0
    residual: float = 0.0
    events: bool = False

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the quantities."""
        return tuple(one.name for one in self.quantities)

    def __getitem__(self, name: str) -> Quantity:
        """A quantity by its name, or another name of it."""
        for one in self.quantities:
            if name == one.name or name in one.also:
                return one
        raise KeyError(f"'{name}' is not conserved.{near(name, self.names)}")

    def energy_statement(self) -> str:
        """One sentence on the energy."""
        if not self.count:
            return "no state was found in which the loops close, so that nothing can be said"
        if "energy" in self.names:
            condition = " between events" if self.events else ""
            return f"energy is conserved{condition}"
        if not self.powers:
            return "energy is not conserved: forces or constraints change with the time"
        who = ", ".join(f"'{name}' {does}" for name, does in self.powers.items())
        return f"energy is not conserved: {who} energy"

    def __str__(self) -> str:
        lines = [f"{len(self.quantities)} conserved quantities"]
        lines += [f"  {one}" for one in self.quantities]
        if "energy" not in self.names:
            lines.append(self.energy_statement())
        if self.cyclic:
            lines.append("nothing depends on: " + ", ".join(self.cyclic))
        if self.events and self.quantities:
            lines.append("between events: an impact may change them")
        return "\n".join(lines)


def conserved(equations: EquationRecord, seed: int = 3) -> Conserved:
    """Find the conserved quantities of a system at its default parameters and inputs.

    Args:
        equations: By whatever method.
        seed: Of the states that are drawn.
    """
    with collector_paused():
        return _searched(equations, np.random.default_rng(seed))


def _searched(equations: EquationRecord, rng: np.random.Generator) -> Conserved:
    system, c = equations.system, context_of(equations)
    momenta, energy = candidates(equations, c)
    every = [*momenta, energy]
    function = watched(equations, c, every)
    count = 2 * len(every) + 12
    states = drawn_at(equations, count, rng, blocks.defaults(system))
    observation = observed(function, states)
    if len(observation.values) <= len(every):
        return Conserved((), events=bool(system.events))
    constant = observation.constant
    chosen = _independent(observation.values, [k for k in constant if k < len(momenta)])
    also = _aliases(observation.values, chosen, [one.name for one in momenta])
    unit = np.eye(len(every))
    picked = [(unit[k], every[k].name, every[k].unit, also[k]) for k in chosen]
    picked += _combined(observation, momenta, chosen)
    if len(momenta) in constant:
        picked.append((unit[-1], energy.name, energy.unit, ()))
    elsewhere = _elsewhere(equations, function, rng, count)
    return Conserved(
        tuple(
            Quantity(
                name, same, of, _value(equations, c, every, weights), _when(weights, elsewhere)
            )
            for weights, name, of, same in picked
        ),
        _cyclic(equations, c, states, rng),
        {} if len(momenta) in constant else _powers(equations, c, states),
        len(observation.values),
        float(np.abs(observation.rates[:, constant]).max(initial=0.0)),
        bool(system.events),
    )


def _independent(values: Array, among: list[int]) -> list[int]:
    """Rows that are not zero and no linear combination of earlier ones.

    Where linear and angular momentum are all constant, that about the center of mass says no more.
    """
    chosen: list[int] = []
    for k in among:
        if len(chosen) == 6 and chosen == list(range(6)) and k >= values.shape[1] - 4:
            continue
        if _left(values, chosen, k) > DEPENDENT:
            chosen.append(k)
    return chosen


def _left(values: Array, chosen: list[int], k: int) -> float:
    """Part of a column that the others do not explain."""
    column = values[:, k]
    if not chosen:
        return float(np.abs(column).max(initial=0.0))
    residual = (
        column - values[:, chosen] @ np.linalg.lstsq(values[:, chosen], column, rcond=None)[0]
    )
    return float(np.abs(residual).max(initial=0.0))


def _aliases(values: Array, chosen: list[int], names: list[str]) -> dict[int, tuple[str, ...]]:
    """Other candidates that are the same number."""
    return {
        k: tuple(
            names[j]
            for j in range(len(names))
            if j not in chosen and np.abs(values[:, j]).max() > DEPENDENT
            if _left(values, [k], j) < DEPENDENT
        )
        for k in chosen
    }


def _combined(
    observation: Observation, momenta: list[Candidate], chosen: list[int]
) -> list[tuple[Array, str, str, tuple[str, ...]]]:
    """Combinations of linear momenta, and of angular ones, that are constant though none is."""
    combinations: list[tuple[Array, str, str, tuple[str, ...]]] = []
    for group, unit in ((range(3), MOMENTUM), (range(3, 6), ANGULAR)):
        free = [
            k for k in group if k not in chosen and _left(observation.values, [], k) > DEPENDENT
        ]
        if len(free) < 2 or len(_independent(observation.values, free)) < len(free):
            continue
        # all in the same unit
        scales = observation.scale[free] / observation.scale[free].max()
        for row in _null_rows(observation.rates[:, free] * scales):
            weights = np.zeros(len(observation.scale))
            weights[free] = row
            along = ", ".join(f"{weights[k]:.6g}" for k in group)
            name = momenta[group[0]].name.removesuffix(AXES[0])
            combinations.append((weights, f"{name}({along})", unit, ()))
    return combinations


def _null_rows(matrix: Array) -> list[Array]:
    """A basis of what a matrix takes to zero, with as many zeros as can be."""
    _, sizes, right = np.linalg.svd(matrix)
    rows = right[sizes < ZERO_RATE * np.sqrt(len(matrix))]
    for i in range(len(rows)):
        k = int(np.abs(rows[i]).argmax())
        rows[i] /= rows[i, k]
        for j in range(len(rows)):
            if j != i:
                rows[j] -= rows[j, k] * rows[i]
    rows[np.abs(rows) < DEPENDENT] = 0.0
    # a number such as 1/3 is one again
    return list(rows.round(12) + 0.0)


def _elsewhere(
    equations: EquationRecord, watched: Function, rng: np.random.Generator, count: int
) -> dict[str, Observation]:
    """The candidates at other inputs, and at other parameters."""
    defaults, observations = blocks.defaults(equations.system), {}
    if len(defaults["r"]):
        other = defaults | {"r": defaults["r"] + rng.normal(size=len(defaults["r"]))}
        observations[INPUTS_STILL] = observed(watched, drawn_at(equations, count, rng, other))
    other = defaults | {"p": defaults["p"] * (1.0 + 0.05 * rng.normal(size=len(defaults["p"])))}
    observations[AT_PARAMETERS] = observed(watched, drawn_at(equations, count, rng, other))
    return observations


def _when(weights: Array, elsewhere: dict[str, Observation]) -> str:
    """Condition of a quantity: where others make its rate differ from zero, or none is known."""
    conditions = []
    for condition, observation in elsewhere.items():
        rate = observation.rates @ (weights * observation.scale)
        size = np.abs(weights * observation.scale).max()
        if not len(rate) or np.abs(rate).max() > ZERO_RATE * size:
            conditions.append(condition)
    return " and ".join(conditions)


def _value(
    equations: EquationRecord, c: Context, every: list[Candidate], weights: Array
) -> Function:
    """A combination of candidates as a function."""
    total = Scalar(c.k.graph, ZERO)
    for one, weight in zip(every, weights, strict=True):
        if weight:
            total = total + (one.value if weight == 1.0 else one.value * float(weight))
    return function_of(equations, c, {"value": Matrix(c.k.graph, 1, 1, [total.node])})


def _cyclic(
    equations: EquationRecord, c: Context, states: States, rng: np.random.Generator
) -> tuple[str, ...]:
    """Coordinates that can be changed without a change of M, h, f, G, gamma or qdot."""
    system, d = equations.system, c.d
    named = {"M": d.mass_matrix, "h": d.bias(), "f": d.forces(), "qdot": c.k.rates}
    if system.closed:
        named |= {"G": d.constraints.jacobian, "gamma": d.constraints.gamma}
        named |= {"g": d.constraints.position}
    function = function_of(equations, c, named)
    before, cyclic = states.of(function), []
    # accelerations: rows of small bodies count as much as those of large ones
    weights = 1.0 / divisors(np.diagonal(before["M"], axis1=1, axis2=2))[..., np.newaxis]
    for k, (name, unit, _) in enumerate(blocks.coordinates(system)):
        if unit not in ("rad", "m"):
            continue
        q = states.values["q"].copy()
        q[:, k] += rng.normal(size=len(q))
        after = States(states.values | {"q": q}, states.count).of(function)
        if all(_same(before[n], after[n], weights if n in "Mhf" else 1.0) for n in before):
            cyclic.append(name)
    return tuple(cyclic)


def _same(a: Array, b: Array, weights: Array | float) -> bool:
    a, b = (np.nan_to_num(x * weights) for x in (a, b))
    size = 1.0 + np.abs(a).max(initial=0.0)
    return bool(np.abs(a - b).max(initial=0.0) < ZERO_RATE * size)


def _powers(equations: EquationRecord, c: Context, states: States) -> dict[str, str]:
    """Power of each source in the sampled states."""
    (output,) = power(c)
    values = Matrix(c.k.graph, len(output.nodes), 1, output.nodes)
    powers = np.nan_to_num(states.of(function_of(equations, c, {"power": values}))["power"][..., 0])
    does = {}
    for name, column in zip(output.entries, powers.T, strict=True):
        takes, gives = column.min(initial=0.0) < 0.0, column.max(initial=0.0) > 0.0
        if takes or gives:
            does[name] = "takes and gives" if takes and gives else "takes" if takes else "gives"
    return does
