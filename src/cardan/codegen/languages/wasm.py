"""WebAssembly: the functions of a Program, straight from its expressions.

The same operations in the same order as the C, nothing contracted, so that results have the bits of
a reproducible build. Functions have the interface of the C: they take addresses in the memory of
the kernels, of which they use the elementary functions and the solvers of linear systems.

Source: WebAssembly Core Specification 2.0, W3C, chapter 5 (binary format).
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping, Sequence
from itertools import groupby
from typing import Any

from ...ir.graph import ZERO
from ...schema.blocks import SLOT
from ..program.program import (
    Angles,
    Assign,
    Call,
    Declare,
    Dispatch,
    Index,
    KernelCall,
    Loop,
    Place,
    Program,
    Routine,
    Scope,
    Section,
    Solve,
    Statement,
    StridedLoop,
    Value,
)
from ..wasm.module import F64, I32, Code, Module, Signature, signed, unsigned

SUFFIX = ".wasm"
# where ``write`` puts constants: behind what the kernels have in their memory
FEW = 4

# what stands on the stack of a function: its parameters by name
PARAMETERS = {
    "function": ("in", "out", "work"),
    "part": ("in", "out", "work"),
    "step": ("in", "out", "work", "at"),
    "prepare": ("p", "w"),
    "prepare_part": ("p", "w"),
    "prepare_step": ("p", "w", "at"),
}
# instructions
GET, SET, TEE = b"\x20", b"\x21", b"\x22"
CONST_I, LOAD_I, STORE_I = b"\x41", b"\x28", b"\x36"
CONST_D, LOAD_D, STORE_D = b"\x44", b"\x2b", b"\x39"
ADD_I, MUL_I, OR_I, LESS_I, EQUAL_I = b"\x6a", b"\x6c", b"\x72", b"\x48", b"\x46"
EQ, NE, LT, GT, LE = b"\x61", b"\x62", b"\x63", b"\x64", b"\x65"
NUMBER = b"\xb8"  # of an unsigned int
SELECT, DROP, FILL = b"\x1b", b"\x1a", b"\xfc\x0b\0"
LOOP, REPEAT, IF, ELSE, END = b"\x03\x40", b"\x0d", b"\x04\x40", b"\x05", b"\x0b"
# operators that are instructions
PLAIN = {
    "add": b"\xa0",
    "sub": b"\xa1",
    "mul": b"\xa2",
    "div": b"\xa3",
    "neg": b"\x9a",
    "sqrt": b"\x9f",
    "abs": b"\x99",
    "floor": b"\x9c",
    "lt": LT + NUMBER,
    "le": LE + NUMBER,
    "eq": EQ + NUMBER,
}
ONE, TWO = Signature("d", "d"), Signature("dd", "d")
# functions of the kernels: sines and cosines of an array, those that operators call, solvers
SINCOS = "cardan_sincos", Signature("iiii")
CALLED = {
    **{
        name: (f"cardan_{name}", ONE)
        for name in (
            *("tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh"),
            *("asinh", "acosh", "atanh"),
        )
    },
    "atan2": ("cardan_atan2", TWO),
    "pow": ("cardan_pow", TWO),
}
STUMPFF = "cardan_stumpff", Signature("id", "d")
PIECEWISE = "cardan_piecewise", Signature("iiiiid", "d")
SOLVER = Signature("iiiii", "i")


def write(program: Program, base: int = 0) -> bytes:
    """The module of a program, which exports the function and its ``prepare_``.

    Args:
        program: What it computes.
        base: Address of its constants.
    """
    return module(program, base).encoded()


def module(program: Program, base: int) -> Module:
    """The same, with what follows its constants still open."""
    result = Module(base)
    add(result, program, exported=True)
    return result


def add(target: Module, program: Program, exported: bool = False) -> None:
    """Add the functions and tables of a program to a module; they have their names in C."""
    tables = {
        table.name: (target.integers if table.integer else target.doubles)(table.values)
        for table in program.tables
    }
    shared = _Shared(program, target, tables)
    for routine in program.routines:
        code = _Writer(routine, routine.scope, shared).code()
        kind = PARAMETERS[routine.kind]
        gives = "" if routine.kind.startswith("prepare") else "i"
        public = exported and routine.kind in ("function", "prepare")
        target.add(routine.name, Signature("i" * len(kind), gives), code, public)


class _Shared:
    """What the functions of a program share.

    Attributes:
        program, module: What is written, and into what.
        tables: Addresses of the constant arrays.
        kinds: Kind of every routine.
    """

    def __init__(self, program: Program, module: Module, tables: Mapping[str, int]) -> None:
        self.program = program
        self.module = module
        self.tables = tables
        self.kinds = {routine.name: routine.kind for routine in program.routines}
        self._scratch: dict[tuple[str, int], int] = {}

    def scratch(self, what: str, size: int) -> int:
        """Address of memory for what a function needs for some instructions: nothing recurses."""
        if (what, size) not in self._scratch:
            self._scratch[what, size] = self.module.constant(bytes(size))
        return self._scratch[what, size]


class _Writer:
    """Writes one function.

    Args:
        routine: The function.
        scope: What its expressions mean.
        shared: What it shares with others.
        outer: The writer of the statements around a loop, which has the same locals.
    """

    def __init__(
        self, routine: Routine, scope: Scope, shared: _Shared, outer: _Writer | None = None
    ) -> None:
        self.shared = shared
        self.scope = scope
        self.nodes = scope.graph.nodes
        self.kind = routine.kind
        self.routine = routine
        # names of values are identifiers; a dot stands before all others
        own = {f".{name}": k for k, name in enumerate(PARAMETERS[routine.kind])}
        self.locals: dict[str, int] = outer.locals if outer else own
        self.types: list[int] = outer.types if outer else []
        # arrays that hold sines and cosines, by name
        self.placed: dict[str, int] = outer.placed if outer else {}
        self.head: Code = outer.head if outer else []

    def code(self) -> Code:
        """Locals and instructions."""
        body = self.all(self.routine.body)
        if not self.kind.startswith("prepare"):
            body += self.get(self.local(".status", I32))
        declared = [(len([*run]), kind) for kind, run in groupby(self.types)]
        locals_ = unsigned(len(declared)) + b"".join(unsigned(n) + bytes([k]) for n, k in declared)
        return [locals_, *self.head, *body, END]

    def all(self, statements: Sequence[Statement]) -> Code:
        """Instructions of statements."""
        code: Code = []
        for statement in statements:
            code += _WRITERS[type(statement)](self, statement)
        return code

    # locals

    def local(self, name: str, kind: int = F64) -> int:
        """Number of a local by its name, which is made where it is new."""
        if name not in self.locals:
            self.locals[name] = len(PARAMETERS[self.kind]) + len(self.types)
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
        if array in self.shared.tables:
            return integer(self.shared.tables[array])
        # an input block: its pointer is read once
        number = self.local(f".{array}", I32)
        self.head += [*self.get(self.locals[".in"]), LOAD_I + memory(2, 4 * SLOT[array])]
        self.head += self.set(number)
        return self.get(number)

    # places

    def address(self, place: Place) -> tuple[Code, int]:
        """Address of an array element, and what is added to it."""
        name, start = place.array, 0
        if name in self.placed:
            base: Code = integer(self.placed[name])
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
        """What an operator node is."""
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
        self.shared.module.imported(name, signature)
        return name

    def _truth(self, i: int) -> Code:
        return [*self.read(i), *number(0.0), NE]

    def _both(self, node: Any, instruction: bytes) -> Code:
        return [*self._truth(node[1]), *self._truth(node[2]), instruction, NUMBER]

    def _and(self, node: Any) -> Code:
        return self._both(node, b"\x71")

    def _or(self, node: Any) -> Code:
        return self._both(node, OR_I)

    def _not(self, node: Any) -> Code:
        return [*self.read(node[1]), *number(0.0), EQ, NUMBER]

    def _select(self, node: Any) -> Code:
        return [*self.read(node[2]), *self.read(node[3]), *self._truth(node[1]), SELECT]

    def _extreme(self, node: Any, instruction: bytes) -> Code:
        """The second operand where a comparison with the first holds, else the first."""
        a, b = self.read(node[1]), self.read(node[2])
        first, second = (self.local(f".compared_{k}") for k in (1, 2))
        # operands may be of this kind themselves
        code: Code = [*a, *b, *self.set(second), *self.set(first)]
        code += [*self.get(second), *self.get(first)]
        return [*code, *self.get(first), *self.get(second), instruction, SELECT]

    def _min(self, node: Any) -> Code:
        return self._extreme(node, GT)

    def _max(self, node: Any) -> Code:
        return self._extreme(node, LT)

    def _sign(self, node: Any) -> Code:
        x = self.local(".compared_1")
        code: Code = [*number(0.0), *self.read(node[1]), TEE + unsigned(x), LT, NUMBER]
        return [*code, *self.get(x), *number(0.0), LT, NUMBER, PLAIN["sub"]]

    def _stumpff(self, node: Any) -> Code:
        order = int(self.nodes[node[1]][1])
        return [*integer(order), *self.read(node[2]), self.kernel(*STUMPFF)]

    def _table(self, node: Any) -> Code:
        k, derivative = int(self.nodes[node[1]][1]), int(self.nodes[node[2]][1])
        table, name = self.scope.graph.tables[k], self.scope.table(k)
        sizes = len(table.coefficients), len(table.coefficients[0])
        addresses = (self.shared.tables[f"{name}_{part}"] for part in ("breaks", "coefficients"))
        code: Code = [part for n in (*sizes, *addresses, derivative) for part in integer(n)]
        return [*code, *self.read(node[3]), self.kernel(*PIECEWISE)]

    # statements

    def _declare(self, s: Declare) -> Code:
        value = s.value
        code = self.definition(value) if isinstance(value, int) else self.loaded(value)
        return [*code, *self.set(self.local(s.name))]

    def _assign(self, s: Assign) -> Code:
        return self.stored(s.target, self.value(s.value))

    def _angles(self, s: Angles) -> Code:
        """Angles into memory, and the call that puts sines and cosines beside them."""
        count = len(s.angles)
        # an even number: the kernels take two at once
        places = [self.shared.scratch(part, 8 * (count + count % 2)) for part in ("x", "s", "c")]
        self.placed |= dict(zip(s.names, places, strict=True))
        code: Code = []
        for k, i in enumerate(s.angles):
            code += [*integer(places[0]), *self.read(i), STORE_D + memory(3, 8 * k)]
        code += [part for n in (count, *places) for part in integer(n)]
        return [*code, self.kernel(*SINCOS)]

    def _section(self, s: Section) -> Code:
        return self.all(s.body)

    def _call(self, s: Call) -> Code:
        return self._run(s.routine)

    def _run(self, routine: str) -> Code:
        """A function of the program is called with what its caller has."""
        kind = self.shared.kinds[routine]
        code: Code = [*self._arguments(kind), routine]
        return code if kind.startswith("prepare") else self._noted(code)

    def _arguments(self, kind: str) -> Code:
        """What a function of a kind is called with."""
        return [part for name in PARAMETERS[kind] for part in self.get(self.locals[f".{name}"])]

    def _noted(self, code: Code) -> Code:
        """A status that is kept."""
        status = self.local(".status", I32)
        return [*self.get(status), *code, OR_I, *self.set(status)]

    def _kernel_call(self, s: KernelCall) -> Code:
        signature = Signature("i" * (len(s.sizes) + 4), "i")
        code: Code = [part for n in s.sizes for part in integer(n)]
        code += integer(self.shared.tables[s.constants])
        code += self._arguments("function")
        return self._noted([*code, self.kernel(s.name, signature)])

    def _solve(self, s: Solve) -> Code:
        """Missing entries of A and B go into the arrays, then the kernel is called."""
        size, array = s.n * s.n, self.scope.arrays[s.arrays[0]]
        code: Code = []
        at = 0
        for node, run in groupby(s.entries):
            start, at = at, at + len(list(run))
            if node == ZERO and at - start > FEW:
                code += [*self.pointer(array.base), *integer(8 * (array.start + start)), ADD_I]
                code += [*integer(0), *integer(8 * (at - start)), FILL]
            elif node is not None:
                for k in range(start, at):
                    place = Place(s.arrays[k >= size], k - size * (k >= size))
                    code += self.stored(place, self.read(node))
        call: Code = [*integer(s.n), *integer(s.m)]
        for name in s.arrays:
            base, offset = self.address(Place(name, 0))
            call += [*base, *integer(offset), ADD_I]
        call.append(self.kernel(f"cardan_solve_{s.kind}", SOLVER))
        return [*code, *(self._noted(call) if array.base == "work" else [*call, DROP])]

    def _loop(self, s: Loop) -> Code:
        i = self.local(f".{s.counter}", I32)
        inner = _Writer(self.routine, s.scope, self.shared, self)
        return self._repeated(i, s.times, inner.all(s.body))

    def _repeated(self, i: int, times: int, body: Code) -> Code:
        """Instructions for i = 0 ... times - 1."""
        code: Code = [*integer(0), *self.set(i), LOOP, *body]
        code += [*self.get(i), *integer(1), ADD_I, TEE + unsigned(i)]
        return [*code, *integer(times), LESS_I, REPEAT + b"\0", END]

    def _dispatch(self, s: Dispatch) -> Code:
        at = self.local(".at", I32)
        code: Code = [*self.pointer(s.table), *self.get(self.locals[f".{s.counter}"])]
        code += [*integer(4 * s.width), MUL_I, ADD_I, *self.set(at)]
        return [*code, *self._chosen(s.steps, 0)]

    def _chosen(self, steps: Sequence[str], k: int) -> Code:
        """The step whose number the row begins with."""
        if k == len(steps) - 1:
            return self._run(steps[k])
        code: Code = [*self.get(self.locals[".at"]), LOAD_I + memory(2, 0)]
        code += [*integer(k), EQUAL_I, IF]
        return [*code, *self._run(steps[k]), ELSE, *self._chosen(steps, k + 1), END]

    def _strided(self, s: StridedLoop) -> Code:
        """Rows move on in memory of their own."""
        size, table = len(s.steps) * s.width, self.shared.tables[s.table]
        row = self.shared.scratch("row", 4 * size)
        at, i = self.local(".at", I32), self.local(".i", I32)
        code: Code = []
        for k in range(size):
            code += [*integer(row), *integer(table), LOAD_I + memory(2, 4 * k)]
            code.append(STORE_I + memory(2, 4 * k))
        body: Code = []
        for n, step in enumerate(s.steps):
            body += [*integer(row + 4 * s.width * n), *self.set(at), *self._run(step)]
        for k in range(size):
            body += [*integer(row), *integer(row), LOAD_I + memory(2, 4 * k)]
            body += [*integer(table), LOAD_I + memory(2, 4 * (size + k)), ADD_I]
            body.append(STORE_I + memory(2, 4 * k))
        return [*code, *self._repeated(i, s.times, body)]


def integer(value: int) -> Code:
    """A constant of 32 bits."""
    return [CONST_I + signed(value)]


def number(value: float) -> Code:
    """A constant double."""
    return [CONST_D + struct.pack("<d", value)]


def memory(alignment: int, offset: int) -> bytes:
    """What an instruction says about its place: a power of two and an offset."""
    return bytes([alignment]) + unsigned(offset)


_SPECIAL: dict[str, Callable[[_Writer, Any], Code]] = {
    "and": _Writer._and,
    "or": _Writer._or,
    "not": _Writer._not,
    "select": _Writer._select,
    "min": _Writer._min,
    "max": _Writer._max,
    "sign": _Writer._sign,
    "stumpff": _Writer._stumpff,
    "table": _Writer._table,
}
_WRITERS: dict[type, Callable[[_Writer, Any], Code]] = {
    Declare: _Writer._declare,
    Assign: _Writer._assign,
    Angles: _Writer._angles,
    Section: _Writer._section,
    Call: _Writer._call,
    Dispatch: _Writer._dispatch,
    KernelCall: _Writer._kernel_call,
    StridedLoop: _Writer._strided,
    Solve: _Writer._solve,
    Loop: _Writer._loop,
}
