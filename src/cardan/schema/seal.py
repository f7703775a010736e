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

from .fields import dumped

KEY = "digest"
ZEROS = b"0" * 64
SEAL = re.compile(rb'"digest":\s*"([0-9a-f]{64})"')
# the key comes first
HEAD = 200


def sealed(data: Mapping[str, object], **options: object) -> str:
    """The JSON text of data with its hash as the first entry."""
    text = dumped({KEY: ZEROS.decode(), **data}, **options) + "\n"
    digest = hashlib.sha256(text.encode()).hexdigest()
    return text.replace(ZEROS.decode(), digest, 1)


def unsealed(content: bytes) -> Any:
    """The data of a text, without its hash; one that was written by hand may have none.

    Raises:
        ValueError: it is not JSON, or not what its hash is of.
    """
    seal = SEAL.search(content, 0, HEAD)
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
