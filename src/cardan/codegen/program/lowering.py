"""From a staged Function to a Program: the parameter stage, the stage that runs, and the head."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from ...errors import CodegenError
from ...ir.function import Function, Output, Staged
from ...ir.routine import Routine
from ...ir.trees.assembly import Assembly
from ...ir.trees.kernels import KERNELS
from . import parts
from .file_head import Cost, head, operations
from .naming import RESERVED, comment
from .program import Assign, KernelCall, Place, Program, Scope, Section, Table
from .program import Routine as CRoutine
from .routines import Built, Result, Stage, build, headers
from .values import Values

TREE = "rows of bodies, of speeds, of results, of what adds to entries: see tree.h"


def lower(
    staged: Staged,
    model: str = "",
    notes: Sequence[str] = (),
    longest: int = parts.LONGEST,
    assembly: Assembly | None = None,
) -> Program:
    """The program of a function: ``prepare_<name>`` for the parameters, ``<name>`` for the rest.

    Args:
        staged: What the passes made.
        model: Name of the model, for the reader.
        notes: Lines for the reader, such as the formalism.
        longest: Statements after which a routine is split.
        assembly: The function whose numbers these are, if they are: they stay in ``work``.

    Raises:
        CodegenError: a placeholder was left in the graph, or the name is none for C.
    """
    function = staged.function
    check_name(function.name)
    order = staged.order or tuple(function.live())
    values = Values(function, order, staged.prepare)

    # w[k] is the k-th prepared node; what crosses between parts of prepare follows
    targets = [Result(i, Place("w", k), values.description(i)) for i, k in values.w.items()]
    first = Stage(f"prepare_{function.name}", "prepare", order, targets, "w", len(targets))
    prepare = build(first, values, longest)
    array = "out" if assembly is None else "work"
    written = results(function, array)
    start = 0 if assembly is None else len(written)
    second = Stage(function.name, "function", order, written, "work", start)
    body = build(second, values, longest)

    counts = (operations(body), operations(prepare))
    read = prepare.blocks | body.blocks
    program = Program(
        name=function.name,
        head=head(function, model, notes, read, Cost(body.length, prepare.length, *counts)),
        includes=headers(prepare, body),
        tables=tables(prepare, body) + prepare.tables,
        routines=prepare.routines + body.routines,
        blocks=tuple(block.name for block in function.inputs if block.name in read),
        operations=counts[0],
        prepare_operations=counts[1],
        work_size=body.length,
        prepared_size=prepare.length,
    )
    return program if assembly is None else assembled(program, assembly, 0, model, notes)


def assembled(
    program: Program, assembly: Assembly, start: int, model: str, notes: Sequence[str]
) -> Program:
    """The program of an assembly, from one that leaves the numbers of the bodies in ``work``.

    Args:
        program: Of the numbers.
        assembly: The function.
        start: Where they begin.
        model, notes: As of :func:`lower`.
    """
    kernel, tree = KERNELS[assembly.kernel], assembly.tree
    counts = dict(Counter(program.operations) + Counter(assembly.counts))
    counts = dict(sorted(counts.items(), key=lambda row: (-row[1], row[0])))
    table = Table(f"tree_of_{program.name}", tree.table(), integer=True, comment=TREE)
    sizes = (*kernel.sizes(tree), start, program.work_size)
    call = KernelCall(f"cardan_{assembly.kernel}", sizes, table.name)
    ending = Section(f"from the numbers of the bodies, {assembly.kernel}.h", (call,))
    *before, main = program.routines
    blocks = tuple(b.name for b in assembly.inputs if b.name in (*program.blocks, *tree.reads))
    work = program.work_size + kernel.work(tree)
    cost = Cost(work, program.prepared_size, counts, program.prepare_operations)
    return replace(
        program,
        head=head(assembly, model, notes, blocks, cost),
        late_includes=kernel.headers,
        tables=(*program.tables, table),
        routines=(*before, replace(main, body=(*main.body, ending))),
        blocks=blocks,
        operations=counts,
        work_size=work,
    )


def lower_routine(function: Routine, model: str = "", notes: Sequence[str] = ()) -> Program:
    """The program of a function that a header of the kernels computes; w is p.

    Args:
        function, model, notes: As of :func:`lower`.

    Raises:
        CodegenError: the name is none for C.
    """
    check_name(function.name)
    count = sum(len(block) for block in function.inputs if block.name == "p")
    scope = Scope(function.graph, (), {}, file=function.name)
    copies = tuple(Assign(Place("w", k), Place("p", k)) for k in range(count))
    constants = f"constants_of_{function.name}"
    call = KernelCall(function.call, function.sizes, constants)
    counts = dict(function.counts)
    read = [block.name for block in function.inputs]
    return Program(
        name=function.name,
        head=head(function, model, notes, read, Cost(function.work, count, counts, {})),
        includes=("cardan.h",),
        late_includes=function.headers,
        tables=(Table(constants, function.constants),),
        routines=(
            CRoutine(f"prepare_{function.name}", "prepare", "", scope, copies),
            CRoutine(function.name, "function", function.about, scope, (call,)),
        ),
        blocks=tuple(read),
        operations=counts,
        work_size=function.work,
        prepared_size=count,
    )


def check_name(name: str) -> None:
    """Refuse what cannot be the name of a C function."""
    if not re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name) or name in RESERVED:
        raise CodegenError(f"'{name}' cannot be the name of a C function")


def results(function: Function, array: str = "out") -> list[Result]:
    """The entries of ``out`` or another array, with the text that says what they are."""
    results_listed: list[Result] = []
    for output in function.outputs:
        for k, node in enumerate(output.nodes):
            results_listed.append(
                Result(node, Place(array, len(results_listed)), description(output, k))
            )
    return results_listed


def description(output: Output, k: int) -> str:
    """Text for a comment: name and unit of an entry of a result."""
    if output.entries:
        text = f"{output.name}: {output.entries[k]}"
    else:
        text = output.name + _position(output.shape, k)
    if output.units and output.units[k]:
        text += f" [{output.units[k]}]"
    return comment(text)


def _position(shape: tuple[int, ...], k: int) -> str:
    """Indices of entry k of an array, such as ``[2][0]``; "" for a scalar."""
    text = ""
    for size in reversed(shape):
        k, index = divmod(k, size)
        text = f"[{index}]{text}"
    return text


def tables(*stages: Built) -> tuple[Table, ...]:
    """The measured data that the nodes read, as constant arrays."""
    tables_by_name: dict[str, Table] = {}
    for built in stages:
        if "table" not in built.operators:
            continue
        scope = built.routines[-1].scope
        nodes = scope.graph.nodes
        for number in {int(nodes[nodes[i][1]][1]) for i in built.order if nodes[i][0] == "table"}:
            table, name = scope.graph.tables[number], scope.table(number)
            flat = tuple(c for row in table.coefficients for c in row)
            tables_by_name[f"{name}_breaks"] = Table(f"{name}_breaks", table.breaks)
            tables_by_name[f"{name}_coefficients"] = Table(f"{name}_coefficients", flat)
    return tuple(tables_by_name[name] for name in sorted(tables_by_name))
