"""Functions of elements in C, for many elements at once."""

from __future__ import annotations

import ctypes
import tempfile
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cardan.build import cache
from cardan.codegen import generate
from cardan.ir.function import Function
from cardan.runtime.calls import abi_ctypes
from cardan.schema import kernel_files
from cardan.schema.blocks import ORDER

Array = NDArray[np.float64]


class Compiled:
    """A function of an element.

    Attributes:
        function: What is compiled.
    """

    def __init__(self, function: Function) -> None:
        made = generate(function)
        with tempfile.TemporaryDirectory(prefix="cardan-element-") as folder:
            text = Path(folder) / f"{made.name}.c"
            text.write_text(made.text, encoding="utf-8")
            self._library = cache.build([text], kernel_files.includes(), False).load()
        self.function, self._entry = function, made.entry
        names = (function.name, f"prepare_{function.name}")
        found = [ctypes.cast(self._library[name], ctypes.c_void_p).value or 0 for name in names]
        self._address, self._prepare = found

    def __call__(self, p: Array, **blocks: Array) -> dict[str, Any]:
        """Results by name, (n, ...), of blocks (n, size)."""
        n = len(p)
        given = {name: np.ascontiguousarray(x, dtype=float) for name, x in blocks.items()}
        given["w"] = np.empty((n, self._entry["prepared_size"]))
        abi_ctypes.prepare(self._prepare, np.ascontiguousarray(p), given["w"])
        arrays = [given.get(letter) for letter in ORDER]
        strides = [0 if x is None else x.shape[1] for x in arrays]
        out = np.empty((n, self._entry["output_size"]))
        work = self._entry["work_size"]
        status, _ = abi_ctypes.run(self._address, arrays, strides, n, out, work)
        assert status == 0
        found: dict[str, Any] = {}
        start = 0
        for output in self.function.outputs:
            part = out[:, start : start + output.size]
            found[output.name] = part.reshape(n, *output.shape)
            start += output.size
        return found


@lru_cache(maxsize=64)
def compiled(function: Function) -> Compiled:
    """The function in C, once."""
    return Compiled(function)
