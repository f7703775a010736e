"""Long functions in parts: the same bits, work reused, values only from earlier parts."""

import re
from itertools import pairwise

import numpy as np
import pytest

from cardan.codegen import generate
from cardan.codegen.program import sections as section_order
from cardan.codegen.program.parts import crossing, split
from cardan.codegen.program.plan import make_plan
from cardan.codegen.program.sections import arrange
from cardan.codegen.program.values import Values
from codegen.functions import random_function, values
from codegen.running import call, compilers, expected


@pytest.mark.parametrize("compiler", sorted(compilers()))
@pytest.mark.parametrize("longest", [1, 7, 40])
def test_splitting_changes_no_bit(longest: int, compiler: str) -> None:
    function, given = random_function(11, 200), values(11)
    whole, pieces = generate(function), generate(function, longest=longest)
    assert "_part2(" in pieces.text
    assert "_part1(" not in whole.text
    answer = call(pieces, given, compiler)
    assert np.array_equal(answer.out, expected(function, given), equal_nan=True)
    assert np.array_equal(answer.out, call(whole, given, compiler).out, equal_nan=True)
    assert answer.status == 0


def test_parts_have_about_equal_length() -> None:
    sections = [(f"s{k}", list(range(100 * k, 100 * k + 37 + 11 * (k % 5)))) for k in range(40)]
    parts = split(sections, 500)
    sizes = [sum(len(s) for _, s in part) for part in parts]
    assert [i for part in parts for _, s in part for i in s] == [i for _, s in sections for i in s]
    assert max(sizes) <= 500
    assert min(sizes[:-1]) >= 500 // 3


def test_short_functions_stay_whole_and_long_sections_are_cut() -> None:
    assert split([("a", [1, 2]), ("b", [3])], 3) == [[("a", [1, 2]), ("b", [3])]]
    parts = split([("a", list(range(10)))], 4)
    assert [len(s) for part in parts for _, s in part] == [4, 4, 2]
    assert {title for part in parts for title, _ in part} == {"a"}
    assert split([], 4) == [[]]


def test_places_in_work_are_used_again() -> None:
    # a chain: every part reads only the part before
    parts = [[("", [k])] for k in range(20)]
    places, length = crossing(parts, {k: (k - 1,) if k else () for k in range(20)}, 5)
    assert sorted(places) == list(range(19))
    assert length == 7
    # a value that everybody reads keeps its place
    reads = {k: (0, k - 1) if k else () for k in range(20)}
    places, length = crossing(parts, reads, 0)
    assert places[0] not in {places[k] for k in range(1, 19)}


def test_a_part_reads_only_what_was_stored_before() -> None:
    text = generate(random_function(12, 200), longest=9).text
    body = text.split("CARDAN_PART int random_part1(")[1]
    stored: set[str] = set()
    for line in body.splitlines():
        target = re.match(r"\s+(work\[\d+\]) =", line)
        if target:
            stored.add(target[1])
        for read in re.findall(r"= (work\[\d+\]);", line):
            assert read in stored


def test_sections_keep_what_reads_what_and_gather_owners() -> None:
    function = random_function(3, 150)
    graph, order = function.graph, function.live()
    values = Values(function, order, ())
    plan = make_plan(graph, order, function.roots, (), values)
    sections = arrange(plan)
    placed = [i for _, statements in sections for i in statements]
    assert sorted(placed) == sorted(plan.reads)
    seen: set[int] = set(plan.outside)
    for i in placed:
        assert seen.issuperset(plan.reads[i])
        seen.add(i)
    # statements of one owner stand together: fewer sections than changes of owner before
    homes = [plan.owners[i].section for i in plan.reads]
    assert len(sections) < sum(a != b for a, b in pairwise(homes))
    assert all(plan.owners[i].section == title for title, s in sections for i in s)


def test_statements_do_not_overtake_too_many(monkeypatch: pytest.MonkeyPatch) -> None:
    function = random_function(3, 150)
    values = Values(function, function.live(), ())
    plan = make_plan(function.graph, function.live(), function.roots, (), values)
    monkeypatch.setattr(section_order, "WINDOW", 10)
    number = {i: n for n, i in enumerate(plan.reads)}
    placed = [number[i] for _, statements in arrange(plan) for i in statements]
    for at, n in enumerate(placed):
        # sine and cosine are numbered as neighbors: a few more than the window
        assert n - min(placed[at:]) <= 10 + 8
