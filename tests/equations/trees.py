"""Random trees as system graphs, made without the model: every number is a parameter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from cardan.elements.joints import Cylindrical, Free, Planar, Prismatic, Revolute, Spherical
from cardan.elements.joints.joint import Joint as JointElement
from cardan.ir.graph import Graph
from cardan.topology.system import Body, Frame, Joint, Parameter, Part, System

EYE = (1, 0, 0, 0, 1, 0, 0, 0, 1)
KINDS: dict[str, type[JointElement]] = {
    "r": Revolute,
    "p": Prismatic,
    "c": Cylindrical,
    "s": Spherical,
    "l": Planar,
    "f": Free,
}


@dataclass(frozen=True)
class Tree:
    """A system with the values of its parameters; rotations are rational, so exactly orthogonal."""

    system: System
    exact: tuple[Fraction, ...]

    @property
    def p(self) -> list[float]:
        return [float(x) for x in self.exact]


class _Maker:
    def __init__(self, rng: np.random.Generator) -> None:
        self.rng, self.graph, self.parameters = rng, Graph(), list[Parameter]()
        self.exact: list[Fraction] = []

    def parameter(self, value: float | Fraction) -> int:
        self.exact.append(Fraction(value))
        self.parameters.append(Parameter(f"p{len(self.parameters)}", float(value), ""))
        return self.graph.var("p", len(self.parameters) - 1)

    def nodes(self, values: object) -> tuple[int, ...]:
        return tuple(self.parameter(v) for v in np.ravel(np.asarray(values, dtype=object)))

    def symmetric(self, x: np.ndarray) -> tuple[int, ...]:
        upper = {(a, b): self.parameter(x[a, b]) for a in range(3) for b in range(a, 3)}
        return tuple(upper[min(a, b), max(a, b)] for a in range(3) for b in range(3))

    def inertia(self) -> tuple[int, tuple[int, ...], tuple[int, ...]]:
        """A physical mass, first moment and tensor about an origin off the center of mass."""
        mass, com = self.rng.uniform(0.5, 2), self.rng.normal(size=3) * 0.3
        root = self.rng.normal(size=(3, 3)) * 0.3
        second = root @ root.T + 0.1 * np.eye(3)
        tensor = np.trace(second) * np.eye(3) - second
        tensor = tensor + mass * (com @ com * np.eye(3) - np.outer(com, com))
        return self.parameter(mass), self.nodes(mass * com), self.symmetric(tensor)


def tree(kinds: str, parents: Sequence[int], seed: int = 0) -> Tree:
    """A tree with one body per letter of ``kinds`` (r p c s l f) and random everything."""
    rng = np.random.default_rng(seed)
    make = _Maker(rng)
    bodies, joints = list[Body](), list[Joint]()
    frames = [Frame("ground", -1, 0, EYE, (0, 0, 0))]
    nq = nu = 0
    for i, (kind, parent) in enumerate(zip(kinds, parents, strict=True)):
        axis = rng.normal(size=3)
        element = KINDS[kind]() if kind in "sf" else KINDS[kind](tuple(axis))
        mass, moment, tensor = make.inertia()
        here = len(frames)
        frames.append(Frame(f"body{i}", i, 0, EYE, (0, 0, 0)))
        frames.append(
            Frame(f"tip{i}", i, 0, make.nodes(_rotation(rng)), make.nodes(rng.normal(size=3)))
        )
        part = Part(f"body{i}", -1, "", mass, moment, tensor, here, here)
        bodies.append(Body(f"body{i}", parent, mass, moment, tensor, (part,)))
        data = {
            name: (3, 1, make.nodes(quantity.value))
            for name, quantity in element.quantities().items()
        }
        turned, placed = make.nodes(_rotation(rng)), make.nodes(rng.normal(size=3))
        joints.append(Joint(f"joint{i}", element, data, 0, here, turned, placed, nq, nu))
        nq, nu = nq + len(element.coordinates), nu + len(element.speeds)
    gravity = make.nodes((0.3, 1.0, -9.81))
    system = System(
        "tree",
        make.graph,
        gravity,
        tuple(bodies),
        tuple(joints),
        tuple(frames),
        (),
        tuple(make.parameters),
        (),
        (),
        {},
        nq,
        nu,
    )
    return Tree(system, tuple(make.exact))


def _rotation(rng: np.random.Generator) -> list[Fraction]:
    """A rational rotation matrix, row by row, from a quaternion of small integers."""
    w, x, y, z = (int(n) for n in rng.integers(-9, 10, size=4))
    n = w * w + x * x + y * y + z * z
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return [Fraction(entry, n) for row in rows for entry in row]


def state(system: System, seed: int) -> dict[str, list[float]]:
    """A random state with unit quaternions, and random udot, tau."""
    rng = np.random.default_rng(seed)
    q: list[float] = []
    for joint in system.joints:
        own = rng.normal(size=len(joint.element.coordinates))
        at = joint.element.quaternion
        if at is not None:
            own[at : at + 4] /= np.linalg.norm(own[at : at + 4])
        q += list(own)
    values = {name: list(rng.normal(size=system.nu)) for name in ("u", "udot", "tau", "du")}
    parts = sum(len(body.parts) for body in system.bodies)
    return {"t": [0.3], "q": q, "r": [], "q0": q, "wrench": [0.0] * 6 * parts, **values}


TREES = {
    "chain": tree("rprcr", (-1, 0, 1, 2, 3), seed=1),
    "branched": tree("rsrpl", (-1, 0, 0, 1, 2), seed=2),
    "floating": tree("frsr", (-1, 0, 0, 1), seed=3),
    "two roots": tree("cfr", (-1, -1, 1), seed=4),
}
