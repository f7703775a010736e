"""Records are what their fields say, and nothing else."""

from __future__ import annotations

from typing import Any

import pytest

from cardan.schema import fields
from cardan.schema.fields import Misfit, Record, field, listed, maybe, one_of, pair, table
from cardan.schema.mechanism import JointRow

# kind -> what it takes, what it does not
KINDS: dict[str, tuple[fields.Kind, list[Any], list[Any]]] = {
    "text": (fields.text, ["", "a"], [1, None, b"a", "\ud800"]),
    "number": (fields.number, [0, 1.5, -3, float("inf")], [True, "1", None, 2**60, 1j]),
    "positive": (fields.positive, [1, 0.5], [0, -1.0, True, float("nan")]),
    "integer": (fields.integer, [-1, 0], [1.0, True, 2**53]),
    "count": (fields.count, [0, 3], [-1, 1.0, True, 2**53]),
    "size": (fields.size, [0, 2**40 - 1], [-1, 2**40, 1.0]),
    "flag": (fields.flag, [True, False], [0, None, "true"]),
    "one of": (one_of("a", "b"), ["a"], ["c", 1, None]),
    "matching": (fields.matching("^[a-z]+$", "a word"), ["ab"], ["a1", "", "ab\n", 3]),
    "list": (listed(fields.count, 2), [[1, 2]], [[1], [1, 2, 3], [1, -1], (1, 2), {}]),
    "table": (table(fields.count), [{}, {"a": 1}], [{"a": -1}, {1: 1}, [], None]),
    "maybe": (maybe(fields.count), [None, 1], [-1, "a"]),
    "pair": (pair(), [[0, 3]], [[0], [0, -1], None, [0.0, 1]]),
}


@pytest.mark.parametrize("name", KINDS)
def test_kinds(name: str) -> None:
    kind, good, bad = KINDS[name]
    for value in good:
        found = kind.read(value, False)
        assert found == (tuple(value) if name == "pair" else value)
    for value in bad:
        with pytest.raises(Misfit):
            kind.read(value, False)


class End(Record):
    """An end of something."""

    name: str = field(fields.text)
    side: int = field(fields.count, "which", default=0)


class Whole(Record):
    """Something with ends."""

    first: End = field(End)
    ends: list[End] = field(listed(End), run=())
    note: str | None = field(fields.text, default=None)


def test_a_record_says_where_it_is_damaged() -> None:
    plain = {"first": {"name": "a"}, "ends": [{"name": "b"}, {"name": "c", "side": -1}]}
    with pytest.raises(Misfit, match=r"^'ends\[1\]\.side' is -1, not an integer from 0 on$"):
        Whole.read(plain)
    with pytest.raises(Misfit, match=r"^'first\.name' is missing$"):
        Whole.read({"first": {}, "ends": []})
    with pytest.raises(Misfit, match=r"^'ends' is missing$"):
        Whole.read({"first": {"name": "a"}})


@pytest.mark.parametrize("owner", [{"q": [0, 2]}, {"solved": {"q": ["a", "b"], "u": ["c"]}}])
def test_a_start_has_a_number_for_each_coordinate(owner: dict[str, object]) -> None:
    told = {"name": "joint", "kind": "universal", **owner}
    assert JointRow.read({**told, "q0": [0.1, 0.2]}, True).q0 == [0.1, 0.2]
    with pytest.raises(Misfit, match=r"'q0' has 1 numbers, not 2"):
        JointRow.read({**told, "q0": [0.1]}, True)


def test_saved_runs_may_say_less() -> None:
    found = Whole.read({"first": {"name": "a", "more": 3}}, run=True)
    assert found.ends == ()
    assert found.first == End(name="a")
    assert found.note is None


def test_what_has_its_default_is_not_written() -> None:
    made = Whole(first=End(name="a", side=0), ends=[End(name="b", side=1)], note=None)
    assert fields.dumped(made) == '{"first": {"name": "a"}, "ends": [{"name": "b", "side": 1}]}'
    assert Whole.read({"first": {"name": "a"}, "ends": [{"name": "b", "side": 1}]}) == made
    assert made.replaced(note="x").note == "x"


def test_a_record_cannot_be_changed_or_made_of_anything() -> None:
    with pytest.raises(AttributeError):
        End(name="a").name = "b"  # type: ignore[misc]
    with pytest.raises(AttributeError):
        del End(name="a").name
    with pytest.raises(TypeError, match="name"):
        End(side=1)  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="more"):
        End(name="a", more=1)  # type: ignore[call-arg]


def test_people_may_read_by_key() -> None:
    end: Any = End(name="a")
    assert (end["name"], end["side"], end.get("other", 7)) == ("a", 0, 7)
    assert "side" not in end
    assert {**end} == {"name": "a"}
    with pytest.raises(KeyError):
        end["other"]


def test_the_schema_says_the_same() -> None:
    schema = Whole.json_schema()
    assert schema["required"] == ["first", "ends"]
    side = schema["properties"]["ends"]["items"]["properties"]["side"]
    assert side == {"type": "integer", "minimum": 0, "description": "which"}
