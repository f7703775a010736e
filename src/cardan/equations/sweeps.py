"""From expressions with handed values to a recursion: sweeps over the tree, and their steps.

Every handed value, every part of a sum and every result is computed when its body is visited. A
sweep goes outward or inward; a value stands in the first sweep in which all that it reads is there.
Visits that do the same with other places are runs of one step.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from ..errors import DerivationError
from ..ir.function import Block, Function, Output, live
from ..ir.graph import Graph
from ..ir.recursion import OUT, STORE, Recursion, Sweep, Visit
from ..ir.rewrite import copy
from ..topology.system import System
from .carried import CELLS, XYZ, Cuts, Definition

# sweeps that any function of a tree needs by far; more means that values wait for each other
MOST_SWEEPS = 40
DIRECTIONS = ("outward", "inward")
AFTER = "after the sweeps"


class Task(NamedTuple):
    """Something to compute at a body.

    Attributes:
        name: All tasks of one name stand in the same sweep.
        body: Whose visit it belongs to; -2 after all sweeps.
        node: Its expression.
        leaf: The stored value it defines or adds to; -1 for a result.
        out: Entry of the results, -1 for others.
        adds: Whether it adds to what is stored.
    """

    name: str
    body: int
    node: int
    leaf: int = -1
    out: int = -1
    adds: bool = False


LATER = -2


class Sweeps:
    """The tasks of a function, in sweeps.

    Args:
        cuts: The handed values.
        function: Its results.
        homes: Body of every entry of the results, ``LATER`` for those of no body.
        system: The tree.
    """

    def __init__(
        self, cuts: Cuts, function: Function, homes: Sequence[int], system: System
    ) -> None:
        self.cuts = cuts
        self.graph = cuts.graph
        self.function = function
        self.system = system
        self.parents = [b.parent for b in system.bodies]
        # all nodes of a task, the inputs and the stored values among them
        self.cones: dict[Task, list[int]] = {}
        self.inputs: dict[Task, list[int]] = {}
        self.reads: dict[Task, list[int]] = {}
        # tasks of one name and body that were found together
        self.bundles: list[tuple[str, int, list[Task]]] = []
        self.tasks = self._tasks(homes)
        self.phases = self._phases()
        self.by_visit = self._visits()
        self.places, self.size = self._places()
        self.fields = {place: cuts.definitions[leaf] for leaf, place in self.places.items()}

    # what is to be done

    def _tasks(self, homes: Sequence[int]) -> list[Task]:
        """All that the results need; notes what each of it is made from."""
        named = [o.name for o in self.function.outputs for _ in o.nodes]
        waiting = [
            Task(f"out {name}" if home != LATER else AFTER, home, node, out=n)
            for n, (name, node, home) in enumerate(
                zip(named, self.function.roots, homes, strict=True)
            )
        ]
        seen = set[int]()
        while waiting:
            # what one visit computes under one name is looked at together
            bundles: dict[tuple[str, int], list[Task]] = defaultdict(list)
            for task in waiting:
                bundles[task.name, task.body].append(task)
            waiting = []
            for (name, body), bundle in bundles.items():
                if body != LATER:
                    self.bundles.append((name, body, bundle))
                for leaf in self._note(bundle):
                    if leaf not in seen:
                        seen.add(leaf)
                        waiting.extend(self._made(leaf))
        return sorted(self.cones, key=lambda t: (t.leaf, t.adds, t.body, t.out))

    def _note(self, bundle: Sequence[Task]) -> list[int]:
        """Note what the tasks of a bundle are made from; returns the stored values among it."""
        nodes = self.graph.nodes
        cone = live(self.graph, [task.node for task in bundle])
        inputs = [i for i in cone if nodes[i][0] == "var"]
        stored = [i for i in inputs if nodes[i][1] == STORE]
        for task in bundle:
            self.cones[task], self.inputs[task], self.reads[task] = cone, inputs, stored
        return stored

    def _made(self, leaf: int) -> list[Task]:
        """What makes a stored value."""
        d = self.cuts.definitions[leaf]
        if not d.added:
            return [Task(d.field[0], d.body, d.node, leaf)]
        name = d.field[0]
        own = Task(f"{name} of itself", d.body, d.node, leaf)
        added: dict[int, int] = {}
        for by, node in d.added:
            added[by] = self.graph.add(added[by], node) if by in added else node
        return [own, *(Task(f"{name} added", by, n, leaf, adds=True) for by, n in added.items())]

    # when

    def _phases(self) -> dict[str, int]:
        """Number of the sweep of every name; even ones go outward, odd ones inward."""
        rules = sorted({rule for bundle in self.bundles for rule in self._rules(*bundle)})
        phases = dict.fromkeys((name for name, _, _ in self.bundles), 0)
        changed = True
        while changed:
            changed = False
            for name, relation, read in rules:
                wanted = _LEAST[relation](phases[read])
                if wanted > phases[name]:
                    phases[name], changed = wanted, True
                if wanted > MOST_SWEEPS:
                    raise DerivationError(
                        f"'{self.function.name}' is no recursion over this tree: {name} and {read} "
                        "wait for each other. Use loops=False"
                    )
        return phases

    def _rules(self, name: str, body: int, tasks: Sequence[Task]) -> set[tuple[str, str, str]]:
        """(name, where the body of what it reads is, name of that)."""
        definitions, rules = self.cuts.definitions, set[tuple[str, str, str]]()
        read = [definitions[leaf] for leaf in self.reads[tasks[0]]]
        for owner, quantity in {(d.body, d.field[0]) for d in read if not d.added}:
            rules.add((name, self._relation(body, owner), quantity))
        for d in read:
            if d.added:
                # complete when everybody has added
                adders = {self._relation(body, by) for by, _ in d.added}
                whole = "outboard" if d.body == body and adders == {"outboard"} else "far"
                rules.add((name, whole, f"{d.field[0]} added"))
        for task in tasks:
            if task.adds:
                d = definitions[task.leaf]
                relation = self._relation(body, d.body)
                rules.add((name, relation, f"{d.field[0]} of itself"))
        return rules

    def _relation(self, reader: int, owner: int) -> str:
        """Where the owner of a value is seen from a body that reads it."""
        if reader == owner:
            return "own"
        if reader == LATER:
            return "far"
        low, high = min(reader, owner), max(reader, owner)
        # regular numbering: whoever is inboard has the lower number
        while high > low:
            high = self.parents[high]
        if high != low:
            return "far"
        return "inboard" if owner < reader else "outboard"

    def _visits(self) -> dict[tuple[int, int], list[Task]]:
        """(phase, body) -> its tasks."""
        found: dict[tuple[int, int], list[Task]] = defaultdict(list)
        last = max(self.phases.values(), default=0) + 1
        for task in self.tasks:
            phase = last if task.body == LATER else self.phases[task.name]
            found[phase, task.body].append(task)
        return found

    # where

    def _places(self) -> tuple[dict[int, int], int]:
        """Place in the store of every value that another visit reads: [body][field]."""
        at = {t.leaf: visit for visit, tasks in self.by_visit.items() for t in tasks if t.leaf >= 0}
        wanted: set[int] = set()
        for visit, tasks in self.by_visit.items():
            for task in tasks:
                if task.leaf >= 0 and self.cuts.definitions[task.leaf].added:
                    wanted.add(task.leaf)
                wanted.update(leaf for leaf in self.reads[task] if at[leaf] != visit)
        fields = sorted({self.cuts.definitions[leaf].field for leaf in wanted})
        number = {field: k for k, field in enumerate(fields)}
        definitions = self.cuts.definitions
        places = {
            leaf: definitions[leaf].body * len(fields) + number[definitions[leaf].field]
            for leaf in sorted(wanted)
        }
        return places, len(fields) * len(self.parents)

    # the recursion

    def recursion(self) -> Recursion:
        """The tasks as steps and visits."""
        builder = _Steps(self)
        sweeps = []
        for phase in sorted({phase for phase, _ in self.by_visit}):
            bodies = sorted(body for at, body in self.by_visit if at == phase)
            later = bodies == [LATER]
            direction = AFTER if later else DIRECTIONS[phase % 2]
            if phase % 2 and not later:
                bodies.reverse()
            visits = tuple(
                builder.visit(direction, body, self.by_visit[phase, body]) for body in bodies
            )
            sweeps.append(Sweep(direction, visits))
        f = self.function
        outputs = tuple(Output(o.name, o.shape, (), o.entries, o.units) for o in f.outputs)
        steps = builder.finished()
        return Recursion(f.name, f.inputs, outputs, steps, tuple(sweeps), self.size, f.about)


# phase of what is read -> first phase in which it can be read: an outward sweep has been at
# everybody inboard, an inward one at everybody outboard
_LEAST: dict[str, Callable[[int], int]] = {
    "own": lambda phase: phase,
    "inboard": lambda phase: phase + phase % 2,
    "outboard": lambda phase: phase + 1 - phase % 2,
    "far": lambda phase: phase + 1,
}


class _Steps:
    """Collects the steps that visits turn out to need."""

    def __init__(self, sweeps: Sweeps) -> None:
        self.sweeps = sweeps
        self._number: dict[object, int] = {}
        self._steps: list[Function] = []
        self._names: dict[str, int] = defaultdict(int)
        self._runs: list[list[str]] = []

    def finished(self) -> tuple[Function, ...]:
        """The steps; each says for whom it stands."""
        found = []
        for step, runs in zip(self._steps, self._runs, strict=True):
            more = f" and {len(runs) - 1} more" if len(runs) > 1 else ""
            found.append(replace(step, about=runs[0] + more))
        return tuple(found)

    def visit(self, direction: str, body: int, tasks: Sequence[Task]) -> Visit:
        """The visit of a body, with a step of its own where no other one does the same."""
        s, local = self.sweeps, Graph()
        local.tables = s.graph.tables.copy()
        defined = {
            t.leaf: t.node for t in tasks if t.leaf >= 0 and not s.cuts.definitions[t.leaf].added
        }
        reads, copies = self._leaves(local, tasks, defined)
        cones = {id(cone): cone for t in tasks for cone in (s.cones[t],)}
        order = sorted({i for cone in cones.values() for i in cone} | set(defined))

        # a value that is computed here is no leaf here: it goes on as its expression
        def inline(_: Graph, i: int, done: Mapping[int, int]) -> int | None:
            return done[defined[i]] if i in defined else None

        copy(s.graph, local, order, copies, inline)

        # what is stored, added and handed out
        stored = [t for t in tasks if t.leaf in s.places]
        outs = [t for t in tasks if t.out >= 0]
        values = {t: copies[t.node] for t in (*stored, *outs)}
        for t in stored:
            if t.adds:
                values[t] = local.add(copies[t.leaf], values[t])
        roots = [values[t] for t in (*stored, *outs)]
        key = (direction, tuple(local.nodes), tuple(roots), len(stored), *map(len, reads.values()))
        if key not in self._number:
            self._number[key] = len(self._steps)
            self._steps.append(self._step(direction, body, local, reads, stored, outs, roots))
            self._runs.append([])
        number = self._number[key]
        self._runs[number].append(self._who(body))
        places = tuple(s.places[t.leaf] for t in stored)
        return Visit(number, reads, places, tuple(t.out for t in outs))

    def _leaves(
        self, local: Graph, tasks: Sequence[Task], defined: Collection[int]
    ) -> tuple[dict[str, tuple[int, ...]], dict[int, int]]:
        """Entries that a visit reads, by block, and the local inputs that stand for them."""
        s, nodes = self.sweeps, self.sweeps.graph.nodes
        leaves = {i for t in tasks for i in s.inputs[t] if i not in defined}
        leaves |= {t.leaf for t in tasks if t.adds}
        entries: dict[str, dict[int, int]] = {}
        for i in leaves:
            block, k = nodes[i][1:]
            entries.setdefault(block, {})[s.places[i] if block == STORE else k] = i
        reads: dict[str, tuple[int, ...]] = {}
        copies: dict[int, int] = {}
        for block in (*(b.name for b in s.function.inputs), STORE):
            if block in entries:
                reads[block] = tuple(sorted(entries[block]))
                for n, k in enumerate(reads[block]):
                    copies[entries[block][k]] = local.var(block, n)
        return reads, copies

    def _step(
        self,
        direction: str,
        body: int,
        local: Graph,
        reads: Mapping[str, tuple[int, ...]],
        stored: Sequence[Task],
        outs: Sequence[Task],
        roots: Sequence[int],
    ) -> Function:
        """A step in words that hold for all its visits."""
        s, words = self.sweeps, self._words(body)
        for where in (local.origins, local.labels):
            items = where.items() if isinstance(where, dict) else enumerate(where)
            for i, (owner, quantity) in list(items):
                where[i] = (words.get(owner, owner), quantity)
        local.shared = {
            i: {(words.get(owner, owner), q) for owner, q in of} for i, of in local.shared.items()
        }
        self._names[direction] += 1
        name = f"{s.function.name}_{direction.split()[0]}_{self._names[direction]}"

        def field(place: int) -> str:
            d = s.fields[place]
            who = self._words(body).get(s.system.bodies[d.body].name, s.system.bodies[d.body].name)
            return f"{who}.{d.field[0]}_{_component(d)}"

        inputs = []
        known = {b.name: b for b in s.function.inputs}
        for block, places in reads.items():
            if block == STORE:
                entries, units = tuple(map(field, places)), ("",) * len(places)
            else:
                entries = tuple(_renamed(known[block].entries[k], words) for k in places)
                units = tuple(known[block].units[k] for k in places)
            inputs.append(Block(block, entries, units))
        results = [(o.name, k, o) for o in s.function.outputs for k in range(o.size)]
        at = len(stored)
        named = tuple(
            _renamed(o.entries[k], words) if o.entries else o.name
            for o, k in ((results[t.out][2], results[t.out][1]) for t in outs)
        )
        outputs = (
            Output(STORE, (at,), tuple(roots[:at]), tuple(field(s.places[t.leaf]) for t in stored)),
            Output(OUT, (len(outs),), tuple(roots[at:]), named),
        )
        owners = tuple(words.values())
        return Function(name, local, tuple(inputs), outputs, owners)

    def _words(self, body: int) -> dict[str, str]:
        """Names of a body's surroundings -> what they are to it."""
        if body == LATER:
            return {}
        system, parent = self.sweeps.system, self.sweeps.parents[body]
        words = {system.bodies[parent].name: "parent"} if parent >= 0 else {}
        return words | {system.joints[body].name: "joint", system.bodies[body].name: "body"}

    def _who(self, body: int) -> str:
        if body == LATER:
            return "all bodies"
        joint = self.sweeps.system.joints[body]
        return f"{self.sweeps.system.bodies[body].name}, {joint.element.kind} joint {joint.name}"


def _component(d: Definition) -> str:
    """x, y, z or xx, xy ... where it is clear, else a number."""
    return {3: XYZ, 9: CELLS}.get(d.size, [str(k) for k in range(d.size)])[d.field[1]]


def _renamed(entry: str, words: Mapping[str, str]) -> str:
    """A dotted name with its first word in general terms."""
    owner, dot, rest = entry.partition(".")
    return f"{words.get(owner, owner)}{dot}{rest}"
