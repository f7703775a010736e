"""Every flexible element at a state, with numbers for all of its data."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from cardan.elements.flexible import FLEXIBLE, Classical, FlexibleElement, HellingerReissner
from cardan.ir.function import Function
from cardan.ir.interpreter import evaluate

Array = NDArray[np.float64]
TINY = 1e-30
ELEMENTS: dict[str, FlexibleElement] = {
    **{kind: element() for kind, element in FLEXIBLE.items()},
    "classical plain": Classical(residual_flexibility=False),
    "hellinger_reissner loaded": HellingerReissner(loaded=True),
}
ENDS = [
    ("node", "node"),
    ("offset", "node"),
    ("offset", "offset"),
    ("ground", "node"),
    ("offset", "ground"),
]
# what is not any number between 0.5 and 1.5
NUMBERS = {"EA": 70.0, "GA2": 30.0, "GA3": 20.0, "GJ": 3.0, "K1": 0.1, "K2": 0.2, "K3": -0.1}
NUMBERS |= {"E2": 0.01, "E3": 0.02} | {f"strain_{k}": 0.02 * k - 0.05 for k in range(1, 7)}


def quaternion(turn: Rotation) -> Array:
    """Scalar first."""
    found: Array = np.roll(turn.as_quat(), 1, axis=-1)
    return found


def rotation(q: Array) -> Rotation:
    """Of unit quaternions (..., 4), scalar first."""
    return Rotation.from_quat(np.roll(q, -1, axis=-1))


@dataclass(frozen=True)
class State:
    """An element somewhere.

    Attributes:
        element: Which.
        kinds: Of its ends.
        numbers: Its data by name.
        q, u, udot: Of its nodes.
        poses: Rotation and position of both ends.
    """

    element: FlexibleElement
    kinds: tuple[str, str]
    numbers: dict[str, float]
    q: Array
    u: Array
    udot: Array
    poses: tuple[tuple[Rotation, Array], ...]
    functions: dict[str, Function] = field(repr=False)

    @property
    def p(self) -> list[float]:
        return [self.numbers[name] for name in self.element.data(self.kinds)]

    def value(self, function: str, output: str, **blocks: Any) -> Any:
        """A result, in complex numbers where the blocks have them."""
        values = {"q": self.q, "u": self.u, "udot": self.udot, "p": self.p} | blocks
        complex_ones = any(np.iscomplexobj(x) for x in values.values())
        arithmetic = "complex" if complex_ones else "float"
        return np.array(evaluate(self.functions[function], values, arithmetic)[output])

    def has(self, function: str, output: str) -> bool:
        return function in self.functions and output in {
            o.name for o in self.functions[function].outputs
        }

    def directions(self, block: str) -> list[Array]:
        """Changes of a block at unit increments of every speed."""
        if block != "q":
            return list(np.eye(len(self.u)))
        return [self.rate(du) for du in np.eye(len(self.u))]

    def rate(self, u: Array) -> Array:
        """qdot at speeds u."""
        rates = []
        for node, speed in zip(self.q.reshape(-1, 7), u.reshape(-1, 6), strict=True):
            w, v, half = node[0], node[1:4], 0.5 * speed[:3]
            rates.append(np.r_[-v @ half, w * half + np.cross(v, half), speed[3:]])
        return np.concatenate(rates)

    def along(self, f: Callable[[Array], Any], block: str = "q") -> Array:
        """Derivative of f(block) along its directions by complex steps, one column each."""
        at = getattr(self, block)
        return np.array([f(at + 1j * TINY * d).imag / TINY for d in self.directions(block)]).T

    def turned(self, turn: Rotation, shift: Array) -> State:
        """The same after a rigid motion; ends of nodes only."""
        nodes = self.q.reshape(-1, 7)
        quaternions = quaternion(turn * rotation(nodes[:, :4]))
        q = np.hstack([quaternions, turn.apply(nodes[:, 4:]) + shift])
        poses = tuple((turn * R, turn.apply(p) + shift) for R, p in self.poses)
        return replace(self, q=q.ravel(), poses=poses)


def state(
    element: FlexibleElement,
    kinds: tuple[str, str] = ("node", "node"),
    turn: tuple[float, float, float] = (0.3, -0.5, 0.4),
    seed: int = 1,
    **given: float,
) -> State:
    """An element at rest somewhere, with the rotation ``turn`` from end 1 to end 2."""
    rng = np.random.default_rng(seed)
    names = element.data(kinds)
    numbers = {name: float(rng.uniform(0.5, 1.5)) for name in names} | NUMBERS
    first = Rotation.from_rotvec(rng.normal(size=3)), rng.normal(size=3)
    apart = first[0].apply([1.1, 0.2, -0.1])
    poses = (first, (first[0] * Rotation.from_rotvec(turn), first[1] + apart))
    q: list[Array] = []
    for name, kind, (R, p) in zip(("start", "end"), kinds, poses, strict=True):
        R_node, p_node = R, p
        if kind == "offset":
            R_node, p_node = Rotation.from_rotvec(rng.normal(size=3)), rng.normal(size=3)
        elif kind == "ground":
            R_node, p_node = Rotation.identity(), np.zeros(3)
        if kind != "ground":
            q += [quaternion(R_node), p_node]
        numbers |= _offset(name, R_node.inv() * R, R_node.inv().apply(p - p_node))
    flat = np.concatenate(q)
    size = 6 * (len(flat) // 7)
    u, udot = rng.normal(size=size), rng.normal(size=size)
    functions = dict(element.derived(kinds))
    return State(element, kinds, numbers | given, flat, u, udot, poses, functions)


def _offset(name: str, R: Rotation, p: Array) -> dict[str, float]:
    """Data of an end that is not at a node."""
    entries = R.as_matrix()
    rotations = {f"{name}_R{i + 1}{j + 1}": entries[i, j] for i in range(3) for j in range(3)}
    return rotations | {f"{name}_p{x}": p[k] for k, x in enumerate("xyz")}
