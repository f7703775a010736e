"""Measured data: times, coordinates, forces, and quantities derived from them."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, final

import numpy as np

from ... import regular_file
from ...arrays import Array
from ...atomic_file import written
from ...errors import ArgumentError, brief, counted, near
from ...records import dataclass
from ...runtime import formats
from ...runtime.calls.calling import numbers
from ...runtime.trajectory.storage import load
from ...runtime.trajectory.trajectory import TrajectoryRecord
from . import smoothing

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

BLOCKS = ("q", "u", "udot", "tau", "r", "z")
# a name and a unit, as saved runs have them above columns
HEADING = re.compile(r"(.+) \[([^\[\]]*)\]")
FORCES = {"rad/s": "N*m", "m/s": "N"}  # by the unit of a speed
# samples left out at either end where derivatives come from a spline
ENDS = 6


@final
@dataclass(frozen=True, eq=False)
class Data:
    """A motion and the forces that made it.

    Attributes:
        t: Times (nt,) [s].
        q, u, udot: (nt, nq), (nt, nu), (nt, nu).
        tau: Forces of the actuators along the speeds (nt, nu) [N m], [N].
        r: Inputs (nt, nr).
        z: Internal states of force elements (nt, nz).
    """

    t: Array
    q: Array
    u: Array
    udot: Array
    tau: Array
    r: Array
    z: Array

    def only(self, rows: object) -> Data:
        """Some of the samples."""
        return replace(self, **{name: value[rows] for name, value in vars(self).items()})


def columns(model: LoadedModel) -> dict[str, tuple[str, ...]]:
    """Names of the entries of every block as columns of a table have them.

    ``elbow``, ``elbow.u``, ``elbow.udot``, ``elbow.tau``; inputs and internal states by their
    names.
    """

    def along(word: str) -> tuple[str, ...]:
        heads = (row.joint for row in model.manifest.speeds)
        return tuple(
            name.replace(f"{joint}.u", f"{joint}.{word}", 1) if joint else f"{name}.{word}"
            for name, joint in zip(model.speeds, heads, strict=True)
        )

    named = {"q": model.coordinates, "u": model.speeds, "r": model.inputs}
    states = tuple(entry.name for entry in model.manifest.z)
    return named | {"udot": along("udot"), "tau": along("tau"), "z": states}


def read(path: Path) -> dict[str, Array]:
    """Columns of a table of comma-separated values, by the names in its first line.

    Raises:
        ArgumentError: no such file, or no regular one; no numbers under names.
    """
    try:
        reader = csv.reader(io.StringIO(regular_file.text(path), newline=""))
        rows = [(reader.line_num, row) for row in reader if row and not row[0].startswith("#")]
    except OSError as error:
        raise ArgumentError(f"{path} cannot be read: {error.strerror}") from error
    except (UnicodeDecodeError, csv.Error):
        raise ArgumentError(f"{path} is not a table of text") from None
    if len(rows) < 2:
        raise ArgumentError(f"{path}: give a line of names, such as t,elbow, and lines of numbers")
    (first, heads), *lines = rows
    names = [name.strip() for name in heads]
    twice = [name for name in names if names.count(name) > 1]
    if twice:
        raise ArgumentError(f"{path}, line {first}: '{twice[0]}' is the name of several columns")
    values = np.array([_numbers(path, line, names, cells) for line, cells in lines])
    return dict(zip(names, values.T, strict=True))


def _numbers(path: Path, line: int, names: Sequence[str], cells: Sequence[str]) -> list[float]:
    """Numbers of a line of a table; NaN of cells that are blank: nothing was measured.

    Raises:
        ArgumentError: a cell holds no number, or there are more or fewer than names.
    """
    if len(cells) != len(names):
        raise ArgumentError(
            f"{path}, line {line}: {counted(len(cells), 'cell')}, but the first line names "
            f"{counted(len(names), 'column')}: {', '.join(names[:12])}"
        )
    values = list[float]()
    for name, cell in zip(names, cells, strict=True):
        try:
            values.append(float(cell) if cell.strip() else np.nan)
        except ValueError:
            hint = ", with a point instead of a comma" if "," in cell else ""
            raise ArgumentError(
                f"{path}, line {line}, column '{name}': {brief(cell)} is not a number{hint}; leave "
                "the cell blank, or write nan, where nothing was measured"
            ) from None
    return values


def write(path: Path, table: Mapping[str, Array]) -> Path:
    """Write columns as comma-separated values with all their digits."""
    text = io.StringIO()
    out = csv.writer(text, lineterminator="\n")
    out.writerow(table)
    out.writerows([[repr(float(x)) for x in row] for row in zip(*table.values(), strict=True)])
    return written(path, text.getvalue())


def measured(
    model: LoadedModel,
    data: object,
    *,
    cutoff: float | None = None,
    period: float | None = None,
    harmonics: int = 5,
    ends: bool = False,
) -> Data:
    """Data with speeds and accelerations, as far as they were not measured.

    Args:
        model: Whose motion it is.
        data: A Trajectory, a path (of a saved run, or a table .csv), or a mapping with ``t`` and
            blocks ``q``, ``u``, ``udot``, ``tau``, ``r``, ``z`` (nt, ...) or columns such as
            ``elbow`` and ``elbow.tau``. Inputs and internal states that are missing are those at
            the start of a run.
        cutoff: [Hz] above which coordinates are noise: they are filtered, forward and backward,
            before they are differentiated.
        period, harmonics: Of a periodic motion [s]: coordinates become a Fourier series, which is
            differentiated exactly.
        ends: Keep the samples at either end too, whose derivatives are less exact; of a filter they
            are not kept.

    Raises:
        ArgumentError: missing or unknown columns, shapes that do not fit, uneven times.
    """
    if isinstance(data, str | Path):
        if not str(data).strip():
            raise ArgumentError("data='' names no file; give the path of a table or of a run")
        path = Path(data)
        data = load(path, model) if path.suffix in formats.readable() else read(path)
    blocks = _of_run(data) if isinstance(data, TrajectoryRecord) else _of_table(model, data)
    count = len(blocks["t"])
    starts = {name: np.tile(model._layout.start(name), (count, 1)) for name in ("r", "z")}
    blocks_with_defaults = {"tau": np.zeros((count, model.nu)), **starts, **blocks}
    _check(model, blocks_with_defaults)
    return _complete(model, blocks_with_defaults, cutoff, period, harmonics, ends)


def _of_run(run: TrajectoryRecord) -> dict[str, Array]:
    """A run: its forces are those of the model's own elements, at its inputs."""
    increasing = np.concatenate([[True], np.diff(run.t) > 0])
    return {
        "t": run.t[increasing],
        "q": run.q[increasing],
        "u": run.u[increasing],
        "r": run.r[increasing],
        "z": run.z[increasing],
    }


