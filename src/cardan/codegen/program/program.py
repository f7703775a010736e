"""Programs: the statements of generated code, as a tree that any language can print.

Expressions stay nodes of a graph. A :class:`Scope` says which nodes have a name; all other nodes
are written out where they are read.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import field
from typing import NamedTuple, TypeAlias

from ...ir.graph import Graph
from ...records import dataclass


@dataclass(frozen=True)
class Index:
    """An index that loops decide: ``table[stride * counter] + offset``.

    Attributes:
        counter: Counter of a loop, or a number.
        stride: Its multiple.
        offset: What is added to the index.
        table: Name of an array of ints, "" where the multiple is the index itself.
    """

    counter: str
    stride: int = 1
    offset: int = 0
    table: str = ""


class Place(NamedTuple):
    """An array element, such as ``q[3]``."""

    array: str
    at: int | Index

    @property
    def key(self) -> tuple[str, str, int]:
        """Orders places by array, then by where loops begin, then by element."""
        if isinstance(self.at, int):
            return self.array, "", self.at
        return self.array, f"{self.at.table}{self.at.counter:>6}", self.at.offset


Value: TypeAlias = int | Place  # a node of the scope, or an array element


class Declare(NamedTuple):
    """A named constant. ``prepared``: a value of parameters only, of type wreal."""

    name: str
    value: Value
    comment: str = ""
    prepared: bool = False


class Assign(NamedTuple):
    """An array element gets a value."""

    target: Place
    value: Value
    comment: str = ""


class Clear(NamedTuple):
    """Consecutive elements of an array become 0.

    Attributes:
        target: The first.
        length: How many.
    """

    target: Place
    length: int


class Angles(NamedTuple):
    """Sines and cosines of some values, computed at once.

    Attributes:
        angles: Their nodes.
        names: The arrays of angles, of sines and of cosines that are made here.
        prepared: They are values of parameters only.
    """

    angles: tuple[int, ...]
    names: tuple[str, str, str]
    prepared: bool = False


class Call(NamedTuple):
    """A part of a long function runs with the arguments of the function."""

    routine: str


class Solve(NamedTuple):
    """A linear system goes to a kernel; the solution replaces B.

    Attributes:
        kind: As in :func:`cardan.ir.solve.solve`.
        n, m: Rows of A, columns of B.
        entries: Nodes of A and of B, row by row; None where they stand in the arrays already.
        arrays: Names of A, of B and of the scratch of the kernel: :class:`Array`.
        comment: What is solved for.
    """

    kind: str
    n: int
    m: int
    entries: tuple[int | None, ...]
    arrays: tuple[str, ...]
    comment: str


class KernelCall(NamedTuple):
    """A routine of a header of the kernels gives the results.

    Attributes:
        name: In C.
        sizes: Its first arguments.
        constants: Name of the array that follows.
    """

    name: str
    sizes: tuple[int, ...]
    constants: str


class Loop(NamedTuple):
    """Statements repeated for ``counter`` = 0 ... times - 1; their expressions have a scope."""

    counter: str
    times: int
    scope: Scope
    body: tuple[Statement, ...]


class Dispatch(NamedTuple):
    """Inside a loop: the step that the row of a table begins with runs on that row.

    Attributes:
        table: Name of the table of ints.
        counter, width: Counter of the loop; ints per row.
        steps: Names of the routines; a row begins with the number of one of them.
    """

    table: str
    counter: str
    width: int
    steps: tuple[str, ...]


class StridedLoop(NamedTuple):
    """Steps run in turn, on rows that move on by the same amount every time.

    Attributes:
        table: Name of the table of ints: the rows of the first turn, then what is added to them.
        width: Ints per row.
        times: Number of turns.
        steps: Names of the routines of a turn, one per row.
    """

    table: str
    width: int
    times: int
    steps: tuple[str, ...]


class Section(NamedTuple):
    """Statements that belong together, under a title and the formulas of what they compute."""

    title: str
    body: tuple[Statement, ...]
    formulas: tuple[str, ...] = ()


Statement: TypeAlias = (
    Declare
    | Assign
    | Clear
    | Angles
    | Call
    | Dispatch
    | KernelCall
    | StridedLoop
    | Solve
    | Loop
    | Section
)


class Array(NamedTuple):
    """A part of work or w under a name of its own, as a matrix where it has several columns."""

    base: str
    start: int
    columns: int = 1


@dataclass(frozen=True)
class Scope:
    """Meaning of the expressions of some statements.

    Attributes:
        graph: Where their nodes live.
        order: The nodes they use, operands first.
        names: How a node is read that is not written out.
        outside: Nodes that are not computed here but read by name.
        file: Name of the function whose file it is; tables are called after it.
        arrays: Parts of work or w with names of their own.
    """

    graph: Graph = field(repr=False)
    order: Sequence[int] = field(repr=False)
    names: dict[int, str]
    outside: Collection[int] = field(default=(), repr=False)
    file: str = ""
    arrays: Mapping[str, Array] = field(default_factory=dict, repr=False)

    def table(self, number: int) -> str:
        """Name of an interpolation table of the graph, before ``_breaks``, ``_coefficients``."""
        return f"table_{number}_{self.file}"


@dataclass(frozen=True)
class Table:
    """A constant array of the file; ``integer``: of indices, else of numbers."""

    name: str
    values: tuple[float, ...]
    integer: bool = False
    comment: str = ""


@dataclass(frozen=True)
class Routine:
    """A function of the file.

    Attributes:
        name: C name.
        kind: ``"function"`` and ``"part"`` take (in, out, work), ``"prepare"`` and
            ``"prepare_part"`` take (p, w); ``"step"`` and ``"prepare_step"`` also take ``at``,
            a row of ints that says where their values lie.
        about: What its reader should know.
        scope: What its expressions mean.
        body: Its statements.
    """

    name: str
    kind: str
    about: str
    scope: Scope
    body: tuple[Statement, ...]


@dataclass(frozen=True)
class Program:
    """Everything that stands in one generated file.

    Attributes:
        name: Name of the function it is for.
        head: Paragraphs for the reader at the top.
        includes: Headers.
        late_includes: Headers of routines, which work on what ``real`` is for states.
        tables: Constant arrays.
        routines: Functions, every one before those that call it.
        blocks: Input blocks that are read, p by the parameter stage.
        operations: Number of operations per call, by operator.
        prepare_operations: The same of the parameter stage.
        work_size, prepared_size: Lengths of work and w.
    """

    name: str
    head: tuple[tuple[str, ...], ...]
    includes: tuple[str, ...]
    tables: tuple[Table, ...]
    routines: tuple[Routine, ...]
    blocks: tuple[str, ...]
    operations: dict[str, int]
    work_size: int
    prepared_size: int
    prepare_operations: dict[str, int] = field(default_factory=dict)
    late_includes: tuple[str, ...] = ()
