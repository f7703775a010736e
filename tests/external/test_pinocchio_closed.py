"""Closed mechanisms against Pinocchio's constrained dynamics, rate feedback switched off.

Dependent rows are no obstacle to it: its proximal iteration ends at the accelerations that all of
them allow. What is compared is unique.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import cardan as cd
from cardan.peers.circuits import circuits
from cardan.scene.files import mjcf, urdf
from external.closed import Constrained
from mechanisms.closed import CLOSED, Closed
from scene import test_urdf_loops as loops
from scene.mjcf_texts import linkage
from spread import some

TOLERANCE = 1e-9
SEED, PLACES = 3, (-0.5, 0.0, 0.1, 0.4)
FUNCTIONS = ("forward_dynamics", "applied_forces", "close_position", "close_velocity")


def agreement(model: cd.CompiledModel, q: np.ndarray, u: np.ndarray) -> np.ndarray:
    """max|difference| / max|udot| by state, with random forces along the joints."""
    found = circuits(model)
    assert not isinstance(found, str), found
    own = model.applied_forces(q, u)
    size = np.abs(own).max() or 1.0
    tau = np.random.default_rng(SEED).uniform(-size, size, u.shape)
    ours = model.forward_dynamics(q, u, tau=tau)
    theirs = Constrained(found).forward_dynamics(q, u, tau + own)
    return np.abs(ours - theirs).max(axis=1) / np.abs(theirs).max(axis=1)


def states(mechanism: Closed, model: cd.CompiledModel) -> tuple[np.ndarray, np.ndarray]:
    """q and u along the motion of a mechanism."""
    moving = {joint["name"] for joint in model.manifest["joints"]}
    found = [mechanism.state(s, 1.5, moving) for s in PLACES]
    pairs = [model.split(model.initial(q=state.q, u=state.u)) for state in found]
    q, u = (np.array(block) for block in zip(*pairs, strict=True))
    return q, u


@pytest.mark.parametrize("mechanism", some(CLOSED.values(), 2, 1), ids=repr)
def test_mechanisms(mechanism: Closed) -> None:
    model = cd.compile(mechanism.build(), functions=FUNCTIONS)
    error = agreement(model, *states(mechanism, model))
    print(f"{mechanism}: {error.max():.1e}")
    assert error.max() <= TOLERANCE


@pytest.mark.parametrize(
    ("name", "joint"),
    some(
        [
            ("four_bar", "A"),
            ("slider_crank", "guide"),
            ("slider_crank", "B"),
            ("bricard", "J4"),
            ("bricard", "J2"),
            ("stewart", "ball0"),
            ("delta", "wrist0"),
        ],
        3,
    ),
)
def test_cut_elsewhere(name: str, joint: str) -> None:
    scene = CLOSED[name].build()
    scene.joints[joint] = dataclasses.replace(scene.joints[joint], cut=True)
    model = cd.compile(scene, functions=FUNCTIONS)
    assert agreement(model, *states(CLOSED[name], model)).max() <= TOLERANCE


def closed(model: cd.CompiledModel, q: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """States moved onto the constraints."""
    for _ in range(20):
        q = model.close_position(q)[..., : model.nq]
    return q, model.close_velocity(q, u)[..., : model.nu]


LOOSE = '<body name="c" pos="1 0 0"><freejoint/><geom type="box" size="0.1 0.2 0.3"/></body>'
FILES = {
    "URDF hinge": urdf.from_text(loops.robot(loops.PIN)),
    "URDF ball": urdf.from_text(loops.robot(loops.PIN.replace("revolute", "ball"))),
    "MJCF connect": mjcf.from_text(
        linkage('<connect body1="a" body2="c" anchor="0.2 0.1 1"/>', LOOSE)
    ),
    "MJCF weld": mjcf.from_text(linkage('<weld body1="b" body2="c"/>', LOOSE)),
}


@pytest.mark.parametrize("name", some(FILES, 3))
def test_files(name: str) -> None:
    model = cd.compile(FILES[name], functions=FUNCTIONS)
    start = model.split(model.initial())[0]
    if name.startswith("URDF"):
        start = np.array([0.7, -0.2, 1.5])
    rng = np.random.default_rng(SEED)
    u = rng.uniform(-1, 1, (5, model.nu))
    q, u = closed(model, np.broadcast_to(start, (5, model.nq)), u)
    assert agreement(model, q, u).max() <= TOLERANCE
