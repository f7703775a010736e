"""The routines of one stage: loads, statements, results and what crosses between parts."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from functools import cached_property, lru_cache
from typing import NamedTuple

from ...ir.graph import ZERO, SystemNames
from ...ir.owners import SHARED
from . import angles, parts
from .naming import comment, mangle
from .plan import Plan, make_plan
from .program import (
    Angles,
    Array,
    Assign,
    Call,
    Clear,
    Declare,
    Index,
    Loop,
    Place,
    Routine,
    Scope,
    Section,
    Solve,
    Statement,
    Table,
)
from .sections import Sections, arrange
from .values import Values

TITLE = 84
# zeros among results from which one loop writes them, and how many other entries may stand between
# two of them: those are written again
ZEROS, GAP = 16, 64
# so many parameters that are prepared as they are become a loop
COPIES = 128


class Result(NamedTuple):
    """A node wanted at a place: an entry of ``out`` or of ``w``."""

    node: int
    place: Place
    comment: str


class Stage(NamedTuple):
    """One stage of a function.

    Attributes:
        name: C name.
        kind: ``"prepare"`` or ``"function"``.
        order: Nodes, operands first.
        results: What it writes.
        array, start: Where it may keep values, and from which place on.
    """

    name: str
    kind: str
    order: Sequence[int]
    results: Sequence[Result]
    array: str
    start: int


# kinds of linear systems whose kernels stand in a header of their own
DEPENDENT = frozenset({"semidefinite", "basic"})


class Built(NamedTuple):
    """Result of building a stage.

    Attributes:
        routines: The last is the stage itself, before it its parts.
        order: Nodes it computes or reads from inputs.
        operators: How often each operator is among them.
        blocks: Input blocks it reads.
        tables: Constant arrays it needs.
        length: Length of its array.
        solves: Kinds of the linear systems in it.
    """

    routines: tuple[Routine, ...]
    order: tuple[int, ...]
    operators: dict[str, int]
    blocks: frozenset[str]
    tables: tuple[Table, ...]
    length: int
    solves: frozenset[str]


def headers(*stages: Built) -> tuple[str, ...]:
    """Headers of cardan that the text of some stages needs."""
    kinds = frozenset[str]().union(*(built.solves for built in stages))
    needed = ["cardan.h", *(["solve.h"] if kinds else [])]
    return (*needed, *(["dependent.h"] if kinds & DEPENDENT else []))


def build(stage: Stage, values: Values, longest: int = parts.LONGEST) -> Built:
    """The routines of a stage.

    Args:
        stage: What is wanted.
        values: Names and places.
        longest: Statements after which a routine is split.
    """
    graph = values.function.graph
    after = not stage.kind.startswith("prepare")
    prepared = values.w if after else {}
    result_nodes = [r.node for r in stage.results]
    plan = make_plan(graph, stage.order, result_nodes, prepared, values)
    builder = _Builder(stage, plan, values)
    section_groups = parts.split(arrange(plan), longest)
    builder.crossing, length = parts.crossing(section_groups, builder.reads, builder.length)
    bodies = [builder.part(sections) for sections in section_groups]
    bodies[-1].extend(builder.plain())
    bodies[0][:0] = builder.zeros()

    # one routine, or parts and the routine that calls them
    file = values.function.name
    scope = Scope(graph, plan.order, builder.names, plan.outside, file, builder.arrays)
    about = values.function.about if after else ""
    routines = []
    if len(bodies) > 1:
        kind = "part" if after else "prepare_part"
        for n, body in enumerate(bodies, 1):
            routines.append(Routine(f"{stage.name}_part{n}", kind, "", scope, tuple(body)))
        bodies[-1] = [Call(routine.name) for routine in routines]
    routines.append(Routine(stage.name, stage.kind, about, scope, tuple(bodies[-1])))
    nodes = graph.nodes
    computed = tuple([i for i in plan.order if i not in prepared])
    operators = Counter([nodes[i][0] for i in computed])
    blocks = frozenset(nodes[i][1] for i in plan.outside if i not in prepared)
    solves = frozenset(nodes[i][1] for i in computed if nodes[i][0] == "solve")
    return Built(tuple(routines), computed, dict(operators), blocks, builder.tables, length, solves)


def room(n: int, m: int) -> int:
    """Numbers that a linear system needs: A, B and the scratch of its kernel, as in solve.h."""
    return n * (n + m) + 2 * n + (n * (n + m) + 1) // 2


class _Builder:
    """Statements of a planned stage."""

    def __init__(self, stage: Stage, plan: Plan, values: Values) -> None:
        self.stage = stage
        self.plan = plan
        self.values = values
        self.graph = plan.graph
        self.after = not stage.kind.startswith("prepare")
        self.names: dict[int, str] = {}
        self.crossing: dict[int, int] = {}
        self.results: dict[int, list[Result]] = {}
        for result in stage.results:
            self.results.setdefault(result.node, []).append(result)
        # names of A, B and the scratch of the kernel of every linear system
        self.systems: dict[int, tuple[str, ...]] = {}
        self.arrays: dict[str, Array] = {}
        self.angle_places: dict[int, Place] = {}
        self.turns, self.named = 0, Counter[str]()
        self.tables: tuple[Table, ...] = ()
        self.length = stage.start
        # entries that are computed go to their places at once, solutions are read in theirs
        self.entries: dict[int, list[Place]] = {}
        self._description = lru_cache(maxsize=None)(self.graph.description_of)
        self.left: dict[int, tuple[int | None, ...]] = {}
        self.reads = dict(plan.reads)
        for i in plan.reads:
            node = self.graph.nodes[i]
            if node[0] == "solve":
                self._reserve(i, node[2], node[3])
            elif node[0] == "item":
                self.reads[i] = ()

    def _reserve(self, i: int, n: int, m: int) -> None:
        """Room for a linear system and what its kernel needs."""
        name = mangle(self._system(i).name)
        array, start, number = self.stage.array, self.length, self.named[name]
        self.named[name] += 1
        matrix, right, scratch = self.systems[i] = tuple(
            self.values.local(f"{name}_{part}", number) for part in ("matrix", "right", "scratch")
        )
        self.arrays[matrix] = Array(array, start, n)
        self.arrays[right] = Array(array, start + n * n, m)
        self.arrays[scratch] = Array(array, start + n * (n + m))
        self.length += room(n, m)
        left: list[int | None] = []
        for at, k in enumerate(self.graph.nodes[i][4:]):
            left.append(None if k in self.plan.reads else k)
            if k in self.plan.reads:
                place = Place(matrix, at) if at < n * n else Place(right, at - n * n)
                self.entries.setdefault(k, []).append(place)
        self.left[i] = tuple(left)
        missing = set(left)
        self.reads[i] = tuple(k for k in self.plan.reads[i] if k in missing)

    def _system(self, i: int) -> SystemNames:
        return self.graph.systems.get(i) or SystemNames("system", (), ())

    def part(self, sections: Sections) -> list[Statement]:
        """The statements of some sections; each section after what it loads from outside.

        Values of other parts are loaded where they are read first and stored where they are made,
        so that few are alive at a time.
        """
        reads, crossing, entries = self.reads, self.crossing, self.entries
        here: set[int] = set()
        block_list: list[Statement] = []
        for title, statements in sections:
            outer: list[int] = []
            lines: list[Statement] = []
            results: list[Statement] = []
            for group in angles.groups(self.graph, reads, statements):
                for i in group:
                    for k in reads[i]:
                        if k in here:
                            continue
                        here.add(k)
                        if k in crossing:
                            lines.append(self._load(k))
                        else:
                            outer.append(k)
                if self.graph.nodes[group[0]][0] in angles.OPERATORS:
                    self._turn(group, lines)
                for i in group:
                    here.add(i)
                    self._state(i, lines, results)
                    if i in entries:
                        lines.extend([Assign(place, i) for place in entries[i]])
                    if i in crossing:
                        lines.append(Assign(Place(self.stage.array, crossing[i]), i))
            loads = [self._load(k) for k in sorted(outer, key=lambda k: self._place(k).key)]
            heading, formulas = self._heading(title, statements)
            block_list.append(Section(heading, (*loads, *lines, *results), formulas))
        return block_list

    @cached_property
    def cleared(self) -> tuple[range, ...]:
        """Places that are cleared before results are written: where many of these are 0.

        A step writes among what other visits have written.
        """
        if self.stage.kind != "function":
            return ()
        runs: list[list[int]] = []
        for place in (r.place for r in self.stage.results if r.node == ZERO):
            assert isinstance(place.at, int)
            if runs and place.at - runs[-1][-1] <= GAP:
                runs[-1].append(place.at)
            else:
                runs.append([place.at])
        return tuple(range(run[0], run[-1] + 1) for run in runs if len(run) >= ZEROS)

    def zeros(self) -> list[Statement]:
        """Clear what is mostly 0."""
        if not self.cleared:
            return []
        array = self.stage.results[0].place.array
        clear = [Clear(Place(array, run[0]), len(run)) for run in self.cleared]
        return [Section("zeros among the results; what stands between them follows", tuple(clear))]

    def _is_cleared(self, r: Result) -> bool:
        return r.node == ZERO and any(r.place.at in run for run in self.cleared)

    def plain(self) -> list[Statement]:
        """Results that need no computation: numbers and values from outside."""
        plain = [
            r
            for r in self.stage.results
            if r.node not in self.plan.reads and not self._is_cleared(r)
        ]
        if not plain:
            return []
        if self.after:
            lines = [Assign(r.place, self._plain_value(r.node), r.comment) for r in plain]
            return [Section("results that are numbers or inputs", tuple(lines))]
        # places in a step hang on the visit: no table of places holds for all
        if len(plain) > COPIES and self.stage.kind == "prepare":
            return [Section("parameters as they are", (self._copies(plain),))]
        lines = [Assign(r.place, self._place(r.node), r.comment) for r in plain]
        return [Section("parameters as they are", tuple(lines))]

    def _plain_value(self, node: int) -> int | Place:
        return self._place(node) if node in self.plan.outside else node

    def _copies(self, plain: Sequence[Result]) -> Loop:
        """Many parameters that are prepared as they are: one loop over two tables."""
        target, source = f"{self.stage.name}_target", f"{self.stage.name}_source"
        to = tuple(self.values.w[r.node] for r in plain)
        entries = tuple(int(self.graph.nodes[r.node][2]) for r in plain)
        self.tables = (
            Table(target, to, integer=True, comment="where w holds parameters as they are"),
            Table(source, entries, integer=True, comment="which entries of p these are"),
        )
        copy = Assign(Place("w", Index("i", table=target)), Place("p", Index("i", table=source)))
        return Loop("i", len(plain), Scope(self.graph, (), {}), (copy,))

    def _place(self, k: int) -> Place:
        """Place of a value from another part or from outside."""
        if k in self.crossing:
            return Place(self.stage.array, self.crossing[k])
        return self.values.place(k, self.after)

    def _load(self, k: int) -> Declare:
        """The statement that gives such a value its name."""
        if k in self.crossing:
            return Declare(self.names[k], self._place(k), prepared=not self.after)
        load = self.values.load(k, self.after)
        self.names[k] = load.name
        return load

    def _turn(self, group: Sequence[int], lines: list[Statement]) -> None:
        """Add the statement that computes some sines and cosines."""
        nodes = self.graph.nodes
        number = {angle: k for k, angle in enumerate(dict.fromkeys(nodes[i][1] for i in group))}
        names = ("angle", "sine", "cosine")
        angle, sine, cosine = (self.values.local(name, self.turns) for name in names)
        self.turns += 1
        lines.append(Angles(tuple(number), (angle, sine, cosine), not self.after))
        for i in group:
            op, argument = nodes[i]
            self.angle_places[i] = Place(sine if op == "sin" else cosine, number[argument])

    def _state(self, i: int, lines: list[Statement], results: list[Statement]) -> None:
        """Add a statement to the lines, and the results it serves to the results."""
        node = self.graph.nodes[i]
        value: int | Place = self.angle_places.get(i, i)
        # prepared values have names: they are read elsewhere
        if i in self.plan.direct and self.after:
            result = self.results[i][0]
            results.append(Assign(result.place, value, result.comment))
            return
        if node[0] == "solve":
            kind, n, m = node[1:4]
            arrays = self.systems[i]
            unknown = ", ".join(self._system(i).columns) or "x"
            about = f"{arrays[0]} {unknown} = {arrays[1]}; the solution takes its place"
            lines.append(Solve(kind, n, m, self.left[i], arrays, about))
            return
        name = self.names[i] = self.values.named(i)
        if node[0] == "item":
            value = Place(self.systems[node[1]][1], node[2])
        lines.append(Declare(name, value, "", not self.after))
        if i in self.results:
            for r in self.results[i]:
                results.append(Assign(r.place, i, r.comment if self.after else ""))

    def _heading(self, owner: str, statements: Iterable[int]) -> tuple[str, tuple[str, ...]]:
        """Whose section it is and what it computes, and the formulas of that."""
        owners, graph = self.plan.owners, self.graph
        quantities = {owners[i].quantity: "" for i in statements}
        # what belongs to the whole system is called after its owner: entries of M
        is_local = owner in self.values.function.owners or owner == SHARED
        whose = "" if is_local else self._description(owner)
        for q in quantities:
            quantities[q] = q if q in graph.formulas else whose or self._description(q)
        phrases = dict.fromkeys(
            full_name(formula_key or q) for q, formula_key in quantities.items()
        )
        what = ", ".join(word for word in phrases if word and word != full_name(owner))
        if len(what) > TITLE - len(owner):
            what = what[: TITLE - len(owner)].rsplit(", ", 1)[0] + ", ..."
        who = "shared by several" if owner == SHARED else owner
        title = comment(": ".join(word for word in (who, what) if word) or "common")
        formulas = [graph.formulas[known] for known in dict.fromkeys(quantities.values()) if known]
        return title, tuple(comment(formula) for formula in formulas)


@lru_cache(maxsize=4096)
def full_name(quantity: str) -> str:
    """The quantity of which a component is named: ``omega`` of ``omega_z``, ``L`` of ``L_2_1``."""
    return re.sub(r"(_[xyz]{1,2}|(_?\d+)+)$", "", quantity).replace("_", " ")
