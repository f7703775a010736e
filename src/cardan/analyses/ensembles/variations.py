"""Differences between the runs of an ensemble, from the user's arguments to numbers per run."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field, replace
from typing import Any

import numpy as np

from ...arguments import Inputs
from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, named, near
from ...records import dataclass
from ...runtime.calls.calling import numbers
from ...runtime.models.initial import initial_state, missing
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.named_rotations import check_units, component, refuse_components
from ..simulation.settings import refuse_second
from ..simulation.signals import Signals, one_by_one, signals
from . import sampling

SUCH = "such as vary={'mass': [1, 2, 5]}, or a plan, vary=cd.sample.grid(mass=(1, 2, 100))"
SOME = 1 << 14  # runs whose parameters are looked at together
WHAT = {"q": "coordinate", "u": "speed", "z": "state", "p": "parameter", "r": "input"}


@dataclass(frozen=True)
class Column:
    """Values of one name, or of a whole block.

    Attributes:
        block: ``q``, ``u``, ``z``, ``p`` or ``r``.
        name: As the user said it; the block itself where all of it was given.
        place: Its entries in the block.
        values: (runs, n), or (1, n) where all runs share them.
    """

    block: str
    name: str
    place: slice
    values: Array = field(repr=False)

    def part(self, first: int, last: int) -> Column:
        """The same of some runs."""
        return self if len(self.values) == 1 else replace(self, values=self.values[first:last])


@dataclass(frozen=True)
class Varied:
    """Start and parameters of every run.

    Attributes:
        runs: How many there are.
        base: Block -> what all runs start from, but for the columns.
        quaternions: First entry of each in q.
        columns: What is given, per run or for all.
    """

    runs: int
    base: Mapping[str, Array] = field(repr=False)
    quaternions: tuple[int, ...]
    columns: tuple[Column, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the quantities that differ between runs."""
        return tuple(c.name for c in self.columns if len(c.values) > 1)

    def part(self, first: int, last: int) -> Varied:
        """The same of some runs alone."""
        columns = tuple(column.part(first, last) for column in self.columns)
        return replace(self, runs=last - first, columns=columns)

    def states(self) -> Array:
        """Initial states of all runs (runs, nx)."""
        return np.concatenate([self.block(letter) for letter in "quz"], axis=1)

    def block(self, letter: str) -> Array:
        """q (runs, nq), u (runs, nu), z, p (runs, np) or r (runs, nr) of all runs."""
        block = self.raw_block(letter)
        for start in self.quaternions if letter == "q" else ():
            # entry by entry: every run gets the bits it would get alone
            w, x, y, z = (block[:, start + k] for k in range(4))
            block[:, start : start + 4] /= np.sqrt(w * w + x * x + y * y + z * z)[:, None]
        return block

    def raw_block(self, letter: str) -> Array:
        """Same as :meth:`block`, quaternions as they were given."""
        block = np.tile(self.base[letter], (self.runs, 1))
        for column in self.columns:
            if column.block == letter:
                block[:, column.place] = column.values
        return block

    @property
    def varies_parameters(self) -> bool:
        """True when any run has parameters of its own."""
        return any(column.block == "p" for column in self.columns)

    def named(self, letter: str, k: int) -> Any:
        """Values named for q, u or z of run ``k``: by names, a whole block, or None."""
        values = {c.name: c.values[k % len(c.values)] for c in self.columns if c.block == letter}
        return values.get(letter, values or None)


