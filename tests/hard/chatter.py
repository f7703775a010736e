"""A ball that bounces ever faster: infinitely often in a finite time."""

from __future__ import annotations

import numpy as np

import cardan as cd

from .case import METHODS, UNDAMPED, Case, Cell, table

HEIGHT, BOUNCE, G = 1.0, 0.5, 9.81
FALL = np.sqrt(2 * HEIGHT / G)
REST = FALL * (1 + BOUNCE) / (1 - BOUNCE)


def ball(settle: float) -> cd.Scene:
    """A mass above a floor."""
    scene = cd.Scene("ball", gravity=(0, 0, -G))
    scene.joint("height", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    scene.force("floor", cd.Stop("height", lower=0.0, restitution=BOUNCE, settle=settle))
    return scene


def bouncing() -> cd.Scene:
    """It never settles."""
    return ball(0.0)


def settling() -> cd.Scene:
    """It stays where it is slower than a millimeter a second."""
    return ball(1e-3)


def end(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """How far the end of the run is from the time at which it rests [s]."""
    return abs(float(motion.t[-1]) - REST)


def settled(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of the times of impacts [s]; infinite unless it lies on the floor at last."""
    hits = [event.t for event in motion.events if event.kind == "impact"]
    known = FALL * (1 + 2 * np.cumsum(np.r_[0, BOUNCE ** np.arange(1, len(hits))]))
    lies = abs(motion["height"][-1]) + abs(motion["height.u"][-1]) < 1e-9
    return float(np.abs(hits - known).max()) if lies and len(hits) > 10 else np.inf


COMMON = {"t": 2.0, "start": {"q": {"height": HEIGHT}}, "step": 1e-3}
CHATTER = Case(
    name="chatter",
    hard="a ball keeps half its speed at every bounce: infinitely many bounces within 1.35 s",
    oracle="closed form; the run ends with the status chatter; error of the time [s]",
    advice="give the stop a `settle=` speed above 0, such as the default of 1e-4",
    build=bouncing,
    error=end,
    # a parabola: exact for every method, up to how small intervals count as none
    expected=table(
        {name: Cell(1e-4, status="chatter") for name in METHODS} | {"Newmark": UNDAMPED}
    ),
    **COMMON,
)
SETTLED = Case(
    name="chatter, settled",
    hard="the same ball, which settles below 1 mm/s and stays at rest",
    oracle="closed form; largest error of the impact times [s]",
    advice="choose `settle=` well below the speeds that matter",
    build=settling,
    error=settled,
    expected=table({name: Cell(1e-8) for name in METHODS} | {"Newmark": UNDAMPED}),
    **COMMON,
)
