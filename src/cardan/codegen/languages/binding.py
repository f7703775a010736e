"""Bindings: calls of exported functions from other programs, their files and their use."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from pprint import pformat

from ...errors import counted
from ...schema.blocks import ARGUMENTS, COORDINATES
from ...schema.c_functions import FunctionRow, ResultRow
from ...schema.manifest import BLOCKS as BLOCK_KEYS
from ...schema.manifest import Manifest
from ...schema.request import Request, reads
from ..program.program import Program


@dataclass(frozen=True)
class BoundModel:
    """An exported model, as bindings are written from it.

    Attributes:
        manifest: What it is.
        programs: Its functions, for what is written from them and not around their C.
        start: Values to start from instead of those that the scene names, by block.
        flags: For the compiler.
    """

    manifest: Manifest
    programs: Sequence[Program]
    start: Mapping[str, Sequence[float]]
    flags: Sequence[str]


@dataclass(frozen=True)
class Binding:
    """Calls of exported functions from another program.

    Attributes:
        package: Name under which they are imported.
        files: Its files by name.
        listed: Names of these files, for the README; ``{package}`` stands for the name.
        use: How it is built and imported, for the README.
        jacobians: Whether every function comes with its derivatives along all that it takes.
        guide: More of the README.
        without_runs: Why integrators do not go with it, and what does; "" where they do.
    """

    package: Callable[[Manifest], str]
    files: Callable[[BoundModel], dict[str, str | bytes]]
    listed: str
    use: str
    jacobians: bool = False
    guide: Callable[[Manifest], str] = lambda manifest: ""
    without_runs: str = ""


@dataclass(frozen=True)
class Jacobian:
    """Columns of a derivative along one block.

    Attributes:
        symbol: C function that gives them.
        start: Where they begin in its result.
        columns: How many there are.
        nonzero: Entries that are not 0 at every state, row by row.
    """

    symbol: str
    start: int
    columns: int
    nonzero: tuple[int, ...]


@dataclass(frozen=True)
class BoundFunction:
    """A function with its derivatives.

    Attributes:
        symbol: In C.
        entry: Its row of the manifest.
        arguments: Blocks in the order in which users hand them over; ``x`` is one of them.
        blocks: The same, with the parts of x.
        jacobians: By block, ``p`` among them, as far as they were exported.
    """

    symbol: str
    entry: FunctionRow
    arguments: tuple[str, ...]
    blocks: tuple[str, ...]
    jacobians: dict[str, Jacobian]

    @property
    def result(self) -> ResultRow:
        """The result: several ones one after the other, as a compiled model has them."""
        outputs = self.entry.outputs
        if len(outputs) == 1:
            return outputs[0]
        name = "xdot" if "x" in self.arguments else self.symbol.split("__")[0]
        return ResultRow(name=name, shape=[self.entry.output_size])

    @property
    def derivatives(self) -> tuple[str, ...]:
        """C functions that give the Jacobians."""
        return tuple(dict.fromkeys(one.symbol for one in self.jacobians.values()))


def sizes(manifest: Manifest) -> dict[str, int]:
    """Length of every block."""
    size = {letter: len(manifest.block(letter)) for letter in BLOCK_KEYS}
    size |= {"t": 1, "z": len(manifest.z), "s": len(manifest.s)}
    size |= dict.fromkeys(("udot", "tau", "du"), size["u"])
    return size | {"x": size["q"] + size["u"] + size["z"]}


def bound(manifest: Manifest) -> list[BoundFunction]:
    """Functions of an export that come with derivatives."""
    functions, size = manifest.functions, sizes(manifest)
    jacobians: dict[tuple[str, str | None], dict[str, Jacobian]] = {}
    for symbol, entry in functions.items():
        if symbol.startswith("derivative__") and entry.of:
            request = Request.read(entry.of)
            by_block = jacobians.setdefault((request.function, request.of), {})
            by_block |= _jacobians(symbol, entry, size)
    result = []
    for symbol, entry in functions.items():
        name = symbol.split("__")[0]
        if (name, entry.of) in jacobians:
            # what it does not read would only be in the way
            taken = (x for x in reads(name, entry.of) if size[x])
            letters = [x for x in taken if not ARGUMENTS[x].default or x in entry.inputs]
            by_block = jacobians[name, entry.of]
            parts = [part for x in letters for part in (("q", "u", "z") if x == "x" else (x,))]
            blocks = tuple(block for block in parts if size[block])
            result.append(BoundFunction(symbol, entry, tuple(letters), blocks, by_block))
    return result


def arguments(name: str, entry: FunctionRow) -> list[str]:
    """Arguments as a compiled model takes them, as far as the C can read them."""
    letters = reads(name.split("__")[0], entry.of)
    usual = (*entry.inputs, "t", "r")
    return [x for x in letters if not ARGUMENTS[x].default or x in usual]


def _jacobians(symbol: str, entry: FunctionRow, size: dict[str, int]) -> dict[str, Jacobian]:
    """Columns of a derivative by block; those along coordinates are those of q."""
    result, start = {}, 0
    for output in entry.outputs:
        wrt, count = output.name.removeprefix("d_"), prod(output.shape)
        block = "q" if wrt == COORDINATES else wrt
        nonzero = range(count) if output.sparsity is None else output.sparsity
        result[block] = Jacobian(symbol, start, size[block], tuple(nonzero))
        start += count
    return result


def names(manifest: Manifest) -> dict[str, tuple[str, ...]]:
    """Names of entries by what the manifest calls them, and of the bodies."""
    listed = {
        BLOCK_KEYS[letter]: tuple(row.name for row in manifest.block(letter)) for letter in "qurp"
    }
    return {**listed, "bodies": tuple(part for body in manifest.bodies for part in body.parts)}


def summary(manifest: Manifest) -> str:
    """Numbers of coordinates, speeds and parameters, in words."""
    q, u, p = (len(manifest.block(letter)) for letter in "qup")
    return f"{counted(q, 'coordinate')}, {counted(u, 'speed')}, {counted(p, 'parameter')}."


def records(f: BoundFunction, manifest: Manifest, grouped: bool) -> list[str]:
    """C of a function and its derivatives as constants ``<symbol>_bound``: see binding.h.

    Args:
        f: The function.
        manifest: Of the model.
        grouped: Whether x is one argument; else its blocks are one each.
    """
    size, blocks = sizes(manifest), list[str]()
    rows = f.entry.output_size
    names = f.arguments if grouped else f.blocks
    for number, name in enumerate(names):
        start = 0
        for block in ("q", "u", "z") if name == "x" else (name,):
            if size[block]:
                field = f"offsetof(cardan_in, {block})"
                blocks.append(f"{{{field}, {size[block]}, {number}, {start}}}")
            start += size[block]
    longest = max(size["p"], *(size[name] for name in names), 1)
    table = f"{f.symbol}_blocks"
    lines = [f"static const cardan_bound_block {table}[] = {{"]
    lines += [*(f"    {block}," for block in blocks or ["{0, 0, 0, 0}"]), "};"]
    for symbol in (f.symbol, *f.derivatives):
        q = f.jacobians.get("q")
        columns = (q.start, rows) if q and q.symbol == symbol else (0, 0)
        lines += [
            f"static const cardan_bound {symbol}_bound = {{",
            f'    "{symbol}", {symbol}, prepare_{symbol},',
            f"    {symbol}_out_size, {symbol}_work_size, {symbol}_w_size,",
            f"    {table}, {len(blocks)}, {len(names)}, {longest}, {columns[0]}, {columns[1]},",
            "};",
        ]
    return lines


def literal(value: object) -> str:
    """Python text of names and numbers, wrapped."""
    return pformat(value, width=96, compact=True, sort_dicts=False)


def plain(text: str) -> str:
    """Words of the user inside a docstring."""
    printable = "".join(c if c.isprintable() else " " for c in text)
    return printable.replace("\\", "\\\\").replace('"', "'")
