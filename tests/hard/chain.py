"""A hundred links."""

from __future__ import annotations

from functools import cache

import numpy as np

import cardan as cd
from mechanisms.chain import chain

from .case import Case, Cell, alike

LINKS = 100
TIMES = np.linspace(0, 1.0, 6)


def build() -> cd.Scene:
    """Rods of 1 m, hinged about y and z in turn, that hang out horizontally."""
    return chain(LINKS)


@cache
def known(model: cd.CompiledModel) -> np.ndarray:
    """States at a tighter tolerance, on which two methods agree."""
    first = model.simulate(TIMES, method="DOP853", rtol=1e-12, atol=1e-13)
    second = model.simulate(TIMES, method="RK45", rtol=1e-11, atol=1e-12)
    assert np.abs(first.x - second.x).max() < 1e-8
    return np.asarray(first.x)


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of an angle [rad]."""
    return float(np.abs(motion.q - known(model)[: len(motion), :LINKS]).max())


CASE = Case(
    name="100 links",
    hard="a chain of 100 rods in space, released from horizontal, for 1 s",
    oracle="two methods at rtol 1e-12 and 1e-11 agree to 4e-12; largest error of an angle [rad]",
    advice="use `DOP853`; stiff methods factor large matrices here",
    build=build,
    t=TIMES,
    start={},
    error=error,
    fine={"rtol": 1e-8, "atol": 1e-10},
    coarse={"rtol": 1e-5, "atol": 1e-7},
    expected=alike(
        explicit=1e-6,
        lower=1e-6,
        implicit=1e-6,
        damped=1e-2,
        fixed=1e-6,
        energy=5e-3,
        EnergyMidpoint=Cell(5e-3, {"step": 1e-2}),
    ),
)
