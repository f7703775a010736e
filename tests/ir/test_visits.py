"""Recursions evaluated visit by visit: the numbers of the straight line, and what they refuse."""

from __future__ import annotations

import json
import random

import numpy as np
import pytest

from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from cardan.ir.recursion import OUT, STORE, Recursion, Sweep, Turns, Visit, ahead
from cardan.ir.serialize import LISTED, form_from_dict, to_dict
from cardan.ir.strided_visits import FEWEST, LONGEST, as_turns
from cardan.ir.visits import SINGLE, RepeatedRecursion


def pendulums(count: int) -> Recursion:
    """Heights of the ends of a chain: every visit adds the length times the sine of its angle."""

    def step(first: bool) -> Function:
        g = Graph()
        way = g.mul(g.var("p", 0), g.apply("sin", g.var("q", 0)))
        end = way if first else g.add(g.var(STORE, 0), way)
        blocks = [Block("q", ("angle",), ("",)), Block("p", ("length",), ("",))]
        blocks += [] if first else [Block(STORE, ("height",), ("",))]
        outputs = (Output(STORE, (1,), (end,)), Output(OUT, (2,), (end, g.neg(end))))
        return Function("first" if first else "next", g, tuple(blocks), outputs)

    visits = [
        Visit(
            min(k, 1),
            {"q": (k,), "p": (k,)} | ({STORE: (k - 1,)} if k else {}),
            (k,),
            (k, count + k),
        )
        for k in range(count)
    ]
    names = tuple(f"x{k}" for k in range(count))
    blocks = tuple(Block(name, names, ("",) * count) for name in ("q", "p"))
    outputs = (Output("up", (count,), ()), Output("down", (count, 1), ()))
    sweeps = (Sweep("outward", as_turns(visits)),)
    return Recursion("heights", blocks, outputs, (step(True), step(False)), sweeps, count)


def values(count: int, *shape: int) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(count)
    return {"q": rng.uniform(-1, 1, (*shape, count)), "p": rng.uniform(1, 2, count)}


@pytest.mark.parametrize("count", [1, 3, 50])
def test_the_numbers_are_those_of_the_straight_line(count: int) -> None:
    recursion, at = pendulums(count), values(count)
    lists = {name: x.tolist() for name, x in at.items()}
    found = RepeatedRecursion(recursion)(lists)
    assert found == evaluate(recursion.straight(), lists)
    # in closed form: sums of lengths times sines
    np.testing.assert_allclose(
        found["up"], np.cumsum(at["p"] * np.sin(at["q"])), rtol=1e-15 * count
    )


@pytest.mark.parametrize("shape", [(), (2, 3), (0,), (SINGLE + 1,)])
@pytest.mark.parametrize("kind", [float, complex])
def test_several_states_at_once(shape: tuple[int, ...], kind: type) -> None:
    recursion, at = pendulums(5), values(5, *shape)
    at = {name: x.astype(kind) for name, x in at.items()}
    found = RepeatedRecursion(recursion).over(at)
    exact = np.cumsum(at["p"] * np.sin(at["q"]), axis=-1)
    assert found["up"].shape == (*shape, 5)
    assert found["down"].shape == (*shape, 5, 1)
    np.testing.assert_allclose(found["up"], exact, rtol=1e-14, atol=1e-14)
    np.testing.assert_allclose(found["down"][..., 0], -exact, rtol=1e-14, atol=1e-14)


def test_blocks_that_do_not_fit_are_refused() -> None:
    visits = RepeatedRecursion(pendulums(3))
    with pytest.raises(ValueError, match="'heights' reads block 'p'; given: q"):
        visits({"q": [0.0] * 3})
    with pytest.raises(ValueError, match="block 'q' of function 'heights' has 3 entries, not 2"):
        visits({"q": [0.0] * 2, "p": [0.0] * 3})


def test_blocks_that_nothing_reads_have_no_say() -> None:
    at = {**values(3), "t": np.zeros((4, 0)), "r": np.zeros((7, 2))}
    assert RepeatedRecursion(pendulums(3)).over(at)["up"].shape == (3,)


