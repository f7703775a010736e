"""A cache that one test has to itself."""

from __future__ import annotations

from pathlib import Path

import pytest

from cardan.build import cache_folder


@pytest.fixture
def cache_directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where it is; empty, and no temporary one beside it."""
    path = tmp_path / "cache"
    monkeypatch.setenv("CARDAN_CACHE", str(path))
    monkeypatch.setattr(cache_folder, "_SCRATCH", {})
    for remembered in (cache_folder._usable, cache_folder._temporary):
        remembered.cache_clear()
    return path
