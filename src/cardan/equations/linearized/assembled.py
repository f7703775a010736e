"""Coordinates that close loops, next to those from which one starts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...errors import DerivationError
from ...ir.derivative import forward
from ...ir.function import Function, Output
from ...ir.graph import ONE
from ...ir.interpreter import evaluate
from ...ir.matrix import Matrix
from .reference_input import NOMINAL, substituted

if TYPE_CHECKING:
    from .reference import Reference

STARTS, STEPS, LONGEST, CLOSED = 12, 60, 0.3, 1e-9
ROUNDING = 1e-14


class Assembly:
    """Newton's method towards closed loops, some coordinates held.

    Attributes:
        solution: The coordinates at the default parameters (nq,).
        moved: Those that are not where they started.
    """

    def __init__(self, reference: Reference, locked: Sequence[int]) -> None:
        self.locked, k, g = list(locked), reference.k, reference.graph
        constraints = reference.d.constraints
        nu = self._speeds = reference.system.nu
        jacobian = constraints.jacobian.block(slice(0, constraints.positions))
        columns = [forward(g, k.rates.nodes, {g.var("u", n): ONE}) for n in range(nu)]
        moves = Matrix(g, nu, reference.system.nq, [x for c in columns for x in c]).T
        still = {leaf: node for leaf, node in reference.values.items() if g.nodes[leaf][1] != "q"}
        outputs = []
        for name, x in (("g", constraints.position), ("G", jacobian), ("N", moves)):
            nodes = substituted(g, x.nodes, still)
            outputs.append(Output(name, (x.rows, x.columns), tuple(nodes)))
        places = [b for b in reference.equations.blocks.values() if b.name == "q"]
        inputs = (*reference.inputs, *places)
        self._function = Function("closing", g, inputs, tuple(outputs))
        self._step = reference.equations.function("integrate")
        self._base_values: dict[str, Any] = reference.tried()
        start = [g.var("q", n) for n in range(reference.system.nq)]
        q0 = Matrix(g, len(start), 1, [reference.values[x] for x in start])
        self._start = reference.number(q0)[:, 0]
        self._fixed = q0
        self._count = len(reference.symbols.names)
        self.solution = self._first(self._start)
        away = np.abs(self.solution - self._start) > 1e-12
        self.moved = [n for n in range(len(away)) if away[n] and n not in self.locked]
        self.names = [reference.names["q"][n] for n in self.moved]

    def at(self, p: Array, symbols: Array) -> Array:
        """The coordinates (nq,) at other parameters and values of symbols, those of others last.

        Raises:
            DerivationError: the loops do not close.
        """
        values = {**self._base_values, "p": p, NOMINAL: symbols[: self._count]}
        output = Output("q", (len(self._start),), self._fixed.nodes)
        places = evaluate(replace(self._function, outputs=(output,)), values)["q"]
        start = np.array([float(x) for x in places])
        start[self.moved] = self.solution[self.moved]
        return self._followed(values, start)

    def _first(self, start: Array) -> Array:
        """From the start itself, or from places around it."""
        offsets = np.random.default_rng(1).normal(0.0, 1.0, (STARTS, self._speeds))
        for n, du in enumerate(offsets):
            q = start
            if n:
                moved = evaluate(
                    self._step, {**self._base_values, "q": start.tolist(), "du": du.tolist()}
                )
                q = np.array([float(x) for x in moved["q"]])
                q[self.locked] = start[self.locked]
            try:
                return self._followed(self._base_values, q)
            except DerivationError as problem:
                last = problem
        raise last

    def _followed(self, values: dict[str, Any], start: Array) -> Array:
        q, last = np.array(start), np.inf
        for _ in range(STEPS):
            g, G, N = self._values({**values, "q": q})
            gap = float(np.abs(g).max(initial=0.0))
            if gap <= ROUNDING or (gap <= CLOSED and gap > 0.5 * last):
                break
            last = gap
            rows = np.concatenate([G, N[self.locked]])
            right = np.concatenate([-g[:, 0], np.zeros(len(self.locked))])
            du = np.linalg.lstsq(rows, right, rcond=1e-9)[0]
            du *= min(1.0, LONGEST / max(float(np.abs(du).max(initial=0.0)), LONGEST))
            moved = evaluate(self._step, {**values, "q": q.tolist(), "du": du.tolist()})
            q = np.array([float(x) for x in moved["q"]])
        if not last <= CLOSED and not gap <= CLOSED:
            raise DerivationError(
                f"linearize: the loops stay open by {gap:.2g} with the given coordinates; "
                "leave some out, or start nearer by q0"
            )
        return q

    def _values(self, values: dict[str, Any]) -> list[Array]:
        results = evaluate(self._function, values)
        return [
            np.array([float(x) for x in results[o.name]]).reshape(o.shape)
            for o in self._function.outputs
        ]
