"""Long functions in parts: the same bits, work reused, values only from earlier parts."""

import re

import numpy as np
import pytest

from cardan.codegen import generate
from cardan.codegen.parts import crossing, split
from codegen.functions import random_function, values
from codegen.running import call, compilers, expected


@pytest.mark.parametrize("compiler", sorted(compilers()))
@pytest.mark.parametrize("longest", [1, 7, 40])
def test_splitting_changes_no_bit(longest: int, compiler: str) -> None:
    function, given = random_function(11, 200), values(11)
    whole, pieces = generate(function), generate(function, longest=longest)
    assert "_part2(" in pieces.text
    assert "_part" not in whole.text
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
