"""Numbers in WebAssembly: array elements, values with a name, and what operators make of them."""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping

from ...ir.graph import Node
from ...schema.blocks import SLOT
from ..program.program import Index, Place, Program, Scope, Value
from .instructions import (
    ADD_I,
    CALLED,
    CONST_D,
    EQ,
    GET,
    GT,
    LOAD_D,
    LOAD_I,
    LT,
    MUL_I,
    NE,
    NUMBER,
    OR_I,
    PIECEWISE,
    PLAIN,
    SELECT,
    SET,
    STORE_D,
    STUMPFF,
    TEE,
    integer,
    memory,
    number,
)
from .module import F64, I32, Code, Module, Signature, unsigned


class Context:
    """What the functions of a program have in common.

    Attributes:
        module: What they are written into.
        tables: Addresses of the constant arrays.
        kinds: Kind of every routine.
    """

    def __init__(self, program: Program, module: Module, tables: Mapping[str, int]) -> None:
        self.module = module
        self.tables = tables
        self.kinds = {routine.name: routine.kind for routine in program.routines}
        self._scratch: dict[tuple[str, int], int] = {}

    def scratch(self, what: str, size: int) -> int:
        """Address of memory for what a function needs for some instructions: nothing recurses."""
        if (what, size) not in self._scratch:
            self._scratch[what, size] = self.module.constant(bytes(size))
        return self._scratch[what, size]


