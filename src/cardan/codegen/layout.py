"""A model on disk: headers, one C file per function, ``manifest.json`` and ``functions.json``.

Every file appears whole or not at all, and two processes may write to the same directory: files are
renamed into place, and whoever changes the manifest holds a lock.
"""

from __future__ import annotations

import hashlib
import json
import os
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

from .. import processes, regular_file
from ..errors import CodegenError, ModelError
from ..ir.routine import Routine
from ..ir.serialize import to_dict
from ..ir.trees.assembly import Form
from ..processes import collector_paused
from ..schema import kernel_files
from ..schema.c_functions import FunctionRow
from ..schema.manifest import Manifest, from_file, remember, statement
from ..schema.seal import is_sealed, sealed, unsealed
from ..version import ABI
from . import header
from .manifest import Base
from .writing import CFile

T = TypeVar("T")
# writes files that belong to a model, gives its manifest with them
Step = Callable[[Manifest], Manifest]
# what every function stands on
HEADERS = ("cardan.h", "lanes.h", "sincos.h")
# frames up to which a manifest is written for people
READ = 1000
MANIFEST, SAVED = "manifest.json", "functions.json"
LOCK = processes.FOLDER_LOCK


class Damaged(CodegenError):
    """A manifest is not what was written."""


@collector_paused()
def write_model(directory: Path, base: Base, steps: Sequence[Step] = ()) -> None:
    """Prepare a directory for the functions of a model; what is there of the same model stays.

    Args:
        directory: Made if it does not exist.
        base: From :func:`cardan.codegen.manifest.base`.
        steps: What else is written before the manifest is, see :func:`with_files` and
            :func:`with_functions`.

    Raises:
        CodegenError: the directory holds other things.
    """
    directory.mkdir(parents=True, exist_ok=True)
    with processes.folder_lock(directory):
        there, damaged = _there(directory)
        if there and not (
            is_sealed(regular_file.content(directory / MANIFEST))
            and all(_is_unchanged(directory, there, name) for name in _shared(there.sha256))
        ):
            there, damaged = None, True
        if there is not None and statement(there) == statement(base.data):
            changed = there
            if list(there.available) != list(base.data.available):
                changed = there.replaced(available=base.data.available)
            _write_if_changed(directory, there, _stepped(changed, steps))
            return
        # a damaged model of ours is written anew, as a damaged object is compiled anew
        if there is None and not damaged and any(path.name != LOCK for path in directory.iterdir()):
            raise CodegenError(
                f"directory {directory} is not empty and holds no model of cardan: "
                "name a new or empty one"
            )
        for name in there.sha256 if there else ():
            (directory / Path(name).name).unlink(missing_ok=True)
        hashes = {name: _write(directory / name, kernel_files.text(name)) for name in HEADERS}
        hashes["model.h"] = _write(directory / "model.h", header.slots(base.data))
        # the manifest names the parameters
        saved = [(f.name, to_dict(f, ("p",))) for f in base.saved()]
        hashes[SAVED] = _write(directory / SAVED, _joined(saved))
        _write_manifest(directory, _stepped(base.data.replaced(sha256=hashes), steps))


def _stepped(manifest: Manifest, steps: Sequence[Step]) -> Manifest:
    for step in steps:
        manifest = step(manifest)
    return manifest


def _there(directory: Path) -> tuple[Manifest | None, bool]:
    """The manifest, and whether one of cardan is damaged."""
    try:
        manifest = read(directory)
        # what else a model has is there: its manifest was lost
        lost = manifest is None and all((directory / name).is_file() for name in ("model.h", SAVED))
        return manifest, lost
    except Damaged:
        # other programs have files of that name too
        if not (directory / "model.h").is_file():
            raise
        return None, True


def _shared(hashes: Mapping[str, str]) -> list[str]:
    """The files that all functions of a model need: expressions and headers."""
    return [SAVED, *(name for name in hashes if name.endswith(".h"))]


