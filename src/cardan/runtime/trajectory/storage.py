"""Runs as files: what stands in them, whatever their format.

Dimensions ``time``, ``coordinate``, ``speed``, ``internal_state``, ``mode``, ``input``, ``source``,
``step``, ``event``, ``constraint``; names of the entries stand in the attribute ``names`` of every
variable, units in ``units``. The manifest (names, units, joints, shapes; no functions) is the
attribute ``manifest``, as JSON; ``sha256`` tells whether all of it is what was saved.
"""

from __future__ import annotations

import json
import warnings
from collections.abc import Iterable, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arguments import checked
from ...arrays import Array
from ...errors import ModelError, ModelWarning
from ...schema.fields import Record, dumped
from ...schema.manifest import BLOCKS, Manifest
from ...schema.rows import column
from ...version import RUN
from .. import formats
from ..formats.contents import Contents, Variable
from ..models.finite_elements import superelements
from . import energy_balance, motion_schema
from .closure_errors import Ledger
from .dense_output import Dense
from .event_log import EventLog
from .histories import COMPUTED, computed
from .input_history import PiecewiseInput, Recorded
from .solver_info import SolverInfo
from .trajectory import TrajectoryRecord

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel

NOTES = ("manifest", "conduct", "scene", "happenings", "sources", "signals")
DENSE = ("spreads", "increments")  # what is between, of quaternions or of their increments
STORED = (
    "kinetic", "potential", "constraints", "multipliers", "losses", "parameters", *COMPUTED,
)  # fmt: skip
LEFT_OUT = ("functions", "sha256", "available", "finite_elements")
COLUMNS = "largest before projection, when, largest after it, when"
# entries of a pose (3, 4): rotation matrix and position [m]
POSE = [f"R{i}{j}" if j < 4 else f"p{'xyz'[i - 1]}" for i in (1, 2, 3) for j in (1, 2, 3, 4)]
FEWER = "Simulate with an array of output times to keep fewer of them, or take .npz or .nc4"


def contents(motion: TrajectoryRecord) -> Contents:
    """Everything of a run but its model, as files have it."""
    return Contents(_variables(motion), _notes(motion))


def _variables(motion: TrajectoryRecord) -> dict[str, Variable]:
    """Everything that is numbers."""
    manifest = motion.manifest

    def listed(key: str) -> dict[str, str]:
        return _about(manifest.block(key))

    variables = {
        "time": Variable(("time",), motion.t, {"units": "s"}),
        "q": Variable(("time", "coordinate"), motion.q, listed("q")),
        "u": Variable(("time", "speed"), motion.u, listed("u")),
        "r": Variable(("time", "input"), motion.r, listed("r")),
    }
    if (p := motion.parameters) is not None and len(p):
        variables["parameters"] = Variable(("parameter",), p, listed("p"))
    if manifest.z:
        variables["z"] = Variable(("time", "internal_state"), motion.z, listed("z"))
    if manifest.s:
        variables["s"] = Variable(("time", "mode"), motion.s, listed("s"))
    if len(motion.event_log.log):
        about = {"columns": "when, 1 for every event that happened, x and s before, x and s behind"}
        variables["events"] = Variable(("event", "event_column"), motion.event_log.log, about)
        losses = energy_balance.losses(motion)
        if len(losses):
            variables["losses"] = Variable(("event",), losses, {"units": "J"})
    if motion.sources:
        names = {"names": _list(f"{name}.work" for name in motion.sources), "units": "J"}
        variables["work"] = Variable(("time", "source"), motion.work_done, names)
    if motion.dense is not None:
        axes = ("step", "row", "entry")
        variables[DENSE[motion.dense.charted]] = Variable(axes, motion.dense.spreads)
    return {**variables, **_signals(motion.inputs_at), **_computed(motion), **_surfaces(motion)}


def _surfaces(motion: TrajectoryRecord) -> dict[str, Variable]:
    """Surfaces of superelements: points, shapes, and what is between the points."""
    return {
        name: Variable(tuple(f"{name}_{k}" for k in range(values.ndim)), values.astype(np.float64))
        for name, values in superelements.arrays_of_run(motion).items()
        # what has no numbers stands in no file
        if values.size
    }


