"""Runs as files: what stands in them, whatever their format.

Dimensions ``time``, ``coordinate``, ``speed``, ``internal_state``, ``mode``, ``input``, ``source``,
``step``, ``event``, ``constraint``; names of the entries stand in the attribute ``names`` of every
variable, units in ``units``. The manifest (names, units, joints, shapes; no functions) is the
attribute ``manifest``, as JSON; ``sha256`` tells whether all of it is what was saved.
"""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arguments import checked
from ...arrays import Array
from ...errors import ModelError
from ...schema.fields import dumped
from ...schema.manifest import BLOCKS, Manifest
from ...schema.rows import column
from ...version import RUN
from .. import formats
from ..formats.contents import Contents, Variable
from . import energy_balance, motion_schema
from .closure_errors import Ledger
from .dense_output import Dense
from .event_log import Happened
from .input_history import Pieces, Recorded
from .solver_info import Conduct
from .trajectory import TrajectoryRecord

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel

NOTES = ("manifest", "conduct", "scene", "happenings", "sources", "signals")
DENSE = ("spreads", "increments")  # what is between, of quaternions or of their increments
KEPT = ("kinetic", "potential", "constraints", "multipliers", "losses")
LEFT_OUT = ("functions", "sha256", "available", "finite_elements")
COLUMNS = "largest before projection, when, largest after it, when"
FEWER = "Simulate with an array of output times to keep fewer of them"


@checked
def save(motion: TrajectoryRecord, path: str | Path) -> Path:
    """Write everything but the model; :func:`cardan.load_motion` reads it.

    The ending says the format: .nc (netCDF), .npz (NumPy archive) or .csv (a table of what
    changes over time, which is not read again). The file appears complete or not at all.

    Returns:
        Its path.

    Raises:
        ModelError: a variable too large for the format, the ending of another format, or a file
            that cannot be written.
    """
    made = Contents(_variables(motion), _notes(motion))
    return formats.save(Path(path), RUN, made, FEWER)


def _variables(motion: TrajectoryRecord) -> dict[str, Variable]:
    """Everything that is numbers."""
    manifest = motion.manifest

    def listed(key: str) -> dict[str, str]:
        rows = manifest.block(key)
        return {"names": _list(column(rows, "name")), "units": _list(column(rows, "unit"))}

    found = {
        "time": Variable(("time",), motion.t, {"units": "s"}),
        "q": Variable(("time", "coordinate"), motion.q, listed("q")),
        "u": Variable(("time", "speed"), motion.u, listed("u")),
        "r": Variable(("time", "input"), motion.r, listed("r")),
    }
    if manifest.z:
        found["z"] = Variable(("time", "internal_state"), motion.z, listed("z"))
    if manifest.s:
        found["s"] = Variable(("time", "mode"), motion.s, listed("s"))
    if len(motion.happened.log):
        about = {"columns": "when, 1 for every event that happened, x and s before, x and s behind"}
        found["events"] = Variable(("event", "event_column"), motion.happened.log, about)
        losses = energy_balance.losses(motion)
        if len(losses):
            found["losses"] = Variable(("event",), losses, {"units": "J"})
    if motion.sources:
        names = {"names": _list(motion.sources), "units": "J"}
        found["work"] = Variable(("time", "source"), motion.given, names)
    if motion.dense is not None:
        axes = ("step", "row", "entry")
        found[DENSE[motion.dense.charted]] = Variable(axes, motion.dense.spreads)
    return {**found, **_signals(motion.inputs_at), **_computed(motion)}


def _computed(motion: TrajectoryRecord) -> dict[str, Variable]:
    """What follows from the states by the model."""
    found = {}
    available = set(motion.manifest.available)
    if "kinetic" in motion.stored or "energy" in available:
        found["kinetic"] = Variable(("time",), motion.energy.kinetic, {"units": "J"})
        found["potential"] = Variable(("time",), motion.energy.potential, {"units": "J"})
    if motion.ledger is not None:
        table = motion.ledger.table
        found["ledger"] = Variable(("constraint", "column"), table, {"columns": COLUMNS})
    if "constraints" in motion.stored or ({"constraints"} <= available and motion.constraints):
        residuals = np.stack([*motion.constraints.values()], axis=-1)
        found["constraints"] = Variable(("time", "position_constraint"), residuals)
    if "multipliers" in motion.stored:
        forces = motion.stored["multipliers"]
        found["multipliers"] = Variable(("time", "multiplier"), forces)
    for k, body in enumerate(_bodies(motion)):
        pose = motion.pose(body)[:, :3, :]
        found[f"pose_{k}"] = Variable(("time", "axis", "column"), pose, {"frame": json.dumps(body)})
    return found


