"""One fault in a saved Function or in C: a sign, an index, a missing term, another frame."""

from __future__ import annotations

import copy
import re
from dataclasses import dataclass
from typing import Any

import numpy as np

# operands that are not values, by operator: numbers of tables and of Stumpff functions
FIXED = {"stumpff": (1,), "table": (1, 2)}
SWAPPED = {"sin": "cos", "cos": "sin", "add": "sub", "sub": "add", "mul": "add", "min": "max"}
SWAPPED |= {"max": "min", "lt": "le", "le": "lt", "sinh": "cosh", "cosh": "sinh", "div": "mul"}


@dataclass(frozen=True)
class Fault:
    """What was changed.

    Attributes:
        kind: Sign, index, missing term, frame, constant, assignment.
        where: In words.
    """

    kind: str
    where: str


def operands(node: list[Any]) -> list[int]:
    """Places in a saved node that name other nodes."""
    if node[0] in ("const", "var", "atom"):
        return []
    if node[0] == "item":
        return [1]
    first = 4 if node[0] == "solve" else 1
    return [k for k in range(first, len(node)) if k not in FIXED.get(node[0], ())]


def sites(text: dict[str, Any]) -> int:
    """Nodes and assignments of a function that a fault may be put into."""
    return len(text["nodes"]) + sum(len(o["nodes"]) for o in text["outputs"])


def harmed(
    text: dict[str, Any], site: int, rng: np.random.Generator
) -> tuple[dict[str, Any], Fault]:
    """The function with a fault at a site."""
    text = copy.deepcopy(text)
    nodes = text["nodes"]
    if site >= len(nodes):
        return text, _assignment(text, site - len(nodes), rng)
    node = nodes[site]
    if node[0] == "const":
        return text, _constant(node, rng)
    if node[0] == "var":
        return text, _variable(text, site, rng)
    return text, _operator(text, site, rng)


def _constant(node: list[Any], rng: np.random.Generator) -> Fault:
    old = float(node[1])
    new = [-old, 2 * old, old + 1, 0.5 * old, 0.0, old * (1 + 1e-3)][rng.integers(6)]
    node[1] = new if new != old else old + 1
    return Fault("constant", f"{old:g} -> {node[1]:g}")


def _variable(text: dict[str, Any], site: int, rng: np.random.Generator) -> Fault:
    """Another entry of the same block, or the opposite sign."""
    node = text["nodes"][site]
    size = next(len(b["entries"]) for b in text["inputs"] if b["name"] == node[1])
    if size > 1 and rng.random() < 0.5:
        old = node[2]
        node[2] = int((old + rng.integers(1, size)) % size)
        return Fault("index", f"{node[1]}[{old}] -> {node[1]}[{node[2]}]")
    return _negated(text, site)


def _negated(text: dict[str, Any], site: int) -> Fault:
    """Everything that reads a node reads its opposite."""
    _insert(text, site + 1, ["neg", site], skip=site + 1)
    return Fault("sign", f"-{_word(text, site)}")


def _word(text: dict[str, Any], site: int) -> str:
    node = text["nodes"][site]
    return f"{node[1]}[{node[2]}]" if node[0] == "var" else f"{node[0]} (node {site})"


def _insert(text: dict[str, Any], at: int, new: list[Any], skip: int) -> None:
    """A node at a place: what read the one before it reads this one."""
    nodes = text["nodes"]

    def moved(k: int) -> int:
        return k + 1 if k >= at - 1 else k

    for node in nodes[at:]:
        for place in [*operands(node), *FIXED.get(node[0], ())]:
            fixed = place in FIXED.get(node[0], ())
            node[place] = node[place] + (node[place] >= at) if fixed else moved(node[place])
    for output in text["outputs"]:
        output["nodes"] = [moved(k) for k in output["nodes"]]
    nodes.insert(at, new)


