"""A compiled model: its functions on arrays, as fast C."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, final

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import Count, Seed, checked, kinds_of, read
from ..arrays import Array
from ..errors import ArgumentError, ModelError, counted, shown
from ..schema.functions import FUNCTIONS, STANDARD
from . import kernels
from .analyzed import Analyzed
from .calling import by_name, numbers
from .evaluation import Values
from .generated import Generated, Source
from .layout import Layout
from .loaded import LoadedFunction
from .objects import Key, Objects, Provide
from .parameters import Parameters
from .states import random_state

if TYPE_CHECKING:
    from ..analyses.alpha import Alpha, GeneralizedAlpha
    from .report import Report
    from .trajectory import Trajectory
    from .verify import Verification


class _Calls(dict[Key, Any]):
    """The quick way into every function; filled on first use."""

    def __init__(self, load: Callable[[str, str | None], LoadedFunction]) -> None:
        self.load = load

    def __missing__(self, key: Key) -> Any:
        self[key] = fast = self.load(*key).fast
        return fast


@final
class CompiledModel(Analyzed):
    """Functions of a system as compiled C.

    All functions broadcast over leading axes like NumPy gufuncs, return fresh arrays (or fill
    ``out=``), may be called from several threads at once, and release the GIL where they work
    long. A vector may be given by names, ``{"elbow": 0.3}``; the rest then takes its default.

    Conventions: the speeds u are what robotics calls v, tau is a generalized applied force; the
    equations are M udot + h = f + tau with gravity inside h; quaternions are (w, x, y, z) and must
    have length 1; 6-vectors have the angular part first. SI units, radians.

    Raises (every function):
        ArgumentError: wrong shape. ModelError: unknown name, or a function that was not compiled.
        SolveError: a number given is not finite; or, for one state, the result is not. In a batch
            the states that fail hold NaN or infinity and a SolveWarning names the first.
    """

    @checked
    def __init__(
        self,
        directory: str | Path,
        provide: Provide | None = None,
        *,
        reproducible: bool = False,
        threads: int | None = None,
    ) -> None:
        """Open a model directory.

        Args:
            directory: With ``manifest.json`` and the C files.
            provide: Of (function, of) pairs; writes what is missing there, gives their C names.
            reproducible: Equal bits from every compiler, 10-30 % slower.
            threads: That share a large batch; by default ``$CARDAN_THREADS``, else the cores that
                this process may use.

        Raises:
            ModelError: no readable manifest.
        """
        self._objects = Objects(Path(directory), provide, reproducible, threads)
        self._set(Parameters(self._objects.manifest))

    def _set(self, parameters: Parameters, layout: Layout | None = None) -> None:
        self._layout = layout or Layout(self._objects.manifest)
        self._parameters = parameters
        self._functions: dict[Key, LoadedFunction] = {}
        self._doubted: set[str] = set()
        # of the mechanism with these parameters, once it is known
        self._size: float | None = None
        # what has been found out about it, by what it is
        self._derived: dict[object, Any] = {}
        self._calls = _Calls(self._function)
        self._source = self._source_of()

    def _source_of(self) -> Source:
        """Where functions come from: elements in tables, or C of their own."""
        if not self.manifest.absolute:
            return Generated()
        from .absolute.assembled import Assembled

        return Assembled()

    def __repr__(self) -> str:
        return (
            f"CompiledModel('{self.name}', {self.manifest.method}: "
            f"{counted(len(self.bodies), 'body', 'bodies')}, "
            f"{counted(self.nq, 'coordinate')}, {counted(self.nu, 'speed')}, "
            f"{counted(len(self.parameters), 'parameter')})"
        )

    @checked
    def with_parameters(self, values: Values | None = None, **named: ArrayLike) -> CompiledModel:
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

    def _with(self, parameters: Parameters) -> CompiledModel:
        """This model over the same loaded code with other values."""
        other = object.__new__(CompiledModel)
        other._objects = self._objects
        other._set(parameters, self._layout)
        return other

    # loading

    def _function(self, name: str, of: str | None = None) -> LoadedFunction:
        """A function, compiled and loaded if it was not yet."""
        return self._load([(name, of)])[0]

    def _load(self, keys: Iterable[Key]) -> list[LoadedFunction]:
        """Several functions; those that must be compiled are compiled side by side.

        Nobody gets a function, and no other process finds its object, before it is checked.
        """
        wanted = list(keys)
        with self._objects.lock:
            missing = [key for key in dict.fromkeys(wanted) if key not in self._functions]
            for name, of in missing:
                self._check_of(name, of)
            if missing:
                self._source.add(self, missing)
            return [self._functions[key] for key in wanted]

    def prepare(self, *functions: str | Key, batch: bool = False) -> None:
        """Compile functions before they are needed, several at once.

        Args:
            functions: Such as ``"rhs"`` or ``("pose", "hand")``; all that were written if empty.
            batch: Also for many states side by side, which else happens when it pays.
        """
        batch = read("prepare", "batch", batch, kinds_of("bool"))
        for f in functions:
            if not isinstance(f, str | tuple):
                raise ArgumentError(f"prepare({shown(f)}): give names, or ('pose', 'hand')")
        keys = [(f, None) if isinstance(f, str) else f for f in functions]
        if not functions:
            keys = self._written()
        loaded = self._load(keys)
        if batch:
            from .samples import build

            for function in loaded:
                build(self, function)

    @checked
    def lanes(self, function: str, of: str | None = None) -> int:
        """States that batches of a function do side by side; 1 until that pays, or without vectors.

        Args:
            function, of: Such as ``"rhs"``, or ``"pose", "hand"``.
        """
        return self._function(function, of).caller.batch.lanes

    def _written(self) -> list[Key]:
        """Keys of the functions whose C is in the directory."""
        rows = self.manifest.functions.items()
        keys = [(name.split("__")[0], entry.of) for name, entry in rows]
        return [key for key in keys if key[0] in STANDARD]

    @property
    def saved(self) -> tuple[str, ...]:
        """Names of the functions whose expressions are stored beside the C."""
        return tuple(self._objects.saved())

    def _evaluate_saved(self, name: str, arithmetic: str = "numpy", **values: Any) -> Any:
        """Results of a saved Function in Python; see :func:`cardan.ir.interpreter.evaluate`."""
        from ..ir.interpreter import evaluate

        try:
            return evaluate(self._objects.function(name), values, arithmetic)
        except ValueError as error:
            raise ModelError(
                f"{self._objects.directory}: what manifest.json and functions.json say differs: "
                f"{error}. Compile the model again"
            ) from error

    def _kernels(self) -> ctypes.CDLL:
        """The library of integrators and loops."""
        return kernels.library(self._objects.reproducible)

    def _evaluate(
        self, key: Key, values: tuple[Any, ...], parameters: Values | None, out: Array | None
    ) -> Array:
        of = key[1]
        if of is not None and not isinstance(of, str):
            kind = FUNCTIONS[key[0]].of
            raise ArgumentError(f"{key[0]}: {kind}={shown(of)}: give the name of a {kind}")
        if parameters is None:
            result: Array = self._calls[key](out, *values)
            return result
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

    def _vector(self, block: str, value: Any) -> Any:
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
    def initial(
        self, q: Values | None = None, u: Values | None = None, z: Values | None = None
    ) -> Array:
        """The state x (nx,) in which a run with these named values starts.

        Loops are closed at t = 0 with the defaults of the inputs, as ``simulate`` closes them: what
        is named is held, the rest is next to q0 and u0 of the joints, then 0.

        Raises:
            ModelError: an unknown name, or loops that cannot be closed with what is named.
            ArgumentError: the wrong number of values.
            SolveError: a value that is not finite, or a quaternion whose length is not 1.
        """
        from ..analyses.closed_start import initial

        return initial(self, q or {}, u or {}, z or {})

    @checked
    def random_state(
        self, rng: np.random.Generator | Seed | None = None, shape: tuple[int, ...] = ()
    ) -> Array:
        """States x (*shape, nx) inside limits and domains; speeds within +-1."""
        return random_state(self.manifest, np.random.default_rng(rng), shape)

    # checks and runs

    @checked
    def verify(self, states: Count = 3, seed: Seed = 1) -> Verification:
        """Compare the C with an independent NumPy Newton-Euler; see :mod:`.verify`.

        Raises:
            BuildError: they differ.
        """
        from .verify import verify

        return verify(self, states=states, seed=seed)

    @checked
    def report(self, t: float | ArrayLike | None = None, **options: Any) -> Report:
        """Measure every function: operations, time, error against 40 digits; prints a table.

        Args:
            t: With an end, or ``(start, end)`` [s], speed against error of every integrator too:
                ``report(10, q={"elbow": 1.0}).methods``.
            options: Of the motion, as :func:`cardan.analyses.precision_runs.precision` takes them.
        """
        from .report import report

        functions = report(self)
        if t is None:
            return functions
        from ..analyses.precision_runs import compare

        return compare(self, functions, t, **options)

    @checked
    def simulate(
        self,
        t: float | ArrayLike | None = None,
        *,
        t_eval: ArrayLike | None = None,
        x0: ArrayLike | None = None,
        q: Any = None,
        u: Any = None,
        z: Any = None,
        events: Mapping[str, Any] | None = None,
        method: str | GeneralizedAlpha | Alpha = "auto",
        rtol: float = 1e-6,
        atol: float | None = None,
        step: float | None = None,
        max_step: float | None = None,
        inputs: Mapping[str, Any] | None = None,
        sample: float | None = None,
        checkpoint: str | Path | None = None,
        every: float = 10.0,
        check: bool = False,
        progress: bool | Callable[[float], None] | None = None,
    ) -> Trajectory:
        """Motion; :func:`cardan.analyses.simulate.simulate` tells what the arguments mean.

        Args:
            t: End, ``(start, end)`` or output times [s].
            t_eval: Output times [s], two or more, in place of ``t``.
            x0: State (nx,); or q, u, z: arrays or values by name, such as ``{"elbow": 0.3}``.
            events: Name -> ``f(t, x)`` or ``("elbow", value)``: where the run ends, or what is
                noted.
            method, rtol, atol, step, max_step: Such as ``"DOP853"``, tolerances, steps [s].
            inputs: Name -> constant, ``(times, values)`` or ``f(t, x)``; ``sample`` [s] holds it.
            checkpoint, every: A file that keeps what is computed, and how often [s].
            check, progress: Raise where the end is not reached; show how far it is.
        """
        from ..analyses.simulate import simulate

        start: dict[str, Any] = {"t_eval": t_eval, "x0": x0, "q": q, "u": u, "z": z}
        start |= {"events": events}
        given: dict[str, Any] = {"inputs": inputs, "sample": sample, "progress": progress}
        given |= {"checkpoint": checkpoint, "every": every}
        how: dict[str, Any] = {"rtol": rtol, "atol": atol, "step": step, "max_step": max_step}
        return simulate(self, t, method=method, check=check, **start, **given, **how)

    def stepper(self, **options: Any) -> Any:
        """Motion step by step; see :class:`cardan.analyses.stepper.Stepper`."""
        from ..analyses.stepper import stepper

        return stepper(self, **options)

    @checked
    def resume(self, path: str | Path, *, events: Mapping[str, Any] | None = None) -> Any:
        """The stepper of a file that ``stepper.save(path)`` wrote, at the same bits."""
        from ..analyses.stepper import resume

        return resume(self, path, events=events)

    def step(self, x: ArrayLike, dt: float, **options: Any) -> Array:
        """States (..., nx) a time dt [s] after x; see :func:`cardan.analyses.stepper.step`."""
        from ..analyses.stepper import step

        return step(self, x, dt, **options)

    def __reduce__(self) -> tuple[object, ...]:
        from .saved import reduced

        return reduced(self)
