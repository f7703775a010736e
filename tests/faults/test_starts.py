"""Starts of runs and named values, one test per fault."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.errors import CardanError
from spread import some


def flying_pair() -> cd.Scene:
    """A free body that carries another one on a ball."""
    scene = cd.Scene("flying_pair", gravity=(0, 0, 0))
    base = scene.body("b", mass=1.0, inertia=(0.1, 0.1, 0.1))
    other = scene.body("d", mass=1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("base", cd.Free(), scene.ground, base)
    scene.joint("ball", cd.Spherical(), base.at(1, 0, 0), other.at(-0.5, 0, 0))
    return scene


def four_bar(knife: bool = False) -> cd.Scene:
    """A crank A, a coupler on B, a rocker on D; C closes the loop. A skate stands beside."""
    scene = cd.Scene("four_bar", gravity=(0, -9.81, 0))
    crank = scene.body("crank", mass=1.0, com=(0.15, 0, 0), inertia=(0.01, 0.01, 0.01))
    coupler = scene.body("coupler", mass=2.0, com=(0.5, 0, 0), inertia=(0.1, 0.1, 0.1))
    rocker = scene.body("rocker", mass=1.5, com=(0.4, 0, 0), inertia=(0.1, 0.1, 0.1))
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.3, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(1.0, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(1.0, 0, 0), rocker.at(0.8, 0, 0))
    scene.force("spring", cd.JointSpring("A", stiffness=1.0))
    if knife:
        skate = scene.body("skate", mass=1.0, inertia=(0.1, 0.1, 0.1))
        scene.joint("P", cd.Planar("z"), scene.ground.at(0, 0, 1), skate)
        angle, along, across = scene.q("P.angle"), scene.u("P.x"), scene.u("P.y")
        scene.constraint("knife", sympy.cos(angle) * across - sympy.sin(angle) * along)
    return scene


Doing = Callable[[cd.CompiledModel, dict[str, Any]], object]
DOORS: dict[str, Doing] = {
    "simulate": lambda m, q: m.simulate(1e-3, q=q),
    "initial": lambda m, q: m.initial(q),
    "stepper": lambda m, q: m.stepper(q=q),
    "equilibrium": lambda m, q: m.equilibrium(q=q),
    "hold": lambda m, q: m.equilibrium(locked=q),
    "linearize": lambda m, q: m.linearize(q=q),
    "modes": lambda m, q: m.modes(q=q),
    "redundancy": lambda m, q: m.redundancy(q=q),
    "ensemble": lambda m, q: m.ensemble(1e-3, q={n: [v, v] for n, v in q.items()}),
    "vary": lambda m, q: m.ensemble(1e-3, vary={n: [v, v] for n, v in q.items()}),
}
# of joint coordinates alone
TREES: dict[str, Doing] = {
    "assemble": lambda m, q: m.assemble(q),
    "assemble_start": lambda m, q: m.assemble(start=q),
    "sweep": lambda m, q: m.sweep({n: [v, v] for n, v in q.items()}),
    "trim": lambda m, q: m.trim(q=q),
}


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a16_one_component_of_a_rotation_is_refused(coordinates: str) -> None:
    """A single component of a quaternion was rescaled in silence, and turned the body."""
    model = cd.compile(flying_pair(), coordinates=coordinates)
    doors = DOORS if coordinates == "absolute" else DOORS | TREES
    for door, do in doors.items():
        for name in ("base.x", "base.qx", "ball.qw", "ball.w"):
            with pytest.raises(CardanError) as problem:
                do(model, {name: 0.5})
            words = str(problem.value)
            head = name.partition(".")[0]
            component = name[-1]
            assert f"'{head}.q{component}' is one component" in words, door
            assert (f"there is no coordinate '{name}'" in words) == (".q" not in name), door
            assert ("'base.px'" in words) == (head == "base"), door
            # nor is another component, or the same under its other name, advised
            assert "Did you mean" not in words, door


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a16_a_quaternion_of_another_length_is_refused(coordinates: str) -> None:
    """A quaternion that was not of length 1 was rescaled in silence."""
    model = cd.compile(flying_pair(), coordinates=coordinates)
    doors = DOORS if coordinates == "absolute" else DOORS | TREES
    for door, do in doors.items():
        if door in ("hold", "sweep", "vary"):  # they take single coordinates
            continue
        for length in (1.0 + 2e-6, 0.0):
            value = np.array([length, 0, 0, 0])
            with pytest.raises(CardanError, match=r"quaternion at 'ball\.qw' has length"):
                do(model, {"ball": value})
    motion = model.simulate(1e-3, q={"ball": [0.8 + 4e-7, 0.6, 0, 0]})
    assert abs(np.linalg.norm(motion["ball"][0]) - 1) < 1e-15


def test_a16_in_scenes_and_symbolic_linear_models() -> None:
    """q0 and the symbolic linear model took any four numbers as a rotation."""
    scene = flying_pair()
    third = scene.body("third", mass=1.0, inertia=(1, 1, 1))
    with pytest.raises(cd.ModelError, match=r"quaternion in q0 has length 0\.9"):
        scene.joint("last", cd.Spherical(), scene.bodies["d"], third, q0=(0.9, 0, 0, 0))
    equations = cd.derive(flying_pair())
    with pytest.raises(cd.DerivationError, match=r"'base\.qx' is one component"):
        equations.linearize(q={"base.qx": 0.5})
    with pytest.raises(cd.DerivationError, match=r"length 1\.1"):
        equations.linearize(q={"base": (1.1, 0, 0, 0, 0, 0, 0)})


@pytest.mark.parametrize("given", [{"A": 1.0}, {"D": 1.6}, {"B": -0.4}])
def test_a17_the_given_coordinate_stays_free(given: dict[str, float]) -> None:
    """The symbolic linear model of a loop took another free coordinate than was given."""
    (name,) = given
    equations = cd.derive(four_bar())
    assert equations.linearize(q=given).states == (name, f"{name}.u")
    other = "B" if name != "B" else "A"
    wanted = equations.linearize(q=given, independent=[other]).states
    assert wanted == (other, f"{other}.u")


def test_b2_closed_form_beside_a_velocity_constraint() -> None:
    """Loops in closed form beside any velocity constraint ended in an IndexError."""
    runs = []
    for constraints in ("closed_form", "multipliers"):
        model = cd.compile(four_bar(knife=True), constraints=constraints)
        start = {"q": {"A": 0.3}, "u": {"A": 1.0, "P": [1.0, 0.0, 1.0]}}
        runs.append(model.simulate(0.1, **start, rtol=1e-10, atol=1e-12))
    for name in ("A", "B", "D", "P.angle", "P.y"):
        np.testing.assert_allclose(runs[0][name][-1], runs[1][name][-1], atol=1e-8)


def folded_array(flexible: bool = True) -> cd.Scene:
    """A free hub with three panels whose hinges two relations couple: h1 = -2 h0, h2 = 2 h0."""
    scene = cd.Scene("array", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=400.0, inertia=(120.0, 150.0, 120.0))
    scene.joint("drift", cd.Free(), scene.ground, hub)
    section = cd.section.rectangle(1.0, 0.01)
    material = cd.material(E=7e10, nu=0.3, rho=500.0, damping=1e-4)
    place, x = hub.at(0.8, 0, 0), 0.8
    for k in range(3):
        yoke = scene.body(f"y{k}", mass=0.3, inertia=(0.01,) * 3, pose=(x, 0, 0))
        scene.joint(f"h{k}", cd.Revolute("y"), place, yoke)
        x += 1.5
        place = (
            scene.beam(f"p{k}", yoke, (x, 0, 0), section, material, elements=2).end
            if flexible
            else yoke.at(1.5, 0, 0)
        )
    for k in (1, 2):
        scene.constraint(f"c{k}", scene.q(f"h{k}") - 2 * (-1) ** k * scene.q("h0"))
    scene.force("spring", cd.JointSpring("h0", stiffness=6.0, damping=25.0))
    return scene


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a2_speeds_that_contradict_each_other_are_refused(coordinates: str) -> None:
    """Absolute coordinates discarded given start speeds: A.u = 5 started as 0.831."""
    model = cd.compile(four_bar(), coordinates=coordinates)
    for speeds in ({"A": 5.0, "D": 1.0, "B": 3.0}, {"A": 5.0, "D": 1.0}):
        with pytest.raises(cd.ModelError, match="would come apart at"):
            model.simulate(1e-6, q={"A": 1.0}, u=speeds)
    motion = model.simulate(1e-6, q={"A": 1.0}, u={"A": 5.0})
    assert motion["A.u"][0] == pytest.approx(5.0, abs=1e-12)
    assert "A.u = 5" in str(motion)


def test_a3_a_loop_starts_on_the_same_branch_in_all_coordinates() -> None:
    """In absolute coordinates a four-bar started on another branch, wound up by 4 pi."""
    starts = [
        cd.compile(four_bar(), coordinates=coordinates).simulate(1e-6, q={"A": 1.0}, u={"A": 5.0})
        for coordinates in ("relative", "absolute")
    ]
    for name in ("A", "B", "D", "A.u", "B.u", "D.u"):
        assert starts[1][name][0] == pytest.approx(starts[0][name][0], abs=1e-9)


@pytest.mark.parametrize("flexible", some([False, True], 2))
def test_a3_a_folded_array_starts_folded_however_it_is_named(flexible: bool) -> None:
    """The beams of a folded array were strained by 180 %: 3.2e8 J for 7.4 J."""
    model = cd.compile(folded_array(flexible))
    folded = {"h0": -np.pi / 2, "h1": np.pi, "h2": -np.pi}
    for names in (["h0"], ["h1"], ["h2"], ["h0", "h2"], ["h0", "h1", "h2"]):
        x = model.initial({name: folded[name] for name in names})
        q, u = model.split(x)
        assert model.energy(q, u).potential == pytest.approx(3 * (np.pi / 2) ** 2, rel=1e-9)
        for name, angle in folded.items():
            assert q[model.coordinates.index(name)] == pytest.approx(angle, abs=1e-9)
    if not flexible:  # with beams the same, after more searches
        with pytest.raises(cd.ModelError, match="are inconsistent"):
            model.initial({"h0": -np.pi / 2, "h1": 0.0})


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a3_relations_are_not_unwound(coordinates: str) -> None:
    """A named angle was replaced where a relation needs an angle beyond half a turn."""
    model = cd.compile(folded_array(flexible=False), coordinates=coordinates)
    x = model.initial({"h0": -2.0})
    found = [x[model.coordinates.index(f"h{k}")] for k in range(3)]
    np.testing.assert_allclose(found, [-2.0, 4.0, -4.0], atol=1e-12)


def test_a3_strained_beams_are_warned_of() -> None:
    """Beams strained by 180 % started without a word."""
    scene = cd.Scene("strut", gravity=(0, 0, 0))
    slider = scene.body("slider", mass=1.0, inertia=(1.0, 1.0, 1.0), pose=(1, 0, 0))
    scene.joint("slide", cd.Prismatic("x"), scene.ground.at(1, 0, 0), slider)
    section = cd.section.general(EA=1e5, GA=1e5, GJ=100, EI=100, rhoA=1, rhoI=1e-3)
    scene.beam("rod", scene.ground, slider, section=section, elements=2)
    model = cd.compile(scene)
    with pytest.warns(cd.SolveWarning, match=r"strains beam 'rod' by 0\.2"):
        model.initial({"slide": 0.2})


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_initial_is_where_runs_start(coordinates: str) -> None:
    """model.initial did not close loops, simulate did."""
    model = cd.compile(four_bar(), coordinates=coordinates)
    x = model.initial({"A": 1.0}, {"A": 5.0})
    motion = model.simulate(1e-6, q={"A": 1.0}, u={"A": 5.0})
    np.testing.assert_array_equal(x, model.initial({"A": 1.0}, {"A": 5.0}))
    np.testing.assert_allclose(motion.x[0], x, atol=1e-11)


def test_a2_named_speeds_of_nodes_inside_a_beam_are_those_of_the_start() -> None:
    """They were replaced by 0 where the joints of the beam's ends were assembled."""
    scene = cd.Scene("clamped", gravity=(0, 0, 0))
    section, rubber = cd.section.rectangle(0.02, 0.01), cd.material(E=1e9, nu=0.3, rho=1000)
    scene.beam("rod", scene.ground, (1, 0, 0), section, rubber, elements=4)
    model = cd.compile(scene)
    name = next(joint for joint in model.joints if "node" in joint or "at" in joint)
    given = [0, 0, 0.3, 0, 0.2, 0]
    motion = model.simulate((0, 1e-6), u={name: given})
    first = model.speeds.index(f"{name}.u.x")
    assert motion.u[0][first : first + 6].tolist() == given


