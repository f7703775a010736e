"""Coordinates that close circuits, next to those from which one starts."""

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
    """Newton's method towards closed circuits, some coordinates held.

    Attributes:
        found: The coordinates at the default parameters (nq,).
        moved: Those that are not where they started.
    """

    def __init__(self, reference: Reference, held: Sequence[int]) -> None:
        self.held, k, g = list(held), reference.k, reference.graph
        own = reference.d.constraints
        nu = self._speeds = reference.system.nu
        jacobian = own.jacobian.block(slice(0, own.positions))
        columns = [forward(g, k.rates.nodes, {g.var("u", n): ONE}) for n in range(nu)]
        moves = Matrix(g, nu, reference.system.nq, [x for c in columns for x in c]).T
        still = {leaf: node for leaf, node in reference.values.items() if g.nodes[leaf][1] != "q"}
        outputs = []
        for name, x in (("g", own.position), ("G", jacobian), ("N", moves)):
            nodes = substituted(g, x.nodes, still)
            outputs.append(Output(name, (x.rows, x.columns), tuple(nodes)))
        places = [b for b in reference.equations.blocks.values() if b.name == "q"]
        inputs = (*reference.inputs, *places)
        self._function = Function("closing", g, inputs, tuple(outputs))
        self._step = reference.equations.function("integrate")
        self._given: dict[str, Any] = reference.tried()
        start = [g.var("q", n) for n in range(reference.system.nq)]
        q0 = Matrix(g, len(start), 1, [reference.values[x] for x in start])
        self._start = reference.number(q0)[:, 0]
        self._fixed = q0
        self._count = len(reference.symbols.names)
        self.found = self._first(self._start)
        away = np.abs(self.found - self._start) > 1e-12
        self.moved = [n for n in range(len(away)) if away[n] and n not in self.held]
        self.names = [reference.names["q"][n] for n in self.moved]

    def at(self, p: Array, symbols: Array) -> Array:
        """The coordinates (nq,) at other parameters and values of symbols, those of others last.

        Raises:
            DerivationError: the circuits do not close.
        """
        given = {**self._given, "p": p, NOMINAL: symbols[: self._count]}
        output = Output("q", (len(self._start),), self._fixed.nodes)
        places = evaluate(replace(self._function, outputs=(output,)), given)["q"]
        start = np.array([float(x) for x in places])
        start[self.moved] = self.found[self.moved]
        return self._followed(given, start)

    def _first(self, start: Array) -> Array:
        """From the start itself, or from places around it."""
        spread = np.random.default_rng(1).normal(0.0, 1.0, (STARTS, self._speeds))
        for n, du in enumerate(spread):
            q = start
            if n:
                moved = evaluate(
                    self._step, {**self._given, "q": start.tolist(), "du": du.tolist()}
                )
                q = np.array([float(x) for x in moved["q"]])
                q[self.held] = start[self.held]
            try:
                return self._followed(self._given, q)
            except DerivationError as problem:
                last = problem
        raise last

    def _followed(self, given: dict[str, Any], start: Array) -> Array:
        q, last = np.array(start), np.inf
        for _ in range(STEPS):
            g, G, N = self._values({**given, "q": q})
            gap = float(np.abs(g).max(initial=0.0))
            if gap <= ROUNDING or (gap <= CLOSED and gap > 0.5 * last):
                break
            last = gap
            kept = np.concatenate([G, N[self.held]])
            right = np.concatenate([-g[:, 0], np.zeros(len(self.held))])
            du = np.linalg.lstsq(kept, right, rcond=1e-9)[0]
            du *= min(1.0, LONGEST / max(float(np.abs(du).max(initial=0.0)), LONGEST))
            moved = evaluate(self._step, {**given, "q": q.tolist(), "du": du.tolist()})
            q = np.array([float(x) for x in moved["q"]])
        if not last <= CLOSED and not gap <= CLOSED:
            raise DerivationError(
                f"linearize: the circuits stay open by {gap:.2g} with the given coordinates; "
                "leave some out, or start nearer by q0"
            )
        return q

    def _values(self, given: dict[str, Any]) -> list[Array]:
        found = evaluate(self._function, given)
        return [
            np.array([float(x) for x in found[o.name]]).reshape(o.shape)
            for o in self._function.outputs
        ]
