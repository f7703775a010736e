"""How the start of a run follows from what was named where formulas do not tell.

In absolute coordinates nodes and beams are placed where the joints carry them, and loops are closed
by all of them. In joint coordinates loops that what was named leaves free to move begin next to the
start of the scene. Both are geometry without any motion, smooth and cheap: derivatives are
differences of eighth order, as exact as the start itself. A start in absolute coordinates that was
given as a whole is closed by projections, whose derivatives are known.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from typing import NamedTuple, TypeAlias

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveError
from ...records import dataclass
from ...runtime.calls.methods import ByName
from ...runtime.models.constraint_projection import columns_of, size_of
from ...runtime.models.finite_elements.joint_driven_nodes import SAVED, leading
from ...runtime.models.finite_elements.table_loading import entries_read, tables_of
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.verification.differences import REACH, central
from ...schema.blocks import COORDINATES, Blocks
from ...schema.mechanism import JointRow
from ..simulation.driving import RunSetup
from ..simulation.settings import start
from ..simulation.starts.start import closed_start, named_of
from .steps import CLOSING, StepsAgain
from .unknowns import Unknowns, start_blocks, start_places

# first step of differences, of an angle, of the size of a coordinate or of a parameter; each is so
# much of the one before, until two of them agree
STEP, SHORTER, STEPS = 1e-2, 0.2, 6
AGREED, POOR = 1e-9, 1e-5  # relative: enough, and what is refused
Names: TypeAlias = Mapping[str, object]


class Move(NamedTuple):
    """A change of what a start is made of.

    Attributes:
        key: Block and entry that changes.
        at: Start (nx,) by a change.
        size: Of the entry.
        linear: True where the start is linear in it.
    """

    key: tuple[str, int]
    at: Callable[[float], Array]
    size: float = 1.0
    linear: bool = False

    def slope(self) -> Array | None:
        """Derivative of the start (nx,); None where no start can be found beside it.

        Raises:
            SolveError: differences by several steps do not agree.
        """
        if self.linear:
            return 0.5 * (self.at(1.0) - self.at(-1.0))
        last, best, error = None, None, np.inf
        for k in range(STEPS):
            try:
                shorter = self._by(STEP * SHORTER**k * self.size)
            except ModelError:
                # beyond a limit of what can be assembled, perhaps
                continue
            if last is not None:
                off = float(np.abs(shorter - last).max(initial=0.0))
                off /= max(float(np.abs(shorter).max(initial=0.0)), 1e-300)
                best, error = (shorter, off) if off < error else (best, error)
            if error <= AGREED or not np.any(shorter):
                return shorter
            last = shorter
        if best is not None and error > POOR:
            raise SolveError(
                "gradient: the start is next to a place where loops can hardly be closed, and how "
                "it moves is not known. Name another coordinate at the start"
            )
        return last if best is None else best

    def _by(self, step: float) -> Array:
        """Derivative by differences of a step."""
        steps = step * np.outer([1.0, -1.0], REACH)
        ahead, behind = ([self.at(float(x)) for x in row] for row in steps)
        return central(np.array(ahead), np.array(behind)) / step


@dataclass(frozen=True)
class StartByDifferences:
    """Derivatives of the start of a run, by differences of starts.

    Attributes:
        setup: The run.
        state: q, u and z by names, as they were given; None of what was given as a whole.
        r: Inputs at the start (nr,).
        s: Modes (ns,).
        unknowns: What the motion is differentiated by.
        closing: Projections that close a start which was given as a whole.
    """

    setup: RunSetup
    state: Mapping[str, Names | None]
    r: Array
    s: Array
    unknowns: Unknowns
    closing: tuple[str, ...]

    @classmethod
    def of(
        cls,
        setup: RunSetup,
        steps: StepsAgain,
        state: Mapping[str, object],
        s: Array,
        unknowns: Unknowns,
    ) -> StartByDifferences:
        """The derivatives at the start of a run.

        Args:
            setup, steps, state, s: As ``NamedStart.of`` takes them.
            unknowns: What the motion is differentiated by: other derivatives are left out.
        """
        as_a_block = state["x0"] is not None
        names = {
            letter: None if as_a_block else named_of(letter, setup.model, state[letter])
            for letter in "qu"
        }
        closing = tuple(name for name in CLOSING if name in steps.runner.closing.functions)
        z = state["z"] if isinstance(state["z"], Mapping) else {}
        r = steps.inputs_at(setup.over.start)[0]
        return cls(setup, {**names, "z": z}, r, s, unknowns, closing)

    @property
    def model(self) -> LoadedModel:
        """The model of the run."""
        return self.setup.model

    @property
    def wide(self) -> bool:
        """True where a parameter is among the unknowns."""
        return self.unknowns.parameters and len(self.model.parameters) > 0

    # gradients

    def backward(self, lam: Array) -> tuple[Array, Array, Array]:
        """Gradients by the start (2 nu + nz,), by inputs and by parameters.

        Args:
            lam: Gradient by the state (nx,).
        """
        model = self.model
        by_r = np.zeros(model.nr)
        by_p = np.zeros(len(model.parameters) if self.wide else 0)
        if self.state["q"] is None or self.state["u"] is None:
            return self._through_projections(lam, by_r, by_p)
        start_gradient = np.zeros(2 * model.nu + model.nz)
        start_gradient[2 * model.nu :] = lam[model.nq + model.nu :]
        for (block, k), column in self._columns.items():
            {"x": start_gradient, "r": by_r, "p": by_p}[block][k] += column @ lam
        return start_gradient, by_r, by_p

    def forward(self, start_change: Array, by_r: Array, by_p: Array) -> Array:
        """Changes of the state (k, nx), see :meth:`NamedStart.forward`."""
        model = self.model
        change = np.zeros((len(start_change), model.nx))
        change[:, model.nq + model.nu :] = start_change[:, 2 * model.nu :]
        if self.state["q"] is None or self.state["u"] is None:
            return self._projected(start_change, by_r, by_p)
        directions = {"x": start_change, "r": by_r, "p": by_p}
        for (block, k), column in self._columns.items():
            change += np.outer(directions[block][:, k], column)
        return change

    # starts that were given as a whole

    def _arguments(self, name: str) -> tuple[Blocks, ByName]:
        """Blocks that a projection has derivatives by, and where it is taken."""
        model = self.model
        q, u, z = model.parts_of(self.setup.begin.x)
        at = {"t": self.setup.over.start, "q": q, "r": self.r}
        blocks = [COORDINATES]
        if name == "close_velocity":
            at |= {"u": u, "z": z, "s": self.s}
            blocks.append("u")
        blocks += ["r"] * (model.nr > 0) + ["p"] * self.wide
        return Blocks(blocks), at

    def _through_projections(
        self, lam: Array, by_r: Array, by_p: Array
    ) -> tuple[Array, Array, Array]:
        model, lam = self.model, lam.copy()
        nq, nu = model.nq, model.nu
        for name in reversed(self.closing):
            blocks, at = self._arguments(name)
            part = slice(nq, nq + nu) if name == "close_velocity" else slice(0, nq)
            size = getattr(model, name)(**at).size
            weights = np.concatenate([lam[part], np.zeros(size - (part.stop - part.start))])
            slopes = dict(
                zip(blocks, model.vjp(name, wrt=blocks)(**at, weights=weights), strict=True)
            )
            lam[part] = 0.0
            lam[:nq] += slopes[COORDINATES]
            lam[nq : nq + nu] += slopes.get("u", 0.0)
            by_r += slopes.get("r", 0.0)
            by_p += slopes.get("p", 0.0)
        q, u, _ = model.parts_of(self.setup.begin.x)
        (along,) = model.vjp("qdot", wrt=Blocks("u"))(
            q=q, u=u, t=self.setup.over.start, r=self.r, weights=lam[:nq]
        )
        return np.concatenate([along, lam[nq:]]), by_r, by_p

    def _projected(self, start_change: Array, by_r: Array, by_p: Array) -> Array:
        model = self.model
        nq, nu = model.nq, model.nu
        q, u, _ = model.parts_of(self.setup.begin.x)
        along = model.jvp("qdot", wrt=Blocks("u"))(
            q=q, u=u, direction=(start_change[:, :nu],), t=self.setup.over.start, r=self.r
        )
        change = np.hstack([along, start_change[:, nu:]])
        for name in self.closing:
            blocks, at = self._arguments(name)
            ways = {COORDINATES: change[:, :nq], "u": change[:, nq : nq + nu], "r": by_r, "p": by_p}
            direction = {block: ways[block] for block in blocks}
            part = slice(nq, nq + nu) if name == "close_velocity" else slice(0, nq)
            step = model.jvp(name, wrt=blocks)(**at, direction=direction)
            change[:, part] = step[:, : part.stop - part.start]
        return change

    # starts by names

    @cached_property
    def _columns(self) -> dict[tuple[str, int], Array]:
        """Derivatives (nx,) of the start by what may be named, by inputs and by parameters.

        Raises:
            SolveError: the start has none.
        """
        columns = dict[tuple[str, int], Array]()
        with warnings.catch_warnings():
            # those of the start itself were given
            warnings.simplefilter("ignore")
            for move in (*self._along(), *self._by_inputs(), *self._by_parameters()):
                if not self._counts(*move.key):
                    continue
                column = move.slope()
                if column is None and self._is_named(*move.key):
                    speed = self.model.speeds[move.key[1] % self.model.nu]
                    raise SolveError(
                        "gradient: loops cannot be closed beside the start as it was named, along "
                        f"'{speed}'. Name fewer coordinates"
                    )
                # where loops decide what it is, it follows what was named
                if column is not None and np.any(column):
                    columns[move.key] = column
        return columns

    def _counts(self, block: str, k: int) -> bool:
        """True where an unknown is this entry, or has it."""
        model, names = self.model, self.unknowns.names
        if block == "x":
            places = {**start_blocks(model), **start_places(model)}
            slices = [places[name] for name in names if name in places]
            return any(place.start <= k < place.stop for place in slices)
        entries = list(model.parameters if block == "p" else model.inputs)
        return (block == "p" and "p" in names) or entries[k] in names

    def _start(
        self,
        q: Names | None = None,
        u: Names | None = None,
        r: Array | None = None,
        model: LoadedModel | None = None,
        along: Array | None = None,
    ) -> Array:
        """The start by other names, or moved along (2 nu) before loops are closed."""
        model = model or self.model
        names = {**self.state, **{k: v for k, v in (("q", q), ("u", u)) if v is not None}}
        begin = start(model, None, names["q"], names["u"], names["z"])
        inputs = self.r if r is None else r
        if along is not None:
            place, speeds, internal = model.parts_of(begin.x)
            place, speeds = model.integrate(place, along[: model.nu]), speeds + along[model.nu :]
            begin = replace(begin, x=np.concatenate([place, speeds, internal]))
        return closed_start(model, begin, names["q"], names["u"], self.setup.over.start, inputs).x

    def _along(self) -> Iterator[Move]:
        """Starts along the coordinates and speeds of joints, and of what was named."""
        model = self.model
        nu, absolute = model.nu, model.manifest.absolute
        q, u, _ = model.parts_of(self.setup.begin.x)
        leads = leading(model) if absolute else np.zeros(nu, dtype=bool)
        units = columns_of(model, size_of(model))
        for joint in model.manifest.joints:
            for k in range(nu)[_part(joint, "u")]:
                if leads[k] or self._is_named("x", k):

                    def moved(h: float, k: int = k, joint: JointRow = joint) -> Array:
                        place = model.integrate(q, h * np.eye(nu)[k])
                        return self._start(q=self._renamed("q", joint, place))

                    yield Move(("x", k), moved, float(units[k]))
                if leads[k] or self._is_named("x", nu + k):

                    def faster(h: float, k: int = k, joint: JointRow = joint) -> Array:
                        return self._start(u=self._renamed("u", joint, u + h * np.eye(nu)[k]))

                    yield Move(("x", nu + k), faster, linear=True)
                # what nobody named begins next to the start of the scene
                for n in range(2 if not absolute else 0):
                    if not self._is_named("x", n * nu + k):
                        unit = np.eye(2 * nu)[n * nu + k]

                        def started(h: float, unit: Array = unit) -> Array:
                            return self._start(along=h * unit)

                        yield Move(("x", n * nu + k), started, float(units[k]), linear=n == 1)

    def _is_named(self, block: str, k: int) -> bool:
        """True where a direction of the start (2 nu) moves an entry that was named."""
        nu = self.model.nu
        if block != "x" or k >= 2 * nu:
            return False
        letter, k = ("q", k) if k < nu else ("u", k - nu)
        joint = next(x for x in self.model.manifest.joints if k in range(nu)[_part(x, "u")])
        entries, speeds = _part(joint, letter), _part(joint, "u")
        if entries.stop - entries.start == speeds.stop - speeds.start:
            # each entry has a speed of its own
            first = entries.start + k - speeds.start
            entries = slice(first, first + 1)
        slots = self.model.manifest.slots(letter)
        named = (slots[name] for name in self._names(letter) if name in slots)
        return any(x.start < entries.stop and entries.start < x.stop for x in named)

    def _names(self, letter: str) -> Names:
        """What was named of coordinates or speeds."""
        return self.state[letter] or {}

    def _of(self, name: str, letter: str, joint: JointRow) -> bool:
        """True when a name is that of entries of a joint."""
        place = _part(joint, letter)
        slot = self.model.manifest.slots(letter).get(name)
        # coordinates that follow by formulas have none
        return slot is not None and bool(place.start <= slot.start < place.stop)

    def _renamed(self, letter: str, joint: JointRow, block: Array) -> Names:
        """What was named, with the entries of a joint as in a block: all of them if it was not."""
        names, slots = dict(self._names(letter)), self.model.manifest.slots(letter)
        entries = [name for name in names if self._of(name, letter, joint)]
        for name in entries or [joint.name]:
            values = block[slots[name]]
            names[name] = values if len(values) > 1 else float(values[0])
        return names

    def _by_inputs(self) -> Iterator[Move]:
        """Starts at other inputs, of those that geometry reads."""
        for k in sorted(self._read("r")):

            def at(h: float, k: int = k) -> Array:
                return self._start(r=self.r + h * np.eye(len(self.r))[k])

            yield Move(("r", k), at, max(1.0, abs(float(self.r[k]))))

    def _by_parameters(self) -> Iterator[Move]:
        """Starts at other parameters, likewise."""
        model = self.model
        for k in sorted(self._read("p")) if self.wide else ():
            value, name = float(model.parameters.vector[k]), model.manifest.parameters[k].name

            def at(h: float, name: str = name, value: float = value) -> Array:
                return self._start(model=model.with_parameters({name: value + h}))

            # one that is 0 may be a length
            yield Move(("p", k), at, abs(value) or min(1.0, size_of(model)))

    def _read(self, block: str) -> set[int]:
        """Entries of a block that the places of nodes and constraints depend on."""
        model = self.model
        if not model.manifest.absolute:
            return {*range(len(model.parameters) if block == "p" else model.nr)}
        read = set(entries_read(model, SAVED, block))
        for group in (group for group in tables_of(model).groups if group.kind.m):
            if block == "p":
                read |= entries_read(model, group.common, block)
            elif block in model.manifest.functions[group.kind.functions["balance"]].inputs:
                read |= {*range(model.nr)}
        return read


def _part(joint: JointRow, letter: str) -> slice:
    """Entries of a joint in q or u."""
    first, count = joint.slot(letter)
    return slice(first, first + count)
