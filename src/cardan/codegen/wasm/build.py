"""Compile the kernels to WebAssembly: ``python -m cardan.codegen.wasm.build``.

It needs the packages wasmtime and ziglang, this in the version that ``index.json`` names, to give
the same bytes.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path
from typing import NamedTuple

from ...schema import kernel_files, wasm_kernels
from ..export import linkage

HERE = Path(__file__).parent
# no data behind errno and no contraction: the bits of a reproducible build
FLAGS = (
    *("-std=c99", "-target", "wasm32-wasi", "-mexec-model=reactor", "-ffp-contract=off"),
    *("-fno-math-errno", "-fno-stack-protector", "-s", "-Wl,--gc-sections"),
    *("-Wl,-z,stack-size=65536", "-Wl,--export=__heap_base"),
)
# what a page calls
RUNS = (
    *("cardan_simulate", "cardan_simulation_size", "cardan_prepare", "cardan_prepared_size"),
    *("cardan_prepared_w", "cardan_work_length", "cardan_start_state"),
)
TABLE = ("-Wl,--export-table", "-Wl,--growable-table")


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
        KernelModule("functions", ("functions.c", "trees.c")),
        KernelModule("superelements", ("functions.c", "superelements.c", "trees.c")),
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


def build(folder: Path) -> None:
    """Compile all modules into a folder, with their index."""
    for module in MODULES.values():
        methods = [f"cardan_{one}_method" for one in module.integrators]
        exported = [f"-Wl,--export={one}" for one in (*(RUNS if methods else ()), *methods)]
        roots = [*module.kernels, *(f"{one}.c" for one in module.integrators)]
        sources = [kernel_files.file(n) for n in linkage.closure(roots) if n.endswith(".c")]
        sources += [HERE / name for name in module.sources]
        include = [f"-I{path}" for path in kernel_files.includes()]
        subprocess.run(
            [
                *(sys.executable, "-m", "ziglang", "cc", *FLAGS, module.optimization),
                *(TABLE if methods else ()),
                *exported,
                *include,
                *("-o", str(folder / f"{module.name}.wasm"), *map(str, sources)),
            ],
            check=True,
        )
    index = {
        "sources": digest(),
        "compiler": f"ziglang {version('ziglang')}",
        "places": {name: _places(folder / f"{name}.wasm") for name in MODULES},
    }
    (folder / wasm_kernels.INDEX.name).write_text(json.dumps(index, indent=1) + "\n", "utf-8")


def _places(path: Path) -> dict[str, int]:
    """Addresses that a module exports, and the length of its table."""
    import wasmtime

    store = wasmtime.Store()
    module = wasmtime.Module(store.engine, path.read_bytes())
    assert not module.imports, f"{path.name} needs more than itself"
    exports = wasmtime.Instance(store, module, []).exports(store)
    places: dict[str, int] = {}
    for name in (each.name for each in module.exports):
        one = exports[name]
        if isinstance(one, wasmtime.Global):
            places[name.removeprefix("__")] = int(one.value(store))
        elif isinstance(one, wasmtime.Table):
            places["table"] = one.size(store)
    return places


def main() -> None:
    """Compile them in their place."""
    with tempfile.TemporaryDirectory() as scratch:
        build(Path(scratch))
        for path in sorted(Path(scratch).iterdir()):
            shutil.copy(path, wasm_kernels.FOLDER / path.name)
            print(f"{path.name}: {path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