def _operator(text: dict[str, Any], site: int, rng: np.random.Generator) -> Fault:
    nodes, node = text["nodes"], text["nodes"][site]
    places = operands(node)
    kinds = ["sign", "operand"]
    if node[0] in ("add", "sub", "mul", "div"):
        kinds += ["missing", "missing"]
    if node[0] in SWAPPED:
        kinds.append("swapped")
    kind = kinds[rng.integers(len(kinds))]
    if kind == "sign" and node[0] != "solve":
        return _negated(text, site)
    if kind == "missing":
        kept = node[places[rng.integers(2)]]
        for later in nodes[site + 1 :]:
            for place in operands(later):
                later[place] = kept if later[place] == site else later[place]
        for output in text["outputs"]:
            output["nodes"] = [kept if k == site else k for k in output["nodes"]]
        return Fault("missing term", f"{node[0]} (node {site})")
    if kind == "swapped":
        old, node[0] = node[0], SWAPPED[node[0]]
        return Fault("frame", f"{old} -> {node[0]} (node {site})")
    place = places[rng.integers(len(places))]
    old = node[place]
    values = [k for k in range(site) if nodes[k][0] != "solve" and k != old]
    like = [k for k in values if nodes[k][0] == nodes[old][0]] or values
    if nodes[old][0] == "solve" or not like:
        return _negated(text, site) if node[0] != "solve" else Fault("none", "")
    node[place] = int(like[rng.integers(len(like))])
    return Fault("frame", f"operand {old} -> {node[place]} of {node[0]} (node {site})")


def _assignment(text: dict[str, Any], k: int, rng: np.random.Generator) -> Fault:
    """A result that another node is assigned to."""
    for output in text["outputs"]:
        size = len(output["nodes"])
        if k < size:
            values = [i for i, n in enumerate(text["nodes"]) if n[0] != "solve"]
            others = [n for n in output["nodes"] if n != output["nodes"][k]]
            pool = others if others and rng.random() < 0.5 else values
            output["nodes"][k] = int(pool[rng.integers(len(pool))])
            return Fault("assignment", f"{output['name']}[{k}]")
        k -= size
    return Fault("none", "")


# C

LINE = re.compile(r"^\s*(?:const )?(?:real|wreal|double)?\s*[\w\[\]>.*-]+ = .*;")
NUMBER = re.compile(r"(?<![\w.\[])\d+(?:\.\d*)?(?:[eE][-+]?\d+)?(?![\w\]])")
READ = re.compile(r"in->(\w+)\[(\d+)\]")
SIGN = re.compile(r"(?<=[\w)\]]) ([+-]) (?=[\w(-])")
NAME = re.compile(r"\b[a-z]\w*_\w+\b(?!\()")


def lines(text: str) -> list[int]:
    """Assignments of a C text."""
    return [k for k, line in enumerate(text.splitlines()) if LINE.match(line)]


def harmed_text(
    text: str, at: int, rng: np.random.Generator, sizes: dict[str, int]
) -> tuple[str, Fault]:
    """The text with a fault in one of its assignments.

    Args:
        text, at: The C, and the number of a line of :func:`lines`.
        rng: Draws the fault.
        sizes: Entries of every block that may be read.
    """
    rows = text.splitlines()
    head, _, tail = rows[at].partition(" = ")
    ways = [(way, list(way.finditer(tail))) for way in (NUMBER, READ, SIGN, NAME)]
    ways = [(way, found) for way, found in ways if found]
    if not ways or rng.random() < 0.15:
        tail, kind = f"-({tail.rstrip(';')});", "sign"
    else:
        way, found = ways[rng.integers(len(ways))]
        one = found[rng.integers(len(found))]
        kind, new = _changed(way, one, rows[:at], rng, sizes)
        tail = tail[: one.start()] + new + tail[one.end() :]
    before, rows[at] = rows[at], f"{head} = {tail}"
    return "\n".join(rows) + "\n", Fault(kind, f"{before.strip()} -> {rows[at].strip()}")


def _changed(
    way: re.Pattern[str],
    one: re.Match[str],
    before: list[str],
    rng: np.random.Generator,
    sizes: dict[str, int],
) -> tuple[str, str]:
    if way is NUMBER:
        old = float(one[0])
        return "constant", repr(old * (2.0 if rng.random() < 0.5 else 1.001) if old else 1.0)
    if way is READ:
        size = sizes.get(one[1], 1)
        if size < 2:
            return "sign", f"(-{one[0]})"
        return "index", f"in->{one[1]}[{(int(one[2]) + int(rng.integers(1, size))) % size}]"
    if way is SIGN:
        return "sign", " - " if one[1] == "+" else " + "
    declared = [m[1] for row in before if (m := re.match(r"^\s*const real (\w+) = ", row))]
    others = [name for name in declared if name != one[0]]
    return "frame", str(others[rng.integers(len(others))]) if others else f"(-{one[0]})"
