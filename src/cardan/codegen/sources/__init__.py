"""Texts that go into exports as they are: C, Cython and words that stand on their headers."""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).parent


def source(name: str) -> str:
    """Text of a file of this folder."""
    return (FOLDER / name).read_text("utf-8")
