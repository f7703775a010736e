"""Reactions hold every body as Newton and Euler say, whichever joint closes the loop."""

from __future__ import annotations

from itertools import cycle

import numpy as np
import pytest

import cardan as cd
from laws.circuits import EVERY, EXACT, PLACES, accelerations, compiled, start
from laws.maximal import Array, Maximal
from mechanisms.carried import CARRIED, PLAIN
from spread import some

MEMBERS = [*CARRIED, "four_bar", "slider_crank"]


def cases() -> list[object]:
    """All cuts, each by one of the exact treatments; a spread of them by default."""
    joints = [(name, joint) for name in MEMBERS for joint in EVERY[name].build().joints]
    ways = cycle(EXACT)
    return some(((name, joint, way) for (name, joint), way in zip(joints, ways, strict=False)), 4)


def moving(model: cd.CompiledModel, bodies: Maximal, q: Array, u: Array) -> tuple[dict, Array]:
    """Poses of the bodies, and their twists about their centers of mass (6 n)."""
    poses, twists = {}, []
    for body in bodies.bodies:
        pose, twist = model.pose(body.name, q), model.velocity(body.name, q, u)
        poses[body.name] = pose[:3, :3], pose[:3, 3]
        arm = pose[:3, :3] @ np.asarray(body.com, float)
        twists += [twist[:3], twist[3:] + np.cross(twist[:3], arm)]
    return poses, np.concatenate(twists)


def held(model: cd.CompiledModel, bodies: Maximal, poses: dict, q: Array, u: Array) -> Array:
    """What all joints do to the bodies (6 n), about their centers of mass in ground axes."""
    total = np.zeros(6 * len(bodies.bodies))
    for joint in bodies.scene.joints.values():
        wrench = model.reaction(joint.name, q, u)
        rotation, point = bodies.frame(poses, joint.child)
        moment, force = rotation @ wrench[:3], rotation @ wrench[3:]
        bodies.push(total, joint.child, poses, moment, point, force)
        bodies.push(total, joint.parent, poses, -moment, point, -force)
    return total


@pytest.mark.parametrize(("name", "cut", "treatment"), cases())
def test_reactions(name: str, cut: str, treatment: str) -> None:
    model, bodies = compiled(name, cut, treatment), Maximal(PLAIN.get(name, EVERY[name].build)())
    for s in PLACES:
        q, u = start(model, name, s)
        poses, twists = moving(model, bodies, q, u)
        change = []
        for body, center in bodies.centers(poses).items():
            angular, linear = np.split(accelerations(model, q, u)[body], 2)
            turning = twists[bodies.slot[body] :][:3]
            spread = np.cross(angular, center) + np.cross(turning, np.cross(turning, center))
            change += [angular, linear + spread]
        mass, load = bodies.loads(poses, twists)
        wanted = mass @ np.concatenate(change) - load
        found = held(model, bodies, poses, q, u)
        # multipliers are accelerations times masses: as exact as those
        assert np.abs(found - wanted).max() < 1e-10 * np.abs(wanted).max()
