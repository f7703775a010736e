"""Loops in C around other programs, and around ours: no Python inside what is timed."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..api.comparison import Coordinates
from ..arrays import Array
from ..records import dataclass
from .peer import States

HERE = Path(__file__).parent
NUMBER = {name: k for k, name in enumerate(("forward_dynamics", "inverse_dynamics", "mass_matrix"))}
NUMBER["derivatives"] = 3


def address(array: NDArray[Any]) -> ctypes.c_void_p:
    """Address of the first entry of an array."""
    return ctypes.c_void_p(array.ctypes.data)


def output_size(function: str, nu: int) -> int:
    """Numbers a function gives at one state."""
    return {"mass_matrix": nu * nu, "derivatives": 2 * nu * nu}.get(function, nu)


@dataclass(frozen=True)
class Loop:
    """A function ``peer_loop`` of a library, with the program it is about.

    Attributes:
        call: ``peer_loop(self, function, q, u, x, out, size, count, repeats)``: fills ``out``, then
            times so many repeats; seconds per call.
        program: As an address.
        map: Our coordinates in those of the program.
    """

    call: Callable[..., float]
    program: Any
    map: Coordinates

    def theirs(self, function: str, states: States) -> list[Array]:
        """The states as the program wants them."""
        q, u = self.map.q(states.q), self.map.speeds(states.q, states.u)
        if function == "inverse_dynamics":
            x = self.map.accelerations(states.q, states.u, states.third)
        else:
            x = self.map.speeds(states.q, states.third)
        return [np.ascontiguousarray(block) for block in (q, u, x)]

    def start(self, function: str, states: States) -> Callable[[int], float]:
        """See :class:`.peer.Contender`."""
        blocks = self.theirs(function, states)
        out = np.empty((len(states), output_size(function, states.u.shape[1])))

        def run(repeats: int) -> float:
            return self.run(function, blocks, out, repeats)

        return run

    def run(self, function: str, blocks: list[Array], out: Array, repeats: int) -> float:
        """Seconds per call; fills ``out``."""
        count, size = out.shape
        places = [address(block) for block in (*blocks, out)]
        return float(self.call(self.program, NUMBER[function], *places, size, count, repeats))

    def results(self, function: str, states: States) -> Array:
        """See :class:`.peer.Contender`."""
        nu = states.u.shape[1]
        out = np.empty((len(states), output_size(function, nu)))
        self.run(function, self.theirs(function, states), out, 0)
        if function == "forward_dynamics":
            return self.map.accelerations_back(states.q, states.u, out)
        if function == "inverse_dynamics":
            return self.map.back(states.q, out)
        if function == "mass_matrix":
            return self.map.matrix_back(states.q, out.reshape(-1, nu, nu))
        return out.reshape(-1, 2, nu, nu)


def peer_loop(library: ctypes.CDLL) -> Callable[..., float]:
    """The loop of a library."""
    function = library.peer_loop
    function.restype = ctypes.c_double
    function.argtypes = [ctypes.c_void_p, ctypes.c_int, *[ctypes.c_void_p] * 4, *[ctypes.c_int] * 3]
    call: Callable[..., float] = function
    return call
