"""Rows that repeat a pattern read like rows that are there."""

from __future__ import annotations

import json

import numpy as np
import pytest

from cardan.ir.rows import SOME, Rows, Run, column, dumped, having, opened

COUNT = SOME + 3


def rows() -> Rows:
    pattern = (
        {"name": {"text": ["node", 4, ".x"]}, "at": {"integer": [7, 2]}, "default": {"value": 0}},
        {"name": {"text": ["node", 4, ".y"]}, "at": {"integer": [8, 2, 3]}, "limits": {}},
    )
    values = np.arange(COUNT, dtype=float)[:, None] / 3
    return Rows([{"name": "first", "limits": {"lower": 1.0}}], [Run(COUNT, pattern, values)])


def expanded() -> list[dict[str, object]]:
    found: list[dict[str, object]] = [{"name": "first", "limits": {"lower": 1.0}}]
    for k in range(COUNT):
        found.append({"name": f"node{4 + k}.x", "at": 7 + 2 * k, "default": k / 3})
        found.append({"name": f"node{4 + k}.y", "at": [8 + 2 * k, 3], "limits": {}})
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
    for key in ("name", "at", "default", "limits", "absent"):
        assert column(rows(), key) == column(expanded(), key)
    assert list(having(rows(), "limits")) == list(having(expanded(), "limits")) == [rows()[0]]


def test_json_gives_them_back_to_the_bit() -> None:
    data = {"rows": rows(), "plain": [1, {"a": 2}], "table": {"listed": 1}}
    again = opened(json.loads(dumped(data)))
    assert again == data
    assert list(again["rows"]) == expanded()


def test_a_damaged_run_is_refused() -> None:
    told = json.loads(dumped({"rows": rows()}))
    told["rows"]["runs"][0]["values"] = "AAAA"
    with pytest.raises(ValueError):
        opened(told)
    del told["rows"]["runs"][0]["values"]
    with pytest.raises(ValueError, match="damaged"):
        opened(told)


@pytest.mark.parametrize(
    "harm",
    [
        {"count": 0},
        {"pattern": []},
        {"pattern": ["node"]},
        {"pattern": [{"name": {"text": ["node"]}}]},
        {"pattern": [{"default": {"value": 1}}]},
        {"values": None},
    ],
)
def test_what_cannot_be_read_is_refused_at_once(harm: dict[str, object]) -> None:
    told = json.loads(dumped({"rows": rows()}))
    told["rows"]["runs"][0] |= harm
    with pytest.raises(ValueError, match=r"damaged|without rows|unpack"):
        opened(told)