def _computed(motion: TrajectoryRecord) -> dict[str, Variable]:
    """Histories computed from the states by the model."""
    variables = {}
    manifest, available = motion.manifest, set(motion.manifest.available)
    if "kinetic" in motion.stored or "energy" in available:
        variables["kinetic"] = Variable(("time",), motion.energy.kinetic, {"units": "J"})
        variables["potential"] = Variable(("time",), motion.energy.potential, {"units": "J"})
    for name, entry in COMPUTED.items():
        rows = manifest.outputs if name == "outputs" else manifest.element_forces
        if rows and (name in motion.stored or name in available):
            table = computed(motion, name, name)
            variables[name] = Variable(("time", entry), table, _about(rows))
    if motion.ledger is not None:
        table = motion.ledger.table
        variables["ledger"] = Variable(("constraint", "column"), table, {"columns": COLUMNS})
    if "constraints" in motion.stored or ({"constraints"} <= available and motion.constraints):
        residuals = motion.constraints
        names = {"names": _list(f"{name}.residual" for name in residuals)}
        table = np.stack([*residuals.values()], axis=-1)
        variables["constraints"] = Variable(("time", "position_constraint"), table, names)
    if "multipliers" in motion.stored:
        forces = motion.stored["multipliers"]
        about = _about(manifest.multipliers)
        variables["multipliers"] = Variable(("time", "multiplier"), forces, about)
    for k, body in enumerate(_bodies(motion)):
        pose = motion.pose(body)[:, :3, :]
        entries = [f"{body}.pose.{entry}" for entry in POSE]
        units = ["m" if entry.startswith("p") else "1" for entry in POSE]
        about = {"frame": json.dumps(body), "names": _list(entries), "units": _list(units)}
        variables[f"pose_{k}"] = Variable(("time", "axis", "column"), pose, about)
    return variables


def _signals(recorded: Recorded | None) -> dict[str, Variable]:
    """Inputs by pieces."""
    variables = {}
    for k, segment in enumerate(recorded.tabulated if recorded is not None else ()):
        axes = (f"break_{k}", f"piece_{k}", "power")
        variables[f"breaks_{k}"] = Variable(axes[:1], segment.breaks, {"units": "s"})
        variables[f"coefficients_{k}"] = Variable(axes[1:], segment.coefficients)
    return variables


def _bodies(motion: TrajectoryRecord) -> list[str]:
    """Frames whose motion goes into the file: one of every body that moves."""
    bodies = [body.parts[0] for body in motion.manifest.bodies if body.parts]
    if motion.model is None:
        return [body for body in bodies if f"pose {body}" in motion.stored]
    if "pose" not in motion.manifest.available:
        return []
    motion.model.prepare(*(("pose", body) for body in bodies))
    return bodies


def _about(rows: Sequence[Record]) -> dict[str, str]:
    """Names and units of the columns of a variable."""
    return {"names": _list(column(rows, "name")), "units": _list(column(rows, "unit"))}


def _list(names: Iterable[str | None]) -> str:
    return json.dumps([name or "" for name in names], ensure_ascii=True)


def _notes(motion: TrajectoryRecord) -> dict[str, str]:
    """Notes of a run for its file."""
    manifest = {
        key: value
        for key, value in vars(motion.manifest).items()
        if key not in LEFT_OUT and (value or Manifest.lacking(key))
    }
    surfaces = superelements.arrays_of_run(motion)
    scene = {
        name: np.asarray(values).tolist()
        for name, values in motion.scene.items()
        if name not in surfaces
    }
    recorded = motion.inputs_at
    signals = None
    if recorded is not None:
        signals = {
            "constants": recorded.constants.tolist(),
            "pieces": [segment.input for segment in recorded.tabulated],
            "asked": list(recorded.called),
            "held": recorded.sampled,
        }
    info = motion.solver_info
    return {
        "title": f"motion of {motion.manifest.name}".encode("ascii", "replace").decode(),
        "manifest": dumped(manifest),
        "conduct": json.dumps(asdict(replace(info, initial=dict(info.initial)))),
        "scene": json.dumps(scene),
        "happenings": json.dumps([dict(row) for row in motion.event_log.rows]),
        "sources": json.dumps(motion.sources),
        "signals": json.dumps(signals),
    }