def _of_table(model: LoadedModel, data: Any) -> dict[str, Array]:
    """Blocks of a mapping, which may have columns in their place."""
    if not hasattr(data, "keys"):
        raise ArgumentError(
            "data: a Trajectory, a file, or a mapping with 't', 'q' and 'tau' is wanted, not "
            f"{type(data).__name__}"
        )
    plain = _without_units(model, [str(key) for key in data.keys()])  # noqa: SIM118
    samples = {plain[str(key)]: numbers(f"data: '{key}'", data[key]) for key in data.keys()}  # noqa: SIM118
    if "t" not in samples or samples["t"].ndim != 1:
        raise ArgumentError(
            f"data: times (nt,) [s] are missing: call their column 't' or 't [s]'. There "
            f"{'is' if len(samples) == 1 else 'are'}: {', '.join(list(samples)[:12]) or 'nothing'}"
        )
    named = columns(model)
    names = ["t", *BLOCKS, *(name for block in BLOCKS for name in named[block])]
    for key in samples:
        if key not in names:
            raise ArgumentError(f"data: '{key}' is not a column of this model.{near(key, names)}")
        if key not in BLOCKS and samples[key].shape != samples["t"].shape:
            raise ArgumentError(
                f"data: '{key}' has shape {samples[key].shape}, t has {samples['t'].shape}"
            )
    blocks = {"t": samples["t"]}
    for block in BLOCKS:
        if block in samples:
            blocks[block] = samples[block]
            continue
        have = [name for name in named[block] if name in samples]
        # passive joints bear no force of an actuator, so that their column may be missing
        if have and (len(have) == len(named[block]) or block == "tau"):
            nothing = np.zeros(len(samples["t"]))
            blocks[block] = np.column_stack([samples.get(name, nothing) for name in named[block]])
        elif have or block == "q":
            missing = next(name for name in named[block] if name not in samples)
            raise ArgumentError(f"data: column '{missing}' is missing.{near(missing, samples)}")
    return blocks


def _without_units(model: LoadedModel, heads: Sequence[str]) -> dict[str, str]:
    """Headings of columns, such as ``elbow [rad]``, and the names in them.

    Raises:
        ArgumentError: another unit than that of the model.
    """
    named = columns(model)
    units = {"t": "s"} | {
        name: row.unit
        for block, rows in (("q", "q"), ("u", "u"), ("r", "r"), ("z", "z"))
        for name, row in zip(named[block], model.manifest.block(rows), strict=True)
    }
    for name, tau, row in zip(named["udot"], named["tau"], model.manifest.speeds, strict=True):
        units[name] = f"{row.unit}^2" if row.unit.endswith("/s") else ""
        units[tau] = FORCES.get(row.unit, "")
    every = {"t", *BLOCKS, *(name for names in named.values() for name in names)}
    return names_of(heads, units, every)


