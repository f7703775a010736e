"""Recursions: visits in order, saved and read again, damaged ones refused."""

from __future__ import annotations

import copy
import json
from typing import Any

import pytest

from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from cardan.ir.recursion import OUT, STORE, Recursion, Sweep, Visit
from cardan.ir.serialize import from_dict, to_dict
from table import each


def power() -> Recursion:
    """Horner's scheme: out = ((p2 q + p1) q + p0), one visit per coefficient."""

    def step(first: bool) -> Function:
        g = Graph()
        q, p, total = g.var("q", 0), g.var("p", 0), g.var(STORE, 0)
        value = p if first else g.add(g.mul(total, q), p)
        blocks = [Block("p", ("c",), ("",))]
        if not first:
            blocks += [Block("q", ("q",), ("",)), Block(STORE, ("total",), ("",))]
        outputs = (Output(STORE, (1,), (value,), ("total",)), Output(OUT, (0,), ()))
        return Function("first" if first else "next", g, tuple(blocks), outputs)

    g = Graph()
    give = Function(
        "last",
        g,
        (Block(STORE, ("total",), ("",)),),
        (Output(STORE, (0,), ()), Output(OUT, (1,), (g.var(STORE, 0),), ("y",))),
    )
    visits = (
        Visit(0, {"p": (2,)}, (0,), ()),
        Visit(1, {"p": (1,), "q": (0,), STORE: (0,)}, (1,), ()),
        Visit(1, {"p": (0,), "q": (0,), STORE: (1,)}, (0,), ()),
    )
    blocks = (Block("q", ("q",), ("",)), Block("p", ("c0", "c1", "c2"), ("",) * 3))
    sweeps = (Sweep("down", visits), Sweep("end", (Visit(2, {STORE: (0,)}, (), (0,)),)))
    steps = (step(True), step(False), give)
    return Recursion("power", blocks, (Output("y", (), (), ("y",)),), steps, sweeps, 2)


def test_visits_are_spliced_in_order() -> None:
    straight = power().straight()
    assert evaluate(straight, {"q": [3.0], "p": [5.0, 7.0, 2.0]})["y"] == [5 + 7 * 3 + 2 * 9]
    assert straight.operations() == power().operations() == {"add": 2, "mul": 2}


def test_saved_recursions_come_back() -> None:
    saved = json.loads(json.dumps(to_dict(power())))
    assert to_dict(from_dict(saved)) == to_dict(power().straight())


def damaged() -> dict[str, tuple[Any, str]]:
    """Name -> (damaged recursion, words of the refusal)."""
    found = {}

    def damage(name: str, words: str) -> dict[str, Any]:
        data: dict[str, Any] = copy.deepcopy(json.loads(json.dumps(to_dict(power()))))
        found[name] = (data, words)
        return data

    damage("size", "whole number")["size"] = -1
    damage("huge", "whole number")["size"] = 10**12
    damage("step", "names step 7")["sweeps"][0]["visits"][0][0] = 7
    damage("place", "leaves the 3 places of 'p'")["sweeps"][0]["visits"][0][1]["p"] = [3]
    damage("store", "leaves the 2 places of 'store'")["sweeps"][0]["visits"][0][2] = [2]
    damage("out", "leaves the 1 places of 'out'")["sweeps"][1]["visits"][0][3] = [1]
    damage("few", "needs 1 places of 'q'")["sweeps"][0]["visits"][1][1]["q"] = []
    damage("form", "saved visit is")["sweeps"][0]["visits"][0] = "x"
    damage("outputs", "two outputs")["steps"][0]["outputs"].pop()
    damage("shape", "whole numbers")["outputs"][0]["shape"] = [-1]
    return found


@each("name", damaged())
def test_damaged_ones_are_refused(name: str) -> None:
    data, words = damaged()[name]
    with pytest.raises(ValueError, match=words):
        from_dict(data)
