"""Functions of a model as WebAssembly, compiled by wasmtime where there is no C compiler.

They are written from the saved expressions in the moment they are needed, and called as compiled C
is, by an address, so that kernels run them in loops of C.
"""

from __future__ import annotations

import atexit
import ctypes
import threading
import weakref
from collections.abc import Callable, Mapping
from functools import lru_cache
from importlib import import_module, metadata
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

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
# places are taken and given back by one thread at a time
_PLACES = threading.Lock()
_LASTING: weakref.WeakSet[Any] = weakref.WeakSet()
T = TypeVar("T")


def available() -> bool:
    """Whether wasmtime is installed."""
    return find_spec(NAME) is not None


def version() -> str:
    """Name and version of what compiles."""
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


class _Kernels:
    """A memory with the functions of the kernels."""

    def __init__(self, store: wasmtime.Store, name: str) -> None:
        from wasmtime import Func, Instance, Linker, Memory

        exports = Instance(store, _compiled(name), []).exports(store)
        self.store, self.linker = store, _lasting(Linker(_engine()))
        for one in exports:
            self.linker.define(store, "kernels", one, exports[one])
        initialize, memory = exports["_initialize"], exports["memory"]
        assert isinstance(initialize, Func)
        assert isinstance(memory, Memory)
        initialize(store)
        self.memory = memory

    @property
    def end(self) -> int:
        """First address behind the memory."""
        return self.memory.size(self.store) * PAGE

    def load(self, content: bytes, size: int) -> Mapping[str, object]:
        """Exports of a module, for which so many bytes are added to the memory."""
        from wasmtime import Module

        self.memory.grow(self.store, -(-size // PAGE))
        module = _lasting(Module(_engine(), content))
        exports: Mapping[str, object] = self.linker.instantiate(self.store, module).exports(
            self.store
        )
        return exports


class Machine:
    """A store of wasmtime: its functions run one at a time."""

    def __init__(self) -> None:
        from wasmtime import Store

        self.store = _lasting(Store(_engine()))
        self.lock = ctypes.create_string_buffer(1)
        self._kernels: dict[str, _Kernels] = {}

    def function(
        self,
        translate: Translate,
        function: Function,
        entry: FunctionRow,
        blocks: Mapping[str, int],
    ) -> Compiled:
        """Compile a function.

        Args:
            translate: Writes it.
            function: As it is saved.
            entry: What the manifest says of it.
            blocks: Numbers of each input block.

        Raises:
            BuildError: the function is not what the manifest says, or all places are taken.
        """
        written = translate(function)
        if (written.work_size, written.prepared_size) != (entry.work_size, entry.prepared_size):
            raise BuildError(
                f"{entry.symbol}: what is saved is not what its manifest says. Compile or export "
                "the model again"
            )
        name = written.kernels
        if name not in self._kernels:
            self._kernels[name] = _Kernels(self.store, name)
        memory = self._kernels[name]
        content, end = written.module(base := memory.end)
        counts = {one: blocks.get(one, 0) if one in entry.inputs else 0 for one in ORDER}
        counts |= {"w": entry.prepared_size, "p": blocks.get("p", 0)}
        rooms = {**counts, "out": entry.output_size, "work": entry.work_size}
        # everything lies behind the constants, at even numbers; then the record of the blocks
        at, addresses = end, dict[str, int]()
        for one, count in rooms.items():
            addresses[one] = at
            at += NUMBER * (count + count % 2)
        exports = memory.load(content, at + POINTER * len(ORDER) - base)
        pointers = b"".join(addresses[one].to_bytes(POINTER, "little") for one in ORDER)
        memory.memory.write(self.store, pointers, at)
        fields = {f"at_{one}": addresses[one] for one in ("p", "w", "out", "work")}
        sizes = {"np": counts["p"], "nw": counts["w"], "size": entry.output_size}
        # parameters are read by what prepares alone
        given = [addresses[one] for one in ORDER], [counts[one] * (one != "p") for one in ORDER]
        functions = exports[entry.symbol], exports[f"prepare_{entry.symbol}"]
        start = memory.memory.data_ptr(self.store)
        return Compiled(self, functions, given, {**fields, **sizes, "at_in": at}, start)


class Compiled:
    """A compiled function and what it needs as long as it may be called.

    Attributes:
        address, prepare: Of the functions of C that stand for it.
    """

    def __init__(
        self,
        machine: Machine,
        functions: tuple[object, object],
        given: tuple[list[int], list[int]],
        fields: Mapping[str, int],
        memory: ctypes._Pointer[ctypes.c_ubyte],
    ) -> None:
        from wasmtime import Func

        run, prepare = functions
        assert isinstance(run, Func)
        assert isinstance(prepare, Func)
        at, sizes = (Counts(*numbers) for numbers in given)
        record = Record(
            **fields,
            **_library(),
            store=ctypes.cast(machine.store._context(), ctypes.c_void_p).value,
            memory=ctypes.cast(memory, ctypes.c_void_p).value,
            lock=ctypes.addressof(machine.lock),
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
        self.address, self.prepare = (address.value or 0 for address in addresses)
        needs = machine, run, prepare, at, sizes, record
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
