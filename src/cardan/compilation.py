"""Compile scenes. C that was written for an equal scene is used without deriving equations again.

An entry of the cache names the folder of that C. Its key is a hash of the scene, of the arguments
of ``compile`` and of this version of cardan. Equations, and the rooms that derive them, are loaded
when a function is called whose C was never written.
"""

from __future__ import annotations

import copy
import hashlib
import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from . import regular_file
from .api.compiled_model import CompiledModel
from .arguments import checked
from .errors import ModelError, watched_warnings
from .runtime.build import cache as compile_cache
from .runtime.build import cache_folder
from .scene.content import content_hash
from .scene.scene import SceneRecord
from .schema.functions import STANDARD
from .schema.manifest import statement
from .schema.seal import is_sealed, sealed, unsealed
from .version import VERSION, source_state

if TYPE_CHECKING:
    from .equations.constraints.treatments import Treatment
    from .equations.finite_elements.record import FiniteElementRecord
    from .equations.record import EquationRecord

FOLDER = re.compile(r"[0-9a-f]{32}\Z")
MOST = 1 << 20  # bytes of an entry of the cache


@checked
def compile(
    scene: SceneRecord | EquationRecord | FiniteElementRecord,
    functions: Sequence[str] = STANDARD,
    directory: str | Path | None = None,
    *,
    coordinates: str | None = None,
    method: str | None = None,
    speeds: Mapping[str, object] | None = None,
    rewrites: Sequence[str] | None = None,
    specialize: bool | Sequence[str] | Mapping[str, float] | None = None,
    constraints: str | Treatment | None = None,
    branches: Mapping[str, str] | None = None,
    independent: Sequence[str] | None = None,
    plane: str | None = None,
    loops: bool | None = None,
    threads: int | None = None,
    reproducible: bool = False,
    dtype: str = "float64",
) -> CompiledModel:
    """C functions of a scene, written, compiled and checked when they are first used.

    Args:
        scene: A model or its equations.
        functions: What may be used; anything else is neither derived nor written.
        directory: Where C and manifest go; a folder of the cache by default.
        coordinates, method, speeds, rewrites: As :func:`derive` takes them.
        specialize, constraints, branches, independent, plane: As :func:`derive` takes them.
        loops: True writes recursions as loops over the bodies, False as straight-line code; by
            default systems of many bodies get loops: a little slower, but written and compiled in
            a time that does not grow with them.
        threads: That share a large batch of states; by default ``$CARDAN_THREADS``, else the cores
            that this process may use.
        reproducible: Equal bits from every compiler and processor, 10-30 % slower.
        dtype: ``"float32"``: batches of arrays of float32 are computed so; all else in doubles.

    Raises:
        DerivationError: an unknown function, or options for equations that are derived already.
        ModelError: no such dtype, or float32 in absolute coordinates.
        BuildError: no compiler, or a build that failed its check.
    """
    options = {
        "coordinates": coordinates, "method": method, "speeds": speeds, "rewrites": rewrites,
        "specialize": specialize, "constraints": constraints, "branches": branches,
        "independent": independent, "plane": plane,
    }  # fmt: skip

    # threads, and how C is compiled, change no equations: they are not part of the key
    how: dict[str, Any] = {"threads": threads, "reproducible": reproducible, "dtype": dtype}

    def derived(of: SceneRecord | EquationRecord | FiniteElementRecord) -> CompiledModel:
        # the rooms of the compiler are loaded when they are needed
        from .pipeline import compile_scene

        return compile_scene(of, functions, directory, options, loops, **how)

    if directory is not None or not isinstance(scene, SceneRecord):
        return derived(scene)
    key = content_hash(VERSION, source_state(), functions, options, loops, scene)
    model = key and _earlier(key, scene, derived, how)
    if model:
        return model
    with watched_warnings() as warnings:
        model = derived(scene)
    # a warning is given every time
    if key and not warnings:
        _remember(key, model)
    return model


class _Entry(NamedTuple):
    """Entry of the cache for a scene.

    Attributes:
        folder: Of its C, in the folder of models.
        available: Functions that it may have; None: all of its manifest.
        statement: Hash of what the manifest says of the model: the folder may hold another one by
            now, whole in itself.
    """

    folder: str
    available: Sequence[str] | None
    statement: str


def _hash(model: CompiledModel) -> str:
    return hashlib.sha256(statement(model._objects.manifest).encode()).hexdigest()


def _place(key: str) -> Path:
    return cache_folder.directory() / "models" / f"{key[:32]}.json"


def _remember(key: str, model: CompiledModel) -> None:
    """Let the next process know where the C of a scene is."""
    path = _place(key)
    # a model in a temporary folder is lost with this process
    if model.directory.parent != path.parent:
        return
    entry = _Entry(model.directory.name, model._objects.available, _hash(model))
    try:
        compile_cache.publish(path, sealed(entry._asdict()).encode())
    except OSError:
        return  # it is derived again


def _read(path: Path) -> _Entry | None:
    """An entry of the cache; None where there is none, or a damaged one."""
    try:
        entry = _Entry(**unsealed(regular_file.content(path, MOST), by_hand=False))
        names = [] if entry.available is None else entry.available
        sound = isinstance(names, list) and all(isinstance(name, str) for name in names)
        sound = sound and FOLDER.match(entry.folder) is not None
    except (OSError, TypeError, ValueError, RecursionError):
        return None
    return entry if sound else None


def _earlier(
    key: str,
    scene: SceneRecord,
    derive: Callable[[SceneRecord], CompiledModel],
    how: Mapping[str, Any],
) -> CompiledModel | None:
    """The model of an equal scene, whole; None where the cache has none."""
    path = _place(key)
    entry = _read(path)
    if entry is None:
        return None
    try:
        # whoever changes the scene afterwards, or what it refers to, changes nothing here
        as_written = copy.deepcopy(scene)
    except RecursionError:
        return None

    @cache
    def derived() -> CompiledModel:
        return derive(as_written)

    def provide(keys: Sequence[tuple[str, str | None]]) -> list[str]:
        """C names of functions; those whose C is missing are derived and written first."""
        objects = model._objects
        names = [objects.stored(*one) for one in keys if one[0] in (objects.available or (one[0],))]
        files = [objects.manifest.functions[name].file for name in filter(None, names)]
        if len(files) == len(keys) and all(_intact(folder, file, model) for file in files):
            return names
        return derived()._objects.symbols(keys)

    folder = path.parent / entry.folder
    try:
        model = CompiledModel(folder, provide, available=entry.available, **how)
    except ModelError:
        return None
    if not _is_as_written(folder, model, entry.statement):
        return None
    if not all(_intact(folder, Path(name).name, model) for name in model.manifest.sha256):
        return None
    for used in (path, folder):
        cache_folder.used(used)
    return model


def _is_as_written(folder: Path, model: CompiledModel, stated: str) -> bool:
    """True for a folder whose manifest has its hash, which was compared, and is of that model."""
    try:
        content = regular_file.content(folder / "manifest.json")
    except OSError:
        return False
    return is_sealed(content) and _hash(model) == stated


def _intact(folder: Path, name: str, model: CompiledModel) -> bool:
    """True for a file that is what the manifest says."""
    try:
        content = regular_file.content(folder / name)
    except OSError:
        return False
    return hashlib.sha256(content).hexdigest() == model.manifest.sha256.get(name)