def names_of(
    heads: Sequence[str], units: Mapping[str, str], every: Collection[str] = ()
) -> dict[str, str]:
    """Headings of columns, with units behind them or not, and the names in them.

    Args:
        heads: As they are written.
        units: Name -> unit that its column has.
        every: Names that may look like headings with units.

    Raises:
        ArgumentError: another unit than that of the name.
    """
    plain = {}
    for head in heads:
        match = None if head in every else HEADING.fullmatch(head)
        plain[head] = head if match is None else match[1]
        expected = units.get(plain[head], "")
        if match is not None and expected and _bare(match[2]) != _bare(expected):
            raise ArgumentError(
                f"data: '{head}': '{plain[head]}' is in {expected}; convert it, and leave the unit "
                "out or state this one"
            )
    return plain


def _bare(unit: str) -> str:
    """A unit without signs of products: N*m, N m and Nm are one."""
    return re.sub(r"[\s*·]", "", unit)


def _check(model: LoadedModel, blocks: Mapping[str, Array]) -> None:
    count = len(blocks["t"])
    sizes = {"q": model.nq, "u": model.nu, "udot": model.nu, "tau": model.nu}
    sizes |= {"r": model.nr, "z": model.nz}
    for block, value in blocks.items():
        if block != "t" and value.shape != (count, sizes[block]):
            raise ArgumentError(
                f"data: {block} has shape {value.shape}, expected ({count}, {sizes[block]}): a row "
                "for every time"
            )
        if not np.isfinite(value).all():
            raise ArgumentError(
                f"data: {block} holds numbers that are not finite: blank cells or nan; leave those "
                "lines out"
            )
    if np.any(np.diff(blocks["t"]) <= 0):
        raise ArgumentError("data: times do not increase")


def _complete(
    model: LoadedModel,
    blocks: dict[str, Array],
    cutoff: float | None,
    period: float | None,
    harmonics: int,
    ends: bool,
) -> Data:
    t, plain = blocks["t"], is_plain(model)
    if period is not None:
        if not plain:
            raise ArgumentError(
                f"period=: model '{model.name}' has coordinates that are not angles or lengths, "
                "and no Fourier series; give cutoff= or measured speeds"
            )
        q, u, udot = smoothing.series(t, blocks["q"], period, harmonics)
        return Data(t, q, u, udot, blocks["tau"], blocks["r"], blocks["z"])
    complete = "u" in blocks and "udot" in blocks
    if cutoff is not None and not complete:
        word = "u" if "u" in blocks else "q"
        blocks[word] = smoothing.lowpass(t, blocks[word], cutoff)
    u = blocks["u"] if "u" in blocks else speeds(model, t, blocks["q"], blocks["r"])
    udot = blocks["udot"] if "udot" in blocks else smoothing.derivative(t, u)
    data = Data(t, blocks["q"], u, udot, blocks["tau"], blocks["r"], blocks["z"])
    if complete or (ends and cutoff is None):
        return data
    cut = ENDS if cutoff is None else max(ENDS, int(1 / (cutoff * smoothing.step_of(t, "cutoff="))))
    return data.only(slice(cut, -cut))


def is_plain(model: LoadedModel) -> bool:
    """True when speeds are the rates of coordinates, one by one."""
    if model.nq != model.nu:
        return False
    rng = np.random.default_rng(0)
    q, u = model.split(model.random_state(rng, (2,)))
    return bool(np.allclose(model.qdot(q, u, t=0.3), u, rtol=1e-12, atol=1e-12))


def speeds(model: LoadedModel, t: Array, q: Array, r: Array) -> Array:
    """Speeds (nt, nu) of coordinates (nt, nq): what N u + n = qdot leaves."""
    rates = smoothing.derivative(t, q)
    if is_plain(model):
        return rates
    arguments: dict[str, Any] = {"t": t, "r": r if r.shape[1] else None}
    still = model.qdot(q, np.zeros((len(t), model.nu)), **arguments)
    ways = [model.qdot(q, np.eye(model.nu)[k], **arguments) - still for k in range(model.nu)]
    matrix = np.stack(ways, axis=-1)
    return np.asarray((np.linalg.pinv(matrix) @ (rates - still)[..., None])[..., 0])


def named_columns(
    model: LoadedModel, t: Array, blocks: Mapping[str, Array], skip: Sequence[str] = ()
) -> dict[str, Array]:
    """A table of blocks by the names of columns."""
    table = {"t": t}
    for block, names in columns(model).items():
        if block in blocks and block not in skip:
            table |= {name: blocks[block][:, k] for k, name in enumerate(names)}
    return table
