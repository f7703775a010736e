"""Requests of derivatives as text and back."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from cardan.schema.request import Request

names = st.text(st.characters(blacklist_categories=("Cs", "Cc")), min_size=1, max_size=12)


def test_plain_words() -> None:
    assert str(Request("pose", "hand", ("q", "upper.mass"))) == "pose(hand): q upper.mass"
    assert Request.read(" bias :q  u") == Request("bias", None, ("q", "u"))


@given(of=st.none() | names, wrt=st.lists(names, min_size=1, max_size=4))
def test_any_names_come_back(of: str | None, wrt: list[str]) -> None:
    request = Request("pose", of, tuple(wrt))
    assert Request.read(str(request)) == request


@pytest.mark.parametrize("text", ["", "bias", "bias:", "bias(: q", 'bias: "q', "bias q"])
def test_what_is_no_request(text: str) -> None:
    with pytest.raises(ValueError, match="names no derivative"):
        Request.read(text)
