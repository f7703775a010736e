"""Models that were saved, opened again as what users hold."""

from __future__ import annotations

from pathlib import Path

from ..arguments import checked
from ..errors import ModelError
from ..runtime.models.saved_models import parts, restore, unchanged
from ..version import PICKLE, VERSION
from .compiled_model import CompiledModel


@checked
def load(directory: str | Path, *, dtype: str = "float64") -> CompiledModel:
    """Open a model directory written by ``export`` or found in a cache.

    Needs neither SymPy nor the compiler half of cardan, only a C compiler. The C in it runs as
    you: open no directory and no pickle from somebody you do not trust.

    Args:
        directory: With ``manifest.json`` and the C files.
        dtype: ``"float32"``: batches whose arrays are of float32 are computed so, as with
            :func:`cardan.compile`.

    Raises:
        ModelError: no manifest, a file is not the one the manifest speaks of, or no such dtype.
    """
    return unchanged(CompiledModel(directory, dtype=dtype))


def reduced(model: CompiledModel) -> tuple[object, ...]:
    """Return value of ``__reduce__`` of a model."""
    return _unpickled_model, (PICKLE.version, VERSION, *parts(model))


def _unpickled_model(
    version: int,
    writer: str,
    files: dict[str, str],
    values: list[float],
    reproducible: bool,
    stated: str,
    dtype: str = "float64",
) -> CompiledModel:
    """The model of a pickle, which names this function as one of ``cardan`` itself.

    Raises:
        ModelError: it is of another version, was damaged or changed.
    """
    if not PICKLE.reads(version):
        raise ModelError(PICKLE.refusal("this pickle of a model", version, writer))
    return restore(CompiledModel, files, values, reproducible, stated, dtype)


# pickles find it wherever it stands
_unpickled_model.__module__ = "cardan"