def _is_unchanged(directory: Path, manifest: Manifest, name: str) -> bool:
    """True when a file is the one that the manifest speaks of."""
    try:
        content = regular_file.content(directory / Path(name).name)
    except OSError:
        return False
    return hashlib.sha256(content).hexdigest() == manifest.sha256.get(name)


def missing(directory: Path, names: Sequence[str], there: Manifest | None = None) -> list[str]:
    """Names of functions that are not in the manifest, or whose file is another; by one look.

    Args:
        directory: Of the model.
        names: Of the functions.
        there: The manifest, where it is not the one in the directory.
    """
    there = there or _there(directory)[0]
    functions = there.functions if there else {}
    return [name for name in names if not _is_there(directory, functions.get(name))]


def _is_there(directory: Path, entry: FunctionRow | None) -> bool:
    if entry is None:
        return False
    try:
        content = regular_file.content(directory / entry.file)
    except (OSError, ValueError):
        return False
    return hashlib.sha256(content).hexdigest() == entry.sha256


def add_functions(directory: Path, texts: Sequence[tuple[CFile, Form]]) -> None:
    """Write functions: their C files, their expressions and their entries in the manifest.

    Raises:
        CodegenError: :func:`write_model` was not called before.
    """
    change(directory, lambda manifest: with_functions(directory, manifest, texts))


def with_functions(
    directory: Path, manifest: Manifest, texts: Sequence[tuple[CFile, Form]]
) -> Manifest:
    """Write functions into the directory of a manifest; returns it with their entries."""
    # what a routine computes has no expressions
    saved = [(c.name, to_dict(f)) for c, f in texts if not isinstance(f, Routine)]
    hashes = dict(manifest.sha256)
    for cfile, _ in texts:
        for name in cfile.includes:
            if name not in hashes:
                hashes[name] = _write(directory / name, kernel_files.text(name))
        hashes[cfile.entry.file] = _write(directory / cfile.entry.file, cfile.text)
    if not _is_unchanged(directory, manifest, SAVED):
        raise Damaged(f"{directory / SAVED} is damaged: remove the directory")
    text = _appended((directory / SAVED).read_text("utf-8"), saved)
    hashes[SAVED] = _write(directory / SAVED, text)
    functions = {**manifest.functions, **{cfile.name: cfile.entry for cfile, _ in texts}}
    return manifest.replaced(sha256=hashes, functions=functions)


def add_files(directory: Path, files: Mapping[str, str | bytes]) -> None:
    """Write more files that belong to the model, by name, unless they are there."""
    change(directory, lambda manifest: with_files(directory, manifest, files))


def with_files(directory: Path, manifest: Manifest, files: Mapping[str, str | bytes]) -> Manifest:
    """Write files into the directory of a manifest unless they are there; returns it with them."""
    contents = {name: x.encode() if isinstance(x, str) else x for name, x in files.items()}
    stated = {name: hashlib.sha256(content).hexdigest() for name, content in contents.items()}
    for name, content in contents.items():
        if manifest.sha256.get(name) != stated[name] or not (directory / name).exists():
            _write(directory / name, content)
    return manifest.replaced(sha256={**manifest.sha256, **stated})


def replace_texts(directory: Path, files: Mapping[str, str], **stated: str) -> None:
    """Write other texts of the files of a model; the manifest says what they are, by field."""
    add_files(directory, dict(files))

    def rewritten(manifest: Manifest) -> Manifest:
        functions = {
            name: entry.replaced(sha256=manifest.sha256[entry.file])
            for name, entry in manifest.functions.items()
        }
        return manifest.replaced(**stated, functions=functions)

    change(directory, rewritten)


def manifest_of(directory: Path) -> Manifest:
    """The manifest of a directory.

    Raises:
        CodegenError: it holds no model, or a damaged one.
    """
    manifest = read(directory)
    if manifest is None:
        raise CodegenError(f"directory {directory} holds no model: call write_model first")
    return manifest


