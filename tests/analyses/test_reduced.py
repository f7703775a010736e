"""The minimal form of closed systems."""

from __future__ import annotations

import json
import re
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd
from laws.circuits import compiled, start
from mechanisms.closed import CLOSED

FOUR_BARS = Path(__file__).parents[1] / "references" / "iftomm_A02_fourbar_N2.json"


@pytest.mark.parametrize("name", CLOSED)
def test_full_state_comes_back(name: str) -> None:
    model = compiled(name)
    q, u = start(model, name, 0.3)
    partition = model.partition(q)
    y = partition.reduce(np.concatenate([q, u]))
    assert len(partition.speeds) == CLOSED[name].freedoms
    np.testing.assert_allclose(partition.full(0.0, y), np.concatenate([q, u]), rtol=0, atol=1e-10)
    expected = partition.reduce(model.rhs(0.0, np.concatenate([q, u])))
    found = model.reduced_rhs(0.0, y, partition)
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("name", CLOSED)
def test_dependent_coordinates_are_followed(name: str) -> None:
    """The position further along the motion is found from its independent coordinates alone."""
    model = compiled(name)
    (q, u), (further, rates) = start(model, name, 0.2), start(model, name, 0.35)
    partition = model.partition(q)
    there = np.concatenate([further, rates])
    found = partition.full(0.0, partition.reduce(there))
    np.testing.assert_allclose(found, there, rtol=0, atol=1e-8)
    assert partition.condition < 1e3
    assert np.abs(model.constraints(found[: model.nq])).max() < 1e-11
    assert len(u) == model.nu


def reduced_motion(model: Any, x: np.ndarray, times: np.ndarray, rtol: float) -> np.ndarray:
    """States at times; independent coordinates are chosen anew at each of them."""
    rows = [x]
    for begin, end in pairwise(times.tolist()):
        partition = model.partition(rows[-1][: model.nq])
        done = solve_ivp(
            lambda t, y, p: model.reduced_rhs(t, y, p), (begin, end), partition.reduce(rows[-1]),
            args=(partition,), method="DOP853", rtol=rtol, atol=0.1 * rtol,
        )  # fmt: skip
        assert done.success
        rows.append(partition.full(end, done.y[:, -1]))
    return np.array(rows)


@pytest.mark.parametrize("name", ["four_bar", "slider_crank", "andrews", "bricard", "delta"])
def test_same_motion(name: str) -> None:
    model = compiled(name)
    end = {"andrews": 0.01, "delta": 0.2}.get(name, 0.6)
    x = np.concatenate(start(model, name, 0.1))
    times = np.linspace(0, end, 4)
    known = model.simulate(times, x0=x, rtol=1e-12, atol=1e-13)
    found = reduced_motion(model, x, times, 1e-11)
    # angles of universal and revolute joints: nothing wraps in so short a time
    scale = np.maximum(1.0, np.abs(known.x).max(axis=0))
    np.testing.assert_allclose(found / scale, known.x / scale, rtol=0, atol=1e-8)


def four_bars(until: float, rtol: float) -> float:
    """Largest error of the angle of IFToMM's parallelograms, which pass singular positions."""
    known = json.loads(FOUR_BARS.read_text(encoding="utf-8"))["reference"]["B0"]
    model = compiled("parallelogram")
    times = np.array([0.0, *(t for t in known["t"] if t <= until)])
    x = np.concatenate(start(model, "parallelogram", 0.0, -1.0))
    motion = reduced_motion(model, x, times, rtol)
    angle = motion[1:, model.coordinates.index("A0")]
    error = np.abs(angle - known["phi"][: len(angle)])
    return float(error.max())


def test_through_singular_positions() -> None:
    # the upper start magnifies errors tenfold in the first second
    errors = [four_bars(2.0, rtol) for rtol in (1e-7, 1e-9, 1e-11)]
    assert errors[0] < 1e-6
    assert errors[0] > errors[1] > errors[2]
    assert errors[2] < 1e-9


@pytest.mark.slow
def test_through_many_singular_positions() -> None:
    assert four_bars(20.0, 1e-12) < 1e-8


def test_mistakes() -> None:
    model = compiled("four_bar")
    q, u = start(model, "four_bar", 0.3)
    with pytest.raises(cd.SolveError, match=r"loops are open by 0\.\d+ at this position"):
        model.partition(q + np.array([0.1, 0.2, -0.1]))
    with pytest.raises(cd.ArgumentError, match=re.escape("q has shape (2,), expected (3,)")):
        model.partition(q[:2])
    partition = model.partition(q)
    assert repr(partition).startswith("Partition of 'four_bar': independent ")
    with pytest.raises(cd.ArgumentError, match=r"y has shape \(3,\), expected \(2,\)"):
        partition.full(0.0, [*q[:2], u[0]])


def test_independent_coordinates_that_cannot_be_reached() -> None:
    """The rocker of a crank-rocker has two dead ends; it turns there, it does not pass."""
    model = compiled("four_bar")
    q, u = start(model, "four_bar", 0.3)
    partition = model.partition(q)
    partition._q, partition._u = [model.coordinates.index("D")], [model.speeds.index("D.u")]
    partition.coordinates = ("D",)
    with pytest.raises(
        cd.SolveError, match=r"no position with D = 3.* near the last one, with D = "
    ):
        partition.full(0.0, [3.0, u[0]])
