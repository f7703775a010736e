"""Runs with loops, events or Python on the way: one after the other, as ``simulate`` does."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import cardan as cd
from analyses.ensembles.test_bits import same
from cardan.runtime.build import toolchain
from cardan.runtime.calls import interpreted

pytestmark = pytest.mark.optimized


@pytest.fixture(scope="module")
def fourbar() -> cd.CompiledModel:
    """A crank and a rocker, closed by a cut joint."""
    scene = cd.Scene("fourbar", gravity=(0, 0, -9.81))
    lengths = {"crank": 0.2, "coupler": 0.6, "rocker": 0.5}
    for name, length in lengths.items():
        rod = cd.inertia.rod(1.0, length, axis="z")
        scene.body(name, mass=1.0, com=(0, 0, -length / 2), inertia=rod)
    crank, coupler, rocker = (scene.bodies[name] for name in lengths)
    scene.joint("a", cd.Revolute("y"), scene.ground, crank)
    scene.joint("b", cd.Revolute("y"), crank.at(0, 0, -0.2), coupler)
    scene.joint("d", cd.Revolute("y"), scene.ground.at(0.55, 0, 0), rocker)
    scene.joint("c", cd.Revolute("y"), coupler.at(0, 0, -0.6), rocker.at(0, 0, -0.5))
    return cd.compile(scene, constraints="multipliers")


def test_circuits_are_assembled_run_by_run(fourbar: cd.CompiledModel) -> None:
    angles = np.linspace(-0.4, 0.4, 12)
    made = fourbar.ensemble(0.5, q={"a": angles}, threads=2)
    assert made.success
    assert made.job.width == 1
    same(made, fourbar.ensemble(0.5, q={"a": angles}, threads=1))
    for i in (0, 7):
        motion = fourbar.simulate(0.5, q={"a": angles[i]})
        np.testing.assert_array_equal(made.final[i], motion.x[-1])
        np.testing.assert_array_equal(made.run(i).x[-1], motion.x[-1])


def test_functions_as_inputs(double: cd.CompiledModel) -> None:
    def torque(t: float, x: np.ndarray) -> float:
        return -0.3 * x[2] + 0.1 * t

    elbow = np.linspace(-1, 1, 11)
    made = double.ensemble(
        1.0, q={"elbow": elbow}, inputs={"torque": torque}, reduce="max of elbow"
    )
    motion = double.simulate(1.0, q={"elbow": elbow[3]}, inputs={"torque": torque})
    np.testing.assert_array_equal(made.final[3], motion.x[-1])

    def broken(t: float, x: np.ndarray) -> float:
        raise RuntimeError("no sensor")

    with pytest.raises(cd.FunctionError, match="'torque' raised at t = 0 s: RuntimeError") as told:
        double.ensemble(1.0, q={"elbow": elbow}, inputs={"torque": broken})
    assert isinstance(told.value.__cause__, RuntimeError)


def test_events_of_the_caller(double: cd.CompiledModel) -> None:
    speeds = np.linspace(0, 6, 10)
    events = {"up": ("elbow", 0.5)}
    made = double.ensemble(1.0, u={"elbow": speeds}, events=events, reduce="max of elbow")
    assert set(made.status) == {"finished", "event"}
    assert made.success
    for i in (0, 9):
        motion = double.simulate(1.0, u={"elbow": speeds[i]}, events=events)
        np.testing.assert_array_equal(made.final[i], motion.x[-1])
        assert made.statistics["t"][i] == motion.t[-1]
    # up to where the event was
    assert 0.45 < made["max of elbow"][9] <= 0.5


def test_without_a_compiler(double: cd.CompiledModel, monkeypatch: pytest.MonkeyPatch) -> None:
    here = double.ensemble(0.3, q={"elbow": np.array([0.1, 0.2, 0.3])}, rtol=1e-10)
    monkeypatch.setenv("PATH", "/nonexistent")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(toolchain, "ziglang", list)
    monkeypatch.setattr("cardan.runtime.calls.webassembly.available", lambda: False)
    interpreted.announce.cache_clear()
    bare = pickle.loads(pickle.dumps(double))
    with pytest.warns(cd.BuildWarning, match="no C compiler"):
        made = bare.ensemble(0.3, q={"elbow": np.array([0.1, 0.2, 0.3])}, rtol=1e-10)
    assert made.job.build.startswith("Python-")
    np.testing.assert_allclose(made.final, here.final, rtol=0, atol=1e-8)


def test_auto_looks_at_the_first_run() -> None:
    scene = cd.Scene("stiff", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=1.0, com=(0, 0, 0), inertia=(1, 1, 1))
    scene.joint("slide", cd.Prismatic("z"), scene.ground, bob)
    scene.force("damper", cd.JointDamper("slide", 1e5))
    model = cd.compile(scene, functions=["rhs", "power", "rhs_jacobian"])
    made = model.ensemble(10.0, q={"slide": np.linspace(0, 1, 5)})
    assert made.job.how.method.name == "Rosenbrock"
    assert "stability limited" in repr(made)
    motion = model.simulate(10.0, q={"slide": 0.25})
    np.testing.assert_array_equal(made.final[1], motion.x[-1])


@pytest.mark.parametrize("method", ["Radau", "Rosenbrock"])
def test_implicit_methods_with_parameters(method: str, double: cd.CompiledModel) -> None:
    masses = np.linspace(0.5, 2, 7)
    options = {"method": method, "q": {"elbow": 0.4}}
    made = double.ensemble(0.5, parameters={"lower.mass": masses}, **options)
    for i in (1, 6):
        model = double.with_parameters({"lower.mass": masses[i]})
        np.testing.assert_array_equal(made.final[i], model.simulate(0.5, **options).x[-1])