def test_entries_that_visits_read() -> None:
    recursion = pendulums(7)
    assert recursion.entries_read("p") == recursion.straight().entries_read("p") == {*range(7)}
    assert not recursion.entries_read("t")


def test_they_are_saved_as_they_are() -> None:
    recursion = pendulums(40)
    saved = json.loads(json.dumps(to_dict(recursion)))
    again = form_from_dict(saved)
    assert to_dict(again) == saved
    at = {name: x.tolist() for name, x in values(40).items()}
    assert isinstance(again, Recursion)
    assert RepeatedRecursion(again)(at) == RepeatedRecursion(recursion)(at)


def test_names_of_long_blocks_may_be_left_out() -> None:
    for count in (LISTED, LISTED + 1):
        saved = to_dict(pendulums(count), ("p",))
        named = {block["name"]: "entries" in block for block in saved["inputs"]}
        assert named == {"q": True, "p": count <= LISTED}
        assert [len(block) for block in form_from_dict(saved).inputs] == [count, count]
    saved["inputs"][1]["size"] = -1
    with pytest.raises(ValueError, match="'size' of a saved block must be a whole number, not -1"):
        form_from_dict(saved)


def test_a_longer_chain_takes_no_more_room() -> None:
    texts = [json.dumps(to_dict(pendulums(n), ("q", "p"))) for n in (2000, 8000)]
    assert abs(len(texts[0]) - len(texts[1])) < 20


def stride(a: Visit, b: Visit) -> Visit | None:
    """What is added to the entries of one visit for those of another of the same step."""
    if a.step != b.step:
        return None

    def away(x: tuple[int, ...], y: tuple[int, ...]) -> tuple[int, ...]:
        return tuple(k - j for j, k in zip(x, y, strict=True))

    reads = {block: away(a.reads[block], b.reads[block]) for block in a.reads}
    return Visit(a.step, reads, away(a.stores, b.stores), away(a.outs, b.outs))


def by_search(visits: list[Visit]) -> tuple[Visit | Turns, ...]:
    """Turns as they are defined: the longest repetition at every visit, looked for one by one."""

    def turns(at: int, n: int) -> Turns:
        first = tuple(visits[at : at + n])
        strides = [stride(a, b) for a, b in zip(first, visits[at + n : at + 2 * n], strict=False)]
        if len(strides) < n or None in strides:
            return Turns(first, (), 1)
        result = Turns(first, tuple(s for s in strides if s is not None), 2)
        while tuple(visits[at + result.times * n : at + (result.times + 1) * n]) == tuple(
            ahead(v, s, result.times) for v, s in zip(first, result.strides, strict=True)
        ):
            result = result._replace(times=result.times + 1)
        return result

    parts: list[Visit | Turns] = []
    at = 0
    while at < len(visits):
        found = [turns(at, n) for n in range(1, LONGEST + 1)]
        long = [len(t.visits) * t.times * (t.times >= FEWEST) for t in found]
        best = found[long.index(max(long))]
        parts.append(best if max(long) else visits[at])
        at += max(long) or 1
    return tuple(parts)


def repeated(draw: random.Random) -> list[Visit]:
    """A few visits, repeated at regular distances."""
    count, times = draw.randint(1, LONGEST + 1), draw.randint(1, 9)
    period = [(draw.randint(0, 1), draw.choices(range(4), k=8)) for _ in range(count)]
    visits = []
    for k in range(times):
        for step, numbers in period:
            starts, strides = numbers[:4], numbers[4:]
            a, b, c, d = (x + k * dx for x, dx in zip(starts, strides, strict=True))
            visits.append(Visit(step, {"p": (a, b)} if step else {"q": (a,)}, (c,), (d,)))
    return visits


def test_turns_are_the_longest_there_are() -> None:
    draw, told = random.Random(1), 0
    for _ in range(300):
        visits = [visit for _ in range(draw.randint(0, 4)) for visit in repeated(draw)]
        found = as_turns(visits)
        assert found == by_search(visits)
        told += sum(isinstance(part, Turns) for part in found)
    assert told > 300
