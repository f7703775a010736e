"""The motion about which equations are linearized: positions, speeds, accelerations, multipliers.

What is named stands; dependent coordinates are assembled, dependent speeds, accelerations and the
multipliers follow from linear systems, as expressions.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...errors import DerivationError, listed, near
from ...ir.derivative import forward
from ...ir.function import Block, Function, Output
from ...ir.graph import ONE, ZERO
from ...ir.interpreter import evaluate
from ...ir.matrix import Matrix
from ...ir.solve import solve
from ..constraints.reaction_friction import friction_forces
from ..functions import blocks
from ..functions.dynamics import Dynamics
from ..kinematics.kinematics import Kinematics
from .assembled import Assembly
from .choice import REQUEST_WEIGHT, choice
from .pivoting import independent, independent_rows, solved
from .reference_input import (
    NOMINAL,
    Placeholder,
    Symbols,
    check_rotations,
    depends,
    entries,
    places_of,
    specified_speeds,
    substituted,
)

if TYPE_CHECKING:
    from ..record import EquationRecord

CLOSED = 1e-9
TRIED = 0.37  # [s], where expressions in t are looked at
FREE = "free"


class Reference:
    """A reference motion.

    Args:
        equations: Of the system.
        q, u, udot, z, r: By name, as numbers or SymPy expressions; udot may be ``"free"``.
        t: Time [s]; None: it stays a symbol.
        s: Modes by name.
        values: Numbers for the symbols of the reference.
        wanted: Coordinates or speeds that are to be independent.
    """

    def __init__(
        self,
        equations: EquationRecord,
        q: Mapping[str, object],
        u: Mapping[str, object],
        udot: Mapping[str, object] | str,
        z: Mapping[str, object],
        r: Mapping[str, object],
        s: Mapping[str, object],
        t: float | None,
        values: Mapping[str, float],
        independent: Iterable[str] | None,
    ) -> None:
        self.equations, self.system = equations, equations.system
        if friction_forces(self.system):
            raise DerivationError(
                f"linearize: the friction of '{friction_forces(self.system)[0].name}' follows from "
                "reactions; model.linearize does it in numbers"
            )
        self.k = Kinematics(self.system, equations.chosen)
        self.d = Dynamics(self.k, "kane" if equations.chosen else "composite")
        self.graph, self.names = self.k.graph, {b.name: b.entries for b in self._blocks}
        self.values: dict[int, int] = {}
        self.symbols = Symbols(self.graph, self._parameter_nodes(), values)
        self._set_constants(z, r, s)
        self._set_positions(q, t)
        if self.symbols.unused():
            raise DerivationError(f"linearize: values: no symbol '{self.symbols.unused()[0]}'")
        names = [] if independent is None else listed("independent", independent, "crank")
        self._choose(names, q, u)
        self._set_speeds(u)
        self._set_accelerations(udot)
        self._set_multipliers()

    # blocks and numbers

    @property
    def _blocks(self) -> list[Block]:
        return list(self.equations.blocks.values())

    def block(self, letter: str) -> list[int]:
        """Leaves of a block."""
        return [self.graph.var(letter, k) for k in range(len(self.names[letter]))]

    def _parameter_nodes(self) -> dict[str, int]:
        nodes = {name: self.graph.var("p", k) for k, name in enumerate(self.names["p"])}
        return {"t": self.graph.var("t", 0)} | nodes

    def put(self, x: Matrix) -> Matrix:
        """Expressions at the reference."""
        return Matrix(self.graph, x.rows, x.columns, substituted(self.graph, x.nodes, self.values))

    def number(self, x: Matrix, p: Array | None = None) -> Array:
        """Values of expressions at the default parameters; symbols without value have any."""
        output = Output("x", (x.rows, x.columns), x.nodes)
        function = Function("x", self.graph, self.inputs, (output,))
        flat = evaluate(function, self.tried(p))["x"]
        return np.array([float(v) for v in flat]).reshape(x.rows, x.columns)

    @property
    def inputs(self) -> tuple[Block, ...]:
        """Blocks that matrices at the reference may read."""
        names = self.symbols.names
        nominal = Block(NOMINAL, names, ("",) * len(names))
        return (*(b for b in self._blocks if b.name in ("t", "p")), nominal)

    def tried(self, p: Array | None = None) -> dict[str, Any]:
        """Values of the inputs at which pivots are chosen and the reference is checked."""
        rng = np.random.default_rng(5)
        free = rng.uniform(0.5, 1.5, len(self.symbols.names))
        nominal = [
            x if v is None else v for v, x in zip(self.symbols.values.values(), free, strict=True)
        ]
        parameters = [x.value for x in self.system.parameters] if p is None else p
        return {"t": [TRIED], "p": parameters, NOMINAL: nominal}

    def trials(self) -> list[Array | None]:
        """Parameters at which something may be seen not to vanish: the default ones, and others.

        A parameter that is 0 by default hides what it brings.
        """
        p = np.array([x.value for x in self.system.parameters], dtype=np.float64)
        other = np.where(p == 0.0, np.random.default_rng(7).uniform(0.5, 1.5, len(p)), p)
        if not np.any(p == 0.0) or self.open_at(self.tried(other)) > CLOSED:
            return [None]
        return [None, other]

    # what is given

    def _set(self, letter: str, nodes: Sequence[int]) -> None:
        self.values.update(zip(self.block(letter), nodes, strict=True))

    def _set_constants(
        self, z: Mapping[str, object], r: Mapping[str, object], s: Mapping[str, object]
    ) -> None:
        """Internal states, inputs and modes."""
        start = blocks.defaults(self.system)
        for letter, values, what in (
            ("z", z, "internal state"),
            ("r", r, "input"),
            ("s", s, "mode"),
        ):
            chosen = entries(values, self.names[letter], what)
            self._set(letter, [
                self.symbols.node(chosen[k]) if k in chosen else self.graph.const(float(x))
                for k, x in enumerate(start[letter])
            ])  # fmt: skip

    def _set_positions(self, q: Mapping[str, object], t: float | None) -> None:
        specified = entries(q, self.names["q"], "coordinate")
        check_rotations(self.system, self.names["q"], specified)
        start = [default for _, _, default in blocks.coordinates(self.system)]
        for joint in self.system.joints:
            if joint.q >= 0 and joint.q0 is not None:
                start[joint.q : joint.q + len(joint.q0)] = joint.q0
        nodes = [
            self.symbols.node(specified[k]) if k in specified else self.graph.const(float(x))
            for k, x in enumerate(start)
        ]
        self.time = self.graph.var("t", 0)
        self.timed = depends(self.graph, nodes, self.time)
        # what was simulated holds the constraints as well as it can
        self.trusted = any(isinstance(x, Placeholder) for x in specified.values())
        if t is None and not self.trusted and not self.timed and self._driven():
            t = 0.0
        if t is not None and not self.timed:
            self.values[self.time] = self.graph.const(t)
        self._set("q", nodes)
        self.assembly: Assembly | None = None
        if self.positions and not self.trusted and self.open_at(self.tried()) > CLOSED:
            self._assemble(specified)

    def _driven(self) -> bool:
        """True when loops close differently at every time."""
        return self.system.closed and depends(
            self.graph, self.d.constraints.position.nodes, self.time
        )

    @property
    def positions(self) -> int:
        """Constraints of position level."""
        return self.d.constraints.positions if self.system.closed else 0

    def open_at(self, values: Mapping[str, object]) -> float:
        """Closure error at the reference, the largest of a batch of values."""
        if not self.positions:
            return 0.0
        x = self.put(self.d.constraints.position)
        function = Function("x", self.graph, self.inputs, (Output("x", (x.rows,), x.nodes),))
        return float(np.abs(evaluate(function, values, "numpy")["x"]).max(initial=0.0))

    def _assemble(self, specified: Mapping[int, object]) -> None:
        """Coordinates that are not given become symbols with the values that close the loops."""
        if self.timed:
            raise DerivationError(
                "linearize: the coordinates do not close the loops at all times; give those of "
                "all joints as expressions in t, or a motion that was simulated"
            )
        self.assembly = Assembly(self, sorted(specified))
        for k, name in zip(self.assembly.moved, self.assembly.names, strict=True):
            node = self.symbols.add(name, float(self.assembly.solution[k]))
            self.values[self.graph.var("q", k)] = node

    # independent increments and speeds

    @cached_property
    def G(self) -> Matrix:
        """G at the reference (m, nu)."""
        if not self.system.closed:
            return Matrix.zeros(self.graph, 0, self.system.nu)
        return self.put(self.d.constraints.jacobian)

    def _choose(
        self, independent: list[str], q: Mapping[str, object], u: Mapping[str, object]
    ) -> None:
        """Choose independent increments and speeds, and the rows of G that determine the others."""
        slots = {name: self.slot(name) for name in independent}
        specified = specified_speeds(self.names["u"], q, u)
        partition = choice(self.number(self.G), self.positions, slots, specified)
        self.y, self.w = partition.y, partition.w
        self.dependent_y, self.dependent_w = partition.dependent_y, partition.dependent_w
        self.rows_y, self.rows_w = partition.rows_y, partition.rows_w

    def slot(self, name: str) -> int:
        """Number of a speed, by its name or that of the coordinate it is the rate of.

        Raises:
            DerivationError: there is none.
        """
        places = places_of(name, self.names["u"])
        if len(places) != 1:
            hint = near(name, (*self.increments, *self.names["u"]))
            raise DerivationError(f"linearize: there is no coordinate or speed '{name}'.{hint}")
        return places[0]

    @cached_property
    def increments(self) -> tuple[str, ...]:
        """Name of every increment: a coordinate, or ``along`` a speed that is not a rate."""
        rates = {node: k for k, node in enumerate(self.k.rates.nodes)}
        return tuple(
            self.names["q"][rates[leaf]] if leaf in rates else f"along {name}"
            for leaf, name in zip(self.block("u"), self.names["u"], strict=True)
        )

    def by_dependent(self, G: Matrix, rows: list[int], columns: list[int], right: Matrix) -> Matrix:
        """X with G[rows, columns] X = right."""
        if not rows:
            return Matrix.zeros(self.graph, 0, right.columns)
        return self.solve(picked(G, rows, columns), right)

    def solve(self, a: Matrix, b: Matrix) -> Matrix:
        """X with A X = B: written out, but along a simulated motion by pivots of every moment."""
        if not self.trusted:
            return solved(a, b, self.number(a))
        # in a symmetric system, as kernels solve those of any batch
        n, none = a.rows, Matrix.zeros(self.graph, a.rows, a.rows)
        both = Matrix.vstack(Matrix.hstack(none, a.T), Matrix.hstack(a, none))
        right = Matrix.vstack(Matrix.zeros(self.graph, n, b.columns), b)
        return solve("symmetric_indefinite", both, right).block(slice(0, n))

    # speeds, accelerations, multipliers

    def _set_speeds(self, u: Mapping[str, object]) -> None:
        specified = entries(u, self.names["u"], "speed")
        nodes = [ZERO] * self.system.nu
        for k, value in specified.items():
            nodes[k] = self.symbols.node(value)
        if self.timed:
            nodes = [n if k in specified else rate for k, (n, rate) in enumerate(
                zip(nodes, self._rates(), strict=True))]  # fmt: skip
        self._set("u", nodes)
        if self.system.closed and not self.trusted:
            rates = self.put(self.d.constraints.rates)
            if np.abs(self.number(rates)).max(initial=0.0) > CLOSED:
                self._complete("u", rates, specified)

    def _rates(self) -> list[int]:
        """Speeds of coordinates that are expressions in t."""
        if self.equations.chosen:
            raise DerivationError("linearize: give u for coordinates that depend on t")
        rates = [ZERO] * self.system.nu
        for i, joint in enumerate(self.system.joints):
            if joint.q < 0:
                continue
            q = self.put(self.k.coordinates[i])
            qdot = Matrix(self.graph, q.rows, 1, forward(self.graph, q.nodes, {self.time: ONE}))
            u = joint.element.speeds_of(q, qdot, **self.k.data[i])
            rates[joint.u : joint.u + u.rows] = u.nodes
        return rates

    def _complete(self, letter: str, residual: Matrix, specified: Mapping[int, object]) -> None:
        """Dependent entries changed so that the constraints hold, given ones as they are."""
        weights = np.ones(self.system.nu)
        weights[list(specified)] = REQUEST_WEIGHT**2
        weights[[k for k in self.w if k not in specified]] = REQUEST_WEIGHT
        G = self.number(self.G)
        free = independent(G, weights)
        columns = [k for k in range(self.system.nu) if k not in free]
        rows = independent_rows(G[:, columns])
        over = {columns.index(k): self.names["u"][k] for k in specified if k in columns}
        change = self.by_dependent(self.G, rows, columns, picked(residual, rows, [0]))
        if over and np.abs(self.number(change)[list(over)]).max() > CLOSED:
            raise DerivationError(
                "linearize: the constraints do not allow the given speeds: "
                f"'{next(iter(over.values()))}' follows from the others; leave it out"
            )
        for n, k in enumerate(columns):
            if k not in specified:
                leaf = self.graph.var(letter, k)
                self.values[leaf] = self.graph.sub(self.values[leaf], change.nodes[n])

    def _set_accelerations(self, udot: Mapping[str, object] | str) -> None:
        accelerations = {} if isinstance(udot, str) else udot
        specified = entries(accelerations, self.names["udot"], "acceleration")
        nodes = forward(self.graph, [self.values[x] for x in self.block("u")], {self.time: ONE})
        for k, value in specified.items():
            nodes[k] = self.symbols.node(value)
        self._set("udot", nodes)
        if self.system.closed:
            constraints = self.d.constraints
            udot_vector = Matrix(self.graph, self.system.nu, 1, self.block("udot"))
            residual = self.put(constraints.jacobian @ udot_vector - constraints.gamma)
            if np.abs(self.number(residual)).max(initial=0.0) > CLOSED:
                self._complete("udot", residual, specified)
        if isinstance(udot, str):
            if udot != FREE:
                raise DerivationError(f"linearize: udot is by name, or '{FREE}', not '{udot}'")
            self._set_free()

    @cached_property
    def W(self) -> Matrix:
        """Changes of all speeds by the independent ones (nu, nw)."""
        return self.expanded(self.G, self.rows_w, self.dependent_w, self.w)

    def expanded(self, G: Matrix, rows: list[int], dependent: list[int], free: list[int]) -> Matrix:
        """All entries from the free ones under G x = 0 (nu, n)."""
        change = self.by_dependent(G, rows, dependent, -picked(G, rows, free))
        return self.joined(free, dependent, Matrix.identity(self.graph, len(free)), change)

    def joined(self, free: list[int], dependent: list[int], a: Matrix, b: Matrix) -> Matrix:
        """Rows of free and dependent entries in their places."""
        place = {k: a.row(n) for n, k in enumerate(free)}
        place |= {k: b.row(n) for n, k in enumerate(dependent)}
        nodes = [x for k in range(len(place)) for x in place[k]]
        return Matrix(self.graph, len(place), a.columns, nodes)

    @cached_property
    def balance(self) -> Matrix:
        """M udot + h - f at any state (nu, 1), constraint forces not counted."""
        return self.d.inverse(Matrix(self.graph, self.system.nu, 1, self.block("udot")))

    def _set_free(self) -> None:
        """Accelerations of the motion that starts there by itself."""
        missing, W = self.put(self.balance), self.W
        mass = W.T @ self.put(self.d.mass_matrix) @ W
        change = W @ self.solve(mass, W.T @ missing)
        for k, leaf in enumerate(self.block("udot")):
            self.values[leaf] = self.graph.sub(self.values[leaf], change.nodes[k])

    def _set_multipliers(self) -> None:
        """lam by the rows that hold the dependent speeds; redundant ones carry nothing."""
        nodes = [ZERO] * len(self.names["lam"])
        if self.rows_w:
            square = picked(self.G, self.rows_w, self.dependent_w).T
            right = picked(self.put(self.balance), self.dependent_w, [0])
            for row, node in zip(self.rows_w, self.solve(square, right).nodes, strict=True):
                nodes[row] = node
        self._set("lam", nodes)

    @cached_property
    def needed(self) -> Matrix:
        """Forces along the independent speeds that keep the reference going (nw, 1)."""
        return self.W.T @ self.put(self.balance)


def picked(x: Matrix, rows: Sequence[int], columns: Sequence[int]) -> Matrix:
    """Chosen rows and columns."""
    nodes = [x.nodes[i * x.columns + j] for i in rows for j in columns]
    return Matrix(x.graph, len(rows), len(columns), nodes)
