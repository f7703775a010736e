"""Laws of mechanics for superelements that fly, whatever their frame, inertia and method."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import product
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.schema.integrators import INTEGRATORS
from combinations.refusals import expected
from mechanisms.superelements import FLYERS
from superelements.rotations import exponential, rotation
from table import each

SPIN, TURN = np.array([1.0, 2.0, 8.0]), exponential(np.array([2.0, -2.6, 0.4]))
PLACE, BOOST = np.array([1.0, 2.0, 3.0]), np.array([30.0, -50.0, 20.0])
START = {"free": [*SPIN, 0.5, 0.0, 0.0]}
FINE = {"method": "DOP853", "rtol": 1e-11}
# tolerance of methods that choose their steps; steps of others that are as accurate. Of order 2,
# errors go with the power 2/3 of the tolerance, so that these are given steps too
RTOL, STEP = 1e-6, 1e-4
# subjects of every run; the others where there is time
SHOWN = (*("root", "tip", "mean", "chord"), "corotated", "stiffened")


@cache
def model_of(name: str) -> cd.CompiledModel:
    return cd.compile(FLYERS[name].build())


def tip_of(name: str) -> str:
    return f"boom.{FLYERS[name].record().interfaces[-1].name}"


def flown(name: str, spin: Any, **start: Any) -> cd.Trajectory:
    """A tenth of a second from an undeformed start."""
    velocity = start.pop("velocity", (0.0, 0.0, 0.0))
    return model_of(name).simulate([0, 0.05, 0.1], u={"free": [*spin, *velocity]}, **FINE, **start)


def check_invariance(name: str) -> None:
    """Galilean invariance and objectivity: of two runs one turned, moved and boosted."""
    velocity = BOOST if FLYERS[name].galilean else 0 * BOOST
    one = flown(name, SPIN)
    two = flown(name, SPIN, q={"free": [*TURN, *PLACE]}, velocity=velocity)
    here, there = (run.pose(tip_of(name))[-1] for run in (one, two))
    R = rotation(TURN)
    np.testing.assert_allclose(there[:3, :3], R @ here[:3, :3], atol=1e-9)
    np.testing.assert_allclose(there[:3, 3], R @ here[:3, 3] + PLACE + 0.1 * velocity, atol=1e-8)
    assert np.abs(here[:3, :3] - np.eye(3)).max() > 0.3


def check_balance(name: str) -> None:
    """Energy is accounted for, momenta stay."""
    run = flown(name, SPIN, velocity=(0.5, 0.0, 0.0))
    total = np.abs(run.energy.total).max()
    assert np.abs(run.energy_residual).max() < 1e-10 * total
    momenta = [run.model.momentum(q, u) for q, u in zip(run.q, run.u, strict=True)]
    np.testing.assert_allclose(momenta, [momenta[0]] * 3, rtol=1e-10, atol=1e-9)
    damped = bool(FLYERS[name].record().C.any())
    assert (abs(run.energy.total[-1] - run.energy.total[0]) > 1e-6 * total) == damped


def check_verified(name: str) -> None:
    """Balances against energies, tangents against slopes of balances."""
    assert model_of(name).verify(seed=2).worst < 1e-9


LAWS: tuple[Callable[[str], None], ...] = (check_invariance, check_balance, check_verified)


@each("law, name", product(LAWS, SHOWN))
def test_laws(law: Callable[[str], None], name: str) -> None:
    law(name)


@pytest.mark.slow
@each("law, name", product(LAWS, sorted({*FLYERS} - {*SHOWN})))
def test_laws_of_the_others(law: Callable[[str], None], name: str) -> None:
    law(name)


def check_power(method: str, name: str) -> None:
    """Ten tolerances of the energy are unaccounted for at most; a refusal has a reason."""
    how: dict[str, Any] = {"rtol": RTOL, "atol": 1e-2 * RTOL}
    row = INTEGRATORS[method]
    how = how if row.adaptive and row.order > 2 else {"step": STEP}
    try:
        run = model_of(name).simulate([0, 0.05, 0.1], u=START, method=method, **how)
    except cd.ModelError as problem:
        expected((name,), method, " ".join(str(problem).split()))
        return
    assert run.success, run.message
    missed = np.abs(run.energy_residual).max() / np.abs(run.energy.total).max()
    print(f"{name}, {method}: {missed:.1e} of the energy")
    assert missed < 10 * RTOL


@each("method", INTEGRATORS)
def test_power_balance(method: str) -> None:
    check_power(method, "mean")


@pytest.mark.slow
@each("method, name", product(INTEGRATORS, sorted({*FLYERS} - {"mean"})))
def test_power_balance_of_the_others(method: str, name: str) -> None:
    check_power(method, name)