def change(directory: Path, edit: Step) -> None:
    """Change what the manifest of a directory says.

    Raises:
        CodegenError: it holds no model.
    """
    with processes.folder_lock(directory):
        manifest = manifest_of(directory)
        _write_if_changed(directory, manifest, edit(manifest))


def _write_if_changed(directory: Path, before: Manifest, manifest: Manifest) -> None:
    if _differs(manifest, before):
        _write_manifest(directory, manifest)


def _differs(one: Manifest, other: Manifest) -> bool:
    """True when manifests differ; entries that one has from the other are not looked at."""
    a, b = vars(one), vars(other)
    return a.keys() != b.keys() or any(x is not b[name] and x != b[name] for name, x in a.items())


def written(directory: Path) -> set[str]:
    """Names of the files in a directory that belong to its model; empty where there is none."""
    # earlier versions wrote files of ours too
    plain = _manifest(directory, lambda content, where: unsealed(content))
    if plain is None or not _has_version(plain):
        return set()
    return {MANIFEST, LOCK, *(Path(name).name for name in plain.get("sha256") or {})}


def read(directory: Path) -> Manifest | None:
    """The manifest of a directory; None where there is none of cardan.

    Raises:
        Damaged: there is one, but not as this cardan writes it.
    """
    return _manifest(directory, _of_cardan)


def _of_cardan(content: bytes, where: str) -> Manifest | None:
    """The manifest in a file; None where the file is somebody else's."""
    try:
        return from_file(content, where)
    except ModelError:
        if not _has_version(unsealed(content)):
            return None
        raise


def _has_version(plain: object) -> bool:
    return isinstance(plain, dict) and ABI.word in plain


def _manifest(directory: Path, reader: Callable[[bytes, str], T]) -> T | None:
    """Apply a reader to the content and name of the manifest; None where there is none.

    Raises:
        Damaged: the reader refuses it.
    """
    path = directory / MANIFEST
    try:
        return reader(regular_file.content(path), str(path))
    except FileNotFoundError:
        return None
    except ModelError as problem:
        raise Damaged(f"{problem}, or remove {directory}") from problem
    except (ValueError, OSError) as problem:
        raise Damaged(f"{path} is damaged ({problem}): remove the directory") from problem


def _write_manifest(directory: Path, manifest: Manifest) -> None:
    ordered = manifest.replaced(
        **{name: dict(sorted(getattr(manifest, name).items())) for name in ("functions", "sha256")}
    )
    # one entry per line for readers; of thousands of bodies nobody reads, and lines take a minute
    rows = max(len(ordered.frames), len(ordered.joints))
    indent = 1 if rows <= READ else None
    content = sealed(vars(ordered), indent=indent, ensure_ascii=False, allow_nan=False).encode()
    _write(directory / MANIFEST, content)
    # opened in this process, the model has its manifest without reading the file
    remember(content, ordered)


def _line(name: str, saved: dict[str, Any]) -> str:
    return f"{json.dumps(name)}: {json.dumps(saved, separators=(',', ':'), allow_nan=False)}"


def _joined(saved: list[tuple[str, dict[str, Any]]]) -> str:
    """``functions.json``: one function per line, so that one more is cheap to add."""
    return "{\n" + ",\n".join(_line(*row) for row in saved) + "\n}\n"


def _appended(text: str, saved: list[tuple[str, dict[str, Any]]]) -> str:
    """The text with functions added or replaced."""
    names = {json.dumps(name) for name, _ in saved}
    lines = [line.rstrip(",") for line in text.splitlines()[1:-1]]
    lines = [line for line in lines if line.split(": ", 1)[0] not in names]
    return "{\n" + ",\n".join([*lines, *(_line(*row) for row in saved)]) + "\n}\n"


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
