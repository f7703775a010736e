"""Warnings about a complete system, given when it is built."""

from __future__ import annotations

from collections.abc import Sequence
from math import dist

from ..elements.forces.force import constant
from ..errors import ModelWarning, warn
from ..ir.matrix import Matrix
from ..scene.origins import place_of
from ..scene.scene import SceneRecord
from .conversion import Converter
from .loops.circuits import HERE, Numbers, Pose, circuit
from .system import Cut, Force, Frame, Joint

MEET = 1e-9  # of the free length of a spring: its ends are at one point


def warn_about(text: str, model: SceneRecord, category: type[ModelWarning] = ModelWarning) -> None:
    """Warn, with the place in its file of what the text names first."""
    place = place_of(text, model.origins)
    warn(f"{place}: {text}" if place else text, category)


def check_concurrent_forces(
    model: SceneRecord,
    forces: Sequence[Force],
    frames: Sequence[Frame],
    joints: Sequence[Joint],
    parents: Sequence[int],
    cuts: Sequence[Cut],
    convert: Converter,
) -> None:
    """Warn of springs that push where their ends meet, in which they have no direction.

    Where they start is known of joints that move by themselves: what is prescribed, follows others
    or closes a loop is found when a run starts.

    Args:
        model: The scene.
        forces, frames, joints, parents, cuts: Of the system.
        convert: Knows the default parameters.
    """
    springs = [force for force in forces if force.element.straight()]
    if not springs:
        return
    numbers = Numbers(convert)
    elsewhere = {i for cut in cuts for i, _ in cut.path}
    elsewhere |= {i for i, j in enumerate(joints) if j.motion is not None or j.coupling is not None}
    steps = dict[int, Pose]()
    for force in springs:
        push = _push(force, numbers)
        if not push:
            continue
        ends = [frames[force.frames[role]] for role in ("a", "b")]
        base, path = circuit(parents, ends[0].body, ends[1].body)
        if elsewhere & {i for i, _ in path}:
            continue
        at = {base: HERE}
        for i, _ in path:
            if i not in steps:
                steps[i] = numbers.start(joints[i])
            at[i] = at[parents[i]].then(steps[i])
        one, other = (at[e.body].then(numbers.pose(e.rotation, e.position)).position for e in ends)
        if dist(one, other) <= MEET * abs(numbers.values(*force.data["rest_length"][2])[0]):
            warn_about(
                f"force '{force.name}' ({force.element.kind}): its ends meet where the motion "
                f"starts, so that its force there, {push:g} N, has no direction: none acts, or one "
                "along what rounding leaves. Start elsewhere (q0=), move one of the ends, or give "
                "rest_length=0",
                model,
            )


def _push(force: Force, numbers: Numbers) -> float:
    """The force of a straight spring at length 0, as far as parameters tell [N]."""
    quantities = [force.data[name][2] for name in ("stiffness", "rest_length")]
    if not all(constant(Matrix(numbers.graph, len(nodes), 1, nodes)) for nodes in quantities):
        return 0.0
    stiffness, length = (float(numbers.values(*nodes)[0]) for nodes in quantities)
    return abs(stiffness * length)


def check_prescribed(model: SceneRecord, joints: Sequence[Joint], cuts: Sequence[Cut]) -> None:
    """Warn of loops in which more joints are prescribed than the loop has freedoms.

    Their number is that of the joints less the closing conditions that are independent on the
    group of the loop; where that leaves none, only the lengths say whether it moves.

    Args:
        model: The scene.
        joints, cuts: Of the system.
    """
    for cut in cuts:
        around = [joints[i] for i, _ in cut.path]
        moved = [joint.name for joint in around if joint.motion is not None]
        freedoms = sum(len(joint.element.speeds) for joint in around) - len(cut.rows)
        follow = any(model.joints[j.name].couple for j in around if j.name in model.joints)
        if len(moved) > freedoms >= 1 and not follow:
            names = ", ".join(f"'{name}'" for name in moved)
            ring = ", ".join(f"'{name}'" for name in dict.fromkeys(j.name for j in around))
            ways = "1 freedom" if freedoms == 1 else f"{freedoms} freedoms"
            warn_about(
                f"joints {names} are prescribed, but the loop of {ring} that joint "
                f"'{cut.name}' closes has {ways}: unless their motions agree at all times, no run "
                "stays closed. Leave out prescribed= of one of them",
                model,
            )
