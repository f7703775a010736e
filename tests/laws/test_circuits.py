"""A closed mechanism moves in one way, wherever it is cut and however constraints are treated."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

import cardan as cd
from laws.circuits import (
    EVERY,
    EXACT,
    PLACES,
    accelerations,
    apart,
    compiled,
    exact,
    scene_of,
    start,
)
from mechanisms.closed_spatial import BASE, TOP
from spread import some

# legs and arms are alike: one of each is cut
LIKE = {"stewart": ("hooke0", "slide0", "ball0"), "delta": ("shoulder0", "elbow0", "wrist0")}


@cache
def cuts_of(name: str) -> tuple[str, ...]:
    """The joints of a mechanism that are cut; those that are wanted keep their coordinates."""
    return LIKE.get(name) or tuple(EVERY[name].build().joints)


def cases() -> list[object]:
    """All cuts by all exact treatments; a spread of them by default."""
    every = [(name, joint, way) for name in EVERY for joint in cuts_of(name) for way in EXACT]
    return some(every, 29)


@pytest.mark.parametrize(("name", "joint", "treatment"), cases())
def test_accelerations(name: str, joint: str, treatment: str) -> None:
    """Against bodies in space with an equation for everything that every joint holds."""
    model = compiled(name, joint, treatment)
    assert joint in {cut["name"] for cut in model.manifest["cuts"]}
    for s in PLACES:
        q, u = start(model, name, s)
        assert apart(accelerations(model, q, u), exact(name, s)) < 1e-10


# where motions start, how fast, how long [s]: none comes near a singular position or is chaotic.
# The drive of Andrews' mechanism makes a thousand turns in the time the others have.
MOTIONS = {
    "four_bar": (0.3, 8.0, 5.0),
    "slider_crank": (0.3, 8.0, 5.0),
    "parallelogram": (0.5 - math.pi, 0.0, 5.0),
    "andrews": (0.0, 0.0, 0.03),
    "bricard": (0.3, 0.0, 5.0),
    "delta": (0.1, 0.0, 5.0),
    "stewart": (0.1, 0.0, 5.0),
    "cam": (0.1, 0.0, 5.0),
    "geared": (0.1, 8.0, 5.0),
    "custom": (0.3, 8.0, 5.0),
}
# what else carries parallel robots: without drives they would fall into dead points
SPRINGS = {
    "delta": (("platform", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 400.0, 0.36),),
    "stewart": tuple(
        ("platform", base, top, 900.0, 0.8) for base, top in zip(BASE, TOP, strict=True)
    ),
}


@cache
def moving(name: str, cut: str, treatment: str) -> np.ndarray:
    """Center of mass and momentum of all bodies at six times (6, 9)."""
    scene = scene_of(name, cut)
    for k, (body, below, above, stiffness, length) in enumerate(SPRINGS.get(name, ())):
        ends = scene.ground.at(*below), scene.bodies[body].at(*above)
        scene.force(f"spring{k}", cd.SpringDamper(*ends, stiffness=stiffness, rest_length=length))
    model = cd.compile(cd.derive(scene, constraints=treatment))
    s, rate, end = MOTIONS[name]
    q, u = start(model, name, s, rate)
    motion = model.simulate(np.linspace(0, end, 6), q=q, u=u, rtol=1e-12, atol=1e-13)
    assert motion.success, motion.message
    return np.concatenate([model.com(motion.q), model.momentum(motion.q, motion.u)], axis=1)


@pytest.mark.parametrize(("name", "joint", "treatment"), cases())
def test_motion(name: str, joint: str, treatment: str) -> None:
    expected = moving(name, cuts_of(name)[0], "multipliers")
    size = np.maximum(1.0, np.abs(expected).max(axis=0))
    found = moving(name, joint, treatment)
    np.testing.assert_allclose(found / size, expected / size, rtol=0, atol=1e-8)
