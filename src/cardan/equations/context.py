"""What the builders of functions work with, and what is known about a function."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..errors import DerivationError, near
from ..ir.function import Output
from ..ir.matrix import Matrix
from ..topology.system import System
from .dynamics import Dynamics
from .kinematics import Kinematics


def frame_number(system: System, name: str) -> int:
    """Index of a frame by its name.

    Raises:
        DerivationError: no such frame.
    """
    for i, frame in enumerate(system.frames):
        if frame.name == name:
            return i
    names = [f.name for f in system.frames]
    raise DerivationError(f"frame '{name}' does not exist.{near(name, names)}")


@dataclass(frozen=True)
class Context:
    """What a builder works with.

    Attributes:
        d: The dynamics, underived.
        names, units: Of the entries of every input block, and of ``qdot``.
        of: The frame or joint asked for.
    """

    d: Dynamics
    names: dict[str, tuple[str, ...]]
    units: dict[str, tuple[str, ...]]
    of: str | None = None

    @property
    def k(self) -> Kinematics:
        return self.d.k

    @property
    def udot(self) -> Matrix:
        """The block udot as a vector."""
        return self.d.block("udot", self.k.system.nu)

    @property
    def frame(self) -> int:
        return frame_number(self.k.system, self.of or "")

    def vector(self, name: str, x: Matrix, like: str) -> tuple[Output, ...]:
        """A result with the names and units of an input block."""
        return (Output(name, (x.rows,), x.nodes, self.names[like], self.units[like]),)


Builder = Callable[[Context], tuple[Output, ...]]


@dataclass(frozen=True)
class Recipe:
    """How a function comes about.

    Attributes:
        about: One line for the reader.
        build: Its builder.
        of: What ``of`` names.
        told: Whether it is the same in whatever frames and by whatever grouping of inertia the
            bodies are told.
        bound: Whether there is one only of systems with constraints.
        solved: Whether there is one only of systems with circuits in closed form.
        moves: Whether it moves coordinates along the speeds of the joints, whatever speeds the
            user chose.
        happens: Whether there is one only of systems with events.
    """

    about: str
    build: Builder
    of: str = ""
    told: bool = False
    bound: bool = False
    solved: bool = False
    moves: bool = False
    happens: bool = False
