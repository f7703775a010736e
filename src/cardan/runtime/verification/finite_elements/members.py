"""Elements of one kind at random states, and what their functions give there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ....ir.interpreter import evaluate
from ....ir.serialize import from_dict
from ....records import dataclass
from ....schema.finite_elements import PlaceKind
from ...calls import loaded_function
from ...calls.code import Code
from ...calls.lanes import unpacked
from ...models.finite_elements.elements import Elements, State
from ...models.finite_elements.tables import Table, Tables
from ...models.initial import start_of
from ..differences import BOUND, SHAKES, missing, relative, shaken, slope
from ..joint_motion import Array
from ..source_expressions import results

if TYPE_CHECKING:
    from ...models.loaded_model import LoadedModel

# how far places are moved from where they start: angles [rad], lengths in parts of the scene's
ANGLE_STEP, SHIFTED = 0.3, 0.03
MOST = 2
# random configurations of the scene at which what was compiled just now is judged
STATES = 2
NODE = 7


class NotThere(Exception):
    """A function that a law needs and the kind does not have, or not compiled; by its name."""


@dataclass(frozen=True)
class Members:
    """Some elements of one kind at random states, (n, ...) each.

    Attributes:
        model: Whose.
        table: Their group.
        inputs: What their functions read.
        codes: Functions by name.
        blocks: Places that they couple.
        length: Size of the scene [m].
    """

    model: LoadedModel
    table: Table
    inputs: Mapping[str, Array]
    codes: Mapping[str, Code]
    blocks: tuple[PlaceKind, ...]
    length: float
    cache: dict[str, Any] = field(default_factory=dict, repr=False, compare=False)

    @property
    def count(self) -> int:
        """Number of states."""
        return len(self.inputs["q"])

    def call(self, form: str, overrides: Mapping[str, Array] | None = None) -> Array:
        """Results (n, size) of a function, at other blocks where they are given.

        Raises:
            NotThere: there is no such function.
        """
        if form not in self.codes:
            raise NotThere(form)
        code, blocks = self.codes[form], {**self.inputs, **(overrides or {})}
        n = max(len(x) for x in blocks.values() if x.ndim > 1)
        run, out = loaded_function.calls(code, blocks, n)
        with np.errstate(all="ignore"):
            run()
        return unpacked(out, code.lanes)[:n]

    def weighed(self, form: str) -> Members:
        """The same with random weights, where a function has some."""
        size = len(self.codes[form].entry.vector)
        if not size:
            return self
        weights = np.random.default_rng(9).uniform(-1, 1, (self.count, size))
        return replace(self, inputs={**self.inputs, "v": weights}, cache={})

    def disagreement(self, both: Callable[[Members], tuple[Array, Array]], *terms: Array) -> float:
        """Of two results (n, ...) for the same, beyond what rounding makes of their difference.

        Of the largest term; NaN where rounding hides everything.
        """
        value, expected = both(self)
        plain = relative(value - expected, expected, *terms)
        # what is no number is wrong whatever rounding does
        if plain < BOUND or not np.isfinite(plain):
            return plain
        # of either too: a few differences may share their rounding by chance
        blur = self.blur(lambda at: (two := both(at)) + (np.subtract(*two),))
        return missing(value.reshape(self.count, -1), blur, expected, *terms)

    def blur(self, results: Callable[[Members], Sequence[Array]]) -> Array:
        """How far results (n, ...) differ where inputs are rounded once more; the most, (n,)."""
        near = [
            results(replace(self, inputs=shaken(self.inputs, k), cache={})) for k in range(SHAKES)
        ]
        spreads = [np.ptp(each, axis=0).reshape(self.count, -1) for each in zip(*near, strict=True)]
        return np.asarray(np.concatenate(spreads, axis=-1).max(axis=-1, initial=0.0))

    def expressions(self, form: str, overrides: Mapping[str, Array] | None = None) -> Array | None:
        """Results of the saved expressions, at other blocks if given; None where not saved."""
        saved = self.model._objects.saved().get(self.codes[form].symbol)
        if saved is None:
            return None
        return results(from_dict(saved), overrides or self.inputs, self.count)

    def constraint_rows(self) -> Array:
        """G (n, m, nu) of its constraints, zero where no mode holds them."""
        kind, n = self.table.kind, self.count
        at = kind.parts.get("G")
        if at is None:
            return np.zeros((n, kind.m, kind.nu))
        flat = self.call("balance_tangent")[:, at : at + kind.m * kind.nu]
        return flat.reshape(n, kind.m, kind.nu)

    @cached_property
    def in_all_modes(self) -> Members:
        """The same at as many states for each of its modes."""
        rows, entries = self.model.manifest.s, self.table.s
        if entries is None:
            return self
        labels = [
            [float(v) for v in rows[k].labels] for k in entries[0, : self.table.kind.states[1]]
        ]
        count = max((len(each) for each in labels), default=0) or 1
        inputs = {k: np.tile(x, (count, 1)) for k, x in self.inputs.items()}
        for k, each in enumerate(labels):
            if each:
                modes = np.resize(each, count)
                inputs["s"][:, k] = np.repeat(modes, self.count)
        return replace(self, inputs=inputs, cache={})

    # ways to move

    @cached_property
    def starts(self) -> tuple[list[int], list[int]]:
        """First local coordinate and speed of every block."""
        q, u = np.cumsum([[0, 0]] + [[b.nq, b.nu] for b in self.blocks], axis=0).T.tolist()
        return q, u

    @cached_property
    def plain(self) -> bool:
        """True when all places are nodes, or have speeds that are rates of coordinates."""
        return all("qdot" not in b.functions or b.node for b in self.blocks)

    def along(self, du: Array, q: Array | None = None) -> Array:
        """Rates of the coordinates of increments along the speeds."""
        q = self.inputs["q"] if q is None else q
        derivative = np.zeros_like(q)
        for block, a, b in zip(self.blocks, *self.starts, strict=False):
            increment = du[:, b : b + block.nu]
            if block.nq == NODE and block.quaternion is not None:
                derivative[:, a : a + 4] = quaternion_rate(q[:, a : a + 4], increment[:, :3])
                derivative[:, a + 4 : a + 7] = increment[:, 3:]
            elif "qdot" in block.functions:
                rates = from_dict(self.model._objects.saved()[block.functions["qdot"]])
                here = {"q": q[:, a : a + block.nq], "u": increment}
                derivative[:, a : a + block.nq] = evaluate(rates, here, "numpy")[
                    rates.outputs[0].name
                ]
            else:
                derivative[:, a : a + block.nq] = increment
        return derivative

    def slope(
        self, f: Any, rates: Mapping[str, Array], overrides: Mapping[str, Array] | None = None
    ) -> tuple[Array, Array]:
        """Derivative of a function of blocks along rates, and how far it may be off."""
        at = {**self.inputs, **(overrides or {})}
        size = np.zeros(self.count)
        for name, rate in rates.items():
            scale = self._scale if name == "q" else 1.0
            size = np.maximum(size, np.abs(rate / scale).max(axis=-1, initial=0.0))
        return slope(f, at, rates, size)

    @cached_property
    def _scale(self) -> Array:
        scale = np.ones(self.inputs["q"].shape[-1])
        for block, a in zip(self.blocks, self.starts[0], strict=False):
            if block.node and block.nq == NODE:
                scale[a + 4 : a + 7] = self.length
            elif block.node:
                scale[a : a + 2] = self.length
            else:
                scale[a : a + block.nq] = min(1.0, self.length)
        return scale


def in_space(block: PlaceKind) -> bool:
    """True of a node in space."""
    return bool(block.node) and block.nq == NODE


def quaternion_rate(q: Array, w: Array) -> Array:
    """Rate of unit quaternions that turn with w in their own axes."""
    real, v = q[:, :1], q[:, 1:]
    return 0.5 * np.concatenate(
        [-(v * w).sum(axis=-1, keepdims=True), real * w + np.cross(v, w)], axis=-1
    )


def members_of(
    model: LoadedModel,
    elements: Elements,
    codes: Mapping[str, Code],
    seed: int,
    count: int = STATES,
) -> list[Members]:
    """Some members of every kind, of its largest group, in so many configurations."""
    rng, tables = np.random.default_rng(seed), elements.tables
    groups = tables.groups
    largest: dict[str, int] = {}
    for k in sorted(range(len(groups)), key=lambda k: len(groups[k])):
        largest[groups[k].kind.name] = k
    length = length_of(tables)
    states = [state_of(model, elements, rng, length) for _ in range(count)]
    members = []
    for number in sorted(largest.values()):
        group = groups[number]
        rows = np.unique(np.linspace(0, len(group) - 1, min(MOST, len(group))).astype(int))
        parts = [_read(elements, number, at, rows) for at in states]
        inputs = {k: np.concatenate([part[k] for part in parts]) for k in parts[0]}
        kind = group.kind
        symbols = {**kind.functions, **kind.derivatives}
        compiled = {f: codes[symbol] for f, symbol in symbols.items() if symbol in codes}
        places = (
            tuple(tables.kinds[tables.kind[p]] for p in group.place[0]) if group.place.size else ()
        )
        members.append(Members(model, group, _drawn(inputs, rng), compiled, places, length))
    return members


def _read(elements: Elements, number: int, at: State, rows: Any) -> dict[str, Array]:
    inputs = elements.read(number, at)
    n = len(elements.tables.groups[number])
    return {k: np.broadcast_to(x, (n, x.shape[-1]))[rows] for k, x in inputs.items()}


def _drawn(inputs: dict[str, Array], rng: np.random.Generator) -> dict[str, Array]:
    """Blocks that elements keep to themselves, drawn too."""
    n, nu = inputs["u"].shape
    drawn = dict(inputs)
    drawn["du"] = 1e-2 * rng.uniform(-1, 1, (n, nu))
    drawn["e"] = rng.integers(0, 2, drawn["e"].shape).astype(float)
    drawn["tau"] = rng.uniform(0.5, 2, drawn["tau"].shape)
    if not drawn["z"].shape[-1]:
        drawn["z"] = rng.uniform(-1, 1, (n, 6))
    return drawn


def state_of(
    model: LoadedModel, elements: Elements, rng: Any, length: float, turn: float = 1.0
) -> State:
    """Positions near the start of the scene; speeds, and what else is read, of order 1."""
    tables, layout = elements.tables, model._layout
    # as the scene tells it: to assemble it would take the elements that are judged here
    q = start_of(model, {}, {})[0][: tables.nq]
    step = turn * ANGLE_STEP * rng.uniform(-1, 1, tables.nu)
    for kind, start in zip(tables.kind, tables.u[:-1], strict=True):
        place = tables.kinds[kind]
        if place.node and place.nq == NODE:
            step[start + 3 : start + 6] *= SHIFTED / ANGLE_STEP * length / turn
        elif place.node:
            step[start : start + 2] *= SHIFTED / ANGLE_STEP * length / turn
    r = layout.start("r")
    return State(
        q=elements.move(np.asarray(q), step),
        u=rng.uniform(-1, 1, tables.nu),
        udot=rng.uniform(-1, 1, tables.nu),
        lam=rng.uniform(-1, 1, tables.m),
        t=0.3,
        r=r + 0.3 * rng.uniform(-1, 1, len(r)),
        z=layout.start("z") + 0.1 * rng.uniform(-1, 1, len(layout.start("z"))),
        s=layout.start("s"),
    )


def length_of(tables: Tables) -> float:
    """The longest element of a beam [m]; 1 where there are none."""
    sizes = [float(np.diff(stations).max()) for stations in tables.stations]
    return max(sizes, default=1.0)
