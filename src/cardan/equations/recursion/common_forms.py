"""Forms in which bodies of all kinds hand on a quantity, so that neighbors need not know the kind.

A hinge about x hands on an angular velocity with two zeros, one about y with two others. Where
one body stands for all of its kind, its neighbors may be of any kind: an entry is 0 for them only
where it is for bodies of all kinds, one entry is another or its negative only where it is so for
all. What kinds do is found by derivation, again and again until the forms say what they did.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Sequence
from typing import NamedTuple, TypeAlias

from ...ir.graph import Graph


class FormEntry(NamedTuple):
    """An entry of a quantity as bodies of all kinds have it.

    Attributes:
        source: Number of the entry that has the same value; its own number where none before has.
        sign: 1, or -1 where it is the negative; of an entry of its own, where all have negatives.
        value: The number, where it is the same one for all.
    """

    source: int
    sign: int = 1
    value: float | None = None


Form: TypeAlias = tuple[FormEntry, ...]
# of every entry a number, or (which of the values that differ, sign)
Pattern: TypeAlias = tuple[float | tuple[int, int], ...]


class Forms:
    """The forms of all quantities that other bodies read.

    Args:
        quantities: Names of those quantities.
        formed: Of every body, whether others may read what it hands on.
        patterns: What earlier derivations saw, by the name and size of the quantity.
    """

    def __init__(
        self,
        quantities: Collection[str],
        formed: Sequence[bool],
        patterns: dict[tuple[str, int], set[Pattern]] | None = None,
    ) -> None:
        self.quantities, self.formed = quantities, formed
        self.patterns: dict[tuple[str, int], set[Pattern]] = defaultdict(set, patterns or {})
        self._forms = {key: _form(patterns) for key, patterns in self.patterns.items()}

    def common(self, body: int, quantity: str) -> bool:
        """True where a quantity of a body has the form that it has for all kinds."""
        return self.formed[body] and quantity in self.quantities

    def form(self, graph: Graph, quantity: str, nodes: Sequence[int]) -> Form | None:
        """The form of a quantity as far as it is known, and what it looks like here noted."""
        key = (quantity, len(nodes))
        self.patterns[key].add(_pattern(graph, nodes))
        return self._forms.get(key)

    def form_of_sum(
        self, graph: Graph, quantity: str, terms: Iterable[Sequence[int]]
    ) -> Form | None:
        """The same of a sum, all of whose terms must be so."""
        form = None
        for nodes in terms:
            form = self.form(graph, quantity, nodes)
        if form is None:
            return None
        # numbers add up to other numbers, but for zeros
        return tuple([FormEntry(k) if entry.value else entry for k, entry in enumerate(form)])

    def settled(self) -> bool:
        """True when no pattern was noted that the forms do not have."""
        return self._forms == {key: _form(patterns) for key, patterns in self.patterns.items()}

    def further(self) -> Forms:
        """The forms of what was noted."""
        return Forms(self.quantities, self.formed, self.patterns)


def _pattern(graph: Graph, nodes: Sequence[int]) -> Pattern:
    """The pattern of a quantity: its numbers, and which entries are alike."""
    number: dict[int, int] = {}
    pattern: list[float | tuple[int, int]] = []
    for i in nodes:
        node = graph.nodes[i]
        if node[0] == "const":
            pattern.append(node[1])
            continue
        value, sign = (node[1], -1) if node[0] == "neg" else (i, 1)
        pattern.append((number.setdefault(value, len(number)), sign))
    return tuple(pattern)


def _form(patterns: Collection[Pattern]) -> Form:
    """The form that all patterns of a quantity have."""
    form: list[FormEntry] = []
    for k, entries in enumerate(zip(*patterns, strict=True)):
        first = entries[0]
        if not isinstance(first, tuple) and all(entry == first for entry in entries):
            form.append(FormEntry(k, value=first))
            continue
        same = (
            FormEntry(j, sign)
            for j in range(k)
            if form[j].source == j and form[j].value is None
            for sign in (1, -1)
            if all(_related(pattern[j], pattern[k], sign) for pattern in patterns)
        )
        signs = {entry[1] for entry in entries if isinstance(entry, tuple)}
        form.append(next(same, FormEntry(k, -1 if signs == {-1} else 1)))
    return tuple(form)


def _related(a: float | tuple[int, int], b: float | tuple[int, int], sign: int) -> bool:
    """True when b is sign times a."""
    if isinstance(a, tuple) and isinstance(b, tuple):
        return a[0] == b[0] and b[1] == sign * a[1]
    return not isinstance(a, tuple) and not isinstance(b, tuple) and b == sign * a
