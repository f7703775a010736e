"""Names of the numbers of results that no block of a model has names for."""

from __future__ import annotations

import pytest

from cardan.runtime.models.finite_elements.evaluation import NumberedNames


def test_names_are_made_when_they_are_asked_for() -> None:
    names = NumberedNames("balance", 3)
    assert list(names) == ["balance[0]", "balance[1]", "balance[2]"]
    assert names[-1] == "balance[2]"
    assert names[:2] == ["balance[0]", "balance[1]"]
    assert "balance[3]" not in names
    with pytest.raises(IndexError):
        names[3]
