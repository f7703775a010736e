"""When and where handed values are computed: sweeps over the tree, and places in a store.

Every handed value, every part of a sum and every result is computed when its body is visited. A
sweep goes outward or inward; a value stands in the first sweep in which all that it reads is there.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from typing import NamedTuple

from ...errors import DerivationError
from ...ir.function import Function, live
from ...ir.recursion import STORE
from ...topology.system import System
from .recursion_boundary import Cuts, Definition
from .representatives import Representatives

# sweeps that any function of a tree needs by far; more means that values wait for each other
MOST_SWEEPS = 40
# the body of what no body is visited for, and of what is not looked at
LATER, LEFT_OUT, AFTER = -2, -3, "after the sweeps"


class Task(NamedTuple):
    """Something to compute at a body.

    Attributes:
        name: All tasks of one name stand in the same sweep.
        body: Whose visit it belongs to; ``LATER`` after all sweeps.
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


class Sweeps:
    """The tasks of a function, in sweeps.

    Args:
        cuts: The handed values.
        function: Its results.
        homes: Body of every entry of the results, ``LATER`` for those of no body.
        system: The tree.
        few: The representatives that the bodies are, if they are such.
    """

    def __init__(
        self,
        cuts: Cuts,
        function: Function,
        homes: Sequence[int],
        system: System,
        few: Representatives | None = None,
    ) -> None:
        self.cuts = cuts
        self.graph = cuts.graph
        self.function = function
        self.system = system
        self.few = few
        self.parents = [b.parent for b in system.bodies]
        # all nodes of a task, the inputs and the stored values among them
        self.cones: dict[Task, list[int]] = {}
        self.inputs: dict[Task, list[int]] = {}
        self.reads: dict[Task, list[int]] = {}
        # tasks of one name and body that were found together
        self.bundles: list[tuple[str, int, list[Task]]] = []
        # leaves of a field that bodies of all kinds hand on
        self.common: dict[tuple[str, int], list[int]] = defaultdict(list)
        for leaf, definition in cuts.definitions.items():
            if definition.common:
                self.common[definition.field].append(leaf)
        self.tasks = self._tasks(homes)
        self.phases = self._phases()
        self.by_visit = self._visits()
        self.places, self.fields_of_body = self._places()
        self.size = self.fields_of_body * len((few.large if few is not None else system).bodies)
        self.fields = {place: cuts.definitions[leaf] for leaf, place in self.places.items()}

    def local(self) -> bool:
        """True where nothing is read of children but what they add, however many they are."""
        if self.few is None or self.few.parent < 0:
            return True
        parent, definitions = self.few.parent, self.cuts.definitions
        inboard = (parent, self.system.bodies[parent].parent)
        tasks = (task for task in self.tasks if task.body == parent)
        return all(definitions[leaf].body in inboard for task in tasks for leaf in self.reads[task])

    # what is to be done

    def _tasks(self, homes: Sequence[int]) -> list[Task]:
        """All that the results need; notes what each of it is made from."""
        named = [o.name for o in self.function.outputs for _ in o.nodes]
        waiting = [
            Task(f"out {name}" if home != LATER else AFTER, home, node, out=n)
            for n, (name, node, home) in enumerate(
                zip(named, self.function.roots, homes, strict=True)
            )
            if home != LEFT_OUT
        ]
        visited = set[int]()
        if self.cuts.every:
            visited.update(self.cuts.definitions)
            waiting += [task for leaf in self.cuts.definitions for task in self._tasks_of(leaf)]
        while waiting:
            # what one visit computes under one name is looked at together
            bundles: dict[tuple[str, int], list[Task]] = defaultdict(list)
            for task in waiting:
                bundles[task.name, task.body].append(task)
            waiting = []
            for (name, body), bundle in bundles.items():
                if body != LATER:
                    self.bundles.append((name, body, bundle))
                for leaf in self._with_common(self._note(bundle)):
                    if leaf not in visited:
                        visited.add(leaf)
                        waiting.extend(self._tasks_of(leaf))
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

    def _with_common(self, leaves: Sequence[int]) -> list[int]:
        """Stored values, and the same of all bodies: what is read of one may be read of any."""
        definitions = self.cuts.definitions
        fields = {definitions[leaf].field: leaf for leaf in leaves if definitions[leaf].common}
        return [*leaves, *(leaf for field in fields for leaf in self.common[field])]

    def _tasks_of(self, leaf: int) -> list[Task]:
        """Tasks that make a stored value."""
        d = self.cuts.definitions[leaf]
        if not d.summed:
            return [Task(d.field[0], d.body, d.node, leaf)]
        name = d.field[0]
        itself = Task(f"{name} of itself", d.body, d.node, leaf)
        added: dict[int, int] = {}
        for by, node in d.added:
            added[by] = self.graph.add(added[by], node) if by in added else node
        return [itself, *(Task(f"{name} added", by, n, leaf, adds=True) for by, n in added.items())]

    # when

    def _phases(self) -> dict[str, int]:
        """Number of the sweep of every name; even ones go outward, odd ones inward."""
        rules = sorted({rule for bundle in self.bundles for rule in self._rules(*bundle)})
        phases = dict.fromkeys((name for name, _, _ in self.bundles), 0)
        changed = True
        while changed:
            changed = False
            for name, relation, read in rules:
                phase = _LEAST[relation](phases[read])
                if phase > phases[name]:
                    phases[name], changed = phase, True
                if phase > MOST_SWEEPS:
                    raise DerivationError(
                        f"'{self.function.name}' is not a recursion over this tree: {name} and "
                        f"{read} wait for each other. Use loops=False"
                    )
        return phases

    def _rules(self, name: str, body: int, tasks: Sequence[Task]) -> set[tuple[str, str, str]]:
        """(name, where the body of what it reads is, name of that)."""
        definitions, rules = self.cuts.definitions, set[tuple[str, str, str]]()
        read = [definitions[leaf] for leaf in self.reads[tasks[0]]]
        for owner, quantity in {(d.body, d.field[0]) for d in read if not d.summed}:
            rules.add((name, self._relation(body, owner), quantity))
        for d in read:
            if d.summed:
                rules.add((name, *self._complete(body, d)))
        for task in tasks:
            if task.adds:
                d = definitions[task.leaf]
                relation = self._relation(body, d.body)
                rules.add((name, relation, f"{d.field[0]} of itself"))
        return rules

    def _complete(self, body: int, d: Definition) -> tuple[str, str]:
        """(where those are that add to a sum that a body reads, name of what they do)."""
        if not d.added:
            return self._relation(body, d.body), f"{d.field[0]} of itself"
        # complete when everybody has added
        adders = {self._relation(body, by) for by, _ in d.added}
        from_where = "outboard" if d.body == body and adders == {"outboard"} else "far"
        return from_where, f"{d.field[0]} added"

    def _relation(self, reader: int, owner: int) -> str:
        """Position of the owner of a value as seen from a body that reads it."""
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
        visits: dict[tuple[int, int], list[Task]] = defaultdict(list)
        last = max(self.phases.values(), default=0) + 1
        for task in self.tasks:
            phase = last if task.body == LATER else self.phases[task.name]
            visits[phase, task.body].append(task)
        return visits

    # where

    def _places(self) -> tuple[dict[int, int], int]:
        """Place in the store of every value that another visit reads, [body][field], and the
        number of fields.
        """
        at = {t.leaf: visit for visit, tasks in self.by_visit.items() for t in tasks if t.leaf >= 0}
        stored = set[int](self.cuts.definitions if self.cuts.every else ())
        for visit, tasks in self.by_visit.items():
            for task in tasks:
                if task.leaf >= 0 and self.cuts.definitions[task.leaf].summed:
                    stored.add(task.leaf)
                stored.update(leaf for leaf in self.reads[task] if at[leaf] != visit)
        stored.update(self._with_common(sorted(stored)))
        fields = sorted({self.cuts.definitions[leaf].field for leaf in stored})
        number = {field: k for k, field in enumerate(fields)}
        definitions = self.cuts.definitions
        bodies = range(len(self.parents)) if self.few is None else self.few.numbers
        places = {
            leaf: bodies[definitions[leaf].body] * len(fields) + number[definitions[leaf].field]
            for leaf in sorted(stored)
        }
        return places, len(fields)


# phase of what is read -> first phase in which it can be read: an outward sweep has been at
# everybody inboard, an inward one at everybody outboard
_LEAST: dict[str, Callable[[int], int]] = {
    "own": lambda phase: phase,
    "inboard": lambda phase: phase + phase % 2,
    "outboard": lambda phase: phase + 1 - phase % 2,
    "far": lambda phase: phase + 1,
}
