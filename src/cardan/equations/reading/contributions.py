"""Contributions to the equations: M, h and f as sums over bodies and force elements.

M and h are linear in the masses, first moments and inertias of all bodies together, f is the sum of
what the elements do. The part of one body is therefore what is left where all others are without
mass, that of one element what is left without the others: nothing has to be taken apart again.

Source: Gautier and Khalil, Direct Calculation of Minimum Set of Inertial Parameters of Serial
Robots, IEEE Trans. Robotics and Automation 6 (1990): dynamics linear in the inertial parameters.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from ...errors import DerivationError, near
from ...ir.function import Function, Output
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...processes import collector_paused
from ...records import dataclass
from ...topology.system import Body, Nodes, Part, System
from ..functions.dynamics import Dynamics
from ..kinematics.kinematics import Kinematics

if TYPE_CHECKING:
    import sympy

    from ..record import EquationRecord

NOTHING: Nodes = (ZERO,) * 9
LETTERS = {"mass_matrix": "M", "bias": "h", "applied_forces": "f"}
INERTIA, VELOCITIES, WEIGHT = "inertia", "velocities", "weight"
ROTOR, FORCE = "rotor", "force"


@dataclass(frozen=True)
class Contribution:
    """Contribution of one body or force element to M, h or f.

    Attributes:
        owner: Name of the body, or of the force element.
        cause: ``"inertia"`` or ``"rotor"`` in M; ``"velocities"``, ``"weight"`` or ``"rotor"`` in
            h; ``"force"`` in f.
        function: Its part, in the shape of the whole.
    """

    owner: str
    cause: str
    function: Function

    @cached_property
    def matrix(self) -> sympy.Matrix:
        """Its part as a SymPy matrix.

        Raises:
            DerivationError: an entry is too long to write out.
        """
        from ...ir.forms.readable import TooLong, readable

        try:
            return readable(self.function)
        except TooLong as problem:
            raise DerivationError(
                f"what '{self.owner}' contributes has an entry of {problem.operations:,} "
                "operations: too long to write out"
            ) from problem


def contributions(equations: EquationRecord, name: str) -> tuple[Contribution, ...]:
    """Everything that a matrix of the equations is the sum of.

    Args:
        equations: Their method does not matter: M, h and f are the same by all.
        name: ``"mass_matrix"``, ``"bias"`` or ``"applied_forces"``.

    Returns:
        In the order of bodies and force elements; whatever contributes nothing is left out.

    Raises:
        DerivationError: another name.
    """
    if name not in LETTERS:
        names = ", ".join(LETTERS)
        raise DerivationError(
            f"contributions are known of {names}, not of '{name}'.{near(name, LETTERS)}"
        )
    with collector_paused():
        parts = [
            Contribution(owner, cause, _function(equations, name, k, part))
            for owner, cause, k, part in _parts(equations, name)
        ]
    return tuple(one for one in parts if any(one.function.roots))


def _function(equations: EquationRecord, name: str, k: Kinematics, part: Matrix) -> Function:
    rows = part.columns if name == "mass_matrix" else 1
    shape = (rows, rows) if name == "mass_matrix" else (part.rows,)
    output = Output(LETTERS[name], shape, part.nodes)
    return Function(LETTERS[name], k.graph, tuple(equations.blocks.values()), (output,))


def _parts(equations: EquationRecord, name: str) -> Iterator[tuple[str, str, Kinematics, Matrix]]:
    """Owner, cause, and the part as expressions of a system in which nothing else has mass."""
    system = equations.system
    if name == "applied_forces":
        for force in system.forces:
            d = _alone(equations, replace(system, forces=(force,)))
            yield force.name, FORCE, d.k, d.forces()
        return
    for i, body in enumerate(system.bodies):
        for part in body.parts:
            d = _alone(equations, _only(system, i, part))
            if name == "mass_matrix":
                yield part.name, INERTIA, d.k, d.mass_matrix
            else:
                yield part.name, VELOCITIES, d.k, d.bias(gravity=False)
                yield part.name, WEIGHT, d.k, d.bias(moving=False)
    for force in system.forces:
        d = _alone(equations, replace(system, bodies=_massless(system), forces=(force,)))
        yield force.name, ROTOR, d.k, d.mass_matrix if name == "mass_matrix" else d.bias()


def _alone(equations: EquationRecord, system: System) -> Dynamics:
    return Dynamics(Kinematics(system, equations.chosen), "kane")


def _massless(system: System) -> tuple[Body, ...]:
    return tuple(
        replace(body, mass=ZERO, first_moment=NOTHING[:3], inertia=NOTHING, second_moment=None)
        for body in system.bodies
    )


def _only(system: System, i: int, part: Part) -> System:
    """The system in which this part of a body has mass, and nothing else."""
    bodies = list(_massless(system))
    bodies[i] = replace(
        bodies[i], mass=part.mass, first_moment=part.first_moment, inertia=part.inertia
    )
    return replace(system, bodies=tuple(bodies), forces=())
