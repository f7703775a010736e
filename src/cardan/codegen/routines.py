"""The routines of one stage: loads, statements, results and what crosses between parts."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import NamedTuple

from . import parts
from .naming import comment
from .plan import SHARED, Plan, make_plan
from .program import Assign, Call, Declare, Place, Routine, Scope, Section, Solve, Statement
from .sections import arrange
from .values import Values

TITLE = 84


class Result(NamedTuple):
    """A node wanted at a place: an entry of ``out`` or of ``w``."""

    node: int
    place: Place
    comment: str


class Stage(NamedTuple):
    """What one stage of a function is.

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


class Built(NamedTuple):
    """Routines of a stage (the last is the stage itself), what they compute, and array length."""

    routines: tuple[Routine, ...]
    order: tuple[int, ...]
    length: int


def build(stage: Stage, values: Values, longest: int = parts.LONGEST) -> Built:
    """The routines of a stage.

    Args:
        stage: What is wanted.
        values: Names and places.
        longest: Statements after which a routine is split.
    """
    graph = values.function.graph
    given = values.w if stage.kind == "function" else {}
    wanted = [r.node for r in stage.results]
    plan = make_plan(graph, stage.order, wanted, given, values.owners)
    builder = _Builder(stage, plan, values)
    pieces = parts.split(arrange(plan, values.owners), longest)
    builder.crossing, length = parts.crossing(pieces, plan.reads, builder.length)
    bodies = [builder.part(piece) for piece in pieces]
    bodies[-1].extend(builder.plain())

    # one routine, or parts and the routine that calls them
    scope = Scope(graph, plan.order, builder.names, plan.outside)
    about = values.function.about if stage.kind == "function" else ""
    routines = []
    if len(bodies) > 1:
        kind = "part" if stage.kind == "function" else "prepare_part"
        for n, body in enumerate(bodies, 1):
            routines.append(Routine(f"{stage.name}_part{n}", kind, "", scope, tuple(body)))
        bodies[-1] = [Call(routine.name) for routine in routines]
    routines.append(Routine(stage.name, stage.kind, about, scope, tuple(bodies[-1])))
    computed = tuple(i for i in plan.order if i not in given)
    return Built(tuple(routines), computed, length)


class _Builder:
    """Statements of a planned stage."""

    def __init__(self, stage: Stage, plan: Plan, values: Values) -> None:
        self.stage = stage
        self.plan = plan
        self.values = values
        self.graph = plan.graph
        self.after = stage.kind == "function"
        self.names: dict[int, str] = {}
        self.crossing: dict[int, int] = {}
        self.results: dict[int, list[Result]] = {}
        for result in stage.results:
            self.results.setdefault(result.node, []).append(result)
        # room for A, B and the scratch of the kernel of every linear system
        self.systems: dict[int, int] = {}
        self.length = stage.start
        for i in plan.reads:
            node = self.graph.nodes[i]
            if node[0] == "solve":
                self.systems[i] = self.length
                self.length += node[2] * (node[2] + node[3]) + 2 * node[2]

    def part(self, sections: parts.Sections) -> list[Statement]:
        """The statements of some sections, each after what it loads from outside."""
        reads, crossing = self.plan.reads, self.crossing
        here: set[int] = set()
        found: list[Statement] = []
        for title, statements in sections:
            loads: list[Statement] = []
            lines: list[Statement] = []
            stores: list[Statement] = []
            for i in statements:
                for k in reads[i]:
                    if k not in here:
                        here.add(k)
                        loads.append(self._load(k))
                here.add(i)
                lines.extend(self._statements(i))
                if i in crossing:
                    stores.append(Assign(Place(self.stage.array, crossing[i]), i))
            found.append(Section(self._title(title, statements), (*loads, *lines, *stores)))
        return found

    def plain(self) -> list[Statement]:
        """Results that need no computation: numbers and values from outside."""
        lines: list[Statement] = []
        for result in self.stage.results:
            if result.node in self.plan.outside:
                value: int | Place = self.values.place(result.node, self.after)
            elif result.node not in self.plan.reads:
                value = result.node
            else:
                continue
            lines.append(Assign(result.place, value, result.comment))
        return [Section("without computation", tuple(lines))] if lines else []

    def _load(self, k: int) -> Declare:
        """A value of another part, or from outside, by name."""
        if k in self.plan.reads:
            place = Place(self.stage.array, self.crossing[k])
            return Declare(self.names[k], place, prepared=not self.after)
        load = self.values.load(k, self.after)
        self.names[k] = load.name
        return load

    def _statements(self, i: int) -> list[Statement]:
        """A statement and the results it serves."""
        node = self.graph.nodes[i]
        results = self.results.get(i, [])
        if node[0] == "solve":
            return [Solve(*node[1:4], node[4:], self.stage.array, self.systems[i])]
        if i in self.plan.direct:
            return [Assign(results[0].place, i, results[0].comment)]
        name = self.names[i] = self.values.name(i)
        value: int | Place = i
        if node[0] == "item":
            n = self.graph.nodes[node[1]][2]
            value = Place(self.stage.array, self.systems[node[1]] + n * n + node[2])
        found: list[Statement] = [Declare(name, value, prepared=not self.after)]
        found.extend(Assign(r.place, i, r.comment) for r in results)
        return found

    def _title(self, owner: str, statements: Iterable[int]) -> str:
        """Whose section it is and what it computes."""
        of = self.values.owners.of
        words = dict.fromkeys(whole(of(i).quantity) for i in statements)
        what = ", ".join(word for word in words if word)
        if len(what) > TITLE - len(owner):
            what = what[: TITLE - len(owner)].rsplit(", ", 1)[0] + ", ..."
        who = "shared by several" if owner == SHARED else owner
        return comment(": ".join(word for word in (who, what) if word) or "common")


@lru_cache(maxsize=4096)
def whole(quantity: str) -> str:
    """The quantity of which a component is named: ``omega`` of ``omega_z``, ``L`` of ``L_2_1``."""
    return re.sub(r"(_[xyz]{1,2}|(_?\d+)+)$", "", quantity).replace("_", " ")
