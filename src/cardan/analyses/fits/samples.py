"""Measured samples of a motion, and what the model has in their place."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from ...arguments import Inputs
from ...arrays import Array
from ...errors import ArgumentError, DerivationError, ModelError, SolveError, brief, near
from ...records import dataclass
from ...runtime.calls.calling import numbers
from ...runtime.calls.loaded_function import LoadedFunction
from ...runtime.models.derivatives import Derivative
from ...runtime.models.loaded_model import LoadedModel
from ...schema.blocks import COORDINATES, Blocks
from ..identification.data import HEADING, names_of, read

TIME = "t"


@dataclass(frozen=True)
class Samples:
    """What was measured.

    Attributes:
        t: Times (nt,), ascending [s].
        formulas: What each channel measures, in names of the model.
        values: (nt, channels); NaN where nothing was measured.
        noise: Standard deviation of every channel, as far as it is known, else 1.
    """

    t: Array
    formulas: tuple[str, ...]
    values: Array
    noise: Array

    @property
    def present(self) -> Array:
        """True where there is a number (nt, channels)."""
        return np.isfinite(self.values)


def samples_of(
    model: LoadedModel,
    table: Mapping[str, object],
    measured: Mapping[str, object] | None,
    noise: float | Mapping[str, float] | None,
) -> Samples:
    """Samples as they are given to ``fit``.

    Raises:
        ArgumentError: no times, columns that do not fit together, unknown names.
    """
    _check_units(model, table, measured)
    t = numbers("fit: data: t", column(table, TIME))
    if t.ndim != 1 or len(t) < 2 or not np.isfinite(t).all() or not (np.diff(t) > 0).all():
        raise ArgumentError(
            "fit: data: t: give two times or more, ascending and finite; no cell of it is blank"
        )
    channels: dict[str, object] = {}
    if measured is None:
        names = {*model.coordinates, *model.speeds, *model.internals, *_outputs(model)}
        plain = names_of(list(table), {}, names)
        channels = {plain[head]: x for head, x in table.items() if plain[head] in names}
        if not channels:
            raise ArgumentError(
                "fit: no column of data is a coordinate, speed or output of the model; say what "
                "they are by measured={'hand.x - 0.1*elbow': 'column'}"
            )
    for formula, source in (measured or {}).items():
        if isinstance(source, str):
            source = column(table, source)
        channels[formula] = source
    values = np.empty((len(t), len(channels)))
    for k, (formula, samples) in enumerate(channels.items()):
        array = numbers(f"fit: measured '{formula}'", samples)
        if array.shape != t.shape:
            raise ArgumentError(
                f"fit: measured '{formula}' has shape {array.shape}, expected ({len(t)},)"
            )
        values[:, k] = array
    return Samples(t, tuple(channels), values, _noise(tuple(channels), noise))


def inputs_of(
    model: LoadedModel, table: Mapping[str, object], inputs: Inputs | None
) -> Inputs | None:
    """Inputs as ``simulate`` takes them: as they are given, else columns of their names."""
    stated = inputs or {}
    named = {n for key in stated for n in (key if isinstance(key, tuple) else (key,))}
    present = set(names_of(list(table), {}, model.inputs).values())
    columns = [name for name in model.inputs if name in present and name not in named]
    t = column(table, TIME) if columns else None
    return {name: (t, column(table, name)) for name in columns} | dict(stated) or None


def column(table: Mapping[str, object], name: str) -> object:
    """A column by its name, with the unit behind it or without.

    Raises:
        ArgumentError: there is none.
    """
    heads = [name, *(head for head, plain in names_of(list(table), {}).items() if plain == name)]
    match = HEADING.fullmatch(name)
    if match is not None:
        heads.append(match[1])
    key = next((head for head in heads if head in table), None)
    if key is None:
        columns = ", ".join(list(table)[:12]) or "none"
        what = (
            f" of times: call it 't' or 't [s]'. Its columns: {columns}"
            if name == TIME
            else f".{near(name, table)}"
        )
        raise ArgumentError(f"fit: data has no column '{name}'{what}")
    return table[key]


def _check_units(
    model: LoadedModel, table: Mapping[str, object], measured: Mapping[str, object] | None
) -> None:
    """Refuse headings with other units than those of the names.

    Raises:
        ArgumentError: there is one.
    """
    rows = model.manifest
    units = {TIME: "s"} | {
        str(row.name): str(row.unit)
        for block in (*map(rows.block, "quzr"), rows.outputs)
        for row in block
    }
    # a column under another name has the unit of what it measures
    units |= {
        source: units[formula]
        for formula, source in (measured or {}).items()
        if isinstance(source, str) and formula in units
    }
    names_of(list(table), units)


def table_of(data: object) -> dict[str, object]:
    """Columns by their headings.

    Raises:
        ArgumentError: neither columns nor a file of them.
    """
    if isinstance(data, str | Path):
        return dict(read(Path(data)))
    if isinstance(data, Mapping):
        return {str(name): value for name, value in data.items()}
    raise ArgumentError(
        f"fit: data={brief(data)}: give a mapping with t and columns, or a file .csv"
    )


def _outputs(model: LoadedModel) -> list[str]:
    return [str(row.name) for row in model.manifest.outputs]


def _noise(formulas: tuple[str, ...], noise: float | Mapping[str, float] | None) -> Array:
    stated = {} if noise is None else noise
    if not isinstance(stated, Mapping):
        stated = dict.fromkeys(formulas, stated)
    unknown = [name for name in stated if name not in formulas]
    if unknown:
        raise ArgumentError(
            f"fit: noise of '{unknown[0]}': it is not measured.{near(unknown[0], formulas)}"
        )
    values = numbers("fit: noise", [stated.get(name, 1.0) for name in formulas])
    if not ((values > 0) & np.isfinite(values)).all():
        raise ArgumentError("fit: noise: standard deviations are positive numbers")
    return values


class Channels:
    """What a model has in the place of measurements, with derivatives.

    Args:
        model: The model, with parameters of the time.
        formulas: What is measured.
        parameters: Names of those that it is differentiated by.
    """

    def __init__(
        self, model: LoadedModel, formulas: tuple[str, ...], parameters: tuple[str, ...]
    ) -> None:
        self.model, self.formulas = model, formulas
        blocks = {COORDINATES: model.nq, "u": model.nu, "z": model.nz}
        # of parameters that are called like a block there are no fits
        wrt = Blocks((*[block for block, size in blocks.items() if size], *parameters))
        self._values, self._slopes = list[LoadedFunction](), list[Derivative]()
        for formula in formulas:
            try:
                self._values.append(model._function("expression", formula))
            except (ModelError, DerivationError) as problem:
                raise ModelError(f"fit: measured='{formula}': {problem}") from problem
            self._slopes.append(model.derivative(("expression", formula), wrt=wrt))
        self._state_blocks = len(wrt) - len(parameters)

    def __call__(
        self, t: Array, x: Array, r: Array, s: Array, changes: Array, by_parameters: Array
    ) -> tuple[Array, Array]:
        """Values (m, channels) and their changes (m, channels, k).

        Args:
            t, x, r, s: Times (m,), states (m, nx), inputs (m, nr) and modes (m, ns).
            changes: Of the states along k directions (m, k, nx).
            by_parameters: Of the parameters along them (k, parameters).
        """
        q, u, z = self.model.parts_of(x)
        shape = (len(t), len(self.formulas))
        values, slopes = np.empty(shape), np.empty((*shape, changes.shape[1]))
        for k, (function, slope) in enumerate(zip(self._values, self._slopes, strict=True)):
            values[:, k] = function.caller(None, t, q, u, r, z, s)
            parts = slope(q=q, u=u, z=z, s=s, t=t, r=r)
            by_x = np.concatenate(parts[: self._state_blocks], axis=-1)
            slopes[:, k] = np.einsum("mki,mi->mk", changes, by_x)
            if len(parts) > self._state_blocks:
                by_p = np.stack(parts[self._state_blocks :], axis=-1)
                slopes[:, k] += by_p @ by_parameters.T
        if not np.isfinite(values).all():
            raise SolveError("fit: a measured quantity has no finite value along the motion")
        return values, slopes
