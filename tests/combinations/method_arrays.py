"""Scenes in which every two features meet each integrator that has equations for both."""

from __future__ import annotations

from cardan.schema.integrators import INTEGRATORS

from .covering import covering
from .features import FEATURES, PRESENT, closed

# more of a scene than in the array of the scenes: each is derived once and run by all methods
SIZE = 12
DECISIONS = ("Coulomb friction", "friction from reaction", "stop", "latch")
LOOPS = ("loop", "second loop", "redundant loop")
# what EnergyMomentum takes: nothing in them takes or gives energy
CONSERVATIVE = (
    *("revolute", "spherical", "universal", "gear coupling", "input jump", "gravity field"),
    *(*LOOPS, "event", "time event", "superelement"),
)
# features that a method refuses, each for the reason in the list of refusals
REFUSED: dict[str, tuple[str, ...]] = {
    "Newmark": ("wheel", *DECISIONS, *LOOPS, "superelement"),
    "EnergyMomentum": tuple(name for name in FEATURES if name not in CONSERVATIVE),
}
# one that it takes, and with which others it does not: where bodies have nodes, a base that moves
# them is bound by constraints
EXCLUDED: dict[str, tuple[str, tuple[str, ...]]] = {
    "Newmark": ("moving base", ("line load", "beam"))
}
# increments of poses are those of absolute coordinates
COORDINATES = {"EnergyMomentum": "absolute"}

Scenes = tuple[tuple[str, ...], ...]


def _array(method: str) -> Scenes:
    """Few scenes with every pair that a method takes."""
    names = [name for name in PRESENT if name not in REFUSED.get(method, ())]
    feature, partners = EXCLUDED.get(method, ("", ()))
    scenes = covering([name for name in names if name != feature], SIZE, closed)
    if feature:
        scenes_of_feature = covering([name for name in names if name not in partners], SIZE, closed)
        scenes += [scene for scene in scenes_of_feature if feature in scene]
    return tuple(scenes)


ARRAYS: dict[str, Scenes] = {method: _array(method) for method in INTEGRATORS}
