"""JAX: the exported C through jax.ffi, with exact first derivatives in both modes.

Reverse mode multiplies by Jacobians, or calls the C of a product with weights where that was
exported.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...schema.blocks import ARGUMENTS
from ...schema.manifest import Manifest
from ...schema.request import reads
from ...schema.rows import column
from ..program.naming import mangle
from ..sources import source
from . import binding
from .binding import BoundFunction, BoundModel

SUFFIX = ".c"
SIZED = ("q", "u", "z", "s", "r", "p", "udot", "tau", "x")

HEAD = '''\
"""{title}: functions of a multibody model for JAX.

{about} Speeds u are what robotics calls v, quaternions are (w, x, y, z), 6-vectors have the angular
part first, units are SI and radians. Needs jax, and a C compiler at the first import; runs on CPUs.

    import jax
    jax.config.update("jax_enable_x64", True)
    import {package}

Functions go with jax.jit, jax.vmap (one call for all states), jax.grad, jax.jacfwd and jax.jacrev.
Their first derivatives are exact; a unit quaternion counts by its direction. Leading axes
broadcast. ``parameters`` is a mapping of names to values, an array (..., {count}), or None for
those of the scene.
"""

import ctypes
import itertools
import pathlib

import jax
import jax.numpy as jnp

NAME = {name!r}
COORDINATES = {coordinates}
SPEEDS = {speeds}
INPUTS = {inputs}
PARAMETERS = {parameters}

_ENTRIES = {{"r": INPUTS, "p": PARAMETERS}}
# length of every block, or its values where nobody gives it
_SIZES = {sizes}
_DEFAULTS = {defaults}
# blocks of a function, length of its result, which derivatives give columns along a block, and
# which gradients of weighted sums give entries along it
_TABLE = {table}
_PACKAGE = {package!r}
_FLAGS = {flags}
'''


def package(manifest: Manifest) -> str:
    """Name of the module."""
    return f"{mangle(manifest.name).lower()}_jax"


def files(model: BoundModel) -> dict[str, str | bytes]:
    """The C of the handlers and the module that registers them."""
    manifest = model.manifest
    functions = binding.bound(manifest)
    lines = [source("jax.c")]
    for f in functions:
        # weights stand behind the blocks, parameters last
        weights = dict.fromkeys(f.products, len(f.blocks))
        lines += [f"/* {f.symbol} */"]
        lines += binding.records(f, manifest, grouped=False, weights=weights)
        symbols = (f.symbol, *f.derivatives, *f.products)
        lines += [*(f"DEFINE({symbol})" for symbol in symbols), ""]
    lines += [source("jax_gradient.c")] if model.swept else []
    head = _head(manifest, functions, package(manifest), model.flags)
    parts = [head, source("library.txt"), source("jax.txt")]
    if model.swept:
        parts += [
            f"METHODS = {binding.literal(list(model.swept))}\n\n\n",
            source("jax_gradient.txt"),
        ]
    return {
        "binding.h": source("binding.h"),
        "jax.c": "\n".join([*lines, "#endif", ""]),
        f"{package(manifest)}.py": "".join(parts) + "\n\n".join(map(_function, functions)),
    }


def _head(
    manifest: Manifest, functions: Sequence[BoundFunction], name: str, flags: Sequence[str]
) -> str:
    """Names, tables and where the scene starts."""
    size = binding.sizes(manifest)
    defaults = {b: [float(x) for x in column(manifest.block(b), "default")] for b in "zsrp"}
    listed = {key: binding.literal(value) for key, value in binding.names(manifest).items()}
    return HEAD.format(
        title=binding.plain(manifest.name),
        name=manifest.name,
        about=binding.summary(manifest),
        count=size["p"],
        package=name,
        sizes=binding.literal({block: size[block] for block in SIZED}),
        defaults=binding.literal(defaults | {"tau": [0.0] * size["tau"]}),
        table=binding.literal({f.symbol: _row(f, manifest) for f in functions}),
        flags=binding.literal(list(flags)),
        **listed,
    )


def _row(f: BoundFunction, manifest: Manifest) -> tuple[object, ...]:
    """Blocks, length of the result, derivatives, gradients."""
    size = binding.sizes(manifest)
    rows: list[dict[str, list[object]]] = []
    for parts in (f.jacobians, f.gradients):
        by_symbol: dict[str, list[object]] = {}
        for block, one in parts.items():
            row = by_symbol.setdefault(one.symbol, [manifest.functions[one.symbol].output_size])
            if block in (*f.blocks, "p"):
                row.append((block, one.start, size[block]))
        rows.append(by_symbol)
    tables = [{symbol: tuple(row) for symbol, row in by_symbol.items()} for by_symbol in rows]
    return ((*f.blocks, "p"), f.entry.output_size, *tables)


def _function(f: BoundFunction) -> str:
    """The Python function of one C function."""
    letters = reads(f.symbol.split("__")[0], f.entry.of)
    # solvers call rhs(t, x)
    takes = ["t", *f.arguments] if "x" in letters and "t" not in f.arguments else [*f.arguments]
    needed = [x for x in takes if not ARGUMENTS[x].default or (x == "t" and "x" in letters)]
    options = [f"{x}={'0.0' if x == 't' else 'None'}" for x in takes if x not in needed]
    shape = tuple(f.result.shape)
    lines = [f"def {f.symbol}({', '.join([*needed, '*', *options, 'parameters=None'])}):"]
    lines += [f'    """{binding.plain(f.entry.about or f.symbol)}.', "", "    Args:"]
    lines += [f"        {x}: {ARGUMENTS[x].text}" for x in takes]
    lines += ["", "    Returns:", f"        Array (..., {', '.join(map(str, shape))})"]
    row = ", ".join(f'"{x}": {x}' for x in takes)
    call = f'    return _evaluate("{f.symbol}", {shape!r}, {{{row}}}, parameters)'
    return "\n".join([*lines, '    """', call, ""])


BINDING = binding.Binding(
    package,
    files,
    "`jax.c`, `{package}.py`",
    "functions of JAX with exact first derivatives: `import {package}` here compiles them",
    jacobians=True,
    products=("vjp",),
)
