"""The kernels as WebAssembly, compiled once for everybody, and modules that work on their memory.

``make wasm`` compiles them anew where their sources have changed.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import NamedTuple

from ..errors import BuildError
from . import kernel_files

FOLDER = kernel_files.KERNELS / "wasm"
INDEX = FOLDER / "index.json"


class WasmFunction(NamedTuple):
    """A generated function as a module.

    Attributes:
        kernels: Name of the module of the kernels that it calls.
        work_size, prepared_size: Lengths of work and w.
        module: The address of its constants -> the module, which exports the function and its
            ``prepare_``, and the first address behind the constants.
    """

    kernels: str
    work_size: int
    prepared_size: int
    module: Callable[[int], tuple[bytes, int]]


def path(name: str) -> Path:
    """The file of a module of the kernels."""
    return FOLDER / f"{name}.wasm"


@cache
def content(name: str) -> bytes:
    """A module of the kernels.

    Raises:
        BuildError: it is not there.
    """
    try:
        return path(name).read_bytes()
    except OSError as error:
        raise BuildError(
            f"{name}.wasm of cardan cannot be read: {error.strerror}. Install cardan again"
        ) from error


@cache
def places(name: str) -> dict[str, int]:
    """Addresses in the memory of a module of the kernels: of what it exports, and behind all it has
    (``heap_base``); and the length of its table (``table``), where others may use that."""
    index = json.loads(INDEX.read_text("utf-8"))
    return {key: int(value) for key, value in index["places"][name].items()}
