"""Models of combinations are compiled as ``make test`` compiles: building is most of the time."""

from __future__ import annotations

from collections.abc import Iterator

import pytest


@pytest.fixture(scope="package", autouse=True)
def plainly_compiled() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CARDAN_OPTIMIZATION", "0")
        yield
