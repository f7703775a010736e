"""Checkpoints of steppers on disk: runs that go on in another process, to the bit."""

from __future__ import annotations

import hashlib
import json
import math
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from .. import __version__
from ..errors import ModelError
from ..runtime.compiled import CompiledModel
from ..runtime.storage import replaced
from .happenings import happenings
from .integrators import INTEGRATORS
from .plain import PlainRunner
from .run import Runner, Saved
from .saved_record import record_of, saved_of
from .settings import Settings
from .signals import signals
from .simulate import runner_of

FORMAT = 2
NONE = "give a file that stepper.save(path) wrote"


def write(runner: Runner | PlainRunner, how: Settings, saved: Saved, path: Path) -> None:
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
    head = {
        "cardan_checkpoint": FORMAT,
        "cardan": __version__,
        "model": runner.model.name,
        "key": _key(runner),
        "kernels": isinstance(runner, Runner),
        "method": how.method.name,
        "words": how.words,
        "max_step": None if math.isinf(how.max_step) else how.max_step,
        "events": [dict(row) for row in runner.may.rows],
        "record": record_of(runner),
        "over": saved.over,
        **numbers,
    }
    parts: dict[str, Any] = {
        "head": np.frombuffer(json.dumps(head).encode("ascii"), dtype=np.uint8),
        "memory": np.frombuffer(saved.memory),
        "ticks": np.frombuffer(saved.ticks, dtype=np.uint8),
    }
    with replaced(path) as new, Path(new).open("wb") as file:
        np.savez(file, **parts)


def read(
    model: CompiledModel, path: Path, events: Mapping[str, Any] | None
) -> tuple[Runner | PlainRunner, Settings, str]:
    """The run of a checkpoint, where it was, and what ended it.

    Args:
        model: The model it is of.
        path: The file.
        events: What the caller watches, as when the run began.

    Raises:
        ModelError: no checkpoint, or one of another model, other parameters, other events or
            another version; one of a machine with a compiler on a machine without.
    """
    head, memory, ticks = _parts(path)
    method = INTEGRATORS.get(str(head["method"]))
    if method is None:
        raise ModelError(f"{path}: this cardan has no method '{head['method']}'")
    limit = math.inf if head["max_step"] is None else float(head["max_step"])
    numbers = (float(head["rtol"]), float(head["atol"]), float(head["step"]), limit)
    how = Settings(method, *numbers, str(head["words"]))
    given = signals(model.manifest["inputs"], None, None, (0.0, 0.0))
    runner = runner_of(model, how, given, happenings(model, events))
    if head["key"] != _key(runner):
        raise ModelError(
            f"{path} is a checkpoint of '{head['model']}' with other equations or parameters than "
            f"'{model.name}' has: give the model it was made with, with_parameters(...) included"
        )
    if head["events"] != [dict(row) for row in runner.may.rows]:
        names = ", ".join(dict.fromkeys(row["name"] for row in head["events"])) or "none"
        raise ModelError(f"{path}: its run watches for {names}: give the same events=")
    if bool(head["kernels"]) != isinstance(runner, Runner):
        raise ModelError(
            f"{path} was made {'with' if head['kernels'] else 'without'} a C compiler, this run "
            "would go on otherwise: bits differ"
        )
    runner.want(None, dense=False)
    runner.restore(saved_of(runner, head["record"], memory, ticks, path))
    return runner, how, str(head["over"])


def _key(runner: Runner | PlainRunner) -> str:
    """Hash of the equations and parameters that a run depends on."""
    model, found = runner.model, hashlib.sha256()
    needed = (*runner.settings.method.needs, *runner.may.functions)
    names = ("rhs", *(("power",) if runner.powered else ()), *runner.closing.functions, *needed)
    for name in names:
        symbol = model._function(name).symbol
        found.update(model._objects.text_path(symbol).read_bytes())
    found.update(model.parameters.vector.tobytes())
    return found.hexdigest()


def _parts(path: Path) -> tuple[dict[str, Any], Any, bytes]:
    """Head, memory and ticks of a file."""
    try:
        # other files than archives may hold objects, about which NumPy has advice
        if path.exists() and not zipfile.is_zipfile(path):
            raise zipfile.BadZipFile
        with np.load(path, allow_pickle=False) as file:
            head = json.loads(file["head"].tobytes())
            memory, ticks = file["memory"], file["ticks"].tobytes()
    except FileNotFoundError:
        raise ModelError(f"{path}: there is no such file") from None
    except OSError as error:
        raise ModelError(f"{path} cannot be read: {error.strerror or error}") from error
    except (ValueError, KeyError, AttributeError, EOFError, zipfile.BadZipFile) as error:
        raise ModelError(f"{path} is no checkpoint, or is damaged: {NONE}") from error
    needed = {"cardan_checkpoint", "key", "method", "record", "events", "words", "max_step", "over"}
    if not isinstance(head, dict) or not needed <= set(head) or memory.dtype != np.float64:
        raise ModelError(f"{path} is no checkpoint: {NONE}")
    if head["cardan_checkpoint"] != FORMAT:
        raise ModelError(f"{path} was written by another version of cardan; start the run anew")
    return head, memory, ticks
