"""Loads along beams that time, inputs, states and motion change, by other ways to their effect."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy
from scipy.optimize import brentq

import cardan as cd
from codegen.running import compilers
from codegen.test_export_mesh import Builder, builder
from codegen.test_export_mesh_events import TIMES, exported_run, same_run
from equations.finite_elements.reference import Reference
from equations.finite_elements.test_tangents import tangents_agree
from spread import some

LENGTH, EI, MASS = 1.2, 4.0, 0.3
__all__ = ["builder"]

SHEAR = 1e5
SECTION = cd.section.general(EA=1e5, GA=SHEAR, GJ=3.0, EI=EI, rhoA=MASS, rhoI=1e-7)
ELEMENTS = ["hellinger_reissner", "hellinger_reissner_loaded", "helicoidal"]


def cantilever(
    elements: int = 6, element: str = "hellinger_reissner", name: str = "cantilever"
) -> tuple[cd.Scene, Any]:
    """A clamped beam without weight."""
    scene = cd.Scene(name, gravity=(0, 0, 0))
    beam = scene.beam(
        "beam", scene.ground, (LENGTH, 0, 0), SECTION, elements=elements, element=element
    )
    scene.output("sag", beam.end.position()[2], unit="m")
    return scene, beam


def blown(element: str = "hellinger_reissner") -> cd.Scene:
    """A cantilever under a load that an input gives."""
    scene, beam = cantilever(element=element)
    gust = scene.input("gust", default=1e-3, unit="N/m")
    scene.force("wind", cd.LineLoad(beam, force=(0, 0, gust)))
    return scene


@pytest.mark.parametrize("element", ELEMENTS)
def test_deflection_at_an_input(element: str) -> None:
    """q L^4 / (8 EI) and the shear, at inputs of one model."""
    model = cd.compile(blown(element))
    for load in (1e-3, -2e-3):
        rest = model.equilibrium(inputs={"gust": load})
        expected = load * LENGTH**4 / (8 * EI) + load * LENGTH**2 / (2 * SHEAR)
        limit = 1e-6 if element != "helicoidal" else 2e-2
        assert model.outputs(rest.q, rest.u)[0] == pytest.approx(expected, rel=limit)


def roots(count: int) -> list[float]:
    """Wave numbers of a clamped beam times its length."""
    return [
        brentq(lambda x: np.cos(x) + 1 / np.cosh(x), (n + 0.01) * np.pi, (n + 0.99) * np.pi)
        for n in range(count)
    ]


def test_harmonic_load_by_superposition_of_modes() -> None:
    """Slender and at rest at first: the sum over modes of a clamped beam."""
    load, rate = 1e-3, 9.0
    scene, beam = cantilever(8)
    scene.force("wind", cd.LineLoad(beam, force=(0, 0, load * sympy.sin(rate * cd.t))))
    times = np.linspace(0, 2.0, 81)
    motion = cd.compile(scene).simulate(times, rtol=1e-8, atol=1e-11)
    expected = np.zeros(len(times))
    for n, x in enumerate(roots(6)):
        sigma = (np.cosh(x) + np.cos(x)) / (np.sinh(x) + np.sin(x))
        omega = x**2 * np.sqrt(EI / MASS) / LENGTH**2
        amplitude = 2 * sigma / x * load / MASS / (omega**2 - rate**2)
        mode = np.sin(rate * times) - rate / omega * np.sin(omega * times)
        expected += 2 * (-1) ** n * amplitude * mode
    assert np.abs(motion["sag"] - expected).max() < 2e-3 * np.abs(expected).max()


def push(t: Any) -> tuple[Any, ...]:
    """A load that bends the beam far."""
    return 0, 2.0 * sympy.sin(6 * t), 9.0 * (1 - sympy.cos(5 * t))


def test_forces_at_many_nodes_take_the_place_of_a_load() -> None:
    """Large deflections; shares of the load at nodes leave out the square of their distance."""
    scene, beam = cantilever(16)
    scene.force("wind", cd.LineLoad(beam, force=push(cd.t)))
    expected = cd.compile(scene).simulate(np.linspace(0, 0.5, 26), rtol=1e-7)["beam.end.pz"]
    assert np.abs(expected).max() > 0.3
    ends = []
    for count in (8, 16):
        scene, beam = cantilever(16)
        for k in range(1, count + 1):
            share = LENGTH / count / (2 if k == count else 1)
            node = beam.at(k / count) if k < count else beam.end
            scene.force(f"f{k}", cd.Force(node, tuple(share * x for x in push(cd.t))))
        ends.append(cd.compile(scene).simulate(np.linspace(0, 0.5, 26), rtol=1e-7)["beam.end.pz"])
    gaps = [np.abs(end - expected).max() for end in ends]
    limit = (4 * ends[1] - ends[0]) / 3
    assert 3.0 < gaps[0] / gaps[1] < 5.0
    assert np.abs(limit - expected).max() < 0.1 * gaps[1]


# of a load that more than parameters change, written anew for every scene
Load = Callable[[cd.Scene, Any], dict[str, Any]]
LOADS: dict[str, Load] = {
    "time": lambda scene, beam: {"force": (0, sympy.sin(cd.t), 2), "moment": (0, 0, cd.t)},
    "input": lambda scene, beam: {"force": (0, 0, scene.input("gust", default=0.7))},
    "state": lambda scene, beam: {"force": (0, scene.state("motor.force"), 0.3)},
    "joint": lambda scene, beam: {
        "force": (0, 0, sympy.sin(scene.q("hinge")) - 0.2 * scene.u("hinge"))
    },
    "other joint": lambda scene, beam: {"force": (0, 0.5, scene.q("pin") * scene.u("pin"))},
    "frame": lambda scene, beam: {
        "force": (0, 0, -0.2 * scene.bodies["crank"].at(0.3, 0, 0).velocity()[2]),
        "moment": (0.1 * scene.bodies["arm"].at(0.1, 0, 0).position()[2], 0, 0),
    },
    "own tip": lambda scene, beam: {
        "force": (0, -0.3 * beam.end.velocity()[1], -0.3 * beam.end.velocity()[2])
    },
}


def machine(load: Load, follower: bool = False) -> cd.Scene:
    """A beam on an arm on a hinge, beside it a crank with a motor that lags."""
    scene = cd.Scene("machine", gravity=(0, 0, -2.0))
    arm = scene.body("arm", mass=1.0, com=(0.2, 0, 0), inertia=(0.1, 0.1, 0.1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, arm, q0=0.1)
    crank = scene.body("crank", mass=0.5, com=(0.1, 0, 0), inertia=(0.02, 0.02, 0.02))
    scene.joint("pin", cd.Revolute("y"), scene.ground.at(0, 1, 0), crank, u0=0.4)
    scene.force("motor", cd.Actuator("pin", sympy.cos(4 * cd.t), lag=0.1, start=0.2))
    beam = scene.beam("beam", arm.at(0.4, 0, 0), (0.4 + LENGTH, 0, 0), SECTION, elements=3)
    scene.force("wind", cd.LineLoad(beam, follower=follower, **load(scene, beam)))
    return scene


@pytest.mark.parametrize("follower", [False, True])
@pytest.mark.parametrize("name", some(LOADS, 2))
def test_tangents_and_energy(name: str, follower: bool) -> None:
    """Complex steps; what the load does is what the energy gains."""
    scene = machine(LOADS[name], follower)
    equations = cd.derive(scene)
    kind = "follower_load_variable_tree" if follower else "dead_load_variable_tree"
    assert any(group.kind.name.startswith(kind) for group in equations.groups)
    tangents_agree(Reference(equations, None, None))
    if not follower or name == "time":
        model = cd.compile(equations)
        model.verify()
        motion = model.simulate(0.3, rtol=1e-8)
        energies = [model.energy(q, u).total for q, u in zip(motion.q, motion.u, strict=True)]
        done = motion.work_done.sum(axis=1)
        assert np.abs(done).max() > 1e-3
        np.testing.assert_allclose(np.ravel(energies) - energies[0], done - done[0], atol=2e-6)


@pytest.mark.parametrize("follower", [False, True])
def test_an_input_acts_like_a_number(follower: bool) -> None:
    """A constant load has a potential and other functions: accelerations are the same."""
    numbers = {"force": (0.3, -0.5, 0.8), "moment": (0.2, 0.1, -0.3)}

    def varying(scene: cd.Scene, beam: Any) -> dict[str, Any]:
        one = scene.input("one", default=1.0)
        return {key: tuple(one * x for x in value) for key, value in numbers.items()}

    models = [cd.compile(machine(load, follower)) for load in (lambda *_: numbers, varying)]
    x = models[0].initial()
    nq, nu = models[0].nq, models[0].nu
    u = x[nq : nq + nu] + np.random.default_rng(2).normal(size=nu)
    accelerations = [model.forward_dynamics(x[:nq], u) for model in models]
    scale = np.abs(accelerations[0]).max()
    np.testing.assert_allclose(*accelerations, atol=1e-11 * scale)
    doubled = models[1].forward_dynamics(x[:nq], u, r=[2.0])
    assert np.abs(doubled - accelerations[0]).max() > 1e-3 * scale


def test_linear_model() -> None:
    """Columns of inputs and of internal states are differences of the accelerations."""
    model = cd.compile(blown())
    rest = model.equilibrium()
    linear, nu = model.linearize(rest), model.nu
    sides = [model.forward_dynamics(rest.q, rest.u, r=[1e-3 + h]) for h in (1e-3, -1e-3)]
    expected = (sides[0] - sides[1]) / 2e-3
    assert np.abs(expected).max() > 1
    np.testing.assert_allclose(linear.B[nu:, 0], expected, atol=1e-7 * np.abs(expected).max())


def test_states_in_a_linear_model() -> None:
    model = cd.compile(machine(LOADS["state"]))
    x, nq, nu = model.initial(), model.nq, model.nu
    q, u = x[:nq], x[nq : nq + nu]
    linear = model.linearize(q=q, u=u, z=[0.2])
    sides = [model.forward_dynamics(q, u, z=[0.2 + h]) for h in (1e-3, -1e-3)]
    expected = (sides[0] - sides[1]) / 2e-3
    column = linear.A[nu : 2 * nu, -1]
    np.testing.assert_allclose(column, expected, atol=1e-6 * np.abs(expected).max())


def test_files_and_ensembles(tmp_path: Path) -> None:
    """A scene file says the same, and runs of an ensemble are those of simulate."""
    scene = blown()
    scene.save(tmp_path / "blown.yaml")
    models = [cd.compile(one) for one in (scene, cd.load(tmp_path / "blown.yaml"))]
    alone = [model.simulate(0.05, inputs={"gust": 0.4}) for model in models]
    np.testing.assert_array_equal(alone[0].x, alone[1].x)
    runs = models[0].ensemble(0.05, inputs={"gust": [0.4, -0.8]})
    np.testing.assert_array_equal(runs.run(0).x, alone[0].x)
    sag = alone[0]["sag"][-1]
    assert abs(sag) > 1e-3
    assert runs.run(1)["sag"][-1] == pytest.approx(-2 * sag, rel=1e-2)


@pytest.mark.skipif("gcc" not in compilers(), reason="needs a C compiler")
@pytest.mark.parametrize("name", some(["state", "own tip"], 2))
def test_exported_runs(name: str, builder: Builder, tmp_path: Path) -> None:
    folder = cd.derive(machine(LOADS[name])).export(
        tmp_path / "c", language="c", integrators=["alpha"]
    )
    times = np.linspace(0, 0.05, TIMES)
    motion = cd.load_model(folder).simulate(times, method=cd.GeneralizedAlpha(0.8), step=5e-4)
    how = {"method": '"alpha"', "step": 5e-4}
    same_run(exported_run(builder, folder, 0.05, how), motion)


def test_a_plane_is_left_by_a_load_across() -> None:
    scene, beam = cantilever()
    scene.force("wind", cd.LineLoad(beam, force=(0, 0, sympy.sin(cd.t))))
    assert "beam.node1.angle" in cd.derive(scene, plane="auto").coordinates
    scene.force("across", cd.LineLoad(beam, force=(0, cd.t, 0)))
    assert "beam.node1.px" in cd.derive(scene, plane="auto").coordinates
