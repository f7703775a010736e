"""From a Recursion to a Program: one C function per step, loops over tables for the visits.

A row of a table is a visit: the number of its step, then where the values of that step lie. Values
whose places differ by the same amount in all visits share a column.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate

from ..ir.function import Staged
from ..ir.graph import Graph
from ..ir.recursion import STORE, Recursion
from .head import Cost, head, operations
from .lowering import check_name, described, tables
from .program import (
    Dispatch,
    Index,
    Loop,
    Place,
    Program,
    Routine,
    Scope,
    Section,
    Statement,
    Table,
)
from .routines import Built, Result, Stage, build
from .values import Values

# the row of a step; the array of what it stores, in words of a step
AT, STORED = "at", "stored"
ROWS = "a row is a visit: number of the step, then where its values begin"
# steps are written in one piece
WHOLE = 1_000_000
EMPTY = Scope(Graph(), (), {})


class Columns:
    """Where the values of a step lie, for all visits of that step: a few columns of ints."""

    def __init__(self) -> None:
        self._shapes: dict[tuple[int, ...], int] = {}
        self._first: list[int] = []
        self._of: dict[tuple[str, int], tuple[int, int]] = {}

    def add(self, array: str, k: int, places: Sequence[int]) -> None:
        """Places of local entry k of an array, one per visit."""
        first = places[0]
        shape = tuple([place - first for place in places])
        if not any(shape):
            self._of[array, k] = (-1, first)
            return
        column = self._shapes.setdefault(shape, len(self._first))
        if column == len(self._first):
            self._first.append(first)
        self._first[column] = min(self._first[column], first)
        self._of[array, k] = (column, first)

    def place(self, array: str, k: int) -> Place:
        """Where entry k is, in words of the row."""
        column, first = self._of[array, k]
        name = "work" if array in (STORE, STORED) else array
        if column < 0:
            return Place(name, first)
        return Place(name, Index(str(column + 1), 1, first - self._first[column], AT))

    def rows(self) -> list[list[int]]:
        """The columns, one row per visit; no rows where there are no columns."""
        pairs = zip(self._shapes, self._first, strict=True)
        columns = [[first + d for d in shape] for shape, first in pairs]
        return [list(row) for row in zip(*columns, strict=True)]


@dataclass(frozen=True)
class _Step:
    """A step on its way to C.

    Attributes:
        staged: Its two stages.
        numbers: Its visits.
        run, prepare: Where the values of the two stages lie.
        values: Their names.
    """

    staged: Staged
    numbers: tuple[int, ...]
    run: Columns
    prepare: Columns
    values: Values

    @property
    def order(self) -> tuple[int, ...]:
        return self.staged.order or tuple(self.staged.function.live())

    def columns(self, kind: str) -> tuple[str, Columns]:
        """C name and columns of a stage."""
        name = self.staged.function.name
        return (name, self.run) if kind == "step" else (f"prepare_{name}", self.prepare)


def lower(
    recursion: Recursion, staged: Sequence[Staged], model: str = "", notes: Sequence[str] = ()
) -> Program:
    """The program of a recursion.

    Args:
        recursion: What the equations made.
        staged: What the passes made of its steps.
        model: Name of the model, for the reader.
        notes: Lines for the reader.

    Raises:
        CodegenError: its name is none for C.
    """
    check_name(recursion.name)
    return _Lowering(recursion, staged).program(model, notes)


class _Lowering:
    """The steps of a recursion with the places of their values."""

    def __init__(self, recursion: Recursion, staged: Sequence[Staged]) -> None:
        self.recursion = recursion
        self.visits = [v for sweep in recursion.sweeps for v in sweep.visits]
        # w is [visit][field]
        self.w = [0, *accumulate(len(staged[v.step].prepare) for v in self.visits)]
        runs: list[list[int]] = [[] for _ in staged]
        self.row: list[int] = []
        for n, visit in enumerate(self.visits):
            self.row.append(len(runs[visit.step]))
            runs[visit.step].append(n)
        self.steps = [self._step(one, tuple(of)) for one, of in zip(staged, runs, strict=True)]

    def _step(self, staged: Staged, numbers: tuple[int, ...]) -> _Step:
        """Columns of a step from the places of its visits."""
        visits = [self.visits[n] for n in numbers]
        run, prepare = Columns(), Columns()
        for block, places in visits[0].reads.items():
            columns = prepare if block == "p" else run
            for k in range(len(places)):
                columns.add(block, k, [v.reads[block][k] for v in visits])
        for k in range(len(staged.prepare)):
            for columns in (run, prepare):
                columns.add("w", k, [self.w[n] + k for n in numbers])
        for k in range(len(visits[0].stores)):
            run.add(STORED, k, [v.stores[k] for v in visits])
        for k in range(len(visits[0].outs)):
            run.add("out", k, [v.outs[k] for v in visits])

        def where(array: str, k: int) -> Place:
            return (prepare if array == "p" else run).place(array, k)

        order = staged.order or tuple(staged.function.live())
        values = Values(staged.function, order, staged.prepare, where)
        return _Step(staged, numbers, run, prepare, values)

    def program(self, model: str, notes: Sequence[str]) -> Program:
        """All routines: the steps, then the two functions of the interface."""
        r, length = self.recursion, self.w[-1]
        prepared = [self._prepare(step) for step in self.steps]
        bodies = [self._body(step) for step in self.steps]
        stages = (*prepared, *bodies)
        work = max(r.size, *(b.length for b in bodies)) if bodies else r.size
        cost = Cost(work, length, self._operations(bodies), self._operations(prepared))
        read = {block for built in stages for block in built.blocks} - {STORE}
        solves = any("solve" in built.operators for built in bodies)
        routines = [x for built in stages for x in built.routines if x.body]
        main, rows = self._main({x.name for x in routines})
        visits = ", ".join(f"{len(s.visits)} {s.name}" for s in r.sweeps)
        return Program(
            name=r.name,
            head=head(r, model, (*notes, f"visits: {visits}"), read, cost),
            includes=("cardan.h", "solve.h") if solves else ("cardan.h",),
            tables=(*tables(*stages), *rows),
            routines=(*routines, *main),
            blocks=tuple(block.name for block in r.inputs if block.name in read),
            operations=cost.run,
            prepare_operations=cost.prepare,
            work_size=work,
            prepared_size=length,
        )

    def _operations(self, stages: Sequence[Built]) -> dict[str, int]:
        """Operations of all visits, the most frequent first."""
        total = Counter[str]()
        for step, built in zip(self.steps, stages, strict=True):
            for op, n in operations(built).items():
                total[op] += n * len(step.numbers)
        return dict(sorted(total.items(), key=lambda row: (-row[1], row[0])))

    def _prepare(self, step: _Step) -> Built:
        """Parameter stage of a step."""
        name, columns = step.columns("prepare_step")
        targets = [
            Result(i, columns.place("w", k), step.values.described(i))
            for i, k in step.values.w.items()
        ]
        return build(Stage(name, "prepare_step", step.order, targets, "w", 0), step.values, WHOLE)

    def _body(self, step: _Step) -> Built:
        """What a step does at every call."""
        name, columns = step.columns("step")
        found = []
        for output, array in zip(step.staged.function.outputs, (STORED, "out"), strict=True):
            for k, node in enumerate(output.nodes):
                found.append(Result(node, columns.place(array, k), described(output, k)))
        stage = Stage(name, "step", step.order, found, "work", self.recursion.size)
        return build(stage, step.values, WHOLE)

    def _main(self, there: set[str]) -> tuple[list[Routine], list[Table]]:
        """The two functions of the interface, and the tables they loop over."""
        r = self.recursion
        sections: list[Statement] = []
        found: list[Table] = []
        at = 0
        for number, sweep in enumerate(r.sweeps, 1):
            visits = range(at, at + len(sweep.visits))
            at += len(sweep.visits)
            loop, table = self._loop(f"{r.name}_sweep_{number}", visits, "step")
            sections.append(Section(f"{sweep.name}, {len(visits)} visits", (loop,)))
            found.append(table)

        # only visits of steps that have something to prepare
        names = [step.columns("prepare_step")[0] for step in self.steps]
        some = [n for n, v in enumerate(self.visits) if names[v.step] in there]
        before: tuple[Statement, ...] = ()
        if some:
            loop, table = self._loop(f"prepare_{r.name}", some, "prepare_step")
            before, found = (Section("parameters of all visits", (loop,)),), [*found, table]
        return [
            Routine(f"prepare_{r.name}", "prepare", "", EMPTY, before),
            Routine(r.name, "function", r.about, EMPTY, tuple(sections)),
        ], found

    def _loop(self, name: str, visits: Sequence[int], kind: str) -> tuple[Loop, Table]:
        """A loop over visits and the table of its rows."""
        steps = list(dict.fromkeys(self.visits[n].step for n in visits))
        number = {step: k for k, step in enumerate(steps)}
        rows = {step: self.steps[step].columns(kind)[1].rows() for step in steps}
        width = 1 + max((len(row[0]) for row in rows.values() if row), default=0)
        flat: list[float] = []
        for n in visits:
            step = self.visits[n].step
            own = rows[step][self.row[n]] if rows[step] else []
            flat += [number[step], *own, *[0] * (width - 1 - len(own))]
        table = Table(f"{name}_visits", tuple(flat), integer=True, comment=ROWS)
        names = tuple(self.steps[step].columns(kind)[0] for step in steps)
        return Loop("i", len(visits), EMPTY, (Dispatch(table.name, "i", width, names),)), table
