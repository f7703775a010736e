"""What runs keep for the next one like them: request, start, memory. Nothing of it shows."""

from __future__ import annotations

import warnings
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.conftest import double_scene
from cardan.errors import ModelError, ModelWarning, SolveError

START = {"elbow": 0.7}


def fresh(**how: Any) -> Any:
    """The motion of a model that has run nothing before."""
    return cd.compile(double_scene()).simulate(**how)


def same(one: Any, other: Any) -> bool:
    """Equal bits, and the same said of them."""
    plain = [
        {**vars(m.solver_info), "statistics": {**m.statistics, "milliseconds": 0}}
        for m in (one, other)
    ]
    arrays = all(
        getattr(one, name).tobytes() == getattr(other, name).tobytes()
        for name in ("t", "x", "r", "work_done", "energy_residual")
    )
    return arrays and plain[0] == plain[1]


def test_every_run_is_like_the_first() -> None:
    model = cd.compile(double_scene())
    requests: list[dict[str, Any]] = [
        {"t": 1.0, "q": START, "rtol": 1e-9},
        {"t": 1.0, "q": {"elbow": -0.7}, "rtol": 1e-9},
        {"t": 1.0, "q": START, "rtol": 1e-6},
        {"t": 2.0, "q": START, "rtol": 1e-9},
        {"t": (0.5, 1.5), "q": START},
        {"t": np.linspace(0, 1, 5), "q": START},
        {"t": 1, "q": {"elbow": 1}, "u": {"elbow": 0.2}},
        {"t": 1.0, "q": START, "inputs": {"torque": 2.0}},
        {"t": 1.0, "q": START, "method": "RK4", "step": 0.01},
        {"t": 1.0, "q": START, "method": "Radau"},
        {"t": 1.0, "q": START, "parameters": {"gravity.z": -1.0}},
        {"t": 1.0, "q": START, "events": {"low": ("elbow", 0.1)}},
        {"t": 1.0},
    ]
    alone = [fresh(**one) for one in requests]
    for _ in range(3):
        for request, expected in zip(requests, alone, strict=True):
            assert same(model.simulate(**request), expected), request


def test_motions_and_starts_are_nobody_elses() -> None:
    model = cd.compile(double_scene())
    first = model.simulate(1.0, q=START)
    kept = {name: getattr(first, name).copy() for name in ("t", "x", "r", "work_done")}
    start = model.initial(q=START)
    second = model.simulate(1.0, q=START)
    for name in kept:
        assert not np.may_share_memory(getattr(first, name), getattr(second, name))
        getattr(second, name)[...] = np.nan
    start[:] = np.nan
    given = {"elbow": 0.7}
    third = model.simulate(1.0, q=given)
    given["elbow"] = 0.1
    assert model.simulate(1.0, q=given).x[0, 1] == 0.1
    for name, array in kept.items():
        assert np.array_equal(getattr(first, name), array)
        assert np.array_equal(getattr(third, name), array)
    assert np.isfinite(model.initial(q=START)).all()


def test_threads_run_the_same_model() -> None:
    model = cd.compile(double_scene())
    angles = np.linspace(-1, 1, 24).tolist()
    expected = [fresh(t=1.0, q={"elbow": angle}).x for angle in angles]

    def one(k: int) -> bool:
        runs = [model.simulate(1.0, q={"elbow": angle}).x for angle in angles[k::6]]
        return all(np.array_equal(a, b) for a, b in zip(runs, expected[k::6], strict=True))

    with ThreadPoolExecutor(6) as pool:
        assert all(pool.map(one, range(6)))


def test_what_is_refused_or_warned_of_once_is_so_again() -> None:
    scene = double_scene()
    foot = scene.body("foot", mass=1.0, inertia=(1, 1, 1))
    scene.joint("knee", cd.Revolute("y"), scene.bodies["lower"], foot, limits=(-0.1, 0.1))
    model = cd.compile(scene)
    for _ in range(2):
        with pytest.warns(ModelWarning, match="knee"):
            model.simulate(0.1, q={"knee": 0.5})
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            model.simulate(0.1, q={"knee": 0.05})
        with pytest.raises(SolveError, match="finite"):
            model.simulate(0.1, q={"knee": float("nan")})
        with pytest.raises(ModelError, match="no joint or coordinate"):
            model.simulate(0.1, q={"kne": 0.0})
        with pytest.raises(ModelError, match="t=-1"):
            model.simulate(-1.0, q={"knee": 0.0})
        with pytest.raises(ModelError, match="tolerances"):
            model.simulate(0.1, q={"knee": 0.0}, rtol=-1.0)


def test_a_run_that_gains_energy_says_so_every_time() -> None:
    model = cd.compile(double_scene())
    for _ in range(2):
        with pytest.warns(cd.SolveWarning, match="of energy unaccounted for"):
            model.simulate(10.0, q={"elbow": 2.0}, method="RK4", step=0.1)
