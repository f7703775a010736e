"""The steps of a recursion: visits that do the same with other places are runs of one step."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from ...ir.function import Block, Function, Output
from ...ir.graph import Graph, Node
from ...ir.ops import COMMUTATIVE
from ...ir.recursion import OUT, STORE, Recursion, Sweep, Visit
from ...ir.rewrite import copy
from ...ir.strided_visits import as_turns
from .recursion_boundary import CELLS, XYZ, Definition
from .representatives import Ints
from .sweeps import AFTER, LATER, Sweeps, Task
from .unfolding import Unfolding

DIRECTIONS = ("outward", "inward")
# local numbers of constants lie below those of everything that is read
NUMBERS = -1_000_000_000


def recursion(sweeps: Sweeps, firsts: Sequence[Ints | None] = ()) -> Recursion | None:
    """Tasks in sweeps as steps and visits; None where representatives do not tell of all bodies.

    Args:
        sweeps: The tasks.
        firsts: Where bodies are representatives: of every output, the first entry of every body in
            it, None where none is a body's.
    """
    f, few = sweeps.function, sweeps.few
    if few is not None and not sweeps.local():
        return None
    builder, sweep_list = _Steps(sweeps), list[Sweep]()
    unfolding = Unfolding(few, f, firsts, sweeps.fields_of_body) if few is not None else None
    for phase in sorted({phase for phase, _ in sweeps.by_visit}):
        bodies = sorted(body for at, body in sweeps.by_visit if at == phase)
        later = bodies == [LATER]
        direction = AFTER if later else DIRECTIONS[phase % 2]
        inward = bool(phase % 2) and not later
        if inward:
            bodies.reverse()
        if few is not None:
            bodies = [body for body in bodies if body != few.parent]
        visits = [builder.visit(direction, body, sweeps.by_visit[phase, body]) for body in bodies]
        if unfolding is None:
            sweep_list.append(Sweep(direction, as_turns(visits)))
            continue
        rows = None if later else unfolding.rows(zip(bodies, visits, strict=True))
        if rows is None:
            return None
        sweep_list.append(Sweep(direction, (rows.reversed() if inward else rows).turns()))
    outputs = tuple(Output(o.name, o.shape, (), o.entries, o.units) for o in f.outputs)
    steps, sweeps_done = builder.finished(), tuple(sweep_list)
    return Recursion(f.name, f.inputs, outputs, steps, sweeps_done, sweeps.size, f.about)


class _Work(NamedTuple):
    """Work of one visit.

    Attributes:
        order: Nodes that are computed or read, operands first.
        inlined: Stored value that is computed here -> its expression.
        reads: As in :class:`~cardan.ir.recursion.Visit`.
        local: Leaf -> (block, local entry).
        stored, outs: Tasks whose values are stored and given out.
    """

    order: list[int]
    inlined: dict[int, int]
    reads: dict[str, tuple[int, ...]]
    local: dict[int, tuple[str, int]]
    stored: tuple[Task, ...]
    outs: tuple[Task, ...]


class _Steps:
    """Collects the steps that visits turn out to need."""

    def __init__(self, sweeps: Sweeps) -> None:
        self.sweeps = sweeps
        self._number: dict[object, int] = {}
        self._steps: list[Function] = []
        self._names: dict[str, int] = defaultdict(int)
        # for whom a step was made, and the number of its visits
        self._first: list[str] = []
        self._visits: list[int] = []

    def finished(self) -> tuple[Function, ...]:
        """The steps; each says for whom it stands."""
        steps_done = []
        for step, first, visits in zip(self._steps, self._first, self._visits, strict=True):
            more = f" and {visits - 1} more" if visits > 1 else ""
            steps_done.append(replace(step, about=first + more))
        return tuple(steps_done)

    def visit(self, direction: str, body: int, tasks: Sequence[Task]) -> Visit:
        """The visit of a body, with a step of its own where no other one does the same."""
        work = self._work(tasks)
        key = (direction, *self._pattern(work))
        if key not in self._number:
            self._number[key] = len(self._steps)
            self._steps.append(self._step(direction, body, work))
            self._first.append(self._who(body))
            self._visits.append(0)
        number, few = self._number[key], self.sweeps.few
        self._visits[number] += len(few.members[body]) if few is not None else 1
        places = tuple([self.sweeps.places[t.leaf] for t in work.stored])
        return Visit(number, work.reads, places, tuple([t.out for t in work.outs]))

    def _work(self, tasks: Sequence[Task]) -> _Work:
        """Values read, computed and written at a visit."""
        s, nodes = self.sweeps, self.sweeps.graph.nodes
        definitions = s.cuts.definitions
        # a sum to which nobody adds is complete here, too
        inlined = {t.leaf: t.node for t in tasks if t.leaf >= 0 and not definitions[t.leaf].added}
        cones = {id(cone): cone for t in tasks for cone in (s.cones[t],)}
        order = sorted({i for cone in cones.values() for i in cone} | set(inlined))

        # entries that are read, by block
        leaves = {i for t in tasks for i in s.inputs[t] if i not in inlined}
        leaves |= {t.leaf for t in tasks if t.adds}
        entries: dict[str, dict[int, int]] = {}
        for i in leaves:
            block, k = nodes[i][1:]
            entries.setdefault(block, {})[s.places[i] if block == STORE else k] = i
        reads: dict[str, tuple[int, ...]] = {}
        local: dict[int, tuple[str, int]] = {}
        for block in (*(b.name for b in s.function.inputs), STORE):
            if block in entries:
                reads[block] = tuple(sorted(entries[block]))
                for n, k in enumerate(reads[block]):
                    local[entries[block][k]] = (block, n)
        stored = tuple([t for t in tasks if t.leaf in s.places])
        return _Work(order, inlined, reads, local, stored, tuple([t for t in tasks if t.out >= 0]))

    def _pattern(self, work: _Work) -> tuple[object, ...]:
        """The expressions of a visit in local numbers: the same for visits that do the same."""
        nodes = self.sweeps.graph.nodes
        # below 0: what is read, then numbers
        number = {leaf: -1 - k for k, leaf in enumerate(work.local)}
        pattern_nodes: list[Node] = []
        for i in work.order:
            node = nodes[i]
            op = node[0]
            if i in number:
                continue
            if i in work.inlined:
                number[i] = number[work.inlined[i]]
                continue
            if op == "const":
                number[i] = NUMBERS - i
                continue
            if op == "item":
                pattern_nodes.append((op, number[node[1]], node[2]))
            elif op == "solve":
                pattern_nodes.append((*node[:4], *[number[k] for k in node[4:]]))
            elif len(node) == 3:
                a, b = number[node[1]], number[node[2]]
                pattern_nodes.append((op, b, a) if b < a and op in COMMUTATIVE else (op, a, b))
            else:
                pattern_nodes.append((op, *[number[k] for k in node[1:]]))
            number[i] = len(pattern_nodes)
        stored = tuple([(t.adds, number[t.node]) for t in work.stored])
        outs = tuple([number[t.node] for t in work.outs])
        return (
            tuple(pattern_nodes),
            stored,
            outs,
            *[(b, len(places)) for b, places in work.reads.items()],
        )

    def _expressions(self, work: _Work) -> tuple[Graph, list[int]]:
        """A graph of a visit's own, and the nodes of what it stores and gives out."""
        graph, local = self.sweeps.graph, Graph()
        local.tables, local.formulas = graph.tables.copy(), graph.formulas.copy()
        copies = {leaf: local.var(*entry) for leaf, entry in work.local.items()}

        # a value that is computed here is not a leaf here: it goes on as its expression
        def inline(_: Graph, i: int, done: Mapping[int, int]) -> int | None:
            return done[work.inlined[i]] if i in work.inlined else None

        copy(graph, local, work.order, copies, inline)
        roots = [
            local.add(copies[t.leaf], copies[t.node]) if t.adds else copies[t.node]
            for t in (*work.stored, *work.outs)
        ]
        return local, roots

    def _step(self, direction: str, body: int, work: _Work) -> Function:
        """A step in words that hold for all its visits."""
        s, roles = self.sweeps, self._role_names(body)
        local, roots = self._expressions(work)
        for where in (local.origins, local.labels):
            items = where.items() if isinstance(where, dict) else enumerate(where)
            for i, (owner, quantity) in list(items):
                where[i] = (roles.get(owner, owner), quantity)
        local.shared = {
            i: {(roles.get(owner, owner), q) for owner, q in of} for i, of in local.shared.items()
        }
        self._names[direction] += 1
        name = f"{s.function.name}_{direction.split()[0]}_{self._names[direction]}"

        def field(place: int) -> str:
            d = s.fields[place]
            who = self._role_names(body).get(
                s.system.bodies[d.body].name, s.system.bodies[d.body].name
            )
            return f"{who}.{d.field[0]}_{_component(d)}"

        inputs = []
        inputs_by_name = {b.name: b for b in s.function.inputs}
        for block, places in work.reads.items():
            if block == STORE:
                entries, units = tuple(map(field, places)), ("",) * len(places)
            else:
                entries = tuple(_renamed(inputs_by_name[block].entries[k], roles) for k in places)
                units = tuple(inputs_by_name[block].units[k] for k in places)
            inputs.append(Block(block, entries, units))
        results = [(o.name, k, o) for o in s.function.outputs for k in range(o.size)]
        at = len(work.stored)
        named = tuple(
            _renamed(o.entries[k], roles) if o.entries else o.name
            for o, k in ((results[t.out][2], results[t.out][1]) for t in work.outs)
        )
        outputs = (
            Output(
                STORE, (at,), tuple(roots[:at]), tuple(field(s.places[t.leaf]) for t in work.stored)
            ),
            Output(OUT, (len(work.outs),), tuple(roots[at:]), named),
        )
        owners = tuple(roles.values())
        return Function(name, local, tuple(inputs), outputs, owners)

    def _role_names(self, body: int) -> dict[str, str]:
        """Names of a body's surroundings -> what they are to it."""
        if body == LATER:
            return {}
        system, parent = self.sweeps.system, self.sweeps.parents[body]
        roles = {system.bodies[parent].name: "parent"} if parent >= 0 else {}
        return roles | {system.joints[body].name: "joint", system.bodies[body].name: "body"}

    def _who(self, body: int) -> str:
        if body == LATER:
            return "all bodies"
        joint = self.sweeps.system.joints[body]
        return f"{self.sweeps.system.bodies[body].name}, {joint.element.kind} joint {joint.name}"


def _component(d: Definition) -> str:
    """x, y, z or xx, xy ... where it is clear, else a number."""
    return {3: XYZ, 9: CELLS}.get(d.size, [str(k) for k in range(d.size)])[d.field[1]]


def _renamed(entry: str, roles: Mapping[str, str]) -> str:
    """A dotted name with its first word in general terms."""
    owner, dot, suffix = entry.partition(".")
    return f"{roles.get(owner, owner)}{dot}{suffix}"
