"""C names of the quantities of frames and joints."""

from __future__ import annotations

from itertools import permutations

from cardan.equations.functions.blocks import c_name


def test_names_that_are_one_in_c_or_look_numbered_stay_apart() -> None:
    awkward = ("a b", "a_b", "a-b", "a_b_0", "a_b_1", "a b_", "a_b__0", "hand")
    for first in range(len(awkward)):
        known = [*awkward[first:], *awkward[:first]]
        assert len({c_name("pose", name, known) for name in known}) == len(known)


def test_plain_names_stay_as_they_are_in_any_order() -> None:
    for known in permutations(("hand", "upper.at1", "hand_0")):
        assert c_name("pose", "hand", list(known)) == "pose__hand"
        assert c_name("pose", "upper.at1", list(known)) == "pose__upper_at1"
    assert c_name("rhs", None, ["hand"]) == "rhs"
