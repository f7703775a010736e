"""Interface of the formalisms: each part of M udot + h = f + tau."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field

from ...ir.matrix import Matrix
from ...records import dataclass
from ...topology.rewrites import REWRITES
from ...topology.system import System
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads

# functions that a recursion over the bodies gives, where M is not solved with
RECURSIONS = (
    "inverse_dynamics",
    "bias",
    "gravity",
    "coriolis",
    "applied_forces",
    "qdot",
    "energy",
    "com",
    "momentum",
)


def every(system: System) -> tuple[str, ...]:
    """All rewrites of the system graph."""
    return tuple(REWRITES)


def within_bodies(system: System) -> tuple[str, ...]:
    """Formalisms that keep vectors in axes that rotate with their bodies."""
    return tuple(name for name in REWRITES if name != "parallel")


@dataclass(frozen=True)
class Formalism:
    """A way to the equations of motion of a tree, with what binds it left to others.

    Coupled and prescribed joints, chosen speeds and loops in closed form stand in the kinematics
    that every function is given, and so do massless bodies. Constraints are put to M, h and f
    afterwards, by a treatment.

    Attributes:
        name: As ``derive(method=...)`` takes it.
        about: What it does, in a few words.
        source: Author, title and chapter.
        mass_matrix: (k, loads) -> M (nu, nu); of the loads the rotors count.
        bias: (k, loads, gravity, moving) -> h (nu, 1); of the loads the rotors count, gravity is
            (3, 1) in ground axes, without ``moving`` speeds and prescribed motions rest.
        forces: (k, loads) -> f (nu, 1).
        inverse: (k, udot, loads, gravity) -> tau (nu, 1) with M udot + h = f + tau; None: M, h and
            f are put together.
        forward: (k, tau, loads, gravity) -> udot (nu, 1) without M; None: M is solved with.
        rewrites: Of the system graph, which are tried unless others are asked for.
        refused: Rewrites that it does not take.
        loops: Functions that it gives as a recursion over the bodies.
        binds: Whether it takes constraints.
        couples: Whether it takes joints that follow others.
        chooses: Whether it takes speeds that the user chose.
    """

    name: str
    about: str
    source: str
    mass_matrix: Callable[[Kinematics, Loads], Matrix]
    bias: Callable[[Kinematics, Loads, Matrix, bool], Matrix]
    forces: Callable[[Kinematics, Loads], Matrix]
    inverse: Callable[[Kinematics, Matrix, Loads, Matrix], Matrix] | None = None
    forward: Callable[[Kinematics, Matrix, Loads, Matrix], Matrix] | None = None
    rewrites: Callable[[System], tuple[str, ...]] = field(default=every)
    refused: tuple[str, ...] = ()
    loops: tuple[str, ...] = ()
    binds: bool = True
    couples: bool = True
    chooses: bool = True
