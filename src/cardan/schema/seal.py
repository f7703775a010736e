"""A manifest with a hash of itself: what a disk has damaged is noticed before anything uses it.

The hash is that of the text in which 64 zeros stand in its place. It finds damage, not malice:
whoever changes a manifest on purpose can make it anew.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from typing import Any

from .fields import Record, dumped

KEY = "digest"
ZEROS = b"0" * 64
SEAL = re.compile(rb'"digest":\s*"([0-9a-f]{64})"')
# the key comes first
HEAD = 200


def sealed(data: Mapping[str, object], **options: object) -> str:
    """The JSON text of data with its hash as the first entry."""
    # lists of rows are made plain at once, which takes less time than row by row
    plain = {name: _plain_rows(x) if type(x) is list else x for name, x in data.items()}
    text = dumped({KEY: ZEROS.decode(), **plain}, **options) + "\n"
    digest = hashlib.sha256(text.encode()).hexdigest()
    return text.replace(ZEROS.decode(), digest, 1)


def _plain_rows(rows: list[object]) -> list[object]:
    return [vars(row) if isinstance(row, Record) else row for row in rows]


def is_sealed(content: bytes) -> bool:
    """True for a text with a hash, whatever it is of."""
    return SEAL.search(content, 0, HEAD) is not None


def unsealed(content: bytes, by_hand: bool = True) -> Any:
    """The data of a text, without its hash.

    Args:
        content: Of a file.
        by_hand: Without a hash, it counts as one that was written by hand, else as damaged.

    Raises:
        ValueError: it is not JSON, or not what its hash is of.
    """
    seal = SEAL.search(content, 0, HEAD)
    if not seal and not by_hand:
        raise ValueError("it has no hash")
    if seal:
        blank = content[: seal.start(1)] + ZEROS + content[seal.end(1) :]
        if hashlib.sha256(blank).hexdigest().encode() != seal[1]:
            raise ValueError("its hash is that of another content")
    try:
        data = json.loads(content)
    except RecursionError as error:
        raise ValueError(f"it is damaged: {error}") from error
    if isinstance(data, dict):
        data.pop(KEY, None)
    return data
