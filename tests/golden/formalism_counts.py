"""Operations of every formalism on every mechanism, and the page that shows them.

usage: python tests/golden/formalism_counts.py
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from functools import partial
from math import exp, log
from pathlib import Path

# the zoo stands in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import cardan as cd
from cardan.equations.formalisms import FORMALISMS
from mechanisms import ZOO
from mechanisms.closed import CLOSED
from mechanisms.rolling import ROLLING

KEPT = Path(__file__).with_suffix(".json")
PAGE = Path(__file__).parents[2] / "docs" / "formalisms.md"
BEGIN, END = "<!-- counts -->\n", "<!-- end of counts -->\n"
FUNCTIONS = ("forward_dynamics", "inverse_dynamics", "mass_matrix", "bias")
CASES: dict[str, Callable[[], cd.Scene]] = {
    **{name: member.build for name, member in ZOO.items()},
    **{name: member.build for name, member in CLOSED.items()},
    **{name: partial(build) for name, build in ROLLING.items()},
}
# what one mechanism costs: by formalism and function; speeds, multipliers; in absolute coordinates
Row = dict[str, dict[str, int]]


def counted(build: Callable[[], cd.Scene]) -> Row:
    """The row of one mechanism."""
    row: Row = {}
    for method in FORMALISMS:
        e = cd.derive(build(), method=method)
        row["size"] = {"speeds": len(e.speeds), "multipliers": len(e.multipliers)}
        row[method] = {}
        for function in FUNCTIONS:
            try:
                row[method][function] = e.operations_of(function).total
            except cd.DerivationError:
                # the formalism does not take it
                continue
    try:
        absolute = cd.derive(build(), coordinates="absolute")
    except cd.DerivationError:
        return row
    groups = [(group.kind, len(group)) for group in absolute.groups]
    row["absolute"] = {
        "elements": sum(
            absolute.operations[kind.c_name("balance")].total * members for kind, members in groups
            if "balance" in kind.functions
        ),
        "speeds": absolute.places.nu,
        "multipliers": sum(kind.m * members for kind, members in groups),
    }  # fmt: skip
    return row


def kept() -> dict[str, Row]:
    return dict(json.loads(KEPT.read_text("utf-8"))) if KEPT.exists() else {}


def write(table: dict[str, Row]) -> None:
    """The table and the page, mechanisms in the order of the cases."""
    ordered = {name: table[name] for name in CASES if name in table}
    rows = (f" {json.dumps(name)}: {json.dumps(row)}" for name, row in ordered.items())
    KEPT.write_text("{\n" + ",\n".join(rows) + "\n}\n", "utf-8")
    before, _, rest = PAGE.read_text("utf-8").partition(BEGIN)
    PAGE.write_text(before + BEGIN + shown(ordered) + END + rest.partition(END)[2], "utf-8")


def shown(table: dict[str, Row]) -> str:
    """The tables of the page."""
    return "\n".join(("", *summary(table), "", *overview(table), "", ""))


def summary(table: dict[str, Row]) -> Iterator[str]:
    """How many times the operations of the cheapest formalism, geometric mean over all."""
    yield f"| times the fewest | {' | '.join(FORMALISMS)} |"
    yield f"|---|{'---:|' * len(FORMALISMS)}"
    for function in FUNCTIONS:
        ratios: dict[str, list[float]] = {method: [] for method in FORMALISMS}
        # mechanisms that differ in nothing that counts are one
        for row in {json.dumps(row): row for row in table.values()}.values():
            counts = {m: row[m][function] for m in FORMALISMS if row[m].get(function)}
            for method, count in counts.items():
                ratios[method].append(count / min(counts.values()))
        means = [exp(sum(map(log, x)) / len(x)) for x in ratios.values()]
        yield f"| `{function}` | {' | '.join(f'{mean:.2f}' for mean in means)} |"


def overview(table: dict[str, Row]) -> Iterator[str]:
    """Operations of forward dynamics, mechanism by formalism; absolute coordinates apart."""
    heads = ("speeds", "multipliers", *FORMALISMS, "elements", "speeds", "multipliers")
    yield f"| mechanism | {' | '.join(heads)} |"
    yield f"|---|{'---:|' * len(heads)}"
    alike: dict[str, list[str]] = {}
    for name, row in table.items():
        counts = [row[method].get("forward_dynamics", "–") for method in FORMALISMS]
        size, elements = row["size"].values(), row.get("absolute", {})
        apart = [elements.get(key, "–") for key in ("elements", "speeds", "multipliers")]
        alike.setdefault(" | ".join(map(str, (*size, *counts, *apart))), []).append(name)
    for cells, (first, *others) in alike.items():
        yield f"| {first}{f' and {len(others)} alike' if others else ''} | {cells} |"


if __name__ == "__main__":
    from cardan.cli.terminal import progress

    found: dict[str, Row] = {}
    with progress() as show:
        for k, (case, make) in enumerate(CASES.items()):
            show(case, k / len(CASES))
            found[case] = counted(make)
    write(found)
