"""Functions of a model as WebAssembly, compiled by wasmtime where there is no C compiler.

They are written from the saved expressions in the moment they are wanted, and called as compiled C
is, by an address, so that kernels run them in loops of C.
"""

from __future__ import annotations

import atexit
import ctypes
import threading
import weakref
from collections.abc import Mapping
from functools import lru_cache
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from ...codegen.languages import wasm
from ...codegen.program.program import Program
from ...codegen.wasm import prebuilt
from ...errors import BuildError
from ...schema.blocks import ORDER
from ...schema.c_functions import FunctionRow
from ...schema.records import WasmFunction
from ..build import kernels

NAME = "wasmtime"
PAGE, NUMBER, POINTER = 65536, 8, 4
# places are taken and given back by one thread at a time
_PLACES = threading.Lock()
_LASTING: weakref.WeakSet[Any] = weakref.WeakSet()
Counts = ctypes.c_ssize_t * len(ORDER)


def available() -> bool:
    """Whether wasmtime is installed."""
    return find_spec(NAME) is not None


@lru_cache(maxsize=1)
def _wasmtime() -> Any:
    return import_module(NAME)


@lru_cache(maxsize=1)
def version() -> str:
    """Name and version of what compiles."""
    from importlib.metadata import version

    return f"{NAME} {version(NAME)}"


def _lasting(thing: Any) -> Any:
    """An object of wasmtime that is never deleted when Python ends: its library may be gone."""
    _LASTING.add(thing)
    return thing


@atexit.register
def _keep() -> None:
    for thing in _LASTING:
        ctypes.pythonapi.Py_IncRef(ctypes.py_object(thing))


@lru_cache(maxsize=1)
def _engine() -> Any:
    return _lasting(_wasmtime().Engine())


@lru_cache(maxsize=4)
def _kernels(name: str) -> Any:
    """A compiled module of the kernels."""
    return _lasting(_wasmtime().Module(_engine(), prebuilt.content(name)))


class Machine:
    """A memory with functions that work on it, one at a time."""

    def __init__(self) -> None:
        self._store = _lasting(_wasmtime().Store(_engine()))
        self._linker: dict[str, Any] = {}
        self._lock = ctypes.create_string_buffer(1)
        self._memory: Any = None

    def function(self, program: Program, entry: FunctionRow, blocks: Mapping[str, int]) -> Compiled:
        """Compile a function.

        Args:
            program: The function.
            entry: What the manifest says of it.
            blocks: Numbers of each input block.

        Raises:
            BuildError: the program is not what the manifest says, or all places are taken.
        """
        sizes = program.work_size, program.prepared_size
        if sizes != (entry.work_size, entry.prepared_size):
            raise BuildError(
                f"{entry.symbol}: what is saved is not what its manifest says. Compile or export "
                "the model again"
            )
        linker = self._linked("functions")
        counts = [blocks.get(name, 0) if name in entry.inputs else 0 for name in ORDER]
        counts[ORDER.index("w")], counts[ORDER.index("p")] = entry.prepared_size, 0
        # where everything lies behind the constants; pages are whole
        module = wasm.module(program, base := self._memory.size(self._store) * PAGE)
        at = module.end
        addresses = []
        for count in (*counts, blocks.get("p", 0), entry.output_size, entry.work_size):
            addresses.append(at)
            at += NUMBER * (count + count % 2)
        self._memory.grow(self._store, -(-(at + POINTER * len(ORDER) - base) // PAGE))
        pointers = b"".join(x.to_bytes(POINTER, "little") for x in addresses[: len(ORDER)])
        self._memory.write(self._store, pointers, at)
        compiled = _lasting(_wasmtime().Module(_engine(), module.encoded()))
        instance = linker.instantiate(self._store, compiled).exports(self._store)
        library = _wasmtime_library()
        return Compiled(
            self,
            (instance[entry.symbol], instance[f"prepare_{entry.symbol}"]),
            (Counts(*addresses[: len(ORDER)]), Counts(*counts)),
            {
                **library,
                "store": ctypes.cast(self._store._context(), ctypes.c_void_p).value,
                "memory": ctypes.cast(self._memory.data_ptr(self._store), ctypes.c_void_p).value,
                "lock": ctypes.addressof(self._lock),
                "at_in": at,
                "at_p": addresses[-3],
                "at_out": addresses[-2],
                "at_work": addresses[-1],
                "at_w": addresses[ORDER.index("w")],
                "np": blocks.get("p", 0),
                "nw": entry.prepared_size,
                "size": entry.output_size,
            },
        )

    def _linked(self, name: str) -> Any:
        """What gives modules the memory and the functions of a module of the kernels."""
        if name not in self._linker:
            linker = _lasting(_wasmtime().Linker(_engine()))
            exports = _wasmtime().Instance(self._store, _kernels(name), []).exports(self._store)
            exports["_initialize"](self._store)
            for one in exports:
                linker.define(self._store, "kernels", one, exports[one])
            self._linker[name], self._memory = linker, exports["memory"]
        return self._linker[name]


class Compiled:
    """A compiled function and what it needs as long as it may be called.

    Attributes:
        address, prepare: Of the functions of C that stand for it.
    """

    def __init__(
        self, machine: Machine, functions: tuple[Any, Any], counts: tuple[Any, Any], fields: Any
    ) -> None:
        library = kernels.library()
        run, prepare = (function._func for function in functions)
        self._record = WasmFunction(
            **fields,
            run=ctypes.addressof(run),
            prepare=ctypes.addressof(prepare),
            at=ctypes.addressof(counts[0]),
            sizes=ctypes.addressof(counts[1]),
        )
        addresses = ctypes.c_void_p(), ctypes.c_void_p()
        with _PLACES:
            place = library.cardan_wasm_take(
                ctypes.byref(self._record), *map(ctypes.byref, addresses)
            )
        if place < 0:
            raise BuildError(
                "no place is free for another function of WebAssembly: let go of models that are "
                "no longer used, or install a C compiler: pip install 'cardan[compiler]'"
            )
        self.address, self.prepare = (address.value or 0 for address in addresses)
        self._needs = machine, functions, counts, run, prepare
        end = weakref.finalize(self, _give_back, library, place, self._record, self._needs)
        end.atexit = False


def _give_back(library: ctypes.CDLL, place: int, *_needs: object) -> None:
    """Nobody calls it any more: its place may be taken, then what it needs may go."""
    with _PLACES:
        library.cardan_wasm_give_back(place)


@lru_cache(maxsize=1)
def _wasmtime_library() -> dict[str, int | None]:
    """Addresses of functions of wasmtime that C calls."""
    library = import_module(f"{NAME}._ffi").dll
    names = {
        "call": "wasmtime_func_call_unchecked",
        "delete_error": "wasmtime_error_delete",
        "delete_trap": "wasm_trap_delete",
    }
    return {
        field: ctypes.cast(library[name], ctypes.c_void_p).value for field, name in names.items()
    }
