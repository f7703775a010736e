"""Models on disk and in pickles: source and manifest, never a binary."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import ModelError
from . import cache
from .parameters import Parameters

if TYPE_CHECKING:
    from .compiled import CompiledModel

KINDS = (".c", ".h", ".json")


def texts(directory: Path) -> dict[str, str]:
    """File name -> text of everything a model directory is made of."""
    return {
        path.name: path.read_text("utf-8")
        for path in sorted(directory.iterdir())
        if path.suffix in KINDS
    }


def load(directory: str | Path) -> CompiledModel:
    """Open a model directory written by ``export`` or found in a cache.

    Needs neither SymPy nor the compiler half of cardan, only a C compiler.

    Raises:
        ModelError: no manifest, or a file is not the one the manifest speaks of.
    """
    from .compiled import CompiledModel

    model = CompiledModel(directory)
    for name, stated in model.manifest.get("sha256", {}).items():
        path = model.directory / name
        if not path.is_file():
            raise ModelError(f"model '{model.name}': file {path} is missing")
        if hashlib.sha256(path.read_bytes()).hexdigest() != stated:
            raise ModelError(
                f"model '{model.name}': {path} is not the file its manifest speaks of. "
                "Copy or export the model again"
            )
    return model


def restore(files: dict[str, str], values: list[float], reproducible: bool) -> CompiledModel:
    """The model of a pickle: its texts, written once into the cache of this machine."""
    from .compiled import CompiledModel

    wrong = [n for n in files if Path(n).name != n or Path(n).suffix not in KINDS]
    if wrong:
        raise ModelError(f"a pickled model cannot hold a file named {wrong[0]!r}")
    digest = hashlib.sha256(json.dumps(files, sort_keys=True).encode()).hexdigest()
    folder = cache.directory() / "models" / digest
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    for name, text in files.items():
        content = text.encode()
        # what is there already is left alone: other processes may be reading it
        if not (folder / name).is_file() or (folder / name).read_bytes() != content:
            cache.publish(folder / name, content)
    model = CompiledModel(folder, reproducible=reproducible)
    return model._with(Parameters(model.manifest, values))
