"""WebAssembly: the functions of a Program, straight from its expressions.

The same operations in the same order as the C, nothing contracted, so that results have the bits of
a reproducible build. Functions have the interface of the C: they take addresses in the memory of
the kernels, of which they use the elementary functions and the solvers of linear systems. An export
has them in one module, and one of JavaScript that calls them.

Source: WebAssembly Core Specification 2.0, W3C, chapter 5 (binary format).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import groupby
from typing import Any

from ...ir.graph import ZERO
from ...schema import wasm_kernels
from ..program.program import (
    Angles,
    Assign,
    Call,
    Clear,
    Declare,
    Dispatch,
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
)
from ..wasm import javascript
from ..wasm.expressions import Context, Expressions
from ..wasm.instructions import (
    ADD_I,
    DROP,
    ELSE,
    END,
    EQUAL_I,
    FILL,
    IF,
    LESS_I,
    LOAD_I,
    LOOP,
    MUL_I,
    OR_I,
    REPEAT,
    SINCOS,
    SOLVER,
    STORE_D,
    STORE_I,
    TEE,
    integer,
    memory,
)
from ..wasm.module import I32, Code, Module, Signature, unsigned
from .binding import Binding, BoundModel

SUFFIX = ".wasm"
KERNELS = "functions"  # all that functions in joint coordinates call
# so many zeros of a linear system are written one by one
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
    context = Context(program, target, tables)
    for routine in program.routines:
        code = _Writer(routine, routine.scope, context).code()
        kind = PARAMETERS[routine.kind]
        gives = "" if routine.kind.startswith("prepare") else "i"
        public = exported and routine.kind in ("function", "prepare")
        target.add(routine.name, Signature("i" * len(kind), gives), code, public)


def files(model: BoundModel) -> dict[str, str | bytes]:
    """The functions as one module, the kernels that they call, and what loads both."""
    name = javascript.package(model.manifest)
    base = wasm_kernels.places(KERNELS)["heap_base"]
    written = Module(base + -base % 16)
    for program in model.programs:
        add(written, program, exported=True)
    return {
        f"{name}.wasm": written.encoded(),
        f"{KERNELS}.wasm": wasm_kernels.content(KERNELS),
        f"{name}.mjs": javascript.text(model, KERNELS, written.end),
        "example.mjs": javascript.example(model.manifest),
    }


BINDING = Binding(
    javascript.package,
    files,
    "`{package}.mjs`, `*.wasm`, `example.mjs`",
    "functions of JavaScript, in node and in pages: `node example.mjs`; no compiler, see below",
    guide=javascript.guide,
    without_runs="has functions and no runs: cd.page(scene), or cardan page, writes a page that "
    "simulates; language='c' exports C that does",
)


class _Writer(Expressions):
    """Writes the statements of one function.

    Args:
        routine: The function.
        scope: What its expressions mean.
        context: Of the functions of its program.
        outer: The writer of the statements around a loop, which has the same locals.
    """

    def __init__(
        self, routine: Routine, scope: Scope, context: Context, outer: _Writer | None = None
    ) -> None:
        super().__init__(PARAMETERS[routine.kind], scope, context, outer)
        self.routine = routine

    def code(self) -> Code:
        """Locals and instructions."""
        body = self.all(self.routine.body)
        if not self.routine.kind.startswith("prepare"):
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

    # statements

    def _declare(self, s: Declare) -> Code:
        value = s.value
        code = self.definition(value) if isinstance(value, int) else self.loaded(value)
        return [*code, *self.set(self.local(s.name))]

    def _assign(self, s: Assign) -> Code:
        return self.stored(s.target, self.value(s.value))

    def _clear(self, s: Clear) -> Code:
        base, offset = self.address(s.target)
        return [*base, *integer(offset), ADD_I, *integer(0), *integer(8 * s.length), FILL]

    def _angles(self, s: Angles) -> Code:
        """Angles into memory, and the call that puts sines and cosines beside them."""
        count = len(s.angles)
        # an even number: the kernels take two at once
        places = [self.context.scratch(part, 8 * (count + count % 2)) for part in ("x", "s", "c")]
        self.angles |= dict(zip(s.names, places, strict=True))
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
        kind = self.context.kinds[routine]
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
        code += integer(self.context.tables[s.constants])
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
        inner = _Writer(self.routine, s.scope, self.context, self)
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
        size, table = len(s.steps) * s.width, self.context.tables[s.table]
        row = self.context.scratch("row", 4 * size)
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


_WRITERS: dict[type, Callable[[_Writer, Any], Code]] = {
    Declare: _Writer._declare,
    Assign: _Writer._assign,
    Clear: _Writer._clear,
    Angles: _Writer._angles,
    Section: _Writer._section,
    Call: _Writer._call,
    Dispatch: _Writer._dispatch,
    KernelCall: _Writer._kernel_call,
    StridedLoop: _Writer._strided,
    Solve: _Writer._solve,
    Loop: _Writer._loop,
}
