"""From a Function to the text of its file and its entry in the manifest."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import field

from .. import passes
from ..ir.function import Function, Output
from ..ir.graph import ZERO
from ..ir.routine import Routine
from ..ir.trees.assembly import Assembly, Form
from ..processes import collector_paused
from ..records import dataclass
from ..schema.blocks import ORDER
from ..schema.c_functions import FunctionRow, ResultRow
from .languages import LANGUAGES
from .program import loops
from .program.lowering import lower, lower_routine
from .program.parts import LONGEST
from .program.program import Program


@dataclass(frozen=True)
class CFile:
    """A generated file.

    Attributes:
        name: C name of the function.
        text: The file.
        entry: What the manifest says about it.
        program: What was written.
        includes: Headers of cardan it needs.
        prepare_operations: Number of operations of its parameter stage, by operator.
    """

    name: str
    text: str = field(repr=False)
    entry: FunctionRow = field(repr=False)
    program: Program = field(repr=False)
    includes: tuple[str, ...] = ("cardan.h",)
    prepare_operations: dict[str, int] = field(default_factory=dict, repr=False)


def generate(
    function: Form,
    model: str = "",
    notes: Sequence[str] = (),
    longest: int = LONGEST,
    of: str | None = None,
    chosen: Sequence[str] | None = None,
) -> CFile:
    """Optimize a function and write it in C: straight-line, a recursion as loops over tables.

    The numbers of an assembly are written so, and behind them the call of its kernel.

    Args:
        function: The function; its name is the C name.
        model: Name of the model, for the reader.
        notes: Lines for the reader, such as the formalism.
        longest: Statements after which straight-line C is split.
        of: Frame or joint it belongs to.
        chosen: Passes by name; by default those that pay for the function.

    Raises:
        CodegenError: the name is none for C.
        ValueError: the expressions break a rule of the grammar.
    """
    with collector_paused():
        return _file(function, lowered(function, model, notes, longest, chosen), of)


def lowered(
    function: Form,
    model: str = "",
    notes: Sequence[str] = (),
    longest: int = LONGEST,
    chosen: Sequence[str] | None = None,
) -> Program:
    """Optimize a function and make it a program; arguments and errors as of :func:`generate`."""
    if isinstance(function, Routine):
        return lower_routine(function, model, notes)
    assembly = function if isinstance(function, Assembly) else None
    numbers = function.parts if isinstance(function, Assembly) else function
    parts = (numbers,) if isinstance(numbers, Function) else numbers.steps
    names = [passes.standard(part) if chosen is None else tuple(chosen) for part in parts]
    used = dict.fromkeys(name for pass_names in names for name in pass_names)
    notes = (*notes, f"passes: {', '.join(used) or 'none'}")
    with collector_paused():
        staged = [passes.optimize(*pair) for pair in zip(parts, names, strict=True)]
        if isinstance(numbers, Function):
            return lower(staged[0], model, notes, longest, assembly)
        return loops.lower(numbers, staged, model, notes, assembly)


def _file(function: Form, program: Program, of: str | None) -> CFile:
    """A program as text, with what the manifest says about it."""
    language = LANGUAGES["c"]
    text = language.write(program)
    text += language.sizes(function.name, _sizes(function, program))
    file = function.name + language.SUFFIX
    entry = _entry(function, program, file, text, of)
    includes = (*program.includes, *program.late_includes)
    return CFile(function.name, text, entry, program, includes, program.prepare_operations)


def _entry(function: Form, program: Program, file: str, text: str, of: str | None) -> FunctionRow:
    """Interface for a caller: blocks read, results, sizes."""
    blocks = set(program.blocks)
    return FunctionRow(
        file=file,
        symbol=function.name,
        of=of,
        about=function.about,
        inputs=[block.name for block in function.inputs if block.name in blocks],
        vector=[x for block in function.inputs if block.name == "v" for x in block.entries],
        outputs=[_result(output) for output in function.outputs],
        output_size=sum(output.size for output in function.outputs),
        work_size=program.work_size,
        prepared_size=program.prepared_size,
        lanes=[1, 2, 4, 8],
        operations=program.operations,
        headers=[*program.includes, *program.late_includes],
        sha256=hashlib.sha256(text.encode()).hexdigest(),
    )


def _sizes(function: Form, program: Program) -> list[int]:
    """Sizes of out, work and w, and of every block as far as it is read."""
    read = {block.name: len(block) for block in function.inputs if block.name in program.blocks}
    out = sum(output.size for output in function.outputs)
    return [out, program.work_size, program.prepared_size, *(read.get(b, 0) for b in ORDER)]


def _result(output: Output) -> ResultRow:
    """One result; of matrices also where they are not 0 for structural reasons."""
    matrix = len(output.shape) > 1
    return ResultRow(
        name=output.name,
        shape=list(output.shape),
        entries=list(output.entries),
        units=list(output.units),
        sparsity=[k for k, x in enumerate(output.nodes) if x != ZERO] if matrix else None,
    )
