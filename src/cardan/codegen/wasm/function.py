"""One generated function as a module that works on the memory of the kernels."""

from __future__ import annotations

from ...ir.function import Function
from ...ir.recursion import Recursion
from ...schema.wasm_kernels import WasmFunction
from ..languages import wasm
from ..program.program import KernelCall, Program, Statement
from ..writing import lowered


def translated(function: Function | Recursion) -> WasmFunction:
    """A function, as it is saved, in WebAssembly."""
    program = lowered(function)

    def module(base: int) -> tuple[bytes, int]:
        written = wasm.module(program, base)
        return written.encoded(), written.end

    return WasmFunction(kernels(program), program.work_size, program.prepared_size, module)


def kernels(program: Program) -> str:
    """Name of the module of the kernels that a program calls."""
    statements: list[Statement] = [s for routine in program.routines for s in routine.body]
    return "superelements" if any(isinstance(s, KernelCall) for s in statements) else "functions"