def hub_with_beam() -> cd.CompiledModel:
    """A hub on a hinge, and a beam whose far end nothing but the beam holds."""
    scene = cd.Scene("strip", gravity=(0, 0, -9.81))
    hub = scene.body("hub", mass=1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    section = cd.section.general(EA=1e6, GA=1e6, GJ=80, EI=100, rhoA=1, rhoI=1e-6)
    scene.beam("beam", hub, (1, 0, 0), section, elements=2)
    return cd.compile(scene)


@pytest.mark.parametrize(
    "named", [{"beam.end.pz": 0.3}, {"beam.end.px": 2.0}, {"beam.end.pz": 0.3, "hinge": 0.1}]
)
def test_a3_a_named_free_end_of_a_beam_is_not_replaced(named: dict[str, float]) -> None:
    """A search that began elsewhere forgot the named end of a beam: the default was the start."""
    model = hub_with_beam()
    with pytest.warns(cd.SolveWarning, match="strains beam 'beam'"):
        x = model.initial(named, {})
    found = {name: x[model.coordinates.index(name)] for name in named}
    assert found == pytest.approx(named, abs=1e-12)


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a_start_outside_of_limits_is_told_in_all_coordinates(coordinates: str) -> None:
    """Limits of joints were lost in absolute coordinates, and with them the warning."""
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    arm = scene.body("arm", mass=1.0, com=(0.5, 0, 0), inertia=(0.01, 0.1, 0.1))
    scene.joint("elbow", cd.Revolute("y"), scene.ground, arm, limits=(-1, 1))
    model = cd.compile(scene, coordinates=coordinates)
    assert model.limits == {"elbow": {"lower": -1.0, "upper": 1.0}}
    with pytest.warns(cd.ModelWarning, match="'elbow'.*above the upper limit 1 rad"):
        model.initial({"elbow": 2.0}, {})