def _signals(recorded: Recorded | None) -> dict[str, Variable]:
    """Inputs by pieces."""
    found = {}
    for k, piece in enumerate(recorded.pieces if recorded is not None else ()):
        axes = (f"break_{k}", f"piece_{k}", "power")
        found[f"breaks_{k}"] = Variable(axes[:1], piece.breaks, {"units": "s"})
        found[f"coefficients_{k}"] = Variable(axes[1:], piece.coefficients)
    return found


def _bodies(motion: TrajectoryRecord) -> list[str]:
    """Frames whose motion goes into the file: one of every body that moves."""
    bodies = [body.parts[0] for body in motion.manifest.bodies if body.parts]
    if motion.model is None:
        return [body for body in bodies if f"pose {body}" in motion.stored]
    if "pose" not in motion.manifest.available:
        return []
    motion.model.prepare(*(("pose", body) for body in bodies))
    return bodies


def _list(names: Any) -> str:
    return json.dumps([name or "" for name in names], ensure_ascii=True)


def _notes(motion: TrajectoryRecord) -> dict[str, str]:
    """What the run says about itself."""
    kept = {
        key: value
        for key, value in vars(motion.manifest).items()
        if key not in LEFT_OUT and (value or Manifest.lacking(key))
    }
    scene = {name: np.asarray(values).tolist() for name, values in motion.scene.items()}
    recorded = motion.inputs_at
    signals = None
    if recorded is not None:
        signals = {
            "constants": recorded.constants.tolist(),
            "pieces": [piece.input for piece in recorded.pieces],
            "asked": list(recorded.asked),
            "held": recorded.held,
        }
    return {
        "title": f"motion of {motion.manifest.name}".encode("ascii", "replace").decode(),
        "manifest": dumped(kept),
        "conduct": json.dumps(asdict(motion.conduct)),
        "scene": json.dumps(scene),
        "happenings": json.dumps([dict(row) for row in motion.happened.rows]),
        "sources": json.dumps(motion.sources),
        "signals": json.dumps(signals),
    }


@checked
def load(path: str | Path, model: LoadedModel | None = None) -> TrajectoryRecord:
    """Read a run that :meth:`.Trajectory.save` wrote.

    Everything in the file is checked before it is used: nothing in it is ever executed.

    Args:
        path: The file.
        model: The compiled model, for what needs it (reactions, outputs, further poses).

    Raises:
        ModelError: not a run of cardan, a damaged one, a newer format, or a model with other
            coordinates.
    """
    path = Path(path)
    held = formats.load(path, RUN, ("title", *NOTES))
    try:
        notes, values, poses = motion_schema.checked(held)
        made = _made(notes, values, model)
    except (ValueError, MemoryError, RecursionError) as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(
            f"{path} is no run that cardan can read: {error or 'it is too large'}. Save the run "
            "again"
        ) from None
    made.stored.update(poses)
    if model is not None:
        _compare(path, notes["manifest"], model)
    return made


def _made(
    notes: dict[str, Any], values: dict[str, Array], model: LoadedModel | None
) -> TrajectoryRecord:
    """The run of a file whose parts fit each other."""
    manifest = notes["manifest"] if model is None else model.manifest
    t, s, given = values["time"], values["s"], values["work"]
    states = np.concatenate([values[name] for name in "quz"], axis=1)
    dense = None
    for charted, name in enumerate(DENSE):
        if name in values:
            rows = np.concatenate([states, given], axis=1)
            quaternions = tuple(notes["manifest"].quaternions)
            dense = Dense(t, rows, values[name], quaternions, charted=charted > 0)
    multipliers = notes["manifest"].multipliers
    return TrajectoryRecord(
        t=t,
        x=states,
        r=values["r"],
        given=given,
        sources=notes["sources"],
        manifest=manifest,
        conduct=Conduct(**notes["conduct"]),
        model=model,
        dense=dense,
        inputs_at=_recorded(notes["signals"], values),
        stored={k: values[k] for k in KEPT if k in values},
        numbers=notes["scene"],
        ledger=Ledger.of(multipliers, values["ledger"]) if "ledger" in values else None,
        happened=Happened(s, notes["happenings"], values["events"]),
    )


def _recorded(told: motion_schema.Signals | None, values: dict[str, Array]) -> Recorded | None:
    """The inputs of a run."""
    if told is None:
        return None
    pieces = tuple(
        Pieces(number, values[f"breaks_{k}"], values[f"coefficients_{k}"])
        for k, number in enumerate(told.pieces)
    )
    constants = np.array(told.constants, dtype=np.float64)
    asked, held = tuple(told.asked), told.held
    return Recorded(constants, pieces, asked, held, values["time"], values["r"])


def _compare(path: Path, manifest: Manifest, model: LoadedModel) -> None:
    for letter in "qurzs":
        here = column(manifest.block(letter), "name")
        there = column(model.manifest.block(letter), "name")
        if here != there:
            raise ModelError(
                f"{path} is a run of another model: its {BLOCKS[letter]} are "
                f"{', '.join(here) or 'none'}; those of '{model.name}' are "
                f"{', '.join(there) or 'none'}"
            )
