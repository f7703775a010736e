"""Rows that repeat a pattern read like rows that are there."""

from __future__ import annotations

import json

import numpy as np
import pytest

from cardan.schema.fields import NOTHING, Misfit, Record, dumped, field, number, pair, table, text
from cardan.schema.rows import SOME, Rows, Run, column, having, rows_of

COUNT = SOME + 3


class Row(Record):
    """A row with everything that may follow a pattern."""

    name: str = field(text)
    at: tuple[int, int] | None = field(pair(), default=None)
    default: float = field(number, default=0.0)
    limits: dict[str, float] = field(table(number), default=NOTHING)


ROWS = rows_of(Row)


def rows() -> Rows[Row]:
    pattern = (
        {"name": {"text": ["node", 4, ".x"]}, "default": {"value": 0}},
        {"name": {"text": ["node", 4, ".y"]}, "at": {"integer": [8, 2, 3]}, "limits": {}},
    )
    values = np.arange(COUNT, dtype=float)[:, None] / 3
    return Rows([Row(name="first", limits={"lower": 1.0})], [Run(Row, COUNT, pattern, values)])


def expanded() -> list[Row]:
    found = [Row(name="first", limits={"lower": 1.0})]
    for k in range(COUNT):
        found.append(Row.trusted({"name": f"node{4 + k}.x", "default": k / 3}))
        found.append(Row.trusted({"name": f"node{4 + k}.y", "at": (8 + 2 * k, 3), "limits": {}}))
    return found


def test_rows_are_those_of_the_pattern() -> None:
    made, wanted = rows(), expanded()
    assert len(made) == len(wanted)
    assert list(made) == wanted
    some = (0, 1, 2, 2 * SOME, -1)
    assert [made[k] for k in some] == [wanted[k] for k in some]
    assert made[1:5] == wanted[1:5]
    assert made[-2:] == wanted[-2:]
    with pytest.raises(IndexError):
        made[len(wanted)]


def test_columns() -> None:
    for key in ("name", "at", "default"):
        made = [x or None for x in column(rows(), key)]
        assert made == [x or None for x in column(expanded(), key)]
    assert list(having(rows(), "limits")) == list(having(expanded(), "limits")) == [rows()[0]]


def again(told: object) -> object:
    return ROWS.read(json.loads(dumped(told)), False)


def test_json_gives_them_back_to_the_bit() -> None:
    assert again(rows()) == rows()
    assert list(again(rows())) == expanded()
    assert again(expanded()[:3]) == expanded()[:3]


def test_a_damaged_run_is_refused() -> None:
    told = json.loads(dumped(rows()))
    told["runs"][0]["values"] = "AAAA"
    with pytest.raises(Misfit):
        again(told)
    del told["runs"][0]["values"]
    with pytest.raises(Misfit, match="damaged"):
        again(told)


@pytest.mark.parametrize(
    "harm",
    [
        {"count": 0},
        {"pattern": []},
        {"pattern": ["node"]},
        {"pattern": [{"name": {"text": ["node"]}}]},
        {"pattern": [{"name": "node", "default": {"value": 1}}]},
        {"pattern": [{"name": "node", "at": {"integer": [3, -1, 2]}}]},
        {"pattern": [{"name": "node", "at": {"integer": [0.5, 1, 2]}}]},
        {"pattern": [{"default": 1.0}]},
        # a text times a number is a longer text
        {"pattern": [{"name": {"integer": ["a", "b"]}}], "count": 10**12, "values": ""},
        {"pattern": [{"name": {"text": [1, 2, 3]}}]},
        {"values": None},
    ],
)
def test_what_cannot_be_read_is_refused_at_once(harm: dict[str, object]) -> None:
    told = json.loads(dumped(rows()))
    told["runs"][0] |= harm
    with pytest.raises(Misfit):
        again(told)
