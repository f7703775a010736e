"""One function of one model: loaded C, prepared parameters, and the way to call it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from functools import partial
from math import prod
from typing import Any

import numpy as np

from ...arrays import Array, on_lines
from ...errors import BuildError
from ...records import dataclass
from ...schema.blocks import ORDER, SLOT
from ...schema.c_functions import FunctionRow, ResultRow
from . import abi, abi_ctypes
from .batch import Batch
from .calling import Argument, Caller, sizes
from .code import Code
from .lanes import packed
from .parameters import Parameters


@dataclass(frozen=True)
class LoadedFunction:
    """A compiled function with the parameter values of a model.

    Attributes:
        name, of: As asked for: ``("pose", "hand")``.
        code: The C.
        w: Prepared parameters, (prepared_size,).
        caller: For any batch.
        fast: For one state: ``fast(out, *values)``; hands everything else to ``caller``.
        interpreted: Whether expressions are evaluated, as there is no compiler.
    """

    name: str
    of: str | None
    code: Code
    w: Array = field(repr=False)
    caller: Caller = field(repr=False)
    fast: Any = field(repr=False)
    interpreted: bool = False

    @property
    def symbol(self) -> str:
        """C name."""
        return self.code.symbol

    @property
    def address(self) -> int:
        """Address of the C function."""
        return self.code.address

    @property
    def entry(self) -> FunctionRow:
        """Entry in the manifest."""
        return self.code.entry

    @property
    def work_size(self) -> int:
        """Numbers of work memory a call needs."""
        return self.code.entry.work_size

    @property
    def outputs(self) -> list[ResultRow]:
        """Name, shape, entries and units of every result."""
        return list(self.code.entry.outputs)

    def prepared(self, p: Array) -> Array:
        """w of parameter vectors, (..., np) -> (..., nw)."""
        return prepare(self.code, p)


def prepare(code: Code, p: Array) -> Array:
    """Prepared parameters w of parameter vectors p, (..., np) -> (..., nw)."""
    if code.interpreted is not None:
        # expressions read the parameters themselves
        return np.ascontiguousarray(p, dtype=np.float64)
    lead = p.shape[:-1]
    return prepare_rows(code, p.reshape(prod(lead), p.shape[-1])).reshape(*lead, -1)


def prepare_rows(code: Code, p: Array) -> Array:
    """The same as the function takes it, (n, np) -> (ceil(n / lanes), nw * lanes)."""
    if code.interpreted is not None:
        return np.ascontiguousarray(p, dtype=np.float64)
    code.take({"p": p.shape[1]})
    rows = packed(p, code.lanes)
    w = on_lines(len(rows), code.entry.prepared_size * code.lanes)
    if w.size:
        abi.prepare(code.prepare, rows, w)
    return w


def calls(code: Code, block_values: Mapping[str, Array], n: int) -> tuple[Callable[[], Any], Array]:
    """Callable that evaluates a function at n states, and its results, packed as lanes are.

    Args:
        code: Its C.
        block_values: Block by name, (n, size), or (size,) for all states; with the parameters p.
        n: Number of states.
    """
    blocks: list[Array | None] = [None] * len(ORDER)
    strides = [0] * len(ORDER)
    for name, array in block_values.items():
        rows, slot = np.broadcast_to(array, (n, array.shape[-1])), SLOT[name]
        if name == "p":
            rows, slot = prepare_rows(code, rows), SLOT["w"]
        else:
            rows = packed(rows, code.lanes)
        # pointers of blocks without entries are read by nobody
        blocks[slot] = rows.reshape(-1) if rows.size else np.zeros(1)
        strides[slot] = rows.shape[1]
    size, work = code.entry.output_size, code.entry.work_size
    out = on_lines(-(-n // code.lanes), size * code.lanes)
    if code.interpreted is not None:
        return partial(code.interpreted.run, blocks, strides, out), out
    # this one has work memory for vectors
    run = abi_ctypes.run
    return partial(run, code.address, blocks, strides, len(out), out, work * code.lanes), out


def batches(
    code: Code, arguments: list[Argument], threads: int | None, dtype: str = "float64"
) -> dict[str, Batch]:
    """Runners of a function over many states, by the type of their numbers.

    Args:
        code: Its C.
        arguments: What it takes.
        threads: As asked for.
        dtype: ``"float32"``: there is one of floats too.
    """
    entry = code.entry
    read = [
        size if ORDER[slot] in entry.inputs else 0 for slot, size in enumerate(sizes(arguments))
    ]
    read[SLOT["w"]] = entry.prepared_size
    recipe = code.recipe if max(entry.lanes) > 1 else None
    address = code.address if code.interpreted is None else 0
    recipes = {"float64": recipe}
    if dtype == "float32":
        recipes[dtype] = recipe and replace(recipe, single=True)
    return {
        name: Batch(code.symbol, one, address, read, entry.work_size, threads)
        for name, one in recipes.items()
    }


def assemble(
    name: str,
    of: str | None,
    code: Code,
    arguments: list[Argument],
    p: Parameters,
    ways: Mapping[str, Batch],
) -> LoadedFunction:
    """A loaded function out of its C, what it takes, parameter values and the ways of batches.

    Raises:
        BuildError: the C reads a block that is not an argument.
    """
    provided = {ORDER[slot] for argument in arguments for slot, _ in argument.blocks} | {"p", "w"}
    unknown = [block for block in code.entry.inputs if block not in provided]
    if unknown:
        raise BuildError(f"{code.symbol} reads {', '.join(unknown)}, which {name} does not take")
    code.take({ORDER[slot]: size for a in arguments for slot, size in a.block_sizes})
    outputs = code.entry.outputs
    # one result keeps its shape; several are handed on as one flat row
    shape = tuple(outputs[0].shape) if len(outputs) == 1 else (code.entry.output_size,)
    w = prepare(code, p.vector)
    caller = Caller(
        f"{name}('{of}')" if of else name,
        code.address,
        arguments,
        shape,
        entry_names(outputs),
        code.entry.work_size,
        w,
        code.entry.total_operations,
        code.interpreted,
        ways["float64"],
        ways.get("float32"),
        partial(_sources, code, p),
    )
    interpreted = code.interpreted is not None
    fast = caller if interpreted else abi.fast(caller)
    return LoadedFunction(name, of, code, w, caller, fast, interpreted)


def _sources(code: Code, p: Parameters, place: int) -> dict[str, float]:
    """Parameters, with their values, that change a prepared one, by its place."""
    before = prepare(code, p.vector)[place]
    changed = np.tile(p.vector, (len(p), 1))
    np.fill_diagonal(changed, np.where(p.vector == 0, 1.0, 2 * p.vector))
    after = prepare(code, changed)[:, place]
    return {name: p[name] for name, x in zip(p, after, strict=True) if x != before}


def entry_names(outputs: Sequence[ResultRow]) -> list[str]:
    """Name of every number of a result, such as ``elbow.udot``."""
    names: list[str] = []
    for output in outputs:
        size = prod(output.shape)
        entries = output.entries
        names += entries if len(entries) == size else [f"{output.name}[{k}]" for k in range(size)]
    return names
