"""From a Recursion to a Program: one C function per step, loops over tables for the visits.

A row of a table is a visit: the number of its step, then where the values of that step lie. Values
whose places differ by the same amount in all visits share a column. Turns take a row per visit of
one turn, and what is added to it from turn to turn.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import chain, groupby
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from ...ir.function import Staged
from ...ir.graph import Graph
from ...ir.recursion import STORE, Recursion, Turns, Visit
from ...ir.trees.assembly import Assembly
from ...records import dataclass
from .file_head import Cost, head, operations
from .lowering import assembled, check_name, description, tables
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
    StridedLoop,
    Table,
)
from .routines import Built, Result, Stage, build, headers
from .values import Values

# the row of a step; the array of what it stores, in words of a step
AT, STORED = "at", "stored"
ROWS = "a row is a visit: number of the step, then where its values begin"
TURNS = "rows of the visits of a turn, where values begin; then what is added from turn to turn"
# steps are written in one piece
UNLIMITED = 1_000_000
EMPTY = Scope(Graph(), (), {})
# entries and strides of a visit
Row: TypeAlias = tuple[list[int], list[int]]
Integers: TypeAlias = npt.NDArray[np.int64]


class Span(NamedTuple):
    """A visit, or one visit of turns.

    Attributes:
        visit, stride: First entries, and what is added to them from turn to turn.
        times: Number of turns.
        w, along: Where its prepared parameters begin, and what is added to that.
    """

    visit: Visit
    stride: Visit | None
    times: int
    w: int
    along: int


class Columns:
    """Places of the values of a step, for all visits of that step: a few columns of ints."""

    def __init__(self, results: str = "out") -> None:
        self._arrays = {STORE: "work", STORED: "work", "out": results}
        self._numbers: dict[tuple[bytes, bytes], int] = {}
        # of a column, how far from the first its entries lie, and their strides
        self._shapes: list[tuple[Integers, Integers]] = []
        self._first: list[int] = []
        self._of: dict[tuple[str, int], tuple[int, int]] = {}

    def add(self, array: str, k: int, places: Integers, strides: Integers) -> None:
        """Places of local entry k of an array: the first and the stride of every span."""
        first = int(places[0])
        gaps = places - first
        if not (gaps.any() or strides.any()):
            self._of[array, k] = (-1, first)
            return
        column = self._numbers.setdefault((gaps.tobytes(), strides.tobytes()), len(self._first))
        if column == len(self._first):
            self._shapes.append((gaps, strides))
            self._first.append(first)
        self._first[column] = min(self._first[column], first)
        self._of[array, k] = (column, first)

    def place(self, array: str, k: int) -> Place:
        """Place of entry k as an expression of the row."""
        column, first = self._of[array, k]
        name = self._arrays.get(array, array)
        if column < 0:
            return Place(name, first)
        return Place(name, Index(str(column + 1), 1, first - self._first[column], AT))

    def rows(self) -> list[Row]:
        """First row and strides of every span; empty where there are no columns."""
        if not self._shapes:
            return []
        pairs = zip(self._shapes, self._first, strict=True)
        firsts = np.stack([gaps + first for (gaps, _), first in pairs], axis=1)
        strides = np.stack([stride for _, stride in self._shapes], axis=1)
        return list(zip(firsts.tolist(), strides.tolist(), strict=True))


@dataclass(frozen=True)
class _Step:
    """A step on its way to C.

    Attributes:
        staged: Its two stages.
        spans: Its visits.
        run, prepare: Where the values of the two stages lie.
        values: Their names.
    """

    staged: Staged
    spans: tuple[Span, ...]
    run: Columns
    prepare: Columns
    values: Values

    @property
    def visits(self) -> int:
        return sum(span.times for span in self.spans)

    @property
    def order(self) -> tuple[int, ...]:
        return self.staged.order or tuple(self.staged.function.live())

    def columns(self, kind: str) -> tuple[str, Columns]:
        """C name and columns of a stage."""
        name = self.staged.function.name
        return (name, self.run) if kind == "step" else (f"prepare_{name}", self.prepare)


def lower(
    recursion: Recursion,
    staged: Sequence[Staged],
    model: str = "",
    notes: Sequence[str] = (),
    assembly: Assembly | None = None,
) -> Program:
    """The program of a recursion.

    Args:
        recursion: What the equations made.
        staged: What the passes made of its steps.
        model: Name of the model, for the reader.
        notes: Lines for the reader.
        assembly: The function whose numbers these are, if they are: they stay in ``work``.

    Raises:
        CodegenError: its name is none for C.
    """
    check_name(recursion.name)
    if assembly is None:
        return _Lowering(recursion, staged, "out").program(model, notes)
    program = _Lowering(recursion, staged, "work").program(model, notes)
    return assembled(program, assembly, recursion.size, model, notes)


class _Lowering:
    """The steps of a recursion with the places of their values; results to ``out`` or ``work``."""

    def __init__(self, recursion: Recursion, staged: Sequence[Staged], results: str) -> None:
        self.recursion, self.results = recursion, results
        # in work, results stand behind what is stored
        self.shift = recursion.size if results == "work" else 0
        count = sum(output.size for output in recursion.outputs)
        self.store_size = recursion.size + (count if results == "work" else 0)
        self.lengths = [len(one.prepare) for one in staged]
        # w is [visit][field]
        self.length = 0
        self.sweeps = [self._spans(sweep.parts) for sweep in recursion.sweeps]
        spans: list[list[Span]] = [[] for _ in staged]
        self.row: dict[int, int] = {}
        for span in (span for sweep in self.sweeps for part in sweep for span in part):
            spans_of_step = spans[span.visit.step]
            self.row[id(span)] = len(spans_of_step)
            spans_of_step.append(span)
        self.steps = [self._step(one, tuple(of)) for one, of in zip(staged, spans, strict=True)]

    def _spans(self, parts: Sequence[Visit | Turns]) -> list[list[Span]]:
        """The visits of a sweep, those of one turn together, with their places in w."""
        spans_by_part = []
        for part in parts:
            if isinstance(part, Visit):
                spans_by_part.append([Span(part, None, 1, self.length, 0)])
                self.length += self.lengths[part.step]
                continue
            along = sum(self.lengths[visit.step] for visit in part.visits)
            here, spans = self.length, []
            for visit, stride in zip(part.visits, part.strides, strict=True):
                spans.append(Span(visit, stride, part.times, here, along))
                here += self.lengths[visit.step]
            spans_by_part.append(spans)
            self.length += along * part.times
        return spans_by_part

    def _step(self, staged: Staged, spans: tuple[Span, ...]) -> _Step:
        """Columns of a step from the places of its visits."""
        run, prepare = Columns(self.results), Columns()
        first = spans[0].visit
        places = np.array([_entries(span.visit) for span in spans], dtype=np.int64)
        still = [0] * places.shape[1]
        strides = np.array(
            [_entries(span.stride) if span.stride else still for span in spans], dtype=np.int64
        )
        pairs = list(zip(places.T, strides.T, strict=True))
        at = 0
        for block, read in first.reads.items():
            columns = prepare if block == "p" else run
            for k in range(len(read)):
                columns.add(block, k, *pairs[at + k])
            at += len(read)
        w, along = np.array([[span.w, span.along] for span in spans], dtype=np.int64).T
        for k in range(len(staged.prepare)):
            for columns in (run, prepare):
                columns.add("w", k, w + k, along)
        for k in range(len(first.stores)):
            run.add(STORED, k, *pairs[at + k])
        at += len(first.stores)
        for k in range(len(first.outs)):
            result, stride = pairs[at + k]
            run.add("out", k, result + self.shift, stride)

        def where(array: str, k: int) -> Place:
            return (prepare if array == "p" else run).place(array, k)

        order = staged.order or tuple(staged.function.live())
        values = Values(staged.function, order, staged.prepare, where)
        return _Step(staged, spans, run, prepare, values)

    def program(self, model: str, notes: Sequence[str]) -> Program:
        """All routines: the steps, then the two functions of the interface."""
        r, length = self.recursion, self.length
        prepared = [self._prepare(step) for step in self.steps]
        bodies = [self._body(step) for step in self.steps]
        stages = (*prepared, *bodies)
        work = max(self.store_size, *(b.length for b in bodies)) if bodies else self.store_size
        cost = Cost(work, length, self._operations(bodies), self._operations(prepared))
        read = {block for built in stages for block in built.blocks} - {STORE}
        routines = [x for built in stages for x in built.routines if x.body]
        main, rows = self._main({x.name for x in routines})
        visits = ", ".join(f"{len(s)} {s.name}" for s in r.sweeps)
        return Program(
            name=r.name,
            head=head(r, model, (*notes, f"visits: {visits}"), read, cost),
            includes=headers(*bodies),
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
                total[op] += n * step.visits
        return dict(sorted(total.items(), key=lambda row: (-row[1], row[0])))

    def _prepare(self, step: _Step) -> Built:
        """Parameter stage of a step."""
        name, columns = step.columns("prepare_step")
        targets = [
            Result(i, columns.place("w", k), step.values.description(i))
            for i, k in step.values.w.items()
        ]
        return build(
            Stage(name, "prepare_step", step.order, targets, "w", 0), step.values, UNLIMITED
        )

    def _body(self, step: _Step) -> Built:
        """Body of a step, run at every call."""
        name, columns = step.columns("step")
        results = []
        for output, array in zip(step.staged.function.outputs, (STORED, "out"), strict=True):
            for k, node in enumerate(output.nodes):
                results.append(Result(node, columns.place(array, k), description(output, k)))
        stage = Stage(name, "step", step.order, results, "work", self.store_size)
        return build(stage, step.values, UNLIMITED)

    def _main(self, there: set[str]) -> tuple[list[Routine], list[Table]]:
        """The two functions of the interface, and the tables they loop over."""
        r = self.recursion
        sections: list[Statement] = []
        tables_used: list[Table] = []
        for number, (sweep, parts) in enumerate(zip(r.sweeps, self.sweeps, strict=True), 1):
            loops, tables = self._loops(f"{r.name}_sweep_{number}", parts, "step")
            sections.append(Section(f"{sweep.name}, {len(sweep)} visits", loops))
            tables_used += tables

        # only visits of steps that have something to prepare
        names = [step.columns("prepare_step")[0] for step in self.steps]
        every = [part for parts in self.sweeps for part in parts]
        spans_with_parameters = [
            [span for span in part if names[span.visit.step] in there] for part in every
        ]
        before: tuple[Statement, ...] = ()
        if any(spans_with_parameters):
            some = [part for part in spans_with_parameters if part]
            loops, tables = self._loops(f"prepare_{r.name}", some, "prepare_step")
            before, tables_used = (
                (Section("parameters of all visits", loops),),
                [*tables_used, *tables],
            )
        return [
            Routine(f"prepare_{r.name}", "prepare", "", EMPTY, before),
            Routine(r.name, "function", r.about, EMPTY, tuple(sections)),
        ], tables_used

    def _loops(
        self, name: str, parts: Sequence[Sequence[Span]], kind: str
    ) -> tuple[tuple[Statement, ...], list[Table]]:
        """Loops over single visits and over turns, as they come, and their tables."""
        rows = {n: step.columns(kind)[1].rows() for n, step in enumerate(self.steps)}
        loops: list[Statement] = []
        tables_built: list[Table] = []
        runs = [
            list(run) for _, run in groupby(parts, key=lambda p: id(p) if p[0].stride else None)
        ]
        for number, run in enumerate(runs, 1):
            title = f"{name}_visits" + (f"_{number}" if len(runs) > 1 else "")
            spans = [span for part in run for span in part]
            strided = spans[0].stride is not None
            loop, table = (self._strided if strided else self._loop)(title, spans, kind, rows)
            loops.append(loop)
            tables_built.append(table)
        return tuple(loops), tables_built

    def _loop(
        self, name: str, spans: Sequence[Span], kind: str, rows: Mapping[int, list[Row]]
    ) -> tuple[Loop, Table]:
        """A loop over visits and the table of its rows."""
        steps = list(dict.fromkeys(span.visit.step for span in spans))
        number = {step: k for k, step in enumerate(steps)}
        picked = [self._row(span, rows)[0] for span in spans]
        width = 1 + max(map(len, picked))
        flat: list[float] = []
        for span, columns in zip(spans, picked, strict=True):
            flat += [number[span.visit.step], *columns, *[0] * (width - 1 - len(columns))]
        table = Table(name, tuple(flat), integer=True, comment=ROWS)
        names = tuple(self.steps[step].columns(kind)[0] for step in steps)
        return Loop("i", len(spans), EMPTY, (Dispatch(table.name, "i", width, names),)), table

    def _strided(
        self, name: str, spans: Sequence[Span], kind: str, rows: Mapping[int, list[Row]]
    ) -> tuple[StridedLoop, Table]:
        """Turns and the table of their rows and strides."""
        picked = [self._row(span, rows) for span in spans]
        width = 1 + max(len(first) for first, _ in picked)
        flat: list[float] = []
        for part in zip(*picked, strict=True):
            for columns in part:
                flat += [0, *columns, *[0] * (width - 1 - len(columns))]
        table = Table(name, tuple(flat), integer=True, comment=TURNS)
        names = tuple(self.steps[span.visit.step].columns(kind)[0] for span in spans)
        return StridedLoop(table.name, width, spans[0].times, names), table

    def _row(self, span: Span, rows: Mapping[int, list[Row]]) -> Row:
        rows_of_step = rows[span.visit.step]
        return rows_of_step[self.row[id(span)]] if rows_of_step else ([], [])


def _entries(visit: Visit) -> list[int]:
    """All entries of a visit: what it reads of every block, what it stores, what it gives out."""
    return [*chain.from_iterable(visit.reads.values()), *visit.stores, *visit.outs]
