"""Beams at rest under large loads, as compiled scenes, against closed and published solutions."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import cardan as cd
from mechanisms.flexible import bend45, elastica, roll_up, two_loads

HERE = Path(__file__).parent
Array = NDArray[np.float64]
STIFF = 1e4  # EA and GA of beams that are to be like inextensible ones


def reference(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))
    return found["reference"]


def tip(found: Any, node: str) -> Array:
    """Where a node is: of an equilibrium (3,), of a path (n, 3)."""
    return np.stack([found[f"{node}.{c}"] for c in ("px", "py", "pz")], axis=-1)


def order(name: str, errors: list[float], halvings: float = 1.0) -> float:
    """By which power of the elements' length errors of twice as many elements fall, printed."""
    slopes = np.log2(np.array(errors[:-1]) / np.array(errors[1:])) / halvings
    print(f"{name}: errors {[f'{e:.2e}' for e in errors]}, orders {np.round(slopes, 2)}")
    return float(slopes[-1])


def test_roll_up() -> None:
    path = cd.compile(roll_up(6)).statics(M=(0, 2 * np.pi))
    assert path.success
    turn = path["M"][1:]
    wanted = np.stack([np.sin(turn) / turn, (1 - np.cos(turn)) / turn, 0 * turn], axis=-1)
    error = np.abs(tip(path, "beam.end")[1:] - wanted).max()
    print(f"roll-up: largest error along the path {error:.1e}")
    assert error < 1e-10


@pytest.mark.parametrize(("torsion", "name"), [(1 / 6, "J_1/6"), (0.140577, "J_0.140577")])
def test_bend(torsion: float, name: str) -> None:
    known = reference("bend45")["tip_position_own"][name]
    errors = []
    for elements in (8, 64):
        path = cd.compile(bend45(elements, torsion)).statics(P=[0, 300, 450, 600])
        wanted = np.array([known[load] for load in ("300", "450", "600")])
        errors.append(np.abs(tip(path, "bend.end")[1:] - wanted).max())
    assert errors[0] < 1.5e-3
    # the tolerance of the reference
    assert errors[-1] < 1e-6
    assert order(f"45-degree bend, {name}", errors, 3) == pytest.approx(4, abs=0.1)


def test_bend_of_published_accuracy() -> None:
    """Eight elements of the sources, of second order, are off by 0.2."""
    known = reference("bend45")["published"]
    path = cd.compile(bend45(4)).statics(P=[0, 300, 450, 600])
    wanted = [known[f"simo_vuquoc_{load}"] for load in (300, 450, 600)]
    np.testing.assert_allclose(tip(path, "bend.end")[1:], wanted, atol=0.2)


def test_elastica() -> None:
    table, loads = reference("elastica_tip_load")["table"], ("1", "5", "10")
    wanted, P = np.array([[1 - table[k]["u"], table[k]["w"]] for k in loads]), np.array([1, 5, 10])
    found = []
    for n in (32, 64):
        path = cd.compile(elastica(n, STIFF)).statics(P=[0.0, *P])
        places = tip(path, "beam.end")[1:, :2]
        # of equal EA and GA the stretch adds P / EA across the beam, exactly, and no more
        found.append(places - np.stack([0 * P, P / STIFF], axis=1))
    errors = [np.abs(places - wanted).max() for places in found]
    assert order("elastica", errors) == pytest.approx(4, abs=0.1)
    assert errors[-1] < 2e-8
    # extrapolated by this order: the tolerance of the reference
    last = np.abs((16 * found[1] - found[0]) / 15 - wanted).max()
    print(f"elastica, extrapolated: error {last:.1e}")
    assert last < 1e-9


def test_two_loads() -> None:
    known = reference("cantilever_two_loads")["two_loads_A=0.2,nu=.3"]
    # told by shortening, deflection and slope
    wanted = np.array([[100, 0], [52.03, 0]]) + np.array([[-1, 1]]) * np.array(
        [known[k][:2] for k in ("tip", "p1")]
    )
    errors = []
    for elements in (8, 32):
        found = cd.compile(two_loads(elements)).equilibrium()
        places = np.array([tip(found, node)[:2] for node in ("beam.end", "beam.at1")])
        errors.append(np.abs(places - wanted).max() / 100)
    # the tolerance of the reference
    assert errors[-1] < 1e-6
    assert order("two loads", errors, 2) == pytest.approx(4, abs=0.2)
