"""The functions of a model whose elements stand in tables: summed over these, or solved for."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from math import prod
from typing import TYPE_CHECKING, final

import numpy as np
from numpy.lib.stride_tricks import as_strided

from ....arrays import Array
from ....errors import ModelError
from ....schema.blocks import ORDER
from ....schema.c_functions import FunctionRow, ResultRow
from ....schema.finite_elements import EXPRESSION
from ....schema.functions import FUNCTIONS, OF_ELEMENTS
from ...calls import abi
from ...calls.calling import Caller
from ...calls.code import Code
from ...calls.generated import Source
from ...calls.loaded_function import LoadedFunction, entry_names
from ...calls.objects import Key
from .evaluation import Inputs, Results
from .mesh import NEEDED
from .products import Products
from .table_loading import load

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel

# what C answers alone, with the interface of generated functions
IN_C = ("rhs", "qdot", "energy", "power", "momentum", "outputs", "events", "transition")


@final
class Assembled(Source):
    """Functions over the tables of a model at its parameters."""

    def __init__(self) -> None:
        self._results: Results | None = None
        self._products: Products | None = None

    def results(self, model: LoadedModel) -> Results:
        """Evaluator of the functions;

        made on first use, once for all threads: runs keep its address.
        """
        with model._objects.lock:
            if self._results is None:
                self._results = Results(load(model), model)
            return self._results

    def add(self, model: LoadedModel, missing: Sequence[Key]) -> None:
        """Make functions callable."""
        for name, of in missing:
            if FUNCTIONS[name].of == "function" or name == EXPRESSION:
                model._functions[name, of] = self._product(model, name, of or "")
                continue
            if name not in OF_ELEMENTS:
                available = ", ".join(OF_ELEMENTS)
                raise ModelError(
                    f"model '{model.name}' is in absolute coordinates, which offer no '{name}'. "
                    f"There are: {available}"
                )
            model._functions[name, of] = self._function(model, name, of)

    def mesh(self, model: LoadedModel) -> int:
        """Address of the tables, with what methods ask of elements themselves."""
        mesh = self.results(model).mesh
        mesh.connect("balance", "balance_tangent", "gamma")
        return ctypes.addressof(mesh.record)

    def codes(self, model: LoadedModel) -> list[Code]:
        """Those of all kinds of elements and places, by their C names."""
        mesh = self.results(model).mesh
        mesh.connect(*NEEDED["rhs"])
        groups, places = mesh.tables.groups, mesh.tables.kinds
        symbols = {g.kind.functions.get(name) for g in groups for name in NEEDED["rhs"]}
        symbols |= {symbol for kind in places for symbol in kind.functions.values()}
        return model._objects.load(sorted(symbol for symbol in symbols if symbol))

    def _function(self, model: LoadedModel, name: str, of: str | None) -> LoadedFunction:
        model._check_of(name, of)
        results, arguments = self.results(model), model._layout.reads(name, of)
        shape, entries = results.shape(name)
        code = self._code(results, name, entries, shape)
        address = code.address
        w = _address_of(results.mesh.record)
        at_once = results.tables.sizes if results.at_once(name, of) else None
        label, one = f"{name}('{of}')" if of else name, _Evaluator(results.of(name, of), at_once)
        work, interpreted = code.entry.work_size, results.mesh.interpreted
        caller = Caller(label, address, arguments, shape, entries, work, w, work, evaluator=one)  # type: ignore[arg-type]
        if name not in IN_C or interpreted:
            return LoadedFunction(name, of, code, w, caller, caller, interpreted)
        one.compiled = partial(abi.run, address, work_size=work)
        return LoadedFunction(name, of, code, w, caller, abi.fast(caller))

    def _product(self, model: LoadedModel, name: str, of: str) -> LoadedFunction:
        """A derivative, a product with one, or an expression."""
        results = self.results(model)
        if self._products is None:
            self._products = Products(results, model)
        product = self._products.product(name, of)
        row, arguments = product.row, model._layout.reads(name, of, product.row.vector)
        shape = tuple(row.outputs[0].shape) if len(row.outputs) == 1 else (row.output_size,)
        code = Code(name, row, False, product.address)
        one = _Evaluator(self._products.evaluator(product, of))
        entries = entry_names(row.outputs)
        w = _address_of(product.record)
        label = f"{name}('{of}')"
        caller = Caller(label, code.address, arguments, shape, entries, 0, w, evaluator=one)  # type: ignore[arg-type]
        return LoadedFunction(name, of, code, w, caller, caller, results.mesh.interpreted)

    def _code(
        self, results: Results, name: str, entries: Sequence[str], shape: tuple[int, ...]
    ) -> Code:
        mesh, address, work = results.mesh, 0, 0
        # runs call these from C: closures over the mesh
        if name in NEEDED:
            address, work = mesh.closure(name), mesh.work
        row = ResultRow(name=name, shape=list(shape), entries=entries)
        entry = FunctionRow(
            file="",
            symbol=name,
            work_size=work,
            prepared_size=0,
            output_size=prod(shape),
            outputs=[row],
            operations={},
            inputs=[],
            lanes=[1],
            sha256="",
        )
        return Code(name, entry, False, address)


def _address_of(record: ctypes.Structure) -> Array:
    """A record in place of prepared parameters: runs hand its address on as these."""
    count = ctypes.sizeof(record) // 8
    return np.ctypeslib.as_array((ctypes.c_double * count).from_buffer(record))


class _Evaluator:
    """A function of states, called as generated C is; see :class:`.Interpreted`."""

    def __init__(
        self, function: Callable[[Inputs], Array], sizes: Mapping[str, int] | None = None
    ) -> None:
        """Args:
        function: Of blocks.
        sizes: Of these, if it takes many states at once: it needs to know where each ends.

        The attribute ``compiled`` is the loop over states in C, where it gives the same.
        """
        self.function, self.sizes = function, sizes
        self.compiled: Callable[..., tuple[int, int]] | None = None

    def run(
        self, blocks: list[Array | None], strides: Sequence[int], out: Array
    ) -> tuple[int, int]:
        """The results of every row of ``out``."""
        if self.compiled is not None:
            answer = self.compiled(blocks=blocks, strides=strides, count=len(out), out=out)
            # what failed is asked once more, for what there is to say of it
            if not answer[0]:
                return answer
        present = [
            (n, b, d) for n, b, d in zip(ORDER, blocks, strides, strict=True) if b is not None
        ]
        if self.sizes is not None:
            rows = {
                name: as_strided(block, (len(out), self.sizes[name]), (8 * stride, 8))
                for name, block, stride in present
                if name in self.sizes
            }
            out[:] = np.reshape(self.function(rows), (len(out), -1))
            return 0, -1
        for k in range(len(out)):
            here = {name: block[k * stride :] for name, block, stride in present}
            out[k] = np.reshape(self.function(here), -1)
        return 0, -1
