"""Models on disk and in pickles: source and manifest, never a binary."""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import TypeVar

from ... import regular_file
from ...errors import BuildError, ModelError
from ...schema.functions import FUNCTIONS
from ...schema.manifest import Manifest, checked_manifest
from ...schema.seal import sealed, unsealed
from ..build import cache, cache_folder
from ..calls.parameters import Parameters
from .loaded_model import LoadedModel

M = TypeVar("M", bound=LoadedModel)

NUMBERS = ".npz"  # tables of elements, as base64 among the texts
KINDS = (".c", ".h", ".json", NUMBERS)
MANIFEST = "manifest.json"
LARGEST = 1 << 30  # characters of all texts of a pickled model


def texts(directory: Path) -> dict[str, str]:
    """File name -> text of everything a model directory is made of."""
    return {
        path.name: _text(path)
        for path in sorted(directory.iterdir())
        if path.suffix in KINDS and not path.name.startswith(".")
    }


def _text(path: Path) -> str:
    if path.suffix == NUMBERS:
        return base64.b64encode(path.read_bytes()).decode("ascii")
    return path.read_text("utf-8")


def _content(name: str, text: str) -> bytes:
    """Content of a file of known text; empty where that is not a text of such a file."""
    if not name.endswith(NUMBERS):
        return text.encode()
    try:
        return base64.b64decode(text, validate=True)
    except ValueError:
        return b""


def unchanged(model: M) -> M:
    """The model, whose files are those that its manifest speaks of.

    Raises:
        ModelError: a file is another one, or missing.
    """
    with model._objects.files() as manifest:
        for name, sha256 in manifest.sha256.items():
            _verify(model.name, model.directory / name, sha256)
    return model


def _verify(model: str, path: Path, sha256: str) -> None:
    try:
        content = regular_file.content(path)
    except FileNotFoundError:
        raise ModelError(f"model '{model}': file {path} is missing") from None
    except OSError as error:
        raise ModelError(f"model '{model}': {path}: {error.strerror}") from error
    if hashlib.sha256(content).hexdigest() != sha256:
        raise ModelError(
            f"model '{model}': {path} is not the file its manifest speaks of. "
            "Copy or export the model again"
        )


def digest(files: Mapping[str, str]) -> str:
    """Hash of the texts of a model."""
    return hashlib.sha256(json.dumps(dict(files), sort_keys=True).encode()).hexdigest()


def parts(model: LoadedModel) -> tuple[object, ...]:
    """Arguments of :func:`restore` besides a class: source and manifest, never a binary.

    Functions of a frame or joint travel as far as they were used.
    """
    rows = (FUNCTIONS[name] for name in model.manifest.available if name in FUNCTIONS)
    model._objects.write(row.name for row in rows if not row.of and not row.rare)
    with model._objects.files() as manifest:
        files = texts(model.directory)
    # the model's own functions, where another one of the same folder has others
    files[MANIFEST] = sealed(vars(manifest), ensure_ascii=False, allow_nan=False)
    values = model.parameters.vector.tolist()
    # earlier versions read pickles of models that they know
    dtype = () if model._objects.dtype == "float64" else (model._objects.dtype,)
    return files, values, model._objects.reproducible, digest(files), *dtype


def restore(
    kind: type[M],
    files: dict[str, str],
    values: list[float],
    reproducible: bool,
    stated: str,
    dtype: str = "float64",
) -> M:
    """The model of a pickle: its texts, checked, then written once into the cache of this machine.

    Args:
        kind: What the model becomes.
        files: As :func:`texts` gives them.
        values: The parameters.
        reproducible: As the model was opened.
        stated: :func:`digest` of the files.
        dtype: As the model was opened.

    Raises:
        ModelError: the pickle was damaged or changed, or is of another version.
    """
    manifest = _checked(files, stated)
    if not isinstance(values, list) or len(values) != len(manifest.parameters):
        raise _damaged("it does not hold one value per parameter")
    name = f"models/{stated}"
    try:
        place = _written(cache_folder.directory() / name, files)
    except OSError as error:
        elsewhere = cache_folder.instead(cache_folder.directory(), str(error.strerror))
        try:
            place = _written(elsewhere / name, files)
        except OSError as again:
            raise BuildError(f"{elsewhere} cannot be written to ({again.strerror})") from again
    model = kind(place, reproducible=bool(reproducible), dtype=dtype)
    return model._with(Parameters(model.manifest, values))


def _checked(files: object, stated: object) -> Manifest:
    """The manifest of a pickle whose texts are all there, unchanged and in order."""
    if not isinstance(files, dict) or not all(
        isinstance(name, str) and isinstance(text, str) for name, text in files.items()
    ):
        raise _damaged("it holds no texts")
    wrong = [n for n in files if Path(n).name != n or Path(n).suffix not in KINDS]
    if wrong:
        raise _damaged(f"it cannot hold a file named {wrong[0]!r}")
    if sum(map(len, files.values())) > LARGEST:
        raise _damaged(f"its texts are longer than {LARGEST} characters")
    if digest(files) != stated:
        raise _damaged("its texts are not those it was made of")
    try:
        statement = unsealed(files.get(MANIFEST, "null").encode())
        saved = json.loads(files.get("functions.json", "{}"))
    except (ValueError, RecursionError) as error:
        raise _damaged(f"a file is not JSON: {error}") from None
    manifest = checked_manifest(statement, "a pickled model")
    if not isinstance(saved, dict):
        raise _damaged("functions.json holds no functions")
    stated_ones = {e.file: e.sha256 for e in manifest.functions.values()}
    for name, expected in {**stated_ones, **manifest.sha256}.items():
        if hashlib.sha256(_content(name, files.get(name, ""))).hexdigest() != expected:
            raise _damaged(f"{name} is not the file its manifest speaks of")
    return manifest


def _damaged(why: str) -> ModelError:
    return ModelError(f"this pickle holds no model of cardan: {why}. Pickle the model again")


def _written(place: Path, files: Mapping[str, str]) -> Path:
    """A folder with these texts."""
    place.mkdir(mode=0o700, parents=True, exist_ok=True)
    for name, text in files.items():
        content = _content(name, text)
        # what is there already is left alone: other processes may be reading it
        if not (place / name).is_file() or (place / name).read_bytes() != content:
            cache.publish(place / name, content)
    cache_folder.used(place)
    return place
