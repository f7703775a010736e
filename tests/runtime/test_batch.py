"""Batches: lanes, their remainders, parameters of their own, failing states, threads, Ctrl-C."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

import cardan as cd
from cardan.errors import BuildError, BuildWarning, SolveError, SolveWarning
from cardan.runtime.build import cache, cpu_levels
from cardan.runtime.calls import batch, calling, lanes

pytestmark = [pytest.mark.optimized, pytest.mark.usefixtures("cache_directory")]

WIDTHS = (1, 2, 4, 8)
FUNCTIONS = ("forward_dynamics", "rhs", "pose", "energy")


@pytest.fixture(autouse=True)
def many(monkeypatch: pytest.MonkeyPatch) -> None:
    """No batch is so small that its states are simply done one by one."""
    monkeypatch.setattr(calling, "LITTLE", 0)


@pytest.fixture(scope="module")
def equations():
    scene = cd.Scene("pair", gravity=(0, 0, -9.81))
    upper = scene.body("upper", mass=2.0, com=(0.1, 0, -0.2), inertia=(0.02, 0.03, 0.01))
    lower = scene.body("lower", mass=1.0, com=(0, 0.02, -0.3), inertia=(0.01, 0.02, 0.01))
    scene.joint("shoulder", cd.Universal("x", "y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -0.4), lower)
    return cd.derive(scene)


@pytest.fixture(params=WIDTHS)
def model(equations, request, monkeypatch):
    monkeypatch.setenv("CARDAN_LANES", str(request.param))
    found = cd.compile(equations, functions=FUNCTIONS)
    found.prepare("forward_dynamics", batch=True)
    assert found.lanes("forward_dynamics") == request.param
    return found


def rows(model, q, u, **more):
    """State by state."""
    lists = {name: np.broadcast_to(x, (len(q), *np.shape(x)[-1:])) for name, x in more.items()}
    return np.array(
        [
            model.forward_dynamics(q[k], u[k], **{name: x[k] for name, x in lists.items()})
            for k in range(len(q))
        ]
    )


def test_every_remainder(model):
    rng = np.random.default_rng(1)
    for count in (301, 40, 39, 33, 32):
        q, u, tau = rng.uniform(-1, 1, (3, count, 3))
        found = model.forward_dynamics(q, u, tau=tau)
        assert found.tobytes() == rows(model, q, u, tau=tau).tobytes()
    # what all states share
    assert (
        model.forward_dynamics(q, u[0], tau=tau[1]).tobytes()
        == rows(model, q, np.broadcast_to(u[0], u.shape), tau=tau[1]).tobytes()
    )


def test_blocks_of_one_array_and_wide_results(model):
    model.prepare("rhs", ("pose", "lower"), batch=True)
    rng = np.random.default_rng(2)
    x = rng.uniform(-1, 1, (4, 25, model.nx))
    q = x[..., :3]
    rhs = np.array([[model.rhs(0.0, b) for b in a] for a in x])
    assert model.rhs(0.0, x).tobytes() == rhs.tobytes()
    poses = np.array([[model.pose("lower", b) for b in a] for a in q])
    assert model.pose("lower", q).tobytes() == poses.tobytes()


def test_parameters_of_every_state(model):
    rng = np.random.default_rng(3)
    q, u = rng.uniform(-1, 1, (2, 50, 3))
    masses = rng.uniform(1, 2, 50)
    model._function("forward_dynamics").caller.batch._spent[True] = np.inf
    found = model.forward_dynamics(q, u, parameters={"upper.mass": masses})
    for k in range(50):
        one = model.forward_dynamics(q[k], u[k], parameters={"upper.mass": masses[k]})
        assert one.tobytes() == found[k].tobytes()
    built = model._function("forward_dynamics").caller.batch._built
    assert (built[True] is not None) == (lanes.width() > 1)


def test_states_without_result_leave_the_others_alone(model):
    q, u = np.full((40, 3), 0.3), np.full((40, 3), 0.2)
    good = model.forward_dynamics(q[0], u[0])
    u[17] = 1e200
    with pytest.warns(SolveWarning, match="state 17; 1 of 40"):
        found = model.forward_dynamics(q, u)
    assert not np.isfinite(found[17]).all()
    assert (np.delete(found, 17, axis=0) == good).all()


def test_numbers_that_are_not_finite_are_named(model):
    rng = np.random.default_rng(5)
    q, u, tau = rng.uniform(-1, 1, (3, 300, 3))
    arrays = ((q, "q of shoulder"), (u, "u of shoulder"), (tau, "tau of shoulder"))
    for place, (array, name) in product((0, 35, 299), arrays):
        held = array[place, 0]
        for bad in (np.nan, np.inf, -np.inf):
            array[place, 0] = bad
            with pytest.raises(SolveError, match=f"{name}.* is {bad} at state {place}"):
                model.forward_dynamics(q, u, tau=tau)
        array[place, 0] = held
    with pytest.raises(SolveError, match="tau of elbow"):
        model.forward_dynamics(q, u, tau=[0.0, 0.0, np.nan])
    # a sum too large says nothing about its terms
    q[:, 2] = 1.7e308
    expected = rows(model, q[:2], u[:2], tau=tau[:2])
    assert model.forward_dynamics(q, u, tau=tau)[:2].tobytes() == expected.tobytes()


def test_results_go_where_they_are_wanted(model):
    rng = np.random.default_rng(6)
    q, u = rng.uniform(-1, 1, (2, 64, 3))
    expected = model.forward_dynamics(q, u)
    room = np.empty((64, 3))
    assert model.forward_dynamics(q, u, out=room) is room
    assert room.tobytes() == expected.tobytes()
    # into an argument, and into every other row
    copy = q.copy()
    assert model.forward_dynamics(copy, u, out=copy).tobytes() == expected.tobytes()
    wide = np.empty((128, 3))
    model.forward_dynamics(q, u, out=wide[::2])
    assert wide[::2].tobytes() == expected.tobytes()


def test_lanes_are_built_when_they_pay(equations, monkeypatch):
    monkeypatch.setenv("CARDAN_LANES", "2")
    model = cd.compile(equations, functions=FUNCTIONS)
    q, u = np.zeros((2, 40, 3))
    model.forward_dynamics(q, u)
    assert model.lanes("forward_dynamics") == 1
    # as if batches had taken as long as the compiler will
    ways = model._function("forward_dynamics").caller.batch
    ways._spent[False] = ways.cost
    before = model.forward_dynamics(q, u)
    assert model.lanes("forward_dynamics") == 2
    assert model.forward_dynamics(q, u).tobytes() == before.tobytes()
    # found in the cache at once by a new model, and by the same with other values
    other = cd.compile(equations, functions=FUNCTIONS)
    other.forward_dynamics(q, u)
    assert other.lanes("forward_dynamics") == 2
    assert model.with_parameters({"upper.mass": 3.0}).lanes("forward_dynamics") == 2


def test_builds_that_differ_are_not_used(equations, monkeypatch, cache_directory):
    monkeypatch.setenv("CARDAN_LANES", "2")
    model = cd.compile(equations, functions=FUNCTIONS)
    before = sorted(cache_directory.glob("*.so"))
    model.prepare("forward_dynamics")
    text = model.directory / "forward_dynamics.c"
    # a text that says other things in lanes
    whole = text.read_text().replace('"lanes.h"\n', '"lanes.h"\n#define cos sin\n', 1)
    changed = whole.replace("return CARDAN_OK;\n", "out[0] = 2.0 * out[0];\nreturn CARDAN_OK;\n")
    ways = model._function("forward_dynamics").caller.batch
    text.write_text(changed)
    with pytest.raises(BuildError, match="is not the text its manifest speaks of"):
        model.prepare("forward_dynamics", batch=True)
    # as if a compiler had made other code of the same text
    monkeypatch.setattr(ways, "recipe", replace(ways.recipe, check=lambda: None))
    with pytest.raises(BuildError, match="different code of one text"):
        model.prepare("forward_dynamics", batch=True)
    assert model.lanes("forward_dynamics") == 1
    ways._spent[False] = ways.cost
    with pytest.warns(BuildWarning, match="done one by one"):
        found = model.forward_dynamics(*np.zeros((2, 40, 3)))
    assert found.shape == (40, 3)
    assert not list(cache_directory.glob(".new-*"))
    assert len(sorted(cache_directory.glob("*.so"))) > len(before)


@pytest.mark.parametrize("many", [1, 2, 3])
def test_threads_share_a_large_batch(equations, many, monkeypatch):
    model = cd.compile(equations, functions=FUNCTIONS, threads=many)
    monkeypatch.setattr(batch, "THREADED", 0.0)
    monkeypatch.setattr(batch, "CHUNK_SECONDS", 1e-4)
    rng = np.random.default_rng(4)
    q, u = rng.uniform(-1, 1, (2, 5000, 3))
    pairs = zip(q[::20], u[::20], strict=True)
    expected = np.concatenate([model.forward_dynamics(*pair) for pair in pairs])
    found = model.forward_dynamics(q, u)
    assert found[::20].tobytes() == expected.tobytes()
    u[4321] = 1e200
    with pytest.warns(SolveWarning, match="state 4321"):
        model.forward_dynamics(q, u)


@pytest.mark.parametrize("text", ["0", "-1", "two", "3.5"])
def test_wrong_variables_are_said(equations, text, monkeypatch):
    model = cd.compile(equations, functions=FUNCTIONS)
    monkeypatch.setenv("CARDAN_LANES", text)
    with pytest.raises(BuildError, match=f"CARDAN_LANES='{text}' is not a number of lanes"):
        model.prepare("forward_dynamics", batch=True)
    monkeypatch.delenv("CARDAN_LANES")
    monkeypatch.setenv("CARDAN_THREADS", text)
    monkeypatch.setattr(batch, "THREADED", 0.0)
    with pytest.raises(BuildError, match=f"CARDAN_THREADS={text} is not a number of threads"):
        model.forward_dynamics(*np.zeros((2, 300, 3)))


def test_width_is_what_vectors_of_the_level_hold(monkeypatch):
    known = {"x86-64": 2, "x86-64-v2": 2, "x86-64-v3": 4, "x86-64-v4": 8, "armv8": 2, "generic": 1}
    widths, highest = {}, cache.level()
    for level in cpu_levels.family():
        if level.number <= highest.number:
            monkeypatch.setenv("CARDAN_LEVEL", level.name)
            widths[level.name] = lanes.width()
    assert widths == {name: known[name] for name in widths}
    assert highest.name in widths


def test_ctrl_c_is_heard_by_threads(equations, cache_directory):
    model = cd.compile(equations, functions=FUNCTIONS)
    model.prepare("forward_dynamics", batch=True)
    script = textwrap.dedent(
        """
        import sys, time
        import numpy as np
        from cardan.api.compiled_model import CompiledModel

        model = CompiledModel(sys.argv[1], threads=2)
        q = np.zeros((3_000_000, 3))
        model.forward_dynamics(q[:100], q[:100])
        try:
            print("ready", flush=True)
            for _ in range(1000):
                model.forward_dynamics(q, q)
        except KeyboardInterrupt:
            print("heard", flush=True)
        """
    )
    command = [sys.executable, "-c", script, str(model.directory)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=dict(os.environ))
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    process.send_signal(signal.SIGINT)
    assert "heard" in process.communicate(timeout=30)[0]