@checked
def load(path: str | Path, model: LoadedModel | None = None) -> TrajectoryRecord:
    """Read a run that :meth:`.Trajectory.save` wrote.

    Everything in the file is checked before it is used: nothing in it is ever executed.

    Args:
        path: The file.
        model: The compiled model, for what needs it (reactions, outputs, further poses). Its
            parameters get the values of the run.

    Raises:
        ModelError: not a run of cardan, a damaged one, a newer format, or a model with other
            coordinates or parameters.
    """
    path = Path(path)
    read = formats.load(path, RUN, ("title", *NOTES))
    try:
        notes, values, poses = motion_schema.checked(read)
        if model is not None:
            model = _of_run(path, notes["manifest"], values.get("parameters"), model)
        motion = _trajectory(notes, values, model)
    except (ValueError, MemoryError, RecursionError) as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(
            f"{path} is not a run that cardan can read: {error or 'it is too large'}. Save the run "
            "again"
        ) from None
    motion.stored.update(poses)
    return motion


def _trajectory(
    notes: dict[str, Any], values: dict[str, Array], model: LoadedModel | None
) -> TrajectoryRecord:
    """The run of a file whose parts fit each other."""
    manifest = notes["manifest"] if model is None else model.manifest
    t, s, work = values["time"], values["s"], values["work"]
    states = np.concatenate([values[name] for name in "quz"], axis=1)
    dense = None
    for charted, name in enumerate(DENSE):
        if name in values:
            rows = np.concatenate([states, work], axis=1)
            quaternions = tuple(notes["manifest"].quaternions)
            dense = Dense(t, rows, values[name], quaternions, charted=charted > 0)
    multipliers = notes["manifest"].multipliers
    return TrajectoryRecord(
        t=t,
        x=states,
        r=values["r"],
        work_done=work,
        sources=notes["sources"],
        manifest=manifest,
        solver_info=SolverInfo(**notes["conduct"]),
        model=model,
        dense=dense,
        inputs_at=_recorded(notes["signals"], values),
        stored={k: values[k] for k in STORED if k in values},
        numbers=notes["scene"],
        ledger=Ledger.of(multipliers, values["ledger"]) if "ledger" in values else None,
        event_log=EventLog(s, notes["happenings"], values["events"]),
    )


def _recorded(record: motion_schema.Signals | None, values: dict[str, Array]) -> Recorded | None:
    """The inputs of a run."""
    if record is None:
        return None
    tabulated = tuple(
        PiecewiseInput(number, values[f"breaks_{k}"], values[f"coefficients_{k}"])
        for k, number in enumerate(record.pieces)
    )
    constants = np.array(record.constants, dtype=np.float64)
    called, sampled = tuple(record.asked), record.held
    return Recorded(constants, tabulated, called, sampled, values["time"], values["r"])


def _of_run(path: Path, manifest: Manifest, p: Array | None, model: LoadedModel) -> LoadedModel:
    """The model with the parameters of a run.

    Raises:
        ModelError: it has other coordinates or parameters.
    """
    for letter in "qurzsp":
        here = column(manifest.block(letter), "name")
        there = column(model.manifest.block(letter), "name")
        if here != there:
            raise ModelError(
                f"{path} is a run of another model: its {BLOCKS[letter]} are "
                f"{', '.join(here) or 'none'}; those of '{model.name}' are "
                f"{', '.join(there) or 'none'}"
            )
    if p is not None:
        return model.with_parameters(dict(zip(model.parameters, p.tolist(), strict=True)))
    if len(model.parameters):
        warnings.warn(
            f"{path} is of an earlier format, without the values of its parameters: those of "
            f"'{model.name}' are taken. Save the run again",
            ModelWarning,
            stacklevel=4,
        )
    return model