class Reader:
    """Collects columns, and checks that they fit each other."""

    def __init__(self, model: LoadedModel, runs: int | None, seed: int) -> None:
        self.model, self.seed = model, sampling.checked_seed(seed)
        self.columns: list[Column] = []
        self.waiting: list[tuple[str, str, slice, sampling.Distribution]] = []
        # how many runs there are, and who said so
        self.runs: tuple[int, str] | None = None
        if runs is not None:
            if not isinstance(runs, int | np.integer) or runs < 1:
                raise ModelError(f"runs={brief(runs)} is not a number of runs: 1, 2, ...")
            self.runs = int(runs), "runs="
        self.covered: dict[tuple[str, int], str] = {}

    def add(self, block: str, name: str, where: str, place: slice, value: object) -> None:
        """One name with its values."""
        for k in range(place.start, place.stop):
            other = self.covered.setdefault((block, k), where)
            if other != where:
                raise ModelError(f"{WHAT[block]} '{name}' is given twice: by {other} and {where}")
        if callable(value) and not isinstance(value, sampling.Distribution):
            word = getattr(value, "__name__", "it")
            raise ModelError(
                f"{where} is a function; call it with its numbers, such as "
                f"cd.sample.{word if hasattr(sampling, word) else 'uniform'}(1, 2), and say runs="
            )
        if isinstance(value, sampling.Distribution):
            if place.stop - place.start != 1:
                raise ArgumentError(f"{where}: a distribution goes to one entry, such as 'base.px'")
            self.waiting.append((block, name, place, value))
            return
        array = self.shaped(where, numbers(where, value), place.stop - place.start)
        self._finite(block, where, place, array)
        self.columns.append(Column(block, name, place, np.ascontiguousarray(array)))

    def shaped(self, where: str, array: Array, size: int) -> Array:
        """(runs, size) or (1, size); says how many runs there are."""
        if size == 1 and (array.ndim == 0 or array.shape[-1:] != (1,)):
            array = array[..., None]
        if array.ndim == 2 and array.shape[1] == size and len(array):
            self._count(where, len(array))
            return array
        if array.shape != (size,):
            runs = self.runs[0] if self.runs else "runs"
            one = "one number" if size == 1 else f"({size},)"
            many = f"({runs},)" if size == 1 else f"({runs}, {size})"
            shape = array.shape[:-1] if size == 1 else array.shape
            raise ArgumentError(f"{where} has shape {shape}, expected {one} or {many}")
        return array[None]

    def _count(self, where: str, runs: int) -> None:
        if runs == 1:
            return
        if self.runs is None:
            self.runs = runs, where
        elif self.runs[0] != runs:
            raise ArgumentError(
                f"{where} has values for {runs} runs, {self.runs[1]} says {self.runs[0]}"
            )

    def _finite(self, block: str, where: str, place: slice, array: Array) -> None:
        bad = np.argwhere(~np.isfinite(array))
        if len(bad):
            run, k = bad[0].tolist()
            name = _entry(self.model, block, place.start + k)
            which = f" of run {run}" if len(array) > 1 else ""
            raise SolveError(f"{where}: '{name}'{which} is {array[run, k]}; it must be finite")

    def total(self) -> int:
        """Number of runs; draw the samples that were waiting for it."""
        if self.runs is None:
            raise ModelError(
                "nothing differs between the runs, or nothing says how many they are: give lists "
                "with one value per run, a plan such as vary=cd.sample.grid(...), or runs= with "
                "distributions"
            )
        for block, name, place, kind in self.waiting:
            values = sampling.drawn(name, kind, self.runs[0], self.seed)[:, None]
            self._finite(block, f"'{name}'", place, values)
            self.columns.append(Column(block, name, place, values))
        for column in self.columns:
            if column.block == "p":
                self.model._parameters.checked(column.name, column.values[:, 0], "run")
        return self.runs[0]


def _entry(model: LoadedModel, block: str, k: int) -> str:
    names = {"q": model.coordinates, "u": model.speeds, "z": model.internals, "r": model.inputs}
    return names[block][k] if block in names else list(model.parameters)[k]


def varied(
    model: LoadedModel,
    *,
    x0: object,
    q: object,
    u: object,
    z: object,
    parameters: Mapping[str, object] | None,
    inputs: Inputs | None,
    sample_time: float | None,
    vary: sampling.Plan | Mapping[str, object] | None,
    runs: int | None,
    seed: int,
    over: tuple[float, float],
) -> tuple[Varied, Signals]:
    """Variations between runs, and the inputs that do not vary.

    Args: as :func:`cardan.analyses.ensembles.ensemble` takes them; ``over`` is the span.

    Raises:
        ModelError: unknown names, something given twice, nothing that differs.
        ArgumentError: shapes that do not fit. SolveError: a value that is not finite.
    """
    reader = Reader(model, runs, seed)
    refuse_second(x0, {"q": q, "u": u, "z": z})
    ends = model.nq, model.nq + model.nu
    if x0 is not None:
        x = reader.shaped("x0", numbers("x0", x0), model.nx)
        q, u, z = np.split(x, ends, axis=1)
    for letter, value in (("q", q), ("u", u), ("z", z)):
        _state(reader, letter, value, "x0" if x0 is not None else letter)
    for name, value in named("parameters", parameters, "'mass': values").items():
        _parameter(reader, name, f"parameters={{'{name}': ...}}", value)
    shared = _inputs(reader, inputs)
    for name, column in _plan(vary).items():
        _named(reader, name, column)
    total = reader.total()
    input_signals = signals(model.manifest.inputs, shared, sample_time, over)
    start, _ = initial_state(model._layout, {}, {})
    base = dict(zip("quz", np.split(start, ends), strict=True))
    base |= {"p": model._parameters.vector, "r": input_signals.constants}
    variations = Varied(total, base, tuple(model.manifest.quaternions), tuple(reader.columns))
    _check_rotations(model, variations)
    for first in range(0, total if variations.varies_parameters else 0, SOME):
        model._parameters.judge(variations.part(first, min(first + SOME, total)).block("p"))
    return variations, input_signals


