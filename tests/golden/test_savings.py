"""What every rewrite and pass saves on the whole zoo: committed, so that losing it is seen.

``pytest tests/golden --accept`` writes the table anew.
"""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path

import pytest

from cardan.equations.record import EquationRecord
from cardan.errors import DerivationError
from golden.savings_counted import savings
from laws.cases import derived
from mechanisms import ZOO

KEPT = Path(__file__).with_name("savings.json")
FUNCTIONS = ("forward_dynamics", "inverse_dynamics", "mass_matrix")


def test_savings_on_the_zoo(pytestconfig: pytest.Config) -> None:
    found: dict[str, Counter[str]] = {name: Counter() for name in FUNCTIONS}
    for member in ZOO:
        for method in ("composite", "articulated"):
            if method not in ZOO[member].methods:
                continue
            equations = EquationRecord(derived(member).system, method)
            for name in FUNCTIONS:
                try:
                    savings_here = savings(equations, name)
                except DerivationError:
                    continue
                found[name].update({s.name: s.operations for s in savings_here})
    text = json.dumps(found, indent=1, sort_keys=True) + "\n"
    if pytestconfig.getoption("--accept"):
        KEPT.write_text(text)
    kept = json.loads(KEPT.read_text())
    less = {
        (name, key): (n, found[name][key])
        for name, row in kept.items()
        for key, n in row.items()
        if found[name][key] < n
    }
    assert not less, f"saved before, saved now: {less}"
    assert kept == json.loads(text), "more is saved: run pytest tests/golden --accept"
