"""C99: the text of a Program."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..naming import comment
from ..program import (
    Assign,
    Branch,
    Call,
    Declare,
    Index,
    Loop,
    Place,
    Program,
    Routine,
    Scope,
    Section,
    Solve,
    Statement,
    Table,
    walk,
)
from .expressions import Piece, definitions

SUFFIX = ".c"
COLUMNS = 100
STEP = "    "

BLOCKS = ("t", "q", "u", "z", "s", "r", "w", "udot", "zdot", "lam", "tau", "wrench", "du", "q0")
SIGNATURES = {
    "function": "CARDAN_API int {}(const cardan_in *in, real *CARDAN_RESTRICT out,"
    " real *CARDAN_RESTRICT work)",
    "part": "CARDAN_PART int {}(const cardan_in *in, real *CARDAN_RESTRICT out,"
    " real *CARDAN_RESTRICT work)",
    "prepare": "CARDAN_API void {}(const real *p, wreal *CARDAN_RESTRICT w)",
    "prepare_part": "CARDAN_PART void {}(const real *p, wreal *CARDAN_RESTRICT w)",
}


def write(program: Program) -> str:
    """The C file of a program; the same text for the same program, always."""
    lines = ["/*"]
    for number, paragraph in enumerate(program.head):
        lines.extend([" *"] if number else [])
        lines.extend(f" * {line}".rstrip() for line in paragraph)
    lines.append(" */")
    lines.extend(f'#include "{name}"' for name in program.includes)
    for table in program.tables:
        lines.extend(["", *_table(table)])
    writer: _Writer | None = None
    for routine in program.routines:
        # the parts of a routine share its expressions
        if writer is None or writer.scope is not routine.scope:
            writer = _Writer(routine.scope, program)
        lines.extend(["", *_routine(routine, writer)])
    return "\n".join(lines) + "\n"


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
    inside = walk(routine.body)
    calls = any(isinstance(s, Call) for s in inside)
    arrays = _arrays(inside)
    body = [
        f"{STEP}const {'wreal' if block == 'w' else 'real'} *const {block} = in->{block};"
        for block in BLOCKS
        if block in arrays and not prepares
    ]
    # what this routine leaves alone
    arguments = ("p", "w") if prepares else ("in", "out", "work")
    used = {*arguments} if calls else arrays | ({"in"} if body else set())
    body.extend(f"{STEP}(void){name};" for name in arguments if name not in used)
    checked = not prepares and (calls or any(isinstance(s, Solve) for s in inside))
    if checked:
        body.append(f"{STEP}int status = CARDAN_OK;")
    for statement in routine.body:
        body.extend(writer.lines(statement, STEP))
    if not prepares:
        body.append(f"{STEP}return {'status' if checked else 'CARDAN_OK'};")
    about = [f"/* {comment(routine.about)} */"] if routine.about else []
    signature = SIGNATURES[routine.kind].format(routine.name)
    return [*about, *_wrapped(signature, "", STEP), "{", *body, "}"]


def _arrays(statements: Iterable[Statement]) -> set[str]:
    """Arrays that statements touch."""
    found: set[str] = set()
    for s in statements:
        if isinstance(s, Declare | Assign) and isinstance(s.value, Place):
            found.add(s.value.array)
        if isinstance(s, Assign):
            found.add(s.target.array)
        if isinstance(s, Solve):
            found.add(s.array)
    return found


class _Writer:
    """Writes the statements of one scope."""

    def __init__(self, scope: Scope, program: Program) -> None:
        self.program = program
        self.scope = scope
        self.definitions, self.pieces = definitions(scope)

    def lines(self, statement: Statement, indent: str) -> list[str]:
        """The lines of a statement."""
        if type(statement) is Declare:
            kind = "wreal" if statement.prepared else "real"
            head = f"{indent}const {kind} {statement.name} = "
            return _line(head, self._value(statement.value, True), statement.comment, indent)
        if type(statement) is Assign:
            head = f"{indent}{_place(statement.target)} = "
            return _line(head, self._value(statement.value), statement.comment, indent)
        if isinstance(statement, Section):
            title = [f"{indent}/* {comment(statement.title)} */"] if statement.title else []
            return ["", *title, *self._all(statement.body, indent)]
        if isinstance(statement, Solve):
            return self._solve(statement, indent)
        if isinstance(statement, Call):
            return [f"{indent}{self._call(statement.routine)}"]
        if isinstance(statement, Loop):
            i, n = statement.counter, statement.count
            inner = _Writer(statement.scope, self.program)
            head = f"{indent}for (int {i} = 0; {i} < {n}; ++{i}) {{"
            return [head, *inner._all(statement.body, indent + STEP), f"{indent}}}"]
        return self._branch(statement, indent)

    def _all(self, statements: Sequence[Statement], indent: str) -> list[str]:
        return [line for s in statements for line in self.lines(s, indent)]

    def _value(self, value: int | Place, define: bool = False) -> str:
        if isinstance(value, tuple):
            return _place(value)
        return self.definitions[value] if define else self.pieces[value][0]

    def _call(self, routine: str) -> str:
        kind = next(r.kind for r in self.program.routines if r.name == routine)
        return (
            f"{routine}(p, w);"
            if kind == "prepare_part"
            else f"status |= {routine}(in, out, work);"
        )

    def _solve(self, s: Solve, indent: str) -> list[str]:
        """A and B into the array, then the kernel."""
        right, scratch = s.start + s.n * s.n, s.start + s.n * (s.n + s.m)
        found = []
        for k, node in enumerate(s.entries):
            found.extend(
                _line(f"{indent}{s.array}[{s.start + k}] = ", self._value(node), "", indent)
            )
        kernel = "rank_revealing" if s.kind == "spd" else s.kind
        places = ", ".join(f"{s.array} + {at}" for at in (s.start, right, scratch))
        status = "status |= " if s.array == "work" else "(void)"
        call = f"{indent}{status}cardan_solve_{kernel}({s.n}, {s.m}, {places});"
        return [*found, call]

    def _branch(self, s: Branch, indent: str) -> list[str]:
        condition = self.pieces[s.condition][0]
        found = [f"{indent}if ({condition} != 0.0) {{", *self._all(s.then, indent + STEP)]
        if s.otherwise:
            found.extend([f"{indent}}} else {{", *self._all(s.otherwise, indent + STEP)])
        return [*found, f"{indent}}}"]


def _place(place: Place) -> str:
    """An array element."""
    index = place.index
    if isinstance(index, int):
        return f"{place.array}[{index}]"
    stride = f"{index.stride} * " if index.stride != 1 else ""
    offset = f" + {index.offset}" if index.offset else ""
    text = f"{stride}{index.counter}{offset}"
    return f"{place.array}[{index.table}[{text}]]" if index.table else f"{place.array}[{text}]"


def _line(head: str, value: str, about: str, indent: str) -> list[str]:
    """``head value; /* about */``, the comment above and the line wrapped where it is long."""
    line = f"{head}{value};"
    if len(line) + len(about) + 7 <= COLUMNS or not about and len(line) <= COLUMNS:
        return [f"{line} /* {about} */" if about else line]
    above = [f"{indent}/* {about} */"] if about else []
    return above + (_wrapped(line, "", indent + STEP) if len(line) > COLUMNS else [line])


def _wrapped(text: str, first: str, indent: str) -> list[str]:
    """Text in lines of at most COLUMNS where spaces allow it, best before an operator."""
    lines, text = [], first + text
    while len(text) > COLUMNS:
        least = len(indent) + 1
        at = max(text.rfind(sign, least, COLUMNS) for sign in (" + ", " - "))
        if at <= least:
            at = text.rfind(" ", least, COLUMNS + 1)
        if at <= least:
            at = text.find(" ", COLUMNS)
        if at < 0:
            break
        lines.append(text[:at].rstrip())
        text = indent + text[at + 1 :]
    return [*lines, text]


__all__ = ["SUFFIX", "Index", "Piece", "write"]
