"""Superelements to be timed: booms on a hub, and a slider-crank whose rod is a bar of solids."""

from __future__ import annotations

import time
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

import cardan as cd
from cardan import solids
from solids.meshes import block
from superelements.components import brick

Array = NDArray[np.float64]
# crank [m], inertia of the crank [kg m^2], mass of the slider [kg], speed of the crank [rad/s]
CRANK, INERTIA, SLIDER, SPEED = 0.1, 0.01, 0.1, 60.0
# rod: length and side [m], cells along it, modes beside the motions of its ends
LENGTH, SIDE, CELLS, MODES = 0.3, 0.008, 24, 4
# damping [s] ends the vibrations along the rod that the start excites
ALUMINIUM = {"E": 70e9, "nu": 0.3, "rho": 2700.0}
DAMPING = 2e-5
RHO_INF, TURN, SAMPLES = 0.8, 2 * np.pi / SPEED, 20


def booms(frame: str, count: int = 1, modes: int = 12) -> cd.Scene:
    """A free hub with booms of two interfaces each."""
    scene = cd.Scene(f"booms_{frame}_{count}", gravity=(0, 0, 0))
    hub = scene.body("hub", 5.0 * count, inertia=(1.0 * count,) * 3)
    scene.joint("free", cd.Free(), scene.ground, hub)
    for k in range(count):
        scene.superelement(f"boom{k}", brick(modes=modes), {"root": hub}, frame=frame)
    return scene


@cache
def rod(modes: int = MODES) -> tuple[Any, Any, dict[str, Array]]:
    """The rod of solids: its mesh, its record, and the nodes of its ends and of its middle."""
    mesh = block("hex20", (CELLS, 1, 1), (LENGTH, SIDE, SIDE))
    places = {"pin": 0.0, "slider": LENGTH, "middle": LENGTH / 2}
    nodes = {name: np.flatnonzero(abs(mesh.points[:, 0] - x) < 1e-9) for name, x in places.items()}
    ends = {name: nodes[name] for name in ("pin", "slider")}
    record = cd.superelement.from_mesh(
        mesh, cd.material(**ALUMINIUM), ends, modes=modes, rayleigh=(0.0, DAMPING)
    )
    return mesh, record, nodes


@cache
def matrices() -> tuple[Any, Any]:
    """M and K of the rod before its reduction."""
    solid = solids.solid(rod()[0], cd.material(**ALUMINIUM))
    return solid.mass(), solid.stiffness()


def slider_crank(frame: str | None, modes: int = MODES) -> cd.Scene:
    """The slider-crank, its rod a superelement with that frame; None: rigid."""
    scene = cd.Scene(f"slider_crank_{frame or 'rigid'}", gravity=(0, 0, 0))
    crank = scene.body("crank", 1.0, inertia=(INERTIA,) * 3)
    slider = scene.body("slider", SLIDER)
    scene.joint("crank", cd.Revolute("z"), scene.ground, crank)
    _, record, _ = rod(modes)
    if frame:
        link = scene.superelement("rod", record, {"slider": slider}, frame=frame)
        start = link.at("pin")
    else:
        own = record.properties
        diagonal = tuple(np.diag(own.inertia))
        body = scene.body("rod", own.mass, com=(own.center[0], 0, 0), inertia=diagonal)
        scene.joint("weld", cd.Fixed(), body.at(LENGTH), slider)
        start = body
    scene.joint("pin", cd.Revolute("z"), crank.at(CRANK), start)
    # one row closes the loop; none is redundant
    scene.joint("guide", cd.PointOnPlane("y"), scene.ground, slider)
    return scene


START = {"crank": SPEED, "pin": -SPEED * (1 + CRANK / LENGTH)}


def middle(motion: Any) -> Array:
    """Where the middle of the rod is at the samples of a motion, in the plane (SAMPLES, 2) [m]."""
    shape = motion.superelement("rod")
    there = abs(shape.surface.points[:, 0] - LENGTH / 2) < 1e-9
    found: Array = shape.positions[1:, there, :2].mean(axis=1)
    return found


def run(model: Any, end: float = TURN, **options: Any) -> tuple[float, Any]:
    """Time of a call [s] and the motion, with samples where it is a whole turn."""
    times = np.linspace(0, TURN, SAMPLES + 1) if end == TURN else (0.0, end)
    start = time.thread_time()
    motion = model.simulate(times, u=START, **options)
    taken = time.thread_time() - start
    assert motion.success, motion
    return taken, motion
