"""A compiled model as data and calls: its functions on arrays, as fast C."""

from __future__ import annotations

import ctypes
from abc import abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Seed, checked, kinds_of, read
from ...arrays import Array
from ...errors import ArgumentError, ModelError, brief, counted, near
from ...processes import collector_paused
from ...schema.functions import FUNCTIONS, STANDARD
from ..build import kernels
from ..calls.argument_values import by_name, numbers
from ..calls.evaluation import Values
from ..calls.generated import Generated, Source
from ..calls.layout import Layout
from ..calls.loaded_function import LoadedFunction
from ..calls.objects import Key, Objects, Provide
from ..calls.parameters import Parameters
from ..calls.webassembly import Translate
from .description import Description
from .random_states import random_state

if TYPE_CHECKING:
    from .finite_elements.elements import Elements

# of numbers in batches
DTYPES = ("float64", "float32")


class _Calls(dict[Key, Any]):
    """The quick way into every function; filled on first use."""

    def __init__(self, load: Callable[[str, str | None], LoadedFunction]) -> None:
        self.load = load

    def __missing__(self, key: Key) -> Any:
        self[key] = fast = self.load(*key).fast
        return fast


class LoadedModel(Description):
    """A compiled model and its calls: files, parameters, functions.

    Rooms below ``api`` pass this around; ``api.CompiledModel`` adds their analyses for users.
    """

    # writes functions as WebAssembly, where that is at hand
    _translate: ClassVar[Translate | None] = None

    @checked
    def __init__(
        self,
        directory: str | Path,
        provide: Provide | None = None,
        *,
        reproducible: bool = False,
        threads: int | None = None,
        available: Sequence[str] | None = None,
        dtype: str = "float64",
    ) -> None:
        """Open a model directory.

        Args:
            directory: With ``manifest.json`` and the C files.
            provide: Of (function, of) pairs; writes what is missing there, gives their C names.
            reproducible: Equal bits from every compiler, 10-30 % slower.
            threads: That share a large batch; by default ``$CARDAN_THREADS``, else the cores that
                this process may use.
            available: Names of the functions that ``provide`` writes; by default those that the
                manifest lists.
            dtype: ``"float32"``: batches of arrays of float32 are computed so, in twice as many
                lanes; all else stays in doubles.

        Raises:
            ModelError: no readable manifest, no such type, or elements in single precision.
        """
        if dtype not in DTYPES:
            raise ModelError(f"dtype '{dtype}' does not exist.{near(dtype, DTYPES)}")
        self._objects = Objects(
            Path(directory), provide, reproducible, threads, available, type(self)._translate, dtype
        )
        if dtype != "float64" and self.manifest.absolute:
            raise ModelError(
                f"model '{self.name}', dtype='{dtype}': equations in absolute coordinates need "
                "doubles. coordinates='relative' has batches in single precision"
            )
        self._set(Parameters(self._objects.manifest))

    def _set(self, parameters: Parameters, layout: Layout | None = None) -> None:
        self._layout = layout or Layout(self._objects.manifest)
        self._parameters = parameters
        self._functions: dict[Key, LoadedFunction] = {}
        # of the mechanism with these parameters, once it is known
        self._size: float | None = None
        # what has been found out about it, by what it is
        self._derived = {}
        self._calls = _Calls(self._function)
        self._source = self._source_of()

    def _source_of(self) -> Source:
        """Source of the functions: elements in tables, or C of their own."""
        if not self.manifest.absolute:
            return Generated()
        from .finite_elements.assembled import Assembled

        return Assembled()

    def __repr__(self) -> str:
        return (
            f"{type(self).__name__}('{self.name}', {self.manifest.method}: "
            f"{counted(len(self.bodies), 'body', 'bodies')}, "
            f"{counted(self.nq, 'coordinate')}, {counted(self.nu, 'speed')}, "
            f"{counted(len(self.parameters), 'parameter')})"
        )

    @checked
    def with_parameters(self, values: Values | None = None, **named: ArrayLike) -> Self:
        """The same model with other parameter values; nothing is compiled again.

        Args:
            values: Dotted name -> value, ``{"upper.mass": 2.0}``.
            named: The same for plain names, ``m=2.0``.

        Raises:
            ModelError: unknown or structural parameter.
        """
        vector = self._parameters.changed({**(values or {}), **named})
        if vector.ndim != 1:
            raise ArgumentError(
                "with_parameters takes one number per name; a batch of parameter sets goes into "
                "parameters= of a function"
            )
        return self._with(Parameters(self.manifest, vector))

    def _with(self, parameters: Parameters) -> Self:
        """This model over the same loaded code with other values."""
        other = object.__new__(type(self))
        other._objects = self._objects
        other._set(parameters, self._layout)
        return other

    # loading

    def _function(self, name: str, of: str | None = None) -> LoadedFunction:
        """A function, compiled and loaded if it was not yet."""
        return self._load([(name, of)])[0]

    @collector_paused()
    def _load(self, keys: Iterable[Key]) -> list[LoadedFunction]:
        """Several functions; those that must be compiled are compiled side by side.

        Nobody gets a function, and no other process finds its object, before it is checked.
        """
        requested = list(keys)
        with self._objects.lock:
            missing = [key for key in dict.fromkeys(requested) if key not in self._functions]
            for name, of in missing:
                self._check_of(name, of)
            if missing:
                self._source.add(self, missing)
            return [self._functions[key] for key in requested]

    def prepare(self, *functions: str | Key, batch: bool = False) -> None:
        """Compile functions before they are needed, several at once.

        Args:
            functions: Such as ``"rhs"`` or ``("pose", "hand")``; all that were written if empty.
            batch: Also for many states side by side, which else happens when it pays.
        """
        batch = read("prepare", "batch", batch, kinds_of("bool"))
        for f in functions:
            if not isinstance(f, str | tuple):
                raise ArgumentError(f"prepare({brief(f)}): give names, or ('pose', 'hand')")
        keys = [(f, None) if isinstance(f, str) else f for f in functions]
        if not functions:
            keys = self._written()
        loaded = self._load(keys)
        if batch:
            from ..calls.samples import build

            for function in loaded:
                build(self, function)

    @checked
    def lanes(self, function: str, of: str | None = None) -> int:
        """States that batches of a function do side by side; 1 until that pays, or without vectors.

        Args:
            function, of: Such as ``"rhs"``, or ``"pose", "hand"``; of a model with
                ``dtype="float32"`` the lanes of floats.
        """
        caller = self._function(function, of).caller
        return (caller.single or caller.batch).lanes

    def _written(self) -> list[Key]:
        """Keys of the functions of this model whose C is in the directory."""
        rows = self.manifest.functions.items()
        keys = [(name.split("__")[0], entry.of) for name, entry in rows]
        # other models of the same equations write there too
        chosen = self._objects.available
        return [k for k in keys if k[0] in STANDARD and (chosen is None or k[0] in chosen)]

    @property
    def saved(self) -> tuple[str, ...]:
        """Names of the functions whose expressions are stored beside the C."""
        return tuple(self._objects.saved())

    def _evaluate_saved(self, name: str, *only: str, **values: object) -> Any:
        """Results of a saved Function in Python; see :func:`cardan.ir.interpreter.evaluate`.

        Args:
            name: C name of the function.
            only: Names of results; all if left out.
            values: Blocks as lists of floats, or as arrays (..., n).
        """
        from ...ir.interpreter import evaluate
        from ...ir.recursion import Recursion
        from ...ir.straight_line import repeated
        from ...ir.visits import repeated_recursion

        form = self._objects.form(name)
        try:
            lists = {name: value for name, value in values.items() if isinstance(value, list)}
            if isinstance(form, Recursion):
                visits = repeated_recursion(form)
                results = visits(lists) if len(lists) == len(values) else visits.over(values)
                return {key: results[key] for key in only} if only else results
            function = self._objects.function(name)
            if len(lists) == len(values):
                return repeated(function, *only)(lists)
            return evaluate(function, values, "numpy")
        except ValueError as error:
            raise ModelError(
                f"{self._objects.directory}: what manifest.json and functions.json say differs: "
                f"{error}. Compile the model again"
            ) from error

    def _kernels(self) -> ctypes.CDLL:
        """The library of integrators and loops."""
        return kernels.library(self._objects.reproducible)

    def _evaluate(
        self, key: Key, values: tuple[object, ...], parameters: Values | None, out: Array | None
    ) -> Array:
        of = key[1]
        if of is not None and not isinstance(of, str):
            kind = FUNCTIONS[key[0]].of
            raise ArgumentError(f"{key[0]}: {kind}={brief(of)}: give the name of a {kind}")
        if parameters is None:
            result: Array = self._calls[key](out, *values)
            return result
        loaded = self._functions.get(key)
        # while a function is checked, another model over its C would have it checked again
        if loaded is not None and not loaded.code.fresh:
            repeated_model = self._of_repeated(parameters)
            if repeated_model is not None:
                return repeated_model._evaluate(key, values, None, out)
        if self.manifest.absolute:
            # its tables are filled for one set of parameters
            vector = self._parameters.changed(parameters)
            if vector.ndim != 1:
                raise ArgumentError(
                    f"{key[0]}: parameters= takes one number per name in absolute coordinates; "
                    "ask with_parameters(...) of one set after the other"
                )
            return self._with(Parameters(self.manifest, vector))._evaluate(key, values, None, out)
        function = self._function(*key)
        w = function.prepared(self._parameters.changed(parameters))
        return function.caller(out, *values, w=w)

    def _of_repeated(self, parameters: Values) -> Self | None:
        """The model with the values that the last call had too; None where they are others.

        The second call with the same numbers checks and prepares them, later ones find that done.
        Zeros are left to the general way: comparisons do not see their signs.
        """
        if type(parameters) is not dict:
            return None
        if not all(type(x) in (float, int) and x for x in parameters.values()):
            return None
        pairs = tuple(parameters.items())
        latest: tuple[object, Self | None] = self._derived.get(Parameters, (None, None))
        if latest[0] != pairs:
            self._derived[Parameters] = pairs, None
            return None
        if latest[1] is None:
            model = self._with(Parameters(self.manifest, self._parameters.changed(parameters)))
            latest = self._derived[Parameters] = pairs, model
        return latest[1]

    def _vector(self, block: str, value: object) -> Any:
        if not isinstance(value, Mapping):
            return numbers(block, value)
        return by_name(block, self._layout.arguments[block], value)

    # states

    def split(self, x: ArrayLike) -> tuple[Array, Array]:
        """q (..., nq) and u (..., nu) of a state x (..., nx): views where x is an array."""
        return self.parts_of(x)[:2]

    def parts_of(self, x: ArrayLike) -> tuple[Array, Array, Array]:
        """q (..., nq), u (..., nu) and z (..., nz) of a state x (..., nx), as :meth:`split`."""
        array = numbers("x", x)
        if array.ndim == 0 or array.shape[-1] != self.nx:
            blocks = "[q, u, z]" if self.nz else "[q, u]"
            raise ArgumentError(f"x has shape {array.shape}, expected (..., {self.nx}): {blocks}")
        nq, end = self.nq, self.nq + self.nu
        return array[..., :nq], array[..., nq:end], array[..., end:]

    @checked
    def random_state(
        self, rng: np.random.Generator | Seed | None = None, shape: tuple[int, ...] = ()
    ) -> Array:
        """States x ``(*shape, nx)`` inside limits and domains; speeds within +-1."""
        return random_state(self.manifest, np.random.default_rng(rng), shape)

    # who verifies builds stands above: the class that users hold

    @abstractmethod
    def _verify_built(self, fresh: Iterable[Key]) -> bool:
        """Check functions that were just built: (name, of). False: accelerations have no digits."""

    @abstractmethod
    def _verify_elements(self, elements: Elements, fresh: Iterable[str]) -> None:
        """Check functions of elements that were just built, by their C names."""
