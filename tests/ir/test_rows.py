"""Rows that are told by their pattern read like those that are written out."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from cardan.ir.rows import SOME, Rows, Run, column, dumped, having, opened

COUNT = SOME + 3


def pattern() -> tuple[dict[str, Any], ...]:
    x: dict[str, Any] = {"name": {"text": ["n", 1, ".x"]}, "q": {"integer": [5, 2, 2]}}
    return (
        x | {"default": {"value": 1}, "limits": {}},
        {"name": {"text": ["n", 1, ".y"]}, "at": {"integer": [7, 3]}, "default": {"value": 0}},
    )


def both() -> tuple[Rows, list[dict[str, Any]]]:
    """Rows, and the same written out."""
    values = np.random.default_rng(3).normal(size=(COUNT, 2))
    first = [{"name": "a", "default": 0.5, "q0": 2.0}]
    plain = list(first)
    for k in range(COUNT):
        q = [5 + 2 * k, 2]
        plain.append({"name": f"n{1 + k}.x", "q": q, "default": values[k, 1], "limits": {}})
        plain.append({"name": f"n{1 + k}.y", "at": 7 + 3 * k, "default": values[k, 0]})
    return Rows(first, [Run(COUNT, pattern(), values)]), plain


def test_they_are_those_that_are_written_out() -> None:
    rows, plain = both()
    assert len(rows) == len(plain)
    assert list(rows) == plain
    assert [rows[k] for k in range(len(rows))] == plain
    assert rows[-1] == plain[-1]
    assert rows[3:9:2] == plain[3:9:2]
    for key in ("name", "default", "q", "at", "q0"):
        assert column(rows, key) == column(plain, key)
        assert list(having(rows, key)) == list(having(plain, key))
    assert rows.kinds == plain[:3]
    with pytest.raises(IndexError):
        rows[len(plain)]


def test_json_keeps_them() -> None:
    rows, plain = both()
    text = dumped({"coordinates": rows, "name": "m"})
    assert len(text) < 0.5 * len(json.dumps(plain))
    again = opened(json.loads(text))
    assert again["name"] == "m"
    assert again["coordinates"] == rows
    assert list(again["coordinates"]) == plain


@pytest.mark.parametrize(
    "harm",
    [
        {"count": 0},
        {"pattern": []},
        {"pattern": ["n"]},
        {"pattern": [{"name": {"text": ["n"]}}]},
        {"pattern": [{"default": {"value": 2}}]},
        {"values": "AAAA"},
        {"values": None},
    ],
)
def test_damage_is_told(harm: dict[str, Any]) -> None:
    told = json.loads(dumped({"speeds": both()[0]}))
    told["speeds"]["runs"][0] |= harm
    with pytest.raises(ValueError, match=r"damaged|rows|buffer|reshape|unpack"):
        opened(told)