class Expressions:
    """Instructions that leave a number on the stack.

    Args:
        parameters: Names of what the function takes.
        scope: What its expressions mean.
        context: Of the functions of its program.
        outer: The statements around a loop, which have the same locals.
    """

    def __init__(
        self,
        parameters: tuple[str, ...],
        scope: Scope,
        context: Context,
        outer: Expressions | None = None,
    ) -> None:
        self.context = context
        self.scope = scope
        self.nodes = scope.graph.nodes
        self.parameters = parameters
        # names of values are identifiers; a dot stands before all others
        numbers = {f".{name}": k for k, name in enumerate(parameters)}
        self.locals: dict[str, int] = outer.locals if outer else numbers
        self.types: list[int] = outer.types if outer else []
        # addresses of arrays that hold sines and cosines, by name
        self.angles: dict[str, int] = outer.angles if outer else {}
        self.head: Code = outer.head if outer else []

    # locals

    def local(self, name: str, kind: int = F64) -> int:
        """Number of a local by its name, which is made where it is new."""
        if name not in self.locals:
            self.locals[name] = len(self.parameters) + len(self.types)
            self.types.append(kind)
        return self.locals[name]

    def get(self, number: int) -> Code:
        return [GET + unsigned(number)]

    def set(self, number: int) -> Code:
        return [SET + unsigned(number)]

    def pointer(self, array: str) -> Code:
        """Address where an array begins: a parameter, an input block, a table."""
        if f".{array}" in self.locals:
            return self.get(self.locals[f".{array}"])
        if array in self.context.tables:
            return integer(self.context.tables[array])
        # an input block: its pointer is read once
        number = self.local(f".{array}", I32)
        self.head += [*self.get(self.locals[".in"]), LOAD_I + memory(2, 4 * SLOT[array])]
        self.head += self.set(number)
        return self.get(number)

    # places

    def address(self, place: Place) -> tuple[Code, int]:
        """Address of an array element, and what is added to it."""
        name, start = place.array, 0
        if name in self.angles:
            base: Code = integer(self.angles[name])
        else:
            array = self.scope.arrays.get(name)
            name, start = (array.base, array.start) if array else (name, 0)
            base = self.pointer(name)
        at = place.at
        if isinstance(at, int):
            return base, 8 * (start + at)
        return [*base, *self.index(at), *integer(8), MUL_I, ADD_I], 8 * (start + at.offset)

    def index(self, at: Index) -> Code:
        """An index without its offset."""
        literal = at.counter.isdigit()
        if literal and not at.table:
            return integer(at.stride * int(at.counter))
        if literal:
            shift = 4 * at.stride * int(at.counter)
            return [*self.pointer(at.table), LOAD_I + memory(2, shift)]
        counted: Code = [*self.get(self.locals[f".{at.counter}"]), *integer(at.stride), MUL_I]
        if not at.table:
            return counted
        return [*self.pointer(at.table), *counted, *integer(4), MUL_I, ADD_I, LOAD_I + memory(2, 0)]

    def loaded(self, place: Place) -> Code:
        base, offset = self.address(place)
        return [*base, LOAD_D + memory(3, offset)]

    def stored(self, place: Place, value: Code) -> Code:
        base, offset = self.address(place)
        return [*base, *value, STORE_D + memory(3, offset)]

    # expressions

    def value(self, value: Value) -> Code:
        """A number: of a node as it is read, or of an array element."""
        return self.loaded(value) if isinstance(value, Place) else self.read(value)

    def read(self, i: int) -> Code:
        """A node by its name where it has one that was declared here."""
        name = self.scope.names.get(i)
        return self.definition(i) if name is None else self.get(self.locals[name])

    def definition(self, i: int) -> Code:
        """The code of a node by what it computes."""
        node = self.nodes[i]
        op = node[0]
        if op == "const":
            return [CONST_D + struct.pack("<d", node[1])]
        if op in PLAIN or op in CALLED:
            code: Code = [part for k in node[1:] for part in self.read(k)]
            return [*code, PLAIN[op] if op in PLAIN else self.kernel(*CALLED[op])]
        return _SPECIAL[op](self, node)

    def kernel(self, name: str, signature: Signature) -> str:
        """A call of a function of the kernels."""
        self.context.module.imported(name, signature)
        return name

    def _nonzero(self, i: int) -> Code:
        return [*self.read(i), *number(0.0), NE]

    def _both(self, node: Node, instruction: bytes) -> Code:
        return [*self._nonzero(node[1]), *self._nonzero(node[2]), instruction, NUMBER]

    def _and(self, node: Node) -> Code:
        return self._both(node, b"\x71")

    def _or(self, node: Node) -> Code:
        return self._both(node, OR_I)

    def _not(self, node: Node) -> Code:
        return [*self.read(node[1]), *number(0.0), EQ, NUMBER]

    def _select(self, node: Node) -> Code:
        return [*self.read(node[2]), *self.read(node[3]), *self._nonzero(node[1]), SELECT]

    def _extreme(self, node: Node, instruction: bytes) -> Code:
        """The second operand where a comparison with the first holds, else the first."""
        a, b = self.read(node[1]), self.read(node[2])
        first, second = (self.local(f".compared_{k}") for k in (1, 2))
        # operands may be of this kind themselves
        code: Code = [*a, *b, *self.set(second), *self.set(first)]
        code += [*self.get(second), *self.get(first)]
        return [*code, *self.get(first), *self.get(second), instruction, SELECT]

    def _min(self, node: Node) -> Code:
        return self._extreme(node, GT)

    def _max(self, node: Node) -> Code:
        return self._extreme(node, LT)

    def _sign(self, node: Node) -> Code:
        x = self.local(".compared_1")
        code: Code = [*number(0.0), *self.read(node[1]), TEE + unsigned(x), LT, NUMBER]
        return [*code, *self.get(x), *number(0.0), LT, NUMBER, PLAIN["sub"]]

    def _stumpff(self, node: Node) -> Code:
        order = int(self.nodes[node[1]][1])
        return [*integer(order), *self.read(node[2]), self.kernel(*STUMPFF)]

    def _table(self, node: Node) -> Code:
        k, derivative = int(self.nodes[node[1]][1]), int(self.nodes[node[2]][1])
        table, name = self.scope.graph.tables[k], self.scope.table(k)
        sizes = len(table.coefficients), len(table.coefficients[0])
        addresses = (self.context.tables[f"{name}_{part}"] for part in ("breaks", "coefficients"))
        code: Code = [part for n in (*sizes, *addresses, derivative) for part in integer(n)]
        return [*code, *self.read(node[3]), self.kernel(*PIECEWISE)]


_SPECIAL: dict[str, Callable[[Expressions, Node], Code]] = {
    "and": Expressions._and,
    "or": Expressions._or,
    "not": Expressions._not,
    "select": Expressions._select,
    "min": Expressions._min,
    "max": Expressions._max,
    "sign": Expressions._sign,
    "stumpff": Expressions._stumpff,
    "table": Expressions._table,
}
