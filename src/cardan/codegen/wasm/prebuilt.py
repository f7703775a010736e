"""The kernels as WebAssembly, compiled once for everybody.

``python -m cardan.codegen.wasm.build`` compiles them anew where their sources have changed.
"""

from __future__ import annotations

import hashlib
import json
from functools import cache
from pathlib import Path
from typing import NamedTuple

from ...errors import BuildError
from ...schema import kernel_files

HERE = Path(__file__).parent
INDEX = HERE / "index.json"


class KernelModule(NamedTuple):
    """A module of the kernels.

    Attributes:
        name: Of its file.
        sources: C files of this folder.
        kernels, integrators: Files of the kernels to which others lead, and methods among them.
        optimization: For the compiler.
    """

    name: str
    sources: tuple[str, ...]
    kernels: tuple[str, ...] = ()
    integrators: tuple[str, ...] = ()
    optimization: str = "-O2"


MODULES = {
    module.name: module
    for module in (
        # what generated functions call
        KernelModule("functions", ("functions.c",)),
        KernelModule("superelements", ("functions.c", "superelements.c")),
        # runs of models in joint coordinates
        KernelModule("kernels", ("functions.c",), ("export.c", "simulate.c"), ("dop853",), "-Os"),
    )
}


def digest() -> str:
    """Hash of all sources."""
    total = hashlib.sha256()
    for path in (*kernel_files.files("*.[ch]"), *sorted(HERE.glob("*.c"))):
        content = path.read_bytes()
        total.update(f"\0{path.name}\0{len(content)}\0".encode())
        total.update(content)
    return total.hexdigest()


@cache
def places(name: str) -> dict[str, int]:
    """Addresses in the memory of a module of the kernels: of what it exports, and behind all it has
    (``heap_base``); and the length of its table (``table``)."""
    index = json.loads(INDEX.read_text("utf-8"))
    return {key: int(value) for key, value in index["places"][name].items()}


@cache
def content(name: str) -> bytes:
    """A module of the kernels.

    Raises:
        BuildError: it is not there.
    """
    try:
        return (HERE / f"{name}.wasm").read_bytes()
    except OSError as error:
        raise BuildError(
            f"{name}.wasm of cardan cannot be read: {error.strerror}. Install cardan again"
        ) from error
