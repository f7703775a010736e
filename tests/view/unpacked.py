"""The data of a page, unpacked as its script does, by other means."""

from __future__ import annotations

import base64
import json
import re
import zlib
from typing import Any

import numpy as np


def data_of(page: str) -> dict[str, Any]:
    """What a page shows: its JSON, with arrays (rows, columns) in it."""
    texts = {
        name: re.search(rf'id="{name}">(.*?)</script>', page, re.S) for name in ("data", "blob")
    }
    assert all(texts.values())
    found = json.loads(texts["data"][1])  # type: ignore[index]
    block = zlib.decompress(base64.b64decode(texts["blob"][1]))  # type: ignore[index]

    def filled(value: Any) -> Any:
        if isinstance(value, list):
            return [filled(x) for x in value]
        if not isinstance(value, dict):
            return value
        if "orders" not in value:
            return {key: filled(x) for key, x in value.items()}
        rows, columns = value["rows"], value["columns"]
        planes = np.frombuffer(block, np.uint8, 4 * rows * columns, value["at"])
        zigzag = planes.reshape(4, -1).T.copy().view("<u4").reshape(rows, columns).astype(np.int64)
        table = np.where(zigzag % 2, -(zigzag + 1) // 2, zigzag // 2)
        for order in reversed(range(value["orders"])):
            # differences begin at the row of their order
            table[order:] = np.cumsum(table[order:], axis=0)
        numbers = (
            table * value["step"] + value.get("first", 0.0) + np.array(value.get("origin", 0.0))
        )
        if "stretch" in value:
            numbers.reshape(rows, -1, 7)[..., 3:] /= value["stretch"]
        return numbers

    unpacked: dict[str, Any] = filled(found)
    return unpacked
