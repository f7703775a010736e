"""C99: the text of a Program."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import groupby
from typing import Any

from ...ir.graph import ZERO
from ..program.naming import comment
from ..program.program import (
    Angles,
    Array,
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
    Table,
    Value,
)
from .expressions import definitions

SUFFIX = ".c"
COLUMNS = 100
STEP = "    "
# so many zeros of a linear system are written one by one
FEW = 4

# what stands below is about states: several of them side by side, if the compiler is told so
LANES = '#include "lanes.h"'
BLOCKS = (
    *("t", "q", "u", "z", "s", "r", "w"),
    *("udot", "zdot", "lam", "tau", "wrench", "du", "q0", "e", "v"),
)
SIGNATURES = {
    "function": "CARDAN_API int {}(const cardan_in *in, real *CARDAN_RESTRICT out,"
    " real *CARDAN_RESTRICT work)",
    "part": "CARDAN_PART int {}(const cardan_in *in, real *CARDAN_RESTRICT out,"
    " real *CARDAN_RESTRICT work)",
    "prepare": "CARDAN_API void {}(const wreal *p, wreal *CARDAN_RESTRICT w)",
    "prepare_part": "CARDAN_PART void {}(const wreal *p, wreal *CARDAN_RESTRICT w)",
    "step": "CARDAN_PART int {}(const cardan_in *in, real *CARDAN_RESTRICT out,"
    " real *CARDAN_RESTRICT work, const int *at)",
    "prepare_step": "CARDAN_PART void {}(const wreal *p, wreal *CARDAN_RESTRICT w, const int *at)",
}
RUNS, PREPARES = ("in", "out", "work"), ("p", "w")
ARGUMENTS = {
    "function": RUNS,
    "part": RUNS,
    "step": (*RUNS, "at"),
    "prepare": PREPARES,
    "prepare_part": PREPARES,
    "prepare_step": (*PREPARES, "at"),
}


def write(program: Program) -> str:
    """The C file of a program; the same text for the same program, always."""
    lines = ["/*"]
    for number, paragraph in enumerate(program.head):
        lines.extend([" *"] if number else [])
        lines.extend(
            text_line for line in paragraph for text_line in _wrapped(f" * {line}", "", " *     ")
        )
    lines.append(" */")
    lines.extend(f'#include "{name}"' for name in program.includes)
    for table in program.tables:
        lines.extend(["", *_table(table)])
    writer: _Writer | None = None
    for routine in program.routines:
        if LANES not in lines and not routine.kind.startswith("prepare"):
            lines.extend(["", LANES, *(f'#include "{name}"' for name in program.late_includes)])
        # the parts of a routine share its expressions
        if writer is None or writer.scope is not routine.scope:
            writer = _Writer(routine.scope, program)
        lines.extend(["", *_routine(routine, writer)])
    return "\n".join(lines) + "\n"


def sizes(name: str, numbers: Sequence[int]) -> str:
    """Constant of the shared object that loaders compare with the manifest."""
    listed = ", ".join(map(str, numbers))
    return (
        "\n#ifdef CARDAN_LOADED\n/* numbers of out, work, w and of the blocks that are read: "
        f"see manifest.json */\nconst int {name}_sizes[] = {{{listed}}};\n#endif\n"
    )


def _table(table: Table) -> list[str]:
    """A constant array, wrapped."""
    kind = "int" if table.integer else "double"
    values = [str(int(v)) if table.integer else repr(float(v)) for v in table.values]
    head = f"static const {kind} {table.name}[{len(values)}] = {{"
    about = [f"/* {comment(table.comment)} */"] if table.comment else []
    return [*about, head, *_wrapped(", ".join(values), STEP, STEP), "};"]


def _routine(routine: Routine, writer: _Writer) -> list[str]:
    """A function: its inputs by letter, its sections, its status."""
    prepares = routine.kind.startswith("prepare")
    writer.touched, writer.checked = set(), False
    lines = writer.all(routine.body, STEP)
    arrays, named = writer.touched, writer.scope.arrays
    declared = [_array(name, named[name]) for name in named if name in arrays]
    arrays.update(named[name].base for name in named if name in arrays)
    body = [] if prepares else [_block(block) for block in BLOCKS if block in arrays]
    # what this routine leaves alone
    if body:
        arrays.add("in")
    unused = [name for name in ARGUMENTS[routine.kind] if name not in arrays]
    body.extend(f"{STEP}(void){name};" for name in unused)
    body.extend(declared)
    checked = writer.checked and not prepares
    if checked:
        body.append(f"{STEP}int status = CARDAN_OK;")
    body.extend(lines if body or not lines or lines[0] else lines[1:])
    if not prepares:
        body.append(f"{STEP}return {'status' if checked else 'CARDAN_OK'};")
    about = [f"/* {comment(routine.about)} */"] if routine.about else []
    signature = SIGNATURES[routine.kind].format(routine.name)
    return [*about, *_wrapped(signature, "", STEP), "{", *body, "}"]


def _block(block: str) -> str:
    """An input block by its letter."""
    return f"{STEP}const {'wreal' if block == 'w' else 'real'} *const {block} = in->{block};"


def _array(name: str, array: Array) -> str:
    """A part of work or w under its name."""
    kind, at = "wreal" if array.base == "w" else "real", f"{array.base} + {array.start}"
    if array.columns == 1:
        return f"{STEP}{kind} *const {name} = {at};"
    row = f"[{array.columns}]"
    return f"{STEP}{kind} (*const {name}){row} = ({kind} (*){row})({at});"


class _Writer:
    """Writes the statements of one scope.

    Attributes:
        touched: Arrays that were written about since this was last emptied.
        checked: Whether one of the statements has a status.
    """

    def __init__(self, scope: Scope, program: Program) -> None:
        self.program = program
        self.scope = scope
        self.definitions, self.texts = definitions(scope)
        self.touched: set[str] = set()
        self.checked = False

    def all(self, statements: Sequence[Statement], indent: str) -> list[str]:
        """The lines of statements."""
        lines: list[str] = []
        for statement in statements:
            _WRITERS[type(statement)](self, statement, indent, lines)
        return lines

    def _declare(self, s: Declare, indent: str, lines: list[str]) -> None:
        value = s.value
        text = self.definitions[value] if isinstance(value, int) else self._place(value)
        head = f"{indent}const {'wreal' if s.prepared else 'real'} {s.name} = "
        _line(head, text, s.comment, indent, lines)

    def _assign(self, s: Assign, indent: str, lines: list[str]) -> None:
        array = self.scope.arrays.get(s.target.array)
        text = self._number(s.value, (array.base if array else s.target.array) in PREPARES)
        _line(f"{indent}{self._place(s.target)} = ", text, s.comment, indent, lines)

    def _clear(self, s: Clear, indent: str, lines: list[str]) -> None:
        first = f"{s.target.array} + {s.target.at}" if s.target.at else s.target.array
        self.touched.add(s.target.array)
        lines.append(f"{indent}memset({first}, 0, {s.length} * sizeof(real));")

    def _number(self, value: Value, prepared: bool) -> str:
        """A value as an array of states has it, or as one of prepared parameters.

        Literals and, among states, parameters are plain numbers and become what the array holds.
        """
        text = self.texts[value][0] if isinstance(value, int) else self._place(value)
        if isinstance(value, Place):
            plain = value.array == "w" and not prepared
        else:
            plain = self.scope.graph.nodes[value][0] == "const" if prepared else self._plain(value)
        return f"CARDAN_{'W' if prepared else ''}REAL({text})" if plain else text

    def _plain(self, i: int) -> bool:
        """True when a node of a stage of states is made of literals and parameters."""
        node = self.scope.graph.nodes[i]
        if node[0] == "const":
            return True
        if node[0] == "var":
            return bool(node[1] == "p")
        if i in self.scope.outside:
            return True
        # only a changed sign can stand here: everything else of parameters is prepared
        return node[0] == "neg" and self._plain(node[1])

    def _angles(self, s: Angles, indent: str, lines: list[str]) -> None:
        """Three arrays and the call that fills two of them."""
        kind, n = "wreal" if s.prepared else "real", len(s.angles)
        angle, sine, cosine = s.names
        values = ", ".join(self._number(i, s.prepared) for i in s.angles)
        size = f"[CARDAN_PADDED({n})]"
        _line(f"{indent}const {kind} {angle}{size} = ", f"{{{values}}}", "", indent, lines)
        lines.append(f"{indent}{kind} {sine}{size}, {cosine}{size};")
        lines.append(f"{indent}cardan_sincos({n}, {angle}, {sine}, {cosine});")

    def _section(self, s: Section, indent: str, lines: list[str]) -> None:
        lines.append("")
        if s.title:
            lines.append(f"{indent}/* {comment(s.title)} */")
        lines.extend(f"{indent}/* {formula} */" for formula in s.formulas)
        for statement in s.body:
            _WRITERS[type(statement)](self, statement, indent, lines)

    def _call(self, s: Call, indent: str, lines: list[str]) -> None:
        lines.append(f"{indent}{self._run(s.routine)}")

    def _run(self, routine: str) -> str:
        """A routine of the file is called with what its caller has."""
        kind = next(r.kind for r in self.program.routines if r.name == routine)
        self.touched.update(ARGUMENTS[kind])
        self.checked = True
        status = "" if kind.startswith("prepare") else "status |= "
        return f"{status}{routine}({', '.join(ARGUMENTS[kind])});"

    def _kernel_call(self, s: KernelCall, indent: str, lines: list[str]) -> None:
        self.touched.update(RUNS)
        self.checked = True
        arguments = (*map(str, s.sizes), s.constants, *RUNS)
        lines.append(f"{indent}status |= {s.name}({', '.join(arguments)});")

    def _dispatch(self, s: Dispatch, indent: str, lines: list[str]) -> None:
        lines.append(f"{indent}const int *const at = {s.table} + {s.width} * {s.counter};")
        if len(s.steps) == 1:
            lines.append(f"{indent}{self._run(s.steps[0])}")
            return
        lines.append(f"{indent}switch (at[0]) {{")
        for number, step in enumerate(s.steps):
            last = number == len(s.steps) - 1
            case = "default" if last else f"case {number}"
            lines.append(f"{indent}{case}: {self._run(step)} break;")
        lines.append(f"{indent}}}")

    def _strided(self, s: StridedLoop, indent: str, lines: list[str]) -> None:
        size = len(s.steps) * s.width
        deep = indent + STEP
        advance = f"for (int k = 0; k < {size}; ++k) row[k]"
        lines.append(f"{indent}{{")
        lines.append(f"{deep}int row[{size}];")
        lines.append(f"{deep}{advance} = {s.table}[k];")
        lines.append(f"{deep}for (int i = 0; i < {s.times}; ++i) {{")
        for n, step in enumerate(s.steps):
            lines.append(f"{deep}{STEP}{{")
            lines.append(f"{deep}{STEP * 2}const int *const at = row + {s.width * n};")
            lines.append(f"{deep}{STEP * 2}{self._run(step)}")
            lines.append(f"{deep}{STEP}}}")
        lines.append(f"{deep}{STEP}{advance} += {s.table}[{size} + k];")
        lines.append(f"{deep}}}")
        lines.append(f"{indent}}}")

    def _solve(self, s: Solve, indent: str, lines: list[str]) -> None:
        """Write the missing entries of A and B into the arrays, then call the kernel."""
        size, array = s.n * s.n, self.scope.arrays[s.arrays[0]]
        at = 0
        for node, run in groupby(s.entries):
            start, at = at, at + len(list(run))
            if node == ZERO and at - start > FEW:
                begin, end = array.start + start, array.start + at
                zero = self._number(ZERO, array.base in PREPARES)
                lines.append(
                    f"{indent}for (int i = {begin}; i < {end}; ++i) {array.base}[i] = {zero};"
                )
                self.touched.add(array.base)
            elif node is not None:
                for k in range(start, at):
                    place = Place(s.arrays[k >= size], k - size * (k >= size))
                    self._assign(Assign(place, node), indent, lines)
        arguments = []
        for name in s.arrays:
            self.touched.add(name)
            arguments.append(f"{name}[0]" if self.scope.arrays[name].columns > 1 else name)
        status = "status |= " if array.base == "work" else "(void)"
        self.checked = True
        lines.append(f"{indent}/* {comment(s.comment)} */")
        call = f"{indent}{status}CARDAN_SOLVE({s.kind}, {s.n}, {s.m}, {', '.join(arguments)});"
        lines.extend(_wrapped(call, "", indent + STEP))

    def _loop(self, s: Loop, indent: str, lines: list[str]) -> None:
        inner = _Writer(s.scope, self.program)
        body = inner.all(s.body, indent + STEP)
        self.touched |= inner.touched
        self.checked |= inner.checked
        i = s.counter
        lines.append(f"{indent}for (int {i} = 0; {i} < {s.times}; ++{i}) {{")
        lines.extend([*body, f"{indent}}}"])

    def _place(self, place: Place) -> str:
        """An array element."""
        self.touched.add(place.array)
        at = place.at
        if isinstance(at, int):
            columns = (
                self.scope.arrays[place.array].columns if place.array in self.scope.arrays else 1
            )
            row = f"[{at // columns}]" if columns > 1 else ""
            return f"{place.array}{row}[{at % columns if row else at}]"
        stride = f"{at.stride} * " if at.stride != 1 else ""
        offset = f" + {at.offset}" if at.offset else ""
        text = f"{stride}{at.counter}"
        if at.table:
            self.touched.add(at.table)
            text = f"{at.table}[{text}]"
        return f"{place.array}[{text}{offset}]"


_WRITERS: dict[type, Callable[[_Writer, Any, str, list[str]], None]] = {
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


def _line(head: str, value: str, about: str, indent: str, lines: list[str]) -> None:
    """``head value; /* about */``, the comment above and the line wrapped where it is long."""
    line = f"{head}{value};"
    if about:
        if len(line) + len(about) + 7 <= COLUMNS:
            lines.append(f"{line} /* {about} */")
            return
        lines.append(f"{indent}/* {about} */")
    if len(line) > COLUMNS:
        lines.extend(_wrapped(line, "", indent + STEP))
    else:
        lines.append(line)


def _wrapped(text: str, first: str, indent: str) -> list[str]:
    """Text in lines of at most COLUMNS where spaces allow it, best before an operator."""
    lines, text = [], first + text
    while len(text) > COLUMNS:
        least = len(indent) + 1
        at = max(text.rfind(" + ", least, COLUMNS), text.rfind(" - ", least, COLUMNS))
        if at <= least:
            at = text.rfind(", ", least, COLUMNS) + 1
        if at <= least:
            at = text.rfind(" ", least, COLUMNS + 1)
        if at <= least:
            at = text.rfind("(", least, COLUMNS) + 1
        if at <= least:
            at = text.find(" ", COLUMNS)
        if at < 0:
            break
        lines.append(text[:at].rstrip())
        text = indent + text[at:].lstrip()
    return [*lines, text]
