"""A model on disk: headers, one C file per function, ``manifest.json`` and ``functions.json``.

Every file appears whole or not at all, and two processes may write to the same directory: files are
renamed into place, and whoever changes the manifest holds a lock.
"""

from __future__ import annotations

import hashlib
import json
import os
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from .. import processes, regular_file
from ..errors import CodegenError
from ..ir.function import Function
from ..ir.recursion import Recursion
from ..ir.rows import dumped, opened
from ..ir.seal import sealed, unsealed
from ..ir.serialize import to_dict
from ..schema.records import KERNELS
from . import header
from .manifest import Base
from .writing import CFile

# what every function stands on
HEADERS = ("cardan.h", "lanes.h", "sincos.h")
# frames up to which a manifest is written for people
READ = 1000
MANIFEST, SAVED, LOCK = "manifest.json", "functions.json", ".lock"


class Damaged(CodegenError):
    """A manifest is not what was written."""


def write_model(directory: Path, base: Base) -> None:
    """Prepare a directory for the functions of a model; what is there of the same model stays.

    Args:
        directory: Made if it does not exist.
        base: From :func:`cardan.codegen.manifest.base`.

    Raises:
        CodegenError: the directory holds other things.
    """
    directory.mkdir(parents=True, exist_ok=True)
    with _locked(directory):
        there, damaged = _there(directory)
        if there and not all(
            _is_unchanged(directory, there, name) for name in _shared(there["sha256"])
        ):
            there, damaged = None, True
        if there is not None and {**there, **_EMPTY} == {**_plain(base.data), **_EMPTY}:
            if there["available"] != base.data["available"]:
                _write_manifest(directory, {**there, "available": base.data["available"]})
            return
        # a damaged model of ours is written anew, as a damaged object is compiled anew
        if there is None and not damaged and any(path.name != LOCK for path in directory.iterdir()):
            raise CodegenError(
                f"directory {directory} is not empty and holds no model of cardan: "
                "name a new or empty one"
            )
        for name in (there or {}).get("sha256", {}):
            (directory / Path(name).name).unlink(missing_ok=True)
        hashes = {name: _write(directory / name, kernel(name)) for name in HEADERS}
        hashes["model.h"] = _write(directory / "model.h", header.slots(base.data))
        saved = [(f.name, to_dict(f)) for f in base.saved()]
        hashes[SAVED] = _write(directory / SAVED, _joined(saved))
        _write_manifest(directory, {**base.data, "sha256": hashes})


def _there(directory: Path) -> tuple[dict[str, Any] | None, bool]:
    """The manifest, and whether one of cardan is damaged."""
    try:
        found = read(directory)
        # what else a model has is there: its manifest was lost
        lost = found is None and all((directory / name).is_file() for name in ("model.h", SAVED))
        return found, lost
    except Damaged:
        # other programs have files of that name too
        if not (directory / "model.h").is_file():
            raise
        return None, True


def _shared(hashes: Mapping[str, str]) -> list[str]:
    """The files that all functions of a model need: expressions and headers."""
    return [SAVED, *(name for name in hashes if name.endswith(".h"))]


def _is_unchanged(directory: Path, manifest: dict[str, Any], name: str) -> bool:
    """Whether a file is the one that the manifest speaks of."""
    try:
        content = regular_file.content(directory / Path(name).name)
    except OSError:
        return False
    return hashlib.sha256(content).hexdigest() == str(manifest["sha256"].get(name))


def has_function(directory: Path, name: str) -> bool:
    """Whether a function is in the manifest and its file is the one it speaks of."""
    return not missing(directory, [name])


def missing(directory: Path, names: Sequence[str]) -> list[str]:
    """Those that :func:`has_function` denies, by one look at the manifest."""
    functions = (_there(directory)[0] or {}).get("functions", {})
    return [name for name in names if not _is_there(directory, functions.get(name))]


def _is_there(directory: Path, entry: dict[str, Any] | None) -> bool:
    if entry is None:
        return False
    try:
        content = regular_file.content(directory / Path(entry["file"]).name)
    except (OSError, KeyError, TypeError, ValueError):
        return False
    return hashlib.sha256(content).hexdigest() == str(entry.get("sha256"))


def add_function(directory: Path, cfile: CFile, function: Function | Recursion) -> None:
    """Write a function: its C file, its expressions and its entry in the manifest.

    Raises:
        CodegenError: :func:`write_model` was not called before.
    """
    add_functions(directory, [(cfile, function)])


def add_functions(directory: Path, made: Sequence[tuple[CFile, Function | Recursion]]) -> None:
    """Write several functions at once.

    Raises:
        CodegenError: :func:`write_model` was not called before.
    """
    saved = [(cfile.name, to_dict(function)) for cfile, function in made]
    with _locked(directory):
        manifest = read(directory)
        if manifest is None:
            raise CodegenError(f"directory {directory} holds no model: call write_model first")
        hashes, functions = manifest["sha256"], manifest["functions"]
        for cfile, _ in made:
            for name in cfile.includes:
                if name not in hashes:
                    hashes[name] = _write(directory / name, kernel(name))
            hashes[cfile.entry["file"]] = _write(directory / cfile.entry["file"], cfile.text)
            functions[cfile.name] = cfile.entry
        if not _is_unchanged(directory, manifest, SAVED):
            raise Damaged(f"{directory / SAVED} is damaged: remove the directory")
        text = _appended((directory / SAVED).read_text("utf-8"), saved)
        hashes[SAVED] = _write(directory / SAVED, text)
        _write_manifest(directory, manifest)


