"""Runs as netCDF files, through SciPy alone.

Dimensions ``time``, ``coordinate``, ``speed``, ``internal_state``, ``mode``, ``input``, ``source``,
``step``, ``event``, ``body``, ``constraint``; names of the entries stand in the attribute ``names``
of every variable, units in ``units``. The manifest (names, units, joints, shapes; no functions) is
the attribute ``manifest``, as JSON.
"""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import __version__
from ..errors import CardanError, ModelError
from ..ir.rows import dumped, opened
from . import balance
from .calling import Array
from .conduct import Conduct
from .dense import Dense
from .events import Happened
from .ledger import Ledger
from .trajectory import Trajectory

if TYPE_CHECKING:
    from .compiled import CompiledModel

FORMAT = 1
DENSE = ("spreads", "increments")  # what is between, of quaternions or of their increments
LIMIT = 2**31 - 4  # bytes of one variable that every netCDF-3 reader takes
ENDINGS = ("", ".nc", ".nc3", ".cdf")
KEPT = ("kinetic", "potential", "constraints", "multipliers", "losses")
LEFT_OUT = ("functions", "sha256", "available")
COLUMNS = "largest before projection, when, largest after it, when"


def save(motion: Trajectory, path: Path) -> Path:
    """Write a run; a file with its name is replaced in one step.

    Raises:
        ModelError: a variable too large for the format, a directory that does not exist, or the
            ending of another format.
    """
    from scipy.io import netcdf_file

    if path.suffix not in ENDINGS:
        raise ModelError(
            f"{path}: runs are written as netCDF, whose files end in .nc; motion.to_xarray() or "
            "motion.x give the numbers to writers of other formats"
        )

    if not path.parent.is_dir():
        raise ModelError(f"{path}: the directory {path.parent} does not exist")
    variables = _variables(motion)
    for name, (_, values, _) in variables.items():
        if values.nbytes > LIMIT:
            raise ModelError(
                f"{path}: '{name}' takes {values.nbytes / 1e9:.1f} GB, netCDF-3 holds 2 GB in one "
                "variable. Simulate with an array of output times to keep fewer of them"
            )
    with replaced(path) as new, netcdf_file(new, "w", version=2) as file:
        _attributes(file, motion)
        _write(file, variables)
    return path


@contextmanager
def replaced(path: Path) -> Iterator[str]:
    """A new file that takes the place of another one, or of none, once it is whole."""
    handle, new = tempfile.mkstemp(dir=path.parent, prefix=".cardan-", suffix=".nc")
    os.close(handle)
    try:
        yield new
        os.chmod(new, 0o666 & ~_umask())
        os.replace(new, path)
    except BaseException:
        Path(new).unlink(missing_ok=True)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


Variables = dict[str, tuple[tuple[str, ...], Array, dict[str, str]]]


def _variables(motion: Trajectory) -> Variables:
    """Name -> (dimensions, values, attributes)."""
    manifest = motion.manifest

    def listed(key: str) -> dict[str, str]:
        return {
            "names": _list(row["name"] for row in manifest[key]),
            "units": _list(row.get("unit", "") for row in manifest[key]),
        }

    found: Variables = {
        "time": (("time",), motion.t, {"units": "s"}),
        "q": (("time", "coordinate"), motion.q, listed("coordinates")),
        "u": (("time", "speed"), motion.u, listed("speeds")),
        "r": (("time", "input"), motion.r, listed("inputs")),
    }
    if manifest["z"]:
        found["z"] = (("time", "internal_state"), motion.z, listed("z"))
    if manifest["s"]:
        found["s"] = (("time", "mode"), motion.s, listed("s"))
    if len(motion.happened.log):
        about = {"columns": "when, 1 for every event that happened, x and s before, x and s behind"}
        found["events"] = (("event", "event_column"), motion.happened.log, about)
        losses = balance.losses(motion)
        if len(losses):
            found["losses"] = (("event",), losses, {"units": "J"})
    if motion.sources:
        names = {"names": _list(motion.sources), "units": "J"}
        found["work"] = (("time", "source"), motion.given, names)
    if motion.dense is not None:
        found[DENSE[motion.dense.charted]] = (("step", "row", "entry"), motion.dense.spreads, {})
    available = set(manifest.get("available", ()))
    if "kinetic" in motion.stored or "energy" in available:
        found["kinetic"] = (("time",), motion.energy.kinetic, {"units": "J"})
        found["potential"] = (("time",), motion.energy.potential, {"units": "J"})
    if motion.ledger is not None:
        found["ledger"] = (("constraint", "column"), motion.ledger.table, {"columns": COLUMNS})
    if "constraints" in motion.stored or ({"constraints"} <= available and motion.constraints):
        residuals = np.stack([*motion.constraints.values()], axis=-1)
        found["constraints"] = (("time", "position_constraint"), residuals, {})
    if "multipliers" in motion.stored:
        found["multipliers"] = (("time", "multiplier"), motion.stored["multipliers"], {})
    for k, body in enumerate(_bodies(motion)):
        pose = motion.pose(body)[:, :3, :]
        found[f"pose_{k}"] = (("time", "axis", "column"), pose, {"frame": body})
    return found


def _bodies(motion: Trajectory) -> list[str]:
    """Frames whose motion goes into the file: one of every body that moves."""
    bodies = [body["parts"][0] for body in motion.manifest["bodies"] if body["parts"]]
    if motion.model is None:
        return [body for body in bodies if f"pose {body}" in motion.stored]
    if "pose" not in motion.manifest.get("available", ()):
        return []
    motion.model.prepare(*(("pose", body) for body in bodies))
    return bodies


