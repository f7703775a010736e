"""The table of features: how each is added to the mechanism, and what it must change."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

import cardan as cd

from . import controllers, forces, joints, structures
from .mechanism import Mechanism, outputs, trunk

Add = Callable[[Mechanism, bool], None]


@dataclass(frozen=True)
class Feature:
    """What a scene may have.

    Attributes:
        name: Its name.
        group: Its part of the table.
        add: Adds it to a mechanism; with False the same masses without the feature.
        requires: Features without which it cannot be.
        effect: What it changes: ``"motion"``, or ``"events"`` where it only records.
        before: Added before the others: 0 under the mechanism, 1 in the chain, 2 beside it,
            3 when all masses are there.
    """

    name: str
    group: str
    add: Add = field(repr=False)
    requires: tuple[str, ...] = ()
    effect: str = "motion"
    before: int = 2


FEATURES: dict[str, Feature] = {
    feature.name: feature
    for feature in (
        Feature("revolute", "joints", joints.revolute, before=1),
        Feature("prismatic", "joints", joints.prismatic, before=1),
        Feature("spherical", "joints", joints.spherical, before=1),
        Feature("free", "joints", joints.free),
        Feature("universal", "joints", joints.universal, before=1),
        Feature("wheel", "joints", joints.wheel),
        Feature("gear coupling", "joints", joints.gear),
        Feature("custom", "joints", joints.custom, before=1),
        Feature("spring-damper", "forces", forces.spring_damper),
        Feature("torsion spring", "forces", forces.torsion_spring),
        Feature("elastic drive", "forces", forces.elastic_drive),
        Feature("table", "forces", forces.table),
        Feature("bushing", "forces", forces.bushing),
        Feature("line load", "forces", forces.line_load, requires=("beam",)),
        Feature("Coulomb friction", "forces", forces.coulomb),
        Feature("friction from reaction", "forces", forces.reaction_friction),
        Feature("PID", "states", controllers.pid),
        Feature("actuator lag", "states", controllers.actuator),
        Feature("Maxwell", "states", controllers.maxwell),
        Feature("motor current", "states", controllers.motor_current),
        Feature("sampled PID", "states", controllers.sampled_pid),
        Feature("stop", "events", controllers.stop),
        Feature("latch", "events", controllers.latch),
        Feature("contact", "events", controllers.contact),
        Feature("event", "events", controllers.event, effect="events"),
        Feature("time event", "events", controllers.time_event),
        Feature("input jump", "events", controllers.input_jump),
        Feature("loop", "structure", structures.loop),
        Feature("second loop", "structure", structures.second_loop),
        Feature("redundant loop", "structure", structures.redundant_loop),
        Feature("beam", "structure", structures.beam, before=1),
        Feature("superelement", "structure", structures.superelement, before=1),
        Feature("cable", "structure", structures.cable),
        Feature("prescribed motion", "structure", structures.prescribed_motion),
        Feature("moving base", "structure", structures.moving_base, before=0),
        Feature("gravity field", "structure", structures.gravity_field, before=3),
    )
}
PRESENT = tuple(FEATURES)


def closed(names: Iterable[str]) -> tuple[str, ...]:
    """Features with all that they require, in the order of the table."""
    every = set(names)
    for name in tuple(every):
        every |= {*FEATURES[name].requires}
    return tuple(name for name in FEATURES if name in every)


def mechanism(
    names: Iterable[str], without: str | None = None, by_conditions: bool = False
) -> Mechanism:
    """A scene with features; ``without`` one of them, of which the masses stay."""
    every = closed(names)
    # those under the mechanism first, then its chain, then what hangs beside it
    order = sorted(every, key=lambda name: FEATURES[name].before)
    scene = cd.Scene("combination", gravity=(0, 0, -9.81))
    made = Mechanism(scene, scene.ground, by_conditions=by_conditions)
    below = [name for name in order if FEATURES[name].before == 0]
    for name in below:
        FEATURES[name].add(made, name != without)
    trunk(made)
    for name in order[len(below) :]:
        FEATURES[name].add(made, name != without)
    outputs(made)
    return made
