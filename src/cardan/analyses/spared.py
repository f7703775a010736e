"""Derivatives that large models are not asked for: implicit methods take differences there."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from ..runtime.compiled import CompiledModel
from .settings import Settings

LARGE = 1600  # pairs of speeds, as in a chain of 40: more are derived for minutes


def pairs(manifest: dict[str, Any]) -> int:
    """Pairs of speeds of which one moves what the other moves: entries of M that are not 0."""
    rows = [row for row in manifest["joints"] if row["u"] is not None]
    size = {row["child"]: row["u"][1] for row in rows}
    parent = {row["child"]: row["parent"] for row in manifest["joints"]}
    count = 0
    for body, own in size.items():
        count += own * own
        above, seen = parent.get(body), {body}
        while above is not None and above not in seen:
            seen.add(above)
            count += 2 * own * size.get(above, 0)
            above = parent.get(above)
    return count


def spared(model: CompiledModel, how: Settings) -> Settings:
    """Settings of a method that differences what a large model would derive for minutes."""
    found = [name for name in how.method.differenced if name in how.method.needs]
    if not found or pairs(model.manifest) <= LARGE:
        return how
    needs = tuple(name for name in how.method.needs if name not in found)
    words = f"{how.words}, {' and '.join(found)} by differences as the model is large"
    return replace(how, method=replace(how.method, needs=needs), words=words)
