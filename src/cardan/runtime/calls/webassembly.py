"""Functions of a model as WebAssembly, compiled by wasmtime where there is no C compiler.

They are written from the saved expressions in the moment they are needed, and called as compiled C
is, by an address, so that kernels run them in loops of C. Each has a memory of its own.
"""

from __future__ import annotations

import atexit
import ctypes
import threading
import weakref
from collections.abc import Callable, Mapping
from functools import lru_cache
from importlib import import_module
from importlib.util import find_spec
from math import ceil
from typing import TYPE_CHECKING, TypeAlias, TypeVar

from ...errors import BuildError
from ...schema import wasm_kernels
from ...schema.blocks import ORDER
from ...schema.c_functions import FunctionRow
from ...schema.records import WasmFunction as Record
from ...schema.wasm_kernels import WasmFunction
from ..build import kernels

if TYPE_CHECKING:
    import wasmtime

    from ...ir.function import Function

NAME = "wasmtime"
PAGE, NUMBER, POINTER = 65536, 8, 4
# writes a function
Translate: TypeAlias = "Callable[[Function], WasmFunction]"
Counts = ctypes.c_ssize_t * len(ORDER)
# places are taken and places back by one thread at a time
_PLACES = threading.Lock()
_LASTING: weakref.WeakSet[object] = weakref.WeakSet()
T = TypeVar("T")


def available() -> bool:
    """True if wasmtime is installed."""
    return find_spec(NAME) is not None


def version() -> str:
    """Name and version of what compiles."""
    from importlib import metadata

    return f"{NAME} {metadata.version(NAME)}"


def _lasting(thing: T) -> T:
    """An object of wasmtime that is never deleted when Python ends: its library may be gone."""
    _LASTING.add(thing)
    return thing


@atexit.register
def _leave() -> None:
    for thing in _LASTING:
        ctypes.pythonapi.Py_IncRef(ctypes.py_object(thing))


@lru_cache(maxsize=1)
def _engine() -> wasmtime.Engine:
    from wasmtime import Engine

    return _lasting(Engine())


@lru_cache(maxsize=4)
def _compiled(name: str) -> wasmtime.Module:
    """A module of the kernels."""
    from wasmtime import Module

    return _lasting(Module(_engine(), wasm_kernels.content(name)))


def compiled(
    translate: Translate, function: Function, entry: FunctionRow, blocks: Mapping[str, int]
) -> Compiled:
    """Compile a function, in a store and a memory of its own.

    Nothing of them changes afterward: other threads may be inside functions that were compiled
    before, and addresses in the memory stay where they are.

    Args:
        translate: Writes it.
        function: As it is saved.
        entry: What the manifest says of it.
        blocks: Numbers of each input block.

    Raises:
        BuildError: all places are taken.
    """
    from wasmtime import Func, Instance, Linker, Memory, Module, Store

    written = translate(function)
    store = _lasting(Store(_engine()))
    kernel_exports = Instance(store, _compiled(written.kernels), []).exports(store)
    linker = _lasting(Linker(_engine()))
    for name in kernel_exports:
        linker.define(store, "kernels", name, kernel_exports[name])
    initialize, memory = kernel_exports["_initialize"], kernel_exports["memory"]
    assert isinstance(initialize, Func)
    assert isinstance(memory, Memory)
    initialize(store)

    # behind the memory of the kernels come the constants, then everything else at even numbers, and
    # the record of the blocks
    base = memory.size(store) * PAGE
    content, at = written.module(base)
    counts = {one: blocks.get(one, 0) if one in entry.inputs else 0 for one in ORDER}
    counts |= {"w": written.prepared_size, "p": blocks.get("p", 0)}
    addresses: dict[str, int] = {}
    for one, count in {**counts, "out": entry.output_size, "work": written.work_size}.items():
        addresses[one] = at
        at += NUMBER * (count + count % 2)
    end = at + POINTER * len(ORDER)
    memory.grow(store, ceil((end - base) / PAGE))
    module = _lasting(Module(_engine(), content))
    exports = linker.instantiate(store, module).exports(store)
    pointers = b"".join(addresses[one].to_bytes(POINTER, "little") for one in ORDER)
    memory.write(store, pointers, at)

    fields = {f"at_{one}": addresses[one] for one in ("p", "w", "out", "work")}
    sizes = {"np": counts["p"], "nw": counts["w"], "size": entry.output_size}
    # parameters are read by what prepares alone
    places = [addresses[one] for one in ORDER], [counts[one] * (one != "p") for one in ORDER]
    functions = exports[entry.symbol], exports[f"prepare_{entry.symbol}"]
    start = memory.data_ptr(store)
    return Compiled(store, functions, places, {**fields, **sizes, "at_in": at}, start)


class Compiled:
    """A compiled function and what it needs as long as it may be called.

    Attributes:
        address, prepare: Of the functions of C that stand for it.
        work_size, prepared_size: Lengths of work and w.
    """

    def __init__(
        self,
        store: wasmtime.Store,
        functions: tuple[object, object],
        places: tuple[list[int], list[int]],
        fields: Mapping[str, int],
        memory: ctypes._Pointer[ctypes.c_ubyte],
    ) -> None:
        from wasmtime import Func

        run, prepare = functions
        lock = ctypes.create_string_buffer(1)
        assert isinstance(run, Func)
        assert isinstance(prepare, Func)
        at, sizes = (Counts(*numbers) for numbers in places)
        record = Record(
            **fields,
            **_library(),
            store=ctypes.cast(store._context(), ctypes.c_void_p).value,
            memory=ctypes.cast(memory, ctypes.c_void_p).value,
            lock=ctypes.addressof(lock),
            run=ctypes.addressof(run._func),
            prepare=ctypes.addressof(prepare._func),
            at=ctypes.addressof(at),
            sizes=ctypes.addressof(sizes),
        )
        library = kernels.library()
        addresses = ctypes.c_void_p(), ctypes.c_void_p()
        with _PLACES:
            place = library.cardan_wasm_take(ctypes.byref(record), *map(ctypes.byref, addresses))
        if place < 0:
            raise BuildError(
                "no place is free for another function of WebAssembly: let go of models that are "
                "no longer used, or install a C compiler: pip install 'cardan[compiler]'"
            )
        self.work_size, self.prepared_size = 0, fields["nw"]
        self.address, self.prepare = (address.value or 0 for address in addresses)
        needs = store, lock, run, prepare, at, sizes, record
        weakref.finalize(self, _give_back, library, place, needs).atexit = False


def _give_back(library: ctypes.CDLL, place: int, _needs: object) -> None:
    """Nobody calls it any more: its place may be taken, then what it needs may go."""
    with _PLACES:
        library.cardan_wasm_give_back(place)


@lru_cache(maxsize=1)
def _library() -> dict[str, int | None]:
    """Addresses of the functions of wasmtime that C calls, by the names of their fields."""
    library = import_module(f"{NAME}._ffi").dll
    names = {
        "call": "wasmtime_func_call_unchecked",
        "delete_error": "wasmtime_error_delete",
        "delete_trap": "wasm_trap_delete",
    }
    return {
        field: ctypes.cast(library[name], ctypes.c_void_p).value for field, name in names.items()
    }
