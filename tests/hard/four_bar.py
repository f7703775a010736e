"""A four-bar a hair from a parallelogram: twice a turn it nearly folds flat."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from scipy.integrate import quad

import cardan as cd
from mechanisms.closed_planar import G, four_bar, heading, meet

from .case import UNDAMPED, Case, alike

GROUND, CRANK, COUPLER, ROCKER = 1.0, 0.5, 1.0, 0.5 * (1 + 1e-3)
ANGLE, SPEED, WIDTH = 1.0, 8.0, 0.02


def build() -> cd.Scene:
    """Crank and rocker differ by a thousandth."""
    return four_bar(GROUND, CRANK, COUPLER, ROCKER)


def angles(theta: float) -> tuple[float, float]:
    """Angles of coupler and rocker on the open branch."""
    tip = (CRANK * np.cos(theta), CRANK * np.sin(theta))
    corner = meet(tip, COUPLER, (GROUND, 0.0), ROCKER, 1)
    return heading(tip, corner), heading((GROUND, 0.0), corner)


def energies(theta: float) -> tuple[float, float]:
    """Inertia seen at the crank, and potential energy."""
    b, c = angles(theta)
    a1, b1, c1 = CRANK, COUPLER, ROCKER
    # rates by the crank's: velocity of the corner along and across
    rate_b = -a1 * np.sin(theta - c) / (b1 * np.sin(b - c))
    rate_c = a1 * np.sin(theta - b) / (c1 * np.sin(c - b))
    # bars of 1 kg/m, 0.02 m wide: two about their ends, the coupler about its middle
    middle = (
        (a1 * np.sin(theta) + b1 / 2 * np.sin(b) * rate_b) ** 2
        + (a1 * np.cos(theta) + b1 / 2 * np.cos(b) * rate_b) ** 2
    )  # fmt: skip
    inertia = a1**3 / 3 + c1**3 / 3 * rate_c**2 + b1 * middle + b1**3 / 12 * rate_b**2
    inertia += WIDTH**2 / 12 * (a1 + b1 * rate_b**2 + c1 * rate_c**2)
    height = a1 * a1 / 2 * np.sin(theta) + c1 * c1 / 2 * np.sin(c)
    height += b1 * (a1 * np.sin(theta) + b1 / 2 * np.sin(b))
    return inertia, G * height


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """How far the crank is from where energy says it is at that time [rad]."""
    inertia, potential = energies(ANGLE)
    total = inertia * SPEED**2 / 2 + potential

    def slowness(theta: float) -> float:
        here, height = energies(theta)
        return float(np.sqrt(here / (2 * (total - height))))

    end = float(motion["A"][-1])
    # it folds at multiples of pi: the integrand is steep there
    folds = np.pi * np.arange(1, int(end // np.pi) + 1)
    near = np.concatenate([folds, *(folds + s * 10.0**-k for k in range(1, 5) for s in (-1, 1))])
    edges = np.unique(np.concatenate([[ANGLE, end], near[(near > ANGLE) & (near < end)]]))
    time = sum(quad(slowness, a, b, epsabs=1e-13, epsrel=1e-12)[0] for a, b in pairwise(edges))
    return abs(time - float(motion.t[-1])) / slowness(end)


b0, c0 = angles(ANGLE)
CASE = Case(
    name="near-singular four-bar",
    hard="links of 1, 0.5, 1 and 0.5005 m: all four hinges nearly align every half turn",
    oracle="energy integral by quadrature, within 1e-11; angle error after 3 s [rad]",
    advice="use `DOP853` at rtol=1e-9; runs step over singular positions by themselves",
    build=build,
    t=(0.0, 3.0),
    start={"q": {"A": ANGLE, "B": b0 - ANGLE, "D": c0}, "u": {"A": SPEED}},
    error=error,
    coarse={"rtol": 1e-7, "atol": 1e-9},
    step=1e-4,
    expected=alike(
        explicit=1e-6,
        lower=1e-6,
        implicit=1e-6,
        damped=1e-1,
        fixed=1e-5,
        energy=1e-2,
        Newmark=UNDAMPED,
    ),
    options={"constraints": "multipliers"},
)
