"""Frequencies of cantilevers: orders of the inertia, and rest in free fall."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import scipy.linalg

from cardan.elements.flexible import (
    Classical,
    Damping,
    FlexibleElement,
    Helicoidal,
    HellingerReissner,
    LinkedInertia,
    LumpedInertia,
)
from elements.flexible.beams import Beam, arc, equilibrium, order, straight
from elements.flexible.test_statics import section

# of slender bars, EI = rhoA = L = 1: squares of the roots of cos x cosh x = -1
EXACT = np.array([1.875104068711961, 4.694091132974175, 7.854757438237613]) ** 2
PAIRS: dict[str, tuple[FlexibleElement, FlexibleElement, float]] = {
    "Hellinger-Reissner, linked": (HellingerReissner(), LinkedInertia(), 4.0),
    "classical, linked": (Classical(), LinkedInertia(), 4.0),
    "Hellinger-Reissner, lumped": (HellingerReissner(), LumpedInertia(), 2.0),
    "helicoidal, linked": (Helicoidal(), LinkedInertia(), 2.0),
}


def frequencies(beam: Beam) -> Any:
    """Of a beam that is clamped at its start [rad/s]."""
    free = slice(6, None)
    K, M = beam.tangent("K")[free, free], beam.tangent("M")[free, free]
    return np.sqrt(scipy.linalg.eigh((K + K.T) / 2, M, eigvals_only=True))


def bar(n: int, elastic: FlexibleElement, heavy: FlexibleElement, radius: float) -> Beam:
    """EI = rhoA = L = 1."""
    data = section(1 / radius) | {"rhoA": 1.0, "rhoI2": radius**2, "rhoI3": radius**2}
    return straight(n).of(elastic, **data).of(heavy, **data)


@pytest.mark.parametrize("name", PAIRS)
def test_orders_of_slender_bars(name: str) -> None:
    elastic, heavy, wanted = PAIRS[name]
    errors = []
    for n in (4, 8, 16):
        # both directions of bending have the same
        found = frequencies(bar(n, elastic, heavy, 1e-4))[:6:2]
        errors.append(abs(found / EXACT - 1))
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    print(name, "errors at 8 elements:", errors[1], "orders:", orders[1])
    # the second frequency: the first is at its rounding, the third not yet at its order
    assert orders[1, 1] == pytest.approx(wanted, abs=0.25)


def test_eight_elements() -> None:
    found = frequencies(bar(8, HellingerReissner(), LinkedInertia(), 1e-4))[:6:2]
    assert np.all(abs(found / EXACT - 1) < [4e-6, 1e-4, 7e-4])


def test_thick_bars_converge() -> None:
    """With soft shear and inertia of rotation."""
    found = [
        frequencies(bar(n, HellingerReissner(), LinkedInertia(), 0.1))[:6] for n in (8, 16, 32)
    ]
    steps = [np.linalg.norm(b - a) for a, b in pairwise(found)]
    assert order(steps) == pytest.approx([2.0], abs=0.4)


def test_a_curved_beam_in_free_fall_is_at_rest() -> None:
    data = section(50.0) | {"rhoA": 2.0, "rhoI2": 0.1, "rhoI3": 0.2, "gravity_3": -9.81}
    beam = arc(4, 1.0, 1.0).of(HellingerReissner(), **data).of(LinkedInertia(), **data)
    falling = np.tile([0.0, 0, 0, 0, 0, -9.81], (4, 2))
    total = np.zeros((5, 6))
    for part in beam.parts:
        b = part.value("balance", q=beam.pairs, u=0 * falling, udot=falling)["balance"]
        total[:-1] += b[:, :6]
        total[1:] += b[:, 6:]
    assert total == pytest.approx(np.zeros((5, 6)), abs=1e-11)


def test_weight_bends_as_a_load_does() -> None:
    """Deflection rhoA g L⁴ / (8 EI) of a slender bar, exact at any number of elements."""
    data = section(1e3) | {"rhoA": 1.0, "rhoI2": 1e-6, "rhoI3": 1e-6, "gravity_3": -1e-4}
    beam = straight(2).of(HellingerReissner(), **data).of(LinkedInertia(), **data)
    found = equilibrium(beam, np.zeros((3, 6)))
    shear = 1e-4 / 2 / data["GA3"]
    assert found.tip[2] == pytest.approx(-1e-4 / 8 - shear, rel=1e-7)


def test_damping_of_bending_is_that_of_the_stiffness() -> None:
    data = section(1e3) | {"damping": 0.3}
    beam = straight(4)
    K = beam.of(HellingerReissner(), **data).tangent("K")
    C = beam.of(Damping(), **data).tangent("C")
    assert pytest.approx(0.3 * K, rel=1e-9, abs=1e-9 * abs(K).max()) == C