def _plan(vary: object) -> Mapping[str, Any]:
    """Name -> values or a distribution, out of ``vary``."""
    if isinstance(vary, sampling.Plan):
        return vary.values
    if callable(vary):
        raise ModelError(f"vary= is a function; call it, {SUCH}")
    if vary is not None and not isinstance(vary, Mapping):
        raise ModelError(
            f"vary={brief(vary)} says not what differs: give names with values, {SUCH}"
        )
    return named("vary", vary, "'mass': values")


def _state(reader: Reader, letter: str, value: object, where: str) -> None:
    """Coordinates, speeds or internal states, by names or as a block."""
    if value is None:
        return
    model = reader.model
    if not isinstance(value, Mapping):
        size = {"q": model.nq, "u": model.nu, "z": model.nz}[letter]
        if size or letter != "z":
            reader.add(letter, letter, where, slice(0, size), value)
        return
    places = model.manifest.slots(letter)
    for name, entry in value.items():
        here = f"{where}={{'{name}': ...}}"
        if name not in places:
            raise ModelError(f"{here}: {missing(model.manifest, letter, name, places)}")
        reader.add(letter, name, here, places[name], entry)


def _parameter(reader: Reader, name: str, where: str, value: object) -> None:
    parameters = reader.model._parameters
    # unknown and structural names are explained there
    k = list(parameters).index(name) if name in parameters else parameters.checked(name, 0.0).size
    reader.add("p", name, where, slice(k, k + 1), value)


def _inputs(reader: Reader, inputs: Inputs | None) -> dict[str, Any]:
    """Inputs that all runs share; those with a value per run become columns."""
    shared = {}
    for name, value in named("inputs", one_by_one(inputs), "'force': values").items():
        per_run = (isinstance(value, np.ndarray) and value.ndim > 0) or _is_row(value)
        input_names = reader.model.inputs
        if per_run or isinstance(value, sampling.Distribution):
            if name not in input_names:
                raise ModelError(f"inputs: there is no input '{name}'.{near(name, input_names)}")
            k = input_names.index(name)
            reader.add("r", name, f"inputs={{'{name}': ...}}", slice(k, k + 1), value)
        else:
            shared[name] = value
    return shared


def _is_row(value: object) -> bool:
    """True when it is a list of numbers, one per run; (times, values) are two lists."""
    return isinstance(value, list | tuple) and bool(value) and all(map(np.isscalar, value))


def _named(reader: Reader, name: str, column: Array) -> None:
    """A name of a plan: whatever of the model it is."""
    model = reader.model
    tables: dict[str, Callable[[], dict[str, slice]]] = {
        "q": lambda: _single(model.manifest.slots("q")),
        "u": lambda: {n: slice(k, k + 1) for k, n in enumerate(model.speeds)},
        "z": lambda: model.manifest.slots("z"),
        "p": lambda: {n: slice(k, k + 1) for k, n in enumerate(model.parameters)},
        "r": lambda: {n: slice(k, k + 1) for k, n in enumerate(model.inputs)},
    }
    places = {block: table() for block, table in tables.items()}
    # a name may be a coordinate and a parameter at once: never guess
    matches = [block for block, table in places.items() if name in table]
    if len(matches) > 1:
        options = " and a ".join(WHAT[block] for block in matches)
        raise ModelError(
            f"vary: '{name}' is a {options} here. Say which by q=, u=, z=, parameters= or inputs="
        )
    if not matches and name in model.manifest.structural:
        model._parameters.checked(name, 0.0)
    if not matches:
        part = component(model.manifest, name)
        if part:
            raise ModelError(f"vary: {part}")
        names = [name for table in places.values() for name in table]
        raise ModelError(
            f"vary: there is no coordinate, speed, parameter or input '{name}'.{near(name, names)}"
        )
    reader.add(matches[0], name, f"vary '{name}'", places[matches[0]][name], column)


def _single(places: Mapping[str, slice]) -> dict[str, slice]:
    return {name: place for name, place in places.items() if place.stop - place.start == 1}


def _check_rotations(model: LoadedModel, variations: Varied) -> None:
    """Refuse single components of quaternions, and quaternions whose length is not 1."""
    covered = {
        k for c in variations.columns if c.block == "q" for k in range(c.place.start, c.place.stop)
    }
    refuse_components(model.manifest, "q, vary", covered)
    if not covered.intersection(variations.quaternions):
        return
    for first in range(0, variations.runs, SOME):
        part = variations.part(first, min(first + SOME, variations.runs))
        check_units(model.manifest, part.raw_block("q"), first=first)
