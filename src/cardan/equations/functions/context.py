"""Context of the builders of functions, and the list of builders."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field, replace

from ...errors import DerivationError, near
from ...ir.function import Block, Output
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...records import dataclass
from ...schema.functions import FUNCTIONS
from ...topology.system import System
from ..constraints.reaction_friction import friction_forces, solved
from ..kinematics.kinematics import Kinematics
from .dynamics import Dynamics


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
    """Context of a builder.

    Attributes:
        d: The dynamics, underived.
        names, units: Of the entries of every input block, and of ``qdot``.
        of: The frame or joint asked for.
        extra_blocks: Blocks of this function alone, by letter; its recipe puts them there.
    """

    d: Dynamics
    names: dict[str, tuple[str, ...]]
    units: dict[str, tuple[str, ...]]
    of: str | None = None
    extra_blocks: dict[str, Block] = field(default_factory=dict)

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

    def with_friction_at(self, udot: Matrix) -> None:
        """Let friction that follows from reactions be that at given accelerations."""
        if friction_forces(self.k.system):
            zero_tau = Matrix.zeros(self.k.graph, self.k.system.nu)
            self.d.friction_forces = solved(self.d, zero_tau, udot)

    def vector(self, name: str, x: Matrix, like: str) -> tuple[Output, ...]:
        """A result with the names and units of an input block."""
        return (Output(name, (x.rows,), x.nodes, self.names[like], self.units[like]),)


Builder = Callable[[Context], tuple[Output, ...]]


# of every function of the table, by name
RECIPES: dict[str, Builder] = {}


def recipe(builder: Builder) -> Builder:
    """Let a builder derive the function of its name."""
    assert builder.__name__ in FUNCTIONS, f"the table has no function {builder.__name__}"
    RECIPES[builder.__name__] = builder
    return builder


def settled(c: Context, results: tuple[Output, ...]) -> tuple[Output, ...]:
    """Results with the friction that follows from reactions, at the model's own forces if no others
    were spoken of."""
    if not friction_forces(c.k.system):
        return results
    if not c.d.friction_forces.values:
        c.d.forward(Matrix.zeros(c.k.graph, c.k.system.nu))
    graph, values = c.k.graph, c.d.friction_forces.values
    return tuple(
        replace(output, nodes=tuple(rebuild(graph, output.nodes, values, into=graph)[1]))
        for output in results
    )
