"""Which functions are written as loops over the bodies, and where their results arise."""

from __future__ import annotations

from ..ir.function import Function
from ..ir.recursion import Recursion
from ..topology.system import System
from .sweeps import LATER

# bodies above which loops are written, and how often a step must be used at least: measured on
# chains, loops run 5 % slower and compile ten times faster at 100 bodies
LOOPED, REPEATED = 60, 4
# what a recursion over the bodies gives; udot where the formalism eliminates body by body
LOOPS = (
    "inverse_dynamics",
    "bias",
    "gravity",
    "coriolis",
    "applied",
    "qdot",
    "energy",
    "com",
    "momentum",
)
FORWARD_LOOPS = ("rhs", "forward_dynamics", "outputs", "power")


def looped(method: str, name: str) -> bool:
    """Whether a formalism gives a function as a recursion."""
    if method == "kane":
        return False
    return name in (FORWARD_LOOPS if method == "articulated" else ()) + LOOPS


def repeats(recursion: Recursion) -> bool:
    """Whether enough bodies are alike for loops to be shorter."""
    visits = sum(len(sweep.visits) for sweep in recursion.sweeps)
    return visits >= REPEATED * len(recursion.steps)


def homes(system: System, function: Function) -> list[int]:
    """Body at whose visit every entry of the results is computed."""
    q, u = [LATER] * system.nq, [LATER] * system.nu
    for i, joint in enumerate(system.joints):
        if joint.q >= 0:
            for slots, first, count in (
                (q, joint.q, len(joint.element.coordinates)),
                (u, joint.u, len(joint.element.speeds)),
            ):
                slots[first : first + count] = [i] * count
    homes: list[int] = []
    for o in function.outputs:
        like = next((x for x in (q, u) if o.shape == (len(x),)), None)
        homes += [LATER] * o.size if like is None else like
    return homes