def add_files(directory: Path, texts: Mapping[str, str]) -> None:
    """Write more files that belong to the model, by name."""
    with _locked(directory):
        manifest = read(directory)
        if manifest is None:
            raise CodegenError(f"directory {directory} holds no model: call write_model first")
        for name, text in texts.items():
            manifest["sha256"][name] = _write(directory / name, text)
        _write_manifest(directory, manifest)


def change(directory: Path, edit: Callable[[dict[str, Any]], None]) -> None:
    """Change what the manifest of a directory says."""
    with _locked(directory):
        manifest = read(directory)
        if manifest is None:
            raise CodegenError(f"directory {directory} holds no model: call write_model first")
        edit(manifest)
        _write_manifest(directory, manifest)


def add_bytes(directory: Path, name: str, content: bytes) -> None:
    """Write one more file of numbers that belongs to the model, unless it is there."""
    digest = hashlib.sha256(content).hexdigest()
    with _locked(directory):
        manifest = read(directory)
        if manifest is None:
            raise CodegenError(f"directory {directory} holds no model: call write_model first")
        if manifest["sha256"].get(name) == digest and (directory / name).exists():
            return
        manifest["sha256"][name] = _write(directory / name, content)
        _write_manifest(directory, manifest)


def written(directory: Path) -> set[str]:
    """Names of the files in a directory that belong to its model; empty where there is none."""
    manifest = read(directory)
    return set() if manifest is None else {MANIFEST, LOCK, *manifest["sha256"]}


def kernel(name: str) -> str:
    """Text of a file of ``cardan/kernels``."""
    return (KERNELS / name).read_text("utf-8")


# what changes when functions are added
_EMPTY: dict[str, Any] = {"functions": {}, "sha256": {}, "available": []}


def _plain(data: dict[str, Any]) -> Any:
    """Data as it reads after JSON."""
    return opened(json.loads(dumped(data)))


def read(directory: Path) -> dict[str, Any] | None:
    """The manifest of a directory; None where there is none of this schema.

    Raises:
        Damaged: there is one, but not as it was written.
    """
    try:
        found = unsealed(regular_file.content(directory / MANIFEST))
    except FileNotFoundError:
        return None
    except (ValueError, OSError) as problem:
        raise Damaged(
            f"{directory / MANIFEST} is damaged ({problem}): remove the directory"
        ) from problem
    if not (isinstance(found, dict) and "abi" in found):
        return None
    wanted = (("functions", dict), ("sha256", dict), ("available", list))
    wrong = [name for name, kind in wanted if not isinstance(found.get(name), kind)]
    rows = found["functions"].values() if not wrong else ()
    if wrong or not all(isinstance(row, dict) for row in rows):
        name = wrong[0] if wrong else "functions"
        raise Damaged(f"{directory / MANIFEST} is damaged ('{name}'): remove the directory")
    return found


def _write_manifest(directory: Path, manifest: dict[str, Any]) -> None:
    ordered = dict(manifest)
    for name in ("functions", "sha256"):
        ordered[name] = dict(sorted(ordered[name].items()))
    # one entry per line for readers; of thousands of bodies nobody reads, and lines take a minute
    rows = max(len(ordered["frames"]), len(ordered["joints"]))
    indent = 1 if rows <= READ else None
    text = sealed(ordered, indent=indent, ensure_ascii=False, allow_nan=False)
    _write(directory / MANIFEST, text)


def _line(name: str, saved: dict[str, Any]) -> str:
    return f"{json.dumps(name)}: {json.dumps(saved, separators=(',', ':'), allow_nan=False)}"


def _joined(saved: list[tuple[str, dict[str, Any]]]) -> str:
    """``functions.json``: one function per line, so that one more is cheap to add."""
    return "{\n" + ",\n".join(_line(*row) for row in saved) + "\n}\n"


def _appended(text: str, saved: list[tuple[str, dict[str, Any]]]) -> str:
    """The text with functions added or replaced."""
    names = {json.dumps(name) for name, _ in saved}
    kept = [line.rstrip(",") for line in text.splitlines()[1:-1]]
    kept = [line for line in kept if line.split(": ", 1)[0] not in names]
    return "{\n" + ",\n".join([*kept, *(_line(*row) for row in saved)]) + "\n}\n"


def _write(path: Path, text: str | bytes) -> str:
    """Write a file in one step; returns its hash."""
    content = text.encode() if isinstance(text, str) else text
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=".new-")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        Path(name).chmod(0o644)
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
    return hashlib.sha256(content).hexdigest()


@contextmanager
def _locked(directory: Path) -> Iterator[None]:
    """Alone with the manifest, across threads and processes."""
    with open(directory / LOCK, "w") as file:
        processes.lock(file.fileno())
        yield
