"""Inputs that functions of the caller compute during a run, in Python or in C."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...arguments import check_fields
from ...errors import BuildError, ModelError, brief, near
from ...ir.function import Function, live
from ...records import dataclass
from ...runtime.build import cache
from ...runtime.models.loaded_model import LoadedModel
from ...schema.records import InputFunction as Row
from ...schema.records import InputFunctions as Record

NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)


@dataclass(frozen=True)
class CFunction:
    """A function in C that computes inputs, such as a force law with states of its own.

    It is asked at every evaluation of the equations, at the speed of C. **It runs with your
    permissions, unchecked: name files that you trust.** The file has

    ``int name(double t, const double *x, const double *reads, double *gives)``

    which takes time [s], the state x = [q, u, z] of the model and the outputs of the scene named in
    ``reads``, and writes the inputs that it stands for. Another result than 0 ends the run.

    States of its own are those of a :class:`cardan.Controller` whose ``changes`` are inputs: the
    function gives their rates, and the integrator keeps their error within the tolerances.

    Args:
        file: A C file; headers beside it can be included. Compiled at its first use, kept in the
            cache.
        name: Of the function; that of the file if left out.
        reads: Names of outputs of the scene, which may not depend on what the function gives.

    Raises:
        ModelError: there is no such file, or a name that C does not have.
    """

    file: str | Path
    name: str = ""
    reads: Sequence[str] = ()

    def __post_init__(self) -> None:
        check_fields(self)
        path, reads = Path(self.file).resolve(), self.reads
        symbol = self.name or path.stem
        if not NAME.fullmatch(symbol):
            raise ModelError(f"CFunction: {brief(symbol)} is not a name in C: give name='...'")
        if path.suffix != ".c" or not path.is_file():
            raise ModelError(f"CFunction: there is no C file '{path}'; name one, such as tire.c")
        reads = (reads,) if isinstance(reads, str) else reads
        if not isinstance(reads, Sequence) or not all(isinstance(one, str) for one in reads):
            raise ModelError(f"CFunction: reads={brief(reads)}: give names of outputs of the scene")
        object.__setattr__(self, "file", path)
        object.__setattr__(self, "name", symbol)
        object.__setattr__(self, "reads", tuple(map(str, reads)))

    def __str__(self) -> str:
        return f"C function '{self.name}' of {Path(self.file).name}"

    def _library(self) -> ctypes.CDLL:
        """The compiled file.

        Raises:
            BuildError: it cannot be compiled, or has no such function.
            CompilerMissing: there is no compiler.
        """
        path = Path(self.file)
        built = cache.build([path], [path.parent])
        library = built.load()
        if not hasattr(library, self.name):
            raise BuildError(f"{self.file} has no function '{self.name}'; is it static?")
        return library


@dataclass(frozen=True)
class CEntry:
    """An input that a C function gives.

    Attributes:
        function: Which one.
        place: Among the inputs that it gives.
    """

    function: CFunction
    place: int


class InputFunctions:
    """What a run asks for its inputs.

    Attributes:
        record: ``cardan_input_functions``.
        functions: Those in C, in the order in which they are asked.
    """

    def __init__(
        self, model: LoadedModel, functions: Mapping[int, object], run: int, python: int | None
    ) -> None:
        """Compile and connect.

        Args:
            model: Whose outputs are read.
            functions: Index in r -> a function f(t, x), or a place of one in C.
            run: Address of the record of the run.
            python: Address of the function that calls those in Python; None if there are none.

        Raises:
            BuildError: C that does not compile. ModelError: outputs that do not exist, or that
                depend on what the function gives.
        """
        gives: dict[CFunction, dict[int, int]] = {}
        for place, one in functions.items():
            if isinstance(one, CEntry):
                gives.setdefault(one.function, {})[one.place] = place
        self.functions = tuple(gives)
        outputs = [str(row.name) for row in model.manifest.outputs]
        self._references: list[object] = [model]
        self._rows = (Row * max(1, len(gives)))()
        for row, (function, places) in zip(self._rows, gives.items(), strict=False):
            library = function._library()
            read = [_place(function, name, outputs) for name in function.reads]
            entries = [places[k] for k in range(len(places))]
            row.function = ctypes.cast(getattr(library, function.name), ctypes.c_void_p).value
            row.reads, row.read_count = self._places(read), len(read)
            row.gives, row.give_count = self._places(entries), len(entries)
            self._references.append(library)
        self.record = Record(run=run, python=python, count=len(gives), failed=-1)
        self.record.functions = ctypes.addressof(self._rows)
        if any(function.reads for function in gives):
            every = [place for places in gives.values() for place in places.values()]
            self._read_outputs(model, gives, every)
        self.record.values = self._numbers(len(outputs))
        self.record.reads = self._numbers(max((len(f.reads) for f in gives), default=0))
        self.record.gives = self._numbers(max((len(p) for p in gives.values()), default=0))

    @property
    def address(self) -> int:
        """The address of the record."""
        return ctypes.addressof(self.record)

    def failure(self) -> str:
        """The error that broke a run, in words."""
        k = self.record.failed
        if k < 0:
            return "the outputs that C functions read cannot be computed"
        return f"{self.functions[k]} returned {self.record.status}"

    def _places(self, places: list[int]) -> int:
        return self._address(np.array(places, dtype=np.intp))

    def _numbers(self, count: int) -> int:
        return self._address(np.zeros(max(1, count)))

    def _address(self, array: NDArray[np.generic]) -> int:
        self._references.append(array)
        return array.ctypes.data

    def _read_outputs(
        self, model: LoadedModel, functions: Mapping[CFunction, object], entries: list[int]
    ) -> None:
        """Connect the outputs.

        Raises:
            ModelError: one depends on what a function gives: nobody could be asked first.
        """
        if model.manifest.absolute:
            raise ModelError(
                f"{next(iter(functions))}: reads= are outputs of models in joint coordinates; this "
                "one has absolute coordinates: compute what is read from x"
            )
        outputs = model._function("outputs")
        used = inputs_of_outputs(model, outputs.symbol)
        for function in functions:
            for name in function.reads:
                loops = sorted(used[name] & {*entries})
                if loops:
                    raise ModelError(
                        f"{function} reads output '{name}', which depends on input "
                        f"'{model.inputs[loops[0]]}', which a C function gives: read something else"
                    )
        self.record.outputs, self.record.outputs_w = outputs.address, self._address(outputs.w)
        self.record.work = self._numbers(outputs.work_size)


def inputs_of_outputs(model: LoadedModel, symbol: str) -> dict[str, set[int]]:
    """Name of an output -> places of the inputs on which it depends."""
    function = model._objects.function(symbol)
    everything = set(range(model.nr))
    if not isinstance(function, Function):
        # loops over bodies: each result may depend on everything
        return {str(row.name): everything for row in model.manifest.outputs}
    used: dict[str, set[int]] = {}
    for output in function.outputs:
        for name, node in zip(output.entries, output.nodes, strict=True):
            nodes = (function.graph.nodes[i] for i in live(function.graph, [node]))
            used[name] = {n[2] for n in nodes if n[0] == "var" and n[1] == "r"}
    return used


def _place(function: CFunction, name: str, outputs: Sequence[str]) -> int:
    """Place of an output.

    Raises:
        ModelError: the scene has none of that name.
    """
    if name not in outputs:
        raise ModelError(f"{function}: reads: there is no output '{name}'.{near(name, outputs)}")
    return outputs.index(name)
