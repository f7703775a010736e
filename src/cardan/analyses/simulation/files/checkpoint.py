"""Checkpoints of steppers on disk: runs that go on in another process, to the bit."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from .... import regular_file
from ....atomic_file import replaced
from ....errors import ModelError
from ....number_file import packed, plain, unpacked
from ....runtime.models.loaded_model import LoadedModel
from ....schema.integrators import INTEGRATORS
from ....version import STEPPER, VERSION, written_by
from ..driving import runner_of
from ..events import event_table_of
from ..run import Runner
from ..run_state import Saved
from ..settings import Settings, settings
from ..signals import signals
from .append_log import model_key
from .saved_record import impossible, record_of, saved_of, sound, ticks_of

TEXTS = ("key", "method", "model", "words", "over")
NUMBERS = ("rtol", "atol", "step")
NEEDED = {*TEXTS, *NUMBERS, "max_step", "kernels", "record", "ticks", "events"}
NONE = "give a file that stepper.save(path) wrote"


def write(runner: Runner, how: Settings, saved: Saved, path: Path) -> None:
    """Write a checkpoint; a file with its name is replaced in one step.

    Args:
        runner: The run.
        how: Its settings as they were asked for.
        saved: The checkpoint.
        path: Of the file.

    Raises:
        ModelError: a method with choices of its own, or no such directory.
    """
    if INTEGRATORS.get(how.method.name) is not how.method:
        raise ModelError(
            f"{path}: '{how.method.name}' was given with choices of its own, which a file does not "
            "hold. Checkpoints are written for methods by their names"
        )
    if not path.parent.is_dir():
        raise ModelError(f"{path}: the directory {path.parent} does not exist")
    numbers = {"rtol": how.rtol, "atol": how.atol, "step": how.step}
    # everything that decides the next step: a run continued from the file has the same bits
    head = {
        STEPPER.word: STEPPER.version,
        "cardan": VERSION,
        "model": runner.model.name,
        "key": _key(runner),
        "kernels": not runner.interpreted,
        "method": how.method.name,
        "words": how.description,
        "max_step": None if math.isinf(how.max_step) else how.max_step,
        "events": [dict(row) for row in runner.event_table.rows],
        "record": record_of(runner),
        "ticks": ticks_of(runner),
        "over": saved.over,
        **numbers,
    }
    text = json.dumps(head).encode("ascii")
    parts = {
        "head": np.frombuffer(text, dtype=np.uint8),
        "memory": np.frombuffer(saved.memory),
        "digest": np.frombuffer(digest(text, saved.memory), dtype=np.uint8),
    }
    # written aside and renamed: a killed process leaves the old file
    with replaced(path) as new:
        Path(new).write_bytes(packed(parts))


def digest(head: bytes, memory: bytes) -> bytes:
    """Hash of everything in a checkpoint; it finds damage, not malice."""
    return hashlib.sha256(hashlib.sha256(head).digest() + memory).digest()


def read(
    model: LoadedModel, path: Path, events: Mapping[str, object] | None
) -> tuple[Runner, Settings, str]:
    """The run of a checkpoint, where it was, and what ended it.

    Args:
        model: The model it is of.
        path: The file.
        events: What the caller watches, as when the run began.

    Raises:
        ModelError: no checkpoint, or one of another model, other parameters, other events or
            another version; one of a machine with a compiler on a machine without.
    """
    head, memory = _parts(path)
    writer = head.get("cardan")
    how = _settings(head, path)
    input_signals = signals(model.manifest.inputs, None, None, (0.0, 0.0))
    runner = runner_of(model, how, input_signals, event_table_of(model, events))
    if head["key"] != _key(runner):
        raise ModelError(
            f"{path} is a checkpoint of '{head['model']}' with other equations or parameters than "
            f"'{model.name}' has here: {written_by(writer)} wrote it. Give the model it was made "
            "with, with_parameters(...) included, or start the run anew"
        )
    if head["events"] != [dict(row) for row in runner.event_table.rows]:
        raise ModelError(
            f"{path}: its run watches for {_names(head)}: give the same events=. "
            f"{written_by(writer)} wrote it; where that had other events, start the run anew"
        )
    if bool(head["kernels"]) == runner.interpreted:
        raise ModelError(
            f"{path} was made {'with' if head['kernels'] else 'without'} a C compiler by "
            f"{written_by(writer)}; this run would go on otherwise: bits differ. Start the run anew"
        )
    runner.want(None, dense=False)
    runner.restore(saved_of(runner, head["record"], memory, head["ticks"], path, writer))
    sound(runner, path)
    return runner, how, str(head["over"])


def _settings(head: dict[str, Any], path: Path) -> Settings:
    """Solver settings of a file, checked as those of callers are."""
    if head["method"] not in INTEGRATORS:
        raise ModelError(
            f"{path}: this cardan has no method '{head['method']}'; "
            f"{written_by(head.get('cardan'))} wrote it. Start the run anew by another method"
        )
    method = INTEGRATORS[head["method"]]
    taken = {name: head[name] or None for name in ("step", "max_step")}
    try:
        if method.adaptive:
            how = settings(method.name, head["rtol"], head["atol"], **taken, length=None)
        else:
            how = settings(method.name, 0.0, 1.0, **taken, length=None)
    except ModelError as error:
        raise impossible(path, str(error)) from error
    # words tell what was asked for before it was bounded
    return replace(how, method=method, description=head["words"])


def _names(head: dict[str, Any]) -> str:
    """Names of the events of a run, as far as a file states them."""
    rows = head["events"] if isinstance(head["events"], list) else []
    names = [str(row.get("name")) for row in rows if isinstance(row, dict)]
    return ", ".join(dict.fromkeys(names)) or "none"


def _key(runner: Runner) -> str:
    """Hash of the equations and parameters that a run depends on."""
    model, total = runner.model, hashlib.sha256()
    if model.manifest.absolute:
        return model_key(model)
    needed = (*runner.settings.method.needs, *runner.event_table.functions)
    names = ("rhs", *(("power",) if runner.powered else ()), *runner.closing.functions, *needed)
    for name in names:
        symbol = model._function(name).symbol
        total.update(model._objects.text_path(symbol).read_bytes())
    total.update(model.parameters.vector.tobytes())
    return total.hexdigest()


def _parts(path: Path) -> tuple[dict[str, Any], Any]:
    """Head and memory of a file."""
    try:
        content = regular_file.content(path)
    except FileNotFoundError:
        raise ModelError(f"{path}: there is no such file") from None
    except OSError as error:
        raise ModelError(f"{path} cannot be read: {error.strerror or error}") from error
    try:
        parts = unpacked(content)
        text, memory, stated = (parts[name] for name in ("head", "memory", "digest"))
        head = plain(text.tobytes())
    except (ValueError, KeyError) as error:
        raise ModelError(f"{path} is not a checkpoint, or is damaged: {NONE}") from error
    if not isinstance(head, dict) or STEPPER.word not in head:
        raise ModelError(f"{path} is not a checkpoint: {NONE}")
    if not STEPPER.reads(head[STEPPER.word]):
        raise ModelError(STEPPER.refusal(path, head[STEPPER.word], head.get("cardan")))
    if stated.tobytes() != digest(text.tobytes(), memory.tobytes()):
        raise impossible(path, "its hash is that of another content")
    _check(head, path)
    return head, memory


def _check(head: dict[str, Any], path: Path) -> None:
    """Check that a header has all its entries, of the right types."""
    if not set(head) >= NEEDED:
        raise impossible(path, f"'{min(NEEDED - set(head))}' is missing")
    for name in TEXTS:
        if not isinstance(head[name], str):
            raise impossible(path, f"'{name}' is not a text")
    for name in (*NUMBERS, *(("max_step",) if head["max_step"] is not None else ())):
        if type(head[name]) not in (int, float) or not abs(head[name]) < 1e308:
            raise impossible(path, f"'{name}' is not a number")
