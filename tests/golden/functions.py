"""What is written of the table of model functions: a stub for type checkers, and a page."""

from __future__ import annotations

import inspect
import textwrap
from collections.abc import Iterator

from cardan.runtime.calls.functions import Functions
from cardan.runtime.verification.routes import JUDGES
from cardan.schema.functions import FUNCTIONS, ModelFunction

# functions that have another route to their numbers
JUDGED = {*JUDGES}
HEAD = '''\
"""Written from the table of functions: pytest tests/golden/test_functions.py --accept"""

from abc import ABCMeta
from typing import Any

from numpy.typing import ArrayLike

from ...arrays import Array
from .evaluation import Evaluation, State, Values
from .methods import Axes, Energy

class Functions(Evaluation, metaclass=ABCMeta):
'''


def stub() -> str:
    """``runtime/calls/functions.pyi``."""
    methods = [name for name in FUNCTIONS if name in vars(Functions)]
    return HEAD + "\n".join(_method(name) for name in methods)


def _method(name: str) -> str:
    method = getattr(Functions, name)
    lines, starred = ["self"], False
    for one in list(inspect.signature(method).parameters.values())[1:]:
        if one.kind is one.KEYWORD_ONLY and not starred:
            lines.append("*")
            starred = True
        default = "" if one.default is one.empty else f" = {literal(one.default)}"
        lines.append(f"{one.name}: {one.annotation}{default}")
    text = f'"""{inspect.getdoc(method)}\n"""'
    return "\n".join(
        [
            f"    def {name}(",
            *(f"        {line}," for line in lines),
            f"    ) -> {method.__annotations__['return']}:",
            textwrap.indent(text, "        "),
            "",
        ]
    )


def literal(value: object) -> str:
    return f'"{value}"' if isinstance(value, str) else repr(value)


PAGE = """\
# Functions of a model

`cd.compile(scene)` gives a model with these functions. Each is derived, written and compiled when
it is first called. They broadcast over leading axes `...`, take vectors by name too
(`{"elbow": 0.3}`) and other parameters by `parameters={"upper.mass": 2.0}`; `help(model.rhs)` says
what a function takes. Sizes: nq coordinates, nu speeds, nz internal states, nx = nq + nu + nz,
ns modes, nr inputs, ne events, nlam multipliers, npositions of them of positions, ny outputs,
nphi inertial parameters. Equations [taken over from SymPy](sympy.md) tell of no bodies, inertias,
kinetic energy and causes of forces.

| function | gives | shape | unit | of systems with | over elements | [verified](verification.md) |
|---|---|---|---|---|---|---|
"""
INTERNAL = """
These have no method. Integrators and other functions call them, `equations.function(name)` gives
their expressions; `model.derivative` has [a page of its own](derivatives.md).

| function | gives | reads | over elements |
|---|---|---|---|
"""


def page() -> str:
    """``docs/functions.md``."""
    rows = FUNCTIONS.values()
    methods = [_row(row) for row in rows if row.name in vars(Functions)]
    others = [_internal(row) for row in rows if row.name not in vars(Functions)]
    return PAGE + "\n".join(methods) + "\n" + INTERNAL + "\n".join(others) + "\n"


def _row(row: ModelFunction) -> str:
    words = [
        one.name + ("=" if one.kind is one.KEYWORD_ONLY else "")
        for one in inspect.signature(getattr(Functions, row.name)).parameters.values()
        if one.name not in ("self", "out", "parameters")
    ]
    shape = ", ".join(["...", *row.shape.split()])
    cells = [f"`{row.name}({', '.join(words)})`", row.about, f"({shape})", row.unit]
    verified = row.name in JUDGED
    return _line([*cells, ", ".join(row.needs), "yes" * row.elements, "yes" * verified])


def _internal(row: ModelFunction) -> str:
    reads = ", ".join(row.arguments) or f"what its {row.of} reads"
    return _line([f"`{row.name}`", row.about, reads, "yes" * row.elements])


def _line(cells: list[str]) -> str:
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def written() -> Iterator[tuple[str, str]]:
    """Files by their path in the project."""
    yield "src/cardan/runtime/calls/functions.pyi", stub()
    yield "docs/functions.md", page()
