"""Our own functions as contenders, and the 40-digit numbers everybody is measured by."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from ..ir.interpreter import evaluate
from ..ir.serialize import from_dict
from ..runtime.cache import build
from ..runtime.compiled import CompiledModel
from ..runtime.derivatives import Derivative
from ..runtime.loaded import LoadedFunction
from ..runtime.slots import ORDER
from .loop import HERE, NUMBER, address, output_size, peer_loop
from .peer import FUNCTIONS, Array, States

KERNELS = Path(__file__).parents[1] / "kernels"
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
    return build([HERE / "ours.c"], [KERNELS]).load()


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
        known = self.model.manifest["available"]
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

    def start(self, name: str, states: States) -> Callable[[int], float]:
        """One state after the other, in a loop in C."""
        function, nu = self.function(name), self.model.nu
        layout = {"t": np.zeros(1), "r": self.model._layout.start("r"), "w": function.w}
        layout["wrench"] = np.zeros(6 * len(self.model.bodies))
        work = np.empty(function.work_size + 1)
        places = [layout[name].ctypes.data if name in layout else None for name in ORDER]
        program = Program(
            function.address, (ctypes.c_void_p * len(ORDER))(*places), work.ctypes.data,
            self.model.nq, nu,
        )  # fmt: skip
        out = np.empty((len(states), output_size(name, nu)))
        blocks = [np.ascontiguousarray(b) for b in (states.q, states.u, states.third)]
        loop, where = peer_loop(library()), [address(b) for b in (*blocks, out)]
        held = (layout, work, program, out, blocks)

        def run(repeats: int, held: Any = held) -> float:
            me = ctypes.byref(program)
            return float(loop(me, NUMBER[name], *where, out.shape[1], len(states), repeats))

        return run

    def batch(self, name: str, states: States) -> Callable[[int], float]:
        """All states in one call from Python."""
        args, more = self.arguments(name, states)
        call = self.method(name)
        more["out"] = call(*args, **more)

        def run(repeats: int) -> float:
            began = perf_counter()
            for _ in range(repeats):
                call(*args, **more)
            return (perf_counter() - began) / repeats / len(states)

        return run

    def exact(self, name: str, states: States) -> Array:
        """Results from 40 digits, rounded once."""
        function = from_dict(self.model._objects.saved()[self.function(name).symbol])
        still = {"t": [0.0], "r": self.model._layout.start("r"), "p": self.model.parameters.vector}
        rows = []
        for q, u, x in zip(states.q, states.u, states.third, strict=True):
            blocks: dict[str, Any] = {**still, "q": q, "u": u, "udot": x, "tau": x}
            blocks["wrench"] = np.zeros(6 * len(self.model.bodies))
            found = evaluate(function, {k: list(v) for k, v in blocks.items()}, "mp", DIGITS)
            rows.append([float(x) for o in function.outputs for x in found[o.name]])
        nu = self.model.nu
        shape = {"mass_matrix": (nu, nu), "derivatives": (2, nu, nu)}.get(name, (nu,))
        return np.array(rows).reshape(len(states), *shape)
