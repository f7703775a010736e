"""Choose the coordinates of ``coordinates="auto"``.

Flexible parts need nodes. Of rigid bodies joint coordinates have the fewest unknowns, but long or
many loops tie all of them together: eliminating them takes operations that grow with the cube of
their number, and so does the code. There body motions and joint forces stay unknowns of one sparse
system, whose code does not grow.
Source: D. Baraff, Linear-time dynamics using Lagrange multipliers, SIGGRAPH 1996; H. Brandl,
R. Johanni, M. Otter, An algorithm for the simulation of multibody systems with kinematic loops,
World Congress on the Theory of Machines and Mechanisms, 1987.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import TYPE_CHECKING

from ..errors import counted
from ..schema.functions import OF_ELEMENTS, STANDARD
from ..topology.system import System

if TYPE_CHECKING:
    from ..scene.scene import SceneRecord

# speeds in one loop, and in all of them, above which elements are taken: measured on chains and
# rows of four-bars, whose code is compiled for longer than a run takes
LONG_LOOP, LOOPED = 16, 60


def element_reason(system: System) -> str:
    """Why a system is derived element by element, "" where it has joint coordinates."""
    if system.segments:
        return counted(len(system.segments), "beam")
    # elements have neither written equations nor friction that follows from reactions
    if system.written or any(force.element.by_reaction for force in system.forces):
        return ""
    loops = [{number for number, _ in cut.path} for cut in system.cuts]
    longest = max((_speeds(system, loop) for loop in loops), default=0)
    if longest > LONG_LOOP:
        return f"a loop with {counted(longest, 'speed')}"
    every = _speeds(system, set().union(*loops))
    return f"loops with {counted(every, 'speed')}" if every > LOOPED else ""


def _speeds(system: System, numbers: Iterable[int]) -> int:
    """Number of the speeds of some joints."""
    joints = (system.joints[number] for number in numbers)
    return sum(len(joint.element.speeds) for joint in joints if joint.u >= 0)


def coordinates_with(scene: SceneRecord, functions: Collection[str]) -> str | None:
    """The coordinates that have functions which elements lack, None where any kind will do."""
    if scene.beams or functions is STANDARD:
        return None
    requested = {functions} if isinstance(functions, str) else {*functions}
    return None if requested <= {*OF_ELEMENTS} else "relative"
