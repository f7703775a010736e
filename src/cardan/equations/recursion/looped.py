"""Choose the functions written as loops over the bodies, and the bodies of their results."""

from __future__ import annotations

from collections.abc import Callable

from ...ir.function import Function
from ...ir.recursion import Recursion
from ...topology.system import System
from ..kinematics.kinematics import Kinematics
from .angle_sweep import angles_first
from .folded import Fold, fold
from .steps import recursion
from .sweeps import LATER, LEFT_OUT, Sweeps

# bodies above which loops are written, and how often a step must be used at least: measured on
# chains, loops run 5 % slower and compile ten times faster at 100 bodies
LOOPED, REPEATED = 60, 4
# those whose results belong to single joints
FOLDED = (
    "rhs",
    "forward_dynamics",
    "inverse_dynamics",
    "bias",
    "gravity",
    "coriolis",
    "applied_forces",
    "qdot",
)
# those whose results are sums over all bodies, which are complete at the first
SUMMED = ("energy", "com", "momentum")


def repeats(recursion: Recursion) -> bool:
    """True when enough bodies are alike for loops to be shorter."""
    visits = sum(len(sweep) for sweep in recursion.sweeps)
    return visits >= REPEATED * len(recursion.steps)


def homes(
    system: System, function: Function, fold: Fold | None = None, other: int = LATER
) -> list[int]:
    """Body at whose visit every entry of the results is computed.

    Args:
        system: The tree.
        function: The results.
        fold: How the tree was shortened: entries of bodies left out have none.
        other: Body of entries that belong to no joint.
    """
    missing = LATER if fold is None else LEFT_OUT
    q, u = [missing] * system.nq, [missing] * system.nu
    for i, joint in enumerate((fold.system if fold else system).joints):
        if joint.q >= 0:
            for slots, first, count in (
                (q, joint.q, len(joint.element.coordinates)),
                (u, joint.u, len(joint.element.speeds)),
            ):
                slots[first : first + count] = [i] * count
    homes: list[int] = []
    for o in function.outputs:
        like = next((x for x in (q, u) if o.shape == (len(x),)), None)
        homes += [other] * o.size if like is None else like
    return homes


def by_bodies(system: System, derive: Callable[[Kinematics], Function], name: str) -> Recursion:
    """A function as a recursion over the bodies; of bodies that repeat only a few are derived.

    Args:
        system: The tree.
        derive: Makes the function from the kinematics of a tree.
        name: Of the function.
    """
    short = fold(system) if name in FOLDED or name in SUMMED else None
    other = 0 if name in SUMMED and system.bodies else LATER
    for folded in (short, None) if short is not None else (None,):
        k = Kinematics(folded.system if folded else system, cut=True)
        function = derive(k)
        assert k.cuts is not None
        home_bodies = homes(system, function, folded, other)
        looped = recursion(Sweeps(k.cuts, function, home_bodies, k.system, folded))
        if looped is not None:
            return angles_first(looped)
    raise AssertionError("a tree that is not folded has its visits")
