"""Operations, lines and work memory of the C are committed: none rises unseen, none falls unkept.

``pytest tests/golden/test_counts.py --accept`` writes ``counts.json`` anew.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

import cardan as cd
from cardan.codegen import generate
from golden.scenes import EXAMPLES, scene_of
from mechanisms.robots import STANDARD
from spread import some

TABLE = Path(__file__).parent / "counts.json"
DERIVATIVES = tuple(
    f"derivative of {name}: q u" for name in ("inverse_dynamics", "forward_dynamics")
)
FUNCTIONS = ("forward_dynamics", "inverse_dynamics", "mass_matrix", "bias", "rhs", *DERIVATIVES)
# speeds of the largest system whose derivatives are counted: they grow with n times depth
DIFFERENTIATED = 40
# column -> operators in it
COLUMNS = {
    "mul": ("mul",),
    "add": ("add", "sub"),
    "neg": ("neg",),
    "div": ("div",),
    "sqrt": ("sqrt",),
    "trig": ("sin", "cos"),
}
ACCEPT = "pytest tests/golden/test_counts.py --accept"
CASES: dict[str, Callable[[], cd.Scene]] = {
    **{example.name: partial(scene_of, example) for example in EXAMPLES},
    **{name: standard.build for name, standard in STANDARD.items()},
}


def counted(scene: cd.Scene) -> dict[str, dict[str, int]]:
    """Function -> column -> number, of the C as it is written."""
    equations = cd.derive(scene)
    found = {}
    for name in FUNCTIONS:
        if name in DERIVATIVES and equations.system.nu > DIFFERENTIATED:
            continue
        key = ("derivative", name.removeprefix("derivative of "))
        form = equations.form(*key) if name in DERIVATIVES else equations.form(name)
        file = generate(form, model=equations.system.name)
        counts = dict(file.entry["operations"])
        row = {
            column: sum(counts.pop(operator, 0) for operator in operators)
            for column, operators in COLUMNS.items()
        }
        row["other"] = sum(counts.values())
        row["prepare"] = sum(file.prepare_operations.values())
        row["lines"] = len(file.text.splitlines())
        row["work"] = file.entry["work_size"]
        found[name] = {column: n for column, n in row.items() if n}
    return found


def changes(
    new: dict[str, dict[str, int]], old: dict[str, dict[str, int]]
) -> tuple[list[str], list[str]]:
    """What rose and what fell."""
    rose, fell = [], []
    for function in FUNCTIONS:
        now, before = new.get(function, {}), old.get(function, {})
        for column in dict.fromkeys((*now, *before)):
            a, b = before.get(column, 0), now.get(column, 0)
            if a != b:
                (rose if b > a else fell).append(f"{function}: {column} {a} -> {b}")
    return rose, fell


def kept() -> dict[str, Any]:
    return dict(json.loads(TABLE.read_text("utf-8"))) if TABLE.exists() else {}


def write(table: dict[str, Any]) -> None:
    """One function per line, in the order of the cases."""
    blocks = []
    for name in (case for case in CASES if case in table):
        rows = ",\n".join(f"  {json.dumps(f)}: {json.dumps(r)}" for f, r in table[name].items())
        blocks.append(f" {json.dumps(name)}: {{\n{rows}\n }}")
    TABLE.write_text("{\n" + ",\n".join(blocks) + "\n}\n", "utf-8")


# files of robots, and what is published, state inertias of no body
@pytest.mark.filterwarnings("ignore:.*triangle inequality")
@pytest.mark.parametrize("name", some(CASES, 3))
def test_counts(name: str, pytestconfig: pytest.Config) -> None:
    try:
        scene = CASES[name]()
    except FileNotFoundError as missing:
        pytest.skip(str(missing))
    new, table = counted(scene), kept()
    if pytestconfig.getoption("--accept"):
        write({**table, name: new})
        return
    assert name in table, f"{name} is new: {ACCEPT}"
    rose, fell = changes(new, table[name])
    assert not rose, f"{name} became more expensive: {'; '.join(rose)}"
    assert not fell, f"{name} became cheaper, keep it with {ACCEPT}: {'; '.join(fell)}"


def test_the_table_has_no_other_cases() -> None:
    assert set(kept()) == set(CASES)


def test_a_rise_and_a_fall_are_told_apart() -> None:
    old = {name: {"mul": 10, "add": 5} for name in FUNCTIONS}
    new = {**old, "bias": {"mul": 11, "add": 4}}
    assert changes(new, old) == (["bias: mul 10 -> 11"], ["bias: add 5 -> 4"])
