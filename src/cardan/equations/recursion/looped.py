"""Choose the functions written as loops over the bodies, and the bodies of their results."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from ...errors import DerivationError
from ...ir.function import Function
from ...ir.recursion import Recursion
from ...topology.system import System
from ..kinematics.kinematics import Kinematics
from .angle_sweep import angles_first
from .common_forms import Forms
from .recursion_boundary import Cuts
from .representatives import Representatives, representatives
from .steps import recursion
from .sweeps import LATER, LEFT_OUT, Sweeps

# bodies above which loops are written, and how often a step must be used at least: measured on
# chains, loops run 5 % slower and compile ten times faster at 100 bodies
LOOPED, REPEATED = 60, 4
# forms of what bodies hand on are known after as many derivations as there are steps on which they
# depend, which are few
MOST_DERIVATIONS = 20
# those whose results belong to single joints
BY_JOINTS = (
    "rhs",
    "forward_dynamics",
    "inverse_dynamics",
    "bias",
    "gravity",
    "coriolis",
    "applied_forces",
    "qdot",
)
# the block in whose order their results are
ORDERED = {"qdot": "q"} | dict.fromkeys(("udot", "tau", "h", "gravity", "coriolis", "f"), "u")
# those whose results are sums over all bodies, which are complete at the first
SUMMED = ("energy", "com", "momentum")


def repeats(recursion: Recursion) -> bool:
    """True when enough bodies are alike for loops to be shorter."""
    visits = sum(len(sweep) for sweep in recursion.sweeps)
    return visits >= REPEATED * len(recursion.steps)


def homes(system: System, function: Function, other: int = LATER) -> list[int]:
    """Body at whose visit every entry of the results is computed.

    Args:
        system: The tree; of a large one the representatives.
        function: The results.
        other: Body of entries that belong to no joint.
    """
    places: list[int] = []
    for o in function.outputs:
        letter = ORDERED.get(o.name, "")
        if not letter:
            places += [other] * o.size
            continue
        slots = [LEFT_OUT] * o.size
        for i, joint in enumerate(system.joints):
            first = getattr(joint, letter)
            parts = joint.element.coordinates if letter == "q" else joint.element.speeds
            if first >= 0:
                slots[first : first + len(parts)] = [i] * len(parts)
        places += slots
    return places


def by_bodies(system: System, derive: Callable[[Kinematics], Function], name: str) -> Recursion:
    """A function as a recursion over the bodies; of bodies that are alike only one is derived.

    Args:
        system: The tree.
        derive: Makes the function from the kinematics of a tree.
        name: Of the function.
    """
    other = 0 if name in SUMMED and system.bodies else LATER
    few = representatives(system) if name in BY_JOINTS or name in SUMMED else None
    try:
        looped = _by_representatives(few, derive, other) if few is not None else None
    except DerivationError:
        # a body without inertia next to the ground or at a tip of the small tree may have some
        # outboard in the large one, which says whether it does
        looped = None
    if looped is None:
        k = Kinematics(system, cut=Cuts)
        function = derive(k)
        assert k.cuts is not None
        looped = recursion(Sweeps(k.cuts, function, homes(system, function, other), system))
    assert looped is not None
    return angles_first(looped)


def _by_representatives(
    few: Representatives, derive: Callable[[Kinematics], Function], other: int
) -> Recursion | None:
    """A function of all bodies from that of their representatives; None where they differ in more
    than names.
    """
    k = Kinematics(few.system, cut=partial(Cuts, every=True))
    function = derive(k)
    assert k.cuts is not None
    places = homes(few.system, function, other)
    results = zip(places, function.roots, strict=True)
    read = k.cuts.read_elsewhere([(body, i) for body, i in results if body != LEFT_OUT])
    forms = Forms(read, few.formed)
    for _ in range(MOST_DERIVATIONS):
        k = Kinematics(few.system, cut=partial(Cuts, forms=forms))
        function = derive(k)
        if forms.settled():
            assert k.cuts is not None
            firsts = [few.slots.get(ORDERED.get(o.name, "")) for o in function.outputs]
            return recursion(Sweeps(k.cuts, function, places, few.system, few), firsts)
        forms = forms.further()
    return None