def _list(names: Any) -> str:
    return json.dumps(list(names), ensure_ascii=True)


def _attributes(file: Any, motion: Trajectory) -> None:
    """What the run says about itself."""
    kept = {k: v for k, v in motion.manifest.items() if k not in LEFT_OUT}
    file.title = f"motion of {motion.manifest['name']}".encode("ascii", "replace")
    file.source = f"cardan {__version__}".encode()
    file.cardan_run = FORMAT
    file.manifest = dumped(kept).encode("ascii")
    file.conduct = json.dumps(asdict(motion.conduct)).encode("ascii")
    scene = {name: np.asarray(values).tolist() for name, values in motion.scene.items()}
    file.scene = json.dumps(scene).encode("ascii")
    file.happenings = json.dumps(motion.happened.rows).encode("ascii")
    file.sources = json.dumps(motion.sources).encode("ascii")


def _write(file: Any, variables: Variables) -> None:
    for name, (dimensions, values, attributes) in variables.items():
        for dimension, size in zip(dimensions, values.shape, strict=True):
            # the format reads a length of 0 as "grows"
            if dimension not in file.dimensions and size:
                file.createDimension(dimension, size)
        if 0 in values.shape:
            continue
        variable = file.createVariable(name, "f8", dimensions)
        variable[:] = values
        for key, text in attributes.items():
            setattr(variable, key, text.encode("ascii", "backslashreplace"))


def load(path: str | Path, model: CompiledModel | None = None) -> Trajectory:
    """Read a run that :meth:`.Trajectory.save` wrote.

    Args:
        path: The file.
        model: The compiled model, for what needs it (reactions, outputs, further poses).

    Raises:
        ModelError: not a run of cardan, a newer format, or a model with other coordinates.
    """
    path = Path(path)
    values, notes, poses = _read(path)
    manifest = opened(json.loads(notes["manifest"]))
    for key in ("available", "z", "s"):
        manifest.setdefault(key, [])
    if model is not None:
        _compare(path, manifest, model)
        manifest = model.manifest
    t = values["time"]

    def block(name: str, width: int) -> Array:
        return values.get(name, np.zeros((len(t), width)))

    q = block("q", len(manifest["coordinates"]))
    u = block("u", len(manifest["speeds"]))
    z, s = block("z", len(manifest["z"])), block("s", len(manifest["s"]))
    states = np.concatenate([q, u, z], axis=1)
    given = block("work", 0)
    sources = json.loads(notes["sources"])
    dense = None
    for charted, name in enumerate(DENSE):
        if name in values:
            rows = np.concatenate([states, given], axis=1)
            quaternions = tuple(manifest["quaternions"])
            dense = Dense(t, rows, values[name], quaternions, charted=charted > 0)
    conduct = json.loads(notes["conduct"])
    conduct["defaulted"] = tuple(conduct["defaulted"])
    stored = {k: values[k] for k in KEPT if k in values}
    ledger = Ledger.of(manifest["multipliers"], values["ledger"]) if "ledger" in values else None
    happenings = tuple(json.loads(notes["happenings"]))
    nothing = np.zeros((0, 1 + len(happenings) + 2 * (states.shape[1] + s.shape[1])))
    return Trajectory(
        t=t,
        x=states,
        r=block("r", len(manifest["inputs"])),
        given=given,
        sources=None if sources is None else tuple(sources),
        manifest=manifest,
        conduct=Conduct(**conduct),
        model=model,
        dense=dense,
        stored=stored | poses,
        numbers={k: np.array(v) for k, v in json.loads(notes["scene"]).items()},
        ledger=ledger,
        happened=Happened(s, happenings, values.get("events", nothing)),
    )


def _read(path: Path) -> tuple[dict[str, Array], dict[str, bytes], dict[str, Array]]:
    """Variables, attributes and poses of a file."""
    from scipy.io import netcdf_file

    try:
        with netcdf_file(str(path), "r", mmap=False) as file:
            if getattr(file, "cardan_run", None) != FORMAT:
                raise ModelError(f"{path} is no run of cardan, or of a newer one than this")
            notes = {k: getattr(file, k) for k in ("manifest", "conduct", "scene", "sources")}
            notes["happenings"] = getattr(file, "happenings", b"[]")
            values, poses = {}, {}
            for name, variable in file.variables.items():
                numbers = np.array(variable[:], dtype=np.float64)
                if name.startswith("pose_"):
                    last = np.broadcast_to([0.0, 0.0, 0.0, 1.0], (len(numbers), 1, 4))
                    key = f"pose {variable.frame.decode('ascii')}"
                    poses[key] = np.concatenate([numbers, last], axis=1)
                else:
                    values[name] = numbers
    except FileNotFoundError:
        raise ModelError(f"{path}: there is no such file") from None
    except (OSError, TypeError, ValueError, AttributeError, KeyError, IndexError) as error:
        if isinstance(error, CardanError):
            raise
        raise ModelError(f"{path} is no run that cardan can read: {error}") from error
    return values, notes, poses


def _compare(path: Path, manifest: dict[str, Any], model: CompiledModel) -> None:
    for key in ("coordinates", "speeds", "inputs", "z", "s"):
        here = [row["name"] for row in manifest[key]]
        there = [row["name"] for row in model.manifest[key]]
        if here != there:
            raise ModelError(
                f"{path} is a run of another model: its {key} are {', '.join(here) or 'none'}; "
                f"those of '{model.name}' are {', '.join(there) or 'none'}"
            )
