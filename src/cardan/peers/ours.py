"""Our own functions as contenders, and the 40-digit numbers everybody is measured by."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import numpy as np

from ..api.compiled_model import CompiledModel
from ..arrays import Array
from ..ir.interpreter import evaluate
from ..ir.serialize import from_dict
from ..runtime.build import prebuilt
from ..runtime.build.cache import build
from ..runtime.calls import samples
from ..runtime.calls.batch import one_by_one
from ..runtime.calls.lanes import States as Many
from ..runtime.calls.loaded_function import LoadedFunction
from ..runtime.models.derivatives import Derivative
from ..schema.blocks import ORDER, SLOT
from .loop import HERE, NUMBER, address, output_size, peer_loop
from .peer import FUNCTIONS, States

DIGITS = 40


class Program(ctypes.Structure):
    """``peer`` of ours.c."""

    _fields_ = (
        ("f", ctypes.c_void_p),
        ("in_", ctypes.c_void_p * len(ORDER)),
        ("work", ctypes.c_void_p),
        ("nq", ctypes.c_int),
        ("nu", ctypes.c_int),
    )


def library() -> ctypes.CDLL:
    """The loop in C."""
    return build([HERE / "ours.c"], [prebuilt.DIRECTORY]).load()


@dataclass(frozen=True)
class Ours:
    """The functions of a compiled model under the names of the contest.

    Attributes:
        model: Compiled.
    """

    model: CompiledModel

    @property
    def functions(self) -> tuple[str, ...]:
        """What the model was compiled with, of ``FUNCTIONS``."""
        known = self.model.manifest.available
        return tuple(f for f in FUNCTIONS if {"derivatives": "derivative"}.get(f, f) in known)

    @property
    def derivative(self) -> Derivative:
        """Of forward dynamics, by q and u."""
        return self.model.derivative("forward_dynamics", wrt=("q", "u"))

    def function(self, name: str) -> LoadedFunction:
        """A function, loaded.

        Raises:
            DerivationError, ModelError: the model has none.
        """
        if name == "derivatives":
            return self.model._function("derivative", self.derivative.request)
        return self.model._function(name)

    def method(self, name: str) -> Callable[..., Any]:
        """A function as people call it."""
        found: Callable[..., Any] = (
            self.derivative if name == "derivatives" else getattr(self.model, name)
        )
        return found

    def arguments(self, name: str, states: States) -> tuple[tuple[Any, ...], dict[str, Any]]:
        """What the method of a model takes."""
        if name == "mass_matrix":
            return (states.q,), {}
        if name == "inverse_dynamics":
            return (states.q, states.u, states.third), {}
        return (states.q, states.u), {"tau": states.third}

    def results(self, name: str, states: States) -> Array:
        """See :class:`.peer.Contender`."""
        args, more = self.arguments(name, states)
        found = self.method(name)(*args, **more)
        return np.stack(found, axis=1) if name == "derivatives" else np.asarray(found)

    def _still(self) -> dict[str, Array]:
        """What is the same at all states: inputs, internal states and modes as they start."""
        own = {block: self.model._layout.start(block) for block in ("r", "z", "s")}
        return own | {"t": np.zeros(1), "wrench": np.zeros(6 * len(self.model.bodies))}

    def blocks(self, name: str, states: States) -> dict[str, Array]:
        """What a call reads besides the parameters, by block."""
        third = {"inverse_dynamics": "udot"}.get(name, "tau")
        moving = {"q": states.q, "u": states.u, third: states.third}
        return self._still() | {key: np.ascontiguousarray(block) for key, block in moving.items()}

    def start(self, name: str, states: States) -> Callable[[int], float]:
        """One state after the other, in a loop in C."""
        function, nu = self.function(name), self.model.nu
        given = {**self.blocks(name, states), "w": function.w}
        work, out = np.empty(function.work_size + 1), np.empty((len(states), output_size(name, nu)))
        places = [given[key].ctypes.data if key in given else None for key in ORDER]
        program = Program(
            function.address, (ctypes.c_void_p * len(ORDER))(*places), work.ctypes.data,
            self.model.nq, nu,
        )  # fmt: skip
        loop, moving = peer_loop(library()), [states.q, states.u, states.third]
        blocks = [np.ascontiguousarray(block) for block in moving]
        where = [address(block) for block in (*blocks, out)]

        def run(repeats: int, held: Any = (given, work, out, blocks)) -> float:
            me = ctypes.byref(program)
            return float(loop(me, NUMBER[name], *where, out.shape[1], len(states), repeats))

        return run

    def batch(self, name: str, states: States) -> Callable[[int], float]:
        """All states in one call, in lanes where the machine has vectors; in this thread."""
        function = self.function(name)
        samples.build(self.model, function)
        blocks: list[Array | None] = [None] * len(ORDER)
        strides = [0] * len(ORDER)
        for key, block in {**self.blocks(name, states), "w": function.w}.items():
            blocks[SLOT[key]] = block.reshape(-1)
            strides[SLOT[key]] = block.shape[1] if block.ndim == 2 else 0
        out = np.empty((len(states), output_size(name, self.model.nu)))
        many, caller = Many(blocks, strides, out), function.caller
        way = caller.batch.found(False, many) or one_by_one(caller.call, many)

        # the call knows addresses alone: the arrays stay with it
        def run(repeats: int, arrays: object = blocks) -> float:
            began = perf_counter()
            for _ in range(repeats):
                way(0, len(out))
            return (perf_counter() - began) / repeats / len(out)

        return run

    def exact(self, name: str, states: States) -> Array:
        """Results from 40 digits, rounded once."""
        function = from_dict(self.model._objects.saved()[self.function(name).symbol])
        still = {**self._still(), "p": self.model.parameters.vector}
        rows = []
        for q, u, x in zip(states.q, states.u, states.third, strict=True):
            blocks: dict[str, Any] = {**still, "q": q, "u": u, "udot": x, "tau": x}
            found = evaluate(function, {k: list(v) for k, v in blocks.items()}, "mp", DIGITS)
            rows.append([float(x) for o in function.outputs for x in found[o.name]])
        nu = self.model.nu
        shape = {"mass_matrix": (nu, nu), "derivatives": (2, nu, nu)}.get(name, (nu,))
        return np.array(rows).reshape(len(states), *shape)
