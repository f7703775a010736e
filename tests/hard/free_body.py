"""A free body that tumbles for ever: momentum and energy after very many steps."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

import cardan as cd

from .case import DAMPED, METHODS, Case, Cell, Never, kind

STEP = 2e-3
SPIN = [0.4, 1.0, 0.02]


def build() -> cd.Scene:
    """Three moments of inertia, no force."""
    scene = cd.Scene("free_body", gravity=(0, 0, 0))
    body = scene.body("body", mass=2.0, com=(0, 0, 0), inertia=(1.0, 2.0, 3.0))
    scene.joint("free", cd.Free(), scene.ground, body)
    return scene


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest relative change of energy, of spin and of linear momentum."""
    momentum = model.momentum(motion.q, motion.u)
    going = momentum[:, 3:]
    # about the center: a flight of kilometers rounds to picometers a step
    turning = momentum[:, :3] - np.cross(motion["free"][:, 4:], going)
    total = motion.energy.total
    return float(
        max(
            abs(total[-1] / total[0] - 1),
            np.linalg.norm(turning[-1] - turning[0]) / np.linalg.norm(turning[0]),
            np.linalg.norm(going[-1] - going[0]) / np.linalg.norm(going[0]),
        )
    )


# of adaptive methods: as many steps as of the others
AS_MANY = {"rtol": 1e-12, "atol": 1e-13, "max_step": STEP}


def expected(count: int) -> dict[str, Cell | Never]:
    """Roundings that go either way; implicit steps leave a little in one direction.

    Order 2 leaves h^2 beside.
    """
    walk = 3e-15 * math.sqrt(count)
    close = Cell(walk, AS_MANY)
    cells = {
        "explicit": close,
        "lower": close,
        "fixed": Cell(walk),
        "implicit": Cell(3e-16 * count, AS_MANY),
        "energy": Cell(2e-6),
        "damped": Cell(3e-6, {"step": STEP}),
    }
    return {
        **{name: cells[kind(name)] for name in METHODS},
        "Rosenbrock": Cell(1e-17 * count, AS_MANY),
    }


CASE = Case(
    name="free body",
    hard="an asymmetric body tumbles in free flight for 1e5 steps of 2 ms",
    oracle="largest relative change at the end: energy, central angular or linear momentum",
    advice="for conservation over many steps, use an explicit method of order 4 or higher",
    build=build,
    t=(0.0, 1e5 * STEP),
    start={"u": {"free": [*SPIN, 0.3, 0.0, -0.2]}},
    error=error,
    expected=expected(100_000),
    step=STEP,
)
LONG = replace(
    CASE,
    name="free body, 1e7 steps",
    hard="the same body for 1e7 steps",
    t=(0.0, 1e7 * STEP),
    # a tenth of the steps or less where each of them solves equations
    expected=expected(10_000_000)
    | {"EnergyMidpoint": Cell(1e-3, {"step": 20 * STEP})}
    | {name: Cell(1e-5, {"step": STEP}) for name in DAMPED},
    slow=tuple(METHODS),
)
