"""The pinned column: where it buckles, that this is told, and how it bends behind that."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import cardan as cd
from mechanisms.flexible import column

Array = NDArray[np.float64]
Follow = Callable[[int, list[str]], Array]
TABLE: dict[str, dict[str, float]] = json.loads(
    (Path(__file__).parent / "pinned_column_elastica.json").read_text(encoding="utf-8")
)["reference"]["table"]
EULER = math.pi**2
STIFF = 1e4
ASIDE = 0.5  # a force that pushes it to one side [N]


def wanted(angles: list[str]) -> Array:
    """Distance of the ends, deflection of the middle, slope at the ends, of every load (n, 3)."""
    rows = ((TABLE[a]["end_dist_over_L"], TABLE[a]["wmid_over_L"], float(a)) for a in angles)
    return np.array([(end, middle, math.radians(angle)) for end, middle, angle in rows])


def shape(path: Any) -> Array:
    """The same of a path, and without what it is shorter under the load (n, 3)."""
    ends = 1 + path["guide"] + path["P"] * EULER / STIFF
    return np.stack([ends, path.pose("beam.at1")[:, 2, 3], np.abs(path["pin"])], axis=1)


def buckled(model: cd.CompiledModel, P: float) -> Any:
    """Behind the critical load: pushed aside, pressed, and released."""
    pushed = model.statics(F=(0, ASIDE), parameters={"P": 0.9}, steps=1)
    pressed = model.statics(P=(0.9, P), parameters={"F": ASIDE}, q=pushed.q[-1], steps=1)
    released = model.statics(F=(ASIDE, 0), parameters={"P": P}, q=pressed.q[-1], steps=1)
    for path in (pushed, pressed, released):
        assert path.success
        assert all(path.stable)
    return released[-1]


def loads(angles: list[str]) -> list[float]:
    return [TABLE[a]["P_over_Pcr"] for a in angles]


def test_the_straight_column_says_where_it_buckles() -> None:
    # EI theta'' = -P ((1 - P / EA) + P / GA) theta
    stretch, shear = 1e3, 1e2
    give = (1 / shear - 1 / stretch) * EULER
    critical = (math.sqrt(1 + 4 * give) - 1) / (2 * give)
    model = cd.compile(column(8, 0.0, stretch, shear))
    with pytest.warns(cd.SolveWarning, match=r"unstable from a load between P = .* and P = "):
        path = model.statics(P=(0, 1.6))
    assert path.success
    (crossing,) = path.crossings
    assert crossing.lost
    low, high = (path.loading.values(place.s)["P"] for place in (crossing.before, crossing.after))
    # 8 elements are off by less than the width of the steps that pass it
    assert low <= critical <= high
    assert high - low < 0.01
    assert path.critical()[0]["P"] == pytest.approx(critical, rel=2e-4)
    assert path.n_negative.tolist() == [int(high <= P) for P in path["P"]]
    # what is kept is the straight column
    np.testing.assert_allclose(path.pose("beam.at1")[:, 2, 3], 0, atol=1e-9)


@pytest.mark.parametrize("imperfection", [1e-2, pytest.param(1e-5, marks=pytest.mark.slow)])
def test_a_column_that_is_not_straight_buckles_to_its_side(imperfection: float) -> None:
    """Long steps lead to the branch of the other side, which is unstable, if nobody looks."""
    path = cd.compile(column(8, imperfection)).statics(P=(0, 1.6))
    assert path.success
    assert all(path.stable)
    assert not path.crossings
    middle = path.pose("beam.at1")[:, 2, 3]
    assert np.all(np.diff(middle[path["P"] < 1.5]) > 0)
    assert middle[-1] > 0.35


@pytest.mark.slow
def test_imperfections_that_vanish_lead_to_the_perfect_shape() -> None:
    angles = ["60", "90"]
    at = [0.0, *loads(angles)]
    paths = [cd.compile(column(8, size, STIFF)).statics(P=at) for size in (4e-3, 2e-3, 1e-3)]
    found = [shape(path)[1:] for path in paths]
    # in the size of the imperfection: error of order 1, and of order 2 once extrapolated
    perfect = cd.compile(column(8, 0.0, STIFF))
    start = buckled(perfect, at[1])
    exact = shape(perfect.statics(P=at[1:], steps=1, q=start.q))[[0, -1]]
    errors = [float(np.abs(x - exact).max()) for x in found]
    print(f"column, imperfect: distance from the perfect one {[f'{e:.2e}' for e in errors]}")
    assert np.log2(errors[1] / errors[2]) == pytest.approx(1, abs=0.1)
    assert np.abs(2 * found[2] - found[1] - exact).max() < 0.05 * errors[2]


def follow(elements: int, angles: list[str]) -> Array:
    model = cd.compile(column(elements, 0.0, STIFF))
    path = model.statics(P=loads(angles), q=buckled(model, loads(angles)[0]).q)
    assert path.success
    assert all(path.stable)
    return shape(path)


def beyond(elements: int, angles: list[str]) -> Array:
    """The plane branch behind the load at which it loses its stability across the plane."""
    model = cd.compile(column(elements, 0.0, STIFF))
    start = buckled(model, loads(angles)[0])
    with pytest.warns(cd.SolveWarning, match="unstable from a load between P = 2.1"):
        path = model.statics(P=loads(angles), q=start.q)
    assert path.success
    return shape(path)


def compared(
    elements: tuple[int, ...], angles: list[str], follow: Follow = follow
) -> tuple[list[float], float]:
    """Errors, and that of the last two extrapolated by order 4; printed."""
    found = [follow(n, angles) for n in elements]
    errors = [float(np.abs(x - wanted(angles)).max()) for x in found]
    slopes = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    last = float(np.abs((16 * found[-1] - found[-2]) / 15 - wanted(angles)).max())
    said = [f"{e:.2e}" for e in errors]
    print(f"column: errors {said}, orders {np.round(slopes, 2)}, extrapolated {last:.1e}")
    assert slopes[-1] == pytest.approx(4, abs=0.1)
    return errors, last


def test_buckled_shapes() -> None:
    errors, last = compared((16, 32), ["40", "80", "120"])
    assert errors[-1] < 3e-6
    assert last < 2e-8


@pytest.mark.slow
def test_buckled_shapes_of_many_elements() -> None:
    errors, last = compared((64, 128), ["20", "40", "60", "80", "100", "120"])
    assert errors[-1] < 3e-8
    # the tolerance of the reference
    assert last < 1e-10


@pytest.mark.slow
def test_shapes_behind_where_its_ends_meet() -> None:
    errors, last = compared((64, 128), ["120", "140", "160"], beyond)
    assert errors[-1] < 3e-8
    # the tolerance of the reference
    assert last < 1e-10


@pytest.mark.slow
def test_where_its_ends_meet_it_turns_out_of_its_plane() -> None:
    """A load between ends in one place does not care in which plane they are."""
    m = brentq(lambda m: 2 * ellipe(m) - ellipk(m), 0.5, 0.95)
    meeting = (2 * ellipk(m) / math.pi) ** 2
    model = cd.compile(column(8, 0.0, STIFF))
    start = buckled(model, loads(["120"])[0])
    with pytest.warns(cd.SolveWarning, match="unstable from a load between P = 2.1"):
        path = model.statics(P=loads(["120", "140", "160"]), q=start.q)
    assert path.critical()[0]["P"] == pytest.approx(meeting, rel=2e-3)
    # the plane branch is followed behind it; 8 elements
    assert np.abs(shape(path) - wanted(["120", "140", "160"])).max() < 2e-3
