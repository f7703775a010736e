"""Beams at rest against closed forms and published cases, with the orders of their errors."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cardan.elements.flexible import (
    Classical,
    DeadLoad,
    FlexibleElement,
    Helicoidal,
    HellingerReissner,
)
from elements.flexible.beams import Array, Beam, arc, equilibrium, order, straight

BEAMS: dict[str, tuple[FlexibleElement, float]] = {
    "hellinger_reissner": (HellingerReissner(), 4.0),
    "helicoidal": (Helicoidal(), 2.0),
    "loaded": (HellingerReissner(loaded=True), 4.0),
    "classical": (Classical(), 2.0),
    "classical plain": (Classical(residual_flexibility=False), 2.0),
}
every = pytest.mark.parametrize("name", BEAMS)
REFERENCES = Path(__file__).parents[2] / "references"
BEND = {"EA": 1e7, "GA2": 5e6, "GA3": 5e6, "EI2": 1e7 / 12, "EI3": 1e7 / 12, "GJ": 5e6 / 6}


def reference(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((REFERENCES / f"{name}.json").read_text(encoding="utf-8"))
    return found["reference"]


def at_the_tip(beam: Beam, *load: float) -> Array:
    """Moment and force on the last node."""
    total = np.zeros((len(beam.q), 6))
    total[-1] = load
    return total


def section(slenderness: float, EI: float = 1.0, length: float = 1.0) -> dict[str, float]:
    """Stiffness of a solid square bar, length / radius of gyration given."""
    EA = EI * (slenderness / length) ** 2
    return {"EA": EA, "GA2": EA / 3, "GA3": EA / 3, "EI2": EI, "EI3": EI, "GJ": EI}


def gradually(beam: Beam, load: Array, steps: int, **options: Any) -> Beam:
    """In equal steps of the load, for elements that need them."""
    for k in range(1, steps + 1):
        beam = equilibrium(beam, load * (k / steps), **options).beam
    return beam


def test_bend_in_one_step() -> None:
    wanted = reference("bend45")["tip_position_own"]["J_1/6"]["600"]
    errors = []
    for n in (4, 8, 16, 32):
        beam = arc(n, 100.0, np.pi / 4).of(HellingerReissner(), **BEND)
        found = equilibrium(beam, at_the_tip(beam, 0, 0, 0, 0, 0, 600.0))
        errors.append(float(np.linalg.norm(found.tip - wanted)))
        # the last step finds that nothing is left
        assert len(found.steps) <= 9
    print("45-degree bend, errors:", errors, "orders:", order(errors))
    assert errors[1] < 1.5e-3
    assert order(errors) == pytest.approx([4.0] * 3, abs=0.1)


@every
def test_orders_on_the_bend(name: str) -> None:
    element, wanted = BEAMS[name]
    exact = reference("bend45")["tip_position_own"]["J_1/6"]["300"]
    errors = []
    for n in (4, 8, 16):
        beam = arc(n, 100.0, np.pi / 4).of(element, **BEND)
        found = equilibrium(beam, at_the_tip(beam, 0, 0, 0, 0, 0, 300.0))
        errors.append(float(np.linalg.norm(found.tip - exact)))
    print(name, "errors:", errors, "orders:", order(errors))
    assert order(errors) == pytest.approx([wanted] * 2, abs=0.15)


@every
def test_roll_up_closes_exactly(name: str) -> None:
    beam = straight(8).of(BEAMS[name][0], **section(100.0))
    found = equilibrium(beam, at_the_tip(beam, 0, 0, 2 * np.pi, 0, 0, 0))
    assert found.tip == pytest.approx([0, 0, 0], abs=1e-10)
    # all nodes on a circle: as long as the beam, or around a polygon with sides of its length
    helicoidal = "classical" not in name
    radius = 1 / (2 * np.pi) if helicoidal else 1 / 16 / np.sin(np.pi / 8)
    center = np.mean(found.beam.q[:-1, 4:], axis=0)
    distances = np.linalg.norm(found.beam.q[:, 4:] - center, axis=1)
    assert distances == pytest.approx(radius, abs=1e-10)


def test_roll_up_takes_few_steps() -> None:
    beam = straight(8).of(HellingerReissner(), **section(100.0))
    load = at_the_tip(beam, 0, 0, 2 * np.pi, 0, 0, 0)
    assert len(equilibrium(beam, load).steps) <= 3


@pytest.mark.parametrize("alpha", ["1", "4", "10"])
def test_elastica(alpha: str) -> None:
    known = reference("elastica_tip_load")["table"][alpha]
    beam = straight(16).of(HellingerReissner(), **section(1e4))
    load = at_the_tip(beam, 0, 0, 0, 0, float(alpha), 0)
    found = gradually(beam, load, 2)
    x, y, z = found.q[-1, 4:]
    turn = 2 * np.arctan2(found.q[-1, 3], found.q[-1, 0])
    clamp = -found.balance()[0, 2]
    # fourth order at 16 elements, and strain of a slender bar
    wanted = [1 - known["u"], known["w"], 0, known["theta"], known["M0"]]
    assert [x, y, z, turn, clamp] == pytest.approx(wanted, rel=3e-5, abs=1e-10)


def test_two_loads() -> None:
    known = reference("cantilever_two_loads")["two_loads_A=0.2,nu=.3"]
    stiffness = {"EA": 6000.0, "GA2": 6000 / 2.6, "GA3": 6000 / 2.6}
    stiffness |= {"EI2": 5000.0, "EI3": 5000.0, "GJ": 5000.0}
    errors = []
    for n in (4, 8, 16):
        first = np.linspace(0, 52.03, n + 1)
        stations = np.concatenate([first, np.linspace(52.03, 100, n + 1)[1:]])
        q = np.zeros((len(stations), 7))
        q[:, 0], q[:, 4] = 1, stations
        beam = Beam(stations, q).of(HellingerReissner(), **stiffness)
        load = at_the_tip(beam, 0, 0, 0, 0, 1.35, 0)
        load[n, 4] = 0.85
        found = gradually(beam, load, 2)
        # shortening and deflection
        wanted = np.array([100 - known["tip"][0], known["tip"][1]])
        errors.append(float(np.linalg.norm(found.q[-1, 4:6] - wanted)))
    print("two loads, errors:", errors, "orders:", order(errors))
    assert errors[-1] < 2e-5
    assert order(errors) == pytest.approx([4.0, 4.0], abs=0.2)


@pytest.mark.parametrize("angle", ["40", "100", "140"])
def test_column_behind_its_buckling_load(angle: str) -> None:
    known = reference("pinned_column_elastica")["table"][angle]
    # half of it by symmetry: clamped in the middle, loaded at the hinge
    beam = straight(16, 0.5).of(HellingerReissner(), **section(1e4, length=0.5))
    compressed = at_the_tip(beam, 0, 0, 0, -known["P_over_Pcr"] * np.pi**2, 0, 0)
    bent = at_the_tip(beam, 0, 0, 2.0, 0, 0, 0)
    # bent by a moment first, which is taken away
    for share in np.linspace(1, 0, 5):
        beam = equilibrium(beam, share * bent + (1 - share) * compressed).beam
    x, y, _ = beam.q[-1, 4:]
    wanted = [known["end_dist_over_L"] / 2, known["wmid_over_L"]]
    assert [x, y] == pytest.approx(wanted, abs=1e-5)


@every
def test_no_locking(name: str) -> None:
    element, _ = BEAMS[name]
    worst = {}
    for slenderness in (1e1, 1e2, 1e3, 1e5):
        tips = []
        for n in (8, 32):
            beam = straight(n).of(element, **section(slenderness))
            load = at_the_tip(beam, 0, 0.1, 0, 0, 0.3, 0.2)
            tips.append(equilibrium(beam, load).tip)
        worst[slenderness] = float(np.linalg.norm(tips[0] - tips[1]))
    print(name, worst)
    assert max(worst.values()) < 2 * min(worst.values()) + 1e-8


@every
def test_constant_stress_on_an_irregular_mesh(name: str) -> None:
    """Patch test: of stretch and torsion, with bending too where the strain is helicoidal."""
    element, _ = BEAMS[name]
    stations = np.array([0.0, 0.1, 0.35, 0.4, 0.8, 1.0])
    q = np.zeros((6, 7))
    q[:, 0], q[:, 4] = 1, stations
    stiffness = section(20.0)
    beam = Beam(stations, q).of(element, **stiffness)
    force, torque = 7.0, 0.4
    load = at_the_tip(beam, torque, 0, 0, force, 0, 0)
    found = equilibrium(beam, load).beam
    assert found.q[:, 4] == pytest.approx(stations * (1 + force / stiffness["EA"]), abs=1e-12)
    stress = found.parts[0].value("stress", q=found.pairs)["stress"][:, :2]
    assert stress == pytest.approx(np.tile([torque, 0, 0, force, 0, 0], (5, 2, 1)), abs=1e-9)


def loaded_tips(element: FlexibleElement, stiffness: dict[str, float], force: float) -> Array:
    """Where a cantilever ends under a force per length, with 4 to 32 elements."""
    tips = []
    for n in (4, 8, 16, 32):
        q = straight(n)
        for share in (0.25, 0.5, 0.75, 1.0):
            load = {"dead_force_2": force * share}
            bent = straight(n).of(element, **stiffness, **load)
            # what carries loads itself has no other element for them
            bent = bent if "dead_force_2" in element.common else bent.of(DeadLoad(), **load)
            found = equilibrium(Beam(bent.stations, q.q, bent.parts), np.zeros((n + 1, 6)))
            q = found.beam
        tips.append(found.tip[:2])
    return np.array(tips)


@pytest.mark.parametrize("name", ["hellinger_reissner", "loaded", "classical"])
def test_distributed_load_on_a_thick_beam(name: str) -> None:
    """Solution of the cantilever's differential equations by shooting to 1e-12."""
    element, wanted = BEAMS[name]
    exact = [4.43808375e-01, 8.44053798e-01]
    stiffness = {"EA": 1e3, "GA2": 4e2, "GA3": 4e2, "EI2": 1.0, "EI3": 1.0, "GJ": 1.0}
    errors = np.linalg.norm(loaded_tips(element, stiffness, 20.0) - exact, axis=1)
    print(name, "errors:", errors, "orders:", order(errors))
    if name == "hellinger_reissner":
        # the stretch by the load is of second order, small, and seen on fine meshes
        assert order(errors)[0] > 3.5
        assert errors[2] < 2.5e-5
    else:
        assert order(errors)[-1] == pytest.approx(wanted, abs=0.2)


def test_distributed_load_on_a_slender_beam() -> None:
    tips = loaded_tips(HellingerReissner(), section(1e3), 20.0)
    steps = np.linalg.norm(np.diff(tips, axis=0), axis=1)
    print("steps:", steps, "orders:", order(steps))
    assert order(steps) == pytest.approx([4.0, 4.0], abs=0.1)
