"""Our own functions as contenders, and the 40-digit numbers everybody is measured by."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from time import perf_counter
from typing import Any

import numpy as np

from ..api.comparison import (
    ORDER,
    SLOT,
    CompiledModel,
    Derivative,
    LoadedFunction,
    build,
    evaluate,
    from_dict,
    kernel_files,
    one_by_one,
    samples,
)
from ..api.comparison import States as Many
from ..arrays import Array
from ..records import dataclass
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
    return build([HERE / "ours.c"], kernel_files.includes()).load()


@dataclass(frozen=True)
class Ours:
    """The functions of a compiled model under the names of the contest.

    Attributes:
        model: Compiled.
    """

    model: CompiledModel

    @property
    def functions(self) -> tuple[str, ...]:
        """Functions of ``FUNCTIONS`` that the model was compiled with."""
        available = self.model.manifest.available
        return tuple(f for f in FUNCTIONS if {"derivatives": "derivative"}.get(f, f) in available)

    @property
    def derivative(self) -> Derivative:
        """Derivative of forward dynamics by q and u."""
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
        bound: Callable[..., Any] = (
            self.derivative if name == "derivatives" else getattr(self.model, name)
        )
        return bound

    def arguments(self, name: str, states: States) -> tuple[tuple[Any, ...], dict[str, Any]]:
        """Arguments of the model's method."""
        if name == "mass_matrix":
            return (states.q,), {}
        if name == "inverse_dynamics":
            return (states.q, states.u, states.third), {}
        return (states.q, states.u), {"tau": states.third}

    def results(self, name: str, states: States) -> Array:
        """See :class:`.peer.Contender`."""
        args, more = self.arguments(name, states)
        values = self.method(name)(*args, **more)
        return np.stack(values, axis=1) if name == "derivatives" else np.asarray(values)

    def _still(self) -> dict[str, Array]:
        """Values that all states share: inputs, internal states and modes at the start."""
        defaults = {block: self.model._layout.start(block) for block in ("r", "z", "s")}
        return defaults | {"t": np.zeros(1), "wrench": np.zeros(6 * len(self.model.bodies))}

    def blocks(self, name: str, states: States) -> dict[str, Array]:
        """Blocks that a call reads besides the parameters."""
        third = {"inverse_dynamics": "udot"}.get(name, "tau")
        moving = {"q": states.q, "u": states.u, third: states.third}
        return self._still() | {key: np.ascontiguousarray(block) for key, block in moving.items()}

    def start(self, name: str, states: States) -> Callable[[int], float]:
        """One state after the other, in a loop in C."""
        function, nu = self.function(name), self.model.nu
        arrays = {**self.blocks(name, states), "w": function.w}
        work, out = np.empty(function.work_size + 1), np.empty((len(states), output_size(name, nu)))
        places = [arrays[key].ctypes.data if key in arrays else None for key in ORDER]
        program = Program(
            function.address, (ctypes.c_void_p * len(ORDER))(*places), work.ctypes.data,
            self.model.nq, nu,
        )  # fmt: skip
        loop, moving = peer_loop(library()), [states.q, states.u, states.third]
        blocks = [np.ascontiguousarray(block) for block in moving]
        where = [address(block) for block in (*blocks, out)]

        def run(repeats: int, references: object = (arrays, work, out, blocks)) -> float:
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
        way = caller.batch.lane_run(False, many) or one_by_one(caller.call, many)

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
            values = evaluate(function, {k: list(v) for k, v in blocks.items()}, "mp", DIGITS)
            rows.append([float(x) for o in function.outputs for x in values[o.name]])
        nu = self.model.nu
        shape = {"mass_matrix": (nu, nu), "derivatives": (2, nu, nu)}.get(name, (nu,))
        return np.array(rows).reshape(len(states), *shape)
