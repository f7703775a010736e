"""Elements in tables where there is no compiler: all of a kind at once in NumPy, SuperLU.

The same results up to rounding, slower by far; there are no runs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, final

import numpy as np
import scipy.sparse
from numpy.typing import NDArray

from ...errors import SolveError
from ...ir.function import Function
from ...ir.interpreter import evaluate
from ..objects import Code
from .elements import INNER, Elements, State
from .massless import massless, refusal
from .plan import plan
from .superlu import SuperluSolver
from .tables import Tables

Array = NDArray[np.float64]
LIGHT, HEAVY = 1e-6, 1e12  # as in kernels/mesh_calls.c


@final
class PlainElements(Elements):
    """The tables of a model with saved functions.

    Args:
        tables: Places and elements.
        load: C names -> loaded functions, as expressions.
        data: Of every group (n, k).
    """

    def __init__(
        self,
        tables: Tables,
        load: Callable[[Sequence[str]], Mapping[str, Code]],
        data: Sequence[Array],
    ) -> None:
        self.tables = tables
        self._load = load
        self.data = data
        self._known: dict[str, Function] = {}
        self.inner = sum(INNER * len(g) for g in tables.groups if "mixed" in g.kind.functions)

    def _function(self, symbol: str) -> Function:
        if symbol not in self._known:
            found = self._load([symbol])[symbol].interpreted
            assert found is not None
            self._known[symbol] = found.function
        return self._known[symbol]

    # evaluation

    def results(self, form: str, at: State) -> list[Array]:
        """As :meth:`Elements.results`."""
        found, inner = [], 0
        for number, group in enumerate(self.tables.groups):
            own = INNER * len(group) if "mixed" in group.kind.functions else 0
            if form in group.kind.functions:
                function = self._function(group.kind.functions[form])
                given = self.read(number, at, inner)
                values = evaluate(function, given, "numpy")
                found.append(_rows(function, values, len(group)))
            inner += own
        return found

    def balance(self, at: State) -> tuple[Array, Array, Array]:
        """As :meth:`Elements.balance`."""
        tables = self.tables
        force, gaps, rates = np.zeros(tables.nu), np.zeros(tables.mp), np.zeros(tables.m)
        having = [k for k, g in enumerate(tables.groups) if "balance" in g.kind.functions]
        for k, rows in zip(having, self.results("balance", at), strict=True):
            kind, lines = tables.groups[k].kind, tables.lines(k)
            np.add.at(force, tables.columns(tables.groups[k]), rows[:, : kind.nu])
            gaps[lines[:, : kind.mp]] = rows[:, kind.nu : kind.nu + kind.mp]
            rates[lines] = rows[:, kind.nu + kind.mp :]
        return force, gaps, rates

    def gamma(self, at: State) -> Array:
        """As :meth:`Elements.gamma`."""
        out, groups = np.zeros(self.tables.m), self.tables.groups
        having = [k for k, g in enumerate(groups) if "gamma" in g.kind.functions]
        for k, rows in zip(having, self.results("gamma", at), strict=True):
            out[self.tables.lines(k)] = rows
        return out

    def total(self, form: str, size: int, at: State) -> Array:
        """As :meth:`Elements.total`."""
        parts = [rows.sum(axis=0) for rows in self.results(form, at)]
        return np.sum(parts, axis=0) if parts else np.zeros(size)

    # systems

    def _solved(self, A: Any, G: Any, force: Array, right: Array) -> tuple[Array, Array]:
        """x and y with A x + Gᵀ y = force, G x = right; redundant rows share."""
        tables = self.tables
        sizes = np.concatenate([[tables.nu], np.full(1 if tables.m else 0, tables.m)])
        blocks = np.array([[0, 1]] if tables.m else [[0]])
        solver = SuperluSolver(plan(sizes, [blocks], np.arange(len(sizes)) > 0))
        pattern = solver.plan.pattern
        whole = scipy.sparse.block_array([[A, G.T], [G, None]]) if tables.m else A
        columns, rows = pattern.csr
        full = np.asarray(whole.todense())
        lines = np.repeat(np.arange(pattern.n), np.diff(rows))
        solver.factor(full[lines, columns])
        found = solver.solve(np.concatenate([force, right]))
        found, _ = solver.refine(np.concatenate([force, right]), found)
        if not np.isfinite(found).all():
            raise SolveError("the elements leave a motion free that nothing resists")
        return found[: tables.nu], found[tables.nu :]

    def accelerations(self, at: State, tau: Array | None = None) -> tuple[Array, Array]:
        """As :meth:`Elements.accelerations`."""
        rest = State(at.q, at.u, t=at.t, r=at.r, z=at.z, s=at.s)
        tangent, force = self.tangent(rest), -self.balance(rest)[0]
        push = force if tau is None else force + tau
        if massless(self, rest):
            raise SolveError(refusal(self, rest))
        udot, y = self._solved(tangent["M"], tangent["G"], push, self.gamma(rest))
        return udot, -y

    def call(self, name: str, at: State, size: int, tau: Array | None = None) -> Array:
        """As :meth:`Elements.call`."""
        _, gaps, rates = self.balance(at)
        open_now = np.zeros(self.tables.m)
        if name == "close_position":
            open_now[: len(gaps)] = gaps
        else:
            open_now[:] = rates
        tangent = self.tangent(at)
        own = tangent["M"].diagonal()
        more = np.where(own == 0, LIGHT, 0.0)
        if tau is not None:
            more = more + np.where(tau != 0, HEAVY * np.abs(own).max(initial=LIGHT), 0.0)
        held = tangent["M"] + scipy.sparse.diags_array(more)
        step, _ = self._solved(held, tangent["G"], np.zeros(len(own)), -open_now)
        if name == "close_position":
            return np.concatenate([self.move(at.q, step), gaps])
        assert at.u is not None
        return np.concatenate([at.u + step, rates])

    # motion

    def rates(self, q: Array, u: Array) -> Array:
        """As :meth:`Elements.rates`."""
        return self._places("qdot", {"q": q, "u": u})

    def move(self, q: Array, du: Array) -> Array:
        """As :meth:`Elements.move`."""
        return self._places("move", {"q": q, "du": du})

    def _places(self, name: str, given: dict[str, Array]) -> Array:
        """A function of places, kind by kind, (nq,)."""
        tables, out = self.tables, np.zeros(self.tables.nq)
        speeds = given["u" if name == "qdot" else "du"]
        for k, kind in enumerate(tables.kinds):
            places = np.flatnonzero(tables.kind == k)
            q_at = tables.q[places][:, None] + np.arange(kind.nq)
            u_at = tables.u[places][:, None] + np.arange(kind.nu)
            q, u = given["q"][q_at], speeds[u_at]
            if name in kind.functions:
                function = self._function(kind.functions[name])
                blocks = {"q": q, "u" if name == "qdot" else "du": u, "p": np.zeros(0)}
                found = evaluate(function, blocks, "numpy")
                out[q_at] = np.reshape(found[function.outputs[0].name], q.shape)
            elif kind.name == "node":
                out[q_at] = _rated(q, u) if name == "qdot" else _moved(q, u)
            else:
                out[q_at] = u if name == "qdot" else q + u
        return out


def _rows(function: Function, values: Mapping[str, Any], n: int) -> Array:
    """Results of a function one behind the other, (n, size)."""
    parts = []
    for output in function.outputs:
        value = np.asarray(values[output.name], dtype=np.float64)
        value = value.reshape(*value.shape[: value.ndim - len(output.shape)], output.size)
        parts.append(np.broadcast_to(value, (n, output.size)))
    return np.concatenate(parts, axis=1)


def _rated(q: Array, u: Array) -> Array:
    """Rates of poses (n, 7)."""
    w, v, omega = q[:, :1], q[:, 1:4], u[:, :3]
    first = -np.sum(v * omega, axis=1, keepdims=True)
    return np.concatenate([0.5 * first, 0.5 * (w * omega + np.cross(v, omega)), u[:, 3:]], axis=1)


def _moved(q: Array, du: Array) -> Array:
    """Poses (n, 7) turned in their own axes and moved in those of the ground."""
    angle = np.linalg.norm(du[:, :3], axis=1, keepdims=True)
    c, s = np.cos(angle / 2), 0.5 * np.sinc(angle / (2 * np.pi)) * du[:, :3]
    w, v = q[:, :1], q[:, 1:4]
    first = w * c - np.sum(v * s, axis=1, keepdims=True)
    return np.concatenate([first, w * s + c * v + np.cross(v, s), q[:, 4:] + du[:, 3:]], axis=1)
