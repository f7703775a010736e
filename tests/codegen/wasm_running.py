"""Runs generated WebAssembly in wasmtime, for tests; shares nothing with the runtime."""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np
import pytest

from cardan.codegen.languages import wasm
from cardan.codegen.program.program import Program
from cardan.schema import wasm_kernels
from codegen.running import ORDER, Answer, guarded

wasmtime = pytest.importorskip("wasmtime", reason="wasmtime is not installed")
PAGE = 65536


@cache
def engine() -> Any:
    return wasmtime.Engine()


@cache
def kernels(name: str) -> Any:
    return wasmtime.Module(engine(), wasm_kernels.content(name))


class Machine:
    """The kernels, and memory behind theirs."""

    def __init__(self, name: str = "functions") -> None:
        self.store = wasmtime.Store(engine())
        self.exports = wasmtime.Instance(self.store, kernels(name), []).exports(self.store)
        self.exports["_initialize"](self.store)
        self.memory = self.exports["memory"]
        self.end = self.memory.size(self.store) * PAGE

    def load(self, content: bytes, room: int = 16) -> Any:
        self.memory.grow(self.store, room)
        linker = wasmtime.Linker(engine())
        for name in self.exports:
            linker.define(self.store, "kernels", name, self.exports[name])
        module = wasmtime.Module(engine(), content)
        return linker.instantiate(self.store, module).exports(self.store)

    def put(self, content: bytes) -> int:
        at, self.end = self.end, self.end + len(content) + -len(content) % 16
        assert self.end <= self.memory.size(self.store) * PAGE
        self.memory.write(self.store, content, at)
        return at

    def read(self, at: int, count: int) -> np.ndarray:
        return np.frombuffer(bytes(self.memory.read(self.store, at, at + 8 * count)))


def call_wasm(
    program: Program,
    values: Mapping[str, Sequence[float]],
    output_size: int,
    kernels: str = "functions",
) -> Answer:
    """Prepare and call a function; arrays have guard values behind them, as in C."""
    machine = Machine(kernels)
    module = wasm.module(program, machine.end)
    functions = machine.load(module.encoded(), room=16 + module.end // PAGE - machine.end // PAGE)
    machine.end = module.end
    sizes = program.prepared_size, output_size, program.work_size
    w, out, work = (machine.put(guarded(size).tobytes()) for size in sizes)
    p = machine.put(np.array([*values.get("p", ()), 0.0], dtype=float).tobytes())
    functions[f"prepare_{program.name}"](machine.store, p, w)
    given = {n: machine.put(np.array(values[n], dtype=float).tobytes()) for n in program.blocks
             if n != "p"}  # fmt: skip
    pointers = {**given, "w": w}
    blocks = machine.put(struct.pack(f"<{len(ORDER)}i", *(pointers.get(n, 0) for n in ORDER)))
    status = functions[program.name](machine.store, blocks, out, work)
    found = [machine.read(at, size + 4) for at, size in zip((w, out, work), sizes, strict=True)]
    for array in found:
        assert (array[-4:] == 12345.0).all(), "something was written behind an array"
    return Answer(status, found[1][:-4], found[0][:-4])
