"""A rubber beam, hung at one end, falls from the horizontal; its tip at times of the motion."""

from __future__ import annotations

import math
import time

import numpy as np
from numpy.typing import NDArray

import cardan as cd

Array = NDArray[np.float64]
LENGTH, RADIUS, YOUNG, POISSON, DENSITY, GRAVITY = 1.0, 0.01, 5e6, 0.499, 1100.0, 9.81
AREA, SECOND = math.pi * RADIUS**2, math.pi * RADIUS**4 / 4
SHEAR = YOUNG / (2 * (1 + POISSON))
SECTION = {
    "EA": YOUNG * AREA,
    "GA": 6 * (1 + POISSON) / (7 + 6 * POISSON) * SHEAR * AREA,
    "GJ": 2 * SHEAR * SECOND,
    "EI": YOUNG * SECOND,
    "rhoA": DENSITY * AREA,
    "rhoI": DENSITY * SECOND,
}
END, STEP, RHO_INF, SAMPLES = 0.5, 1e-3, 0.8, 10


def scene(
    n: int, element: str = "hellinger_reissner", inertia: str = "linked", flat: bool = False
) -> cd.Scene:
    """The beam with n elements, on a ball joint, or on a hinge across its plane."""
    model = cd.Scene("rubber", gravity=(0, 0, -GRAVITY))
    beam = model.beam(
        "rope", (0, 0, 0), (LENGTH, 0, 0), cd.section.general(**SECTION), elements=n,
        element=element, inertia=inertia,
    )  # fmt: skip
    pin = cd.Revolute("y") if flat else cd.Spherical()
    model.joint("pin", pin, model.ground, beam.start)
    for name, axis in (("x", 0), ("z", 2)):
        model.output(name, beam.end.position()[axis], unit="m")
    return model


def run(model: cd.CompiledModel, steps: int, end: float = END) -> tuple[float, Array]:
    """Time of a step [s], all of the call, and where the tip is at the samples (SAMPLES, 2) [m]."""
    times = np.linspace(0, end, SAMPLES + 1)
    method = cd.GeneralizedAlpha(RHO_INF, index=3)
    start = time.thread_time()
    motion = model.simulate(times, method=method, step=end / steps)
    taken = time.thread_time() - start
    assert motion.success, motion
    return taken / steps, np.stack([motion["x"], motion["z"]], axis=-1)[1:]
