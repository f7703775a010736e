"""Bindings: calls of exported functions from other programs, their files and their use."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import prod
from pprint import pformat

from ...errors import counted
from ...records import dataclass
from ...schema.blocks import ARGUMENTS, COORDINATES
from ...schema.c_functions import FunctionRow, ResultRow
from ...schema.functions import FUNCTIONS
from ...schema.manifest import BLOCKS as BLOCK_KEYS
from ...schema.manifest import Manifest
from ...schema.request import Request, reads
from ..program.program import Program

Pair = tuple[str, str | None]
# rows of the table that belong to a function
PRODUCTS = tuple(name for name, row in FUNCTIONS.items() if row.of == "function")


@dataclass(frozen=True)
class BoundModel:
    """An exported model, as bindings are written from it.

    Attributes:
        manifest: What it is.
        programs: Its functions, for what is written from them and not around their C.
        start: Values to start from instead of those that the scene names, by block.
        flags: For the compiler.
        swept: Methods of runs that have a gradient.
    """

    manifest: Manifest
    programs: Sequence[Program]
    start: Mapping[str, Sequence[float]]
    flags: Sequence[str]
    swept: tuple[str, ...] = ()


@dataclass(frozen=True)
class Binding:
    """Calls of exported functions from another program.

    Attributes:
        package: Name under which they are imported.
        files: Its files by name.
        listed: Names of these files, for the README; ``{package}`` stands for the name.
        use: How it is built and imported, for the README.
        jacobians: Whether every function comes with its derivatives along all that it takes.
        products: Products with these derivatives that functions come with too where they are named.
        guide: More of the README.
        without_runs: Why integrators do not go with it, and what does; "" where they do.
    """

    package: Callable[[Manifest], str]
    files: Callable[[BoundModel], dict[str, str | bytes]]
    listed: str
    use: str
    jacobians: bool = False
    products: tuple[str, ...] = ()
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
class Gradient:
    """Derivatives of the weighted sum of results along one block.

    Attributes:
        symbol: C function that gives them.
        start: Where they begin in its result.
    """

    symbol: str
    start: int


@dataclass(frozen=True)
class Hessian:
    """Second derivatives of the weighted sum of results.

    Attributes:
        symbol: C function that gives them.
        size: How many rows and columns there are.
        starts: Where the columns of every block begin.
        nonzero: Entries that are not 0 at every state, row by row.
    """

    symbol: str
    size: int
    starts: dict[str, int]
    nonzero: frozenset[int]


@dataclass(frozen=True)
class BoundFunction:
    """A function with its derivatives.

    Attributes:
        symbol: In C.
        entry: Its row of the manifest.
        arguments: Blocks in the order in which users hand them over; ``x`` is one of them.
        blocks: The same, with the parts of x.
        jacobians: By block, ``p`` among them, as far as they were exported.
        gradients: By block, as far as they were exported.
        hessian: None where it was not exported.
    """

    symbol: str
    entry: FunctionRow
    arguments: tuple[str, ...]
    blocks: tuple[str, ...]
    jacobians: dict[str, Jacobian]
    gradients: dict[str, Gradient]
    hessian: Hessian | None

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

    @property
    def products(self) -> tuple[str, ...]:
        """C functions that take weights of the results."""
        symbols = [one.symbol for one in self.gradients.values()]
        return (*dict.fromkeys(symbols), *([self.hessian.symbol] if self.hessian else []))


def sizes(manifest: Manifest) -> dict[str, int]:
    """Length of every block."""
    size = {letter: len(manifest.block(letter)) for letter in BLOCK_KEYS}
    size |= {"t": 1, "z": len(manifest.z), "s": len(manifest.s)}
    size |= dict.fromkeys(("udot", "tau", "du"), size["u"])
    return size | {"x": size["q"] + size["u"] + size["z"]}


def bound(manifest: Manifest) -> list[BoundFunction]:
    """Functions of an export that come with derivatives."""
    functions, size = manifest.functions, sizes(manifest)
    jacobians: dict[Pair, dict[str, Jacobian]] = {}
    gradients: dict[Pair, dict[str, Gradient]] = {}
    hessians: dict[Pair, Hessian] = {}
    for symbol, entry in functions.items():
        kind = symbol.split("__")[0]
        if kind not in PRODUCTS or not entry.of:
            continue
        request = Request.read(entry.of)
        pair = (request.function, request.of)
        if kind == "derivative":
            jacobians.setdefault(pair, {}).update(_jacobians(symbol, entry, size))
        elif kind == "vjp":
            gradients.setdefault(pair, {}).update(_gradients(symbol, entry))
        elif kind == "hessian":
            hessians[pair] = _hessian(symbol, entry, request.wrt, size)
    result = []
    for symbol, entry in functions.items():
        pair = (symbol.split("__")[0], entry.of)
        if pair in jacobians:
            # what it does not read would only be in the way
            taken = (x for x in reads(*pair) if size[x])
            letters = [x for x in taken if not ARGUMENTS[x].default or x in entry.inputs]
            parts = [part for x in letters for part in (("q", "u", "z") if x == "x" else (x,))]
            blocks = tuple(block for block in parts if size[block])
            products = (gradients.get(pair, {}), hessians.get(pair))
            one = BoundFunction(symbol, entry, tuple(letters), blocks, jacobians[pair], *products)
            result.append(one)
    return result


def arguments(name: str, entry: FunctionRow) -> list[str]:
    """Arguments as a compiled model takes them, as far as the C can read them."""
    letters = reads(name.split("__")[0], entry.of)
    usual = (*entry.inputs, "t", "r")
    return [x for x in letters if not ARGUMENTS[x].default or x in usual]


def about(block: str, entry: FunctionRow) -> str:
    """What a block is as an argument of a function; v has a length of its own in every one."""
    text = ARGUMENTS[block].text
    return text.replace("nv", str(len(entry.vector))) if block == "v" else text


def _jacobians(symbol: str, entry: FunctionRow, size: dict[str, int]) -> dict[str, Jacobian]:
    """Columns of a derivative by block; those along coordinates are those of q."""
    result, start = {}, 0
    for output in entry.outputs:
        block, count = _block(output.name.removeprefix("d_")), prod(output.shape)
        nonzero = range(count) if output.sparsity is None else output.sparsity
        result[block] = Jacobian(symbol, start, size[block], tuple(nonzero))
        start += count
    return result


def _gradients(symbol: str, entry: FunctionRow) -> dict[str, Gradient]:
    """Derivatives of a weighted sum by block; those along coordinates are those of q."""
    result, start = {}, 0
    for output in entry.outputs:
        result[_block(output.name.removeprefix("d_"))] = Gradient(symbol, start)
        start += prod(output.shape)
    return result


def _hessian(
    symbol: str, entry: FunctionRow, wrt: Sequence[str], size: Mapping[str, int]
) -> Hessian:
    """Second derivatives of a weighted sum, all blocks together."""
    starts, start = {}, 0
    for block in map(_block, wrt):
        starts[block] = start
        start += size[block]
    (output,) = entry.outputs
    nonzero = range(start * start) if output.sparsity is None else output.sparsity
    return Hessian(symbol, start, starts, frozenset(nonzero))


def _block(wrt: str) -> str:
    """The block of columns."""
    return "q" if wrt == COORDINATES else wrt


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


def records(
    f: BoundFunction, manifest: Manifest, grouped: bool, weights: Mapping[str, int] | None = None
) -> list[str]:
    """C of a function and its derivatives as constants ``<symbol>_bound``: see binding.h.

    Args:
        f: The function.
        manifest: Of the model.
        grouped: Whether x is one argument; else its blocks are one each.
        weights: Functions that take weights of the results -> number of that argument.
    """
    size, blocks = sizes(manifest), list[str]()
    names = f.arguments if grouped else f.blocks
    for number, name in enumerate(names):
        start = 0
        for block in ("q", "u", "z") if name == "x" else (name,):
            if size[block]:
                field = f"offsetof(cardan_in, {block})"
                blocks.append(f"{{{field}, {size[block]}, {number}, {start}}}")
            start += size[block]
    longest = max(size["p"], *(size[name] for name in names), 1)
    lines = _blocks(f.symbol, blocks)
    for symbol in (f.symbol, *f.derivatives):
        table = (f.symbol, len(blocks), len(names), longest)
        lines += _record(symbol, table, _columns(f, symbol, size["q"]))
    for symbol, number in (weights or {}).items():
        count = len(manifest.functions[symbol].vector)
        lines += _blocks(symbol, [*blocks, f"{{offsetof(cardan_in, v), {count}, {number}, 0}}"])
        # parameters stand behind the arguments of the function, weights behind all or between
        arguments = len(names) + (number == len(names))
        table = (symbol, len(blocks) + 1, arguments, max(longest, count))
        lines += _record(symbol, table, _columns(f, symbol, size["q"]))
    return lines


def _blocks(symbol: str, blocks: Sequence[str]) -> list[str]:
    """The table of the blocks that a function takes."""
    rows = [f"    {block}," for block in blocks or ["{0, 0, 0, 0}"]]
    return [f"static const cardan_bound_block {symbol}_blocks[] = {{", *rows, "};"]


def _columns(f: BoundFunction, symbol: str, coordinates: int) -> tuple[int, int, int, int]:
    """Where columns along the coordinates begin, rows, from row to row, whether of a Hessian."""
    q, gradient, hessian = f.jacobians.get("q"), f.gradients.get("q"), f.hessian
    if hessian and hessian.symbol == symbol and "q" in hessian.starts:
        return (hessian.starts["q"], hessian.size, hessian.size, 1)
    if q and q.symbol == symbol:
        return (q.start, f.entry.output_size, coordinates, 0)
    if gradient and gradient.symbol == symbol:
        return (gradient.start, 1, coordinates, 0)
    return (0, 0, 0, 0)


def _record(
    symbol: str, table: tuple[str, int, int, int], columns: tuple[int, int, int, int]
) -> list[str]:
    """The record of a C function."""
    name, blocks, arguments, longest = table
    numbers = ", ".join(map(str, (blocks, arguments, longest, *columns)))
    return [
        f"static const cardan_bound {symbol}_bound = {{",
        f'    "{symbol}", {symbol}, prepare_{symbol},',
        f"    {symbol}_out_size, {symbol}_work_size, {symbol}_w_size,",
        f"    {name}_blocks, {numbers},",
        "};",
    ]


def literal(value: object) -> str:
    """Python text of names and numbers, wrapped."""
    return pformat(value, width=96, compact=True, sort_dicts=False)


def plain(text: str) -> str:
    """Words of the user inside a docstring."""
    printable = "".join(c if c.isprintable() else " " for c in text)
    return printable.replace("\\", "\\\\").replace('"', "'")
